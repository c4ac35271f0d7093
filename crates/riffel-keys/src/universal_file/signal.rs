//! Functions whose values stay in the file until they are asked for: signals of hours.

use std::io::{self, BufRead, Read, Seek, SeekFrom};

use thiserror::Error;

use super::binary::Encoding;
use super::form::Form;
use super::lines::{Line, Lines};
use super::{Function, Units, UniversalFile, UniversalFileError};

/// Longest line that is looked at \[bytes\]; those of the format have 80 columns.
const LONGEST_LINE: u64 = 1 << 12;
/// Records between the number of a dataset 58 and its values.
const RECORDS: usize = 11;

/// A file that cannot be read, or is no universal file.
#[derive(Debug, Error)]
pub enum SignalError {
    /// The file cannot be read.
    #[error(transparent)]
    Read(#[from] io::Error),
    /// What stands in it is wrong.
    #[error(transparent)]
    File(#[from] UniversalFileError),
}

/// A function, and where its values are.
#[derive(Debug, Clone)]
pub struct Signal {
    /// What is said of it; its abscissa and ordinate are empty.
    pub function: Function,
    /// How many points it has.
    pub points: usize,
    /// First value and step of the abscissa in the units of the file; `None` if it is uneven.
    pub even: Option<(f64, f64)>,
    form: Form,
    /// How binary values are encoded, and the bytes of each number of a point.
    encoding: Option<(Encoding, Vec<usize>)>,
    /// Of the first value \[bytes\].
    offset: u64,
    /// Lines before the first value.
    lines: usize,
}

/// The functions of a universal file, of any length.
///
/// Method: one pass over the lines of text; binary values are leapt over. Memory: a record for each function.
#[derive(Debug, Clone)]
pub struct Signals {
    /// In the order of the file.
    pub signals: Vec<Signal>,
    /// Units of the file, if it states them.
    pub units: Option<Units>,
}

/// Lines of a file, each with its end, as far as the first so many bytes of each.
struct Reading<R> {
    reader: R,
    offset: u64,
    lines: usize,
    bytes: Vec<u8>,
}

impl<R: BufRead + Seek> Reading<R> {
    fn new(reader: R) -> Self {
        Self { reader, offset: 0, lines: 0, bytes: Vec::new() }
    }

    /// Go on at an offset, before which there are so many lines.
    fn leap(&mut self, offset: u64, lines: usize) -> io::Result<()> {
        self.reader.seek(SeekFrom::Start(offset))?;
        (self.offset, self.lines) = (offset, lines);
        Ok(())
    }

    /// The next line with its end; none at the end of the file.
    fn next(&mut self) -> io::Result<Option<&[u8]>> {
        self.bytes.clear();
        let mut limited = self.reader.by_ref().take(LONGEST_LINE);
        let read = limited.read_until(b'\n', &mut self.bytes)?;
        if read == 0 {
            return Ok(None);
        }
        self.offset += read as u64;
        self.lines += 1;
        Ok(Some(&self.bytes))
    }

    /// The next line of the dataset that a line opened.
    fn inside(&mut self, opening: usize) -> Result<&[u8], SignalError> {
        match self.next()? {
            Some(_) => Ok(&self.bytes),
            None => Err(UniversalFileError::Truncated { line: opening }.into()),
        }
    }

    /// Whether so many bytes stand here with the closing mark behind them; then they are leapt over.
    fn block(&mut self, length: u64) -> io::Result<bool> {
        let (offset, lines) = (self.offset, self.lines);
        self.leap(offset.saturating_add(length), lines)?;
        for _ in 0..2 {
            match self.next()? {
                Some(line) if is_mark(line) => return Ok(true),
                // Some systems end the line before the mark.
                Some(line) if line.trim_ascii().is_empty() => {}
                _ => break,
            }
        }
        self.leap(offset, lines)?;
        Ok(false)
    }
}

fn is_mark(line: &[u8]) -> bool {
    line.trim_ascii_end() == b"    -1"
}

impl Signals {
    /// The functions of a file.
    ///
    /// # Errors
    /// [`SignalError::Read`] if it cannot be read, [`SignalError::File`] with the line of what is wrong.
    pub fn find(reader: impl BufRead + Seek) -> Result<Self, SignalError> {
        let mut reading = Reading::new(reader);
        let mut file = UniversalFile { functions: Vec::new(), units: None };
        let (mut signals, mut empty) = (Vec::new(), true);
        while let Some(line) = reading.next()? {
            let blank = line.trim_ascii().is_empty();
            if !is_mark(line) {
                if blank {
                    continue;
                }
                let line = reading.lines;
                return Err(UniversalFileError::Outside { line }.into());
            }
            empty = false;
            signals.extend(dataset(&mut reading, &mut file)?);
        }
        if empty {
            return Err(UniversalFileError::NoDataset.into());
        }
        Ok(Self { signals, units: file.units })
    }
}

/// Read or skip the dataset of which the opening mark has been taken.
fn dataset<R: BufRead + Seek>(
    reading: &mut Reading<R>,
    file: &mut UniversalFile,
) -> Result<Option<Signal>, SignalError> {
    let opening = reading.lines;
    let name = reading.inside(opening)?.to_vec();
    let number = Lines::within(&name, opening, opening).record("number")?;
    let mut fields = number.fields();
    if fields.integer(6, "the number of the dataset")? != 58 {
        // Anything else is short: all of it at once.
        let mut bytes = [b"    -1\n", &name[..]].concat();
        loop {
            let line = reading.inside(opening)?;
            let last = is_mark(line);
            // What is skipped need not be kept.
            if bytes.len() < 1 << 16 || last {
                bytes.extend_from_slice(line);
            }
            if last {
                break;
            }
        }
        let mut lines = Lines::within(&bytes, opening - 1, opening);
        lines.open()?;
        super::read_dataset(&mut lines, file)?;
        return Ok(None);
    }
    let encoding = match fields.text(1) {
        "" => None,
        "b" | "B" => Some(Encoding::read(fields)?),
        letter => {
            return Err(UniversalFileError::UnknownForm { line: opening + 1, text: letter.to_owned() }.into());
        }
    };
    let mut head = Vec::new();
    for _ in 0..RECORDS {
        let line = reading.inside(opening)?;
        head.extend_from_slice(line);
        if is_mark(line) {
            break;
        }
    }
    let mut lines = Lines::within(&head, opening + 1, opening);
    let (function, form) = Function::read_head(&mut lines)?;
    let (offset, lines) = (reading.offset, reading.lines);
    let encoding = match encoding {
        None => {
            while !is_mark(reading.inside(opening)?) {}
            None
        }
        Some(encoding) => {
            let widths = encoding.leap(&form, |length| reading.block(length))?;
            Some((encoding, widths))
        }
    };
    Ok(Some(Signal { points: form.points, even: form.even(), function, form, encoding, offset, lines }))
}

impl Signal {
    /// The numbers of the signal as they stand in the file, one after the other: abscissa where it is uneven, real part,
    /// imaginary part where it is complex. Memory: a line.
    ///
    /// # Errors
    /// [`SignalError::Read`] if the file cannot be read; the iterator ends with the first error.
    pub fn values<R: BufRead + Seek>(&self, reader: R) -> Result<Values<'_, R>, SignalError> {
        let mut reading = Reading::new(reader);
        reading.leap(self.offset, self.lines)?;
        Ok(Values { signal: self, reading, held: 0, line: Vec::new().into_iter(), broken: false })
    }
}

/// Values that are read as they are asked for.
pub struct Values<'a, R> {
    signal: &'a Signal,
    reading: Reading<R>,
    /// Numbers taken from the file.
    held: usize,
    line: std::vec::IntoIter<f64>,
    broken: bool,
}

