//! Tables of answers: what a file, a terminal, a page and an array show, once.

use std::fmt::Display;
use std::io::{self, Write};

use riffel::Complex64;
use riffel_keys::{Language, Message};
use serde::Serialize;

use crate::number_alone;

/// A table by columns of equal length.
#[derive(Debug, Clone)]
pub struct Table {
    /// Of its file, without `.csv`.
    pub name: &'static str,
    /// The columns.
    pub columns: Vec<Column>,
}

/// A column.
#[derive(Debug, Clone)]
pub struct Column {
    /// In a file: quantity and unit, as in `total_db`; without a name the column is for readers only.
    pub name: String,
    /// For a reader, with the unit; none leaves the column to files.
    pub head: Option<Message>,
    /// The cells.
    pub values: Values,
}

/// Cells of a column.
#[derive(Debug, Clone)]
pub enum Values {
    /// Words.
    Words(Vec<Message>),
    /// Numbers as documents have them, in the fewest digits that tell them, 1.0 and 1e-7; `None` if there is nothing.
    Exact(Vec<Option<f64>>),
    /// Numbers as they are, such as nominal frequencies and rates of 10⁻⁷; `None` if there is nothing.
    Plain(Vec<Option<f64>>),
    /// Numbers to so many digits after the point in a file and before a reader; empty cells where there is nothing.
    Fixed {
        /// The numbers.
        values: Vec<Option<f64>>,
        /// In a file.
        file: usize,
        /// Before a reader.
        shown: usize,
        /// Differences have their sign.
        signed: bool,
    },
}

impl Values {
    fn count(&self) -> usize {
        match self {
            Self::Words(words) => words.len(),
            Self::Exact(values) | Self::Plain(values) => values.len(),
            Self::Fixed { values, .. } => values.len(),
        }
    }

    fn in_file(&self, row: usize) -> String {
        match self {
            Self::Words(words) => words[row].to_string(),
            Self::Exact(values) => {
                values[row].map_or_else(String::new, |value| ryu::Buffer::new().format(value).to_owned())
            }
            Self::Plain(values) => values[row].map_or_else(String::new, |value| value.to_string()),
            Self::Fixed { values, file, .. } => values[row].map_or_else(String::new, |value| format!("{value:.file$}")),
        }
    }

    fn shown(&self, row: usize, language: Language) -> String {
        let number = match self {
            Self::Words(words) => return words[row].text(language),
            Self::Fixed { values, shown, signed, .. } => {
                let Some(value) = values[row] else {
                    return String::new();
                };
                // Not −0.0.
                let power = 10f64.powi(*shown as i32);
                let value = (power * value).round() / power + 0.0;
                match signed {
                    true => format!("{value:+.shown$}"),
                    false => format!("{value:.shown$}"),
                }
            }
            Self::Exact(_) | Self::Plain(_) => self.in_file(row),
        };
        number.replace('.', language.decimal_mark())
    }
}

impl Column {
    /// Words that a reader sees.
    pub fn words(name: &str, head: Message, words: Vec<Message>) -> Self {
        Self { name: name.to_owned(), head: Some(head), values: Values::Words(words) }
    }

    /// Numbers for files alone, as they are.
    pub fn in_file(name: &str, values: impl Iterator<Item = f64>) -> Self {
        Self { name: name.to_owned(), head: None, values: Values::Plain(values.map(Some).collect()) }
    }

    /// Words for files alone.
    pub fn names<T: ToString>(name: &str, names: impl Iterator<Item = T>) -> Self {
        let names = names.map(|name| Message::verbatim(name.to_string()));
        Self { name: name.to_owned(), head: None, values: Values::Words(names.collect()) }
    }

    /// Numbers for files alone, as documents have them.
    pub fn exact<T: Into<Option<f64>>>(name: &str, values: impl Iterator<Item = T>) -> Self {
        Self { name: name.to_owned(), head: None, values: Values::Exact(values.map(Into::into).collect()) }
    }

    /// Real and imaginary parts for files alone, as in `force_re` and `force_im`.
    pub fn complex(name: &str, values: impl Iterator<Item = Complex64>) -> [Self; 2] {
        let (re, im): (Vec<f64>, Vec<f64>) = values.map(|value| (value.re, value.im)).unzip();
        [("re", re), ("im", im)].map(|(part, values)| Self::exact(&format!("{name}_{part}"), values.into_iter()))
    }

    /// Words for readers only, which a file has as numbers.
    pub fn shown(head: Message, words: Vec<Message>) -> Self {
        Self::words("", head, words)
    }

    /// Numbers for readers alone, to so many digits after the point; empty cells where there is nothing.
    pub fn digits<T: Into<Option<f64>>>(head: Message, digits: usize, values: impl Iterator<Item = T>) -> Self {
        let cells = values.map(|value| match value.into() {
            Some(value) => number_alone(format_args!("{value:.digits$}")),
            None => Message::verbatim(""),
        });
        Self::shown(head, cells.collect())
    }

    /// Decibels: to a tenth before a reader, to a thousandth in a file.
    pub fn decibels(name: String, head: Option<Message>, values: Vec<Option<f64>>) -> Self {
        let values = Values::Fixed { values, file: 3, shown: 1, signed: false };
        Self { name, head, values }
    }
}

/// Columns of a table with a cell of each row.
pub(crate) trait Rows<T> {
    /// Words for files and readers.
    fn words(&self, name: &str, head: Message, cell: impl Fn(&T) -> Message) -> Column;

