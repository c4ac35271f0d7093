//! `POST /api/remedies`: what would slow growth under the traffic of the line.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicU64, Ordering};

use crate::remedies::{RemediesAnswer, Remedy};
use riffel_keys::Message;
use serde::{Deserialize, Serialize};

use crate::page::traffic::OnLine;
use crate::page::{Fault, Reply, Tell};

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

impl crate::page::Question for Question {
    fn subject(&self) -> Option<String> {
        Some("remedies".to_owned())
    }

    fn answer(&self) -> Result<Reply, Fault> {
        self.answer_telling(&|_, _| ())
    }

    fn answer_telling(&self, tell: Tell<'_>) -> Result<Reply, Fault> {
        let (case, traffic) = self.line.read()?;
        let (begun, steps) = (AtomicU64::new(0), RemediesAnswer::steps(&case) as u64);
        let progress = |by| tell(begun.fetch_add(by as u64, Ordering::Relaxed), steps);
        let answer = RemediesAnswer::new(&case, traffic.as_ref(), &progress)?;
        let answer = answer.with_costs(&self.costs)?;
        let ranked = answer.remedies.iter().map(|remedy| Ranked {
            name: &remedy.title,
            doubles_in: &remedy.doubles_in,
            ground_after: remedy.ground_after.as_ref(),
            months_per_cost: remedy.months_per_cost(),
            remedy,
        });
        let left_out = answer.left_out.iter().map(|it| LeftOut { title: &it.title, reason: &it.reason });
        Reply::json(&Answer {
            helps_most: answer.helps_most(),
            remedies: ranked.collect(),
            left_out: left_out.collect(),
            notes: &answer.remarks,
        })
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Mutex;

    #[test]
    fn each_step_is_told() {
        let toml = riffel_case::NOMINAL_CASE;
        let asked = serde_json::json!({ "case": { "toml": toml } }).to_string();
        let question = crate::page::read("/api/remedies", asked.as_bytes());
        let question = question.unwrap().unwrap();
        let told = Mutex::new(Vec::new());
        let tell = |done, of| told.lock().unwrap().push((done, of));
        let answer = question.answer_telling(&tell).unwrap();
        let told = told.into_inner().unwrap();
        let of = told[0].1;
        assert_eq!(told, (0..of).map(|done| (done, of)).collect::<Vec<_>>());
        assert_eq!(answer.bytes, question.answer().unwrap().bytes);
    }
}
