//! `POST /api/remedies`: what would slow growth under the traffic of the line.

use std::collections::BTreeMap;

use riffel_answers::remedies::{RemediesAnswer, Remedy};
use riffel_keys::Message;
use serde::{Deserialize, Serialize};

use crate::traffic::OnLine;
use crate::{Fault, Reply};

#[derive(Deserialize)]
pub(crate) struct Question {
    #[serde(flatten)]
    line: OnLine,
    /// By the ids of remedies, in any currency.
    #[serde(default)]
    costs: BTreeMap<String, f64>,
}

#[derive(Serialize)]
struct Answer<'a> {
    helps_most: Option<Message>,
    remedies: Vec<Ranked<'a>>,
    left_out: Vec<LeftOut<'a>>,
    notes: &'a [Message],
}

#[derive(Serialize)]
struct Ranked<'a> {
    name: &'a Message,
    doubles_in: &'a Message,
    ground_after: Option<&'a Message>,
    months_per_cost: Option<f64>,
    #[serde(flatten)]
    remedy: &'a Remedy,
}

#[derive(Serialize)]
struct LeftOut<'a> {
    title: &'a Message,
    reason: &'a Message,
}

impl crate::Question for Question {
    fn subject(&self) -> Option<String> {
        Some("remedies".to_owned())
    }

    fn answer(&self) -> Result<Reply, Fault> {
        let (case, traffic) = self.line.read()?;
        let answer = RemediesAnswer::new(&case, traffic.as_ref(), &|_| ())?;
        let answer = answer.with_costs(&self.costs)?;
        let ranked = answer.remedies.iter().map(|remedy| Ranked {
            name: &remedy.title,
            doubles_in: &remedy.doubles_in,
            ground_after: remedy.ground_after.as_ref(),
            months_per_cost: remedy.months_per_cost(),
            remedy,
        });
        let left_out = answer.left_out.iter().map(|it| LeftOut {
            title: &it.title,
            reason: &it.reason,
        });
        Reply::json(&Answer {
            helps_most: answer.helps_most(),
            remedies: ranked.collect(),
            left_out: left_out.collect(),
            notes: &answer.remarks,
        })
    }
}
