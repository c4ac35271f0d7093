//! Rolling noise, from the command line to the files.

use serde_json::Value;

use crate::sandbox::{Sandbox, number};

const CASE: &str = "noise cases/main-line.toml --speed \"136 km/h\"";
const MEASURED: &str = "--roughness validation/reference/sbb-track-noise/rail_roughness.csv --where laboratory=MBBM";

fn sandbox() -> Sandbox {
    let sandbox = Sandbox::new();
    sandbox.copy("validation/reference/sbb-track-noise");
    sandbox
}

fn numbers(value: &Value) -> Vec<f64> {
    serde_json::from_value(value.clone()).unwrap()
}

/// A track on direct fastenings has no sleepers, and none are told of.
#[test]
fn levels_are_told_of_what_is_there() {
    let sandbox = sandbox();
    let sleepers = |case: &str| {
        let outcome = sandbox.riffel(&format!("noise {case} --speed \"80 km/h\" {MEASURED}"));
        let lines = outcome.text.lines().map(str::trim_start);
        // Below the levels by band.
        let parts = lines.skip_while(|line| !line.starts_with("what radiates"));
        let rows: Vec<&str> = parts.skip(2).take(3).collect();
        assert!(rows[0].starts_with("rail "), "{}", outcome.text);
        rows[1].starts_with("sleepers ")
    };
    assert!(!sleepers("cases/metro.toml"));
    assert!(sleepers("cases/main-line.toml"));
}

/// Levels of the parts add up to the total, and a rail 10 dB rougher than its wheels is 10 dB louder.
#[test]
fn levels_add_up_and_follow_the_roughness() {
    let sandbox = sandbox();
    let document = sandbox.json(&format!("{CASE} {MEASURED} --json"));
    let level = &document["level"];
    let parts = ["rail_db", "sleepers_db", "wheel_db"].map(|part| numbers(&level[part]));
    for (place, total) in numbers(&level["total_db"]).iter().enumerate() {
        let sum: f64 = parts.iter().map(|part| 10f64.powf(0.1 * part[place])).sum();
        assert!((10.0 * sum.log10() - total).abs() < 1e-9);
    }
    assert_eq!(numbers(&document["left_out_hz"]), [100.0]);
    // A wheel of the power W on either rail, one in 6.6 m of train: p² = 2ρc W/(4 · 6.6 m)(1/d₁ + 1/d₂), over hard ground.
    let power = &document["sound_power_level"];
    let distances = [6.75f64, 8.25].map(|across| across.hypot(1.2).recip());
    let mean_square = 2.0 * 1.204 * 343.2 * 1e-12 / (4.0 * 6.6) * (distances[0] + distances[1]);
    let apart = 10.0 * (mean_square / 4e-10).log10();
    for part in ["rail", "sleepers", "wheel", "total"] {
        let levels = [level, power].map(|levels| numbers(&levels[format!("{part}_db")]));
        for (pressure, power) in levels[0].iter().zip(&levels[1]) {
            assert!((pressure - power - apart).abs() < 1e-9, "{part}");
        }
        let [pressure, power] = [level, power].map(|levels| number(&levels[format!("{part}_dba")]));
        assert!((pressure - power - apart).abs() < 1e-9, "{part}");
    }

    let table = |level: f64| -> String {
        let rows: Vec<String> =
            (5..=25).map(|tenth| format!("{:.3},{level}", 1e3 * 10f64.powf(-0.1 * f64::from(tenth)))).collect();
        format!("wavelength_mm,level_db\n{}\n", rows.join("\n"))
    };
    let of = |level: f64| {
        std::fs::write(sandbox.path("flat.csv"), table(level)).unwrap();
        let document = sandbox.json(&format!("{CASE} --roughness flat.csv --json"));
        number(&document["level"]["total_dba"])
    };
    assert!((of(5.0) - of(-5.0) - 10.0).abs() < 1e-6);
}

/// Grinding a rail that is everywhere above the limit by as much saves as much; dampers save 3 dB of the track.
#[test]
fn measures_save_what_they_change() {
    let sandbox = sandbox();
    let limit =
        std::fs::read_to_string(crate::sandbox::root().join("crates/riffel-rail/limits/iso-3095-2013.toml")).unwrap();
    let mut rows = "wavelength_mm,level_db\n".to_owned();
    let mut wavelength = "";
    for line in limit.lines() {
        if let Some(rest) = line.strip_prefix("wavelength = \"") {
            wavelength = rest.strip_suffix(" mm\"").unwrap();
        }
        if let Some(level) = line.strip_prefix("level_db = ") {
            let level: f64 = level.parse().unwrap();
            rows += &format!("{wavelength},{}\n", level + 7.0);
        }
    }
    std::fs::write(sandbox.path("rough.csv"), rows).unwrap();
    let document = sandbox.json(&format!("{CASE} --roughness rough.csv --json"));
    let saved = |word: &str| {
        let measures = document["measures"].as_array().unwrap().iter();
        let mut found = measures.filter(|measure| measure["title"].as_str().unwrap().contains(word));
        number(&found.next().unwrap()["saved_db"])
    };
    assert!((saved("ground to") - 7.0).abs() < 1e-9);
    // The wheel stays.
    assert!((2.9..3.011).contains(&saved("dampers")));
    assert!(saved("109 km/h") > 0.0);
}

