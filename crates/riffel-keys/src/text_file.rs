//! A text file of any origin: bounded in size, told from binary files, decoded.

use std::fmt;
use std::io;
use std::path::Path;

use crate::binary_format::BinaryFormat;
pub use crate::printable::{in_a_message, printable};
pub use crate::standard_input::LARGEST_RESPONSES;
use crate::standard_input::{read_to, standard_input};
use crate::texts_in_memory::in_memory;
pub use crate::texts_in_memory::with_texts;
use crate::{CaseError, Message, number, question, say, seal};

/// Largest file of keys \[bytes\]: a case, a traffic, a plan, a recipe, a limit table, a site. Also the largest
/// table of observations.
pub const LARGEST_KEYS: u64 = 16 << 20;

/// Bytes from which the encoding is told.
const HEAD: usize = 1 << 16;
/// Share of control characters above which a file is no text.
const MOST_CONTROLS: f64 = 0.01;

/// How letters are written as bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Encoding {
    /// UTF-8, ASCII among it.
    Utf8,
    /// UTF-16, the low byte first.
    Utf16LittleEndian,
    /// UTF-16, the high byte first.
    Utf16BigEndian,
    /// Windows-1252, the usual 8-bit encoding of western Windows; Latin 1 but for 0x80 to 0x9f.
    Windows1252,
}

/// A byte that no text has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BinaryByte {
    /// Its place in the file, from zero.
    pub at: usize,
    /// Its line, from 1.
    pub line: usize,
    /// Its value.
    pub value: u8,
    /// The format of the file, where its first bytes tell it.
    pub format: Option<&'static BinaryFormat>,
}

impl fmt::Display for BinaryByte {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(&Message::from(*self).to_string())
    }
}

impl From<BinaryByte> for Message {
    fn from(byte: BinaryByte) -> Self {
        match byte.format {
            Some(format) => say!(file_of_binary_format, name = format.name(), reader = format.reader()),
            None => say!(file_is_binary, at = number(byte.at + 1), value = format!("{:#04x}", byte.value)),
        }
    }
}

impl BinaryByte {
    fn new(bytes: &[u8], at: usize) -> Self {
        Self { at, line: line_of(bytes, at), value: bytes[at], format: BinaryFormat::of(bytes) }
    }
}

impl Encoding {
    /// The encoding of a text, from its byte order mark or else from its first 64 KiB, where NULs in every other
    /// byte are UTF-16, and bytes that are no UTF-8 are Windows-1252.
    ///
    /// # Errors
    /// [`BinaryByte`] for what is no text: any other NUL, or more than 1 % of other control characters.
    pub fn of(bytes: &[u8]) -> Result<Self, BinaryByte> {
        match bytes {
            [0xff, 0xfe, ..] => return Ok(Self::Utf16LittleEndian),
            [0xfe, 0xff, ..] => return Ok(Self::Utf16BigEndian),
            _ => {}
        }
        let head = &bytes[..bytes.len().min(HEAD)];
        if BinaryFormat::of(head).is_some_and(BinaryFormat::is_certain) {
            return Err(BinaryByte::new(head, 0));
        }
        if let Some(at) = memchr::memchr(0, head) {
            return Self::of_pairs(head).ok_or_else(|| BinaryByte::new(head, at));
        }
        let control = |byte: &u8| *byte < 32 && !matches!(byte, b'\t' | b'\n' | b'\r' | 12);
        let controls = head.iter().filter(|byte| control(byte)).count();
        if controls as f64 > MOST_CONTROLS * head.len() as f64 {
            let at = head.iter().position(control).unwrap_or(0);
            return Err(BinaryByte::new(head, at));
        }
        Ok(match std::str::from_utf8(head) {
            Ok(_) => Self::Utf8,
            // A letter that is cut at the end of the head is whole behind it.
            Err(error) if error.error_len().is_none() && bytes.len() > head.len() => Self::Utf8,
            Err(_) => Self::Windows1252,
        })
    }

