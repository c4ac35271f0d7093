//! Receptance and growth on tracks, from the command line to the files.

use std::fs;

use serde_json::Value;

use crate::sandbox::Sandbox;

const CASE: &str = "cases/discrete-supports.toml";

fn pairs(document: &Value, key: &str) -> Vec<(f64, f64)> {
    document[key]
        .as_array()
        .unwrap()
        .iter()
        .map(|pair| (pair[0].as_f64().unwrap(), pair[1].as_f64().unwrap()))
        .collect()
}

/// Lines of a CSV as numbers, below their header.
fn table(text: &str) -> (Vec<&str>, Vec<Vec<f64>>) {
    let mut lines = text.lines();
    let header = lines.next().unwrap().split(',').collect();
    let rows = lines.map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect()).collect();
    (header, rows)
}

/// The document and the table hold the same, frequencies include both ends exactly, the joints add
/// up, and without a folder nothing is written.
#[test]
fn receptance_document_and_table() {
    let sandbox = Sandbox::new();
    let arguments = format!("receptance {CASE} --from 20 --to 3000 --points 200 --json");
    let document = sandbox.json(&arguments);
    assert_eq!(sandbox.list("."), ["cases"]);
    let frequencies: Vec<f64> = serde_json::from_value(document["frequency_hz"].clone()).unwrap();
    assert_eq!((frequencies[0], frequencies[199]), (20.0, 3000.0));
    let step = frequencies[1] / frequencies[0];
    assert!((frequencies[150] / frequencies[149] / step - 1.0).abs() < 1e-12);

    let joints = ["rail_m_per_n", "wheel_m_per_n", "contact_m_per_n", "total_m_per_n"];
    let [rail, wheel, contact, total] = joints.map(|key| pairs(&document, key));
    for index in 0..200 {
        let sum = rail[index].0 + wheel[index].0 + contact[index].0;
        // Rounding of the largest term.
        let tolerance = 1e-14 * wheel[index].0.abs().max(rail[index].0.abs());
        assert!((sum - total[index].0).abs() <= tolerance + 1e-24);
        assert!(rail[index].1 < 0.0);
    }

    let written = sandbox.riffel(&format!("{arguments} -o out"));
    assert_eq!(written.status, Some(0), "{}", written.text);
    let text = fs::read_to_string(sandbox.path("out/receptance.csv")).unwrap();
    let (header, rows) = table(&text);
    assert_eq!(
        header[..9],
        [
            "frequency_hz",
            "rail_m_per_n_re",
            "rail_m_per_n_im",
            "wheel_m_per_n_re",
            "wheel_m_per_n_im",
            "contact_m_per_n_re",
            "contact_m_per_n_im",
            "total_m_per_n_re",
            "total_m_per_n_im",
        ]
    );
    assert_eq!(rows.len(), 200);
    for (row, (frequency, rail)) in rows.iter().zip(frequencies.iter().zip(rail)) {
        // The reader of JSON is a rounding off now and then.
        let close = |a: f64, b: f64| (a - b).abs() <= 1e-15 * b.abs();
        assert!(close(row[0], *frequency) && close(row[1], rail.0) && close(row[2], rail.1));
        // The case has the wheel over a support.
        assert_eq!((row[9], row[10]), (row[1], row[2]));
    }
    for file in ["receptance.png", "receptance.html", "resonances.csv", "decay-rate.csv", "decay-rate.png"] {
        assert!(sandbox.path("out").join(file).exists(), "{file}");
    }
}

/// `--position` moves the wheel: in mid-span the receptance is that of the mid-span column.
#[test]
fn position_moves_the_wheel() {
    let sandbox = Sandbox::new();
    let arguments = "--from 900 --to 1200 --points 20";
    sandbox.riffel(&format!("receptance {CASE} {arguments} -o out"));
    let text = fs::read_to_string(sandbox.path("out/receptance.csv")).unwrap();
    let (_, rows) = table(&text);
    let mid_span = sandbox.json(&format!("receptance {CASE} {arguments} --position \"0.3 m\" --json"));
    let mid_span = pairs(&mid_span, "rail_m_per_n");
    for (row, value) in rows.iter().zip(mid_span) {
        // Half the spacing and 0.3 m are a rounding apart.
        let distance = (row[11] - value.0).hypot(row[12] - value.1);
        assert!(distance < 1e-12 * value.0.hypot(value.1));
        assert_ne!((row[1], row[2]), value);
    }
}

