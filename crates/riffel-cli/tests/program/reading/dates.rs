//! Dates of tables and profiles: what is told is of the last, or a column that is not read is refused by every command.

use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::fs;

use serde_json::Value;

use crate::sandbox::{Sandbox, number};

/// Bands of a table, and their levels in 2024.
const LEVELS: [(f64, f64); 6] = [(20.0, -12.0), (25.0, -11.0), (31.5, -10.0), (40.0, -9.0), (50.0, -8.0), (63.0, -7.0)];

/// Levels of three years that rise by 4 dB a year.
fn levels(dates: [&str; 3]) -> String {
    let mut text = "date;wavelength_mm;level_db\n".to_owned();
    for (year, date) in dates.iter().enumerate() {
        for (wavelength, level) in LEVELS {
            writeln!(text, "{date};{wavelength};{}", level + 4.0 * year as f64).unwrap();
        }
    }
    text
}

/// Every command that reads levels of a rail.
const COMMANDS: [&str; 9] = [
    "roughness FILE --json",
    "noise cases/bhaskar-track.toml --roughness FILE --speed \"100 km/h\" --json",
    "diagnose cases/nominal.toml --roughness FILE --speed \"100 km/h\" --json",
    "forecast cases/nominal.toml --traffic cases/traffic.toml --spectrum FILE --json",
    "forecast cases/nominal.toml --traffic cases/traffic.toml --spectrum FILE --date-column date --json",
    "forecast cases/nominal.toml --traffic cases/traffic.toml --ground FILE --json",
    "compare cases/nominal.toml --traffic cases/traffic.toml --with cases/soft-pads.toml --spectrum FILE --json",
    "report cases/nominal.toml --roughness FILE --speed \"100 km/h\" -o report",
    "roughness FILE --by date --json",
];

#[test]
fn a_column_of_dates_that_is_not_read_is_refused_by_every_command() {
    let sandbox = Sandbox::new();
    for (dates, part) in [
        (["06/01/2024", "06/01/2025", "06/01/2026"], "may be two dates"),
        (["Jun 2024", "Jun 2025", "Jun 2026"], "is no date"),
    ] {
        fs::write(sandbox.path("rail.csv"), levels(dates)).unwrap();
        for command in COMMANDS {
            let outcome = sandbox.riffel(&command.replace("FILE", "rail.csv"));
            let sentence = outcome.sentence();
            assert_eq!(outcome.status, Some(2), "{command}: {sentence}");
            assert!(sentence.contains("column `date`") && sentence.contains(part), "{command}: {sentence}");
        }
    }
}

/// Levels by the days of a spreadsheet are those by dates, of the last year: 8 dB more than in 2024.
#[test]
fn the_days_of_a_spreadsheet_are_dates() {
    let sandbox = Sandbox::new();
    for (name, dates) in
        [("plain.csv", ["2024-06-01", "2025-06-01", "2026-06-01"]), ("days.csv", ["45444", "45809", "46174"])]
    {
        fs::write(sandbox.path(name), levels(dates)).unwrap();
    }
    for command in [COMMANDS[1], COMMANDS[4]] {
        let answer = |name: &str| {
            let mut answer = sandbox.json(&command.replace("FILE", name));
            for key in ["inputs", "spectrum", "file", "remarks", "warnings", "roughness"] {
                answer.as_object_mut().unwrap().remove(key);
            }
            if let Some(fit) = answer.get_mut("wear_fit").and_then(Value::as_object_mut) {
                fit.remove("remarks");
            }
            answer
        };
        assert_eq!(answer("plain.csv"), answer("days.csv"), "{command}");
    }
    let told = sandbox.riffel("roughness days.csv -o out").sentence();
    assert!(told.contains("45444 is read as 2024-06-01"), "{told}");
    assert!(told.contains("of 3 dates"), "{told}");
}