    /// Words for readers alone.
    fn shown(&self, head: Message, cell: impl Fn(&T) -> Message) -> Column {
        self.words("", head, cell)
    }

    /// Numbers for readers alone, as they are written.
    fn numbers<N: Display>(&self, head: Message, cell: impl Fn(&T) -> N) -> Column {
        self.shown(head, |row| number_alone(cell(row)))
    }

    /// Numbers for readers alone, to so many digits after the point; `None` where there is nothing.
    fn digits<N: Into<Option<f64>>>(&self, head: Message, digits: usize, value: impl Fn(&T) -> N) -> Column;

    /// Numbers to so many digits before a reader, to a millionth in a file; `None` where there is nothing.
    fn fixed<N: Into<Option<f64>>>(&self, name: &str, head: Message, shown: usize, value: impl Fn(&T) -> N) -> Column;

    /// Numbers for files alone, as documents have them; `None` where there is nothing.
    fn exact<N: Into<Option<f64>>>(&self, name: &str, value: impl Fn(&T) -> N) -> Column;

    /// Numbers for files alone, as they are; `None` where there is nothing.
    fn plain<N: Into<Option<f64>>>(&self, name: &str, value: impl Fn(&T) -> N) -> Column;

    /// Words for files alone.
    fn names<'a, N: ToString>(&'a self, name: &str, cell: impl Fn(&'a T) -> N) -> Column
    where
        T: 'a;
}

impl<T> Rows<T> for [T] {
    fn words(&self, name: &str, head: Message, cell: impl Fn(&T) -> Message) -> Column {
        Column::words(name, head, self.iter().map(cell).collect())
    }

    fn digits<N: Into<Option<f64>>>(&self, head: Message, digits: usize, value: impl Fn(&T) -> N) -> Column {
        Column::digits(head, digits, self.iter().map(value))
    }

    fn fixed<N: Into<Option<f64>>>(&self, name: &str, head: Message, shown: usize, value: impl Fn(&T) -> N) -> Column {
        let values = self.iter().map(|row| value(row).into()).collect();
        let values = Values::Fixed { values, file: 6, shown, signed: false };
        Column { name: name.to_owned(), head: Some(head), values }
    }

    fn exact<N: Into<Option<f64>>>(&self, name: &str, value: impl Fn(&T) -> N) -> Column {
        Column::exact(name, self.iter().map(value))
    }

    fn plain<N: Into<Option<f64>>>(&self, name: &str, value: impl Fn(&T) -> N) -> Column {
        let values = Values::Plain(self.iter().map(|row| value(row).into()).collect());
        Column { name: name.to_owned(), head: None, values }
    }

    fn names<'a, N: ToString>(&'a self, name: &str, cell: impl Fn(&'a T) -> N) -> Column
    where
        T: 'a,
    {
        Column::names(name, self.iter().map(cell))
    }
}

impl Table {
    /// Rows with a column for each of their keys, for files alone; without rows there are no columns.
    pub(crate) fn of_rows(name: &'static str, rows: &[impl Serialize]) -> Self {
        let mut written = Vec::new();
        // Writing to memory does not fail.
        let _ = write_csv(&mut written, None, rows.iter());
        let mut reader = csv::Reader::from_reader(&written[..]);
        let keys = reader.headers().cloned().unwrap_or_default();
        let rows: Vec<csv::StringRecord> = reader.records().filter_map(Result::ok).collect();
        let columns = keys.iter().enumerate();
        let columns = columns.map(|(place, key)| Column::names(key, rows.iter().map(|row| &row[place])));
        Self { name, columns: columns.collect() }
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        let columns = self.columns.iter();
        columns.map(|column| column.values.count()).max().unwrap_or(0)
    }

    /// Whether a reader sees a column of it.
    pub fn is_shown(&self) -> bool {
        self.columns.iter().any(|column| column.head.is_some())
    }

    /// Whether a file has a column of it.
    pub fn has_file(&self) -> bool {
        self.columns.iter().any(|column| !column.name.is_empty())
    }

    /// Heads and rows for a reader.
    pub fn shown(&self, language: Language) -> (Vec<String>, Vec<Vec<String>>) {
        let columns = self.columns.iter();
        let columns: Vec<(&Message, &Values)> =
            columns.filter_map(|column| Some((column.head.as_ref()?, &column.values))).collect();
        let heads = columns.iter().map(|(head, _)| head.text(language));
        let row = |row| {
            let cells = columns.iter();
            cells.map(|(_, values)| values.shown(row, language)).collect()
        };
        (heads.collect(), (0..self.rows()).map(row).collect())
    }

    /// Write it as CSV.
    ///
    /// # Errors
    /// Errors of the file.
    pub fn csv(&self, file: impl Write) -> io::Result<()> {
        let named = || self.columns.iter().filter(|column| !column.name.is_empty());
        let row = |row| named().map(|column| column.values.in_file(row)).collect::<Vec<String>>();
        write_csv(file, Some(named().map(|column| &*column.name).collect()), (0..self.rows()).map(row))
    }
}

/// Write rows as CSV, below heads or the keys of the first row.
fn write_csv(file: impl Write, heads: Option<Vec<&str>>, rows: impl Iterator<Item = impl Serialize>) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(file);
    if let Some(heads) = heads {
        writer.write_record(heads)?;
    }
    for row in rows {
        writer.serialize(row)?;
    }
    writer.flush()
}
