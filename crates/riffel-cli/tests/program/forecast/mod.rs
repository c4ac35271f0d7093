//! `riffel forecast` and `riffel compare`, from the files to the decision.

mod earlier;
mod variants;

use std::f64::consts::LN_10;
use std::fs;

use serde_json::Value;

use crate::sandbox::{Sandbox, number};

const NIEDERWANGEN: &str = "validation/reference/sbb-track-noise";
const MEASURED: &str = "--spectrum validation/reference/sbb-track-noise/rail_roughness.csv --where laboratory=MBBM";

fn sandbox() -> Sandbox {
    let sandbox = Sandbox::new();
    sandbox.copy(NIEDERWANGEN);
    sandbox
}

/// One band of 0 dB at 50 mm.
fn one_band(sandbox: &Sandbox, level: f64) {
    let text = format!("wavelength_mm,level_db\n50,{level}\n");
    fs::write(sandbox.path("one.csv"), text).unwrap();
}

#[test]
fn the_forecast_answers_under_the_fixed_names() {
    let sandbox = sandbox();
    let command = format!("forecast cases/nominal.toml {MEASURED} --date-column date --traffic cases/traffic.toml");
    let document = sandbox.json(&format!("{command} --months 6 --json"));
    let passages = number(&document["horizon"]["passages"]);
    assert!((passages / (6000.0 * 365.2425 / 2.0) - 1.0).abs() < 1e-12);
    assert_eq!(document["horizon"]["date"], "2016-04-01");
    let bands = document["bands"].as_array().unwrap();
    assert_eq!(bands.len(), 7);
    let mut first = f64::INFINITY;
    for (place, band) in bands.iter().enumerate() {
        let (now, then) = (&document["spectrum_now"][place], &document["spectrum_then"][place]);
        let rate = &document["growth_rate_per_passage"][place];
        assert_eq!(now["wavelength_m"], rate["wavelength_m"]);
        let change = number(&then["level_db"]) - number(&now["level_db"]);
        let linear = 20.0 / LN_10 * number(&rate["growth_rate_per_passage"]) * passages;
        // The fastest lines of a band take over: never less than its mean rate, at six months little more. What decays stays.
        assert!(change >= linear.max(0.0) - 1e-9 && change < linear.max(0.0) + 0.6, "{band}: {change} {linear}");
        if let Some(passages) = band["passages_to_limit"].as_f64() {
            first = first.min(passages);
        }
    }
    assert_eq!(number(&document["passages_to_limit"]), first);
    let mgt = first * 14_600.0 * 1e-9;
    assert!((number(&document["mgt_to_limit"]) / mgt - 1.0).abs() < 1e-12);
    assert_eq!(document["bands_left_out"].as_array().unwrap().len(), 18);
    assert_eq!(sandbox.list("."), ["cases", "validation"]);
    let outcome = sandbox.riffel(&format!("{command} -o out"));
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    assert!(outcome.text.contains("grinding interval: EN ISO 3095:2013"), "{}", outcome.text);
    assert_eq!(
        sandbox.list("out"),
        ["bands.csv", "forecast.html", "forecast.png", "forecast.svg", "growth.csv", "summary.json"]
    );
}

/// Passages, MGT and months that are the same amount give the same levels.
#[test]
fn the_amount_can_be_said_in_three_ways() {
    let sandbox = sandbox();
    one_band(&sandbox, 0.0);
    let then = |horizon: &str| {
        let command =
            format!("forecast cases/nominal.toml --spectrum one.csv --traffic cases/traffic.toml --json {horizon}");
        number(&sandbox.json(&command)["spectrum_then"][0]["level_db"])
    };
    let level = then("--passages 1e6");
    assert!(level > 0.0);
    assert!((then("--mgt 14.6") - level).abs() < 1e-9);
    let months = 1e6 / 6000.0 / 365.2425 * 12.0;
    assert!((then(&format!("--months {months}")) - level).abs() < 1e-9);
}

