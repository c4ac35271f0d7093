//! Files of roughness: profiles and spectra.

use std::path::Path;

use riffel_keys::table::{NumberColumns, Table, is_comment, lines, rows};
use riffel_keys::text_file::Encoding;
use riffel_keys::{CaseError, Message, question, say};

use crate::format::ReaderFormat;
use crate::labelled_spectrum::LabelledSpectrum;
use crate::layout::Layout;
use crate::profile_columns::ProfileTable;
use crate::record::Record;
use crate::refusal::Refusal;
use crate::{input, plausibility, spectra};

/// What a file of roughness holds.
#[derive(Debug, Clone, PartialEq)]
pub enum RoughnessFile {
    /// A longitudinal profile.
    Profile(Record),
    /// One-third-octave spectra, and what was left out of their table.
    Spectra(Vec<LabelledSpectrum>, Vec<Message>),
}

impl RoughnessFile {
    /// Read a file, or standard input for the path `-`: as the layout says, or as its first lines let it be understood. What stands in a
    /// question under this path is taken as it is.
    /// `progress` is told of bytes done, from several threads.
    ///
    /// Text in columns, with or without a header, in UTF-8, UTF-16 or Windows-1252; blank lines and those that begin
    /// with `#` or `%` are left out, but units are read from remarks above the numbers. A profile needs columns of
    /// heights and a position or a spacing; a table of spectra needs a header with a wavelength and a level, or with
    /// wavelengths. Some hundred megabytes a second.
    ///
    /// # Errors
    /// [`CaseError::Read`] if the file cannot be read, [`CaseError::Data`] with the line and the rule if it is none of
    /// these, or its values are unlike any rail. Defects of less than one row in a hundred are put right and counted in
    /// the warnings of the record.
    pub fn read(path: &Path, layout: &Layout, progress: &(dyn Fn(usize) + Sync)) -> Result<Self, CaseError> {
        if let Some(given) = question::value(path) {
            return Ok(Self::clone(&given));
        }
        let bytes = input::read(path, &|head| match layout.format {
            Some(_) => Ok(()),
            None => Table::find(head).map(|_| ()).ok_or_else(|| no_table(head)),
        })?;
        Self::parse(&bytes, layout, progress).map_err(|refusal| refusal.of(path))
    }

    /// Text in UTF-8 or Windows-1252 whose lines end in line feeds.
    fn parse(bytes: &[u8], layout: &Layout, progress: &(dyn Fn(usize) + Sync)) -> Result<Self, Refusal> {
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        refuse_what_is_no_text(bytes)?;
        let spacing = layout.spacing;
        if let Some(spacing) = spacing {
            if spacing.si() <= 0.0 {
                let message = say!(spacing_is_not_positive, spacing);
                return Err(Refusal::new(None, message));
            }
            plausibility::check_spacing(spacing.si(), None)?;
        }
        let (format, heads, count, text_behind, assumptions) = match &layout.format {
            Some(format) => {
                let format = layout.apply(format);
                let (count, text_behind) = count_of(bytes, &format)?;
                let heads = heads_of(bytes, &format);
                (format, heads, count, text_behind, Vec::new())
            }
            None => {
                let table = Table::find(bytes).ok_or_else(|| no_table(bytes))?;
                check_marks(&table)?;
                if let Some(header) = table.heading.names.as_deref()
                    && let Some(columns) = spectra::Columns::of(header, &table)
                {
                    for (argument, given) in
                        [("--height-unit", &layout.height_unit), ("--position-unit", &layout.position_unit)]
                    {
                        if given.is_some() {
                            let message = format!("{argument} is for profiles, but this is a table of levels");
                            return Err(Refusal::new(None, message));
                        }
                    }
                    progress(bytes.len());
                    let rows = spectra::Rows::new(bytes, &table, header);
                    let (spectra, remarks) = spectra::read(&rows, &columns)?;
                    return Ok(Self::Spectra(spectra, remarks));
                }
                let profile = ProfileTable::new(&table, bytes, layout);
                let format = profile.format().map_err(|message| Refusal {
                    line: None,
                    message,
                    help: Some(HELP.to_owned().into()),
                })?;
                let assumptions = profile.assumptions(&format);
                let head = |label: &usize| table.heading.name(label - 1).unwrap_or_default().to_owned();
                let heads = format.labels.iter().map(head).collect();
                (format, heads, table.count(), table.text_behind, assumptions)
            }
        };
        let start = bytes.len() - from_line(bytes, format.header_lines).len();
        let rows = number_columns(&format, count, text_behind)
            .parse(bytes, start, format.header_lines + 1, progress)
            .map_err(|error| Refusal::new(Some(error.line), error.message))?;
        let insisted = layout.height_unit.is_some();
        let record = Record::new(format, &heads, rows, assumptions, insisted)?;
        if let Some(spacing) = spacing
            && (spacing.si() / record.spacing - 1.0).abs() > 0.02
        {
            return Err(Refusal::new(None, say!(spacing_is_not_that_of_positions, spacing, metres = record.spacing)));
        }
        Ok(Self::Profile(record))
    }
}

