//! `POST /api/noise`: what a train sounds like on a measured rail.

use axum::Json;
use axum::extract::State;
use serde::Deserialize;
use serde_json::{Value, json};

use super::roughness::{self, Reading, Run};
use super::traffic::TRAFFIC_FILE;
use crate::Page;
use crate::fault::{Fault, Refusal};
use crate::request::{Asked, Asker};

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
    /// Arguments of the program for its modes.
    fn arguments(self) -> &'static [&'static str] {
        match self {
            Self::Rigid => &[],
            Self::StraightWeb920 => &["--wheel-modes", "straight-web-920"],
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
) -> Result<Json<Value>, Refusal> {
    question.rail.check()?;
    let limit = question.limit_dba;
    if limit.is_some_and(|limit| !(0.0..=LOUDEST).contains(&limit)) {
        return Err(Refusal(Fault::bad(format!(
            "the limit of the level must be 0 to {LOUDEST} dB(A)"
        ))));
    }
    let upload = page.uploads.of(&asker.owner()?)?;
    let program = page.program.clone();
    page.long
        .run(asker.subject("noise"), move |wanted| {
            let rail = &question.rail;
            if let Some(why) = riffel_answers::noise::without_decay(&rail.case.read()?) {
                let fault = Fault::of_key("track.model", why, "");
                return Ok(Json(json!({ "fault": fault })));
            }
            rail.write(&upload)?;
            let run = Run {
                names: rail.names(&upload, &rail.earlier(&upload)?),
                program: &program,
                upload: &upload,
                wanted,
            };
            let reading = Reading::new(&upload, rail.format.as_ref())?;
            let speed = format!("{} m/s", rail.traffic.mean_speed());
            let months = rail.months.to_string();
            let limit = limit.map(|limit| limit.to_string());
            let mut arguments = vec![
                "noise",
                "case.toml",
                "--roughness",
                &upload.name,
                "--speed",
                &speed,
                "--traffic",
                TRAFFIC_FILE,
                "--months",
                &months,
                "--json",
            ];
            if let Some(limit) = &limit {
                arguments.extend(["--limit-dba", limit]);
            }
            arguments.extend(question.wheel.arguments());
            arguments.extend(reading.format());
            run.document_or_fault(&arguments).map(Json)
        })
        .await
}
