//! `POST /api/calibration`: what measurements say of the case of the page; `/plan`: what would be computed. `GET
//! /api/calibration/example`: a case with data to try.

use axum::extract::State;
use riffel_answers::page::{CaseText, Traffic};
use serde::Deserialize;
use serde_json::{Value, json};

use super::decision::DECISION_FILE;
use crate::Page;
use crate::fault::{Fault, Refusal};
use crate::json_with_messages::JsonWithMessages;
use crate::plan_changes::PlanChanges;
use crate::program::Program;
use crate::queue::CancelToken;
use crate::request::{ClientId, Json};
use crate::uploads::{Drawn, Sent};
use crate::workspace::Workspace;

/// The plan beside its case, its traffic and its data, and the folder of its results.
const CASE_FILE: &str = "case.toml";
const TRAFFIC_FILE: &str = "traffic.toml";
const PLAN_FILE: &str = "plan.toml";
pub(super) const POSTERIOR: &str = "posterior";

/// True for what is written beside the data, on systems that tell capital letters and on others.
fn is_own(name: &str) -> bool {
    let is_action = name.starts_with("action-") && name.ends_with(".toml");
    is_action || [CASE_FILE, TRAFFIC_FILE, PLAN_FILE, DECISION_FILE, POSTERIOR].contains(&name)
}

/// A file of measurements in a question.
#[derive(Deserialize)]
struct DataFile {
    upload: u32,
    /// Its name to the user.
    name: String,
}

#[derive(Deserialize)]
pub(crate) struct Question {
    case: CaseText,
    traffic: Traffic,
    data: Vec<DataFile>,
    #[serde(default)]
    changes: PlanChanges,
}

impl Question {
    /// Case, traffic, data and plan in a folder of their own; and what the program says of the plan.
    fn put(&self, own: &Sent, program: &Program, cancel: &CancelToken) -> Result<(Workspace, Value), Fault> {
        // They are checked here, and open no file.
        self.case.read()?;
        let traffic = self.traffic.toml()?;
        let files = Workspace::within(own.folder(), is_own)?;
        files.write(CASE_FILE, &self.case.toml()?)?;
        files.write(TRAFFIC_FILE, &traffic)?;
        let tables = self.data.iter().map(|data| files.put(&own.file(data.upload)?, &data.name));
        let tables = tables.collect::<Result<Vec<String>, Fault>>()?;
        let ask = |question: Value| program.ask(files.path(), "calibrate", &question, cancel);
        let usual = ask(json!({
            "plan": CASE_FILE, "with": tables, "traffic": TRAFFIC_FILE, "output": ".", "dry_run": true,
        }))?;
        files.write(PLAN_FILE, &self.changes.made(&usual)?)?;
        let mut plan = ask(json!({ "plan": PLAN_FILE, "output": POSTERIOR, "dry_run": true }))?;
        // What was taken for granted, the plan itself no longer says.
        plan["remarks"] = usual["remarks"].clone();
        plan["usual"] = usual["parameters"].clone();
        Ok((files, plan))
    }
}

pub(crate) async fn plan(
    State(page): State<Page>,
    client: ClientId,
    Json(question): Json<Question>,
) -> Result<JsonWithMessages<Value>, Refusal> {
    let own = page.uploads.of(&client.owner()?)?;
    let program = page.program.clone();
    page.queue
        // Plans of single files and of all are asked for side by side: none takes the place of another.
        .run(None, move |cancel| {
            let (files, mut plan) = question.put(&own, &program, cancel)?;
            for (key, file) in [("case", CASE_FILE), ("traffic", TRAFFIC_FILE)] {
                plan[key] = files.read(file)?.into();
            }
            Ok(JsonWithMessages(plan))
        })
        .await
}

pub(crate) async fn post(
    State(page): State<Page>,
    client: ClientId,
    Json(question): Json<Question>,
) -> Result<JsonWithMessages<Value>, Refusal> {
    let own = page.uploads.of(&client.owner()?)?;
    let program = page.program.clone();
    page.chains
        .run(client.subject("calibration"), move |cancel| {
            let (files, plan) = question.put(&own, &program, cancel)?;
            let asked = json!({ "plan": PLAN_FILE, "output": POSTERIOR });
            let answer = program.ask(files.path(), "calibrate", &asked, cancel)?;
            let plan = plan["text"].as_str().unwrap_or_default().to_owned();
            own.keep(Drawn { files, plan });
            Ok(JsonWithMessages(answer))
        })
        .await
}

/// Levels of three dates, with the case and the traffic that they belong to: made by Riffel, with known values.
///
/// Growth holds the wear coefficient with friction, tractive ratio and the share of driven wheels as one product: these are left
/// out, and the wear coefficient tells the product.
pub(crate) async fn example() -> JsonWithMessages<Value> {
    const LEFT_OUT: [&str; 6] = [
        "vehicle.traction_share",
        "vehicle.tractive_ratio",
        "contact.friction",
        "contact.transverse_radius",
        "track.sleeper.mass",
        "rail.loss_factor",
    ];
    let left_out = LEFT_OUT.map(|name| (name.to_owned(), json!({ "left_out": true })));
    let left_out: serde_json::Map<String, Value> = left_out.into_iter().collect();
    // Evenly between the two lies what has the standard deviation of the made-up traffic, 8 km/h.
    let speeds = json!({ "from_km_per_h": 96.14, "to_km_per_h": 123.86 });
    let mut vehicle = speeds.clone();
    vehicle["name"] = "unit".into();
    vehicle["share"] = 1.into();
    vehicle["tractive_ratio"] = 0.15.into();
    let mut traffic = speeds;
    traffic["passages_per_day"] = 6000.into();
    traffic["months"] = 24.into();
    traffic["vehicles"] = json!([vehicle]);
    JsonWithMessages(json!({
        "case": include_str!("../../example/case.toml"),
        "traffic": traffic,
        "data": [{ "name": "roughness.csv", "text": include_str!("../../example/roughness.csv") }],
        "changes": { "parameters": left_out },
        // Chosen; the upkeep of remedies by the key that they change.
        "costs": {
            "grinding": "9000",
            "price": "1000",
            "upkeep": [["track.pad.stiffness", "800"], ["contact.friction", "400"], ["speed.standard_deviation", "250"]],
        },
    }))
}
