//! `riffel diagnose`: from records to ranked candidates.

use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::fs;
use std::sync::LazyLock;

use serde_json::Value;

use crate::sandbox::{Sandbox, number};

fn share(finding: &Value, mechanism: &str) -> f64 {
    let candidates = finding["candidates"].as_array().unwrap();
    let found = candidates.iter().find(|candidate| candidate["mechanism"] == mechanism);
    found.map_or(0.0, |candidate| number(&candidate["share"]))
}

/// Positions of a record in m, and there heights in µm that look random: sines of wavelengths without a common measure.
static NOISE: LazyLock<Vec<[f64; 2]>> = LazyLock::new(|| {
    let wave = |index: i32| [0.006 * (1.0 + 0.017 * f64::from(index)).powf(2.3), 1.7 * f64::from(index * index)];
    let waves: Vec<[f64; 2]> = (0..400).map(wave).collect();
    let at = |row: i32| {
        let x = 1e-3 * f64::from(row);
        let heights = waves.iter().map(|[wavelength, phase]| 0.1 * (TAU * x / wavelength + phase).sin());
        [x, heights.sum()]
    };
    (0..40_000).map(at).collect()
});

fn record(sandbox: &Sandbox, name: &str, wavelength: f64, amplitude: f64) {
    record_of(sandbox, name, |x| amplitude * (TAU * x / wavelength).sin());
}

fn record_of(sandbox: &Sandbox, name: &str, wave: impl Fn(f64) -> f64) {
    let text = NOISE.iter().fold(String::new(), |mut text, [x, noise]| {
        let height = noise + wave(*x);
        writeln!(text, "{x:.3},{height:.4}").unwrap();
        text
    });
    fs::write(sandbox.path(name), text).unwrap();
}

const SBB: &str = "validation/reference/sbb-track-noise/rail_roughness.csv";

/// The rails of Niederwangen: a fading grinding mark and not growing corrugation.
#[test]
fn the_mark_of_niederwangen_is_a_fading_one() {
    let sandbox = Sandbox::new();
    sandbox.copy("validation/reference/sbb-track-noise");
    let document = sandbox.json(&format!(
        "diagnose cases/discrete-supports.toml --roughness {SBB} --where laboratory=MBBM \
             --speed \"136 km/h\" --json"
    ));
    let findings = document["dominant_wavelengths"].as_array().unwrap();
    assert_eq!(findings.len(), 1);
    let finding = &findings[0];
    assert_eq!(number(&finding["wavelength_m"]), 0.020);
    // The mark of the left rail is 3 dB lower and does not stand out of the scatter of its four sections.
    assert_eq!(finding["rail"], "R");
    // 136/3.6/0.02 = 1888.9 Hz.
    assert!((number(&finding["frequency_min_hz"]) - 1888.9).abs() < 0.1);
    let levels: Vec<f64> = finding["course"]["levels_db"].as_array().unwrap().iter().map(number).collect();
    // Means of four sections of the right rail.
    for (found, expected) in levels.iter().zip([-2.75, -5.8, -7.05, -8.775]) {
        assert!((found - expected).abs() < 1e-9, "{levels:?}");
    }
    assert_eq!(levels.len(), 4);
    assert_eq!(finding["course"]["per"], "year");
    assert!(number(&finding["course"]["probability_of_rise"]) < 0.01);
    assert_eq!(finding["candidates"][0]["mechanism"], "grinding mark");
    let summary = finding["summary"].as_str().unwrap();
    assert!(summary.contains("a fading grinding mark and not growing corrugation"), "{summary}");
    // Never one verdict alone, and shares are shares.
    let candidates = finding["candidates"].as_array().unwrap();
    let sum: f64 = candidates.iter().map(|found| number(&found["share"])).sum();
    assert!(candidates.len() > 5 && (sum - 1.0).abs() < 1e-9);
    assert!(finding["measurements"].as_array().unwrap().len() >= 2);
}

