//! What a store holds, told.

use riffel_keys::{Message, number, say};
use riffel_network::{LineStatus, Status};
use serde::Serialize;

use super::words::{hundredths, kilometres, millimetres, nothing};
use crate::{Answer, Rows, Table};

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
            lines.shown(say!(line_column), |line| Message::verbatim(&line.line)),
            lines.numbers(say!(surveys_column), |line| line.dates.len()),
            lines.shown(say!(latest_column), |line| line.dates.last().map_or_else(nothing, Message::verbatim)),
            lines.shown(say!(from_kilometre_column), |line| kilometres(line.ends_m[0])),
            lines.shown(say!(to_kilometre_column), |line| kilometres(line.ends_m[1])),
            lines.shown(say!(rails_column), |line| kilometres(line.measured_m.iter().map(|(_, length)| length).sum())),
        ];
        columns.extend(self.0.bands_m.iter().enumerate().map(|(place, band)| {
            let cell = |line: &LineStatus| line.rms_m[place].map_or_else(nothing, |rms| hundredths(1e6 * rms));
            lines.shown(say!(rms_of_band_column, band = millimetres(*band)), cell)
        }));
        vec![Table { name: "lines", columns }]
    }

    fn sentences(&self) -> Vec<Message> {
        vec![say!(surveys_in_cells, surveys = number(self.0.surveys), length = number(self.0.resolution_m))]
    }
}
