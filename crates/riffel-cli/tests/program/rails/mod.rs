//! Several rails of one record: each judged on its own, and where along the line.

mod spectra;

use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::fs;

use serde_json::Value;

use crate::sandbox::{Sandbox, number};

/// Where the low rail is corrugated \[m\].
const CORRUGATED: (f64, f64) = (1200.0, 1240.0);
/// Wavelength \[m\] and amplitude \[µm\] there: 10 lg(7.77²/2) = 14.80 dB.
const WAVELENGTH: f64 = 0.0559;
const AMPLITUDE: f64 = 7.77;

/// White noise within ±1.2 µm, which is −17 dB re 1 µm in the one-third octave at 55 mm where samples are 5 mm apart:
/// SplitMix64 (Steele et al. 2014) of the position in tenths of a millimetre.
fn noise(x: f64, seed: f64) -> f64 {
    let place = (1e4 * x).round() as u64;
    let mut bits = (place ^ seed.to_bits()).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    bits ^= bits >> 31;
    1.2 * (bits as f64 / (u64::MAX as f64) * 2.0 - 1.0)
}

/// Two kilometres of two rails sampled every 5 mm; the low one is corrugated on 40 m.
fn two_kilometres() -> String {
    let mut text = "position [m],high [µm],low [µm]\n".to_owned();
    for row in 0..400_000 {
        let x = 5e-3 * f64::from(row);
        let corrugated = (CORRUGATED.0..CORRUGATED.1).contains(&x);
        let wave = if corrugated { AMPLITUDE * (TAU * x / WAVELENGTH).sin() } else { 0.0 };
        let (high, low) = (noise(x, 1.7), wave + noise(x, 2.3));
        writeln!(text, "{x:.3},{high:.3},{low:.3}").unwrap();
    }
    text
}

fn list<'a>(document: &'a Value, name: &str) -> &'a Vec<Value> {
    document[name].as_array().unwrap()
}

/// 5.5 m of 100 m over the limit: 5.5 % of the low rail, 2.75 % of both. The mean of both rails was within the
/// limit of 5 %.
// Long: reads a record of 100 000 heights for each of a dozen questions.
#[test]
fn a_clean_rail_does_not_excuse_the_other() {
    let sandbox = Sandbox::new();
    let mut text = "position [m],high [µm],low [µm]\n".to_owned();
    for row in 0..100_000 {
        let x = 1e-3 * f64::from(row);
        let wave = 20.0 * (TAU * x / 0.05).sin();
        let low = if (50.0..55.5).contains(&x) { wave } else { 0.05 * wave };
        writeln!(text, "{x:.3},{:.4},{low:.4}", 0.05 * wave).unwrap();
    }
    fs::write(sandbox.path("rails.csv"), text).unwrap();
    let document = sandbox.json("roughness rails.csv --limit grassie-1999 --json");
    assert_eq!(document["worst_rail"], "low");
    let verdicts = list(&document, "verdicts");
    assert_eq!(verdicts.len(), 2);
    assert_eq!(verdicts[0]["rail"], "low");
    assert_eq!(verdicts[0]["within"], false);
    // Windows of 1 m are over 7 µm while a quarter of them is corrugated: 0.25 m more at either end.
    let share = number(&verdicts[0]["share_over_limit"]);
    assert!((0.055..0.062).contains(&share), "{share}");
    assert!(verdicts[0]["sentence"].as_str().unwrap().starts_with("rail low: Grassie"));
    assert_eq!(verdicts[1]["rail"], "high");
    assert_eq!(verdicts[1]["within"], true);
    // Each list says of which rail it speaks, the worst first.
    for (name, count) in [("bands", 8), ("rails", 2)] {
        let rows = list(&document, name);
        assert_eq!(rows.len(), count);
        let key = if name == "rails" { "name" } else { "rail" };
        assert_eq!(rows[0][key], "low");
        assert_eq!(rows[count - 1][key], "high");
    }
    let sections = list(&document["grind"], "sections");
    assert_eq!(sections.len(), 1);
    assert_eq!(sections[0]["rail"], "low");

    let alone = sandbox.json("roughness rails.csv --limit grassie-1999 --rail low --json");
    assert_eq!(list(&alone, "verdicts").len(), 1);
    assert_eq!(number(&list(&alone, "verdicts")[0]["share_over_limit"]), share);
    let other = sandbox.json("roughness rails.csv --limit grassie-1999 --rail high --json");
    assert_eq!(other["verdicts"][0]["within"], true);
    // No part of the record but the bad one, and no place outside it.
    let there =
        sandbox.json("roughness rails.csv --limit grassie-1999 --rail low --from \"51 m\" --to \"54 m\" --json");
    assert!((number(&there["length_m"]) - 3.0).abs() < 2e-3);
    assert_eq!(number(&there["verdicts"][0]["share_over_limit"]), 1.0);

    let outcome = sandbox.riffel("roughness rails.csv --limit grassie-1999 -o out");
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    assert!(outcome.text.contains("worst is rail low, over 1 of 1 limits"), "{}", outcome.text);
    for name in ["grind.csv", "blocks.csv", "spectrum.csv"] {
        let text = fs::read_to_string(sandbox.path(&format!("out/{name}"))).unwrap();
        assert!(text.starts_with("rail,"), "{name}: {text}");
        assert!(text.lines().nth(1).unwrap().starts_with("low,"), "{name}: {text}");
    }
    for (arguments, part) in [
        ("roughness rails.csv --rail middle", "there are high, low"),
        ("roughness rails.csv --from 200", "reaches from 0.000 m to 100.000 m"),
        ("roughness rails.csv --from 60 --to 50", "must rise"),
        ("roughness rails.csv --from 60 --to 60.5", "no stretch of 1 m"),
        ("diagnose cases/nominal.toml --roughness rails.csv --rail middle", "there are high, low"),
        ("report --roughness rails.csv --rail middle", "there are high, low"),
        ("report cases/nominal.toml --rail low", "--roughness"),
    ] {
        let outcome = sandbox.riffel(&format!("{arguments} -o none"));
        let sentence = outcome.sentence();
        assert_eq!(outcome.status, Some(2), "{arguments}: {sentence}");
        assert!(sentence.contains(part), "{arguments}: {sentence}");
    }
    assert_eq!(sandbox.list("."), ["cases", "out", "rails.csv"]);
}

