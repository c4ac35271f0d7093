//! Tables of measurements, by the names of their columns.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use riffel_keys::table::{HeadedTable, NoHead, Row};
use riffel_keys::text_file::{LARGEST_RESPONSES, decode, read_bounded};
use riffel_keys::{CaseError, Message, say};

use riffel_rail::is_device_column;

use crate::file::Kind;

/// Numbers by row: columns that must be there, and others that may.
pub(crate) struct Numbers {
    /// Line of each row, from 1.
    pub(crate) lines: Vec<usize>,
    pub(crate) needed: Vec<Vec<f64>>,
    pub(crate) others: Vec<Option<Vec<f64>>>,
    /// Columns that name the instruments, with their cells.
    devices: Vec<(String, Vec<String>)>,
}

fn refuse(path: &Path, line: Option<usize>, message: impl Into<Message>) -> CaseError {
    CaseError::Data { path: path.to_owned(), line, message: message.into(), help: None }
}

fn text(path: &Path) -> Result<String, CaseError> {
    let bytes = read_bounded(path, "table of measurements", LARGEST_RESPONSES)?;
    decode(bytes).map_err(|byte| refuse(path, Some(byte.line), byte))
}

/// The names of the columns of a table, of the first line that is a head; else those of its first line.
///
/// # Errors
/// [`CaseError::Read`].
pub(crate) fn names(path: &Path, is_head: impl Fn(&[String]) -> bool) -> Result<Vec<String>, CaseError> {
    let text = text(path)?;
    let find = |names: &[String]| is_head(names).then_some(()).ok_or(names.to_vec());
    Ok(match HeadedTable::find(&text, find, |(), _| true) {
        Ok(table) => table.names,
        Err(NoHead::Names(names)) => names,
        Err(_) => vec![text.lines().next().unwrap_or_default().to_owned()],
    })
}

/// Columns of a table of some kind that no reader of the kind knows.
///
/// # Errors
/// [`CaseError::Read`].
pub(crate) fn unused(path: &Path, kind: Kind) -> Result<Vec<String>, CaseError> {
    let needed = kind.columns();
    let mut names = names(path, |names| needed.iter().all(|needed| names.iter().any(|it| it == needed)))?;
    let is_known = |name: &str| needed.iter().chain(kind.other_columns()).any(|it| *it == name);
    names.retain(|name| !name.is_empty() && !is_known(name));
    Ok(names)
}

/// Read the columns of a table.
///
/// # Errors
/// [`CaseError::Read`], or [`CaseError::Data`] with the line, the column and the rule.
pub(crate) fn read(path: &Path, needed: &[&str], others: &[&str]) -> Result<Numbers, CaseError> {
    let text = text(path)?;
    let find = |names: &[String]| {
        let place = |wanted: &&str| names.iter().position(|name| name == wanted);
        needed.iter().map(place).collect::<Option<Vec<usize>>>().ok_or(())
    };
    let table = HeadedTable::find(&text, find, |columns, row| row.number(columns[0]).is_ok());
    let table = table.map_err(|_| without_head(path, needed, &text))?;
    let mut numbers = Numbers {
        lines: Vec::new(),
        needed: needed.iter().map(|_| Vec::new()).collect(),
        others: Vec::new(),
        devices: Vec::new(),
    };
    let place = |wanted: &&str| table.names.iter().position(|name| name == wanted);
    let places: Vec<Option<usize>> = others.iter().map(place).collect();
    numbers.others = places.iter().map(|place| place.map(|_| Vec::new())).collect();
    let devices = table.names.iter().enumerate();
    let devices = devices.filter(|(_, name)| is_device_column(name));
    let devices: Vec<(usize, &String)> = devices.collect();
    numbers.devices = devices.iter().map(|(_, name)| ((*name).clone(), Vec::new())).collect();
    for row in table.rows() {
        let number = |column: usize| {
            let number = row.number(column);
            number.map_err(|rule| refuse(path, Some(row.line), format!("`{}` {rule}", table.names[column])))
        };
        numbers.lines.push(row.line);
        for (values, &column) in numbers.needed.iter_mut().zip(&table.columns) {
            values.push(number(column)?);
        }
        for (values, column) in numbers.others.iter_mut().zip(&places) {
            if let (Some(values), Some(column)) = (values, column) {
                values.push(number(*column)?);
            }
        }
        for ((_, cells), (column, _)) in numbers.devices.iter_mut().zip(&devices) {
            cells.push(row.text(*column));
        }
    }
    if numbers.lines.is_empty() {
        return Err(refuse(path, None, "has no rows".to_owned()));
    }
    Ok(numbers)
}

