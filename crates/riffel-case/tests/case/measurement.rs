//! Measured receptances.

use std::fs;
use std::path::Path;

use riffel::Complex64;
use riffel_case::{Case, NOMINAL_CASE};
use riffel_keys::CaseError;
use tempfile::TempDir;

/// A case with the file as its track, in a folder of its own; the window of the map lies within
/// 50–2000 Hz.
fn case(name: &str, bytes: &[u8], keys: &str) -> Result<Case, CaseError> {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join(name), bytes).unwrap();
    let text = NOMINAL_CASE.replace("model = \"free-beam\"", "model = \"measured\"")
        + &format!("\n[track.measurement]\nfile = \"{name}\"\n{keys}\n");
    let path = folder.path().join("case.toml");
    fs::write(&path, text).unwrap();
    let overrides = ["map.speed.max=30", "map.speed.min=8"].map(str::to_owned);
    Case::read(&path, &overrides)
}

const CARTESIAN: &str = "real = \"re\"\nimaginary = \"im\"";

/// H = 1e-8/(1 + if/100) at 40 frequencies from 50 to 2500 Hz, times a factor.
fn table(header: &str, row: impl Fn(f64, Complex64) -> String) -> String {
    let mut text = format!("{header}\n");
    for step in 0..40 {
        let frequency = 50.0 * 50f64.powf(f64::from(step) / 39.0);
        let h = 1e-8 / Complex64::new(1.0, frequency / 100.0);
        text.push_str(&row(frequency, h));
        text.push('\n');
    }
    text
}

fn cartesian() -> String {
    table("frequency_hz,re,im", |f, h| format!("{f},{:e},{:e}", h.re, h.im))
}

fn check(case: &Case) {
    assert!(case.remarks.iter().all(|remark| !remark.to_string().contains("energy")));
    case.check_window().unwrap();
    let f = 50.0 * 50f64.powf(20.0 / 39.0);
    let h = case.track.receptance.receptance(std::f64::consts::TAU * f, 0.0);
    let expected = 1e-8 / Complex64::new(1.0, f / 100.0);
    assert!((h - expected).norm() < 1e-9 * expected.norm(), "{h} {expected}");
}

#[test]
fn reads_a_table() {
    check(&case("rail.csv", cartesian().as_bytes(), CARTESIAN).unwrap());
}

/// Semicolons, decimal commas, kilohertz, a comment, mobility in other units, modulus and phase.
#[test]
fn reads_a_table_as_instruments_write_it() {
    let text = "# exported\r\n".to_owned()
        + &table("f;mod;phase", |f, h| {
            let mobility = h * Complex64::new(0.0, std::f64::consts::TAU * f);
            // mm/s per kN: 1e-6 m/s per N.
            format!("{};{:e};{}", f / 1e3, 1e6 * mobility.norm(), mobility.arg().to_degrees()).replace('.', ",")
        });
    let keys = "quantity = \"mobility\"\nunit = \"mm/s/kN\"\nfrequency = \"f\"\nfrequency_unit = \"kHz\"\n\
                modulus = \"mod\"\nphase = \"phase\"";
    check(&case("rail.csv", text.as_bytes(), keys).unwrap());
}