/// Spots of a few decimetres along a kilometre are a few pieces of grinding and not a hundred.
#[test]
fn grinding_is_a_list_of_what_a_train_can_do() {
    let sandbox = Sandbox::new();
    let mut text = "position [m],left [µm]\n".to_owned();
    for row in 0..200_000 {
        let x = 5e-3 * f64::from(row);
        // From 300 m to 500 m half a metre in seven is bad, and another at the very end.
        let bad = (300.0..500.0).contains(&x) && x % 7.0 < 0.5 || x > 999.5;
        let wave = 20.0 * (TAU * x / 0.05).sin();
        writeln!(text, "{x:.3},{:.4}", if bad { wave } else { 0.05 * wave }).unwrap();
    }
    fs::write(sandbox.path("spots.csv"), text).unwrap();
    let document = sandbox.json("roughness spots.csv --json");
    let grind = &document["grind"];
    let sections = list(grind, "sections");
    assert_eq!(sections.len(), 2, "{grind}");
    assert!((number(&sections[0]["from_m"]) - 296.5).abs() < 1.0, "{grind}");
    assert!((number(&sections[0]["to_m"]) - 502.0).abs() < 1.0, "{grind}");
    let end = &sections[1];
    assert!((number(&end["from_m"]) - 990.0).abs() < 0.01 && (number(&end["to_m"]) - 1000.0).abs() < 0.01);
    let total = number(&grind["total_m"]);
    assert!((total - 215.5).abs() < 2.0, "{total}");
    assert!((number(&grind["share_of_length"]) - total / 1000.0).abs() < 1e-6);
    let every = sandbox.json("roughness spots.csv --json --merge 0 --grinding-length 0");
    assert!(list(&every["grind"], "sections").len() > 28);
    let outcome = sandbox.riffel("roughness spots.csv --grinding-length=\"-1 m\"");
    assert_eq!(outcome.status, Some(2), "{}", outcome.text);
}

