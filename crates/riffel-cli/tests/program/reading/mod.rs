//! Records and tables that were made without Riffel, as instruments and spreadsheets write them.

mod cells;
mod dates;
mod refusals;
mod spectra;
mod units;

use std::f64::consts::TAU;
use std::fs;

use serde_json::Value;

use crate::sandbox::{Sandbox, number};

/// Amplitude of the test rail \[m\].
const AMPLITUDE: f64 = 20e-6;

/// Positions \[m\] and heights \[m\]: 10 m of a wave of 50 mm.
fn rail() -> Vec<(f64, f64)> {
    (0..10_000).map(|row| at(1e-3 * f64::from(row))).collect()
}

fn at(x: f64) -> (f64, f64) {
    (x, AMPLITUDE * (TAU * x / 0.05).sin())
}

/// A table of rows, below a heading.
fn table(heading: &str, rows: &[(f64, f64)], row: impl Fn(f64, f64) -> String) -> String {
    let rows = rows.iter().map(|&(x, height)| row(x, height));
    heading.to_owned() + &rows.map(|row| row + "\n").collect::<String>()
}

/// Levels \[dB re 1 µm\] of 31.5, 50 and 80 mm. The wave has 20 lg(20/√2) = 23.0 dB, less what the neighbouring bands
/// take of its line.
fn check_wave(document: &Value, clothes: &str) {
    let level = |wavelength: f64| {
        let rows = document["spectrum"].as_array().unwrap();
        let near = |row: &&Value| (number(&row["wavelength_m"]) / wavelength - 1.0).abs() < 0.1;
        number(&rows.iter().find(near).unwrap()["level_db"])
    };
    assert!((level(0.05) - 23.01).abs() < 0.1, "{clothes}: {}", level(0.05));
    assert!(level(0.0315) < 3.0 && level(0.08) < 3.0, "{clothes}");
}

/// A message without the breaks and bars with which it is shown.
fn unwrapped(text: &str) -> String {
    let words = text.split_whitespace().filter(|word| *word != "│");
    words.collect::<Vec<_>>().join(" ")
}

fn comma(number: String) -> String {
    number.replace('.', ",")
}

/// UTF-16 with its mark, the low byte first, as spreadsheets write "Unicode text".
fn utf_16(text: &str) -> Vec<u8> {
    let units = std::iter::once(0xfeff).chain(text.encode_utf16());
    units.flat_map(u16::to_le_bytes).collect()
}

// Long: reads and judges fifteen records of 10 000 heights.
#[test]
fn the_same_rail_comes_out_of_all_clothes() {
    let sandbox = Sandbox::new();
    let rail = rail();
    let um = |height: f64| format!("{:.4}", 1e6 * height);
    let mm = |height: f64| format!("{:.7}", 1e3 * height);
    let clothes: Vec<(&str, Vec<u8>, &str)> = vec![
        ("heights in mm by a remark", table("# heights in mm\n", &rail, |x, h| format!("{x:.3},{}", mm(h))).into(), ""),
        (
            "heights in mm by an argument",
            table("", &rail, |x, h| format!("{x:.3} {}", mm(h))).into(),
            "--height-unit mm",
        ),
        (
            "units in a line of their own, Windows-1252, CRLF, trailing semicolons",
            table("Messfahrt 12; Gleis 2\nWeg;H\u{f6}he;\n[m];[\u{b5}m];\n", &rail, |x, h| {
                format!("{};{};\r", comma(format!("{x:.3}")), comma(um(h)))
            })
            .chars()
            .map(|letter| letter as u8)
            .collect(),
            "",
        ),
        (
            "UTF-16 with tabulators",
            utf_16(&table("Abszisse [m]\tHöhe [mm]\n", &rail, |x, h| format!("{x:.3}\t{}", mm(h)))),
            "",
        ),
        (
            "lines that end in carriage returns alone",
            table("position (m),height (µm)\n", &rail, |x, h| format!("{x:.3},{}", um(h))).replace('\n', "\r").into(),
            "",
        ),
        (
            "quotes and a byte order mark",
            table("\u{feff}\"Position, m\",\"Height, um\"\n", &rail, |x, h| format!("\"{x:.3}\",\"{}\"", um(h))).into(),
            "",
        ),
        (
            "fixed width",
            table("  Position [m]    Height [um]\n", &rail, |x, h| format!("{x:14.3}{:>15}", um(h))).into(),
            "",
        ),
        (
            "kilometrage",
            table("Station;z_um\n", &rail, |x, h| {
                let x = 12_400.0 + x;
                format!("{}+{:07.3};{}", (x / 1e3).floor(), x % 1e3, um(h))
            })
            .into(),
            "",
        ),
        (
            "kilometrage with words, in a column called km",
            table("km;Hoehe [mm]\n", &rail, |x, h| {
                let x = 12_400.0 + x;
                let metres = comma(format!("{:07.3}", x % 1e3));
                format!("km {}+{metres};{}", (x / 1e3).floor(), comma(mm(h)))
            })
            .into(),
            "",
        ),
        (
            "thousands apart",
            table("Weg [m];Höhe [µm]\n", &rail, |x, h| {
                format!("12.{};{}", comma(format!("{:.3}", 400.0 + x)), comma(um(h)))
            })
            .into(),
            "",
        ),
        (
            "remarks here and there",
            table("position m,height um,remark\n", &rail, |x, h| {
                let remark = if x % 1.0 < 2e-4 { ",joint, welded" } else { "" };
                format!("{x:.3},{}{remark}", um(h))
            })
            .into(),
            "",
        ),
        (
            "words behind blanks",
            table("", &rail, |x, h| {
                let remark = if x % 1.0 < 2e-4 { "  a joint here" } else { "" };
                format!("{x:.3} {}{remark}", um(h))
            })
            .into(),
            "",
        ),
        ("height before position", table("", &rail, |x, h| format!("{};{x:.3}", um(h))).into(), ""),
        (
            "an encoder that jitters by 0.25 mm rms, with places where it goes back",
            {
                let uneven: Vec<(f64, f64)> =
                    rail.iter().map(|(x, _)| at(x + 0.35e-3 * (1e3 * x * 78.233).sin())).collect();
                table("position m,height um\n", &uneven, |x, h| format!("{x:.5},{}", um(h))).into()
            },
            "",
        ),
        (
            "positions in mm by an argument",
            table("x;z\n", &rail, |x, h| format!("{:.2};{}", 1e3 * x, um(h))).into(),
            "--position-unit mm",
        ),
    ];
    for (clothes, text, arguments) in clothes {
        fs::write(sandbox.path("rail.txt"), text).unwrap();
        let document = sandbox.json(&format!("roughness rail.txt --json {arguments}"));
        check_wave(&document, clothes);
        assert_eq!(document["rails"].as_array().unwrap().len(), 1, "{clothes}");
    }
}