/// Responses with the wrong signs are refused by their name, whatever keys are set, and turned by the keys that the refusal names.
#[test]
fn responses_with_the_wrong_signs_are_refused_and_turned() {
    let text = |signs: [f64; 2]| {
        table("frequency_hz,re,im", |f, h| format!("{f},{:e},{:e}", signs[0] * h.re, signs[1] * h.im))
    };
    let active = "gives energy away (Im H > 0) at 40 of 40 frequencies, and";
    for (signs, says, keys) in [
        ([1.0, 1.0], "", [false, false]),
        ([1.0, -1.0], "the sign of its real part is right: it is conjugated", [true, false]),
        ([-1.0, -1.0], "it is turned in sign", [false, true]),
        ([-1.0, 1.0], "it is conjugated, as with exp(−iωt), and turned in sign", [true, true]),
    ] {
        for set in [[false, false], [true, false], [false, true], [true, true]] {
            let of = |keys: [bool; 2]| format!("conjugate = {}\nnegate = {}", keys[0], keys[1]);
            let read = case("rail.csv", text(signs).as_bytes(), &format!("{CARTESIAN}\n{}", of(set)));
            if set == keys {
                check(&read.unwrap());
                continue;
            }
            let refusal = read.err().unwrap().to_string();
            let key = |name: &str, value: bool| format!("track.measurement.{name} = {value}");
            for part in [key("conjugate", keys[0]), key("negate", keys[1])] {
                assert!(refusal.contains(&part), "{signs:?} {set:?}: {refusal}");
            }
            if set == [false, false] {
                assert!(refusal.contains(says), "{signs:?}: {refusal}");
                assert_eq!(refusal.contains(active), signs[1] < 0.0);
            }
        }
    }
}

/// A mobility that is read as a receptance is none that is conjugated.
#[test]
fn another_quantity_is_told_from_a_wrong_sign() {
    let text = table("frequency_hz,re,im", |f, h| {
        let mobility = 1e-3 * h * Complex64::new(0.0, std::f64::consts::TAU * f);
        format!("{f},{:e},{:e}", mobility.re, mobility.im)
    });
    let refusal = case("rail.csv", text.as_bytes(), CARTESIAN).err().unwrap().to_string();
    assert!(refusal.contains("as that of a mobility or an accelerance does"), "{refusal}");
}

/// Files written by pyuff: see tests/universal-files/make_fixtures.py. Their displacement points up
/// (direction 3) and their force down (−3), so the receptance in one direction is the negative, which is turned back, for
/// their values are those of one direction. An uneven abscissa in text has six digits, which near a
/// resonance is five of the value, and all values in single precision have six.
#[test]
fn reads_universal_files() {
    for (name, tolerance) in [
        ("receptance_double_even.uff", 1e-10),
        ("receptance_double_uneven.uff", 1e-4),
        ("receptance_binary_even.uff", 1e-10),
        ("mobility_single_even.uff", 1e-5),
        ("accelerance_single_uneven.uff", 1e-4),
    ] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../riffel-rail/tests/universal-files");
        let case = case(name, &fs::read(folder.join(name)).unwrap(), "negate = true").unwrap();
        let exact = fs::read_to_string(folder.join("exact.csv")).unwrap();
        let mut compared = 0;
        for line in exact.lines().skip(1) {
            let cells: Vec<f64> = line.split(',').filter_map(|cell| cell.parse().ok()).collect();
            let [frequency, re, im] = cells[..] else {
                continue;
            };
            let uneven = name.contains("uneven");
            let is_even = (frequency / 20.0 - (frequency / 20.0).round()).abs() < 1e-9;
            if uneven == is_even {
                continue;
            }
            let h = case.track.receptance.receptance(std::f64::consts::TAU * frequency, 0.0);
            if h.is_nan() {
                continue; // the last frequency, rounded down in the file
            }
            let expected = Complex64::new(re, im);
            assert!((h - expected).norm() < tolerance * expected.norm(), "{frequency} {h} {expected}");
            compared += 1;
        }
        assert!(compared > 90, "{compared}");
    }
}

#[test]
fn is_not_extrapolated() {
    let case = case("rail.csv", cartesian().as_bytes(), CARTESIAN).unwrap();
    let error = case.check_frequencies(40.0, 100.0).unwrap_err().to_string();
    assert!(error.contains("is known from 50") && error.contains("not extrapolated"), "{error}");
}

