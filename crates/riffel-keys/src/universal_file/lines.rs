//! Lines of a universal file and the marks that enclose its datasets.

use std::borrow::Cow;

use super::UniversalFileError;
use super::fields::Fields;

/// What is left of a file, taken line by line.
#[derive(Clone, Copy)]
pub(super) struct Lines<'a> {
    rest: &'a [u8],
    taken: usize,
    opening: usize,
}

/// One line without its end.
pub(super) struct Line<'a> {
    pub(super) number: usize,
    pub(super) text: Cow<'a, str>,
}

impl<'a> Lines<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { rest: bytes, taken: 0, opening: 0 }
    }

    /// Lines from within a dataset, so many of the file before them, and the one with the opening mark.
    pub(super) fn within(bytes: &'a [u8], taken: usize, opening: usize) -> Self {
        Self { rest: bytes, taken, opening }
    }

    /// Line with the mark that opened the present dataset.
    pub(super) fn opening(&self) -> usize {
        self.opening
    }

    /// Number of the line that comes next.
    pub(super) fn coming(&self) -> usize {
        self.taken + 1
    }

    fn next(&mut self) -> Option<Line<'a>> {
        if self.rest.is_empty() {
            return None;
        }
        let mut parts = self.rest.splitn(2, |&byte| byte == b'\n');
        let bytes = parts.next().unwrap_or_default();
        self.rest = parts.next().unwrap_or_default();
        self.taken += 1;
        Some(Line::new(self.taken, bytes))
    }

    /// Take the mark that opens a dataset; false at the end of the file.
    pub(super) fn open(&mut self) -> Result<bool, UniversalFileError> {
        while let Some(line) = self.next() {
            if line.is_mark() {
                self.opening = line.number;
                return Ok(true);
            }
            if !line.text.trim().is_empty() {
                return Err(UniversalFileError::Outside { line: line.number });
            }
        }
        Ok(false)
    }

    /// Take a line of the present dataset, which may be the closing mark.
    pub(super) fn inside(&mut self) -> Result<Line<'a>, UniversalFileError> {
        self.next().ok_or(UniversalFileError::Truncated { line: self.opening })
    }

    /// Take a line of the present dataset that must not be the closing mark.
    pub(super) fn record(&mut self, name: &'static str) -> Result<Line<'a>, UniversalFileError> {
        let line = self.inside()?;
        if line.is_mark() {
            return Err(UniversalFileError::RecordMissing { line: line.number, record: name });
        }
        Ok(line)
    }

    /// Take everything to the closing mark.
    pub(super) fn skip(&mut self) -> Result<(), UniversalFileError> {
        while !self.inside()?.is_mark() {}
        Ok(())
    }

    pub(super) fn mark_follows(mut self) -> bool {
        self.next().is_some_and(|line| line.is_mark())
    }

    /// Take so many bytes and the closing mark, if the mark follows them.
    ///
    /// The mark follows the bytes at once, but some systems end the line before it.
    pub(super) fn block(&mut self, length: usize) -> Option<&'a [u8]> {
        let (block, rest) = self.rest.split_at_checked(length)?;
        let mut after = Self { rest, ..*self };
        for end in [&b"\r\n"[..], b"\n"] {
            if let Some(rest) = rest.strip_prefix(end) {
                after.rest = rest;
                after.taken += 1;
                break;
            }
        }
        if !after.next()?.is_mark() {
            return None;
        }
        *self = after;
        Some(block)
    }
}

/// Text in UTF-8 or, where it is not, in Latin-1, of which older systems write their units.
fn decode(bytes: &[u8]) -> Cow<'_, str> {
    match std::str::from_utf8(bytes) {
        Ok(text) => Cow::Borrowed(text),
        Err(_) => Cow::Owned(bytes.iter().copied().map(char::from).collect()),
    }
}

impl<'a> Line<'a> {
    /// A line of a number, with its end.
    pub(super) fn new(number: usize, bytes: &'a [u8]) -> Self {
        let bytes = bytes.strip_suffix(b"\n").unwrap_or(bytes);
        Self { number, text: decode(bytes.strip_suffix(b"\r").unwrap_or(bytes)) }
    }

    pub(super) fn is_mark(&self) -> bool {
        self.text.trim_end() == "    -1"
    }

    pub(super) fn fields(&self) -> Fields<'_> {
        Fields::new(self.number, &self.text)
    }
}