/// The rows of a table with a column of numbers and one of names.
///
/// # Errors
/// Errors of [`read`].
pub(crate) fn named(path: &Path, columns: &[&str]) -> Result<Vec<(f64, String)>, CaseError> {
    let text = text(path)?;
    let find = |names: &[String]| {
        let place = |wanted: &&str| names.iter().position(|name| name == wanted);
        columns.iter().map(place).collect::<Option<Vec<usize>>>().ok_or(())
    };
    let table = HeadedTable::find(&text, find, |columns, row| row.number(columns[0]).is_ok());
    let table = table.map_err(|_| without_head(path, columns, &text))?;
    let row = |row: Row<'_>| {
        let number = row.number(table.columns[0]);
        let number = number.map_err(|rule| refuse(path, Some(row.line), format!("`{}` {rule}", columns[0])))?;
        Ok((number, row.text(table.columns[1])))
    };
    table.rows().map(row).collect()
}

fn without_head(path: &Path, columns: &[&str], text: &str) -> CaseError {
    let is_head = |line: &&str| {
        let names: Vec<&str> = line.split([',', ';', '\t']).map(|name| name.trim().trim_matches('"')).collect();
        columns.iter().all(|column| names.contains(column))
    };
    if text.lines().any(|line| is_head(&line)) {
        let rule = format!(
            "has a head with the columns {}, but below it no row with a number in `{}`",
            columns.join(", "),
            columns[0]
        );
        return refuse(path, None, rule);
    }
    let first = text.lines().next().unwrap_or_default();
    let rule = format!(
        "must have a head with the columns {}, units included, but begins with \"{first}\"",
        columns.join(", ")
    );
    refuse(path, Some(1), rule)
}

impl Numbers {
    /// The columns of a table of some kind, those that it may have in the order of the kind.
    ///
    /// # Errors
    /// Errors of [`read`], and where the instrument changes along the passages or the gross mass.
    pub(crate) fn of(path: &Path, kind: Kind) -> Result<Self, CaseError> {
        let numbers = read(path, kind.columns(), kind.other_columns())?;
        let mut columns = kind.columns().iter().zip(&numbers.needed);
        if let Some((_, dates)) = columns.find(|(name, _)| ["passages", "mgt"].contains(name)) {
            numbers.unless_device_changes(path, dates)?;
        }
        Ok(numbers)
    }

    /// That all dates have the same instruments: what others differ by would be taken for growth.
    fn unless_device_changes(&self, path: &Path, dates: &[f64]) -> Result<(), CaseError> {
        for (column, cells) in &self.devices {
            let mut by_date: BTreeMap<u64, BTreeSet<&str>> = BTreeMap::new();
            for (date, cell) in dates.iter().zip(cells).filter(|(_, cell)| !cell.is_empty()) {
                by_date.entry(date.to_bits()).or_default().insert(cell);
            }
            let Some(first) = by_date.values().next() else {
                continue;
            };
            if by_date.values().all(|devices| devices == first) {
                continue;
            }
            // Two dates differ, so that two names are there.
            let mut named = cells.iter().enumerate().filter(|(_, cell)| !cell.is_empty());
            let Some((_, other)) = named.next() else {
                continue;
            };
            let Some((row, device)) = named.find(|(_, cell)| *cell != other) else {
                continue;
            };
            let rule = say!(device_of_other_dates, column, device, other);
            return Err(self.refuse(path, row, rule));
        }
        Ok(())
    }

    /// That every number of a column fits a rule.
    pub(crate) fn check(
        &self,
        path: &Path,
        name: &str,
        values: &[f64],
        rule: &str,
        fits: impl Fn(f64) -> bool,
    ) -> Result<(), CaseError> {
        match values.iter().position(|value| !fits(*value)) {
            None => Ok(()),
            Some(row) => Err(self.refuse(path, row, format!("`{name}` is {}, but {rule}", values[row]))),
        }
    }

    /// That no row says once more what another says.
    pub(crate) fn unless_doubled<T>(
        &self,
        path: &Path,
        rows: &[T],
        same: impl Fn(&T, &T) -> bool,
    ) -> Result<(), CaseError> {
        for (row, own) in rows.iter().enumerate() {
            if let Some(before) = rows[..row].iter().position(|it| same(it, own)) {
                let rule = say!(repeats_line, line = self.lines[before]);
                return Err(self.refuse(path, row, rule));
            }
        }
        Ok(())
    }

    /// A sentence on a row.
    pub(crate) fn refuse(&self, path: &Path, row: usize, message: impl Into<Message>) -> CaseError {
        CaseError::Data { path: path.to_owned(), line: Some(self.lines[row]), message: message.into(), help: None }
    }
}
