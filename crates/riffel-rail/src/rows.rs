//! Rows of numbers, parsed in parallel.

use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;
use riffel_keys::text_file::{printable, text_of};

use crate::format::{DecimalMark, Delimiter, ReaderFormat};
use crate::number;

/// Bytes that one task parses.
const PIECE: usize = 1 << 20;

/// Columns of numbers; not a number where a value is missing.
#[derive(Debug)]
pub(super) struct Rows {
    /// In the order in which they were asked for.
    pub(super) columns: Vec<Vec<f64>>,
    /// First row and line of each piece, and the lines of its rows where some were left out.
    pieces: Vec<(usize, usize, Option<Vec<u32>>)>,
}

/// A cell that is none.
#[derive(Debug, PartialEq)]
pub(super) struct RowError {
    /// From 1.
    pub(super) line: usize,
    pub(super) message: String,
}

impl Rows {
    /// Line of a row, from 1.
    pub(super) fn line(&self, row: usize) -> usize {
        let index = self.pieces.partition_point(|piece| piece.0 <= row);
        match self.pieces.get(index.wrapping_sub(1)) {
            Some((first, line, None)) => line + row - first,
            Some((first, line, Some(lines))) => line + lines[row - first] as usize,
            None => 0,
        }
    }
}

/// Which cells of a row hold what.
pub(super) struct Cells {
    delimiter: Delimiter,
    decimal: DecimalMark,
    /// For each cell of a row up to the last that is wanted, its column.
    wanted: Vec<Option<usize>>,
    columns: usize,
    /// Cells of a row that hold numbers, and all before them.
    count: usize,
    /// Whether text may stand behind them in every row.
    text_behind: bool,
}

impl Cells {
    /// The cells of a format: the position, if there is one, then the rails. `count` is the number of
    /// cells in a row up to the last that holds numbers; `text_behind` tells of columns of text behind it.
    pub(super) fn new(format: &ReaderFormat, count: usize, text_behind: bool) -> Self {
        let columns = format.position.iter().chain(&format.rails);
        let mut wanted = Vec::new();
        let mut total = 0;
        for column in columns {
            if wanted.len() < column.column {
                wanted.resize(column.column, None);
            }
            wanted[column.column - 1] = Some(total);
            total += 1;
        }
        Self {
            delimiter: format.delimiter,
            decimal: format.decimal,
            wanted,
            columns: total,
            count,
            text_behind,
        }
    }

    /// Parse all lines from the byte `start` on, which begins line `line`. `progress` is told of bytes
    /// done.
    pub(super) fn parse(
        &self,
        bytes: &[u8],
        start: usize,
        line: usize,
        progress: &(dyn Fn(usize) + Sync),
    ) -> Result<Rows, RowError> {
        let pieces = pieces(&bytes[start..]);
        // Pieces behind a wrong one need not be read.
        let first_wrong = AtomicUsize::new(usize::MAX);
        let parsed: Vec<Piece> = pieces
            .into_par_iter()
            .enumerate()
            .map(|(index, piece)| {
                if index > first_wrong.load(Ordering::Relaxed) {
                    return Piece::default();
                }
                let parsed = self.parse_piece(piece);
                if parsed.error.is_some() {
                    first_wrong.fetch_min(index, Ordering::Relaxed);
                }
                progress(piece.len());
                parsed
            })
            .collect();
        let mut rows = Rows {
            columns: Vec::new(),
            pieces: Vec::new(),
        };
        let total: usize = parsed.iter().map(Piece::rows).sum();
        rows.columns = vec![Vec::with_capacity(total); self.columns];
        let (mut row, mut line) = (0, line);
        for piece in parsed {
            if let Some((offset, message)) = piece.error {
                return Err(RowError {
                    line: line + offset,
                    message,
                });
            }
            let count = piece.columns.first().map_or(0, Vec::len);
            for (column, part) in rows.columns.iter_mut().zip(&piece.columns) {
                column.extend_from_slice(part);
            }
            rows.pieces.push((row, line, piece.lines_of_rows));
            row += count;
            line += piece.lines;
        }
        Ok(rows)
    }

