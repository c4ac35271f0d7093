//! The bytes of a record, which may be large: looked at first, then read within bounds.

use std::io::{self, Cursor, Read};
use std::path::Path;

use riffel_keys::text_file::{Encoding, decode, is_standard_input};
use riffel_keys::{CaseError, question, seal};

use crate::refusal::Refusal;

/// Bytes that are looked at first.
const HEAD: usize = 1 << 16;
/// Bytes that are read at a time.
const PIECE: usize = 1 << 20;
/// Longest line \[bytes\]: a row of a thousand columns has some ten thousand.
const LONGEST_LINE: usize = 1 << 20;
/// Largest input without a size of its own, a pipe or a device \[bytes\].
const LARGEST_STREAM: usize = 2 << 30;

/// Text in UTF-8 or Windows-1252 with line feeds. `check` refuses by the first bytes of a long file before the rest is
/// read.
pub(super) fn read(path: &Path, check: &dyn Fn(&[u8]) -> Result<(), Refusal>) -> Result<Vec<u8>, CaseError> {
    let failed = |reason| CaseError::Read { what: "file", path: path.to_owned(), reason };
    let mut file: Box<dyn Read> = if let Some(table) = question::as_csv(path) {
        Box::new(Cursor::new(table.map_err(failed)?))
    } else if is_standard_input(path) {
        Box::new(io::stdin().lock())
    } else {
        Box::new(seal::open(path).map_err(failed)?)
    };
    let size = std::fs::metadata(path).ok();
    let size = size.filter(std::fs::Metadata::is_file);
    let size = size.map(|file| file.len() as usize);
    let mut bytes = Vec::new();
    file.by_ref().take(HEAD as u64).read_to_end(&mut bytes).map_err(failed)?;
    let refuse = |refusal: Refusal| refusal.of(path);
    let encoding = Encoding::of(&bytes).map_err(|byte| refuse(Refusal::new(Some(byte.line), byte)))?;
    let wide = matches!(encoding, Encoding::Utf16LittleEndian | Encoding::Utf16BigEndian);
    let mut reading = Reading::new(&bytes, wide);
    if bytes.len() == HEAD {
        if !wide {
            let mut head = bytes.clone();
            reading.end_lines(&mut head);
            check(&head).map_err(refuse)?;
        }
        bytes.reserve(size.unwrap_or(0).saturating_sub(HEAD));
        loop {
            let from = bytes.len();
            let read = file.by_ref().take(PIECE as u64).read_to_end(&mut bytes).map_err(failed)?;
            if read == 0 {
                break;
            }
            reading.check(&bytes, from).map_err(refuse)?;
            if size.is_none() && bytes.len() > LARGEST_STREAM {
                let message = format!("does not end within {} MiB", LARGEST_STREAM >> 20);
                return Err(refuse(Refusal::new(None, message)));
            }
        }
    }
    if wide {
        let text = decode(bytes).map_err(|byte| refuse(Refusal::new(None, byte)))?;
        return Ok(text.into_bytes());
    }
    reading.end_lines(&mut bytes);
    Ok(bytes)
}

/// What is known of the text read so far.
struct Reading {
    /// What ends a line.
    end: u8,
    /// Whether bytes stand in pairs, so that NUL is no sign of a binary file and line ends are not looked for.
    wide: bool,
    /// Lines before the last, which is still being read.
    lines: usize,
    /// Where the last line begins.
    last: usize,
}

impl Reading {
    fn new(head: &[u8], wide: bool) -> Self {
        let returns = memchr::memchr(b'\n', head).is_none() && memchr::memchr(b'\r', head).is_some();
        let end = if returns { b'\r' } else { b'\n' };
        Self {
            end,
            wide,
            lines: memchr::memchr_iter(end, head).count(),
            last: memchr::memrchr(end, head).map_or(0, |at| at + 1),
        }
    }

    /// Check what was read from a byte on.
    fn check(&mut self, bytes: &[u8], from: usize) -> Result<(), Refusal> {
        if self.wide {
            return Ok(());
        }
        let piece = &bytes[from..];
        if let Some(at) = memchr::memchr(0, piece) {
            let line = self.lines + memchr::memchr_iter(self.end, &piece[..at]).count() + 1;
            let message = format!("the file is binary: byte {} is 0x00, which no text has", from + at + 1);
            return Err(Refusal::new(Some(line), message));
        }
        self.lines += memchr::memchr_iter(self.end, piece).count();
        if let Some(at) = memchr::memrchr(self.end, piece) {
            self.last = from + at + 1;
        }
        if bytes.len() - self.last > LONGEST_LINE {
            let message = format!("is longer than {} MiB, and no row of numbers", LONGEST_LINE >> 20);
            return Err(Refusal::new(Some(self.lines + 1), message));
        }
        Ok(())
    }

    /// Line feeds in place of carriage returns that stand alone.
    fn end_lines(&self, bytes: &mut [u8]) {
        if self.end == b'\r' {
            for byte in bytes.iter_mut().filter(|byte| **byte == b'\r') {
                *byte = b'\n';
            }
        }
    }
}
