//! Columns of numbers of a large table, parsed in parallel, or line by line.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;

use super::delimiter::{DecimalMark, Delimiter};
use super::heading::label;
use super::line::{is_comment, is_remark, lines, quoted_length, trim_blanks};
use super::missing::{Marked, leave_out_marks};
use super::number::{Oddity, clock, number, oddity, plain};
use crate::printable::printable;
use crate::text_file::text_of;
use crate::{Message, say};

/// Bytes that one task parses.
const PIECE: usize = 1 << 20;

/// Rows of numbers; not a number where a value is missing.
#[derive(Debug, Default)]
pub struct NumberRows {
    /// Columns, in the order in which they were asked for.
    pub columns: Vec<Vec<f64>>,
    /// Values that only mark missing ones, by column, which are NaN now.
    pub marked: Vec<Option<Marked>>,
    /// First row and line of each piece, and the lines of its rows where some were left out.
    pieces: Vec<(usize, usize, Option<Vec<u32>>)>,
    /// The cells of the columns of labels, those of a row together and once each, and which of these every row has; empty
    /// without such columns.
    labels: (Vec<Vec<String>>, Vec<u32>),
}

/// A row that has no such numbers.
#[derive(Debug, PartialEq)]
pub struct RowError {
    /// From 1.
    pub line: usize,
    /// What is wrong, as a sentence without its subject, or with the column as its subject.
    pub message: Message,
}

impl NumberRows {
    /// Line of a row, from 1.
    pub fn line(&self, row: usize) -> usize {
        let index = self.pieces.partition_point(|piece| piece.0 <= row);
        match self.pieces.get(index.wrapping_sub(1)) {
            Some((first, line, None)) => line + row - first,
            Some((first, line, Some(lines))) => line + lines[row - first] as usize,
            None => 0,
        }
    }

    /// The rows of each label with its cells, in the order in which labels first come; all rows without one where there are
    /// none.
    pub fn by_label(self) -> Vec<(Vec<String>, Self)> {
        if self.labels.0.len() < 2 {
            let label = self.labels.0.first().cloned().unwrap_or_default();
            return vec![(label, self)];
        }
        let (labels, of_rows) = &self.labels;
        let split = labels.iter().zip(0..).map(|(label, id)| {
            let rows: Vec<usize> = (0..of_rows.len()).filter(|&row| of_rows[row] == id).collect();
            let take = |column: &Vec<f64>| rows.iter().map(|&row| column[row]).collect();
            let lines = rows.iter().map(|&row| self.line(row) as u32).collect();
            let part = Self {
                columns: self.columns.iter().map(take).collect(),
                marked: vec![None; self.columns.len()],
                pieces: vec![(0, 0, Some(lines))],
                labels: Default::default(),
            };
            (label.clone(), part)
        });
        split.collect()
    }
}

/// What a cell is read for.
#[derive(Debug, Clone, Copy)]
enum CellUse {
    /// The number of a column.
    Number(usize),
    /// The seconds of a column of times of day.
    Clock(usize),
    Label,
    Nothing,
}

/// Which cells of a row are read as numbers, and which as labels.
#[derive(Debug)]
pub struct NumberColumns {
    delimiter: Delimiter,
    decimal: DecimalMark,
    /// For each cell of a row up to the last that is wanted.
    wanted: Vec<CellUse>,
    columns: usize,
    /// Cells of a row that must be there.
    count: usize,
    /// Whether text may stand behind them in every row.
    text_behind: bool,
}

impl NumberColumns {
    /// `columns` and `labels` are places in a row, from zero. `count` is the number of cells in a row up to the last that holds
    /// numbers; `text_behind` tells of columns of text behind it.
    pub fn new(
        (delimiter, decimal): (Delimiter, DecimalMark),
        columns: &[usize],
        labels: &[usize],
        count: usize,
        text_behind: bool,
    ) -> Self {
        let last = columns.iter().chain(labels).max();
        let mut wanted = vec![CellUse::Nothing; last.map_or(0, |last| last + 1)];
        for &label in labels {
            wanted[label] = CellUse::Label;
        }
        for (number, &column) in columns.iter().enumerate() {
            wanted[column] = CellUse::Number(number);
        }
        Self { delimiter, decimal, count: count.max(wanted.len()), wanted, columns: columns.len(), text_behind }
    }

