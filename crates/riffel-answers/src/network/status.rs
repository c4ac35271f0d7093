//! What a store holds, told.

use riffel_keys::{Message, number, say};
use riffel_network::{LineStatus, Status};
use serde::Serialize;

use super::words::{hundredths, kilometres, millimetres, nothing, shown};
use crate::number_alone;
use crate::{Answer, Table};

/// What a store holds.
#[derive(Serialize)]
#[serde(transparent)]
pub struct StatusAnswer(pub Status);

impl Answer for StatusAnswer {
    fn name(&self) -> &'static str {
        "status"
    }

    fn tables(&self) -> Vec<Table> {
        let lines = &self.0.lines;
        let mut columns = vec![
            shown(say!(line_column), lines, |line| Message::verbatim(&line.line)),
            shown(say!(surveys_column), lines, |line| number_alone(line.dates.len())),
            shown(say!(latest_column), lines, |line| line.dates.last().map_or_else(nothing, Message::verbatim)),
            shown(say!(from_kilometre_column), lines, |line| kilometres(line.ends_m[0])),
            shown(say!(to_kilometre_column), lines, |line| kilometres(line.ends_m[1])),
            shown(say!(rails_column), lines, |line| kilometres(line.measured_m.iter().map(|(_, length)| length).sum())),
        ];
        columns.extend(self.0.bands_m.iter().enumerate().map(|(place, band)| {
            let cell = |line: &LineStatus| line.rms_m[place].map_or_else(nothing, |rms| hundredths(1e6 * rms));
            shown(say!(rms_of_band_column, band = millimetres(*band)), lines, cell)
        }));
        vec![Table { name: "lines", columns }]
    }

    fn sentences(&self) -> Vec<Message> {
        vec![say!(surveys_in_cells, surveys = number(self.0.surveys), length = number(self.0.resolution_m))]
    }

    fn remarks(&self) -> &[Message] {
        &[]
    }
}
