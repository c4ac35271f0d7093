//! Readers of all kinds of files on inputs that are cut, doubled, swapped and sprinkled with what confuses readers.

use std::fmt::Debug;
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use riffel_answers::report::Site;
use riffel_case::traffic::Traffic;
use riffel_case::{Case, CurvingCase, Variant};
use riffel_keys::CaseError;
use riffel_rail::{
    AxleBoxFile, AxleBoxLayout, AxleBoxReading, Layout, LimitTable, LinePlace, ProfileReading, ReaderFormat,
    RecipeFile, RoughnessFile, TransferTable, WheelModesTable, read_decay_rates, read_profile,
};

use crate::sandbox::root;

/// Longest that a reader may take on one input of some ten thousand bytes; a machine with much to do is ten times slower.
const LONGEST: Duration = Duration::from_secs(10);
/// Bytes of a file that are mutated.
const MOST: usize = 60_000;
/// Inputs over all readers, as `RIFFEL_MUTATIONS` says or else so many.
const USUAL: usize = 1500;

/// Numbers that look random (Steele, Lea & Flood 2014, splitmix64).
struct Numbers(u64);

impl Numbers {
    fn next(&mut self, below: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut word = self.0;
        word = (word ^ (word >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        word = (word ^ (word >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((word ^ (word >> 31)) % below.max(1) as u64) as usize
    }
}

/// What stands in files where nobody expects it.
const PIECES: [&str; 40] = [
    "NaN",
    "nan",
    "inf",
    "-inf",
    "1e400",
    "-1e308",
    "1e-320",
    "0",
    "-0",
    "-1",
    "9999999999999999999999",
    "1,5",
    "1.000",
    "0,45-",
    "(0.45)",
    "26+100",
    "\"",
    "'",
    ",",
    ";",
    "\t",
    "\n",
    "\r",
    "\r\n",
    " ",
    "#",
    "%",
    "=",
    "[",
    "]",
    "{",
    "}",
    "µm",
    "\u{feff}",
    "\0",
    "\u{1b}[31m",
    "2026-01-31",
    "31.02.2026",
    "------",
    "    -1\n    58\n",
];

/// A file with one to three changes.
fn mutated(bytes: &[u8], numbers: &mut Numbers) -> Vec<u8> {
    let mut bytes = bytes[..bytes.len().min(MOST)].to_vec();
    for _ in 0..=numbers.next(3) {
        let length = bytes.len();
        let at = numbers.next(length + 1);
        let until = (at + numbers.next(40)).min(length);
        match numbers.next(7) {
            0 => bytes.truncate(at),
            1 => drop(bytes.drain(at..until)),
            2 => {
                let again = bytes[at..until].to_vec();
                drop(bytes.splice(at..at, again));
            }
            3 if at < length => bytes[at] ^= 1 << numbers.next(8),
            4 => {
                let mut lines: Vec<Vec<u8>> = bytes.split(|byte| *byte == b'\n').map(<[u8]>::to_vec).collect();
                let (one, other) = (numbers.next(lines.len()), numbers.next(lines.len()));
                lines.swap(one, other);
                bytes = lines.join(&b'\n');
            }
            5 => {
                let mut lines: Vec<Vec<u8>> = bytes.split(|byte| *byte == b'\n').map(<[u8]>::to_vec).collect();
                lines.insert(numbers.next(lines.len()), lines[numbers.next(lines.len())].clone());
                bytes = lines.join(&b'\n');
            }
            _ => {
                let piece = PIECES[numbers.next(PIECES.len())].bytes();
                drop(bytes.splice(at..until.min(at + numbers.next(8)), piece));
            }
        }
    }
    bytes
}

/// What a reader makes of a file, as text in which no number is none.
type Reader = fn(&Path, &str) -> Result<String, CaseError>;

fn shown(value: &impl Debug) -> String {
    format!("{value:?}")
}

/// A value that shows nothing.
fn read<T>(outcome: Result<T, CaseError>) -> Result<String, CaseError> {
    outcome.map(|_| String::new())
}

fn axle_box(path: &Path, _: &str) -> Result<String, CaseError> {
    let is_wave = path.extension().is_some_and(|ending| ending == "wav");
    let channels = ["acceleration_left_g=50", "acceleration_right_g=50"].map(str::to_owned);
    let layout = match is_wave {
        true => AxleBoxLayout { channels: channels.into(), speed: Some(20.0), ..AxleBoxLayout::default() },
        false => AxleBoxLayout::default(),
    };
    let file = AxleBoxFile::open(path, &layout)?;
    let mut sum = 0.0;
    let mut add = |reading: AxleBoxReading<'_>| {
        if let AxleBoxReading::Sample(accelerations, position) = reading {
            sum += accelerations.iter().sum::<f64>() + position;
        }
        Ok(())
    };
    file.read(None, &mut add, &|_| ())?;
    Ok(shown(&sum))
}

fn receptance(path: &Path, _: &str) -> Result<String, CaseError> {
    let overrides =
        ["track.model=\"measured\"".to_owned(), format!("track.measurement.file={:?}", path.display().to_string())];
    let case = Case::parse("case.toml", riffel_case::NOMINAL_CASE, &overrides)?;
    let rate = case.feedback.at(case.wavelength.min(), case.speed.min());
    Ok(shown(&rate.normal_force()))
}

fn case(_: &Path, text: &str) -> Result<String, CaseError> {
    let case = Case::parse_sealed("case.toml", text)?;
    Ok(shown(&case.feedback.at(case.wavelength.min(), case.speed.min()).normal_force()))
}

fn rail(path: &Path, _: &str) -> Result<String, CaseError> {
    RoughnessFile::read(path, &Layout::default(), &|_| ()).map(|file| shown(&file))
}

/// A folder and the end of names.
type Files = (&'static str, &'static str);

/// Each reader with its files, by folder and the end of their names.
const READERS: [(&str, Reader, &[Files]); 18] = [
    ("case", case, &[("cases", ".toml"), ("presets/tracks", ".toml")]),
    ("curving", |_, text| read(CurvingCase::parse("curve.toml", text, &[])), &[("cases", "curve.toml")]),
    ("traffic", |_, text| read(Traffic::parse("traffic.toml", text)), &[("cases", "traffic.toml")]),
    (
        "changes",
        |_, text| read(Variant::parse("changes.toml", text)),
        &[("cases", "soft-pads.toml"), ("cases", "more-cant.toml")],
    ),
    (
        "study",
        |_, text| read(riffel_study::Plan::parse("study.toml", text, &root().join("cases/nominal.toml"))),
        &[("cases", "study.toml"), ("cases", "sensitivity.toml")],
    ),
    (
        "calibration",
        |path, _| read(riffel_calibrate::Plan::read(path)),
        &[("validation/calibration/b-three-dates", "plan.toml")],
    ),
    ("site", |_, text| read(Site::parse("site.toml", text)), &[]),
    ("limit", |_, text| read(LimitTable::parse("limit.toml", text)), &[("limits", ".toml")]),
    ("recipe", |_, text| read(RecipeFile::parse("recipe.toml", text)), &[("cases", "roughness-recipe.toml")]),
    ("format", |_, text| read(ReaderFormat::parse("format.toml", text)), &[]),
    (
        "rail",
        rail,
        &[
            ("validation/reference/sbb-track-noise", ".csv"),
            ("validation/calibration/b-three-dates", ".csv"),
            ("crates/riffel-web/example", ".csv"),
        ],
    ),
    (
        "decay",
        |path, _| read_decay_rates(path).map(|rates| shown(&rates)),
        &[("validation/reference/decay-rate", ".csv"), ("validation/calibration/a-hammer-and-decay", ".csv")],
    ),
    (
        "response",
        receptance,
        &[
            ("crates/riffel-rail/tests/universal-files", ""),
            ("crates/riffel-rail/tests/measured-tables", ".csv"),
            ("validation/reference/receptance", ".csv"),
        ],
    ),
    (
        "profile",
        |path, _| read(read_profile(path, ProfileReading::default())),
        &[("cases", "worn-rail.csv"), ("cases", "worn-wheel.csv"), ("crates/riffel-rail/tests/profiles", "")],
    ),
    ("axle box", axle_box, &[]),
    (
        "places",
        |path, _| {
            LinePlace::read(path).map(|places| {
                let ends = places.iter().map(|place| [place.from, place.to]);
                shown(&ends.collect::<Vec<_>>())
            })
        },
        &[],
    ),
    (
        "transfer",
        |_, text| read(TransferTable::parse("transfer.toml", text)),
        &[("crates/riffel-rail/transfers", ".toml")],
    ),
    (
        "wheel modes",
        |_, text| read(WheelModesTable::parse("modes.toml", text)),
        &[("crates/riffel-rail/wheel-modes", ".toml")],
    ),
];

/// Files that no folder of the repository has.
fn made_up(name: &str) -> Vec<(String, Vec<u8>)> {
    let rows = |head: &str, row: &dyn Fn(f64) -> String| {
        let rows: String = (0..300).map(|at| row(f64::from(at))).collect();
        format!("{head}{rows}").into_bytes()
    };
    let noise = |at: f64| (at * 7919.0) % 41.0 - 20.0;
    match name {
        "site" => vec![("site.toml".to_owned(), b"[site]\nline = \"U2\"\ntitle = \"T\"\n[cost]\ncurrency = \"EUR\"\ngrinding_shift = 15000\nlength_a_shift = \"800 m\"\n".to_vec())],
        "format" => vec![("format.toml".to_owned(), b"delimiter = \"semicolon\"\ndecimal = \"comma\"\nheader_lines = 3\nposition = { column = 1, unit = \"km\" }\nrails = [{ column = 3, unit = \"mm\", name = \"left\" }, { column = 4, unit = \"um\" }]\n".to_vec())],
        "rail" => vec![
            ("profile.csv".to_owned(), rows("position_m,left_um,right_um\n", &|at| format!("{},{},{}\n", 1e-3 * at, noise(at), noise(at + 7.0)))),
            ("levels.csv".to_owned(), rows("date;rail;wavelength_m;level_db\n", &|at| format!("2026-0{}-31;left;{};{}\n", 1 + at as i32 % 9, 0.02 + 1e-3 * at, noise(at)))),
        ],
        "axle box" => {
            let mut wave = b"RIFF\0\0\0\0WAVEfmt \x10\0\0\0\x01\0\x02\0\x40\x1f\0\0\0\x7d\0\0\x04\0\x10\0data\xb0\x04\0\0".to_vec();
            wave.extend((0..1200_u32).map(|at| (at * 7919 % 251) as u8));
            vec![
                ("run.csv".to_owned(), rows("time_s,acceleration_left_m_per_s2,speed_km_per_h\n", &|at| format!("{},{},72\n", 1e-3 * at, noise(at)))),
                ("run.wav".to_owned(), wave),
            ]
        }
        "places" => vec![("line.csv".to_owned(), rows("position_m;kind;name\n", &|at| format!("{};weld;W {at}\n", 12.0 * at)))],
        _ => Vec::new(),
    }
}

/// The files of a folder by their names.
fn all_of(folder: &str) -> Vec<(String, Vec<u8>)> {
    let entries = fs::read_dir(root().join(folder)).unwrap();
    let paths = entries.map(|entry| entry.unwrap().path());
    let mut paths: Vec<PathBuf> = paths.filter(|path| path.is_file()).collect();
    paths.sort();
    let named = paths.iter().map(|path| {
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        (name, fs::read(path).unwrap())
    });
    named.collect()
}

/// What is mutated for a reader.
fn files(name: &str, folders: &[(&str, &str)]) -> Vec<(String, Vec<u8>)> {
    let of_folders = folders.iter().flat_map(|(folder, end)| {
        let own = all_of(folder).into_iter();
        own.filter(move |(name, _)| name.ends_with(end))
    });
    let files: Vec<_> = made_up(name).into_iter().chain(of_folders).collect();
    assert!(!files.is_empty(), "{name}");
    files
}

/// Every input leads to a value without NaN or to an error that a terminal can show, soon and without a panic.
// Long: reads 1500 mutated files, whole cases and records among them.
#[test]
fn no_mutated_file_breaks_a_reader() {
    let folder = tempfile::tempdir().unwrap();
    let count = std::env::var("RIFFEL_MUTATIONS").ok().and_then(|count| count.parse().ok());
    let each: usize = count.unwrap_or(USUAL).div_ceil(READERS.len());
    let mut faults = Vec::new();
    for (reader, (name, reads, folders)) in READERS.into_iter().enumerate() {
        let files = files(name, folders);
        // A plan finds its case and its data beside it.
        for (file, bytes) in folders.iter().flat_map(|(place, _)| all_of(place)) {
            fs::write(folder.path().join(file), bytes).unwrap();
        }
        let (mut taken, mut slowest) = (0, Duration::ZERO);
        for input in 0..each {
            let mut numbers = Numbers((reader * 1_000_003 + input) as u64);
            let (file, bytes) = &files[input % files.len()];
            let bytes = mutated(bytes, &mut numbers);
            let path = folder.path().join(file);
            fs::write(&path, &bytes).unwrap();
            let text = String::from_utf8_lossy(&bytes);
            let begun = Instant::now();
            let outcome = catch_unwind(AssertUnwindSafe(|| reads(&path, &text)));
            slowest = slowest.max(begun.elapsed());
            let fault = match outcome {
                Err(_) => Some("panics".to_owned()),
                Ok(Ok(value)) => {
                    taken += 1;
                    let none = value.contains("NaN") || value.contains("inf");
                    none.then(|| format!("has no number in {}", &value[..value.len().min(300)]))
                }
                Ok(Err(error)) => {
                    let words = error.to_string();
                    let control = words.chars().any(|c| c.is_control() && c != '\n');
                    (control || words.is_empty() || words.len() > 4096).then(|| format!("says {words:?}"))
                }
            };
            let fault = fault.or_else(|| (begun.elapsed() > LONGEST).then(|| format!("takes {:?}", begun.elapsed())));
            faults.extend(fault.map(|fault| format!("{name} {file} {input}: {fault}")));
        }
        println!("{name}: {each} inputs of {} files, {taken} taken, slowest {slowest:?}", files.len());
        // Changes that all are refused at the first line test nothing behind it.
        faults.extend((taken == 0).then(|| format!("{name}: none is taken")));
    }
    assert!(faults.is_empty(), "{} of {}:\n{}", faults.len(), each * READERS.len(), faults.join("\n"));
}
