//! Tables of text: where their numbers stand.

use super::MeasurementError;

/// Most lines: a frequency response has some thousand, a time record has more.
const MOST_LINES: usize = 200_000;

/// Lines among which the header is looked for.
const PREAMBLE: usize = 500;

/// The columns that are read.
pub(super) trait Chosen {
    /// Their numbers.
    fn numbers(&self) -> Vec<usize>;
}

/// Where the numbers of a table stand. Lines before its header are left out, as are those that begin with `#`; columns
/// are separated by semicolon, tab, comma or blanks; unless by a comma, a decimal comma is understood; a row of units
/// may follow the header.
pub(super) struct Layout<C> {
    separator: Separator,
    pub(super) header: Vec<String>,
    /// Cells of the row of units, if there is one.
    units: Vec<String>,
    pub(super) columns: C,
    /// Lines before the first row of numbers.
    first_row: usize,
}

/// A row of numbers.
pub(super) struct Row<'a, C> {
    layout: &'a Layout<C>,
    /// Where it stands, as "line 12".
    pub(super) place: String,
    cells: Vec<String>,
}

impl<C: Chosen> Layout<C> {
    /// The first line in which `columns` finds its own and below which numbers stand in them. A file without a header is
    /// told of `example`.
    pub(super) fn find(
        text: &str,
        example: &str,
        columns: impl Fn(&[String]) -> Result<C, MeasurementError>,
    ) -> Result<Self, MeasurementError> {
        let head: Vec<&str> = text.lines().take(PREAMBLE).collect();
        for (index, line) in head.iter().enumerate() {
            let found = Separator::ALL
                .into_iter()
                .find_map(|separator| Self::below(&head, index, line, separator, &columns));
            if let Some(layout) = found {
                return Ok(layout);
            }
        }
        Err(Self::reason(&head, example, columns))
    }

    fn below(
        head: &[&str],
        index: usize,
        line: &str,
        separator: Separator,
        columns: impl Fn(&[String]) -> Result<C, MeasurementError>,
    ) -> Option<Self> {
        let header = separator.cells(line.trim_start_matches(['#', '%', ' ']));
        let columns = columns(&header).ok()?;
        let numbers = columns.numbers();
        let mut rows = head.iter().enumerate().skip(index + 1);
        let mut next = || {
            let (index, line) = rows.find(|(_, line)| !is_blank(line) && !is_comment(line))?;
            Some((index, separator.cells(line)))
        };
        let is_row = |cells: &[String]| {
            numbers.iter().any(|&column| {
                cells
                    .get(column)
                    .is_some_and(|cell| number(cell, separator).is_ok())
            })
        };
        let layout = |first_row, units| Self {
            separator,
            header,
            units,
            columns,
            first_row,
        };
        let (first, cells) = match next() {
            Some(row) => row,
            // A header without rows is told of later, as too few frequencies.
            None => return Some(layout(index + 1, Vec::new())),
        };
        if is_row(&cells) {
            return Some(layout(first, Vec::new()));
        }
        let (second, below) = next()?;
        is_row(&below).then(|| layout(second, cells))
    }

    /// Why there is no header.
    fn reason(
        head: &[&str],
        example: &str,
        columns: impl Fn(&[String]) -> Result<C, MeasurementError>,
    ) -> MeasurementError {
        // The likeliest header stands over the first row of numbers.
        let of_numbers = |line: &str, separator: Separator| {
            let cells = separator.cells(line);
            let numbers = cells.iter().filter(|cell| number(cell, separator).is_ok());
            numbers.count()
        };
        let lines = || head.iter().filter(|line| !is_blank(line));
        let first = lines().position(|line| {
            let most = Separator::ALL.map(|separator| of_numbers(line, separator));
            most.into_iter().max() > Some(1)
        });
        if first == Some(0) {
            return MeasurementError::file(format!(
                "has no header: its columns need names above them, such as \"{example}\""
            ));
        }
        let header = lines()
            .nth(first.map_or(0, |first| first - 1))
            .copied()
            .unwrap_or_default();
        let separator = Separator::ALL
            .into_iter()
            .rev()
            .max_by_key(|separator| separator.cells(header).len());
        let header = separator.map_or_else(Vec::new, |separator| separator.cells(header));
        match columns(&header) {
            Err(error) => error,
            Ok(_) => MeasurementError::file("has no row of numbers below its header"),
        }
    }