/// Corrugation at the ridge of the nominal case, growing from record to record.
// Long: makes and reads records of 40 000 heights at three dates.
#[test]
fn corrugation_on_the_ridge_is_led_by_it() {
    let sandbox = Sandbox::new();
    // The ridge follows 537 Hz: 55.9 mm at 108 km/h.
    record(&sandbox, "old.csv", 0.0559, 4.0);
    record(&sandbox, "new.csv", 0.0559, 9.0);
    let document = sandbox.json(
        "diagnose cases/nominal.toml --roughness new.csv --earlier old.csv --dates 2024-03-01,2025-03-01 \
         --speed \"108 km/h\" --json",
    );
    let finding = &document["dominant_wavelengths"][0];
    assert!((number(&finding["wavelength_m"]) / 0.0559 - 1.0).abs() < 0.01, "{finding}");
    assert!((number(&finding["frequency_min_hz"]) / 537.0 - 1.0).abs() < 0.01);
    assert_eq!(finding["candidates"][0]["mechanism"], "growth ridge");
    // 20 lg(9/4) = 7.04 dB in a year; noise in the band takes some of it.
    assert!((number(&finding["course"]["slope_db"]) - 7.04).abs() < 0.5, "{finding}");
    assert!(share(finding, "grinding mark") < 0.05);
    let swapped = sandbox.riffel(
        "diagnose cases/nominal.toml --roughness new.csv --earlier old.csv --dates 2025-03-01,2024-03-01 \
         --speed \"108 km/h\"",
    );
    let sentence = swapped.sentence();
    assert!(swapped.status == Some(2) && sentence.contains("days that rise"), "{sentence}");
    // Read the other way round it fades from record to record, and the mark leads.
    record(&sandbox, "between.csv", 0.0559, 6.0);
    let document = sandbox.json(
        "diagnose cases/nominal.toml --roughness old.csv --earlier new.csv --earlier between.csv \
         --speed \"108 km/h\" --json",
    );
    let fading = &document["dominant_wavelengths"][0];
    assert_eq!(fading["candidates"][0]["mechanism"], "grinding mark");
    assert_eq!(fading["course"]["per"], "record");
}

/// A given mode of the wheelset is a candidate, and leads where its frequency is that of the wave.
#[test]
fn a_wheelset_mode_is_taken_as_given() {
    let sandbox = Sandbox::new();
    record(&sandbox, "curve.csv", 0.1, 20.0);
    let document = sandbox.json(
        "diagnose cases/discrete-supports.toml --roughness curve.csv --speed \"29 km/h\" --speed \"31 km/h\" \
         --bending \"83 Hz\" --torsion \"45 Hz\" --json",
    );
    let finding = &document["dominant_wavelengths"][0];
    // 83 Hz at 30 km/h is 100.4 mm.
    assert!(share(finding, "wheelset bending") > 10.0 * share(finding, "wheelset torsion"));
    assert!(share(finding, "wheelset bending") > 0.2, "{finding}");
    assert!(share(finding, "pinned-pinned, lateral") < 0.02);
}

/// Corrugation at the peak of a hammer test is led by that peak, and not by a grinding mark.
#[test]
fn a_measured_peak_is_a_candidate() {
    let sandbox = Sandbox::new();
    sandbox.riffel("receptance cases/discrete-supports.toml --from 30 --to 4000 --points 2000 -o hammer");
    let measured = "--set track.model=measured --set track.measurement='{file=\"../hammer/receptance.csv\", \
                    real=\"rail_m_per_n_re\", imaginary=\"rail_m_per_n_im\"}'";
    let listed = sandbox.json(&format!("receptance cases/discrete-supports.toml {measured} --json"));
    let peak = listed["resonances"]
        .as_array()
        .unwrap()
        .iter()
        .find(|found| (number(&found["frequency_hz"]) / 492.0 - 1.0).abs() < 0.01)
        .unwrap();
    assert_eq!(peak["resonance"], "peak of the measured receptance");
    assert!(number(&peak["damping_ratio"]) > 0.01 && number(&peak["resolution_hz"]) > 0.1);
    // 498 Hz at 100 km/h is 55.8 mm.
    record(&sandbox, "rail.csv", 100.0 / 3.6 / 498.0, 8.0);
    let document = sandbox.json(&format!(
        "diagnose cases/discrete-supports.toml {measured} --roughness rail.csv --speed \"100 km/h\" --json"
    ));
    let finding = &document["dominant_wavelengths"][0];
    let peaks = share(finding, "peak of the measured receptance");
    assert!(peaks > 3.0 * share(finding, "grinding mark"), "{finding}");
    let text = document.to_string();
    assert!(!text.contains("no support") && !text.contains("has none"), "{text}");
    let outcome = sandbox.riffel(&format!("receptance cases/discrete-supports.toml {measured} -o out"));
    assert!(outcome.text.contains("damping %"), "{}", outcome.text);
}

