//! A network, from surveys to a plan.

use crate::sandbox::{Sandbox, number};

/// 2 km of two rails, 1 µm but for 100 m of `rough` µm on the left one.
fn survey(sandbox: &Sandbox, name: &str, rough: f64) {
    let mut text = "rail,from_m,to_m,rms_30_to_100_mm_um\n".to_owned();
    for rail in ["left", "right"] {
        for from in (0..2000).step_by(10) {
            let is_rough = rail == "left" && (500..600).contains(&from);
            let rms = if is_rough { rough } else { 1.0 };
            text += &format!("{rail},{from},{},{rms}\n", from + 10);
        }
    }
    std::fs::write(sandbox.path(name), text).unwrap();
}

/// 3.5 µm are half of the limit of 7 µm; 7 µm half a year later reach it, and 100 m of track are to be ground.
#[test]
fn surveys_become_a_plan() {
    let sandbox = Sandbox::new();
    survey(&sandbox, "before.csv", 3.5);
    survey(&sandbox, "after.csv", 6.9);
    let take = |file: &str, date: &str| {
        sandbox.json(&format!("network ingest railway {file} --line \"Main line\" --date {date} --json"))
    };
    assert_eq!(number(&take("before.csv", "2025-07-01")["measured"]["left"]), 200.0);
    assert_eq!(take("after.csv", "2026-01-01")["there_already"], false);
    assert_eq!(take("after.csv", "2026-01-01")["there_already"], true);
    let status = sandbox.json("network status railway --json");
    assert_eq!(status["lines"][0]["dates"].as_array().unwrap().len(), 2);

    let worst = sandbox.json("network worst railway --most 1 --json");
    assert_eq!(number(&worst[0]["from_m"]), 500.0);
    assert!((number(&worst[0]["rms_over_limit"]) - 6.9 / 7.0).abs() < 1e-12);
    let before = sandbox.json("network worst railway --most 1 --until 2025-12-31 --json");
    assert!((number(&before[0]["rms_over_limit"]) - 0.5).abs() < 1e-12);

    let growth = sandbox.json("network growth railway --json");
    let yearly = 20.0 * (6.9f64 / 3.5).log10() / 184.0 * 365.2425;
    assert!((number(&growth[0]["growth_db_per_year"]) - yearly).abs() < 1e-9);
    // Beside them, what the traffic of a case is expected to make: that of its fastest wave, which `map` tells, too.
    let expected = sandbox.json("network growth railway --case cases/nominal.toml --json");
    let of_map = &sandbox.json("map cases/nominal.toml --json")["under_traffic"];
    let fastest = &of_map["fastest"];
    assert!((0.03..0.1).contains(&number(&fastest["wavelength_m"])));
    let rate = number(&fastest["growth_rate_per_passage"]) * number(&of_map["passages_per_day"]);
    let median = 20.0 / std::f64::consts::LN_10 * rate * 365.2425;
    let growth_db = &expected[0]["expected_growth_db_per_year"];
    assert!((number(&growth_db["median"]) / median - 1.0).abs() < 0.02);
    assert!(number(&growth_db["band_80"][0]) < median && median < number(&growth_db["band_80"][1]));
    for (wrong, words) in [
        ("network growth railway --case cases/nominal.toml --line Branch", "one of those in the store: Main line"),
        ("network plan railway --length \"1 km\" --traffic cases/traffic.toml", "--case"),
    ] {
        let refused = sandbox.riffel(wrong);
        assert_eq!(refused.status, Some(2), "{}", refused.text);
        assert!(refused.sentence().contains(words), "{}", refused.text);
    }
    let plan = sandbox.json("network plan railway --months 6 --length \"1 km\" --json");
    assert_eq!(number(&plan["over_limit_m"]), 100.0);
    assert_eq!(number(&plan["sites"][0]["from_m"]), 500.0);
    assert_eq!(number(&plan["left_over_limit_m"]), 0.0);
    for (command, words) in [
        ("status railway", "Main line"),
        ("worst railway", "30–100"),
        ("growth railway", "3.50 → 6.90"),
        ("plan railway --months 6 --money 500 --cost-per-metre 4", "0.000 km are left"),
        ("plan railway --months 6 --money 500 --cost-per-metre 6", "0.100 km are left\n"),
        (
            "plan railway --months 6 --money 500 --cost-per-metre 4 --cost-per-site 100 --most-track",
            "0.100 km are ground for 500, 0.000 km are left\n",
        ),
    ] {
        let outcome = sandbox.riffel(&format!("network {command}"));
        assert_eq!(outcome.status, Some(0), "{command}: {}", outcome.text);
        assert!(outcome.text.contains(words), "{command}: {}", outcome.text);
    }
}

