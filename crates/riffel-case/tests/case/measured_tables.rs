//! Measured receptances as measuring systems and scripts write them, made with NumPy and pyuff from a closed form
//! (tests/measured-tables/make_fixtures.py), against the model of the same track.

use std::f64::consts::TAU;
use std::fs;
use std::path::{Path, PathBuf};

use riffel::diagnosis::MechanismKind;
use riffel_case::Case;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../riffel-rail/tests/measured-tables")
}

fn model() -> Case {
    Case::read(&folder().join("case.toml"), &[]).unwrap()
}

/// The case on a file, with keys of `track.measurement`.
fn measured(file: &str, keys: &str) -> Result<Case, riffel_keys::CaseError> {
    let text = fs::read_to_string(folder().join("case.toml")).unwrap();
    let text = text.replace("\"two-layer\"", "\"measured\"")
        + &format!("\n[track.measurement]\nfile = {:?}\n{keys}\n", folder().join(file));
    Case::parse("case.toml", &text, &[])
}

/// Digits of the files are nine, those of text in a universal file twelve with frequencies of six.
#[test]
fn every_file_is_the_same_track() {
    for (file, keys) in [
        ("accelerance_g.csv", ""),
        ("receptance_db.txt", ""),
        ("mobility_savetxt.txt", "unit = \"mm/s/kN\""),
        ("receptance_quoted.csv", ""),
        ("three_directions.uff", ""),
    ] {
        let (model, case) = (model(), measured(file, keys).unwrap());
        for frequency in [50.0, 80.0, 250.0, 490.0, 1200.0, 2500.0] {
            let h = case.track.receptance.receptance(TAU * frequency, 0.0);
            let expected = model.track.receptance.receptance(TAU * frequency, 0.0);
            let error = (h - expected).norm() / expected.norm();
            assert!(error < 1e-7, "{frequency} Hz: {h} {expected}");
        }
        // A point of the map on a line, 25 m/s over 50 mm.
        let rate = |case: &Case| case.feedback.at(0.05, 25.0).growth_rate;
        assert!((rate(&case) / rate(&model) - 1.0).abs() < 1e-6);
        // Between two lines the receptance is a chord.
        let between = |case: &Case| case.feedback.at(0.0503, 25.0).growth_rate;
        assert!((between(&case) / between(&model) - 1.0).abs() < 0.02);
        // The same rail on its pads is a candidate, within a line.
        let of = |case: &Case, kind: MechanismKind| -> Vec<f64> {
            let mechanisms = case.mechanisms().0.into_iter();
            mechanisms
                .filter(|mechanism| mechanism.kind == kind)
                .filter_map(|mechanism| mechanism.frequency())
                .collect()
        };
        let expected = of(&model, MechanismKind::RailOnPad)[0];
        let peaks = of(&case, MechanismKind::MeasuredPeak);
        assert!(peaks.iter().any(|peak| (peak - expected).abs() < 10.0), "{peaks:?} {expected}");
    }
}

#[test]
fn remarks_say_what_was_done() {
    let words = |file: &str, keys: &str| {
        let remarks = measured(file, keys).unwrap().remarks;
        let words: Vec<String> = remarks.iter().map(ToString::to_string).collect();
        words.join("\n")
    };
    let analyser = words("accelerance_g.csv", "");
    assert!(analyser.contains("the measured value at 0 Hz is left out"), "{analyser}");
    assert!(analyser.contains("coherence is below 0.8 at 4 of 250 frequencies, between 10 and 40 Hz"), "{analyser}");
    assert!(!analyser.contains("names no unit"), "{analyser}");
    // Nothing is said where nothing had to be guessed, and it is where something was.
    let spreadsheet = words("receptance_db.txt", "");
    assert!(!spreadsheet.contains("measured") && !spreadsheet.contains("taken as"), "{spreadsheet}");
    let unnamed = words("mobility_savetxt.txt", "quantity = \"mobility\"\nunit = \"mm/s/kN\"");
    assert!(!unnamed.contains("names no unit"), "{unnamed}");
}

