//! `riffel roughness`, from the file to the verdict.

use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::fs;

use serde_json::Value;

use crate::sandbox::{Sandbox, number};

/// Level of the band that contains a wavelength.
fn level(document: &Value, wavelength: f64) -> f64 {
    let near = |row: &&Value| (number(&row["wavelength_m"]) / wavelength - 1.0).abs() < 0.1;
    number(&document["spectrum"].as_array().unwrap().iter().find(near).unwrap()["level_db"])
}

/// 20 m of 3 µm at 50.1 mm: position in m and height in µm, without a header.
fn wave() -> String {
    (0..20_000).fold(String::new(), |mut text, row| {
        let x = 1e-3 * f64::from(row);
        let height = 3.0 * (TAU * x / 0.050_118_723).sin();
        writeln!(text, "{x:.3},{height:.5}").unwrap();
        text
    })
}

#[test]
fn two_columns_are_understood_and_answered_under_the_fixed_names() {
    let sandbox = Sandbox::new();
    fs::write(sandbox.path("wave.csv"), wave()).unwrap();
    let document = sandbox.json("roughness wave.csv --json");
    assert_eq!(number(&document["sample_spacing_m"]), 1e-3);
    assert!((number(&document["length_m"]) - 20.0).abs() < 1e-9);
    // Heights are written to 1e-5 µm.
    assert!((level(&document, 0.0501) - 6.532).abs() < 0.01);
    assert!(level(&document, 0.0316) < -40.0 && level(&document, 0.0794) < -40.0);
    let bands = document["bands"].as_array().unwrap();
    assert_eq!(bands.len(), 4);
    assert!((number(&bands[1]["rms_m"]) / (3e-6 / 2f64.sqrt()) - 1.0).abs() < 0.01);
    assert!((number(&bands[1]["peak_to_peak_max_m"]) / 6e-6 - 1.0).abs() < 0.05);
    assert_eq!(number(&bands[1]["share_over_limit"]), 0.0);
    assert!((number(&bands[1]["from_m"]) - 0.03).abs() < 1e-12);
    assert_eq!(document["removed"]["spikes"], 0);
    assert_eq!(document["removed"]["pits"], 0);
    assert_eq!(document["warnings"].as_array().unwrap().len(), 1);
    assert_eq!(sandbox.list("."), ["cases", "wave.csv"]);
}

/// A moving RMS over a tenth of a wave goes up and down with it: each band whose waves are longer than the window is named.
#[test]
fn a_window_shorter_than_a_wave_is_told() {
    let sandbox = Sandbox::new();
    fs::write(sandbox.path("wave.csv"), wave()).unwrap();
    let told = |window: &str| {
        let document = sandbox.json(&format!("roughness wave.csv {window} --json"));
        let warnings = document["warnings"].to_string();
        warnings.matches("is shorter than waves of").count()
    };
    assert_eq!([told("--window \"50 mm\""), told("--window \"2 m\""), told("")], [3, 0, 0]);
}

/// The section of a part is told with what lies there alone; the table keeps all of it.
#[test]
fn sections_are_told_with_what_lies_there() {
    let sandbox = Sandbox::new();
    fs::write(sandbox.path("wave.csv"), wave()).unwrap();
    let table = "from_km,to_km,kind,name\n0.002,0.004,curve,R 300\n0.018,0.018,weld,W 7\n";
    fs::write(sandbox.path("line.csv"), table).unwrap();
    let document = sandbox.json("roughness wave.csv --along line.csv --to \"15 m\" --json");
    let [section] = &document["sections"].as_array().unwrap()[..] else {
        panic!("15 m are one section: {document}");
    };
    // 3 µm at 50 mm are 6.5 dB, where the limit of levels is -1.1 dB; their RMS of 2.1 µm is below 7 µm.
    assert!((number(&section["excess_db"]) - 7.6).abs() < 0.1, "{section}");
    assert_eq!(section["within"], false);
    assert_eq!(number(&section["grind_m"]), 0.0);
    let names = section["along"].as_array().unwrap().iter();
    let names: Vec<&Value> = names.map(|place| &place["name"]).collect();
    assert_eq!(names, ["R 300"]);
    assert_eq!(document["along"].as_array().unwrap().len(), 2);
}