#[test]
fn bad_tables() {
    for (text, keys, sentence) in [
        ("frequency_hz,re,im\n1,1,-1\n2,,-1\n", CARTESIAN, "line 3: column `re` is empty"),
        ("frequency_hz,re,im\n1,1,-1\n2,NaN,-1\n", CARTESIAN, "line 3: column `re` is NaN, but must be finite"),
        ("frequency_hz,re,im\n1,1,-1\n2,x,-1\n", CARTESIAN, "line 3: column `re` is \"x\", not a number"),
        ("frequency_hz,re,im\n1,1,-1\n1,1,-1\n", CARTESIAN, "line 3: the frequency 1 Hz is there twice"),
        ("frequency_hz,re,im\n2,1,-1\n1,1,-1\n", CARTESIAN, "line 3: the frequency falls from 2 Hz to 1 Hz"),
        (
            "frequency_hz,re,im\n1,1,-1\n0,1,-1\n",
            CARTESIAN,
            "line 3: the frequency is 0 Hz, but must be greater than zero",
        ),
        (
            "frequency_hz,mod,phase\n100,1e-9,-10\n110,-1e-9,-20\n",
            "",
            "line 3: column `mod` is -0.000000001, but a modulus is not negative (for a column in decibels write \
     track.measurement.unit = \"dB re 1 m/N\")",
        ),
        (
            "frequency_hz,mod [dB],phase\n100,-170,-10\n110,-171,-20\n",
            "",
            "`track.measurement.unit` is left out, but column `mod [dB]` is in decibels: write the \
     reference, as unit = \"dB re 1 m/N\"",
        ),
        (
            "frequency_hz,mod,phase\n100,60,-10\n110,61,-20\n",
            "",
            "those of rails are some 1e-11 to 1e-7 m/N: check track.measurement.quantity and unit",
        ),
        (
            "frequency_hz,mod,phase\n100,1e-9,-0.1\n110,1e-9,-0.2\n",
            "",
            "`track.measurement.phase_unit` is left out, and column `phase` stays within ±0.20",
        ),
        (
            "frequency_hz,re,im,coherence\n100,1e-9,-1e-9,0.9\n110,1e-9,-1e-9,1.2\n",
            "",
            "line 3: column `coherence` is 1.2, but a coherence lies between 0 and 1",
        ),
        (
            "frequency_hz,rail re,wheel re,im\n100,1,1,-1\n",
            "",
            "`track.measurement.real` is left out, and more than one column could be it: `rail re`, `wheel re`",
        ),
        ("100,1e-9,-1e-9\n110,1e-9,-1e-9\n", "", "has no header"),
        ("frequency_hz,re,im\n-1,1,-1\n1,1,-1\n", CARTESIAN, "line 2: the frequency is -1 Hz"),
        ("frequency_hz,re,im\n100,1,-1\n300,1,-1\n", CARTESIAN, "line 3: nothing between 100 Hz and 300 Hz"),
        ("frequency_hz,re,im\n100,1,-1\n", CARTESIAN, "needs two frequencies or more"),
        ("frequency_hz,re,im\n", CARTESIAN, "needs two frequencies or more"),
        ("frequency_hz,re,im\n100,1\n", CARTESIAN, "column `im` is empty"),
        ("", CARTESIAN, "`track.measurement.file` is empty"),
        (
            "f,re,im\n1,1,-1\n",
            "frequency = \"frequency_hz\"\nreal = \"re\"\nimaginary = \"im\"",
            "`track.measurement.frequency` is \"frequency_hz\", but the file has no such column; it has f, re, im",
        ),
        (
            "frequency_hz,re,im\n1,1,-1\n2,1,-1\n",
            "real = \"re\"",
            "`real` and `imaginary`, or by `modulus` and `phase`",
        ),
        (
            "frequency_hz,re,im\n1,1,-1\n2,1,-1\n",
            "real = \"re\"\nimaginary = \"im\"\nunit = \"m/s\"",
            "`track.measurement.unit` is \"m/s\", which is no unit of a receptance in m/N, a mobility",
        ),
        (
            "frequency_hz,re,im\n1,1,-1\n2,1,-1\n",
            "real = \"re\"\nimaginary = \"im\"\nunit = \"furlong\"",
            "unknown unit",
        ),
        (
            "frequency_hz,re,im\n1,1,-1\n2,1,-1\n",
            "real = \"re\"\nimaginary = \"im\"\nfrequency_unit = \"s\"",
            "is no unit of a frequency",
        ),
    ] {
        let error = case("rail.csv", text.as_bytes(), keys).err().unwrap_or_else(|| panic!("{text:?} is read"));
        assert!(error.to_string().contains(sentence), "{text:?}: {error}");
    }
}