/// No verdict, no file, status 2, and what to do.
// Long: starts the program thirteen times, most with a record of 10 000 heights.
#[test]
fn values_unlike_any_rail_get_no_verdict() {
    let sandbox = Sandbox::new();
    let rail = rail();
    let write = |name: &str, text: String| fs::write(sandbox.path(name), text).unwrap();
    write("mm.csv", table("", &rail, |x, h| format!("{x:.3},{:.7}", 1e3 * h)));
    write("um.csv", table("position m,height mm\n", &rail, |x, h| format!("{x:.3},{:.4}", 1e6 * h)));
    write("step.csv", table("x m,z um\n", &rail, |x, h| format!("{:.0},{:.4}", 1e3 * x, 1e6 * h)));
    write("two.csv", table("# heights in mm\nposition_m,height_um\n", &rail, |x, h| format!("{x:.3},{:.4}", 1e6 * h)));
    write("level.csv", "wavelength_mm,level_db\n31.5,-118\n40,-110\n50,-105\n".to_owned());
    write("alone.txt", table("", &rail, |_, h| format!("{:.4}", 1e6 * h)));
    for (arguments, words) in [
        ("roughness mm.csv", "look like mm"),
        ("roughness mm.csv", "--height-unit mm"),
        ("diagnose cases/nominal.toml --roughness mm.csv", "look like mm"),
        ("forecast cases/nominal.toml --spectrum mm.csv --traffic cases/traffic.toml", "look like mm"),
        ("report --roughness mm.csv", "look like mm"),
        ("roughness um.csv", "look like um"),
        ("roughness step.csv", "--position-unit mm"),
        ("roughness two.csv", "line 1 says heights in mm"),
        ("roughness level.csv", "dB re 1 m"),
        ("roughness alone.txt --spacing 1", "--spacing \"1 mm\""),
        ("roughness mm.csv --height-unit kg", "no unit of length"),
        ("roughness level.csv --height-unit mm", "for profiles"),
    ] {
        let outcome = sandbox.riffel(arguments);
        assert_eq!(outcome.status, Some(2), "{arguments}: {}", outcome.text);
        let text = unwrapped(&outcome.text);
        assert!(text.contains(words), "{arguments}: {text}");
        assert!(!text.contains("limit"), "{arguments}: {text}");
    }
    let insisted = sandbox.riffel("roughness mm.csv --height-unit um --json");
    assert_eq!(insisted.status, Some(0), "{}", insisted.text);
    assert!(insisted.text.contains("no rail is so smooth"), "{}", insisted.text);
    assert!(!sandbox.list(".").iter().any(|name| name.ends_with("-roughness")));
}