/// A rail in other clothes gives the same levels.
// Long: reads a record in every layout.
#[test]
fn layouts_do_not_matter() {
    let sandbox = Sandbox::new();
    fs::write(sandbox.path("plain.csv"), wave()).unwrap();
    let expected = level(&sandbox.json("roughness plain.csv --json"), 0.0501);
    let rows: Vec<(f64, f64)> = wave()
        .lines()
        .map(|line| {
            let (x, height) = line.split_once(',').unwrap();
            (x.parse().unwrap(), height.parse().unwrap())
        })
        .collect();
    let german = rows.iter().rev().fold("km;links (mm);rechts (mm)\n".to_owned(), |mut text, (x, height)| {
        let line = format!("{:.6};{:.8};{:.8}", 12.0 + 1e-3 * x, 1e-3 * height, -1e-3 * height);
        writeln!(text, "{}", line.replace('.', ",")).unwrap();
        text
    });
    fs::write(sandbox.path("german.txt"), german).unwrap();
    let alone = rows.iter().fold(String::new(), |mut text, (_, height)| {
        writeln!(text, "{height}").unwrap();
        text
    });
    fs::write(sandbox.path("alone.txt"), alone).unwrap();
    let document = sandbox.json("roughness german.txt --json --save-format german.toml");
    assert_eq!(document["rails"].as_array().unwrap().len(), 2);
    assert_eq!(document["rails"][0]["name"], "links");
    for arguments in [
        "roughness german.txt --json",
        "roughness german.txt --json --format german.toml",
        "roughness alone.txt --json --spacing \"1 mm\"",
    ] {
        let found = level(&sandbox.json(arguments), 0.0501);
        assert!((found - expected).abs() < 1e-3, "{arguments}: {found} {expected}");
    }
}

#[test]
fn a_made_profile_is_judged_and_its_corrugation_found() {
    let sandbox = Sandbox::new();
    let made = sandbox.riffel("roughness --synthesise -o made.csv");
    assert_eq!(made.status, Some(0), "{}", made.text);
    let outcome = sandbox.riffel("roughness made.csv -o out");
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    assert_eq!(
        sandbox.list("out"),
        ["blocks.csv", "grind.csv", "roughness.html", "roughness.png", "roughness.svg", "spectrum.csv", "summary.json"]
    );
    assert!(outcome.text.contains("EN ISO 3095:2013, Figure 2: over the limit"));
    let text = fs::read_to_string(sandbox.path("out/summary.json")).unwrap();
    let document: Value = serde_json::from_str(&text).unwrap();
    // One spike and one pit on each of two rails.
    assert_eq!(document["removed"]["spikes"], 2);
    assert_eq!(document["removed"]["pits"], 2);
    let sections = document["grind"]["sections"].as_array().unwrap();
    let corrugated = sections.iter().find(|section| (number(&section["from_m"]) - 30.0).abs() < 1.0).unwrap();
    // 15 µm from 30 m to 55 m, seen through windows of 1 m.
    assert!((number(&corrugated["to_m"]) - 55.0).abs() < 1.0, "{corrugated}");
    let share = number(&document["grind"]["share_of_length"]);
    assert!((number(&document["grind"]["total_m"]) / 100.0 - share).abs() < 1e-3);
}

