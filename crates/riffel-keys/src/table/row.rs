//! Rows of a table as text.

use riffel::Complex64;

use super::delimiter::{DecimalMark, Delimiter};
use super::heading::label;
use super::line::{cells, is_comment, lines};
use super::number::{complex, number};

/// The rows below the first `above` lines, each with its cells.
pub fn rows(
    text: &[u8],
    above: usize,
    delimiter: Delimiter,
    decimal: Option<DecimalMark>,
) -> impl Iterator<Item = Row<'_>> {
    let all = lines(text).enumerate().skip(above);
    let rows = all.filter(move |(_, line)| !is_comment(line));
    rows.map(move |(index, line)| Row { line: index + 1, cells: cells(line, delimiter), decimal })
}

/// The finite number that a text is, with a decimal point or a decimal comma.
pub fn number_in(text: &str) -> Option<f64> {
    let read = |decimal: u8| number(text.as_bytes(), decimal);
    read(b'.').or_else(|| read(b',')).filter(|value| value.is_finite())
}

/// A row.
#[derive(Debug, Clone, PartialEq)]
pub struct Row<'a> {
    /// Its line, from 1.
    pub line: usize,
    /// Its cells, trimmed; an empty one behind a delimiter at the end.
    pub cells: Vec<&'a [u8]>,
    /// What stands before decimals; either where it is not known.
    decimal: Option<DecimalMark>,
}

impl Row<'_> {
    /// Whether all cells are empty.
    pub fn is_empty(&self) -> bool {
        self.cells.iter().all(|cell| cell.is_empty())
    }

    /// The text of a column, without quotes; empty where there is none.
    pub fn text(&self, column: usize) -> String {
        self.cells.get(column).map_or_else(String::new, |cell| label(cell))
    }

    /// The number in a column, NaN for a missing one; None for anything else.
    pub fn value(&self, column: usize) -> Option<f64> {
        self.read(column, number)
    }

    /// The finite number in a column.
    ///
    /// # Errors
    /// What is wrong with it, as the end of a sentence.
    pub fn number(&self, column: usize) -> Result<f64, String> {
        self.finite(column, number, |value| value.is_finite(), "a number")
    }

    /// The finite complex number in a column, real ones among them.
    ///
    /// # Errors
    /// What is wrong with it, as the end of a sentence.
    pub fn complex(&self, column: usize) -> Result<Complex64, String> {
        let read =
            |cell: &[u8], decimal: u8| complex(cell, decimal).or_else(|| number(cell, decimal).map(Complex64::from));
        self.finite(column, read, |value| value.is_finite(), "a complex number")
    }

    /// Whether a column holds a complex number that is not real.
    pub fn is_complex(&self, column: usize) -> bool {
        self.read(column, complex).is_some()
    }

    fn read<T>(&self, column: usize, read: impl Fn(&[u8], u8) -> Option<T>) -> Option<T> {
        let cell = self.cells.get(column)?;
        match self.decimal {
            Some(decimal) => read(cell, decimal.byte()),
            None => read(cell, b'.').or_else(|| read(cell, b',')),
        }
    }

    fn finite<T>(
        &self,
        column: usize,
        read: impl Fn(&[u8], u8) -> Option<T>,
        is_finite: impl Fn(&T) -> bool,
        what: &str,
    ) -> Result<T, String> {
        let cell = self.text(column);
        if cell.is_empty() {
            return Err("is empty".to_owned());
        }
        match self.read(column, read) {
            Some(value) if is_finite(&value) => Ok(value),
            Some(_) => Err(format!("is {cell}, but must be finite")),
            None => Err(format!("is \"{cell}\", not {what}")),
        }
    }
}