impl<R: BufRead + Seek> Values<'_, R> {
    fn take(&mut self) -> Result<f64, SignalError> {
        if let Some(value) = self.line.next() {
            return Ok(value);
        }
        let form = &self.signal.form;
        if let Some((encoding, widths)) = &self.signal.encoding {
            let mut bytes = [0; 8];
            let field = &mut bytes[..widths[self.held % widths.len()]];
            self.reading.reader.read_exact(field)?;
            self.held += 1;
            return Ok(encoding.finite(field, self.signal.lines + 1)?);
        }
        let widths = super::ascii::widths(form);
        let needed = (form.numbers() - self.held).min(widths.len());
        let opening = self.signal.function.line;
        let text = self.reading.inside(opening)?.to_vec();
        let number = self.reading.lines;
        if is_mark(&text) {
            return Err(UniversalFileError::TooFew {
                line: form.line,
                points: form.points,
                numbers: form.numbers(),
                held: self.held,
            }
            .into());
        }
        let line = Line::new(number, &text);
        let mut values = line.fields().numbers(widths)?;
        if values.len() < needed {
            return Err(UniversalFileError::ShortLine { line: number, needed, held: values.len() }.into());
        }
        self.held += needed;
        // The last line may be filled up with zeros.
        let more = values.drain(needed..).any(|value| value != 0.0);
        if more || self.held == form.numbers() && !is_mark(self.reading.inside(opening)?) {
            return Err(UniversalFileError::TooMany {
                line: number + usize::from(!more),
                points: form.points,
                numbers: form.numbers(),
            }
            .into());
        }
        self.line = values.into_iter();
        self.take()
    }
}

