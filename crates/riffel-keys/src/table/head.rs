//! Tables that are found by the names of their columns.

use super::delimiter::Delimiter;
use super::heading::label;
use super::line::{cells, lines};
use super::row::{Row, rows};

/// Lines among which the head is looked for.
const PREAMBLE: usize = 500;
/// Delimiters, the one that is tried first before the others.
const DELIMITERS: [Delimiter; 4] = [Delimiter::Semicolon, Delimiter::Tab, Delimiter::Comma, Delimiter::Space];

/// A table below the names of its columns. Lines before its head are left out; unless commas divide columns, a decimal comma
/// is understood; a row of units may follow the head.
#[derive(Debug)]
pub struct HeadedTable<'a, C> {
    text: &'a [u8],
    delimiter: Delimiter,
    /// Names of the columns.
    pub names: Vec<String>,
    /// Cells of the row of units, if there is one.
    units: Vec<String>,
    /// The columns that were asked for.
    pub columns: C,
    /// Lines before the first row.
    above: usize,
}

/// Why there is no such table.
#[derive(Debug)]
pub enum NoHead<E> {
    /// The first line is one of numbers.
    Numbers,
    /// Nothing stands below the names.
    NoRows,
    /// What the likeliest names lack.
    Names(E),
}

impl<'a, C> HeadedTable<'a, C> {
    /// The table below the first line in which `find` finds its columns, if `is_row` says that a row follows, or a row of units
    /// and then one, or nothing at all.
    ///
    /// # Errors
    /// What the line above the first numbers lacks.
    pub fn find<E>(
        text: &'a str,
        find: impl Fn(&[String]) -> Result<C, E>,
        is_row: impl Fn(&C, &Row<'_>) -> bool,
    ) -> Result<Self, NoHead<E>> {
        let text = text.as_bytes();
        for (index, line) in lines(text).take(PREAMBLE).enumerate() {
            for delimiter in DELIMITERS {
                let names = names_of(line, delimiter);
                // A line that this does not divide has the words of all columns in one.
                if names.len() < 2 {
                    continue;
                }
                let Ok(columns) = find(&names) else { continue };
                let mut table = Self { text, delimiter, names, units: Vec::new(), columns, above: index + 1 };
                let mut next = table.rows();
                let first = next.next();
                if first.as_ref().is_none_or(|row| is_row(&table.columns, row)) {
                    return Ok(table);
                }
                let second = next.next().filter(|row| is_row(&table.columns, row));
                if let (Some(units), Some(_)) = (first, second) {
                    let all = (0..units.cells.len()).map(|column| units.text(column));
                    let (line, units) = (units.line, all.collect());
                    drop(next);
                    (table.above, table.units) = (line, units);
                    return Ok(table);
                }
            }
        }
        Err(reason(text, find))
    }

    /// The rows.
    pub fn rows(&self) -> impl Iterator<Item = Row<'a>> + use<'a, C> {
        let rows = rows(self.text, self.above, self.delimiter, None);
        rows.filter(|row| !row.is_empty())
    }

    /// The unit of a column in the row of units.
    pub fn unit_below(&self, column: usize) -> Option<&str> {
        let unit = self.units.get(column)?.trim_matches(['[', ']']).trim();
        (!unit.is_empty()).then_some(unit)
    }
}

/// The cells of a line as names.
fn names_of(line: &[u8], delimiter: Delimiter) -> Vec<String> {
    let marks = line.iter().take_while(|byte| matches!(byte, b'#' | b'%' | b' '));
    let cells = cells(&line[marks.count()..], delimiter);
    cells.into_iter().map(label).collect()
}

/// Why there is no head: the likeliest one stands over the first row of numbers.
fn reason<C, E>(text: &[u8], find: impl Fn(&[String]) -> Result<C, E>) -> NoHead<E> {
    let is_blank = |line: &[u8]| {
        let mut rest = line.iter();
        rest.all(|byte| byte.is_ascii_whitespace() || matches!(byte, b',' | b';'))
    };
    let above: Vec<&[u8]> = lines(text).take(PREAMBLE).filter(|line| !is_blank(line)).collect();
    let has_numbers = |line: &&[u8]| {
        DELIMITERS.into_iter().any(|delimiter| {
            let row = rows(line, 0, delimiter, None).next();
            row.is_some_and(|row| {
                let is_number = |column: &usize| row.number(*column).is_ok();
                (0..row.cells.len()).filter(is_number).nth(1).is_some()
            })
        })
    };
    let first = above.iter().position(has_numbers);
    if first == Some(0) {
        return NoHead::Numbers;
    }
    let line = above.get(first.map_or(0, |first| first - 1)).copied();
    let names = |delimiter| names_of(line.unwrap_or_default(), delimiter);
    let mut ways = DELIMITERS.into_iter().map(names);
    match find(&ways.find(|names| names.len() > 1).unwrap_or_default()) {
        Err(error) => NoHead::Names(error),
        Ok(_) => NoHead::NoRows,
    }
}