#[test]
fn what_cannot_be_is_refused() {
    let sandbox = Sandbox::new();
    survey(&sandbox, "a.csv", 5.0);
    let ingest = "network ingest railway a.csv --line A";
    for (arguments, words) in [
        ("network status nowhere".to_owned(), "nowhere holds no network"),
        (format!("{ingest} --date tomorrow"), "the date \"tomorrow\" is no date; write it as"),
        (
            format!("{ingest} --date 2026-01-01 --resolution \"1 mm\""),
            "the resolution is 0.001 m, but must be between 0.1 m and 1000 m",
        ),
        ("network ingest railway none.csv --line A --date 2026-01-01".to_owned(), "none.csv"),
    ] {
        let outcome = sandbox.riffel(&arguments);
        assert_eq!(outcome.status, Some(2), "{arguments}: {}", outcome.text);
        assert!(outcome.sentence().contains(words), "{arguments}: {}", outcome.text);
        assert!(!sandbox.path("railway/network.json").exists(), "{arguments}");
    }
    let made = sandbox.riffel(&format!("{ingest} --date 2026-01-01"));
    assert_eq!(made.status, Some(0), "{}", made.text);
    for (arguments, words) in [
        ("growth railway", "no line has surveys of two dates"),
        ("worst railway --section \"1 m\"", "at least a cell of the store, 10 m"),
        ("worst railway --limit iso-3095-2013", "is one of levels, but a store holds RMS in bands"),
        ("growth railway --from tomorrow --to 2026-01-01", "\"tomorrow\" is no date; write it as"),
        ("plan railway --length \"-1 km\"", "--length is -1000 m, but must be greater"),
        ("plan railway --months -1 --length \"1 km\"", "the number of months is -1"),
    ] {
        let outcome = sandbox.riffel(&format!("network {arguments}"));
        assert_eq!(outcome.status, Some(2), "{arguments}: {}", outcome.text);
        assert!(outcome.sentence().contains(words), "{arguments}: {}", outcome.text);
    }
}

