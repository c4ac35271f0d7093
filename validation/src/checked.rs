//! Checks and how they came out.

use riffel_answers::{Answer, Column, Printed, Table};
use riffel_keys::{Message, number, say};
use serde::Serialize;

use crate::Row;

/// Checks that were run.
#[derive(Serialize)]
#[serde(transparent)]
pub struct Checked(pub Vec<Row>);

impl Checked {
    /// How many do not hold.
    pub fn failed(&self) -> usize {
        self.0.iter().filter(|row| !row.holds).count()
    }
}

impl Answer for Checked {
    fn name(&self) -> &'static str {
        "checks"
    }

    fn tables(&self) -> Vec<Table> {
        let shown = |head: Message, of: &dyn Fn(&Row) -> Message| Column::shown(head, self.0.iter().map(of).collect());
        let columns = vec![
            shown(say!(statement_column), &|row| Message::verbatim(row.statement)),
            shown(say!(source_column), &|row| Message::verbatim(row.source)),
            shown(say!(expected_column), &|row| Message::verbatim(&row.expected)),
            shown(Message::verbatim("Riffel"), &|row| Message::verbatim(&row.got)),
            shown(say!(tolerance_column), &|row| Message::verbatim(row.tolerance)),
            shown(Message::verbatim(""), &|row| if row.holds { say!(check_holds) } else { say!(check_fails) }),
        ];
        vec![Table { name: self.name(), columns }]
    }

    fn printed(&self) -> Vec<Printed> {
        let all = self.0.len();
        let hold = say!(checks_hold, hold = number(all - self.failed()), all = number(all));
        self.tables().into_iter().map(Printed::Texts).chain([Printed::Line(hold)]).collect()
    }

    fn remarks(&self) -> &[Message] {
        &[]
    }
}
