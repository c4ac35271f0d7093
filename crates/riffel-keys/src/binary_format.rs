//! Formats of data that are no text, by their first bytes.

use crate::Words;

/// A format, and what reads it.
#[derive(Debug, PartialEq, Eq)]
pub struct BinaryFormat {
    /// First bytes of every file.
    signature: &'static [u8],
    /// What it is called.
    name: &'static str,
    /// What reads it, to write its columns as text.
    reader: &'static str,
}

const FORMATS: [BinaryFormat; 12] = [
    of(b"\x89HDF\r\n\x1a\n", "HDF5, as MATLAB writes from 7.3 on", "h5py in Python or load in MATLAB"),
    of(b"MATLAB 5.0 MAT-file", "a MAT-file", "scipy.io.loadmat in Python or load in MATLAB"),
    of(b"PK\x03\x04", "a ZIP archive, as spreadsheets in .xlsx and .ods are", "the spreadsheet or unzip"),
    of(b"\xd0\xcf\x11\xe0", "an old file of Office", "the spreadsheet"),
    of(b"PAR1", "Parquet", "pandas.read_parquet in Python"),
    of(b"ARROW1", "Feather", "pandas.read_feather in Python"),
    of(b"TDSm", "TDMS, as LabVIEW writes", "npTDMS in Python"),
    of(b"\x93NUMPY", "an array of NumPy", "numpy.load in Python"),
    of(b"\x1f\x8b", "compressed by gzip", "gunzip"),
    of(b"CDF\x01", "netCDF", "xarray.open_dataset in Python"),
    of(b"CDF\x02", "netCDF", "xarray.open_dataset in Python"),
    of(b"SQLite format 3\0", "a database of SQLite", "sqlite3"),
];

const fn of(signature: &'static [u8], name: &'static str, reader: &'static str) -> BinaryFormat {
    BinaryFormat { signature, name, reader }
}

impl BinaryFormat {
    /// That of a file which begins with some bytes; none of what is not known here.
    pub fn of(bytes: &[u8]) -> Option<&'static Self> {
        FORMATS.iter().find(|format| bytes.starts_with(format.signature))
    }

    /// What it is called.
    pub fn name(&self) -> Words {
        Words::by_english("Format", self.name)
    }

    /// What reads it.
    pub fn reader(&self) -> Words {
        Words::by_english("Format", self.reader)
    }

    /// Whether no text begins so.
    pub(crate) fn is_certain(&self) -> bool {
        let is_text = |byte: &u8| (b' '..=b'~').contains(byte);
        !self.signature.iter().all(is_text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text_file::{Encoding, decode};

    /// Each format is named with what reads it, whether its first bytes could begin a text or not; a text that begins like one is a text.
    #[test]
    fn formats_are_named() {
        for format in &FORMATS {
            let bytes = [format.signature, &[0; 100]].concat();
            let told = Encoding::of(&bytes).unwrap_err().to_string();
            assert!(told.contains(format.name) && told.contains(format.reader), "{told}");
            assert_eq!(decode(bytes).unwrap_err().to_string(), told);
        }
        assert!(Encoding::of(b"PAR1,PAR2\n1,2\n").is_ok());
        let other = Encoding::of(b"ab\0\0\0cd").unwrap_err().to_string();
        assert!(other.starts_with("the file is binary: byte 3"), "{other}");
    }
}
