//! A survey that was taken in.

use riffel_keys::{Message, Value, number, say};
use riffel_network::Ingested;
use serde::Serialize;

use crate::Answer;

/// What became of a survey.
#[derive(Serialize)]
#[serde(transparent)]
pub struct IngestedAnswer {
    found: Ingested,
    #[serde(skip)]
    remarks: Vec<Message>,
}

impl IngestedAnswer {
    /// What a store says of it.
    pub fn new(found: Ingested) -> Self {
        let twice = found.goes_back.iter().map(|goes_back| {
            say!(
                places_go_back,
                row = number(goes_back.line),
                rail = goes_back.rail.as_str(),
                end = number(format!("{:.3}", goes_back.end_m)),
                from = number(format!("{:.3}", goes_back.from_m))
            )
        });
        let renamed = found.renamed.iter().map(|(old, new)| say!(rail_is_renamed, old, new));
        let is_new = !found.new_rails.is_empty();
        let new = is_new.then(|| say!(line_has_not_had_rail, rails = found.new_rails.join(", ")));
        let alike = found.alike.as_ref();
        let alike = alike.map(|alike| say!(line_is_called_alike, alike, line = found.line.as_str()));
        let remarks = twice.chain(renamed).chain(new).chain(alike).collect();
        Self { found, remarks }
    }
}

impl Answer for IngestedAnswer {
    fn name(&self) -> &'static str {
        "survey"
    }

    fn sentences(&self) -> Vec<Message> {
        let Ingested { line, date, .. } = &self.found;
        if self.found.there_already {
            return vec![say!(survey_is_there_already, line, date)];
        }
        let rails = self.found.measured.iter();
        let rails: Value = rails.map(|(rail, cells)| say!(cells_of_rail, rail, cells = number(cells))).collect();
        let length = number(self.found.resolution_m);
        vec![say!(survey_is_taken_in, line, date, rails, length)]
    }

    fn remarks(&self) -> &[Message] {
        &self.remarks
    }
}
