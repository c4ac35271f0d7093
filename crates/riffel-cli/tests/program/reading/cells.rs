//! Cells of a rail in other ways than those of its neighbours, through the commands: what they tell is that of the plain cells, or they
//! refuse the file with line and cell. All ways of writing stand beside the readers.

use std::f64::consts::TAU;
use std::fs;

use crate::sandbox::Sandbox;

/// How the value of a row is written.
type Writing = fn(usize, f64) -> String;

const PLAIN: Writing = |_, value| format!("{value:.3}");
const READ: [Writing; 2] = [
    |_, value| format!("'{value:.3}").replace('-', "\u{2212}"),
    |_, value| {
        let rounded: f64 = format!("{value:.3}").parse().unwrap();
        format!("{rounded:e}\u{a0}")
    },
];
const REFUSED: [Writing; 2] = [
    |row, value| format!("{value:.3}{}", if row == 3 { "*" } else { "" }),
    |_, value| format!("\"{value:.3} µm\"").replace('.', ","),
];

/// A rail right that is far rougher than the left one, in cells of some writing, as a kind of table.
fn table(kind: &str, write: Writing) -> String {
    let rough = |row: usize| 20.0 * (TAU * row as f64 / 16.0 + 0.2).sin();
    let smooth = |row: usize| ((row * 7919 % 101) as f64 - 50.0) / 10.0;
    let rows = |head: &str, count: usize, row: &dyn Fn(usize) -> String| {
        let rows = (0..count).map(|at| row(at) + "\n");
        format!("{head}\n{}", rows.collect::<String>())
    };
    let bands = [200.0, 160.0, 125.0, 100.0, 80.0, 63.0, 50.0, 40.0, 31.5, 25.0, 20.0];
    match kind {
        "profile" => rows("x_m,left_um,right_um", 1200, &|row| {
            let (x, left) = (5e-3 * row as f64, smooth(row));
            format!("{x:.3},{left:.3},{}", write(row, rough(row)))
        }),
        "levels" => rows("wavelength_mm,left_db,right_db", bands.len(), &|row| {
            let left = -12.0 - row as f64;
            format!("{},{left},{}", bands[row], write(row, 0.5 * rough(row)))
        }),
        "run" => rows("time_s,acceleration_left_m_per_s2,acceleration_right_m_per_s2,speed_km_per_h", 8000, &|row| {
            let (time, left) = (5e-4 * row as f64, smooth(row));
            format!("{time:.4},{left:.3},{},72.0", write(row, 4.0 * rough(row)))
        }),
        "blocks" => rows("rail,from_m,to_m,rms_30_to_100_mm_um", 60, &|row| {
            let rms = write(row, 20.0 + row as f64);
            format!("right,{},{},{rms}", 10 * row, 10 * row + 10)
        }),
        _ => rows("passages,wavelength_mm,level_db,standard_error_db", 16, &|row| {
            let (passages, level) = (1_000_000 * (row / 8), 0.4 * rough(row % 8));
            let grown = level + 3.0 * (row / 8) as f64;
            let level = write(row, grown);
            format!("{passages},{},{level},0.5", bands[row % 8])
        }),
    }
}

/// Kinds of tables, with the commands that read them.
const COMMANDS: [(&str, &str); 18] = [
    ("profile", "roughness rail.csv --json"),
    ("levels", "roughness rail.csv --json"),
    ("profile", "diagnose cases/nominal.toml --roughness rail.csv --speed \"100 km/h\" --json"),
    ("levels", "diagnose cases/nominal.toml --roughness rail.csv --speed \"100 km/h\" --json"),
    ("profile", "noise cases/bhaskar-track.toml --roughness rail.csv --speed \"100 km/h\" --json"),
    ("levels", "noise cases/bhaskar-track.toml --roughness rail.csv --speed \"100 km/h\" --json"),
    ("levels", "noise cases/bhaskar-track.toml --roughness plain.csv --before rail.csv --speed \"100 km/h\" --json"),
    ("profile", "forecast cases/nominal.toml --traffic cases/traffic.toml --spectrum rail.csv --json"),
    ("levels", "forecast cases/nominal.toml --traffic cases/traffic.toml --spectrum rail.csv --json"),
    ("levels", "forecast cases/nominal.toml --traffic cases/traffic.toml --ground rail.csv --json"),
    (
        "profile",
        "forecast cases/nominal.toml --traffic cases/traffic.toml --spectrum plain.csv --earlier rail.csv --dates 2025-06-01,2026-06-01 --json",
    ),
    (
        "levels",
        "compare cases/nominal.toml --traffic cases/traffic.toml --with cases/soft-pads.toml --spectrum rail.csv --json",
    ),
    (
        "profile",
        "compare cases/nominal.toml --traffic cases/traffic.toml --with cases/soft-pads.toml --spectrum rail.csv --json",
    ),
    ("profile", "simulate cases/nominal.toml --profile rail.csv --rail right --speed \"20 m/s\" --json"),
    (
        "profile",
        "report cases/nominal.toml --set map.wavelength.points=21 --set map.speed.points=5 --roughness rail.csv --speed \"100 km/h\" -o report.html",
    ),
    ("run", "axlebox rail.csv --case cases/bhaskar-track.toml --json"),
    ("blocks", "network ingest store rail.csv --line A --date 2026-01-01 --json"),
    ("dated levels", "calibrate set/case.toml --with rail.csv --traffic set/traffic.toml --dry-run --json"),
];

// Long: starts the program a hundred times.
#[test]
fn no_command_loses_a_rail_by_its_cells() {
    let sandbox = Sandbox::new();
    fs::create_dir(sandbox.path("set")).unwrap();
    let set = crate::sandbox::root().join("validation/calibration/b-three-dates");
    for name in ["case.toml", "traffic.toml"] {
        fs::copy(set.join(name), sandbox.path("set").join(name)).unwrap();
    }
    fs::write(sandbox.path("plain.csv"), table("profile", PLAIN)).unwrap();
    let told = |kind: &str, command: &str, write: Writing| {
        let _ = fs::remove_dir_all(sandbox.path("store"));
        let _ = fs::remove_file(sandbox.path("report.html"));
        fs::write(sandbox.path("rail.csv"), table(kind, write)).unwrap();
        let outcome = sandbox.riffel(command);
        let found = match kind {
            "blocks" if outcome.status == Some(0) => sandbox.riffel("network worst store --json").text,
            _ => outcome.text.clone(),
        };
        (outcome.status, found, outcome.sentence())
    };
    for (kind, command) in COMMANDS {
        let (status, plain, sentence) = told(kind, command, PLAIN);
        assert_eq!(status, Some(0), "{command}: {sentence}");
        // A survey is a table that Riffel writes, and is read as that alone.
        let read = if kind == "blocks" { &READ[..0] } else { &READ };
        for (way, &write) in read.iter().enumerate() {
            let (status, found, sentence) = told(kind, command, write);
            assert_eq!(status, Some(0), "{kind}, {command}, way {way}: {sentence}");
            assert!(found == plain, "{kind}, {command}, way {way}");
        }
        for (way, write) in REFUSED.into_iter().enumerate() {
            let (status, _, sentence) = told(kind, command, write);
            let parts = [["line 5", "*\""], ["line 2", "µm\""]][way];
            let is_named = parts.iter().all(|part| sentence.contains(part));
            assert!(status == Some(2) && is_named, "{kind}, {command}, way {way}: {sentence}");
            assert!(!sandbox.path("report.html").exists() && !sandbox.path("store/surveys").exists());
        }
    }
}
