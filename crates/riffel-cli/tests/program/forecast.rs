//! `riffel forecast` and `riffel compare`, from the files to the decision.

use std::f64::consts::LN_10;
use std::fs;

use serde_json::Value;

use crate::sandbox::{Sandbox, number};

const NIEDERWANGEN: &str = "validation/reference/sbb-track-noise";
const MEASURED: &str =
    "--spectrum validation/reference/sbb-track-noise/rail_roughness.csv --where laboratory=MBBM";

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
    let command = format!(
        "forecast cases/nominal.toml {MEASURED} --date-column date --traffic cases/traffic.toml"
    );
    let document = sandbox.json(&format!("{command} --months 6 --json"));
    let passages = number(&document["horizon"]["passages"]);
    assert!((passages / (6000.0 * 365.2425 / 2.0) - 1.0).abs() < 1e-12);
    assert_eq!(document["horizon"]["date"], "2016-04-01");
    let bands = document["bands"].as_array().unwrap();
    assert_eq!(bands.len(), 7);
    let mut first = f64::INFINITY;
    for (place, band) in bands.iter().enumerate() {
        let (now, then) = (
            &document["spectrum_now"][place],
            &document["spectrum_then"][place],
        );
        let rate = &document["growth_rate_per_passage"][place];
        assert_eq!(now["wavelength_m"], rate["wavelength_m"]);
        let change = number(&then["level_db"]) - number(&now["level_db"]);
        let linear = 20.0 / LN_10 * number(&rate["growth_rate_per_passage"]) * passages;
        // The fastest lines of a band take over: never less than its mean rate, at six months little more.
        assert!(
            change >= linear - 1e-9 && change < linear + 0.6,
            "{band}: {change} {linear}"
        );
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
    assert!(
        outcome.text.contains("grinding interval: EN ISO 3095:2013"),
        "{}",
        outcome.text
    );
    assert_eq!(
        sandbox.list("out"),
        [
            "bands.csv",
            "forecast.html",
            "forecast.png",
            "forecast.svg",
            "growth.csv",
            "summary.json"
        ]
    );
}

/// The 20 mm of Niederwangen fades: no wear coefficient is claimed, and the page says why.
#[test]
fn a_fading_grinding_mark_is_not_fitted() {
    let sandbox = sandbox();
    let command = format!(
        "forecast cases/nominal.toml {MEASURED} --date-column date --traffic cases/traffic.toml --json"
    );
    let document = sandbox.json(&command);
    let fit = &document["wear_fit"];
    assert_eq!(fit["paired"], true);
    assert_eq!(fit["records_earlier"], 8);
    // 2014-03-01 to 2015-10-01.
    assert_eq!(number(&fit["passages_between"]), 579.0 * 6000.0);
    assert!(fit["coefficient_kg_per_j"].is_null());
    assert!(
        fit["verdict"] == "against" || fit["verdict"] == "indistinct",
        "{fit}"
    );
    let mark = &fit["bands"][0];
    assert!((number(&mark["wavelength_m"]) - 0.019_953).abs() < 1e-6);
    assert!((number(&mark["measured_change_db"]) + 6.5).abs() < 0.1);
    let sentences = fit["sentences"].to_string();
    assert!(sentences.contains("no wear coefficient"), "{sentences}");
    assert!(sentences.contains("20 mm fades"), "{sentences}");
}