#[test]
// Without a unit, values of 1e-2 are not those of a rail.
fn what_does_not_fit_is_refused() {
    for row in [
        "mobility_savetxt.txt =>  => but those of rails are some 1e-11 to 1e-7 m/N",
        "accelerance_g.csv => unit = \"m/N\"\nquantity = \"mobility\" => no unit of a mobility",
        "accelerance_g.csv => quantity = \"receptance\" => is in g/N, an accelerance",
        "receptance_db.txt => unit = \"m/N\" => is in decibels: write the reference",
        "receptance_db.txt => unit = \"dB\" => without a reference: write the reference, as unit = \"dB re 1 m/N\"",
        "three_directions.uff => function = 1 => responds along y to a force along y",
        "three_directions.uff => function = 3 => responds along z to a force along y",
        "three_directions.uff => vertical_axis = \"x\" => 3 frequency responses: choose one",
    ] {
        let [file, keys, sentence] = row.split(" => ").collect::<Vec<_>>()[..] else { panic!("{row}") };
        let error = measured(file, keys).err().expect("refused").to_string();
        assert!(error.contains(sentence), "{error}");
    }
}

/// A case may say that the test stood on its side.
#[test]
fn another_axis_may_be_vertical() {
    let soft = measured("three_directions.uff", "vertical_axis = \"y\"").unwrap();
    let [h, vertical] = [&soft, &model()].map(|case| case.track.receptance.receptance(TAU * 490.0, 0.0));
    assert!((h - 3.0 * vertical).norm() < 1e-6 * h.norm());
}

/// An angular frequency is converted; what is no frequency is refused.
#[test]
fn frequencies_are_converted() {
    for (head, per_hertz) in [
        ("frequency [rad/s]", std::f64::consts::TAU),
        ("frequency_rad_s", std::f64::consts::TAU),
        ("frequency [kHz]", 1e-3),
    ] {
        let case = with_frequencies(head, per_hertz).unwrap();
        let found = case.track.receptance.receptance(TAU * 500.0, 0.0);
        assert!((found.re - 5e-9).abs() < 1e-17, "{head}: {found}");
    }
}

#[test]
fn other_frequencies_are_refused() {
    for (head, part) in [
        ("frequency [rpm]", "column `frequency [rpm]` is in rpm"),
        ("frequency [mm]", "column `frequency [mm]` is in mm"),
    ] {
        let error = with_frequencies(head, 1.0).err().unwrap().to_string();
        assert!(error.contains(part), "{error}");
    }
}

/// Receptance with its frequencies in another unit.
fn with_frequencies(head: &str, per_hertz: f64) -> Result<Case, riffel_keys::CaseError> {
    let head = format!("{head},real [m/N],imaginary [m/N]");
    with_rows(&head, |f, re, im| format!("{:.12},{re:.12e},{im:e}", per_hertz * f), "")
}

/// A receptance of 1e-11 m/N for each hertz less 1e-10i m/N, 50 to 3000 Hz, with rows of frequency, real and imaginary part.
fn with_rows(head: &str, row: impl Fn(f64, f64, f64) -> String, keys: &str) -> Result<Case, riffel_keys::CaseError> {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("rail.csv");
    let rows = (5..=300).map(|line| {
        let hertz = 10.0 * f64::from(line);
        row(hertz, 1e-11 * hertz, -1e-10) + "\n"
    });
    fs::write(&file, format!("{head}\n{}", rows.collect::<String>())).unwrap();
    measured(file.to_str().unwrap(), keys)
}

/// A factor of a thousand is within what is read, but not within what rails have.
#[test]
fn a_receptance_unlike_any_rail_is_asked_about() {
    let asked = |unit: &str| {
        let case = measured("receptance_quoted.csv", &format!("unit = \"{unit}\"")).unwrap();
        case.remarks.iter().any(|remark| remark.to_string().contains("but rails have 1e-11 to 1e-7 m/N"))
    };
    assert!(!asked("m/N"));
    assert!(asked("m/mN"));
}