/// At a long kilometre the places go back from 400 m to 380 m, and 12 m of the second stretch are bad: these are named, told as a share of
/// all 820 m, and kept by a network.
// Long: reads 160 000 heights.
#[test]
fn a_stretch_of_a_long_kilometre_is_named() {
    let sandbox = Sandbox::new();
    let mut text = "position [m],left [µm]\n".to_owned();
    for (from, to, bad) in [(0, 80_000, 0.0..0.0), (76_000, 160_000, 384.0..396.0)] {
        for row in from..to {
            let x = 5e-3 * f64::from(row);
            let wave = (TAU * x / 0.05).sin();
            let factor = if bad.contains(&x) { 20.0 } else { 1.0 };
            writeln!(text, "{x:.3},{:.4}", factor * wave).unwrap();
        }
    }
    fs::write(sandbox.path("long.csv"), text).unwrap();
    let document = sandbox.json("roughness long.csv --json -o out");
    let grind = &document["grind"];
    let [section] = &list(grind, "sections")[..] else {
        panic!("{grind}");
    };
    let length = number(&section["to_m"]) - number(&section["from_m"]);
    assert!((length - 12.0).abs() < 1.0, "{grind}");
    assert_eq!(section["stretch"], 2, "{grind}");
    assert!((number(&grind["total_m"]) - length).abs() < 1e-9);
    let share = length / 820.0;
    for told in [&grind["share_of_length"], &document["rails"][0]["grind_share_of_length"]] {
        assert!((number(told) - share).abs() < 1e-4, "{told} {share}");
    }
    let csv = fs::read_to_string(sandbox.path("out/grind.csv")).unwrap();
    let (head, row) = csv.trim_end().split_once('\n').unwrap();
    assert!(head.ends_with(",stretch") && row.ends_with(",2"), "{csv}");
    let worst = &list(&document, "sections")[0];
    assert_eq!((number(&worst["from_m"]), &worst["stretch"]), (380.0, &2.into()));
    let said = sandbox.riffel("roughness long.csv -o again").text;
    assert!(said.contains("left, stretch 2"), "{said}");
    assert!(said.contains("at worst 380–500 m on stretch 2"), "{said}");
    assert!(said.contains("in all 12.") && said.contains(" m of line to grind, 1.5 % of"), "{said}");
    let kept = sandbox.riffel("network ingest store out/blocks.csv --line A --date 2026-01-31");
    assert_eq!(kept.status, Some(0), "{}", kept.text);
}

/// A report draws the moving RMS of each rail with its limits.
// Long: reads two kilometres of two rails twice.
#[test]
fn a_report_shows_the_moving_rms_of_each_rail() {
    let sandbox = Sandbox::new();
    fs::write(sandbox.path("line.csv"), two_kilometres()).unwrap();
    let drawn = |limit: &str| {
        let outcome = sandbox.riffel(&format!("report --roughness line.csv --limit {limit} -o report.html"));
        assert_eq!(outcome.status, Some(0), "{}", outcome.text);
        let html = fs::read_to_string(sandbox.path("report.html")).unwrap();
        assert!(html.contains("nearest to them is rail low"));
        let (_, strip) = html.split_once("Moving RMS along the line").unwrap();
        strip.split_once("Spectrum and limits").unwrap().0.to_owned()
    };
    let strip = drawn("grassie-1999");
    let place = |rail: &str| strip.find(&format!(">{rail}<")).unwrap();
    assert!(place("low") < place("high"), "the worst rail is not first");
    // Limits of the RMS are lines of the drawing; those of levels are not.
    let lines = |strip: &str| strip.matches("<polyline").count() + strip.matches("<line").count();
    assert!(lines(&strip) > lines(&drawn("iso-3095-2013")));
}