#[test]
fn a_million_lines_are_no_frequency_response() {
    let mut text = "frequency_hz,re,im\n".to_owned();
    for line in 1..=1_000_000 {
        text.push_str(&format!("{line},1e-9,-1e-9\n"));
    }
    let error = case("rail.csv", text.as_bytes(), CARTESIAN).err().expect("too long");
    assert!(error.to_string().contains("more than 200000 lines"), "{error}");
}

#[test]
fn bad_universal_files() {
    let cases: [(&[u8], &str); 2] = [(b"", "the file holds no dataset"), (b"    -1\n    58\n", "line")];
    for (bytes, sentence) in cases {
        let error = case("rail.uff", bytes, "").err().expect("a bad file");
        assert!(error.to_string().contains(sentence), "{error}");
    }
}

/// Frequencies in radians a second, and what a file does not say of its own: the key that says it is asked for.
#[test]
fn what_a_universal_file_leaves_unsaid_is_asked_for() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../riffel-rail/tests/universal-files");
    let text = fs::read_to_string(folder.join("receptance_double_even.uff")).unwrap();
    let changed = |changes: &[(&str, &str)], keys: &str| {
        let text = changes.iter().fold(text.clone(), |text, (from, to)| {
            assert!(text.contains(from), "{from}");
            text.replace(from, to)
        });
        // Its displacement and its force point against each other, its values do not.
        let negate = format!("negate = {}\n{keys}", !keys.contains("function"));
        case("rail.uff", text.as_bytes(), &negate).map_err(|error| error.to_string())
    };
    let at = |case: &Case, omega: f64| case.track.receptance.receptance(omega, 0.0);
    let plain = at(&changed(&[], "").unwrap(), std::f64::consts::TAU * 400.0);
    let radians = changed(&[("Frequency            Hz   ", "Frequency            rad/s")], "");
    assert!((at(&radians.unwrap(), 400.0) / plain - 1.0).norm() < 1e-9);
    let no_unit = ("Displacement         m   ", "Displacement         NONE");
    let general = ("         8    1", "         1    1");
    let nowhere = [("RAIL         1   3", "RAIL         1   0"), ("RAIL         1  -3", "RAIL         1   0")];
    for (changes, key, says) in [
        (&[no_unit][..], "unit = \"m/N\"", "track.measurement.unit"),
        (&[general], "quantity = \"receptance\"", "track.measurement.quantity"),
        (&nowhere, "function = 1", "track.measurement.function"),
    ] {
        let refusal = changed(changes, "").err().unwrap();
        assert!(refusal.contains(says), "{refusal}");
        let read = changed(changes, key).unwrap();
        let found = at(&read, std::f64::consts::TAU * 400.0);
        assert!((found / plain - 1.0).norm() < 1e-9, "{key}: {found} {plain}");
    }
    let unknown = changed(&[("Frequency            Hz   ", "Frequency            m/s  ")], "");
    assert!(unknown.err().unwrap().contains("frequency_unit"));
}

#[test]
fn a_missing_file_is_named() {
    let text = NOMINAL_CASE.replace("model = \"free-beam\"", "model = \"measured\"")
        + "\n[track.measurement]\nfile = \"nowhere.csv\"\n";
    let error = Case::parse("case.toml", &text, &[]).err().unwrap().to_string();
    assert!(error.contains("`track.measurement.file`: cannot read the measurement nowhere.csv"), "{error}");
}