/// The rails of Niederwangen, as the chapter of the book reads them.
#[test]
fn the_grinding_mark_of_niederwangen_fades() {
    let sandbox = Sandbox::new();
    sandbox.copy("validation/reference/sbb-track-noise");
    let file = "validation/reference/sbb-track-noise/rail_roughness.csv";
    let document = sandbox.json(&format!("roughness {file} --json --where laboratory=MBBM --by campaign"));
    let groups = document["groups"].as_array().unwrap();
    let levels: Vec<f64> = groups
        .iter()
        .map(|group| {
            assert_eq!(group["spectra"], 8);
            let rows = group["arithmetic_mean"].as_array().unwrap();
            let near = |row: &&Value| (number(&row["wavelength_m"]) - 0.019953).abs() < 1e-6;
            number(&rows.iter().find(near).unwrap()["level_db"])
        })
        .collect();
    for (found, expected) in levels.iter().zip([-4.2, -8.4, -9.4, -10.7]) {
        assert!((found - expected).abs() <= 0.05, "{levels:?}");
    }
    let finding = document["findings"][0].as_str().unwrap();
    assert!(finding.contains("20 mm") && finding.contains("not growing corrugation"), "{finding}");
    let all = sandbox.json(&format!("roughness {file} --json"));
    let groups = all["groups"].as_array().unwrap().iter();
    let counts = groups.map(|group| number(&group["spectra"]));
    assert_eq!(counts.sum::<f64>(), 36.0);
}

// Long: starts the program 26 times.
#[test]
fn bad_files_are_refused_and_leave_nothing() {
    let sandbox = Sandbox::new();
    let good: Vec<String> = wave().lines().map(str::to_owned).collect();
    let with = |row: usize, line: &str| {
        let mut rows = good.clone();
        rows[row] = line.to_owned();
        rows.join("\n")
    };
    let constant: String = (0..5000).map(|row| format!("{},1.5\n", 1e-3 * f64::from(row))).collect();
    for (name, text, part) in [
        ("empty.csv", String::new(), "empty"),
        ("word.csv", with(700, "0.700,high"), "line 701"),
        ("mark.csv", with(700, "0.700;1,5"), "line 701"),
        ("short.csv", good[..900].join("\n"), "1 m"),
        ("constant.csv", constant, "line 1"),
        ("binary.csv", "\0\u{1}\u{2}PK".to_owned(), "binary"),
        ("words.csv", "there is\nnothing here\n".to_owned(), "line 1"),
    ] {
        fs::write(sandbox.path(name), text).unwrap();
        let outcome = sandbox.riffel(&format!("roughness {name} -o out"));
        // Lines of a sentence are broken where the terminal ends.
        let words = outcome.text.split_whitespace().filter(|word| *word != "│");
        let sentence = words.collect::<Vec<_>>().join(" ");
        assert_eq!(outcome.status, Some(2), "{name}: {sentence}");
        assert!(sentence.contains(part), "{name}: {sentence}");
        fs::remove_file(sandbox.path(name)).unwrap();
    }
    fs::write(sandbox.path("wave.csv"), wave()).unwrap();
    fs::write(sandbox.path("levels.csv"), "wavelength_mm,level_db\n20,-4\n25,-3\n").unwrap();
    for arguments in [
        "roughness levels.csv --longest \"1 m\"",
        "roughness",
        "roughness missing.csv",
        "roughness wave.csv --longest \"6 m\"",
        "roughness wave.csv --spacing \"-1 mm\"",
        "roughness wave.csv --spacing \"2 mm\"",
        "roughness wave.csv --limit no-such-limit",
        "roughness wave.csv --format missing.toml",
        "roughness wave.csv --window \"0 m\"",
        "roughness --synthesise missing.toml",
        "roughness wave.csv --merge=\"-1 m\"",
        "roughness wave.csv --along wave.csv",
        "roughness levels.csv --along line.csv",
    ] {
        let outcome = sandbox.riffel(arguments);
        assert_eq!(outcome.status, Some(2), "{arguments}: {}", outcome.text);
    }
    // What would change nothing is not taken in silence.
    for command in
        ["roughness wave.csv", "diagnose cases/nominal.toml --roughness wave.csv", "report --roughness wave.csv"]
    {
        for argument in ["--where rail=left", "--by date"] {
            let outcome = sandbox.riffel(&format!("{command} {argument} -o out"));
            assert_eq!(outcome.status, Some(2), "{command}: {}", outcome.text);
            assert!(outcome.text.contains("left out"), "{}", outcome.text);
        }
    }
    assert_eq!(sandbox.list("."), ["cases", "levels.csv", "wave.csv"]);
}