/// A profile is analysed, its rails averaged; a rough one is beyond the linear range.
#[test]
fn a_profile_can_be_forecast() {
    let sandbox = sandbox();
    sandbox.riffel("roughness --synthesise -o made.csv");
    let command = "forecast cases/nominal.toml --spectrum made.csv --traffic cases/traffic.toml --json";
    let document = sandbox.json(command);
    assert_eq!(document["inputs"]["records"], 2);
    assert!(document["wear_fit"].is_null());
    one_band(&sandbox, 40.0);
    let command = "forecast cases/nominal.toml --spectrum one.csv --traffic cases/traffic.toml --json";
    let document = sandbox.json(command);
    assert_eq!(number(&document["passages_to_limit"]), 0.0);
    assert_eq!(document["bands"][0]["beyond_linear_range"], true);
    assert!(document["findings"].to_string().contains("beyond the linear range now"));
}

/// 68 dB is 3.5 mm: nothing is forecast where the wheel has left the rail, in table, JSON and files alike.
#[test]
fn a_forecast_ends_where_the_wheel_leaves_the_rail() {
    let sandbox = sandbox();
    one_band(&sandbox, 0.0);
    let command = "forecast cases/nominal.toml --spectrum one.csv --traffic cases/traffic.toml";
    let near = sandbox.json(&format!("{command} --passages 1e6 --json"));
    let end = number(&near["valid_to_passages"]);
    assert_eq!(near["valid_to_passages"], near["linear_range"]["passages"]);
    assert!(number(&near["spectrum_then"][0]["level_db"]) > 0.0);
    assert!((number(&near["valid_to_months"]) * 6000.0 * 365.2425 / 12.0 / end - 1.0).abs() < 1e-12);
    let far = sandbox.json(&format!("{command} --passages {} -o far --json", 10.0 * end));
    assert!(far["spectrum_then"][0]["level_db"].is_null());
    assert!(far["bands"][0]["level_then_db"].is_null());
    assert_eq!(far["valid_to_passages"], near["valid_to_passages"]);
    let rows = fs::read_to_string(sandbox.path("far/bands.csv")).unwrap();
    let (header, row) = rows.split_once('\n').unwrap();
    let place = header.split(',').position(|name| name == "level_then_db").unwrap();
    assert_eq!(row.split(',').nth(place), Some(""), "{rows}");
    let picture = fs::read_to_string(sandbox.path("far/forecast.svg")).unwrap();
    assert!(picture.contains("where the forecast ends"));
    // A limit of a millimetre is never seen: neither a date nor "never".
    fs::write(
        sandbox.path("high.toml"),
        "name = \"high\"\ntitle = \"t\"\nedition = \"a millimetre\"\nsource = \"invented\"\n\
         [[level]]\nwavelength = \"50 mm\"\nlevel_db = 60.0\n",
    )
    .unwrap();
    let high = sandbox.json(&format!("{command} --limit high.toml --json"));
    assert_eq!(high["limit_reached"], "beyond-linear-range");
    assert!(high["passages_to_limit"].is_null() && high["date_of_limit"].is_null());
    let text = sandbox.riffel(&format!("{command} --limit high.toml --passages {} -o far", 2.0 * end));
    assert_eq!(text.text.matches(" beyond the linear range").count(), 2, "{}", text.text);
    assert!(text.text.contains("is not reached before the wheel leaves the rail"), "{}", text.text);
}

