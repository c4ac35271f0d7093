//! Forecasts with an earlier record: what grew since, and the wear coefficient.

use std::fs;

use serde_json::Value;

use super::{MEASURED, sandbox};
use crate::sandbox::{Sandbox, number};

/// The 20 mm of Niederwangen fades: no wear coefficient is claimed, and the page says why.
#[test]
fn a_fading_grinding_mark_is_not_fitted() {
    let sandbox = sandbox();
    let command =
        format!("forecast cases/nominal.toml {MEASURED} --date-column date --traffic cases/traffic.toml --json");
    let document = sandbox.json(&command);
    let fit = &document["wear_fit"];
    assert_eq!(fit["paired"], true);
    assert_eq!(fit["records_earlier"], 4);
    // 2014-03-01 to 2015-10-01.
    assert_eq!(number(&fit["passages_between"]), 579.0 * 6000.0);
    assert!(fit["coefficient_kg_per_j"].is_null());
    assert!(fit["verdict"] == "against" || fit["verdict"] == "indistinct", "{fit}");
    let mark = &fit["bands"][0];
    assert!((number(&mark["wavelength_m"]) - 0.019_953).abs() < 1e-6);
    assert!((number(&mark["measured_change_db"]) + 7.8).abs() < 0.1);
    let sentences = fit["sentences"].to_string();
    assert!(sentences.contains("no wear coefficient"), "{sentences}");
    assert!(sentences.contains("20 mm fades"), "{sentences}");
}

/// A rail that grows twice as fast as the model says gives twice the coefficient.
#[test]
fn the_coefficient_of_two_dates_is_found() {
    let sandbox = sandbox();
    let forecast = |arguments: &str| {
        sandbox.json(&format!("forecast cases/nominal.toml --traffic cases/traffic.toml --json {arguments}"))
    };
    let write = |name: &str, document: &Value, key: &str| {
        let mut text = "section,wavelength_m,level_db\n".to_owned();
        for level in document[key].as_array().unwrap() {
            for (section, more) in [("A", 0.4), ("B", -0.1), ("C", -0.2), ("D", 0.3)] {
                let own = number(&level["level_db"]) + more * f64::from(key == "spectrum_then");
                text += &format!("{section},{},{own}\n", level["wavelength_m"]);
            }
        }
        fs::write(sandbox.path(name), text).unwrap();
    };
    // Of one date, for a rail of several goes on as it was measured.
    let future = forecast(&format!("{MEASURED} --where date=2015-10-01 --passages 8e6"));
    write("now.csv", &future, "spectrum_now");
    write("then.csv", &future, "spectrum_then");
    let found = forecast("--spectrum then.csv --earlier now.csv --passages-between 4e6");
    let fit = &found["wear_fit"];
    assert_eq!(fit["verdict"], "fitted", "{fit}");
    let interval = &fit["coefficient_interval_kg_per_j"];
    let (low, high) = (number(&interval[0]), number(&interval[1]));
    assert!(low < 5e-9 && 5e-9 < high, "{fit}");
    assert!((number(&fit["coefficient_kg_per_j"]) / 5e-9 - 1.0).abs() < 0.05, "{fit}");
}

/// Two profiles are as many records as they have places in common, whose growth tells the coefficient.
// Long: reads 160 000 heights, as many as nine places of 10 m have.
#[test]
fn profiles_are_fitted_place_by_place() {
    let sandbox = sandbox();
    // A wave of 63 mm, higher from place to place, on a rough floor that stays as it is.
    let write = |name: &str, from: u32, to: u32, gain: f64| {
        let mut text = "position_m,left_um\n".to_owned();
        let mut floor = 1_u32;
        for sample in from * 500..to * 500 {
            let position = f64::from(sample) / 500.0;
            floor = floor.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let height = 2.0 + (position / 10.0).floor() % 7.0;
            let wave = gain * height * (std::f64::consts::TAU * position / 0.063).cos();
            let rough = f64::from(floor >> 8) / f64::from(1_u32 << 24) - 0.5;
            text += &format!("{position:.3},{:.4}\n", wave + rough);
        }
        fs::write(sandbox.path(name), text).unwrap();
    };
    write("before.csv", 995, 1092, 1.0);
    write("now.csv", 1000, 1100, 1.4);
    let command = "forecast cases/nominal.toml --spectrum now.csv --earlier before.csv --passages-between 4e6 \
                   --traffic cases/traffic.toml --json";
    let document = sandbox.json(command);
    let fit = &document["wear_fit"];
    assert_eq!(fit["verdict"], "fitted", "{fit}");
    assert_eq!(fit["paired"], true);
    // 1000 to 1090 m.
    assert_eq!(fit["records_earlier"], 9);
    assert_eq!(fit["records_later"], 9);
    let bands = fit["bands"].as_array().unwrap();
    let band = |wavelength: f64| {
        let is = |band: &&Value| (number(&band["wavelength_m"]) / wavelength - 1.0).abs() < 0.01;
        bands.iter().find(is).unwrap()
    };
    let grown = number(&band(0.0631)["measured_change_db"]);
    assert!((grown - 20.0 * 1.4_f64.log10()).abs() < 0.05, "{grown}");
    // Two places are too few, and there is one record of each rail as before.
    write("short.csv", 1000, 1022, 1.4);
    let short = sandbox.json(&command.replace("now.csv", "short.csv"));
    assert_eq!(short["wear_fit"]["records_later"], 1);
}

