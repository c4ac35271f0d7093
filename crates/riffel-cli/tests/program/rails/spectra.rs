//! Tables of spectra with several rails.

use std::fmt::Write as _;
use std::fs;

use super::list;
use crate::sandbox::{Sandbox, number};

/// Rails of a table of levels are judged one by one as well.
#[test]
fn rails_of_a_table_are_judged_one_by_one() {
    let sandbox = Sandbox::new();
    // The limit is 4.2 dB at 50 mm; the mean of 6 and −9 dB is 3.1 dB.
    let text = "site,rail,wavelength_mm,level_db\nA,R,50,-9\nA,R,40,-9\nA,L,50,6\nA,L,40,-2\n";
    fs::write(sandbox.path("levels.csv"), text).unwrap();
    let document = sandbox.json("roughness levels.csv --limit iso-3095-2013 --json");
    let verdicts = list(&document, "verdicts");
    assert_eq!(verdicts[0]["rail"], "L");
    assert_eq!(verdicts[0]["within"], false);
    assert_eq!(verdicts[1]["rail"], "R");
    assert_eq!(verdicts[1]["within"], true);
    let one = sandbox.json("roughness levels.csv --limit iso-3095-2013 --rail R --json");
    assert_eq!(one["verdicts"][0]["within"], true);
    assert_eq!(list(&one, "verdicts").len(), 1);
    for (arguments, part) in [("--rail M", "there are R, L"), ("--from 10", "has no positions")] {
        let outcome = sandbox.riffel(&format!("roughness levels.csv {arguments}"));
        assert_eq!(outcome.status, Some(2), "{}", outcome.text);
        assert!(outcome.sentence().contains(part), "{}", outcome.text);
    }
}

/// Rails of a table of levels are forecast one by one; within a rail the energies of other columns are averaged.
#[test]
fn rails_of_a_table_are_forecast_one_by_one() {
    let sandbox = Sandbox::new();
    // The limit is −1.1 dB at 50 mm. The mean energy of 1.0 and −20 dB of rail L is −2.0 dB; that of all four −5 dB.
    let text = "site;Schiene;wavelength_mm;level_db\nA;R;50;-9\nB;R;50;-9\nA;L;50;1\nB;L;50;-20\n";
    fs::write(sandbox.path("levels.csv"), text).unwrap();
    let command = "forecast cases/nominal.toml --traffic cases/traffic.toml --spectrum levels.csv --json";
    let both = sandbox.json(command);
    assert_eq!(both["rail"], "L");
    let mean = 10.0 * ((10_f64.powf(0.1) + 10_f64.powi(-2)) / 2.0).log10();
    assert!((number(&both["bands"][0]["level_now_db"]) - mean).abs() < 1e-12);
    let rails = list(&both, "rails");
    for (rail, name) in rails.iter().zip(["L", "R"]) {
        let alone = sandbox.json(&format!("{command} --rail {name}"));
        assert_eq!(alone["months_to_limit"], rail["months_to_limit"]);
        assert_eq!(alone["bands"], rail["bands"]);
        let chosen = sandbox.json(&format!("{command} --where Schiene={name}"));
        assert_eq!(chosen["bands"], rail["bands"]);
    }
    assert!(number(&rails[0]["months_to_limit"]) < number(&rails[1]["months_to_limit"]));
    // A rail without a band in the window of the case is left out, and said to be.
    let text = "rail,wavelength_mm,level_db\nR,1000,-9\nL,50,-4\n";
    fs::write(sandbox.path("far.csv"), text).unwrap();
    let far = sandbox.json(&command.replace("levels", "far"));
    assert_eq!(list(&far, "rails").len(), 1);
    assert!(far["remarks"].to_string().contains("rail R has no band between 20 and 80 mm"), "{}", far["remarks"]);
}

/// Of two rails in a table of levels one has a wave; it is found on that one, as if the rail were alone.
#[test]
fn rails_of_a_table_are_diagnosed_one_by_one() {
    let sandbox = Sandbox::new();
    let mut text = "section,rail,date,wavelength_mm,level_db\n".to_owned();
    for (year, wave) in [(2024, 10.0), (2025, 14.0)] {
        for (place, section) in ["A", "B", "C", "D"].iter().enumerate() {
            for (index, wavelength) in [20.0, 25.0, 31.5, 40.0, 50.0, 63.0, 80.0, 100.0].iter().enumerate() {
                // A smooth rail whose sections scatter by half a decibel, now up, now down.
                let sign = if (place + index) % 2 == 0 { 0.25 } else { -0.25 };
                let smooth = -12.0 + 1.5 * index as f64 + sign;
                let peak = if *wavelength == 50.0 { wave } else { 0.0 };
                writeln!(text, "{section},R,{year}-05-01,{wavelength},{smooth:.2}").unwrap();
                writeln!(text, "{section},L,{year}-05-01,{wavelength},{:.2}", smooth + peak).unwrap();
            }
        }
    }
    fs::write(sandbox.path("levels.csv"), text).unwrap();
    let command = "diagnose cases/nominal.toml --roughness levels.csv --speed \"108 km/h\" --json";
    let both = sandbox.json(command);
    let findings = list(&both, "dominant_wavelengths");
    assert_eq!(findings.len(), 1, "{findings:?}");
    let finding = &findings[0];
    assert_eq!(finding["rail"], "L");
    assert_eq!(number(&finding["wavelength_m"]), 0.05);
    let rails = list(finding, "rails");
    assert_eq!(rails.len(), 2);
    let level = |name: &str| {
        let rail = rails.iter().find(|rail| rail["name"] == name);
        number(&rail.unwrap()["level_db"])
    };
    assert_eq!(level("L"), number(&finding["level_db"]));
    assert!((level("L") - level("R") - 14.0).abs() < 1e-9);
    // 4 dB in 365 days.
    let slope = number(&finding["course"]["slope_db"]);
    assert!((slope - 4.0 * 365.2425 / 365.0).abs() < 1e-6, "{slope}");
    let alone = sandbox.json(&format!("{command} --rail L"));
    let mut own = alone["dominant_wavelengths"][0].clone();
    assert_eq!(own["rail"], "L");
    own["rails"] = finding["rails"].clone();
    assert_eq!(own, *finding);
    let smooth = sandbox.json(&format!("{command} --rail R"));
    assert!(list(&smooth, "dominant_wavelengths").is_empty());
    let outcome = sandbox.riffel(&format!("{} -o out", command.replace(" --json", "")));
    assert!(outcome.text.contains("rail L, 600 Hz") && outcome.text.contains("(L "), "{}", outcome.text);
}
