//! `POST /api/calibration/decision`: which action pays, over the chains of the page.

use axum::extract::State;
use riffel_keys::say;
use serde::Deserialize;
use serde_json::{Value, json};
use toml::Table;

use super::calibration::POSTERIOR;
use crate::Page;
use crate::fault::{Fault, Refusal};
use crate::json_with_messages::JsonWithMessages;
use crate::request::{ClientId, Json};

/// The plan with its actions.
pub(super) const DECISION_FILE: &str = "decision.toml";
/// Most actions and measurements.
const MOST: usize = 20;

/// Tables of a plan as `riffel decide` takes them; what an action changes stands in a table `changes` by dotted keys.
#[derive(Deserialize)]
pub(crate) struct Question {
    cost: Table,
    #[serde(default)]
    action: Vec<Table>,
    #[serde(default)]
    measurement: Vec<Table>,
}

impl Question {
    /// The plan with what this asks, and the files of changes that it names.
    fn plan(self, plan: &str) -> Result<(String, Vec<(String, String)>), Fault> {
        if self.action.len().max(self.measurement.len()) > MOST {
            return Err(Fault::bad(say!(there_are_more_than_actions_or, most = MOST)));
        }
        let unwritten = |_| Fault::bad(say!(the_actions_cannot_be_written));
        let mut files = Vec::new();
        let mut plan: Table = toml::from_str(plan).map_err(|_| Fault::defect(say!(the_plan_cannot_be_read)))?;
        let mut actions = Vec::new();
        for (number, mut action) in self.action.into_iter().enumerate() {
            // Nothing that a page sends names a file.
            if let Some(changes) = action.remove("changes") {
                let name = format!("action-{}.toml", number + 1);
                let changes = changes.as_table().map(toml::to_string).transpose().map_err(unwritten)?;
                files.push((name.clone(), changes.unwrap_or_default()));
                action.insert("changes".to_owned(), name.into());
            }
            actions.push(action);
        }
        plan.insert("cost".to_owned(), self.cost.into());
        plan.insert("action".to_owned(), actions.into());
        plan.insert("measurement".to_owned(), self.measurement.into());
        Ok((toml::to_string(&plan).map_err(unwritten)?, files))
    }
}

pub(crate) async fn post(
    State(page): State<Page>,
    client: ClientId,
    Json(question): Json<Question>,
) -> Result<JsonWithMessages<Value>, Refusal> {
    let drawn = page.uploads.of(&client.owner()?)?.drawn()?;
    let program = page.program.clone();
    page.chains
        .run(client.subject("decision"), move |cancel| {
            let (plan, changes) = question.plan(&drawn.plan)?;
            drawn.files.write(DECISION_FILE, &plan)?;
            for (name, text) in &changes {
                drawn.files.write(name, text)?;
            }
            let asked = json!({ "dir": POSTERIOR, "plan": DECISION_FILE });
            let mut answer = program.ask(drawn.files.path(), "decide", &asked, cancel)?;
            answer["plan"] = plan.into();
            answer["files"] = json!(changes);
            Ok(JsonWithMessages(answer))
        })
        .await
}