/// 45 mm that swells and fades between sleepers every 0.6 m: 1/λ ± 1/0.6 are its own, and no causes are looked for.
#[test]
fn what_the_supports_make_of_a_wave_is_told_with_it() {
    let sandbox = Sandbox::new();
    record_of(&sandbox, "swelling.csv", |x| 8.0 * (1.0 + (TAU * x / 0.6).cos()) * (TAU * x / 0.045).sin());
    let of = "cases/main-line.toml --set map.wavelength.points=21 --set map.speed.points=5 --roughness swelling.csv";
    let document = sandbox.json(&format!("diagnose {of} --speed \"70 km/h\" --json"));
    let findings = document["dominant_wavelengths"].as_array().unwrap();
    let found = |wavelength: f64| {
        let near = |finding: &&Value| (number(&finding["wavelength_m"]) / wavelength - 1.0).abs() < 0.01;
        findings.iter().find(near).unwrap()
    };
    assert!(found(0.045)["sideband_of_m"].is_null());
    for order in [-1.0, 1.0] {
        let finding = found(1.0 / (1.0 / 0.045 + order / 0.6));
        assert!((number(&finding["sideband_of_m"]) - 0.045).abs() < 1e-4);
        let summary = finding["summary"].as_str().unwrap();
        assert!(summary.starts_with("It comes with 45.0 mm"), "{summary}");
        assert_eq!(finding["candidates"].as_array().unwrap().len(), 0);
    }
    sandbox.riffel(&format!("report {of} --speed \"70 km/h\" -o report.html"));
    let page = std::fs::read_to_string(sandbox.path("report.html")).unwrap();
    let brief = page.split("</section>").next().unwrap();
    assert_eq!(brief.matches("Beside it stand").count(), 1, "{brief}");
    assert!(!brief.contains("It comes with"), "{brief}");
}

/// 50 mm that was ground away between two dates is told behind what is there, and is no mark; the 20 mm that grinding left lead. A year's
/// rise of 1 dB in two single spectra is none.
#[test]
fn what_was_ground_away_does_not_lead() {
    let sandbox = Sandbox::new();
    let survey = |date: &str, fall: f64, corrugation: f64, mark: f64| {
        let levels = (0..20).map(|band| {
            let wavelength = 400.0 * 10f64.powf(-0.1 * f64::from(band));
            let near = |at: f64, height: f64| height * f64::from((wavelength / at).ln().abs() < 0.1);
            let level = 12.0 * (wavelength / 400.0).log10() + 12.0 - fall;
            let own = near(50.0, corrugation) + near(20.0, mark);
            format!("{wavelength:.1},left,{date},{:.2}\n", level + own)
        });
        let table = levels.collect::<String>();
        let head = "wavelength_mm,rail,date,level_db\n";
        std::fs::write(sandbox.path(&format!("{date}.csv")), format!("{head}{table}")).unwrap();
    };
    survey("2026-05-04", 0.0, 9.0, 0.0);
    survey("2026-06-20", 5.0, 0.0, 6.0);
    let told = |more: &str| {
        sandbox.json(&format!(
            "diagnose cases/main-line.toml --roughness 2026-06-20.csv --earlier 2026-05-04.csv \
             --dates 2026-05-04,2026-06-20 --speed \"140 km/h\" --json{more}"
        ))
    };
    let document = told("");
    let [there, gone] = &document["dominant_wavelengths"].as_array().unwrap()[..] else {
        panic!("{document}");
    };
    assert!((number(&there["wavelength_m"]) - 0.02).abs() < 1e-6, "{there}");
    assert!(share(there, "grinding mark") > 0.5, "{there}");
    let course = there["course"]["sentence"].as_str().unwrap();
    assert!(course.contains("two records do not tell whether it rises"), "{course}");
    assert!((number(&gone["wavelength_m"]) - 0.05).abs() < 1e-6, "{gone}");
    let summary = gone["summary"].as_str().unwrap();
    assert!(summary.starts_with("Gone by grinding: its level fell by 14.0 dB before 2026-06-20.csv"), "{summary}");
    let candidates = gone["candidates"].as_array().unwrap();
    assert!(candidates.iter().all(|one| one["mechanism"] != "grinding mark"), "{gone}");
    // Where it is there again, or has never gone, it is no more behind.
    survey("2026-06-20", 0.0, 9.0, 6.0);
    let document = told("");
    let first = &document["dominant_wavelengths"][0];
    assert!((number(&first["wavelength_m"]) - 0.05).abs() < 1e-6, "{document}");
}

