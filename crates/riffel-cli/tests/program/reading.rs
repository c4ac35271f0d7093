//! Records and tables that were made without Riffel, as instruments and spreadsheets write them.

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
    assert!(
        (level(0.05) - 23.01).abs() < 0.1,
        "{clothes}: {}",
        level(0.05)
    );
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

#[test]
fn the_same_rail_comes_out_of_all_clothes() {
    let sandbox = Sandbox::new();
    let rail = rail();
    let um = |height: f64| format!("{:.4}", 1e6 * height);
    let mm = |height: f64| format!("{:.7}", 1e3 * height);
    let clothes: Vec<(&str, Vec<u8>, &str)> = vec![
        (
            "heights in mm by a remark",
            table("# heights in mm\n", &rail, |x, h| {
                format!("{x:.3},{}", mm(h))
            })
            .into(),
            "",
        ),
        (
            "heights in mm by an argument",
            table("", &rail, |x, h| format!("{x:.3} {}", mm(h))).into(),
            "--height-unit mm",
        ),
        (
            "units in a line of their own, Windows-1252, CRLF, trailing semicolons",
            table(
                "Messfahrt 12; Gleis 2\nWeg;H\u{f6}he;\n[m];[\u{b5}m];\n",
                &rail,
                |x, h| format!("{};{};\r", comma(format!("{x:.3}")), comma(um(h))),
            )
            .chars()
            .map(|letter| letter as u8)
            .collect(),
            "",
        ),
        (
            "UTF-16 with tabulators",
            utf_16(&table("Abszisse [m]\tHöhe [mm]\n", &rail, |x, h| {
                format!("{x:.3}\t{}", mm(h))
            })),
            "",
        ),
        (
            "lines that end in carriage returns alone",
            table("position (m),height (µm)\n", &rail, |x, h| {
                format!("{x:.3},{}", um(h))
            })
            .replace('\n', "\r")
            .into(),
            "",
        ),
        (
            "quotes and a byte order mark",
            table("\u{feff}\"Position, m\",\"Height, um\"\n", &rail, |x, h| {
                format!("\"{x:.3}\",\"{}\"", um(h))
            })
            .into(),
            "",
        ),
        (
            "fixed width",
            table("  Position [m]    Height [um]\n", &rail, |x, h| {
                format!("{x:14.3}{:>15}", um(h))
            })
            .into(),
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
        (
            "height before position",
            table("", &rail, |x, h| format!("{};{x:.3}", um(h))).into(),
            "",
        ),
        (
            "an encoder that jitters by 0.25 mm rms, with places where it goes back",
            {
                let uneven: Vec<(f64, f64)> = rail
                    .iter()
                    .map(|(x, _)| at(x + 0.35e-3 * (1e3 * x * 78.233).sin()))
                    .collect();
                table("position m,height um\n", &uneven, |x, h| {
                    format!("{x:.5},{}", um(h))
                })
                .into()
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
#[test]
fn values_unlike_any_rail_get_no_verdict() {
    let sandbox = Sandbox::new();
    let rail = rail();
    let write = |name: &str, text: String| fs::write(sandbox.path(name), text).unwrap();
    write(
        "mm.csv",
        table("", &rail, |x, h| format!("{x:.3},{:.7}", 1e3 * h)),
    );
    write(
        "um.csv",
        table("position m,height mm\n", &rail, |x, h| {
            format!("{x:.3},{:.4}", 1e6 * h)
        }),
    );
    write(
        "step.csv",
        table("x m,z um\n", &rail, |x, h| {
            format!("{:.0},{:.4}", 1e3 * x, 1e6 * h)
        }),
    );
    write(
        "two.csv",
        table("# heights in mm\nposition_m,height_um\n", &rail, |x, h| {
            format!("{x:.3},{:.4}", 1e6 * h)
        }),
    );
    write(
        "level.csv",
        "wavelength_mm,level_db\n31.5,-118\n40,-110\n50,-105\n".to_owned(),
    );
    write(
        "alone.txt",
        table("", &rail, |_, h| format!("{:.4}", 1e6 * h)),
    );
    for (arguments, words) in [
        ("roughness mm.csv", "look like mm"),
        ("roughness mm.csv", "--height-unit mm"),
        (
            "diagnose cases/nominal.toml --roughness mm.csv",
            "look like mm",
        ),
        (
            "forecast cases/nominal.toml --spectrum mm.csv --traffic cases/traffic.toml",
            "look like mm",
        ),
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
    assert!(
        insisted.text.contains("no rail is so smooth"),
        "{}",
        insisted.text
    );
    assert!(
        !sandbox
            .list(".")
            .iter()
            .any(|name| name.ends_with("-roughness"))
    );
}

/// Levels of a wave that falls by 3 dB from date to date, written in days before months.
fn dated(dates: &[&str]) -> String {
    let mut text = "date;wavelength_mm;level_db\n".to_owned();
    for (place, date) in dates.iter().enumerate() {
        for (wavelength, level) in [
            ("31,5", 2.0),
            ("40", 3.0),
            ("50", 20.0),
            ("63", 3.0),
            ("80", 2.0),
        ] {
            let level = if wavelength == "50" {
                level - 3.0 * place as f64
            } else {
                level
            };
            text += &format!("{date};{wavelength};{}\n", comma(format!("{level:.1}")));
        }
    }
    text
}

#[test]
fn dates_are_sorted_as_dates() {
    let sandbox = Sandbox::new();
    // In the order of the file the level would rise.
    let mut rows: Vec<String> = dated(&["05.11.2023", "02.03.2024 09:30", "01.10.2024"])
        .lines()
        .map(str::to_owned)
        .collect();
    rows[1..].reverse();
    fs::write(sandbox.path("dated.csv"), rows.join("\n")).unwrap();
    let document = sandbox.json("diagnose cases/nominal.toml --roughness dated.csv --json");
    let course = &document["dominant_wavelengths"][0]["course"];
    assert!(course.to_string().contains("2023-11-05"), "{course}");
    let slope = course.to_string();
    let first = slope.find("2023-11-05").unwrap();
    assert!(
        first < slope.find("2024-03-02").unwrap() && first < slope.find("2024-10-01").unwrap(),
        "{course}"
    );
    let outcome = sandbox.riffel("roughness dated.csv --by date -o out");
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    assert!(
        outcome.text.contains("falls every time"),
        "{}",
        outcome.text
    );
    let chosen = sandbox.json("roughness dated.csv --where date=02.03.2024 --json");
    assert!((number(&chosen["spectrum"][2]["level_db"]) - 17.0).abs() < 1e-9);

    for (name, dates, words) in [
        (
            "open.csv",
            &["03/04/2024", "05/06/2024"][..],
            "may be two dates; write 2024-04-03 or 2024-03-04",
        ),
        (
            "words.csv",
            &["before grinding", "after grinding"],
            "is no date",
        ),
        ("short.csv", &["03.04.24", "05.06.24"], "two digits"),
    ] {
        fs::write(sandbox.path(name), dated(dates)).unwrap();
        for arguments in [
            format!("diagnose cases/nominal.toml --roughness {name}"),
            format!("roughness {name} --by date"),
            format!(
                "forecast cases/nominal.toml --spectrum {name} --traffic cases/traffic.toml --date-column date"
            ),
        ] {
            let outcome = sandbox.riffel(&arguments);
            assert_eq!(outcome.status, Some(2), "{arguments}: {}", outcome.text);
            let text = unwrapped(&outcome.text);
            assert!(text.contains(words), "{arguments}: {text}");
        }
    }
    let outcome = sandbox.riffel(
        "diagnose cases/nominal.toml --roughness dated.csv --earlier dated.csv --dates 01.03.2024,15.06.2023",
    );
    assert_eq!(outcome.status, Some(2), "{}", outcome.text);
    assert!(
        unwrapped(&outcome.text).contains("do not rise"),
        "{}",
        outcome.text
    );
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
    assert!(
        unwrapped(&outcome.text).contains("have no unit"),
        "{}",
        outcome.text
    );
}

#[test]
fn files_of_keys_say_where_and_what_they_are() {
    let sandbox = Sandbox::new();
    let case = fs::read_to_string(sandbox.path("cases/nominal.toml")).unwrap();
    let titled = case.replace("title = \"", "title = \"Gleisb\u{f6}gen ");
    let latin: Vec<u8> = titled
        .chars()
        .filter(char::is_ascii)
        .map(|letter| letter as u8)
        .collect();
    let at = latin
        .windows(7)
        .position(|word| word == b"Gleisbg")
        .unwrap()
        + 6;
    let mut latin = latin;
    latin.insert(at, 0xf6);
    fs::write(sandbox.path("latin.toml"), latin).unwrap();
    fs::write(sandbox.path("wide.toml"), utf_16(&case)).unwrap();
    fs::write(sandbox.path("returns.toml"), case.replace('\n', "\r")).unwrap();
    fs::write(sandbox.path("marked.toml"), format!("\u{feff}{case}")).unwrap();
    fs::write(
        sandbox.path("escape.toml"),
        case.replace("title = \"", "title = \"\\u001b[2J"),
    )
    .unwrap();
    fs::write(
        sandbox.path("raw.toml"),
        case.replace("title = \"", "title = \"\u{1b}[2J"),
    )
    .unwrap();
    fs::write(sandbox.path("large.toml"), vec![b'\n'; (16 << 20) + 1]).unwrap();
    for (name, words) in [
        (
            "latin.toml",
            "it looks like Windows-1252, where it is \"ö\"",
        ),
        ("latin.toml", "latin.toml, line"),
        (
            "wide.toml",
            "is text in UTF-16, but a case file must be UTF-8",
        ),
        (
            "escape.toml",
            "`title` is a text with the control character '\\u{1b}'",
        ),
        ("raw.toml", "not valid TOML"),
        ("large.toml", "larger than 16 MiB"),
    ] {
        let outcome = sandbox.riffel(&format!("map {name}"));
        assert_eq!(outcome.status, Some(2), "{name}: {}", outcome.text);
        let text = unwrapped(&outcome.text);
        assert!(text.contains(words), "{name}: {text}");
        assert!(!text.contains('\u{1b}'), "{name}: {text:?}");
    }
    for name in ["returns.toml", "marked.toml"] {
        let outcome = sandbox.riffel(&format!(
            "point {name} --wavelength \"40 mm\" --speed \"100 km/h\""
        ));
        assert_eq!(outcome.status, Some(0), "{name}: {}", outcome.text);
    }
    let heading = "x m,\u{1b}[2Jz um\n";
    fs::write(
        sandbox.path("rail.csv"),
        table(heading, &rail(), |x, h| format!("{x:.3},{:.4}", 1e6 * h)),
    )
    .unwrap();
    let outcome = sandbox.riffel("roughness rail.csv -o out");
    assert_eq!(outcome.status, Some(0), "{}", outcome.text);
    assert!(!outcome.text.contains('\u{1b}'), "{:?}", outcome.text);
}

/// Names of files, values of `--set` and words of files reach a message as characters that can be seen.
#[cfg(unix)]
#[test]
fn no_message_holds_control_characters() {
    let sandbox = Sandbox::new();
    let name = "a\tb\u{1b}[31m\u{7f}.toml";
    let case = fs::read_to_string(sandbox.path("cases/discrete-supports.toml")).unwrap();
    fs::write(sandbox.path(name), "no case\n").unwrap();
    let preset = case.replace("preset = \"", "preset = \"a\\tb");
    assert_ne!(case, preset);
    fs::write(sandbox.path("preset.toml"), preset).unwrap();
    for (words, said) in [
        (vec!["map", "\u{1b}[31m\t.toml"], "\\u{1b}[31m\\t.toml"),
        (vec!["map", name], "a\\tb\\u{1b}[31m\\u{7f}.toml"),
        (vec!["map", "preset.toml"], "a\\tb"),
        (vec!["roughness", name], "a\\tb\\u{1b}[31m\\u{7f}.toml"),
        (
            vec![
                "map",
                "cases/nominal.toml",
                "--set",
                "contact.friction=a\tb\u{1b}[31m",
            ],
            "a\\tb\\u{1b}[31m",
        ),
        (
            vec![
                "map",
                "cases/nominal.toml",
                "--set",
                "contact.fri\u{9b}ction=0.3",
            ],
            "fri\\u{9b}ction",
        ),
        (
            vec![
                "map",
                "cases/nominal.toml",
                "-o",
                "cases/nominal.toml/\u{1b}[31m",
            ],
            "\\u{1b}[31m",
        ),
        (vec!["init", name], "a\\tb\\u{1b}[31m\\u{7f}.toml"),
        (vec!["map", "--\u{1b}[31mfast"], "--"),
        (vec!["\u{1b}[31m\tmap"], "map"),
        (
            vec!["point", "cases/nominal.toml", "--speed", "\u{1b}]0;a\tb"],
            "--speed",
        ),
    ] {
        let output = sandbox.command().args(&words).output().unwrap();
        let text = String::from_utf8([output.stdout, output.stderr].concat()).unwrap();
        assert_eq!(output.status.code(), Some(2), "{words:?}: {text}");
        assert!(unwrapped(&text).contains(said), "{words:?}: {text}");
        let control = text.chars().find(|c| c.is_control() && *c != '\n');
        assert_eq!(control, None, "{words:?}: {text:?}");
    }
}

/// A device that never ends, as any file: a sentence after some megabytes.
#[cfg(unix)]
#[test]
fn endless_input_ends() {
    let sandbox = Sandbox::new();
    for arguments in [
        "map /dev/zero",
        "roughness /dev/zero",
        "roughness --synthesise /dev/zero",
        "roughness cases/roughness-recipe.toml --format /dev/zero",
        "roughness cases/roughness-recipe.toml --limit /dev/zero.toml",
        "map cases/nominal.toml --observations /dev/zero",
        "forecast cases/nominal.toml --spectrum /dev/zero --traffic cases/traffic.toml",
        "forecast cases/nominal.toml --spectrum /dev/zero --traffic /dev/zero",
        "compare cases/nominal.toml --with /dev/zero",
        "report --site /dev/zero --roughness /dev/zero",
        "diagnose cases/nominal.toml --roughness /dev/urandom",
        "study /dev/zero",
    ] {
        let outcome = sandbox.riffel(arguments);
        assert_eq!(outcome.status, Some(2), "{arguments}: {}", outcome.text);
        assert!(
            !outcome.text.contains("panicked"),
            "{arguments}: {}",
            outcome.text
        );
    }
    let line = vec![b'1'; 3 << 20];
    fs::write(sandbox.path("line.txt"), line).unwrap();
    assert_eq!(sandbox.riffel("roughness line.txt").status, Some(2));
}

/// A length is converted, whatever it is called.
#[test]
fn lengths_of_the_inch_are_read_as_such() {
    let sandbox = Sandbox::new();
    let rail = rail();
    for (heading, position, height) in [
        ("x [ft],left [mil]\n", 0.3048, 25.4e-6),
        ("x_ft,left_in\n", 0.3048, 25.4e-3),
        ("Weg [yd],links [thou]\n", 0.9144, 25.4e-6),
        ("Miles,height [um]\n", 1609.344, 1e-6),
        ("x [dm],left (um)\n", 0.1, 1e-6),
        ("[ft],[mil]\n", 0.3048, 25.4e-6),
    ] {
        let text = table(heading, &rail, |x, h| {
            format!("{:.9},{:.9}", x / position, h / height)
        });
        fs::write(sandbox.path("rail.csv"), text).unwrap();
        check_wave(&sandbox.json("roughness rail.csv --json"), heading);
    }
}

/// What is no length is refused with its column, and nothing is written.
#[test]
fn other_units_of_positions_and_heights_are_refused() {
    let sandbox = Sandbox::new();
    let rail = rail();
    for (heading, part) in [
        (
            "x [furlong],left_um",
            "column 1, \"x [furlong]\", gives furlong",
        ),
        ("Weg [Fuss],left_um", "column 1, \"Weg [Fuss]\", gives Fuss"),
        ("x [hm],left_um", "column 1, \"x [hm]\", gives hm"),
        ("t_s,left_um", "column 1, \"t_s\", gives s"),
        ("x_m,left [°]", "column 2, \"left [°]\", gives °"),
        ("x_m,left [dB]", "column 2, \"left [dB]\", gives dB"),
        (
            "x_m,left [10 um]",
            "column 2, \"left [10 um]\", gives 10 um",
        ),
    ] {
        let text = table(&format!("{heading}\n"), &rail, |x, h| {
            format!("{x:.3},{:.4}", 1e6 * h)
        });
        fs::write(sandbox.path("rail.csv"), text).unwrap();
        let outcome = sandbox.riffel("roughness rail.csv -o out");
        let sentence = unwrapped(&outcome.text);
        assert_eq!(outcome.status, Some(2), "{heading}: {sentence}");
        assert!(sentence.contains(part), "{heading}: {sentence}");
        assert!(!sandbox.path("out").exists());
        // Who knows better says so.
        let said = if part.contains("column 1") {
            "--position-unit m"
        } else {
            "--height-unit um"
        };
        check_wave(
            &sandbox.json(&format!("roughness rail.csv --json {said}")),
            heading,
        );
    }
}

#[test]
fn references_of_levels_are_converted_or_refused() {
    let sandbox = Sandbox::new();
    let read = |wavelength: &str, size: f64, level: &str, shift: f64| {
        let rows = [(0.08, 4.0), (0.063, 3.0), (0.05, 2.0), (0.04, 1.0)]
            .map(|(length, db)| format!("{},{}\n", length / size, db + shift));
        let text = format!("{wavelength},{level}\n{}", rows.concat());
        fs::write(sandbox.path("levels.csv"), text).unwrap();
        sandbox.riffel("roughness levels.csv --json")
    };
    for (wavelength, size, level, shift) in [
        ("wavelength_mm", 1e-3, "level_db", 0.0),
        ("wavelength_mm", 1e-3, "level [dB re 1 nm]", 60.0),
        ("wavelength [m]", 1.0, "level [dB re 1e-9 m]", 60.0),
        ("wavelength_in", 0.0254, "level [dB re 1 um]", 0.0),
    ] {
        let outcome = read(wavelength, size, level, shift);
        let document: Value = serde_json::from_str(&outcome.text).unwrap();
        let levels = document["spectrum"].as_array().unwrap().iter();
        let levels: Vec<f64> = levels.map(|row| number(&row["level_db"])).collect();
        for (found, expected) in levels.iter().zip([1.0, 2.0, 3.0, 4.0]) {
            assert!((found - expected).abs() < 1e-9, "{level}: {levels:?}");
        }
    }
    for (wavelength, size, level, part) in [
        (
            "wavelength_mm",
            1e-3,
            "level [dB re 20 uPa]",
            "is in dB re 20 uPa",
        ),
        ("wavelength_mm", 1e-3, "level_nm", "is in nm"),
        ("wavelength_mm", 1e-3, "amplitude_um", "is in um"),
        ("wavelength_mm", 1e-3, "speed_kmh", "is in kmh"),
        ("wavelength [m]", 1e-3, "level_db", "between 1 mm and 10 m"),
        ("wavelength [Fuss]", 0.3, "level_db", "is in Fuss"),
    ] {
        let outcome = read(wavelength, size, level, 0.0);
        let sentence = unwrapped(&outcome.text);
        assert_eq!(outcome.status, Some(2), "{level}: {sentence}");
        assert!(sentence.contains(part), "{level}: {sentence}");
    }
}

/// What stands in the way of a position is named.
#[test]
fn tables_without_a_position_say_what_they_have() {
    let sandbox = Sandbox::new();
    let rail = rail();
    let rows = |heading: &str, row: &dyn Fn(usize, f64) -> String| {
        let rows = rail.iter().enumerate();
        let rows = rows.map(|(index, &(_, height))| row(index, 1e6 * height) + "\n");
        format!("{heading}\n{}", rows.collect::<String>())
    };
    let counted = |index: usize, height: f64| format!("{index},{height:.4},{:.4}", height + 1.0);
    let timed = |index: usize, height: f64| format!("{:.3},{height:.4}", 1e-3 * index as f64);
    let commas = |index: usize, height: f64| {
        comma(format!("{:.3};{height:.4}", 1e-3 * index as f64)).replace(';', ",")
    };
    for (text, part) in [
        (
            rows("sample,left_um,right_um", &counted),
            "column 1, \"sample\", is a counter or a time",
        ),
        (
            rows("time_s,left_um", &timed),
            "column 1, \"time_s\", is a counter or a time",
        ),
        (
            rows("Zeit [s],Hoehe [um]", &timed),
            "column 1, \"Zeit [s]\", is a counter or a time",
        ),
        (
            rows("x_m,left_um", &commas),
            "line 2: has 4 columns, but its head has 2",
        ),
    ] {
        fs::write(sandbox.path("rail.csv"), text).unwrap();
        let outcome = sandbox.riffel("roughness rail.csv");
        let sentence = unwrapped(&outcome.text);
        assert_eq!(outcome.status, Some(2), "{sentence}");
        assert!(sentence.contains(part), "{sentence}");
    }
    let text = rows("sample,left_um", &|index, height| {
        format!("{index},{height:.4}")
    });
    fs::write(sandbox.path("rail.csv"), text).unwrap();
    let document = sandbox.json("roughness rail.csv --spacing \"1 mm\" --json");
    check_wave(&document, "a counter and the spacing");
}

#[test]
fn empty_files_are_named() {
    let sandbox = Sandbox::new();
    fs::write(sandbox.path("empty.toml"), "\n").unwrap();
    for command in [
        "map empty.toml",
        "study empty.toml",
        "forecast cases/nominal.toml --traffic empty.toml --from-limit 3",
        "compare cases/nominal.toml --with empty.toml --traffic cases/traffic.toml",
        "report cases/nominal.toml --site empty.toml",
        "map cases/nominal.toml --observations empty.toml",
        "roughness empty.toml",
    ] {
        let outcome = sandbox.riffel(command);
        let sentence = unwrapped(&outcome.text);
        assert_eq!(outcome.status, Some(2), "{command}: {sentence}");
        assert!(
            sentence.contains("empty.toml: the file "),
            "{command}: {sentence}"
        );
    }
}

/// What is wrong on a command line is said in the words of its options.
#[test]
fn wrong_arguments_are_named() {
    let sandbox = Sandbox::new();
    for (command, part) in [
        (
            "point cases/nominal.toml --wavelength \"-55 mm\" --speed \"80 km/h\"",
            "--wavelength is -55 mm, but must be between",
        ),
        (
            "init nowhere/case.toml",
            "nowhere/case.toml: there is no folder nowhere",
        ),
        (
            "forecast cases/nominal.toml --traffic cases/traffic.toml",
            "--spectrum is left out, but must be given, or else --ground or --from-",
        ),
    ] {
        let outcome = sandbox.riffel(command);
        let sentence = unwrapped(&outcome.text);
        assert_eq!(outcome.status, Some(2), "{command}: {sentence}");
        assert!(sentence.contains(part), "{command}: {sentence}");
    }
    // Neighbouring speeds are told apart.
    let outcome = sandbox.riffel(
        "map cases/nominal.toml -o out --set 'map.speed={min=\"18 km/h\",max=\"20 km/h\"}'",
    );
    assert!(
        outcome.text.contains("  18.0 ") && outcome.text.contains("  18.2 "),
        "{}",
        outcome.text
    );
}