/// Refuse a table whose decimal marks leave doubts.
fn check_marks(table: &Table) -> Result<(), Refusal> {
    let line = Some(table.header_lines + 1);
    if table.has_decimal_commas() {
        let message = format!(
            "has {} columns, but its head has {}; where commas divide columns, numbers have a decimal point",
            table.count(),
            table.count() / 2
        );
        let help = "write the file with semicolons or tabs between its columns";
        return Err(Refusal { help: Some(help.to_owned().into()), ..Refusal::new(line, message) });
    }
    if table.mixed_marks {
        let message = format!(
            "numbers have a {} from here on, but a {} above",
            table.decimal.words(),
            table.decimal.other().words()
        );
        return Err(Refusal::new(line, message));
    }
    Ok(())
}

/// The cells of a format: the position, if there is one, then the rails, and the labels.
fn number_columns(format: &ReaderFormat, count: usize, text_behind: bool) -> NumberColumns {
    let columns = format.position.iter().chain(&format.rails);
    let columns: Vec<usize> = columns.map(|column| column.column - 1).collect();
    let labels: Vec<usize> = format.labels.iter().map(|label| label - 1).collect();
    let marks = (format.delimiter, format.decimal);
    NumberColumns::new(marks, &columns, &labels, count, text_behind)
}

fn no_table(bytes: &[u8]) -> Refusal {
    let first = lines(bytes).position(|line| !is_comment(line));
    Refusal { line: first.map(|line| line + 1), message: say!(no_table_of_numbers), help: Some(HELP.to_owned().into()) }
}

const HELP: &str = "a profile is a position and a height in columns, or heights alone with --spacing; \
                    --format names the columns of any other file";

fn refuse_what_is_no_text(bytes: &[u8]) -> Result<(), Refusal> {
    if bytes.iter().all(u8::is_ascii_whitespace) {
        let what = if bytes.is_empty() { "is empty" } else { "holds only blanks" };
        return Err(Refusal::new(None, format!("the file {what}")));
    }
    Encoding::of(bytes).map_err(|byte| Refusal::new(Some(byte.line), byte))?;
    Ok(())
}

/// Cells of the first row below the header up to the last number, which must reach to the last column of the format,
/// and whether text stands behind them.
fn count_of(bytes: &[u8], format: &ReaderFormat) -> Result<(usize, bool), Refusal> {
    let columns = format.position.iter().chain(&format.rails);
    let columns = columns.map(|column| column.column);
    let needed = columns.chain(format.labels.iter().copied()).max().unwrap_or(0);
    let first = rows(bytes, format.header_lines, format.delimiter, Some(format.decimal)).next();
    let Some(row) = first else {
        let message = format!("nothing follows the {} lines of the header", format.header_lines);
        return Err(Refusal::new(None, message));
    };
    let refuse = |message: String| Err(Refusal::new(Some(row.line), message));
    if format.delimiter.byte() == format.decimal.byte() && !row.cells.iter().any(|cell| cell.starts_with(b"\"")) {
        let rule = "the reader profile has commas between cells and in numbers, which then stand in quotes";
        return refuse(rule.to_owned());
    }
    let has = row.cells.iter().rposition(|cell| !cell.is_empty());
    let has = has.map_or(0, |last| last + 1);
    let numbers = (0..has).rfind(|&column| row.value(column).is_some());
    if row.cells.len() >= needed {
        let count = numbers.map_or(0, |last| last + 1).max(needed);
        return Ok((count, count < has));
    }
    refuse(format!(
        "the reader profile asks for column {needed}, but there are {has}, separated by {}",
        format.delimiter.words()
    ))
}

/// What stands above the columns of labels, in all lines of the header.
fn heads_of(bytes: &[u8], format: &ReaderFormat) -> Vec<String> {
    let header: Vec<_> =
        rows(bytes, 0, format.delimiter, None).take_while(|row| row.line <= format.header_lines).collect();
    let head = |label: &usize| {
        let cells: Vec<String> = header.iter().map(|row| row.text(label - 1)).collect();
        cells.join(" ").trim().to_owned()
    };
    format.labels.iter().map(head).collect()
}

/// The text from a line on, counted from zero.
fn from_line(bytes: &[u8], line: usize) -> &[u8] {
    match line.checked_sub(1) {
        None => bytes,
        Some(last) => memchr::memchr_iter(b'\n', bytes).nth(last).map_or(&[], |end| &bytes[end + 1..]),
    }
}

#[cfg(test)]
mod tests;
