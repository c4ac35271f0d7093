//! Lines of a table, and their cells.

use super::delimiter::Delimiter;
use super::number::number;

/// Lines without their ends; what follows the last line feed is a line if there is anything.
#[inline]
pub fn lines(bytes: &[u8]) -> impl Iterator<Item = &[u8]> {
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
#[inline]
pub fn is_comment(line: &[u8]) -> bool {
    match line.first() {
        None | Some(b'#' | b'%') => true,
        Some(byte) => byte.is_ascii_whitespace() && line.trim_ascii().is_empty(),
    }
}

/// Cells of a line, trimmed, with quotes around them where they have some; a delimiter at the end begins an empty one.
pub fn cells(line: &[u8], delimiter: Delimiter) -> Vec<&[u8]> {
    let line = line.strip_suffix(b"\r").unwrap_or(line);
    if delimiter == Delimiter::Space {
        let words = line.split(|byte| matches!(byte, b' ' | b'\t'));
        return words.filter(|cell| !cell.is_empty()).collect();
    }
    let mut cells = Vec::new();
    let mut rest = Some(line);
    while let Some(text) = rest {
        let blanks = text.len() - text.trim_ascii_start().len();
        let quoted = blanks + quoted_length(&text[blanks..]);
        let end = memchr::memchr(delimiter.byte(), &text[quoted..]);
        let (cell, behind) = match end {
            Some(at) => (&text[..quoted + at], Some(&text[quoted + at + 1..])),
            None => (text, None),
        };
        cells.push(cell.trim_ascii());
        rest = behind;
    }
    cells
}

/// Cells of a line without the empty ones at its end beyond the first `count`.
pub(super) fn cells_up_to(line: &[u8], delimiter: Delimiter, count: usize) -> Vec<&[u8]> {
    let mut cells = cells(line, delimiter);
    end_at(&mut cells, count, |cell| cell.is_empty());
    cells
}

/// Leave out the empty cells at the end of a line beyond the first `count`.
pub(super) fn end_at<Cell>(cells: &mut Vec<Cell>, count: usize, is_empty: impl Fn(&Cell) -> bool) {
    while cells.len() > count && cells.last().is_some_and(&is_empty) {
        cells.pop();
    }
}

/// Without blanks that mean nothing at the beginning, and with blanks as delimiter also at the end.
#[inline]
pub(super) fn trim_blanks(line: &[u8], delimiter: Delimiter) -> &[u8] {
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
#[inline]
pub(super) fn quoted_length(text: &[u8]) -> usize {
    match text {
        [b'"', inner @ ..] => memchr::memchr(b'"', inner).map_or(0, |end| end + 2),
        _ => 0,
    }
}

/// Whether what stands behind the numbers of a row is no further number: words, a remark, or delimiters alone.
pub(super) fn is_remark(text: &[u8], delimiter: Delimiter, decimal: u8) -> bool {
    let words = text.iter().any(|byte| byte.is_ascii_alphabetic() || !byte.is_ascii());
    let first = cells(text, delimiter).first().copied().unwrap_or_default();
    matches!(text.trim_ascii().first(), Some(b'#' | b'%'))
        || (words && number(first, decimal).is_none())
        || !text.iter().any(|byte| byte.is_ascii_alphanumeric())
}