    fn parse_piece(&self, bytes: &[u8]) -> Piece {
        let mut piece = Piece {
            columns: vec![Vec::with_capacity(bytes.len() / 12); self.columns],
            lines: 0,
            lines_of_rows: None,
            error: None,
        };
        let mut row = vec![f64::NAN; self.columns];
        for line in lines(bytes) {
            let line = line.strip_suffix(b"\r").unwrap_or(line);
            if is_comment(line) {
                // From here on rows and lines differ.
                let before = piece.lines as u32;
                piece
                    .lines_of_rows
                    .get_or_insert_with(|| (0..before).collect());
            } else if let Err(message) = self.parse_line(line, &mut row) {
                piece.error = Some((piece.lines, message));
                return piece;
            } else {
                for (column, value) in piece.columns.iter_mut().zip(&row) {
                    column.push(*value);
                }
                if let Some(lines) = &mut piece.lines_of_rows {
                    lines.push(piece.lines as u32);
                }
            }
            piece.lines += 1;
        }
        piece
    }

    fn parse_line(&self, line: &[u8], row: &mut [f64]) -> Result<(), String> {
        let decimal = self.decimal.byte();
        let mut rest = trim_blanks(line, self.delimiter);
        let mut cell = 0;
        loop {
            if let Some(Some(column)) = self.wanted.get(cell) {
                let (value, length) = match number::plain(rest, decimal) {
                    Some((value, length)) if self.ends(rest, length) => (value, length),
                    _ => {
                        let length = self.cell_length(rest);
                        let value = number::parse(&rest[..length], decimal)
                            .ok_or_else(|| self.no_number(cell, &rest[..length]))?;
                        (value, length)
                    }
                };
                row[*column] = value;
                rest = &rest[length..];
            } else {
                rest = &rest[self.cell_length(rest)..];
            }
            cell += 1;
            if rest.is_empty() {
                break;
            }
            rest = trim_blanks(&rest[1..], self.delimiter);
            // A delimiter at the end of the line begins no cell, and text behind the numbers is a remark.
            if cell == self.count
                && (rest.is_empty() || self.text_behind || is_remark(rest, self.delimiter, decimal))
            {
                break;
            }
        }
        if cell == self.count {
            return Ok(());
        }
        let (plural, has) = (if cell == 1 { "" } else { "s" }, self.count);
        Err(format!(
            "has {cell} column{plural}, the lines before it have {has}"
        ))
    }

    /// Whether a cell ends after this length.
    fn ends(&self, text: &[u8], length: usize) -> bool {
        text.get(length).is_none_or(|&byte| {
            byte == self.delimiter.byte() || (self.delimiter == Delimiter::Space && byte == b'\t')
        })
    }

    fn cell_length(&self, text: &[u8]) -> usize {
        let quoted = quoted_length(text);
        (quoted..text.len())
            .find(|&at| self.ends(text, at))
            .unwrap_or(text.len())
    }

    fn no_number(&self, cell: usize, text: &[u8]) -> String {
        let shown: String = text_of(text).trim().chars().take(40).collect();
        let shown = printable(&shown);
        let column = cell + 1;
        let other = self.decimal.other();
        if number::parse(text, other.byte()).is_some() {
            let (other, own) = (other.words(), self.decimal.words());
            return format!(
                "column {column} is \"{shown}\", with a {other}; the file has a {own} elsewhere"
            );
        }
        format!("column {column} is \"{shown}\", not a number")
    }
}

/// What one task has parsed.
#[derive(Default)]
struct Piece {
    columns: Vec<Vec<f64>>,
    lines: usize,
    lines_of_rows: Option<Vec<u32>>,
    error: Option<(usize, String)>,
}

