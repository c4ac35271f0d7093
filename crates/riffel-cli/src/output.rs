//! What is printed as the result.

use std::borrow::Cow;
use std::io::{self, Write};

pub(crate) use comfy_table::Table;
use comfy_table::{CellAlignment, ContentArrangement, TableStyle, presets};
use serde::Serialize;

use crate::error::CliError;
use crate::messages::Voice;
use riffel_keys::message::as_data;
use riffel_keys::text_file::printable;

/// Print to standard output.
pub(crate) fn print(text: &str) -> Result<(), CliError> {
    // Data stays as it is.
    match text.starts_with(['{', '[']) {
        true => write(text),
        false => write(&without_minus_zero(text)),
    }
}

/// A text in which no number that rounds to zero has a minus: "-0.0" is "0.0", and as wide in its column.
fn without_minus_zero(text: &str) -> String {
    let mut words = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find("-0") {
        let (before, number) = rest.split_at(at);
        words.push_str(before);
        let (number, after) = number.split_at(1 + length_of_number(&number[1..]));
        let begins = !words.ends_with(|c: char| c.is_alphanumeric() || "-.".contains(c));
        let ends = !after.starts_with(|c: char| c.is_alphabetic() || c == '-');
        let zero = number.bytes().all(|byte| b"-0.,".contains(&byte));
        match begins && ends && zero {
            true => words.extend([&number[1..], if after.starts_with("  ") { " " } else { "" }]),
            false => words.push_str(number),
        }
        rest = after;
    }
    words + rest
}

/// Digits with points and with commas between them, at the beginning of a text.
fn length_of_number(text: &str) -> usize {
    let is_digit = |place: usize| text.as_bytes().get(place).is_some_and(u8::is_ascii_digit);
    let belongs = |(place, letter)| match letter {
        ',' => is_digit(place + 1),
        letter => letter.is_ascii_digit() || letter == '.',
    };
    let end = text.char_indices().find(|&letter| !belongs(letter));
    end.map_or(text.len(), |(end, _)| end)
}

/// Names come from files of others: what commands a terminal is written out.
fn write(text: &str) -> Result<(), CliError> {
    let mut stdout = io::stdout().lock();
    unless_reader_left(stdout.write_all(printable(text).as_bytes()).and_then(|()| stdout.flush()))
}

/// The outcome of writing to standard output: a reader that has gone away (`riffel … | head`) is not an error.
pub(crate) fn unless_reader_left(outcome: io::Result<()>) -> Result<(), CliError> {
    match outcome {
        Err(reason) if reason.kind() != io::ErrorKind::BrokenPipe => Err(CliError::StandardOutput { reason }),
        _ => Ok(()),
    }
}

/// Print one JSON document.
pub(crate) fn print_json(voice: Voice, document: &impl Serialize) -> Result<(), CliError> {
    write(&json(voice, document))
}

/// A JSON document, indented, with a final line feed.
pub(crate) fn json(voice: Voice, document: &impl Serialize) -> String {
    // Only a map with keys that are not strings, or a failing `Serialize`, could be refused.
    json_of(voice, || serde_json::to_string_pretty(document).unwrap_or_default())
}

/// [`json`] of a document that `write` writes.
pub(crate) fn json_of(voice: Voice, write: impl FnOnce() -> String) -> String {
    let mut text = match voice.tells_messages_as_data() {
        true => as_data(write),
        false => write(),
    };
    // JSON writes out those below a blank alone; no other place than in a string has one.
    if let Cow::Owned(_) = printable(&text) {
        let escaped = |character: char| match printable(character.encode_utf8(&mut [0; 4])) {
            Cow::Borrowed(_) => character.to_string(),
            Cow::Owned(_) => format!("\\u{:04x}", u32::from(character)),
        };
        text = text.chars().map(escaped).collect();
    }
    text.push('\n');
    text
}

/// A line below the header, none between the rows.
const STYLE: TableStyle = presets::NOTHING.header_separator(comfy_table::LineStyle::new('─', '─', '─', '─'));

/// A table of an answer as a reader sees it: words to the left, numbers to the right.
pub(crate) fn table_of(voice: Voice, table: &riffel_answers::Table) -> Table {
    let (heads, rows) = table.shown(voice.language);
    let mut shown = Table::new();
    shown.load_style(STYLE).set_header(heads).add_rows(rows);
    for column in shown.column_iter_mut().skip(1) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    shown
}

/// A table as one of text, wrapped to the terminal or, where there is none, to 110 columns.
pub(crate) fn as_text(mut table: Table) -> Table {
    for column in table.column_iter_mut() {
        column.set_cell_alignment(CellAlignment::Left);
    }
    table.set_content_arrangement(ContentArrangement::Dynamic);
    if table.width().is_none() {
        table.set_width(110);
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zero_has_no_sign() {
        for (text, without) in [
            ("from -0.0 to -0.00 m", "from 0.0 to 0.00 m"),
            ("-0 and (-0.000)", "0 and (0.000)"),
            ("a  -0.0  b", "a  0.0   b"),
            ("-0,176 and -0,000, -0", "-0,176 and 0,000, 0"),
            (
                "-0.01, -0.0e3, 2026-05-01, 1e-06, -00-, x-0.0, -1.0",
                "-0.01, -0.0e3, 2026-05-01, 1e-06, -00-, x-0.0, -1.0",
            ),
        ] {
            assert_eq!(without_minus_zero(text), without);
        }
    }
}