/// Measured decay rates take the place of the model's, and the course of a level ends where it began without growth.
#[test]
fn decay_rates_and_traffic_are_read() {
    let sandbox = sandbox();
    let rates: Vec<String> = (20..=37).map(|index| format!("{:.1},30", 10f64.powf(0.1 * f64::from(index)))).collect();
    let rates = format!("frequency_hz,decay_rate_db_per_m\n{}\n", rates.join("\n"));
    std::fs::write(sandbox.path("decay.csv"), rates).unwrap();
    let by_model = sandbox.json(&format!("{CASE} {MEASURED} --json"));
    let damped = sandbox.json(&format!("{CASE} {MEASURED} --decay-rate decay.csv --json"));
    let level = |document: &Value| number(&document["level"]["rail_dba"]);
    assert!(level(&damped) < level(&by_model) - 3.0);

    let written =
        sandbox.riffel(&format!("{CASE} {MEASURED} --traffic cases/traffic.toml --months 6 --limit-dba 20 -o out"));
    assert_eq!(written.status, Some(0), "{}", written.text);
    assert!(written.text.contains("20 dB(A) are reached now"), "{}", written.text);
    let text = std::fs::read_to_string(sandbox.path("out/summary.json")).unwrap();
    let document: Value = serde_json::from_str(&text).unwrap();
    let months = numbers(&document["course"]["month"]);
    assert_eq!((months[0], months[24]), (0.0, 6.0));
    let first = numbers(&document["course"]["total_dba"])[0];
    assert!((first - number(&document["level"]["total_dba"])).abs() < 1e-9);
    let bands = std::fs::read_to_string(sandbox.path("out/bands.csv")).unwrap();
    assert_eq!(bands.lines().count(), 18);
}

/// The end of the linear range, and the month of a limit, do not hang on how far one looks ahead.
// Long: computes the noise of a track on discrete supports over its months four times.
#[test]
fn months_do_not_hang_on_the_time_looked_ahead() {
    let sandbox = sandbox();
    let course = |months: &str| {
        sandbox.json(&format!("{CASE} {MEASURED} --traffic cases/traffic.toml --months {months} --limit-dba 87 --json"))
            ["course"]
            .clone()
    };
    let (short, long) = (course("400"), course("500"));
    let limit = |course: &Value| number(&course["months_to_limit"]);
    assert!((limit(&short) / limit(&long) - 1.0).abs() < 1e-4, "{short} {long}");
    let (far, farther) = (course("3000"), course("9000"));
    assert_eq!(far["beyond_linear_range"], true);
    assert_eq!(far["month"], farther["month"]);
}

/// What a track or an amplitude takes beyond the model is told.
#[test]
fn levels_beyond_the_model_are_told() {
    let sandbox = sandbox();
    let rough = "wavelength_mm,level_db\n40,50\n50,50\n63,50\n80,50\n100,50\n";
    std::fs::write(sandbox.path("rough.csv"), rough).unwrap();
    let told = |options: &str| sandbox.riffel(&format!("{CASE} {options}")).text;
    let text = told("--roughness rough.csv");
    assert!(text.contains("beyond the linear range: |P₁| is"), "{text}");
    let undamped = "--set track.pad.damping=0 --set track.pad.loss_factor=0";
    let text = told(&format!("{MEASURED} {undamped}"));
    assert!(text.contains("beyond 66 bays"), "{text}");
    let text = told(&format!("{MEASURED} --rail-foot 150"));
    assert!(text.contains("--rail-foot"), "{text}");
}