    /// UTF-16 without a byte order mark: western text has a NUL in nearly every pair of bytes, always on the same
    /// side.
    fn of_pairs(head: &[u8]) -> Option<Self> {
        let pairs = head.len() / 2;
        let nuls = |side: usize| {
            let bytes = head.iter().skip(side).step_by(2);
            bytes.filter(|&&byte| byte == 0).count()
        };
        let (first, second) = (nuls(0), nuls(1));
        let most = |count: usize| 10 * count >= 8 * pairs;
        match (first, second) {
            (0, second) if most(second) => Some(Self::Utf16LittleEndian),
            (first, 0) if most(first) => Some(Self::Utf16BigEndian),
            _ => None,
        }
    }

    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Utf8 => "UTF-8",
            Self::Utf16LittleEndian | Self::Utf16BigEndian => "UTF-16",
            Self::Windows1252 => "Windows-1252",
        }
    }
}

/// True for the path `-`, which stands for standard input wherever a file is read.
pub fn is_standard_input(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// The bytes of a file, or of standard input for the path `-`, which is `what` in errors, as in "case file".
///
/// # Errors
/// [`CaseError::Read`] if it cannot be read, [`CaseError::Data`] if it is larger than `largest` bytes, so that
/// endless input comes to an end.
pub fn read_bounded(path: &Path, what: &'static str, largest: u64) -> Result<Vec<u8>, CaseError> {
    let failed = |reason| CaseError::Read { what, path: path.to_owned(), reason };
    let bytes = if let Some(text) = in_memory(path) {
        Ok(text)
    } else if let Some(document) = question::as_toml(path) {
        document
    } else if is_standard_input(path) {
        standard_input(largest + 1)
    } else {
        seal::open(path).and_then(|file| read_to(file, largest + 1))
    };
    let bytes = bytes.map_err(failed)?;
    if bytes.len() as u64 > largest {
        let message = format!("is larger than {} MiB, the most that Riffel reads of a {what}", largest >> 20);
        return Err(CaseError::data(path, message));
    }
    Ok(bytes)
}

/// The text of a file of keys (TOML), which is UTF-8 by definition; `what` it is in errors.
///
/// # Errors
/// Errors of [`read_bounded`]; [`CaseError::Data`] with line and byte if it is not UTF-8, and what it looks like.
pub fn read_keys(path: &Path, what: &'static str) -> Result<String, CaseError> {
    let bytes = read_bounded(path, what, LARGEST_KEYS)?;
    if bytes.iter().all(u8::is_ascii_whitespace) {
        return Err(CaseError::data(path, "the file is empty"));
    }
    let refuse = |line, message| CaseError::Data {
        path: path.to_owned(),
        line,
        message,
        help: Some("save the file as UTF-8".into()),
    };
    let encoding = Encoding::of(&bytes).map_err(|byte| CaseError::Data {
        path: path.to_owned(),
        line: Some(byte.line),
        message: byte.into(),
        help: None,
    })?;
    if !matches!(encoding, Encoding::Utf8 | Encoding::Windows1252) {
        let message = format!("is text in {}, but a {what} must be UTF-8", encoding.name());
        return Err(refuse(None, message.into()));
    }
    let text = String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        let bytes = error.as_bytes();
        let message = format!(
            "byte {} of the file is {:#04x}, which is not UTF-8; it looks like Windows-1252, where it is \"{}\"",
            at + 1,
            bytes[at],
            printable(&windows_1252(bytes[at]).to_string())
        );
        refuse(Some(line_of(bytes, at)), message.into())
    })?;
    Ok(with_line_feeds(text))
}

/// A text in UTF-8 with line feeds at the ends of lines, whatever its encoding and its line ends were.
///
/// # Errors
/// [`BinaryByte`] for what is no text.
pub fn decode(bytes: Vec<u8>) -> Result<String, BinaryByte> {
    let encoding = Encoding::of(&bytes)?;
    if let Some(at) = memchr::memchr(0, &bytes)
        && matches!(encoding, Encoding::Utf8 | Encoding::Windows1252)
    {
        return Err(BinaryByte::new(&bytes, at));
    }
    let text = match encoding {
        Encoding::Utf16LittleEndian => utf_16(&bytes, u16::from_le_bytes),
        Encoding::Utf16BigEndian => utf_16(&bytes, u16::from_be_bytes),
        Encoding::Utf8 | Encoding::Windows1252 => match String::from_utf8(bytes) {
            Ok(text) => text,
            Err(error) => error.as_bytes().iter().copied().map(windows_1252).collect(),
        },
    };
    Ok(with_line_feeds(text))
}

