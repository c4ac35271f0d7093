//! Standard input, which is read once.

use std::io::{self, Read};
use std::sync::{Mutex, PoisonError};

/// Largest file of frequency responses \[bytes\], and of what stands on standard input.
pub const LARGEST_RESPONSES: u64 = 256 << 20;

/// What stands on standard input, up to so many bytes: the same as often as it is asked for.
pub(crate) fn standard_input(most: u64) -> io::Result<Vec<u8>> {
    static READ: Mutex<Option<Vec<u8>>> = Mutex::new(None);
    let mut read = READ.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(bytes) = &*read {
        return Ok(bytes.clone());
    }
    let bytes = read_to(io::stdin().lock(), most)?;
    *read = Some(bytes.clone());
    Ok(bytes)
}

/// Up to so many bytes.
pub(crate) fn read_to(from: impl Read, most: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    from.take(most).read_to_end(&mut bytes)?;
    Ok(bytes)
}