/// Complex numbers in one column, as NumPy, MATLAB and spreadsheets write them, and a modulus under the name of its quantity.
#[test]
fn values_are_read_as_programs_write_them() {
    type Row = fn(f64, f64, f64) -> String;
    let tables: [(&str, Row); 6] = [
        ("# frequency [Hz], H [m/N]", |f, re, im| format!("{f}, ({re:e}{im:+e}j)")),
        ("frequency [Hz],H [m/N]", |f, re, im| format!("{f},{re:e}{im:+e}i")),
        ("Frequenz [Hz];H [m/N]", |f, re, im| format!("{f};{re:e} {im:+e}i").replace('.', ",")),
        ("Frequency [Hz],Receptance [m/N],Phase [rad]", |f, re, im| format!("{f},{:e},{}", re.hypot(im), im.atan2(re))),
        ("Frequenz [Hz];real [m/N];imag [m/N]", |f, re, im| {
            let (thousands, rest) = (f.div_euclid(1e3), f.rem_euclid(1e3));
            match thousands > 0.0 {
                true => format!("{thousands}.{rest:03},0;{re:e};{im:e}"),
                false => format!("{rest},0;{re:e};{im:e}"),
            }
        }),
        ("frequency_hz real_m/N imag_m/N", |f, re, im| format!("{f} {re:.12e} {im:.12e}").replace('e', "D")),
    ];
    for (head, row) in tables {
        let case = with_rows(head, row, "unit = \"m/N\"").unwrap();
        let found = case.track.receptance.receptance(TAU * 500.0, 0.0);
        assert!((found.re - 5e-9).abs() < 1e-17 && (found.im + 1e-10).abs() < 1e-17, "{head}: {found}");
    }
}

/// What a head says of unit and quantity is taken, or refused where it is not known; a phase of one turn says no unit.
#[test]
fn what_a_head_says_is_not_passed_over() {
    type Row = fn(f64, f64, f64) -> String;
    let cartesian: Row = |f, re, im| format!("{f},{re:e},{im:e}");
    let of_mobility: Row = |f, re, im| {
        let mobility = riffel::Complex64::new(re, im) * riffel::Complex64::new(0.0, TAU * f);
        format!("{f},{:e},{}", mobility.norm(), mobility.arg().to_degrees())
    };
    let of_a_turn: Row = |f, re, im| {
        let phase = im.atan2(re).rem_euclid(TAU);
        format!("{f},{:e},{phase}", re.hypot(im))
    };
    for (head, row, expected) in [
        ("f (Hz),Re(H) (mm/kN),Im(H) (mm/kN)", cartesian, Ok(1e-6)),
        ("frequency [Hz],Re [m/N],Im [m/N]", cartesian, Ok(1.0)),
        ("Frequency [Hz],Mobility,Phase [deg]", of_mobility, Ok(1.0)),
        ("frequency [Hz],Re [mm/kgf],Im [mm/kgf]", cartesian, Err("is in mm/kgf, which is no unit")),
        ("frequency [Hz],modulus [m/N],phase", of_a_turn, Err("write \"radians\"")),
    ] {
        match (with_rows(head, row, ""), expected) {
            (Ok(case), Ok(unit)) => {
                let found = case.track.receptance.receptance(TAU * 500.0, 0.0);
                assert!((found.re / unit - 5e-9).abs() < 1e-14, "{head}: {found}");
            }
            (Err(error), Err(words)) => {
                assert!(error.to_string().contains(words), "{head}: {error}");
            }
            (found, _) => panic!("{head}: {:?}", found.map(|case| case.file.title)),
        }
    }
}

/// A mark of a missing value is no receptance.
#[test]
fn marks_of_missing_values_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("rail.csv");
    let rows = (5..=300).map(|line| match line {
        20 => "200,-9999,-9999\n".to_owned(),
        _ => format!("{},1e-9,-1e-10\n", 10 * line),
    });
    let text = format!("frequency_hz,real_m_per_n,imag_m_per_n\n{}", rows.collect::<String>());
    fs::write(&file, text).unwrap();
    let error = measured(file.to_str().unwrap(), "unit = \"m/N\"").err().unwrap().to_string();
    assert!(error.contains("line 17: column `real_m_per_n` is -9999, which marks"), "{error}");
}
