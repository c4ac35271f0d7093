//! `POST /api/noise`: what a train sounds like on a measured rail.

use axum::extract::State;
use riffel_answers::page::TRAFFIC_FILE;
use riffel_keys::say;
use serde::Deserialize;
use serde_json::{Value, json};

use super::roughness::{self, CASE_FILE, fault_as_answer};
use crate::Page;
use crate::fault::{Fault, Refusal};
use crate::request::{Asked, Asker};
use crate::told::Told;

/// Highest level that may be a limit \[dB(A)\].
const LOUDEST: f64 = 200.0;

/// What the wheels are.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Wheel {
    /// A rigid body.
    #[default]
    Rigid,
    /// A straight web and a tyre of 920 mm that ring.
    #[serde(rename = "straight-web-920")]
    StraightWeb920,
}

impl Wheel {
    /// The name of its modes.
    fn modes(self) -> Option<&'static str> {
        match self {
            Self::Rigid => None,
            Self::StraightWeb920 => Some("straight-web-920"),
        }
    }
}

#[derive(Deserialize)]
pub(crate) struct Question {
    #[serde(flatten)]
    rail: roughness::Question,
    /// Highest level that is allowed \[dB(A)\].
    #[serde(default)]
    limit_dba: Option<f64>,
    #[serde(default)]
    wheel: Wheel,
}

pub(crate) async fn post(
    State(page): State<Page>,
    asker: Asker,
    Asked(question): Asked<Question>,
) -> Result<Told<Value>, Refusal> {
    question.rail.check()?;
    let limit = question.limit_dba;
    if limit.is_some_and(|limit| !(0.0..=LOUDEST).contains(&limit)) {
        return Err(Refusal(Fault::bad(say!(the_limit_of_the_level_must, loudest = LOUDEST))));
    }
    let upload = page.uploads.of(&asker.owner()?)?;
    let earlier = question.rail.earlier(&upload)?;
    let program = page.program.clone();
    page.long
        .run(asker.subject("noise"), move |wanted| {
            let rail = &question.rail;
            if let Some(why) = rail.case.read()?.without_decay() {
                let fault = Fault::of_key("track.model", why, "");
                return Ok(Told(json!({ "fault": fault })));
            }
            let (files, record) = rail.put(&upload)?;
            let before = earlier.put(&files)?;
            let mut question = rail.reading.add_to(json!({
                "case": CASE_FILE, "roughness": record, "traffic": TRAFFIC_FILE,
                "speed": format!("{} m/s", rail.traffic.mean_speed()), "months": rail.months,
                "limit_dba": limit, "wheel_modes": question.wheel.modes(),
            }));
            if earlier.has_dates() {
                earlier.add_to(&before, &mut question);
            }
            let answer = program.ask(files.path(), "noise", &question, wanted);
            fault_as_answer(answer, wanted).map(Told)
        })
        .await
}
