//! Measured receptances in cases.

use std::f64::consts::TAU;
use std::fs;
use std::path::{Path, PathBuf};

use riffel::diagnosis::MechanismKind;
use riffel_case::{Case, NOMINAL_CASE, traffic};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../riffel-rail/tests/measured-tables")
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
        let text = fs::read_to_string(folder().join("case.toml")).unwrap();
        let model = Case::read(&folder().join("case.toml"), &[]).unwrap();
        let text = text.replace("\"two-layer\"", "\"measured\"")
            + &format!("\n[track.measurement]\nfile = {:?}\n{keys}\n", folder().join(file));
        let case = crate::case(&text, &[]);
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
            let mechanisms = traffic::mechanisms(case).0.into_iter();
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

/// A receptance is known from its first line to its last; what is wrong with its file is said of the key that names it.
#[test]
fn a_measurement_ends_and_is_refused_by_its_keys() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("rail.csv");
    let of = |text: &str, keys: &str| {
        fs::write(&file, text).unwrap();
        let text = NOMINAL_CASE.replace("model = \"free-beam\"", "model = \"measured\"")
            + &format!("\n[track.measurement]\nfile = {file:?}\n{keys}\n");
        crate::parsed(&text, &["map.speed.max=30", "map.speed.min=8"])
    };
    let rows = (0..40).map(|step| {
        let frequency = 50.0 * 50f64.powf(f64::from(step) / 39.0);
        let h = 1e-8 / riffel::Complex64::new(1.0, frequency / 100.0);
        format!("{frequency},{:e},{:e}\n", h.re, h.im)
    });
    let table = format!("frequency_hz,re,im\n{}", rows.collect::<String>());
    let case = of(&table, "").unwrap();
    case.check_window().unwrap();
    let error = case.check_frequencies(40.0, 100.0).unwrap_err().to_string();
    assert!(error.contains("is known from 50") && error.contains("not extrapolated"), "{error}");
    for (text, keys, sentence) in [
        ("", "", "`track.measurement.file` is empty"),
        (&*table, "frequency_unit = \"s\"", "`track.measurement.frequency_unit` is \"s\", which is no unit"),
        (&table, "real = \"re\"", "`track.measurement`"),
    ] {
        let error = of(text, keys).err().unwrap().to_string();
        assert!(error.contains(sentence), "{error}");
    }
    fs::remove_file(&file).unwrap();
    let text = NOMINAL_CASE.replace("model = \"free-beam\"", "model = \"measured\"")
        + "\n[track.measurement]\nfile = \"nowhere.csv\"\n";
    let error = crate::parsed(&text, &[]).err().unwrap().to_string();
    assert!(error.contains("`track.measurement.file`: cannot read the measurement nowhere.csv"), "{error}");
}