/// A receptance that Riffel has written is one that Riffel can read, and gives the same growth at its
/// frequencies.
#[test]
fn a_computed_receptance_reads_back_as_a_measured_one() {
    let sandbox = Sandbox::new();
    sandbox.riffel(&format!("receptance {CASE} --from 400 --to 600 --points 3 -o out"));
    // The middle one of the three frequencies.
    let frequency = (400f64 * 600.0).sqrt();
    let point = format!("--wavelength {} --speed 25 --json", 25.0 / frequency);
    let exact = sandbox.json(&format!("point {CASE} {point}"));
    let measured = sandbox.json(
        &format!(
            "point {CASE} {point} --set track.model=measured \
             --set track.measurement='{{file=\"../out/receptance.csv\", real=\"rail_m_per_n_re\", imaginary=\"rail_m_per_n_im\"}}'"
        ),
    );
    assert!(measured.is_null() || measured["growth_rate_per_passage"].is_number());
    let (got, expected) =
        (measured["growth_rate_per_passage"].as_f64().unwrap(), exact["growth_rate_per_passage"].as_f64().unwrap());
    assert!((got / expected - 1.0).abs() < 1e-9, "{got} {expected}");
}

/// Every file of the bay, and numbers that agree with each other and with points.
#[test]
fn growth_over_the_bay() {
    let sandbox = Sandbox::new();
    let outcome = sandbox.riffel(&format!(
        "map {CASE} --bay --wavelength \"50 mm\" --speed \"80 km/h\" -o out \
         --set map.wavelength.points=41 --set map.speed.points=21"
    ));
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    for file in [
        "bay.csv",
        "bay.html",
        "bay.png",
        "bay.svg",
        "bay-map.html",
        "bay-map.png",
        "bay-map.svg",
        "bay-mean-ridge.csv",
        "bay-mean-branches.csv",
        "bay-mean.csv",
        "bay-mean.nc",
        "bay-wavelength.csv",
        "map.csv",
    ] {
        assert!(sandbox.path("out").join(file).exists(), "{file}");
    }
    let summary = fs::read_to_string(sandbox.path("out/summary.json")).unwrap();
    let summary: Value = serde_json::from_str(&summary).unwrap();
    let text = fs::read_to_string(sandbox.path("out/bay.csv")).unwrap();
    let (_, rows) = table(&text);
    assert_eq!((rows[0][0], rows[120][0]), (0.0, 0.6));
    for (row, place, key) in [(0, "0", "growth_rate_over_support"), (60, "0.3", "growth_rate_mid_span")] {
        let point =
            sandbox.json(&format!("point {CASE} --wavelength \"50 mm\" --speed \"80 km/h\" --position {place} --json"));
        let expected = point["growth_rate_per_passage"].as_f64().unwrap();
        let summarised = summary["bay"][key].as_f64().unwrap();
        for got in [rows[row][5], summarised] {
            // The place in the middle is 0.6/2 or 0.3, a rounding apart.
            assert!((got / expected - 1.0).abs() < 1e-9, "{key}: {got} {expected}");
        }
    }
    let rates: Vec<f64> = rows.iter().map(|row| row[5]).collect();
    let (low, high) = rates.iter().fold((f64::MAX, f64::MIN), |(low, high), &rate| (low.min(rate), high.max(rate)));
    let mean = summary["bay"]["growth_rate_mean"].as_f64().unwrap();
    assert!(low < mean && mean < high, "{low} {mean} {high}");
}

/// A window wider than the measurement is refused before anything is written.
#[test]
fn a_map_beyond_the_measurement_is_refused() {
    let sandbox = Sandbox::new();
    sandbox.riffel(&format!("receptance {CASE} --from 100 --to 1000 -o rail"));
    let outcome = sandbox.riffel(
        "map cases/nominal.toml -o out --set track.model=measured \
         --set track.measurement='{file=\"../rail/receptance.csv\", real=\"rail_m_per_n_re\", imaginary=\"rail_m_per_n_im\"}'",
    );
    assert_eq!(outcome.status, Some(2), "{}", outcome.text);
    assert!(outcome.text.contains("extrapolated"), "{}", outcome.text);
    assert!(!sandbox.path("out").exists());
}