    /// Read the cells in a place as times of day, see [`clock`].
    #[must_use]
    pub fn with_clock(mut self, place: usize) -> Self {
        if let Some(wanted) = self.wanted.get_mut(place)
            && let CellUse::Number(column) = *wanted
        {
            *wanted = CellUse::Clock(column);
        }
        self
    }

    /// Parse all lines from the byte `start` on, which begins line `line`. `progress` is told of bytes done.
    ///
    /// # Errors
    /// [`RowError`] for the first row with a cell that is no number, or with other cells than the rows before.
    pub fn parse(
        &self,
        bytes: &[u8],
        start: usize,
        line: usize,
        progress: &(dyn Fn(usize) + Sync),
    ) -> Result<NumberRows, RowError> {
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
        let total: usize = parsed.iter().map(Piece::rows).sum();
        let mut rows = NumberRows { columns: vec![Vec::with_capacity(total); self.columns], ..NumberRows::default() };
        let (mut row, mut line) = (0, line);
        for piece in parsed {
            if let Some((offset, message)) = piece.error {
                return Err(RowError { line: line + offset, message });
            }
            for (column, part) in rows.columns.iter_mut().zip(&piece.columns) {
                column.extend_from_slice(part);
            }
            let (labels, of_rows) = &mut rows.labels;
            let ids = piece.labels.known.into_iter().map(|label| {
                let known = labels.iter().position(|known| *known == label);
                known.unwrap_or_else(|| {
                    labels.push(label);
                    labels.len() - 1
                }) as u32
            });
            let ids: Vec<u32> = ids.collect();
            of_rows.extend(piece.labels.of_rows.iter().map(|&id| ids[id as usize]));
            let count = piece.columns.first().map_or(0, Vec::len);
            rows.pieces.push((row, line, piece.lines_of_rows));
            row += count;
            line += piece.lines;
        }
        let columns = rows.columns.par_iter_mut();
        rows.marked = columns.map(|column| leave_out_marks(column)).collect();
        Ok(rows)
    }

    fn parse_piece(&self, bytes: &[u8]) -> Piece {
        let mut piece = Piece { columns: vec![Vec::with_capacity(bytes.len() / 12); self.columns], ..Piece::default() };
        let mut row = vec![f64::NAN; self.columns];
        let mut cells = Vec::new();
        for line in lines(bytes) {
            let line = line.strip_suffix(b"\r").unwrap_or(line);
            if is_comment(line) {
                // From here on rows and lines differ.
                let before = piece.lines as u32;
                piece.lines_of_rows.get_or_insert_with(|| (0..before).collect());
            } else if let Err(message) = self.parse_line(line, &mut row, &mut cells) {
                piece.error = Some((piece.lines, message));
                return piece;
            } else {
                for (column, value) in piece.columns.iter_mut().zip(&row) {
                    column.push(*value);
                }
                if !cells.is_empty() {
                    piece.labels.push(&cells);
                    cells.clear();
                }
                if let Some(lines) = &mut piece.lines_of_rows {
                    lines.push(piece.lines as u32);
                }
            }
            piece.lines += 1;
        }
        piece
    }

