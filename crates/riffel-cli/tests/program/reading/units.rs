//! Units of positions, heights and levels.

use std::fs;

use serde_json::Value;

use super::{check_wave, rail, table, unwrapped};
use crate::sandbox::{Sandbox, number};

/// A length is converted, whatever it is called.
#[test]
fn lengths_of_the_inch_are_read_as_such() {
    let sandbox = Sandbox::new();
    let rail = rail();
    for (heading, position, height) in [
        ("x [ft],left [mil]\n", 0.3048, 25.4e-6),
        ("x_ft,left_in\n", 0.3048, 25.4e-3),
        ("Weg [yd],links [thou]\n", 0.9144, 25.4e-6),
        ("Miles,height [um]\n", 1609.344, 1e-6),
        ("x [dm],left (um)\n", 0.1, 1e-6),
        ("[ft],[mil]\n", 0.3048, 25.4e-6),
    ] {
        let text = table(heading, &rail, |x, h| format!("{:.9},{:.9}", x / position, h / height));
        fs::write(sandbox.path("rail.csv"), text).unwrap();
        check_wave(&sandbox.json("roughness rail.csv --json"), heading);
    }
}

/// What is no length is refused with its column, and nothing is written.
// Long: reads seven records of 10 000 heights twice, refused and as they are told.
#[test]
fn other_units_of_positions_and_heights_are_refused() {
    let sandbox = Sandbox::new();
    let rail = rail();
    for (heading, part) in [
        ("x [furlong],left_um", "column 1, \"x [furlong]\", gives furlong"),
        ("Weg [Fuss],left_um", "column 1, \"Weg [Fuss]\", gives Fuss"),
        ("x [hm],left_um", "column 1, \"x [hm]\", gives hm"),
        ("t_s,left_um", "column 1, \"t_s\", gives s"),
        ("x_m,left [°]", "column 2, \"left [°]\", gives °"),
        ("x_m,left [dB]", "column 2, \"left [dB]\", gives dB"),
        ("x_m,left [10 um]", "column 2, \"left [10 um]\", gives 10 um"),
    ] {
        let text = table(&format!("{heading}\n"), &rail, |x, h| format!("{x:.3},{:.4}", 1e6 * h));
        fs::write(sandbox.path("rail.csv"), text).unwrap();
        let outcome = sandbox.riffel("roughness rail.csv -o out");
        let sentence = unwrapped(&outcome.text);
        assert_eq!(outcome.status, Some(2), "{heading}: {sentence}");
        assert!(sentence.contains(part), "{heading}: {sentence}");
        assert!(!sandbox.path("out").exists());
        // Who knows better says so.
        let said = if part.contains("column 1") { "--position-unit m" } else { "--height-unit um" };
        check_wave(&sandbox.json(&format!("roughness rail.csv --json {said}")), heading);
    }
}

#[test]
fn references_of_levels_are_converted_or_refused() {
    let sandbox = Sandbox::new();
    let read = |wavelength: &str, size: f64, level: &str, shift: f64| {
        let rows = [(0.08, 4.0), (0.063, 3.0), (0.05, 2.0), (0.04, 1.0)]
            .map(|(length, db)| format!("{},{}\n", length / size, db + shift));
        let text = format!("{wavelength},{level}\n{}", rows.concat());
        fs::write(sandbox.path("levels.csv"), text).unwrap();
        sandbox.riffel("roughness levels.csv --json")
    };
    for (wavelength, size, level, shift) in [
        ("wavelength_mm", 1e-3, "level_db", 0.0),
        ("wavelength_mm", 1e-3, "level [dB re 1 nm]", 60.0),
        ("wavelength [m]", 1.0, "level [dB re 1e-9 m]", 60.0),
        ("wavelength_in", 0.0254, "level [dB re 1 um]", 0.0),
    ] {
        let outcome = read(wavelength, size, level, shift);
        let document: Value = serde_json::from_str(&outcome.text).unwrap();
        let levels = document["spectrum"].as_array().unwrap().iter();
        let levels: Vec<f64> = levels.map(|row| number(&row["level_db"])).collect();
        for (found, expected) in levels.iter().zip([1.0, 2.0, 3.0, 4.0]) {
            assert!((found - expected).abs() < 1e-9, "{level}: {levels:?}");
        }
    }
    for (wavelength, size, level, part) in [
        ("wavelength_mm", 1e-3, "level [dB re 20 uPa]", "is in dB re 20 uPa"),
        ("wavelength_mm", 1e-3, "level_nm", "is in nm"),
        ("wavelength_mm", 1e-3, "amplitude_um", "is in um"),
        ("wavelength_mm", 1e-3, "speed_kmh", "is in kmh"),
        ("wavelength [m]", 1e-3, "level_db", "between 1 mm and 10 m"),
        ("wavelength [Fuss]", 0.3, "level_db", "is in Fuss"),
    ] {
        let outcome = read(wavelength, size, level, 0.0);
        let sentence = unwrapped(&outcome.text);
        assert_eq!(outcome.status, Some(2), "{level}: {sentence}");
        assert!(sentence.contains(part), "{level}: {sentence}");
    }
}
