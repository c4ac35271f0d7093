//! Roughness from axle-box acceleration, from the command line to the files.

use std::f64::consts::TAU;

use serde_json::Value;

use crate::sandbox::{Sandbox, number};

/// \[m/s\].
const SPEED: f64 = 20.0;

/// A wheel of the nominal case at 72 km/h along a rail with a wave of 3 µm and 100 mm and some noise, as its axle box feels
/// it: `simulate` gives the normal force, which shakes the wheel of 350 kg.
fn run(sandbox: &Sandbox, wavelength: f64) -> Vec<f64> {
    let rows = (0..60_000).map(|row| {
        let x = 1e-3 * f64::from(row);
        let noise: f64 = (1..40)
            .map(|wave| {
                let k = 3.0 * 1.13f64.powi(wave);
                0.05 * (TAU * k * x + f64::from(wave * wave)).sin()
            })
            .sum();
        let height = 3.0 * (TAU * x / wavelength).sin() + noise;
        format!("{x:.3},{height:.6}\n")
    });
    let text = format!("position_m,height_um\n{}", rows.collect::<String>());
    std::fs::write(sandbox.path("profile.csv"), text).unwrap();
    let document = sandbox.json(&format!("simulate cases/nominal.toml --speed {SPEED} --profile profile.csv --json"));
    let forces: Vec<f64> = serde_json::from_value(document["normal_force_n"].clone()).unwrap();
    forces.iter().map(|force| (force - 50e3) / 350.0).collect()
}

fn write(sandbox: &Sandbox, name: &str, head: &str, row: impl Fn(f64, f64) -> String, run: &[f64]) {
    let rows = run.iter().enumerate().map(|(index, acceleration)| {
        let time = 1e-3 * index as f64 / SPEED;
        row(time, *acceleration)
    });
    let text = format!("{head}\n{}", rows.collect::<String>());
    std::fs::write(sandbox.path(name), text).unwrap();
}

/// Level of the band about 100 mm.
fn at_100_mm(spectrum: &Value) -> f64 {
    let levels = spectrum.as_array().unwrap().iter();
    let mut near = levels.filter(|level| (number(&level["wavelength_m"]) - 0.1).abs() < 1e-6);
    number(&near.next().unwrap()["level_db"])
}

/// A wave of 3 µm is 10 lg(9/2) = 6.53 dB re 1 µm; noise in its band adds 0.01 dB, the regularisation takes 0.1 dB. What is
/// written goes on into the commands for trolleys.
// Long: turns five records of 60 000 accelerations into rails.
#[test]
fn a_wave_is_found_and_goes_on() {
    let sandbox = Sandbox::new();
    let run = run(&sandbox, 0.1);
    let head = "time_s,acceleration_left_m_per_s2,speed_km_per_h";
    write(&sandbox, "run.csv", head, |time, value| format!("{time:.6},{value:.6},72\n"), &run);
    let of = "axlebox run.csv --case cases/nominal.toml";
    let written = sandbox.riffel(&format!("{of} -o out"));
    assert_eq!(written.status, Some(0), "{}", written.text);
    let text = std::fs::read_to_string(sandbox.path("out/summary.json")).unwrap();
    let document: Value = serde_json::from_str(&text).unwrap();
    let rail = &document["rails"][0];
    assert_eq!(rail["name"], "left");
    let level = at_100_mm(&rail["spectrum"]);
    assert!((level - 6.53).abs() < 0.3, "{level}");
    let band = &rail["bands"][1];
    assert_eq!(number(&band["from_m"]), 0.03);
    assert!((number(&rail["mean_speed_m_per_s"]) - SPEED).abs() < 1e-3);

    let roughness = sandbox.json("roughness out/spectrum.csv --json");
    assert!((at_100_mm(&roughness["spectrum"]) - level).abs() < 1e-9);
    for on in [
        "diagnose cases/nominal.toml --roughness out/spectrum.csv --speed \"72 km/h\" -o diagnosis",
        "forecast cases/nominal.toml --spectrum out/spectrum.csv --traffic cases/traffic.toml -o forecast",
    ] {
        let outcome = sandbox.riffel(on);
        assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    }

    // In g, with decimal commas, and by an odometer in steps of a centimetre.
    let head = "time_ms;Beschleunigung links [g];odometer_m";
    let row = |time: f64, value: f64| {
        let odometer = (100.0 * SPEED * time).floor() / 100.0;
        format!("{:.3};{:.7};{odometer:.2}\n", 1e3 * time, value / 9.80665).replace('.', ",")
    };
    write(&sandbox, "counted.csv", head, row, &run);
    let counted = sandbox.json("axlebox counted.csv --case cases/nominal.toml --json");
    let other = at_100_mm(&counted["rails"][0]["spectrum"]);
    assert!((other - level).abs() < 0.1, "{other} {level}");

    // Times rounded to two samples have the rate of all rows, which may be said.
    let rounded = |time: f64, value: f64| format!("{time:.4},{value:.6},72\n");
    let head = "time_s,acceleration_left_m_per_s2,speed_km_per_h";
    write(&sandbox, "rounded.csv", head, rounded, &run);
    for rate in ["", "--rate \"20 kHz\""] {
        let of = format!("axlebox rounded.csv --case cases/nominal.toml {rate} --json");
        let other = at_100_mm(&sandbox.json(&of)["rails"][0]["spectrum"]);
        assert!((other - level).abs() < 0.01, "{rate}: {other} {level}");
    }

    // Pads are no part of a free beam: they leave nothing open.
    let first = &rail["spectrum"][0];
    assert_eq!(first["lowest_db"], first["level_db"]);
    let preset = "--set track.model=two-layer --set track.preset=ballasted-stiff-pads --json";
    let document = sandbox.json(&format!("{of} {preset}"));
    let levels = document["rails"][0]["spectrum"].as_array().unwrap().iter();
    let open = levels.map(|level| number(&level["highest_db"]) - number(&level["lowest_db"]));
    assert!(open.fold(0.0, f64::max) > 0.5);
}