/// Every survey of a line as a picture and a table; a line or a rail that is not there is refused with those that are.
#[test]
fn a_chart_has_every_survey() {
    let sandbox = Sandbox::new();
    survey(&sandbox, "before.csv", 3.5);
    survey(&sandbox, "after.csv", 14.0);
    for (file, date) in [("before.csv", "2025-07-01"), ("after.csv", "2026-01-01")] {
        sandbox.json(&format!("network ingest railway {file} --line \"Main line\" --date {date} --json"));
    }
    let chart = sandbox.json("network chart railway --json");
    let surveys = chart["lines"][0]["surveys"].as_array().unwrap();
    assert_eq!(surveys.len(), 2);
    for (survey, ratio) in surveys.iter().zip([0.5, 2.0]) {
        let sections = survey["sections"].as_array().unwrap();
        assert_eq!(sections.len(), 20);
        assert_eq!(sections[5]["rail"], "left");
        assert!((number(&sections[5]["rms_over_limit"]) - ratio).abs() < 1e-12);
        assert!((number(&sections[4]["rms_over_limit"]) - 1.0 / 7.0).abs() < 1e-12);
    }
    let right = sandbox.json("network chart railway --rail right --json");
    let section = &right["lines"][0]["surveys"][1]["sections"][5];
    assert!((number(&section["rms_over_limit"]) - 1.0 / 7.0).abs() < 1e-12);

    let drawn = sandbox.riffel("network chart railway");
    assert_eq!(drawn.status, Some(0), "{}", drawn.text);
    assert!(drawn.text.contains("2.000           0.100    2.00   0.500"), "{}", drawn.text);
    assert_eq!(sandbox.list("railway-chart"), ["chart.csv", "chart.png", "chart.svg", "summary.json"]);
    let table = std::fs::read_to_string(sandbox.path("railway-chart/chart.csv")).unwrap();
    assert_eq!(table.lines().count(), 41);
    for (asked, sentence) in [
        ("--line Mainline", "must be one of those in the store: Main line"),
        ("--rail middle", "must be one of those in the store: left, right"),
    ] {
        let refused = sandbox.riffel(&format!("network chart railway {asked} -o none"));
        assert_eq!(refused.status, Some(2), "{}", refused.text);
        assert!(refused.sentence().contains(sentence), "{}", refused.text);
        assert!(!sandbox.path("none").exists());
    }
}

/// Surveys that would be taken for others: a band twice, another encoding, nothing known, a year of another age; the order of columns
/// means nothing, and rails that are named otherwise later are told.
#[test]
fn surveys_that_mislead_are_refused_or_told() {
    let sandbox = Sandbox::new();
    let take = |file: &str, line: &str, date: &str| {
        sandbox.riffel(&format!("network ingest railway {file} --line {line} --date {date}"))
    };
    let write = |name: &str, text: &[u8]| std::fs::write(sandbox.path(name), text).unwrap();
    write("two.csv", b"rail,from_m,to_m,rms_10_to_30_mm_um,rms_30_to_100_mm_um\nleft,0,100,1,4\nleft,100,200,1,4\n");
    write(
        "turned.csv",
        b"rail,from_m,to_m,rms_30_to_100_mm_um,rms_10_to_30_mm_um\nnorth,0,100,8,1\nnorth,100,200,4,1\n",
    );
    write("twice.csv", b"rail,from_m,to_m,rms_30_to_100_mm_um,rms_30_to_100_mm_um\nleft,0,100,1,4\n");
    write("latin.csv", b"rail,from_m,to_m,rms_10_to_30_mm_um\n\xfcber,0,100,1\n");
    write("empty.csv", b"rail,from_m,to_m,rms_10_to_30_mm_um\nleft,0,100,\n");
    for (file, date, sentence) in [
        ("twice.csv", "2026-01-01", "another column has already"),
        ("latin.csv", "2026-01-01", "is not in UTF-8"),
        ("empty.csv", "2026-01-01", "no block has an RMS"),
        ("two.csv", "1025-01-31", "a day between 1950 and 2100"),
    ] {
        let refused = take(file, "A", date);
        assert_eq!(refused.status, Some(2), "{file}: {}", refused.text);
        assert!(refused.sentence().contains(sentence), "{}", refused.text);
    }
    assert_eq!(take("two.csv", "A", "2025-01-01").status, Some(0));
    let second = take("turned.csv", "A", "2026-01-01");
    assert_eq!(second.status, Some(0), "{}", second.text);
    let worst = sandbox.json("network worst railway --most 1 --json");
    assert!((number(&worst[0]["rms_m"]) - 8e-6).abs() < 1e-15);
    let words = "nothing is known of the growth of left of 2025-01-01; north of 2026-01-01";
    for command in ["growth railway", "plan railway --length \"1 km\""] {
        let told = sandbox.riffel(&format!("network {command}"));
        assert!(told.text.contains(words), "{command}: {}", told.text);
    }
}