/// 40 m of 2 km of one rail: −2 dB in the mean of the rail, 14.8 dB there.
// Long: reads two kilometres of two rails for each of four questions.
#[test]
fn a_local_corrugation_is_diagnosed_where_it_is() {
    let sandbox = Sandbox::new();
    fs::write(sandbox.path("line.csv"), two_kilometres()).unwrap();
    let document = sandbox.json("diagnose cases/nominal.toml --roughness line.csv --speed \"108 km/h\" --json");
    let findings = list(&document, "dominant_wavelengths");
    assert_eq!(findings.len(), 1, "{findings:?}");
    let finding = &findings[0];
    assert_eq!(finding["rail"], "low");
    assert_eq!(finding["all_along"], false);
    assert!((number(&finding["wavelength_m"]) / WAVELENGTH - 1.0).abs() < 0.01);
    // Ends known to a metre are 0.1 dB; noise and the window have the rest.
    let level = 10.0 * (AMPLITUDE.powi(2) / 2.0).log10();
    assert!((number(&finding["level_db"]) - level).abs() < 0.4, "{finding}");
    let places = list(finding, "places");
    assert_eq!(places.len(), 1);
    assert!((number(&places[0]["from_m"]) - CORRUGATED.0).abs() < 1.0, "{places:?}");
    assert!((number(&places[0]["to_m"]) - CORRUGATED.1).abs() < 1.0, "{places:?}");
    // The other rail has nothing of it there.
    let rails = list(finding, "rails");
    let high = rails.iter().find(|rail| rail["name"] == "high").unwrap();
    assert!(number(&high["level_db"]) < 0.0, "{rails:?}");
    assert_eq!(finding["candidates"][0]["mechanism"], "growth ridge");

    let clean =
        sandbox.json("diagnose cases/nominal.toml --roughness line.csv --rail high --speed \"108 km/h\" --json");
    assert!(list(&clean, "dominant_wavelengths").is_empty());
    let beyond =
        sandbox.json("diagnose cases/nominal.toml --roughness line.csv --to \"1.1 km\" --speed \"108 km/h\" --json");
    assert!(list(&beyond, "dominant_wavelengths").is_empty());
    let outcome = sandbox.riffel(
        "diagnose cases/nominal.toml --roughness line.csv --from \"1 km\" --to \"1.5 km\" --speed \"108 km/h\" -o out",
    );
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    assert!(outcome.sentence().contains("rail low, 1200."), "{}", outcome.text);
    let table = fs::read_to_string(sandbox.path("out/places.csv")).unwrap();
    assert!(table.lines().nth(1).unwrap().starts_with("low,0.055"), "{table}");
}

/// The course of a place is that of the place, and not of the rail.
#[test]
fn a_local_course_is_that_of_its_place() {
    let sandbox = Sandbox::new();
    for (name, amplitude) in [("old.csv", 4.0), ("new.csv", 8.0)] {
        let mut text = "position [m],left [µm],right [µm]\n".to_owned();
        for row in 0..60_000 {
            let x = 5e-3 * f64::from(row);
            let there = (100.0..140.0).contains(&x);
            let wave = if there { amplitude * (TAU * x / WAVELENGTH).sin() } else { 0.0 };
            writeln!(text, "{x:.3},{:.3},{:.3}", noise(x, 1.7), wave + noise(x, 2.3)).unwrap();
        }
        fs::write(sandbox.path(name), text).unwrap();
    }
    let document = sandbox.json(
        "diagnose cases/nominal.toml --roughness new.csv --earlier old.csv --dates 2024-03-01,2025-03-01 \
         --speed \"108 km/h\" --json",
    );
    let finding = &document["dominant_wavelengths"][0];
    assert_eq!(finding["rail"], "right");
    // 20 lg 2 = 6.02 dB.
    assert!((number(&finding["course"]["slope_db"]) - 6.02).abs() < 0.2, "{finding}");
    let levels = list(&finding["course"], "levels_db");
    assert!((number(&levels[1]) - 15.05).abs() < 0.6, "{levels:?}");
}