// Long: starts the program for every bad run.
#[test]
fn bad_runs_are_refused_and_nothing_is_written() {
    let sandbox = Sandbox::new();
    let noise: Vec<f64> = (0..4_000).map(|row| f64::from((row * 7919) % 1000) / 100.0 - 5.0).collect();
    let case = "--case cases/nominal.toml";
    let head = "time_s,acceleration_m_per_s2,speed_km_per_h";
    let at = |speed: f64| move |time: f64, value: f64| format!("{time:.6},{value},{speed}\n");
    write(&sandbox, "standing.csv", head, at(0.0), &noise);
    write(&sandbox, "backward.csv", head, at(-72.0), &noise);
    write(&sandbox, "run.csv", head, at(72.0), &noise);
    write(&sandbox, "nowhere.csv", "time_s,acceleration_m_per_s2,fuel", at(1.0), &noise);
    write(&sandbox, "gravity.csv", head, |time, value| format!("{time:.6},{},72\n", 0.01 * value + 1.0), &noise);
    write(
        &sandbox,
        "resting.csv",
        head,
        |time, value| format!("{time:.6},{:.7},72\n", 1e-4 * value),
        &[&noise[..]; 30].concat(),
    );
    write(
        &sandbox,
        "contrary.csv",
        "time_s,acceleration_m_per_s2,speed_km_per_h,odometer_m",
        |time, value| format!("{time:.6},{value},72,{:.4}\n", 40.0 * time),
        &noise,
    );
    write(
        &sandbox,
        "losing.csv",
        head,
        |time, value| format!("{:.6},{value},72\n", time + 0.037 * (time / 0.04).floor()),
        &noise,
    );
    for (arguments, words) in [
        ("axlebox resting.csv", "no rail is so smooth"),
        (
            "axlebox contrary.csv",
            "the odometer makes 144.0 km/h in the mean, but the speeds make 72.0 km/h in the mean: one of the two is wrong",
        ),
        ("axlebox losing.csv", "samples are lost where the time leaps 4 times"),
        ("axlebox standing.csv", "the train never runs faster than 20.0 km/h"),
        ("axlebox backward.csv", "the speed is -20 m/s, but must be zero or greater"),
        ("axlebox nowhere.csv", "there is no column of speeds or of an odometer"),
        ("axlebox gravity.csv", "as gravity is in g"),
        ("axlebox run.csv --rate \"100 Hz\"", "the times make 20000 samples a second, but --rate says"),
        ("axlebox run.csv --rate \"-1 Hz\"", "--rate is -1 Hz, but must be greater than zero"),
        ("axlebox run.csv --longest \"15 mm\"", "--longest is 0.015 m, but must be at least twice"),
        ("axlebox none.csv", "none.csv"),
    ] {
        let outcome = sandbox.riffel(&format!("{arguments} {case} -o out"));
        assert_eq!(outcome.status, Some(2), "{arguments}: {}", outcome.text);
        assert!(outcome.sentence().contains(words), "{arguments}: {}", outcome.text);
        assert!(!sandbox.path("out").exists(), "{arguments}");
    }
}
