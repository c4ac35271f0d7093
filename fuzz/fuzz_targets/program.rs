//! The built program on a file: whatever it holds, the program ends in time and with an exit status of its own, and
//! prints neither a control character nor, in a document, a number that is none.
#![no_main]

use std::path::Path;
use std::process::{Command, Output};

use libfuzzer_sys::fuzz_target;

/// Longest processor time of a run \[s\].
const LONGEST: u32 = 10;
const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");
/// Levels of a rail, for commands that need some beside the file.
const LEVELS: &[u8] = b"wavelength_mm,level_db\n100,4\n80,5\n63,6\n50,8\n40,7\n31.5,2\n25,-2\n";

/// Command lines, and the name that the file has there. `FOLDER` is where it lies.
const LINES: [(&str, &str); 8] = [
    ("point FOLDER/case.toml --wavelength 50mm --speed 90km/h --json", "case.toml"),
    (
        "map FOLDER/case.toml --set map.wavelength.points=9 --set map.speed.points=5 -o FOLDER/map",
        "case.toml",
    ),
    ("receptance FOLDER/case.toml --points 20 -o FOLDER/receptance", "case.toml"),
    ("roughness FOLDER/rail.csv -o FOLDER/roughness", "rail.csv"),
    ("diagnose cases/nominal.toml --roughness FOLDER/rail.csv -o FOLDER/diagnosis", "rail.csv"),
    (
        "forecast cases/nominal.toml --spectrum FOLDER/levels.csv --traffic FOLDER/traffic.toml -o FOLDER/forecast",
        "traffic.toml",
    ),
    ("compare cases/nominal.toml --with FOLDER/variant.toml -o FOLDER/compare", "variant.toml"),
    (
        "point cases/nominal.toml --wavelength 50mm --speed 90km/h --json --set track.model=measured \
         --set track.measurement.file=FOLDER/track.csv",
        "track.csv",
    ),
];

fuzz_target!(|bytes: &[u8]| {
    // The length of an input chooses its command line, so that any file is one.
    let (line, name) = LINES[bytes.len() % LINES.len()];
    riffel_fuzz::file("levels.csv", LEVELS);
    let path = riffel_fuzz::file(name, bytes);
    let Output { status, stdout, stderr } = run(line, path.parent().unwrap());
    let (document, notes) = (String::from_utf8_lossy(&stdout), String::from_utf8_lossy(&stderr));
    assert!(!notes.contains("panicked at"), "{line}: {notes}");
    assert!(matches!(status.code(), Some(0..=2)), "{line}: {status}, or longer than {LONGEST} s");
    for text in [&document, &notes] {
        let control = text.chars().find(|&c| c.is_control() && c != '\n');
        assert!(control.is_none(), "{line}: the control character {control:?}");
    }
    if status.success() && line.contains("--json") {
        assert!(!document.contains("NaN") && !document.contains(": null"), "{line}: {document}");
    }
});

fn run(line: &str, folder: &Path) -> Output {
    let line = line.replace("FOLDER", &folder.display().to_string());
    let limited = format!("ulimit -t {LONGEST}; exec target/release/riffel {line}");
    let mut command = Command::new("sh");
    command.args(["-c", &limited]).current_dir(ROOT).env("NO_COLOR", "1");
    command.output().expect("the program is built: cargo build --release")
}