/// A rail 6 dB below the limit reaches it after the months that 6 dB of growth take.
#[test]
fn the_interval_of_a_rail_that_will_be_ground() {
    let sandbox = sandbox();
    let command = "forecast cases/nominal.toml --traffic cases/traffic.toml";
    let ground = sandbox.json(&format!("{command} --from-limit \"-6 dB\" --json"));
    assert_eq!(ground["inputs"]["ground"], "6 dB below EN ISO 3095:2013, Figure 2");
    assert!(ground["inputs"]["spectrum"].is_null());
    let bands = ground["bands"].as_array().unwrap();
    assert_eq!(bands.len(), 7);
    for band in bands {
        let below = number(&band["limit_db"]) - number(&band["level_now_db"]);
        assert!((below - 6.0).abs() < 1e-9, "{band}");
    }
    let months = number(&ground["months_to_limit"]);
    let rates = bands.iter().map(|band| number(&band["growth_rate_per_passage"]));
    let fastest = rates.fold(0.0, f64::max);
    // By the mean rate of the fastest band; its fastest lines are sooner there.
    let by_mean = 6.0 * LN_10 / 20.0 / fastest / (6000.0 * 365.2425 / 12.0);
    assert!(months > 0.8 * by_mean && months <= by_mean, "{months} {by_mean}");
    let nearer = sandbox.json(&format!("{command} --from-limit=-3dB --json"));
    assert!(number(&nearer["months_to_limit"]) < 0.6 * months);
    // The same levels from a file are the same rail.
    let rows = bands.iter().map(|band| format!("{},{}\n", band["wavelength_m"], band["level_now_db"]));
    let text = format!("wavelength_m,level_db\n{}", rows.collect::<String>());
    fs::write(sandbox.path("ground.csv"), text).unwrap();
    let file = sandbox.json(&format!("{command} --ground ground.csv --json"));
    assert!((number(&file["months_to_limit"]) / months - 1.0).abs() < 1e-9);
    let text = sandbox.riffel(&format!("{command} --from-limit \"-6 dB\""));
    let sentence = "grinding interval from 6 dB below EN ISO 3095:2013, Figure 2";
    assert!(text.text.contains(sentence), "{}", text.text);
    fs::write(sandbox.path("damp.toml"), "title = \"damp\"\n[wear]\ncoefficient = 1.25e-9\n").unwrap();
    let compare = "compare cases/nominal.toml --with damp.toml --traffic cases/traffic.toml --from-limit -6";
    let compared = sandbox.json(&format!("{compare} --json"));
    let of = |index: usize| number(&compared["outcomes"][index]["months_to_limit"]);
    assert!((of(0) / months - 1.0).abs() < 1e-12);
    // Half the wear, twice the time.
    assert!((of(1) / of(0) - 2.0).abs() < 1e-9);
    let text = sandbox.riffel(compare).text;
    assert!(text.contains("months to limit"), "{text}");
}

/// A metro curve: with τ = 0.5 on every axle the amplitude doubles within weeks, which no railway has reported.
#[test]
fn growth_faster_than_ever_reported_is_remarked() {
    let sandbox = sandbox();
    one_band(&sandbox, -10.0);
    let vehicle = |name: &str, more: &str| {
        let text = format!(
            "[line]\npassages_per_day = 10000\n[[vehicle]]\nname = \"metro\"\nshare = 1\n\
             speed = {{ mean = \"60 km/h\" }}\ntractive_ratio = 0.5\n{more}"
        );
        fs::write(sandbox.path(name), text).unwrap();
    };
    vehicle("all.toml", "");
    vehicle("part.toml", "traction_share = \"5 %\"\n");
    let forecast = |traffic: &str| {
        sandbox.json(&format!("forecast cases/nominal.toml --spectrum one.csv --traffic {traffic} --json"))
    };
    let (all, part) = (forecast("all.toml"), forecast("part.toml"));
    let rate = |document: &Value| number(&document["bands"][0]["growth_rate_per_passage"]);
    assert!((rate(&part) / rate(&all) - 0.05).abs() < 1e-12);
    let remarks = |document: &Value| document["remarks"].to_string();
    assert!(remarks(&all).contains("Torstensson & Nielsen 2009"), "{}", remarks(&all));
    assert!(!remarks(&part).contains("Torstensson"), "{}", remarks(&part));
    vehicle("much.toml", "traction_share = 1.5\n");
    let outcome = sandbox.riffel("forecast cases/nominal.toml --spectrum one.csv --traffic much.toml");
    assert_eq!(outcome.status, Some(2), "{}", outcome.text);
    assert!(outcome.text.contains("traction_share` is 1.5, but must be between 0 and 1"), "{}", outcome.text);
}