/// A rail that grows twice as fast as the model says gives twice the coefficient.
#[test]
fn the_coefficient_of_two_dates_is_found() {
    let sandbox = sandbox();
    let forecast = |arguments: &str| {
        sandbox.json(&format!(
            "forecast cases/nominal.toml --traffic cases/traffic.toml --json {arguments}"
        ))
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
    let future = forecast(&format!("{MEASURED} --passages 8e6"));
    write("now.csv", &future, "spectrum_now");
    write("then.csv", &future, "spectrum_then");
    let found = forecast("--spectrum then.csv --earlier now.csv --passages-between 4e6");
    let fit = &found["wear_fit"];
    assert_eq!(fit["verdict"], "fitted", "{fit}");
    let interval = &fit["coefficient_interval_kg_per_j"];
    let (low, high) = (number(&interval[0]), number(&interval[1]));
    assert!(low < 5e-9 && 5e-9 < high, "{fit}");
    assert!(
        (number(&fit["coefficient_kg_per_j"]) / 5e-9 - 1.0).abs() < 0.05,
        "{fit}"
    );
}

/// Passages, MGT and months that are the same amount give the same levels.
#[test]
fn the_amount_can_be_said_in_three_ways() {
    let sandbox = sandbox();
    one_band(&sandbox, 0.0);
    let then = |horizon: &str| {
        let command = format!(
            "forecast cases/nominal.toml --spectrum one.csv --traffic cases/traffic.toml --json {horizon}"
        );
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
    let command =
        "forecast cases/nominal.toml --spectrum made.csv --traffic cases/traffic.toml --json";
    let document = sandbox.json(command);
    assert_eq!(document["inputs"]["records"], 2);
    assert!(document["wear_fit"].is_null());
    one_band(&sandbox, 40.0);
    let command =
        "forecast cases/nominal.toml --spectrum one.csv --traffic cases/traffic.toml --json";
    let document = sandbox.json(command);
    assert_eq!(number(&document["passages_to_limit"]), 0.0);
    assert_eq!(document["bands"][0]["beyond_linear_range"], true);
    assert!(
        document["findings"]
            .to_string()
            .contains("beyond the linear range now")
    );
}

#[test]
fn variants_are_compared() {
    let sandbox = sandbox();
    fs::write(
        sandbox.path("dry.toml"),
        "title = \"dry\"\n[contact]\nfriction = 0.6\ntractive_ratio = 0.2\n",
    )
    .unwrap();
    fs::write(sandbox.path("slow.toml"), "[speed]\nfactor = 0.7\n").unwrap();
    let command = "compare cases/nominal.toml --with dry.toml --with slow.toml";
    let alone = sandbox.json(&format!("{command} --speed \"108 km/h\" --json"));
    let outcomes = alone["outcomes"].as_array().unwrap();
    let titles: Vec<&str> = outcomes
        .iter()
        .filter_map(|o| o["title"].as_str())
        .collect();
    assert_eq!(titles, ["as it is", "dry", "slow"]);
    // The ridge of the nominal case: 537 Hz, at 70 % of the speed 70 % of the wavelength.
    let wavelength = |index: usize| number(&outcomes[index]["fastest_wavelength_m"]);
    assert!((30.0 / wavelength(0) - 537.0).abs() < 15.0);
    assert!((wavelength(2) / wavelength(0) - 0.7).abs() < 0.02);
    assert!(number(&outcomes[1]["change_of_fastest_growth"]) > 0.5);
    assert_eq!(outcomes[0]["fastest_at_edge"], false);
    assert!(alone["spectrum_now"].is_null() && outcomes[0]["passages_to_limit"].is_null());
    let measured = "--where campaign=4 --traffic cases/traffic.toml -o out";
    let outcome = sandbox.riffel(&format!("{command} {MEASURED} {measured}"));
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    let text = fs::read_to_string(sandbox.path("out/summary.json")).unwrap();
    let document: Value = serde_json::from_str(&text).unwrap();
    let to_limit = |index: usize| number(&document["outcomes"][index]["passages_to_limit"]);
    assert!(to_limit(1) < to_limit(0));
    assert!(sandbox.list("out").contains(&"compare.png".to_owned()));
}

#[test]
fn bad_input_is_answered_with_a_sentence() {
    let sandbox = sandbox();
    one_band(&sandbox, 0.0);
    fs::write(sandbox.path("long.csv"), "wavelength_mm,level_db\n1000,3\n").unwrap();
    fs::write(sandbox.path("nothing.toml"), "title = \"no change\"\n").unwrap();
    fs::write(
        sandbox.path("quiet.toml"),
        "[[vehicle]]\nname = \"unit\"\nshare = 1\nspeed = { mean = 30 }\n",
    )
    .unwrap();
    let forecast = "forecast cases/nominal.toml --traffic cases/traffic.toml";
    for (arguments, part) in [
        (
            format!("{forecast} --spectrum none.csv"),
            "none.csv: cannot read",
        ),
        (
            format!("{forecast} --spectrum long.csv"),
            "map.wavelength of the case",
        ),
        (
            format!("{forecast} --spectrum one.csv --limit grassie-1999"),
            "one-third-octave levels",
        ),
        (
            format!("{forecast} --spectrum one.csv --limit none"),
            "no limit table",
        ),
        (
            format!("{forecast} --spectrum one.csv --passages -1"),
            "greater than zero",
        ),
        (
            format!("{forecast} --spectrum one.csv --passages 1 --mgt 1"),
            "cannot be used with",
        ),
        (
            format!("{forecast} --spectrum one.csv --passages-between 1e6"),
            "no earlier measurement",
        ),
        (
            format!("{forecast} --spectrum one.csv --earlier one.csv"),
            "--passages-between",
        ),
        (
            format!("{forecast} --spectrum one.csv --date-column date"),
            "no column \"date\"",
        ),
        (
            format!("{forecast} --spectrum one.csv --date 2026-02-30"),
            "--date",
        ),
        (
            "forecast cases/nominal.toml --traffic none.toml --spectrum one.csv".to_owned(),
            "cannot read the traffic file",
        ),
        (
            "forecast cases/nominal.toml --traffic quiet.toml --spectrum one.csv".to_owned(),
            "passages_per_day",
        ),
        (
            "compare cases/nominal.toml --with none.toml".to_owned(),
            "cannot read the file of changes",
        ),
        (
            "compare cases/nominal.toml --with nothing.toml".to_owned(),
            "changes nothing",
        ),
        ("compare cases/nominal.toml".to_owned(), "--with"),
    ] {
        let outcome = sandbox.riffel(&arguments);
        assert_eq!(outcome.status, Some(2), "{arguments}: {}", outcome.text);
        let text = outcome.text.replace("\n  │ ", " ");
        assert!(text.contains(part), "{arguments}: {text}");
    }
    let left = [
        "cases",
        "long.csv",
        "nothing.toml",
        "one.csv",
        "quiet.toml",
        "validation",
    ];
    assert_eq!(sandbox.list("."), left);
}

#[test]
fn a_traffic_file_to_start_from_is_written() {
    let sandbox = sandbox();
    one_band(&sandbox, -10.0);
    let outcome = sandbox.riffel("init --traffic mine.toml");
    assert!(
        outcome.text.contains("--traffic mine.toml"),
        "{}",
        outcome.text
    );
    let command = "forecast cases/nominal.toml --spectrum one.csv --traffic mine.toml --json";
    assert!(sandbox.json(command)["passages_to_limit"].is_number());
    let schema = sandbox.json("schema --traffic");
    assert!(schema["properties"]["vehicle"].is_object());
}
