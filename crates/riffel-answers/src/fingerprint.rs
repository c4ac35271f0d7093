//! SHA-256 of a file.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use riffel_keys::question;
use riffel_keys::text_file::{LARGEST_KEYS, read_bounded};
use sha2::{Digest, Sha256};

/// SHA-256 of a file, or of a document in a question as TOML, in hexadecimal digits. A profile may be larger than all else that is in
/// memory: it is read in parts.
///
/// # Errors
/// That of reading it.
pub fn fingerprint(path: &Path) -> io::Result<String> {
    let mut file: Box<dyn Read> = match question::holds(path) {
        true => Box::new(io::Cursor::new(read_bounded(path, "file", LARGEST_KEYS).map_err(io::Error::other)?)),
        false => Box::new(File::open(path)?),
    };
    let mut hash = Sha256::new();
    let mut part = vec![0; 1 << 20];
    loop {
        match file.read(&mut part) {
            Ok(0) => break,
            Ok(length) => hash.update(&part[..length]),
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
    let digits = hash.finalize();
    Ok(digits.iter().map(|byte| format!("{byte:02x}")).collect())
}