/// 10 m of a wave of 50 mm, `wave` µm high, and steps within half a micrometre.
fn profile(date: &str, wave: f64) -> String {
    let mut text = String::new();
    for sample in 0..2000u32 {
        let x = 5e-3 * f64::from(sample);
        let step = f64::from(sample.wrapping_mul(2_654_435_761) >> 16) / 65_536.0 - 0.5;
        writeln!(text, "{date},{x:.3},{:.3}", wave * (TAU * x / 0.05).sin() + step).unwrap();
    }
    text
}

/// A rail that was ground since the former survey is what it is now: within, and nothing to grind.
// Long: asks fifteen questions about profiles of two dates.
#[test]
fn the_survey_before_grinding_leads_no_answer() {
    let sandbox = Sandbox::new();
    let head = "date,x_m,height_um\n";
    let (before, now) = (profile("2025-06-01", 16.0), profile("2026-06-01", 1.0));
    fs::write(sandbox.path("both.csv"), format!("{head}{before}{now}")).unwrap();
    fs::write(sandbox.path("turned.csv"), format!("{head}{now}{before}")).unwrap();
    fs::write(sandbox.path("now.csv"), format!("{head}{now}")).unwrap();
    let of = |command: &str, name: &str| {
        let mut answer = sandbox.json(&command.replace("FILE", name));
        for key in ["file", "warnings", "remarks", "spectrum_file"] {
            answer.as_object_mut().unwrap().remove(key);
        }
        answer
    };
    for (command, keys) in [
        (COMMANDS[0], ["verdicts", "grind"]),
        (COMMANDS[1], ["total_dba", "bands"]),
        // Bands that were not ground go on as they were measured.
        (COMMANDS[3], ["months_to_limit", "spectrum_now"]),
    ] {
        for name in ["both.csv", "turned.csv"] {
            let (one, other) = (of(command, name), of(command, "now.csv"));
            for key in keys {
                assert_eq!(one.get(key), other.get(key), "{command} {name} {key}");
            }
        }
    }
    let judged = sandbox.json("roughness both.csv --json");
    assert_eq!(judged["rails"].as_array().unwrap().len(), 1);
    assert_eq!(judged["rails"][0]["name"], "height");
    assert!(judged["verdicts"].as_array().unwrap().iter().all(|one| one["within"] == true));
    let told = judged["warnings"].to_string();
    assert!(told.contains("2026-06-01, and before it stands that of 2025-06-01"), "{told}");
    // A rail that grows: the former date is the earlier record of a diagnosis and of a forecast.
    let grown = profile("2025-06-01", 8.0) + &profile("2026-06-01", 16.0);
    fs::write(sandbox.path("grown.csv"), format!("{head}{grown}")).unwrap();
    let found = of(COMMANDS[2], "grown.csv");
    let course = &found["dominant_wavelengths"][0]["course"];
    // 20 lg 2 in 365 days; steps of half a micrometre are 30 dB lower.
    let slope = number(&course["slope_db"]);
    assert!((slope - 20.0 * 2f64.log10()).abs() < 0.1, "{course}");
    let told = sandbox.riffel(&COMMANDS[4].replace("FILE", "grown.csv").replace(" --json", " -o forecast"));
    assert!(told.text.contains("between 1 and 1 records"), "{}", told.text);
}

