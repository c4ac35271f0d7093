//! Tables of frequency responses and modes, with names above their columns.

use riffel::Complex64;
use riffel_keys::table::{self, HeadedTable, NoHead};

use super::MeasurementError;
use super::columns::unit_in_name;

/// Most lines: a frequency response has some thousand, a time record has more.
const MOST_LINES: usize = 200_000;

/// A table with the columns that are read.
pub(super) type Layout<'a, C> = HeadedTable<'a, C>;

/// The table in which `columns` finds its own, with numbers in any of `numbers`. A file without a header is told of
/// `example`.
pub(super) fn find<'a, C>(
    text: &'a str,
    example: &str,
    columns: impl Fn(&[String]) -> Result<C, MeasurementError>,
    numbers: impl Fn(&C) -> Vec<usize>,
) -> Result<Layout<'a, C>, MeasurementError> {
    if text.trim().is_empty() {
        return Err(MeasurementError::file("is empty"));
    }
    let is_row = |columns: &C, row: &table::Row<'_>| {
        let mut numbers = numbers(columns).into_iter();
        numbers.any(|column| row.complex(column).is_ok())
    };
    HeadedTable::find(text, columns, is_row).map_err(|reason| match reason {
        NoHead::Numbers => {
            MeasurementError::file(format!("has no header: its columns need names above them, such as \"{example}\""))
        }
        NoHead::NoRows => MeasurementError::file("has no row of numbers below its header"),
        NoHead::Names(error) => error,
    })
}

/// The unit of a column, as the row of units or its name has it.
pub(super) fn unit<'a, C>(layout: &'a Layout<'_, C>, column: usize) -> Option<&'a str> {
    let below = layout.unit_below(column);
    below.or_else(|| unit_in_name(&layout.names[column]))
}

/// The rows.
pub(super) fn rows<'a, C>(layout: &'a Layout<'_, C>) -> impl Iterator<Item = Result<Row<'a>, MeasurementError>> {
    layout.rows().enumerate().map(|(count, row)| {
        if count == MOST_LINES {
            return Err(MeasurementError::file(format!(
                "has more than {MOST_LINES} lines; a frequency response has some thousand, so this may \
                 be a time record"
            )));
        }
        Ok(Row { names: &layout.names, place: format!("line {}", row.line), row })
    })
}

/// A row of numbers.
pub(super) struct Row<'a> {
    names: &'a [String],
    row: table::Row<'a>,
    /// Where it stands, as "line 12".
    pub(super) place: String,
}

impl Row<'_> {
    /// The text of a column.
    pub(super) fn text(&self, column: usize) -> String {
        self.row.text(column)
    }

    /// The number in a column.
    pub(super) fn number(&self, column: usize) -> Result<f64, MeasurementError> {
        let number = self.row.number(column);
        number.map_err(|rule| self.wrong(column, &rule))
    }

    /// The complex number in a column.
    pub(super) fn complex(&self, column: usize) -> Result<Complex64, MeasurementError> {
        let number = self.row.complex(column);
        number.map_err(|rule| self.wrong(column, &rule))
    }

    /// What is wrong in a column, as the end of a sentence.
    pub(super) fn wrong(&self, column: usize, rule: &str) -> MeasurementError {
        let (place, name) = (&self.place, &self.names[column]);
        MeasurementError::file(format!("{place}: column `{name}` {rule}"))
    }
}