/// `Ok` for a file that can be read as often as one likes.
///
/// # Errors
/// That of the system, or a sentence for a pipe or a device: what was read of it is gone, and it may wait for ever.
pub fn check_is_read_twice(path: &Path) -> io::Result<()> {
    let kind = std::fs::metadata(path)?;
    match kind.is_file() || kind.is_dir() {
        true => Ok(()),
        false => {
            Err(io::Error::other("it is a pipe or a device, but is read more than once: write it to a file first"))
        }
    }
}

/// A piece of text in UTF-8 or, where it is none, in Windows-1252.
pub fn text_of(bytes: &[u8]) -> String {
    match std::str::from_utf8(bytes) {
        Ok(text) => text.to_owned(),
        Err(_) => bytes.iter().copied().map(windows_1252).collect(),
    }
}

/// Without a byte order mark; a carriage return ends a line, with the line feed behind it or alone.
fn with_line_feeds(text: String) -> String {
    let text = match text.strip_prefix('\u{feff}') {
        Some(rest) => rest.to_owned(),
        None => text,
    };
    if !text.contains('\r') {
        return text;
    }
    text.replace("\r\n", "\n").replace('\r', "\n")
}

fn utf_16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> String {
    let units = bytes.chunks_exact(2).map(|pair| unit([pair[0], pair[1]]));
    char::decode_utf16(units).map(|character| character.unwrap_or(char::REPLACEMENT_CHARACTER)).collect()
}

/// The character of a byte in Windows-1252; the five bytes without one are the control characters of Latin 1.
fn windows_1252(byte: u8) -> char {
    /// 0x80 to 0x9f, as the Unicode Consortium maps them (CP1252.TXT).
    const UPPER: [char; 32] = [
        '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', 'Ž', '\u{8f}', '\u{90}', '‘',
        '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}', 'ž', 'Ÿ',
    ];
    match byte {
        0x80..=0x9f => UPPER[usize::from(byte - 0x80)],
        byte => char::from(byte),
    }
}

/// The line of a byte, from 1.
fn line_of(bytes: &[u8], at: usize) -> usize {
    memchr::memchr_iter(b'\n', &bytes[..at]).count() + 1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::printable::{command_in, printable_in_place};
    use proptest::prelude::*;

    fn utf_16_bytes(text: &str, bytes: fn(u16) -> [u8; 2]) -> Vec<u8> {
        text.encode_utf16().flat_map(bytes).collect()
    }

    #[test]
    fn the_same_text_comes_out_of_every_encoding() {
        let text = "Höhe [µm];Weg\n1,5;2\n";
        let mut latin: Vec<u8> = text.chars().map(|c| c as u8).collect();
        let little = utf_16_bytes(text, u16::to_le_bytes);
        let big = utf_16_bytes(text, u16::to_be_bytes);
        let marked = utf_16_bytes(&format!("\u{feff}{text}"), u16::to_be_bytes);
        for (bytes, encoding) in [
            (text.as_bytes().to_vec(), Encoding::Utf8),
            (format!("\u{feff}{text}").into_bytes(), Encoding::Utf8),
            (latin.clone(), Encoding::Windows1252),
            (little, Encoding::Utf16LittleEndian),
            (big, Encoding::Utf16BigEndian),
            (marked, Encoding::Utf16BigEndian),
            (text.replace('\n', "\r\n").into_bytes(), Encoding::Utf8),
            (text.replace('\n', "\r").into_bytes(), Encoding::Utf8),
        ] {
            assert_eq!(Encoding::of(&bytes), Ok(encoding));
            assert_eq!(decode(bytes).unwrap(), text);
        }
        latin.push(0x80);
        assert!(decode(latin).unwrap().ends_with('€'));
    }

    #[test]
    fn binary_files_are_told_by_their_first_byte() {
        let wrong = decode(b"one\ntwo\x00three".to_vec()).unwrap_err();
        assert_eq!((wrong.at, wrong.line, wrong.value), (7, 2, 0));
        assert_eq!(wrong.to_string(), "the file is binary: byte 8 is 0x00, which no text has");
        assert!(decode(vec![0; 1000]).is_err());
        assert!(decode(b"\x7fELF\x02\x01\x01\x00\x00".to_vec()).is_err());
        assert!(decode(Vec::new()).is_ok());
    }

    proptest! {
        #[test]
        fn whatever_is_decoded_can_be_shown(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
            if let Ok(text) = decode(bytes) {
                prop_assert!(command_in(&printable(&text)).is_none());
                prop_assert_eq!(printable_in_place(&text).len(), text.len());
            }
        }
    }
}