    /// The rows of the text in which it was found.
    pub(super) fn rows<'a>(
        &'a self,
        text: &'a str,
    ) -> impl Iterator<Item = Result<Row<'a, C>, MeasurementError>> {
        let lines = text.lines().enumerate().skip(self.first_row);
        let lines = lines.filter(|(_, line)| !is_blank(line) && !is_comment(line));
        lines.enumerate().map(|(count, (index, line))| {
            if count == MOST_LINES {
                return Err(MeasurementError::file(format!(
                    "has more than {MOST_LINES} lines; a frequency response has some thousand, so this may \
                     be a time record"
                )));
            }
            Ok(Row {
                layout: self,
                place: format!("line {}", index + 1),
                cells: self.separator.cells(line),
            })
        })
    }
}

impl<C> Layout<C> {
    /// The unit of a column, as the row of units or its name has it.
    pub(super) fn unit(&self, column: usize) -> Option<&str> {
        self.unit_below(column)
            .or_else(|| super::columns::unit_in_name(&self.header[column]))
    }

    /// The unit of a column in the row of units.
    pub(super) fn unit_below(&self, column: usize) -> Option<&str> {
        let below = self.units.get(column).map(String::as_str);
        below
            .map(|unit| unit.trim_matches(['[', ']']).trim())
            .filter(|unit| !unit.is_empty())
    }
}

impl<C> Row<'_, C> {
    /// The text of a column.
    pub(super) fn text(&self, column: usize) -> &str {
        self.cells.get(column).map_or("", String::as_str)
    }

    /// The number in a column.
    pub(super) fn number(&self, column: usize) -> Result<f64, MeasurementError> {
        number(self.text(column), self.layout.separator).map_err(|rule| self.wrong(column, &rule))
    }

    /// What is wrong in a column, as the end of a sentence.
    pub(super) fn wrong(&self, column: usize, rule: &str) -> MeasurementError {
        let (place, name) = (&self.place, &self.layout.header[column]);
        MeasurementError::file(format!("{place}: column `{name}` {rule}"))
    }
}

fn is_blank(line: &str) -> bool {
    line.trim_matches(|c: char| c.is_whitespace() || matches!(c, ',' | ';'))
        .is_empty()
}

fn is_comment(line: &str) -> bool {
    line.trim_start().starts_with('#')
}

/// What stands between two cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Separator {
    Mark(char),
    Blanks,
}

impl Separator {
    const ALL: [Self; 4] = [
        Self::Mark(';'),
        Self::Mark('\t'),
        Self::Mark(','),
        Self::Blanks,
    ];

    /// The cells of a line without quotation marks and the blanks around them.
    fn cells(self, line: &str) -> Vec<String> {
        let Self::Mark(mark) = self else {
            return line.split_whitespace().map(str::to_owned).collect();
        };
        let mut quoted = false;
        let cells = line.split(|c: char| {
            quoted ^= c == '"';
            c == mark && !quoted
        });
        cells
            .map(|cell| cell.trim().trim_matches('"').trim().to_owned())
            .collect()
    }
}

/// A finite number, or what is wrong, as the end of a sentence.
fn number(cell: &str, separator: Separator) -> Result<f64, String> {
    if cell.is_empty() {
        return Err("is empty".to_owned());
    }
    let has_decimal_comma = separator != Separator::Mark(',') && !cell.contains('.');
    let text = match has_decimal_comma {
        true => cell.replace(',', "."),
        false => cell.to_owned(),
    };
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(_) => Err(format!("is {cell}, but must be finite")),
        Err(_) => Err(format!("is \"{cell}\", not a number")),
    }
}
