//! What the files and folders of a store are called.

use jiff::civil::Date;

/// What a store says of itself: its mark.
pub(crate) const RECORD: &str = "network.json";
/// Digits of the SHA-256 of a survey in the name of its arrays.
const DIGITS: usize = 12;

/// The folder of the arrays of a survey, in that of its line.
pub(crate) fn arrays_name(date: Date, sha256: &str) -> String {
    format!("{date}-{}.zarr", sha256.get(..DIGITS).unwrap_or(sha256))
}

/// The day of arrays, if a folder has a name as [`arrays_name`] gives it.
pub(crate) fn day_of_arrays(name: &str) -> Option<Date> {
    let (day, digits) = name.strip_suffix(".zarr")?.rsplit_once('-')?;
    let is_own = digits.len() == DIGITS && digits.bytes().all(|digit| digit.is_ascii_hexdigit());
    day.parse().ok().filter(|_| is_own)
}

/// The file of the record of a survey, in the folder of its line.
pub(crate) fn record_name(date: Date) -> String {
    format!("{date}.json")
}

/// The folder of a line, in a name in which there is nothing that a file system could take amiss.
pub(crate) fn line_name(line: &str) -> String {
    let mut name = String::new();
    for byte in line.bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'_' => name.push(byte.into()),
            _ => name += &format!("%{byte:02X}"),
        }
    }
    name
}

/// The name of the array of a rail: its own where that is a plain word, which no coordinate has.
pub(crate) fn array_name(rail: &str, index: usize) -> String {
    let plain = rail.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
    let taken = ["place", "band", "band_from", "band_to"].contains(&rail);
    match plain && !taken && rail.len() <= 40 {
        true => rail.to_owned(),
        false => format!("rail_{}", index + 1),
    }
}