/// What was measured on several dates is now at its latest, and no mean of years.
#[test]
fn now_is_the_latest_date() {
    let sandbox = Sandbox::new();
    let text = "rail,date,80 mm,63 mm,50 mm,40 mm\n\
                L,2026-01-15,1,1,14,1\n\
                L,2024-01-15,1,1,0,1\n\
                R,2026-01-14,1,1,3,1\n\
                R,2024-01-15,1,1,0,1\n";
    fs::write(sandbox.path("dated.csv"), text).unwrap();
    let document = sandbox.json("forecast cases/nominal.toml --spectrum dated.csv --traffic cases/traffic.toml --json");
    let at_50 = |rail: &Value| {
        let bands = rail["bands"].as_array().unwrap();
        let near = |row: &&Value| (number(&row["wavelength_m"]) - 0.05).abs() < 1e-3;
        number(&bands.iter().find(near).unwrap()["level_now_db"])
    };
    let rails: Vec<f64> = document["rails"].as_array().unwrap().iter().map(at_50).collect();
    // The mean of one level passes through its energy.
    let is = |found: f64, level: f64| (found - level).abs() < 1e-9;
    assert!(is(rails[0], 14.0) && is(rails[1], 3.0), "{rails:?}");
    assert!(document["remarks"].to_string().contains("now is the latest of each rail, 2026-01-15"));
    // Nor does a limit hold for a mean of years.
    let document = sandbox.json("roughness dated.csv --json");
    let groups = document["groups"].as_array().unwrap();
    let names: Vec<&str> = groups.iter().map(|group| group["group"].as_str().unwrap()).collect();
    assert_eq!(names, ["date 2024-01-15", "date 2026-01-14", "date 2026-01-15"]);
}

/// One record of each date gives a best fit and no claim; levels that stay have not fallen.
#[test]
fn two_records_claim_no_coefficient() {
    let sandbox = Sandbox::new();
    let sentence = |change: f64| {
        let rows = [("2025-01-15", 0.0), ("2026-01-15", change)].map(|(date, change)| {
            let levels = [80.0, 63.0, 50.0].map(|length| format!("{date},{length},{change}\n"));
            levels.concat()
        });
        let text = format!("date,wavelength_mm,level_db\n{}", rows.concat());
        fs::write(sandbox.path("dated.csv"), text).unwrap();
        let document = sandbox.json(
            "forecast cases/nominal.toml --spectrum dated.csv --date-column date \
             --traffic cases/traffic.toml --json",
        );
        document["findings"].to_string() + &document["wear_fit"].to_string()
    };
    let grown = sentence(3.0);
    assert!(grown.contains("no wear coefficient is claimed"), "{grown}");
    let same = sentence(0.0);
    assert!(same.contains("have not moved") && !same.contains("have fallen"), "{same}");
    let fallen = sentence(-3.0);
    assert!(fallen.contains("have fallen"), "{fallen}");
}

/// Two welds are no roughness that grows: forecast and noise leave them out and say so, unless they are kept.
// Long: reads 30 000 heights at two dates for each of its questions.
#[test]
fn welds_do_not_grow() {
    let sandbox = Sandbox::new();
    let mut text = "position [m],height [um]\n".to_owned();
    let mut random = 1u32;
    for sample in 0..30_000u32 {
        random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let x = 2e-3 * f64::from(sample);
        let noise = f64::from(random >> 16) / 65_536.0 - 0.5;
        let slow = 2.0 * (x / 0.11).sin() * (x / 0.7).cos();
        let dips = [17.0, 41.0].map(|at| (1.0 - (x - at).abs() / 0.1).max(0.0));
        text += &format!("{x:.3},{:.3}\n", noise + slow - 300.0 * (dips[0] + dips[1]));
    }
    fs::write(sandbox.path("welds.csv"), text).unwrap();
    let level = |kept: &str| {
        let document = sandbox.json(&format!(
            "forecast cases/metro.toml --traffic cases/traffic.toml --spectrum welds.csv --json {kept}"
        ));
        let bands = document["bands"].as_array().unwrap();
        let near = |band: &&Value| (number(&band["wavelength_m"]) - 0.16).abs() < 0.01;
        number(&bands.iter().find(near).unwrap()["level_now_db"])
    };
    assert!(level("--keep-defects") > level("") + 6.0);
    let outcome = sandbox.riffel("noise cases/metro.toml --speed \"80 km/h\" --roughness welds.csv");
    assert!(outcome.text.contains("2 welds, joints or squats: 17.0 m (-299 µm), 41.0 m (-300 µm)"), "{}", outcome.text);
}
