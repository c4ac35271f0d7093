//! Tables of spectra: dates, and a column for each band.

use std::fs;

use serde_json::Value;

use super::{comma, unwrapped};
use crate::sandbox::{Sandbox, number};

/// Levels of a wave that falls by 3 dB from date to date, written in days before months.
fn dated(dates: &[&str]) -> String {
    let mut text = "date;wavelength_mm;level_db\n".to_owned();
    for (place, date) in dates.iter().enumerate() {
        for (wavelength, level) in [("31,5", 2.0), ("40", 3.0), ("50", 20.0), ("63", 3.0), ("80", 2.0)] {
            let level = if wavelength == "50" { level - 3.0 * place as f64 } else { level };
            text += &format!("{date};{wavelength};{}\n", comma(format!("{level:.1}")));
        }
    }
    text
}

#[test]
fn dates_are_sorted_as_dates() {
    let sandbox = Sandbox::new();
    // In the order of the file the level would rise.
    let mut rows: Vec<String> =
        dated(&["05.11.2023", "02.03.2024 09:30", "01.10.2024"]).lines().map(str::to_owned).collect();
    rows[1..].reverse();
    fs::write(sandbox.path("dated.csv"), rows.join("\n")).unwrap();
    let document = sandbox.json("diagnose cases/nominal.toml --roughness dated.csv --json");
    let course = &document["dominant_wavelengths"][0]["course"];
    assert!(course.to_string().contains("2023-11-05"), "{course}");
    let slope = course.to_string();
    let first = slope.find("2023-11-05").unwrap();
    assert!(first < slope.find("2024-03-02").unwrap() && first < slope.find("2024-10-01").unwrap(), "{course}");
    let outcome = sandbox.riffel("roughness dated.csv --by date -o out");
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    assert!(outcome.text.contains("falls every time"), "{}", outcome.text);
    let chosen = sandbox.json("roughness dated.csv --where date=02.03.2024 --json");
    assert!((number(&chosen["spectrum"][2]["level_db"]) - 17.0).abs() < 1e-9);

    for (name, dates, words) in [
        ("open.csv", &["03/04/2024", "05/06/2024"][..], "may be two dates; write 2024-04-03 or 2024-03-04"),
        ("words.csv", &["before grinding", "after grinding"], "is no date"),
        ("short.csv", &["03.04.24", "05.06.24"], "two digits"),
    ] {
        fs::write(sandbox.path(name), dated(dates)).unwrap();
        for arguments in [
            format!("diagnose cases/nominal.toml --roughness {name}"),
            format!("roughness {name} --by date"),
            format!("forecast cases/nominal.toml --spectrum {name} --traffic cases/traffic.toml --date-column date"),
        ] {
            let outcome = sandbox.riffel(&arguments);
            assert_eq!(outcome.status, Some(2), "{arguments}: {}", outcome.text);
            let text = unwrapped(&outcome.text);
            assert!(text.contains(words), "{arguments}: {text}");
        }
    }
    let outcome = sandbox
        .riffel("diagnose cases/nominal.toml --roughness dated.csv --earlier dated.csv --dates 01.03.2024,15.06.2023");
    assert_eq!(outcome.status, Some(2), "{}", outcome.text);
    assert!(unwrapped(&outcome.text).contains("days that rise from each record to the next"), "{}", outcome.text);
}

#[test]
fn tables_with_a_column_for_each_band_are_read() {
    let sandbox = Sandbox::new();
    fs::write(sandbox.path("long.csv"), dated(&["2024-01-01"])).unwrap();
    let expected = sandbox.json("roughness long.csv --json");
    let row = "Bern;links;2,0;3,0;20,0;3,0;2,0\n";
    for wide in [
        format!("Ort;Schiene;31,5 mm;40 mm;50 mm;63 mm;80 mm\n{row}"),
        format!("site;rail;L_31.5mm;L_40mm;L_50mm;L_63mm;L_80mm\n{row}"),
        format!("site;rail / wavelength mm;31,5;40;50;63;80\n{row}"),
        "wavelength_mm;left;right\n31,5;2;2\n40;3;3\n50;20;20\n63;3;3\n80;2;2\n".to_owned(),
    ] {
        fs::write(sandbox.path("wide.csv"), &wide).unwrap();
        let found = sandbox.json("roughness wide.csv --json");
        for band in 0..5 {
            let level = |document: &Value| number(&document["spectrum"][band]["level_db"]);
            assert!((level(&found) - level(&expected)).abs() < 1e-9, "{wide}");
        }
    }
    let bare = "site;rail;31,5;40;50;63;80\nBern;links;2,0;3,0;20,0;3,0;2,0\n";
    fs::write(sandbox.path("bare.csv"), bare).unwrap();
    let outcome = sandbox.riffel("roughness bare.csv");
    assert_eq!(outcome.status, Some(2), "{}", outcome.text);
    assert!(unwrapped(&outcome.text).contains("have no unit"), "{}", outcome.text);
}