/// A rail without support carries its vibration on without end: a level would be that of where its length is cut. Decay rates of
/// one's own give it one.
#[test]
fn a_rail_without_support_has_no_level_of_its_own() {
    let sandbox = sandbox();
    let command = format!("noise cases/nominal.toml --speed \"136 km/h\" {MEASURED} --json -o out");
    let refused = sandbox.riffel(&command);
    assert_eq!(refused.status, Some(2), "{}", refused.text);
    let sentence = refused.sentence();
    assert!(sentence.contains("carries its vibration on without end at every frequency"), "{sentence}");
    assert!(!sandbox.path("out").exists());
    std::fs::write(sandbox.path("decay.csv"), "frequency_hz,decay_rate_db_per_m\n500,2\n630,1.5\n800,1\n1000,0.8\n")
        .unwrap();
    let document = sandbox.json(&format!("{command} --decay-rate decay.csv"));
    assert!(number(&document["level"]["total_dba"]) > 50.0);
}

/// A wheel that rings is louder than a rigid one where it has modes, makes no difference below them, and is listed with dampers.
#[test]
fn wheels_that_ring_are_louder() {
    let sandbox = sandbox();
    let rigid = sandbox.json(&format!("{CASE} {MEASURED} --json"));
    let ringing = sandbox.json(&format!("{CASE} {MEASURED} --wheel-modes straight-web-920 --json"));
    assert_eq!(ringing["wheel_modes"], "straight-web-920");
    let frequencies = numbers(&rigid["frequency_hz"]);
    assert_eq!(frequencies, numbers(&ringing["frequency_hz"]));
    let louder = |part: &str| -> Vec<f64> {
        let [rigid, ringing] = [&rigid, &ringing].map(|document| numbers(&document["level"][part]));
        ringing.iter().zip(rigid).map(|(one, other)| one - other).collect()
    };
    let (wheel, total) = (louder("wheel_db"), louder("total_db"));
    for (place, frequency) in frequencies.iter().enumerate() {
        if *frequency >= 1600.0 {
            assert!(wheel[place] > 30.0, "{frequency} Hz: {} dB", wheel[place]);
        }
        if *frequency <= 160.0 {
            assert!(total[place].abs() < 0.5, "{frequency} Hz: {} dB", total[place]);
        }
    }
    let measures = ringing["measures"].as_array().unwrap();
    let saved = |title: &str| {
        let mut found = measures.iter();
        let measure = found.find(|measure| measure["title"].as_str().unwrap().contains(title));
        number(&measure.unwrap()["saved_db"])
    };
    assert!(saved("wheel dampers") > 1.0);
    // The wheel stays as loud as it was.
    let before = number(&rigid["measures"][3]["saved_db"]);
    assert!(saved("rail dampers") < before - 0.5);
    let remarks = ringing["remarks"].to_string();
    assert!(remarks.contains("wheel of 920 mm"), "{remarks}");

    let refused = sandbox.riffel(&format!("{CASE} {MEASURED} --wheel-modes curved"));
    assert_eq!(refused.status, Some(2), "{}", refused.text);
    let sentence = refused.sentence();
    assert!(sentence.contains("straight-web-920"), "{sentence}");
}

/// Before and after stand in the table, the sentence and the document, also where nothing is remarked, and a sum of bands that end
/// at 1 kHz is told as a lower bound.
#[test]
fn a_change_and_a_lower_bound_are_told() {
    let sandbox = sandbox();
    let table = |name: &str, level: f64, tenths: std::ops::RangeInclusive<i32>| {
        let rows: Vec<String> =
            tenths.map(|tenth| format!("{:.3},{level}", 1e3 * 10f64.powf(-0.1 * f64::from(tenth)))).collect();
        let text = format!("wavelength_mm,level_db\n{}\n", rows.join("\n"));
        std::fs::write(sandbox.path(name), text).unwrap();
    };
    // At 136 km/h, 37.8 m/s, waves down to 28 mm, the end of the band of 31.6 mm, fill the bands up to 1 kHz.
    for (shortest, bound) in [(15, Some(1000.0)), (25, None)] {
        table("before.csv", 5.0, 5..=shortest);
        table("now.csv", -5.0, 5..=shortest);
        let asked = format!("{CASE} --roughness now.csv --before before.csv");
        let document = sandbox.json(&format!("{asked} --json"));
        assert_eq!(document["lower_bound_up_to_hz"].as_f64(), bound);
        // A rail 10 dB smoother is 10 dB quieter: rounding.
        let since = &document["since"];
        assert!((number(&since["change_db"]) + 10.0).abs() < 1e-6);
        assert!((number(&since["now_dba"]) - number(&document["level"]["total_dba"])).abs() < 1e-9);
        let text = sandbox.riffel(&format!("{asked} --quiet")).text;
        assert!(text.contains(" now: -10.0 dB"), "{text}");
        assert!(text.contains("before dB"), "{text}");
        for head in ["≥ dB(A) (up to 1000 Hz)", "saves dB (up to 1000 Hz)"] {
            assert_eq!(text.contains(head), bound.is_some(), "{text}");
        }
    }
}
