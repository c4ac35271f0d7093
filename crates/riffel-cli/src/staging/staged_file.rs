//! A file as it is written, with what spreadsheets would run made harmless.

use std::fs::File;
use std::io::{self, BufWriter, Write};

/// A file of results. In a table, `.csv`, a cell of text that begins as a formula does gets an apostrophe in front, by which
/// spreadsheets take it for text: names come from files of others, and `=cmd…` in a cell is a command when the table is opened.
/// Numbers stay as they are.
pub(crate) struct StagedFile {
    file: BufWriter<File>,
    table: Option<Cells>,
}

/// Where in a table the writing stands.
#[derive(Default)]
struct Cells {
    /// The cell so far, with its quotation marks.
    cell: Vec<u8>,
    is_quoted: bool,
}

impl StagedFile {
    pub(super) fn new(file: File, name: &str) -> Self {
        Self { file: BufWriter::new(file), table: name.ends_with(".csv").then(Cells::default) }
    }

    /// Write what is held.
    pub(super) fn finish(mut self) -> io::Result<()> {
        if let Some(cells) = &mut self.table {
            cells.close(&mut self.file)?;
        }
        self.file.flush()
    }
}

impl Write for StagedFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.table {
            None => self.file.write(bytes),
            Some(cells) => {
                for byte in bytes {
                    cells.take(*byte, &mut self.file)?;
                }
                Ok(bytes.len())
            }
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

impl Cells {
    fn take(&mut self, byte: u8, to: &mut impl Write) -> io::Result<()> {
        if byte == b'"' {
            self.is_quoted = !self.is_quoted;
        }
        if !self.is_quoted && matches!(byte, b',' | b'\n' | b'\r') {
            self.close(to)?;
            return to.write_all(&[byte]);
        }
        self.cell.push(byte);
        Ok(())
    }

    fn close(&mut self, to: &mut impl Write) -> io::Result<()> {
        let quote = usize::from(self.cell.first() == Some(&b'"'));
        let (mark, content) = self.cell.split_at(quote);
        to.write_all(mark)?;
        if is_formula(content) {
            to.write_all(b"'")?;
        }
        to.write_all(content)?;
        self.cell.clear();
        Ok(())
    }
}

/// Whether a spreadsheet would compute a cell: by its first sign, unless it is a number or one sign alone.
fn is_formula(content: &[u8]) -> bool {
    let begins = matches!(content.first(), Some(b'=' | b'+' | b'-' | b'@' | b'\t' | b'\r'));
    let text = std::str::from_utf8(content).unwrap_or_default();
    begins && content.len() > 1 && text.trim_end_matches('"').parse::<f64>().is_err()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(table: &str) -> String {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("table.csv");
        let mut file = StagedFile::new(File::create(&path).unwrap(), "table.csv");
        // In pieces, as they come out of a buffer.
        for piece in table.as_bytes().chunks(3) {
            file.write_all(piece).unwrap();
        }
        file.finish().unwrap();
        std::fs::read_to_string(path).unwrap()
    }

    #[test]
    fn formulas_become_text_and_numbers_stay() {
        let table = "rail,level\n=cmd|' /C calc'!A0,-1.5e-3\n\"=SUM(1,2)\",+2\n\"+49,1\",-\n@a,-x\nleft = a,-inf\n\"say \"\"=a\"\"\",3";
        let harmless = "rail,level\n'=cmd|' /C calc'!A0,-1.5e-3\n\"'=SUM(1,2)\",+2\n\"'+49,1\",-\n'@a,'-x\nleft = a,-inf\n\"say \"\"=a\"\"\",3";
        assert_eq!(written(table), harmless);
    }
}