impl Piece {
    fn rows(&self) -> usize {
        self.columns.first().map_or(0, Vec::len)
    }
}

/// Pieces of whole lines.
fn pieces(bytes: &[u8]) -> Vec<&[u8]> {
    let mut pieces = Vec::new();
    let mut rest = bytes;
    while !rest.is_empty() {
        let least = PIECE.min(rest.len());
        let end = memchr::memchr(b'\n', &rest[least..]).map_or(rest.len(), |at| least + at + 1);
        let (piece, behind) = rest.split_at(end);
        pieces.push(piece);
        rest = behind;
    }
    pieces
}

/// Lines without their ends; what follows the last line feed is a line if there is anything.
pub(super) fn lines(bytes: &[u8]) -> impl Iterator<Item = &[u8]> {
    let mut rest = bytes;
    std::iter::from_fn(move || {
        if rest.is_empty() {
            return None;
        }
        let end = memchr::memchr(b'\n', rest).unwrap_or(rest.len());
        let line = &rest[..end];
        rest = rest.get(end + 1..).unwrap_or_default();
        Some(line)
    })
}

/// Whether a line is empty or a remark.
pub(super) fn is_comment(line: &[u8]) -> bool {
    match line.first() {
        None | Some(b'#' | b'%') => true,
        Some(byte) => byte.is_ascii_whitespace() && line.trim_ascii().is_empty(),
    }
}

/// Without blanks that mean nothing at the beginning, and with blanks as delimiter also at the end.
fn trim_blanks(line: &[u8], delimiter: Delimiter) -> &[u8] {
    match delimiter {
        Delimiter::Space => match line {
            [b' ' | b'\t', ..] | [.., b' ' | b'\t'] => line.trim_ascii(),
            _ => line,
        },
        _ => match line {
            [b' ', ..] => line.trim_ascii_start(),
            _ => line,
        },
    }
}

/// Bytes from an opening quote to its end, in which no delimiter ends the cell; zero without quotes.
fn quoted_length(text: &[u8]) -> usize {
    match text {
        [b'"', inner @ ..] => memchr::memchr(b'"', inner).map_or(0, |end| end + 2),
        _ => 0,
    }
}

/// Whether what stands behind the numbers of a row is no further number: words, a remark, or delimiters alone.
pub(super) fn is_remark(text: &[u8], delimiter: Delimiter, decimal: u8) -> bool {
    let words = text
        .iter()
        .any(|byte| byte.is_ascii_alphabetic() || !byte.is_ascii());
    let first = cells(text, delimiter).first().copied().unwrap_or_default();
    matches!(text.trim_ascii().first(), Some(b'#' | b'%'))
        || (words && number::parse(first, decimal).is_none())
        || !text.iter().any(|byte| byte.is_ascii_alphanumeric())
}

/// Cells of a line, trimmed.
pub(super) fn cells(line: &[u8], delimiter: Delimiter) -> Vec<&[u8]> {
    let line = line.strip_suffix(b"\r").unwrap_or(line);
    match delimiter {
        Delimiter::Space => line
            .split(|byte| matches!(byte, b' ' | b'\t'))
            .filter(|cell| !cell.is_empty())
            .collect(),
        _ => {
            let mut cells = Vec::new();
            let mut rest = Some(line);
            while let Some(text) = rest {
                let quoted = quoted_length(text);
                let end = memchr::memchr(delimiter.byte(), &text[quoted..]);
                let (cell, behind) = match end {
                    Some(at) => (&text[..quoted + at], Some(&text[quoted + at + 1..])),
                    None => (text, None),
                };
                cells.push(cell.trim_ascii());
                rest = behind;
            }
            // A delimiter at the end of the line begins no cell.
            if cells.len() > 1 && cells.last().is_some_and(|cell| cell.is_empty()) {
                cells.pop();
            }
            cells
        }
    }
}