// Long: starts the program for every wrong argument.
#[test]
fn bad_input_is_answered_with_a_sentence() {
    let sandbox = sandbox();
    one_band(&sandbox, 0.0);
    fs::write(sandbox.path("long.csv"), "wavelength_mm,level_db\n1000,3\n").unwrap();
    fs::write(sandbox.path("nothing.toml"), "title = \"no change\"\n").unwrap();
    fs::write(sandbox.path("quiet.toml"), "[[vehicle]]\nname = \"unit\"\nshare = 1\nspeed = { mean = 30 }\n").unwrap();
    let forecast = "forecast cases/nominal.toml --traffic cases/traffic.toml";
    for (arguments, part) in [
        (format!("{forecast} --spectrum none.csv"), "cannot read the file none.csv"),
        (format!("{forecast} --spectrum long.csv"), "map.wavelength of the case"),
        (format!("{forecast} --spectrum one.csv --limit grassie-1999"), "one-third-octave levels"),
        (format!("{forecast} --spectrum one.csv --limit none"), "no limit table"),
        (format!("{forecast} --spectrum one.csv --passages -1"), "must be above zero and at most 1000000000000"),
        (format!("{forecast} --spectrum one.csv --passages 2,5e6"), "no separators of thousands"),
        (format!("{forecast} --spectrum one.csv --passages 1 --mgt 1"), "cannot be used with"),
        (format!("{forecast} --spectrum one.csv --passages-between 1e6"), "no earlier measurement"),
        (format!("{forecast} --spectrum one.csv --earlier one.csv"), "--passages-between"),
        (format!("{forecast} --spectrum one.csv --date-column date"), "no column \"date\""),
        (format!("{forecast} --spectrum one.csv --date 2026-02-30"), "--date"),
        (
            "forecast cases/nominal.toml --traffic none.toml --spectrum one.csv".to_owned(),
            "cannot read the traffic file",
        ),
        ("forecast cases/nominal.toml --traffic quiet.toml --spectrum one.csv".to_owned(), "passages_per_day"),
        ("compare cases/nominal.toml --with none.toml".to_owned(), "cannot read the file of changes"),
        ("compare cases/nominal.toml --with nothing.toml".to_owned(), "changes nothing"),
        ("compare cases/nominal.toml".to_owned(), "--with"),
        (
            "forecast cases/nominal.toml --traffic cases/nominal.toml --spectrum one.csv".to_owned(),
            "this is a case file, with its table [wheel], and no traffic file",
        ),
        (
            "forecast cases/traffic.toml --traffic cases/traffic.toml --spectrum one.csv".to_owned(),
            "this is a traffic file, with its [[vehicle]], and no case file",
        ),
        (format!("{forecast} --from-limit \"6 dB\""), "below the limit"),
        (format!("{forecast} --from-limit -6mm"), "below the limit"),
        (format!("{forecast} --ground iso-3095-2013"), "smoother than --limit"),
        (format!("{forecast} --ground grassie-1999"), "one-third-octave levels"),
        (format!("{forecast} --ground none.csv"), "none.csv"),
        (format!("{forecast} --earlier one.csv --from-limit -6"), "--earlier needs --spectrum"),
        (forecast.to_owned(), "--spectrum"),
        ("compare cases/nominal.toml --with nothing.toml --hold torque".to_owned(), "invalid value 'torque'"),
    ] {
        let outcome = sandbox.riffel(&arguments);
        assert_eq!(outcome.status, Some(2), "{arguments}: {}", outcome.text);
        let text = outcome.text.replace("\n  │ ", " ");
        assert!(text.contains(part), "{arguments}: {text}");
    }
    let left = ["cases", "long.csv", "nothing.toml", "one.csv", "quiet.toml", "validation"];
    assert_eq!(sandbox.list("."), left);
}

#[test]
fn a_traffic_file_to_start_from_is_written() {
    let sandbox = sandbox();
    one_band(&sandbox, -10.0);
    let outcome = sandbox.riffel("init --traffic mine.toml");
    assert!(outcome.text.contains("--traffic mine.toml"), "{}", outcome.text);
    let command = "forecast cases/nominal.toml --spectrum one.csv --traffic mine.toml --json";
    assert!(sandbox.json(command)["passages_to_limit"].is_number());
    let schema = sandbox.json("schema --traffic");
    assert!(schema["properties"]["vehicle"].is_object());
}