/// One line in two columns of rails and dates: rails are rails, dates are dates.
#[test]
fn rails_are_rails_and_dates_are_dates() {
    let sandbox = Sandbox::new();
    let mut text = "rail,date,x_m,height_um\n".to_owned();
    for (rail, date, wave) in [
        ("left", "2025-06-01", 16.0),
        ("right", "2025-06-01", 1.0),
        ("left", "2026-06-01", 1.0),
        ("right", "2026-06-01", 16.0),
    ] {
        for row in profile(date, wave).lines() {
            writeln!(text, "{rail},{row}").unwrap();
        }
    }
    fs::write(sandbox.path("rails.csv"), text).unwrap();
    let judged = sandbox.json("roughness rails.csv --json");
    assert_eq!(judged["worst_rail"], "right");
    let names: Vec<&str> =
        (judged["rails"].as_array().unwrap().iter()).map(|rail| rail["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["right", "left"]);
    // By whatever name the rail is asked for.
    for name in ["left", "links", "L", "1"] {
        let one = sandbox.json(&format!("roughness rails.csv --rail {name} --json"));
        assert_eq!(one["rails"][0]["name"], "left", "{name}");
    }
}

/// A device that changes along the dates is told, and what devices differ by is no growth; of one device nothing is said.
// Long: judges levels of four dates for each of its devices.
#[test]
fn growth_is_that_of_one_device() {
    let sandbox = Sandbox::new();
    let dates = ["2024-06-01", "2025-06-01", "2025-06-01", "2026-06-01"];
    let with = |devices: [(&str, f64); 4]| {
        let mut text = "device;date;wavelength_mm;level_db\n".to_owned();
        for ((device, offset), (date, year)) in devices.iter().zip(dates.iter().zip([0.0, 1.0, 1.0, 2.0])) {
            // A device measures once a day.
            if text.contains(&format!("{device};{date}")) {
                continue;
            }
            for (wavelength, level) in LEVELS {
                writeln!(text, "{device};{date};{wavelength};{}", level + 4.0 * year + offset).unwrap();
            }
        }
        fs::write(sandbox.path("rail.csv"), text).unwrap();
        let command = |at: usize| COMMANDS[at].replace("FILE", "rail.csv");
        let told = |at: usize| sandbox.riffel(&command(at).replace(" --json", " -o out")).sentence();
        let told = [told(0), told(2), told(4)];
        (sandbox.json(&command(4))["wear_fit"]["bands"].clone(), told)
    };
    let (bands, told) = with([("T1", 0.0); 4]);
    assert!(!told.concat().contains("column `device`"), "{told:?}");
    let (t1, t2) = (("T1", 0.0), ("T2", 3.0));
    let (of_both, told) = with([t1, t1, t2, t2]);
    assert!(told[0].contains("changes along the dates, from T1 to T2"), "{}", told[0]);
    for told in &told[1..] {
        assert!(told.contains("levels of T1 count +3.0 dB"), "{told}");
    }
    for (one, both) in bands.as_array().unwrap().iter().zip(of_both.as_array().unwrap()) {
        let change = |band: &Value| number(&band["measured_change_db"]);
        // 4 dB a year over two years.
        assert!((change(one) - 8.0).abs() < 1e-9 && (change(both) - 8.0).abs() < 1e-9);
    }
    let (none, told) = with([t1, t1, t1, t2]);
    assert!(none.is_null() && told[2].contains("T1 is left out of growth"), "{none} {}", told[2]);
}

/// What was before, of a rail of which nothing is known now, is one too many.
#[test]
fn an_earlier_record_is_refused_beside_a_ground_rail() {
    let sandbox = Sandbox::new();
    fs::write(sandbox.path("rail.csv"), levels(["2024-06-01", "2025-06-01", "2026-06-01"])).unwrap();
    let forecast = "forecast cases/nominal.toml --traffic cases/traffic.toml";
    for option in [
        "--earlier rail.csv",
        "--earlier rail.csv --dates 2024-06-01,2025-06-01",
        "--date-column date",
        "--where date=2024-06-01",
        "--earlier-where date=2024-06-01",
        "--passages-between 1e6",
    ] {
        let outcome = sandbox.riffel(&format!("{forecast} --from-limit=-6 {option}"));
        assert_eq!(outcome.status, Some(2), "{}", outcome.text);
        assert!(outcome.sentence().contains("--spectrum"), "{}", outcome.text);
    }
    // Nor is a record taken of which nobody says when it was.
    for command in [
        "noise cases/main-line.toml --roughness rail.csv --speed \"100 km/h\"",
        "compare cases/nominal.toml --traffic cases/traffic.toml --with cases/soft-pads.toml --spectrum rail.csv",
    ] {
        let outcome = sandbox.riffel(&format!("{command} --earlier rail.csv"));
        assert_eq!(outcome.status, Some(2), "{}", outcome.text);
        assert!(outcome.sentence().contains("--dates"), "{}", outcome.text);
    }
}