/// 45 mm that grows by 2 dB a year before it is ground and after: no mark that fades.
// Long: makes and reads records of 40 000 heights at four dates.
#[test]
fn a_rail_that_was_ground_grows_again() {
    let sandbox = Sandbox::new();
    for (year, level) in [(2022, 22.0), (2023, 24.0), (2024, 8.0), (2025, 10.0)] {
        let amplitude = 2f64.sqrt() * 10f64.powf(level / 20.0);
        record(&sandbox, &format!("{year}.csv"), 0.045, amplitude);
    }
    let earlier = "--earlier 2022.csv --earlier 2023.csv --earlier 2024.csv";
    let dates = "--dates 2022-01-01,2023-01-01,2024-01-01,2025-01-01";
    let document = sandbox.json(&format!(
        "diagnose cases/main-line.toml --roughness 2025.csv {earlier} {dates} --speed \"70 km/h\" --json"
    ));
    let finding = &document["dominant_wavelengths"][0];
    let course = &finding["course"];
    assert_eq!(course["ground_before"], "2024-01-01");
    assert!((number(&course["slope_db"]) - 2.0).abs() < 0.3, "{course}");
    let summary = finding["summary"].as_str().unwrap();
    assert!(!summary.contains("fading"), "{summary}");
    assert_ne!(finding["candidates"][0]["mechanism"], "grinding mark");
    // Of two records between which it was ground nothing is known of its growth.
    let document = sandbox.json(
        "diagnose cases/main-line.toml --roughness 2024.csv --earlier 2023.csv \
         --dates 2023-01-01,2024-01-01 --speed \"70 km/h\" --json",
    );
    let finding = &document["dominant_wavelengths"][0];
    assert!(finding["course"]["slope_db"].is_null(), "{finding}");
    assert!(finding["course"]["probability_of_rise"].is_null());
}

#[test]
fn noise_has_no_dominant_wavelength() {
    let sandbox = Sandbox::new();
    record(&sandbox, "noise.csv", 0.05, 0.0);
    let outcome = sandbox.riffel("diagnose cases/nominal.toml --roughness noise.csv --speed \"100 km/h\" -o out");
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    assert!(outcome.text.contains("no dominant wavelength"), "{}", outcome.text);
    assert_eq!(
        sandbox.list("out"),
        ["candidates.csv", "diagnosis.html", "diagnosis.json", "diagnosis.png", "diagnosis.svg", "places.csv"]
    );
}

// Long: starts the program eleven times, most with a record of 40 000 heights.
#[test]
fn bad_input_is_refused_and_leaves_nothing() {
    let sandbox = Sandbox::new();
    sandbox.copy("validation/reference/sbb-track-noise");
    record(&sandbox, "good.csv", 0.05, 5.0);
    for (arguments, part) in [
        ("--roughness missing.csv", "missing.csv"),
        ("--roughness good.csv --speed fast", "--speed"),
        ("--roughness good.csv --speed \"0 km/h\"", "must be between 0.01 m/s and 200 m/s"),
        ("--roughness good.csv --speed \"90 km/h..60 km/h\"", "from the slower"),
        ("--roughness good.csv --torsion=\"-5 Hz\"", "--torsion"),
        ("--roughness good.csv --earlier missing.csv", "missing.csv"),
        ("--roughness good.csv --earlier good.csv --dates 2024-01-01", "2 dates"),
        ("--roughness good.csv --earlier good.csv --dates 2024-01-01,yesterday", "yesterday"),
        (&format!("--roughness good.csv --earlier {SBB}"), "both must be the same"),
        (&format!("--roughness {SBB} --where laboratory=NOBODY"), "no spectrum has"),
        (&format!("--roughness {SBB} --by moon"), "no column"),
    ] {
        let outcome = sandbox.riffel(&format!("diagnose cases/nominal.toml {arguments} -o out"));
        let words = outcome.text.split_whitespace().filter(|word| *word != "│");
        let sentence = words.collect::<Vec<_>>().join(" ");
        assert_eq!(outcome.status, Some(2), "{arguments}: {sentence}");
        assert!(sentence.contains(part), "{arguments}: {sentence}");
    }
    assert_eq!(sandbox.list("."), ["cases", "good.csv", "validation"]);
}

/// What a case predicts does not hang on the window of its map, which is for the eye.
// Long: reads a record of 40 000 heights in four windows.
#[test]
fn the_window_of_the_map_does_not_choose_the_cause() {
    let sandbox = Sandbox::new();
    record(&sandbox, "rail.csv", 0.045, 9.0);
    let finding = |window: &str| {
        let document = sandbox.json(&format!(
            "diagnose cases/nominal.toml --roughness rail.csv --speed \"40 km/h..50 km/h\" --json \
             --set 'map.wavelength={{{window}}}'"
        ));
        document["dominant_wavelengths"][0]["candidates"].clone()
    };
    let wide = finding("min=\"20 mm\",max=\"200 mm\"");
    assert_eq!(wide, finding("min=\"20 mm\",max=\"80 mm\""));
    assert_eq!(wide, finding("min=\"40 mm\",max=\"50 mm\""));
    // The measured wavelength lies outside.
    assert_eq!(wide, finding("min=\"60 mm\",max=\"100 mm\""));
}