/// A rail 6 dB above the other leads the forecast, and each is forecast as if it were alone, bit for bit.
// Long: asks seven questions about a record of two rails, with pictures and a report.
#[test]
fn each_rail_is_forecast_from_its_own_levels() {
    let sandbox = Sandbox::new();
    let mut text = "position [m],high [µm],low [µm]\n".to_owned();
    for row in 0..20_000 {
        let x = 2e-3 * f64::from(row);
        // Waves of 20–85 mm, so gentle that the wheel reaches every trough: levels go with heights.
        let wave = |index: i32| (TAU * x / (0.02 * 1.05f64.powi(index)) + f64::from(index * index)).sin();
        let height = 0.15 * (0..30).map(wave).sum::<f64>();
        writeln!(text, "{x:.3},{height:.4},{:.4}", 2.0 * height).unwrap();
    }
    fs::write(sandbox.path("rails.csv"), text).unwrap();
    let command = "forecast cases/nominal.toml --traffic cases/traffic.toml --spectrum rails.csv --json";
    let both = sandbox.json(command);
    assert_eq!(both["rail"], "low");
    assert_eq!(both["inputs"]["records"], 2);
    let rails = list(&both, "rails");
    assert_eq!(rails.len(), 2);
    let months = |document: &Value| number(&document["months_to_limit"]);
    assert!(0.0 < months(&rails[0]) && months(&rails[0]) < months(&rails[1]));
    for (rail, name) in rails.iter().zip(["low", "high"]) {
        assert_eq!(rail["rail"], name);
        let alone = sandbox.json(&format!("{command} --rail {name}"));
        assert_eq!(alone["rail"], name);
        assert_eq!(alone["rails"].as_array().unwrap(), std::slice::from_ref(rail));
        assert_eq!(alone["months_to_limit"], rail["months_to_limit"]);
        assert_eq!(alone["bands"], rail["bands"]);
    }
    // 20 lg 2 = 6.02 dB between the rails; heights are written to 0.1 nm.
    for (low, high) in list(&rails[0], "bands").iter().zip(list(&rails[1], "bands")) {
        let more = number(&low["level_now_db"]) - number(&high["level_now_db"]);
        assert!((more - 6.0206).abs() < 0.01, "{more}");
        assert_eq!(low["growth_rate_per_passage"], high["growth_rate_per_passage"]);
    }
    for key in ["months_to_limit", "limit_reached", "bands"] {
        assert_eq!(both[key], rails[0][key]);
    }
    let outcome = sandbox.riffel(&format!("{} -o out", command.replace(" --json", "")));
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    for part in [
        "rail low leads: grinding interval: EN ISO 3095:2013",
        "rail high: grinding interval: EN ISO 3095:2013",
        "rail high: linear range",
    ] {
        assert!(outcome.text.contains(part), "{}", outcome.text);
    }
    let table = fs::read_to_string(sandbox.path("out/bands.csv")).unwrap();
    assert!(table.starts_with("rail,wavelength_m,"), "{table}");
    let of: Vec<&str> = table.lines().skip(1).filter_map(|row| row.split(',').next()).collect();
    assert_eq!(of, [["low"; 7], ["high"; 7]].concat());
    let picture = fs::read_to_string(sandbox.path("out/forecast.svg")).unwrap();
    assert!(picture.contains("rail low now"));

    fs::write(sandbox.path("damp.toml"), "title = \"damp\"\n[wear]\ncoefficient = 1.25e-9\n").unwrap();
    let compare = "compare cases/nominal.toml --traffic cases/traffic.toml --with damp.toml --spectrum rails.csv";
    let compared = sandbox.json(&format!("{compare} --json"));
    for outcome in list(&compared, "outcomes") {
        assert_eq!(outcome["rail"], "low");
        let own = list(outcome, "rails");
        assert_eq!(own.len(), 2);
        assert_eq!(own[0]["months_to_limit"], outcome["months_to_limit"]);
        assert_eq!(own[1]["rail"], "high");
    }
    for (own, rail) in list(&compared["outcomes"][0], "rails").iter().zip(rails) {
        assert_eq!(own["passages_to_limit"], rail["passages_to_limit"]);
        assert_eq!(own["months_to_limit"], rail["months_to_limit"]);
    }
    let text = sandbox.riffel(&format!("{compare} -o compared")).text;
    assert!(text.contains("rail") && text.contains("low"), "{text}");
    let report = sandbox.riffel(
        "report cases/nominal.toml --roughness rails.csv --traffic cases/traffic.toml --with damp.toml -o report.html",
    );
    assert_eq!(report.status, Some(0), "{}", report.text);
    let html = fs::read_to_string(sandbox.path("report.html")).unwrap();
    assert!(html.contains("Rail low leads: grinding interval"));
    assert!(html.contains("as it is on rail low"));
}
