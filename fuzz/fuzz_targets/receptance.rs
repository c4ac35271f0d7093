//! Measured receptances: the file that a case names, as a universal file and as a table whose columns are those
//! of its first line.
#![no_main]

use libfuzzer_sys::fuzz_target;
use riffel_case::{Case, NOMINAL_CASE};

fuzz_target!(|bytes: &[u8]| {
    for name in ["track.uff", "track.csv"] {
        let path = riffel_fuzz::file(name, bytes);
        let columns = columns(bytes);
        for [second, third] in [["real", "imaginary"], ["modulus", "phase"]] {
            let mut overrides = vec![
                "track.model=\"measured\"".to_owned(),
                format!("track.measurement.file={:?}", path.display().to_string()),
            ];
            if let (true, Some(columns)) = (name.ends_with("csv"), &columns) {
                for (key, column) in ["frequency", second, third].iter().zip(columns) {
                    overrides.push(format!("track.measurement.{key}=\"{column}\""));
                }
            }
            riffel_fuzz::read(|| Case::parse("case.toml", NOMINAL_CASE, &overrides));
        }
    }
});

/// The first three names of the first line, if the case can quote them as they are.
fn columns(bytes: &[u8]) -> Option<[String; 3]> {
    let line = bytes.split(|&byte| byte == b'\n').next()?;
    let line = std::str::from_utf8(line).ok()?.trim_end();
    let plain = |name: &&str| !name.chars().any(|c| c.is_control() || "\"\\".contains(c));
    let mut names = line
        .split([',', ';', '\t'])
        .filter(plain)
        .map(|name| name.trim().to_owned());
    Some([names.next()?, names.next()?, names.next()?])
}