    /// Parse a line without its end into a row of numbers, and take its labels.
    ///
    /// # Errors
    /// A sentence for a cell that is no number, or other cells than rows have.
    pub fn parse_line<'a>(&self, line: &'a [u8], row: &mut [f64], labels: &mut Vec<&'a [u8]>) -> Result<(), Message> {
        let decimal = self.decimal.byte();
        let mut rest = trim_blanks(line, self.delimiter);
        let mut cell = 0;
        loop {
            match self.wanted.get(cell) {
                Some(CellUse::Number(column)) => {
                    let (value, length) = match plain(rest, decimal) {
                        Some((value, length)) if self.ends(rest, length) => (value, length),
                        _ => {
                            let length = self.cell_length(rest);
                            let value = number(&rest[..length], decimal)
                                .ok_or_else(|| self.no_number(cell, &rest[..length]))?;
                            (value, length)
                        }
                    };
                    row[*column] = value;
                    rest = &rest[length..];
                }
                Some(CellUse::Clock(column)) => {
                    let (text, behind) = rest.split_at(self.cell_length(rest));
                    row[*column] = clock(text).ok_or_else(|| self.no_number(cell, text))?;
                    rest = behind;
                }
                wanted => {
                    let (text, behind) = rest.split_at(self.cell_length(rest));
                    if matches!(wanted, Some(CellUse::Label)) {
                        labels.push(text);
                    }
                    rest = behind;
                }
            }
            cell += 1;
            if rest.is_empty() {
                break;
            }
            rest = trim_blanks(&rest[1..], self.delimiter);
            // A delimiter at the end of the line begins no cell, and text behind the numbers is a remark.
            if cell == self.count && (rest.is_empty() || self.text_behind || is_remark(rest, self.delimiter, decimal)) {
                break;
            }
        }
        if cell == self.count {
            return Ok(());
        }
        let (plural, has) = (if cell == 1 { "" } else { "s" }, self.count);
        Err(format!("has {cell} column{plural}, the lines before it have {has}").into())
    }

    /// Whether a cell ends after this length.
    fn ends(&self, text: &[u8], length: usize) -> bool {
        text.get(length)
            .is_none_or(|&byte| byte == self.delimiter.byte() || (self.delimiter == Delimiter::Space && byte == b'\t'))
    }

    fn cell_length(&self, text: &[u8]) -> usize {
        let quoted = quoted_length(text);
        (quoted..text.len()).find(|&at| self.ends(text, at)).unwrap_or(text.len())
    }

    fn no_number(&self, cell: usize, text: &[u8]) -> Message {
        let shown: String = text_of(text).trim().chars().take(40).collect();
        let (column, shown) = (crate::number(cell + 1), printable(&shown).into_owned());
        let (own, other) = (self.decimal, self.decimal.other());
        if number(text, other.byte()).is_some() {
            let (other, own) = (other.words(), own.words());
            return say!(cell_has_other_mark, column, cell = shown, other, own);
        }
        match oddity(text) {
            Some(Oddity::Brackets) => say!(cell_in_brackets, column, cell = shown),
            Some(Oddity::Unit) => say!(cell_with_letters, column, cell = shown),
            Some(Oddity::Mark) => say!(cell_with_marks, column, cell = shown),
            None => say!(cell_is_no_number, column, cell = shown),
        }
    }
}

/// What one task has parsed.
#[derive(Default)]
struct Piece {
    columns: Vec<Vec<f64>>,
    lines: usize,
    lines_of_rows: Option<Vec<u32>>,
    labels: Labels,
    error: Option<(usize, Message)>,
}

impl Piece {
    fn rows(&self) -> usize {
        self.columns.first().map_or(0, Vec::len)
    }
}

/// Labels of rows, which seldom change from one to the next.
#[derive(Default)]
struct Labels {
    ids: BTreeMap<Vec<u8>, u32>,
    known: Vec<Vec<String>>,
    of_rows: Vec<u32>,
    last: Vec<u8>,
}

impl Labels {
    fn push(&mut self, cells: &[&[u8]]) {
        let joined = cells.join(&0);
        let id = match self.of_rows.last() {
            Some(&id) if joined == self.last => id,
            _ => *self.ids.entry(joined.clone()).or_insert_with(|| {
                self.known.push(cells.iter().map(|cell| label(cell)).collect());
                (self.known.len() - 1) as u32
            }),
        };
        self.last = joined;
        self.of_rows.push(id);
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_with_other_labels_are_other_records() {
        let text = b"L;0,0;1,5\nL;0,1;-9999\n# turned\nR;0,0;2,5\nL;0,2;1,25\n";
        let columns = NumberColumns::new((Delimiter::Semicolon, DecimalMark::Comma), &[1, 2], &[0], 3, false);
        let rows = columns.parse(text, 0, 1, &|_| ()).unwrap();
        assert_eq!(rows.marked[1].map(|marked| (marked.mark, marked.first)), Some((-9999.0, 1)));
        let records = rows.by_label();
        let names: Vec<String> = records.iter().map(|record| record.0.join(" ")).collect();
        assert_eq!(names, ["L", "R"]);
        assert_eq!(records[0].1.columns[0], [0.0, 0.1, 0.2]);
        assert_eq!(records[0].1.line(2), 5);
        assert_eq!(records[1].1.columns[1], [2.5]);
        assert_eq!(records[1].1.line(0), 4);
    }
}
