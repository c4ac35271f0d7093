//! The text of a survey on its way into the reader of its table.

use std::io::{self, Read};

use sha2::{Digest, Sha256};

/// Longest line \[bytes\].
const LONGEST_LINE: usize = 1 << 16;

/// Bytes as they are read, with their sum, and lines within bounds: the reader of tables holds a row, however long it is.
pub(crate) struct SurveyText<R> {
    from: R,
    hash: Sha256,
    /// Bytes of the present line, and whether a quotation mark is open in it.
    line: usize,
    is_quoted: bool,
    number: usize,
}

impl<R> SurveyText<R> {
    pub(crate) fn new(from: R) -> Self {
        Self { from, hash: Sha256::new(), line: 0, is_quoted: false, number: 1 }
    }

    /// SHA-256 of all that was read.
    pub(crate) fn sha256(self) -> String {
        let bytes = self.hash.finalize();
        bytes.iter().map(|byte| format!("{byte:02x}")).collect()
    }

    fn refuse(&self, what: &str) -> io::Error {
        io::Error::new(io::ErrorKind::InvalidData, format!("line {} {what}", self.number))
    }
}

impl<R: Read> Read for SurveyText<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let read = self.from.read(buffer)?;
        for byte in &buffer[..read] {
            self.line += 1;
            match byte {
                b'\n' | b'\r' if self.is_quoted => {
                    return Err(self.refuse("has a quotation mark that is not closed in it"));
                }
                b'\n' => (self.line, self.number) = (0, self.number + 1),
                b'"' => self.is_quoted = !self.is_quoted,
                _ => {}
            }
            if self.line > LONGEST_LINE {
                return Err(self.refuse("is longer than 65536 bytes"));
            }
        }
        self.hash.update(&buffer[..read]);
        Ok(read)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(bytes: &[u8]) -> Result<String, String> {
        let mut text = SurveyText::new(bytes);
        let done = io::copy(&mut text, &mut io::sink());
        done.map(|_| text.sha256()).map_err(|error| error.to_string())
    }

    #[test]
    fn lines_have_bounds_and_bytes_a_sum() {
        // The test vector of FIPS 180-2.
        let sum = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
        assert_eq!(read(b"abc").unwrap(), sum);
        let mut long = b"a,b\n".to_vec();
        long.resize(70_000, b'1');
        assert_eq!(read(&long).unwrap_err(), "line 2 is longer than 65536 bytes");
        assert!(read(b"a,\"b\nc\"\n").unwrap_err().contains("line 1 has a quotation mark"));
        assert!(read(b"a,\"b\"\r\n1,2\r\n").is_ok());
    }
}