impl<R: BufRead + Seek> Iterator for Values<'_, R> {
    type Item = Result<f64, SignalError>;

    fn next(&mut self) -> Option<Self::Item> {
        let done = self.held == self.signal.form.numbers() && self.line.len() == 0;
        if done || self.broken {
            return None;
        }
        let value = self.take();
        self.broken = value.is_err();
        Some(value)
    }
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use super::super::read;
    use super::super::tests::{FIXTURES, binary, fixture};
    use super::*;

    /// What is streamed is what is read whole, whatever the form.
    #[test]
    fn values_are_those_of_the_file_read_whole() -> Result<(), SignalError> {
        let mut files: Vec<Vec<u8>> = FIXTURES.iter().map(|name| fixture(name)).collect();
        files.extend([2, 4, 5, 6].map(|kind| binary(kind, true, 2, 4, "\r\n")));
        for bytes in files {
            let whole = read(&bytes)?;
            let found = Signals::find(Cursor::new(&bytes))?;
            assert_eq!(found.units, whole.units);
            assert_eq!(found.signals.len(), whole.functions.len());
            for (signal, function) in found.signals.iter().zip(&whole.functions) {
                assert_eq!(signal.function.title, function.title);
                assert_eq!(signal.function.line, function.line);
                assert_eq!(signal.points, function.ordinate.len());
                let values: Result<Vec<f64>, _> = signal.values(Cursor::new(&bytes))?.collect();
                let (_, ordinate) = signal.form.points_of(&values?);
                assert_eq!(ordinate, function.ordinate);
            }
        }
        Ok(())
    }

    #[test]
    fn what_is_cut_is_refused() {
        let bytes = fixture("modulus_single_even.uff");
        let cut = &bytes[..bytes.len() - 200];
        let refusal = Signals::find(Cursor::new(cut)).unwrap_err().to_string();
        assert!(refusal.contains("cut short by the end"), "{refusal}");
        let bytes = binary(4, true, 1, 8, "");
        let refusal = Signals::find(Cursor::new(&bytes[..bytes.len() - 12]));
        assert!(refusal.is_err());
        assert!(Signals::find(Cursor::new(b"time;a\n1;2\n")).is_err());
    }
}
