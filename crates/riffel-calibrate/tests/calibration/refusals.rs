//! Plans and data that cannot be used: a sentence with key, value and rule.

use std::fs;

use riffel_calibrate::Plan;
use riffel_keys::{CaseError, Language};
use tempfile::TempDir;

use crate::{copy_set, folder};

/// A copy of set b or c with a text in a file in place of another.
fn changed(set: &str, file: &str, from: &str, to: &str) -> (TempDir, Result<Plan, CaseError>) {
    let copy = TempDir::new().unwrap();
    copy_set(set, copy.path());
    let path = copy.path().join(file);
    let text = fs::read_to_string(&path).unwrap();
    assert!(text.contains(from), "{from}");
    fs::write(&path, text.replacen(from, to, 1)).unwrap();
    let plan = Plan::read(&copy.path().join("plan.toml"));
    (copy, plan)
}

#[test]
fn what_cannot_be_used_is_said() {
    let (b, c) = ("b-three-dates", "c-all-together");
    // The file is the plan unless it is named; + stands for what was there.
    for (set, from, to, parts) in [
        // Data outside the window of the case.
        (b, "case.toml: min = \"36 mm\"", "min = \"60 mm\"", &["50.1", "outside the window", "60.0"][..]),
        // Decisions.
        (b, "grinding = \"9000 EUR\"", "grinding = 9000", &["cost.grinding", "9000", "currency"]),
        (b, "\"12000 EUR\"", "\"12000 CHF\"", &["action[0].upkeep", "12000 CHF", "in EUR"]),
        (b, "deviation\" = 2.0", "deviation\" = -2.0", &["is -2", "greater than zero"]),
        (b, "{ \"vehicle.speed.standard_deviation", "{ \"vehicle.speed", &["no [[parameter]]", "wheel.mass"]),
        (b, "factor = 1.05", "factor = 0.95", &["measurement[0].factor", "0.95", "greater than one"]),
        (b, "from_limit = \"-6 dB\"", "from_limit = \"6 dB\"", &["cost.from_limit", "6 dB", "below zero"]),
        (b, "\"240 months\"", "\"240 moons\"", &["cost.horizon", "240 moons", "18 months"]),
        (
            b,
            "kind = \"dated-levels\"\nprice",
            "kind = \"decay-rate\"\nprice",
            &["measurement[1].kind", "decay-rate", "no such"],
        ),
        (b, "upkeep = \"4000 EUR\"", "investment = \"4000 EUR\"", &["action[1].life", "missing"]),
        (b, "grinding = \"9000 EUR\"", "+\ndiscount = 3", &["discount"]),
        (b, "friction.toml: friction = 0.25", "frixion = 0.25", &["frixion"]),
        (b, "grinding = \"9000 EUR\"", "+\nbudget = \"-1 EUR\"", &["cost.budget", "-1 EUR", "zero or more"]),
        (b, "grinding = \"9000 EUR\"", "+\nnoise_limit = \"-3 dB\"", &["cost.noise_limit", "-3 dB", "zero or more"]),
        (b, "grinding = \"9000 EUR\"", "+\nnoise_limit = 3", &["cost.noise_limit", "3 dB"]),
        (b, "grinding = \"9000 EUR\"", "+\npossession_hours = \"40 h\"", &["cost.grinding_hours", "missing"]),
        (b, "grinding = \"9000 EUR\"", "+\ngrinding_hours = \"6 EUR\"", &["cost.grinding_hours", "6 EUR", "6 h"]),
        // Comparisons.
        (b, "[sampler]", "[hold_out]\ndate = \"latest\"\n+", &["hold_out.date", "latest", "\"last\"", "3500000"]),
        (b, "[sampler]", "[hold_out]\ndate = 7\n+", &["hold_out.date", "7", "since the first"]),
        (b, "[sampler]", "[hold_out]\nposition = \"0.3 m\"\n+", &["hold_out.position", "0.3 m", "two places"]),
        (b, "[sampler]", "[hold_out]\ndata = \"growth\"\n+", &["hold_out.data", "growth", "only data"]),
        (c, "[sampler]", "[hold_out]\ndata = \"axle-box\"\n+", &["hold_out.data", "axle-box", "by date"]),
        (c, "[sampler]", "[hold_out]\ndata = \"hamer\"\n+", &["hold_out.data", "hamer", "no [[data]]", "decay"]),
        (c, "[sampler]", "[hold_out]\ndate = \"last\"\ndata = \"decay\"\n+", &["hold_out", "must name one"]),
        (b, "[sampler]", "[[compare]]\nset = { \"contact.creep_law\" = \"half-space\" }\n+", &["compare[0]", "title"]),
        (b, "[sampler]", "[[compare]]\ntitle = \"same\"\n+", &["compare[0].set", "missing"]),
        (
            b,
            "[sampler]",
            "[[compare]]\ntitle = \"heavy\"\nset = { \"track.pad.stiffness\" = \"500 MN/m\" }\n+",
            &["compare[0].set", "track.pad.stiffness", "uncertain"],
        ),
        (b, "[sampler]", "[[compare]]\ntitle = \"odd\"\nset = { \"contact.frixion\" = 1 }\n+", &["odd", "frixion"]),
        (
            c,
            "[sampler]",
            "[[compare]]\ntitle = \"hard\"\nwithout = [\"preload\"]\n+",
            &["compare[0].without", "preload", "preload_stiffening"],
        ),
        (
            c,
            "[sampler]",
            "[[compare]]\ntitle = \"a\"\nwithout = [\"preload_stiffening\"]\n[[compare]]\ntitle = \"a\"\nset = { \"contact.friction\" = 0.3 }\n+",
            &["compare[1].title", "second time"],
        ),
        // The prior excludes what the case says.
        (b, "mean = \"110 km/h\"", "mean = \"200 km/h\"", &["excludes", "vehicle.speed.mean"]),
        (b, "min = 0.05, max = 0.95", "min = 0.6, max = 0.95", &["excludes 0.5"]),
        (b, "median = \"300 MN/m\"", "median = \"300 kg\"", &["lognormal.median", "300 kg"]),
        (b, "vehicle.tractive_ratio", "vehicle.tractiveratio", &["vehicle.tractiveratio"]),
        (b, "wheel.mass", "wheel.mas", &["wheel.mas", "no such key"]),
        (b, "traffic = \"traffic.toml\"", "", &["names no traffic"]),
        (b, "[sampler]", "+\nkind = \"gibbs\"", &["sampler.kind", "gibbs"]),
        (b, "[sampler]", "+\nkind = \"smc\"", &["`sampler.warmup` is 1000", "left out", "smc"]),
        (b, "unit = \"dB per 1e6 passages\"", "unit = \"dB\"", &["unit", "dB per 1e6 passages"]),
        (b, "first_level = \"flat\"", "first_level = \"normal\"", &["first_level", "flat"]),
        (b, "kernel = \"exponential\"", "kernel = \"linear\"", &["kernel", "matern-3/2"]),
        // Units that are not those of the column.
        (b, "roughness.csv: level_db", "level_um", &["level_db", "level_um"]),
        (b, "roughness.csv: 199.52623,1.8841084", "150,1.8841084", &["wavelength_mm", "150", "centre"]),
        (c, "averages = 8 ", "# averages = 8 ", &["averages", "coherence"]),
        (c, "in_data = [\"growth\", \"axle-box\"]", "in_data = [\"growth\", \"axlebox\"]", &["axlebox", "no [[data]]"]),
        (c, "speed = \"100 km/h\"", "", &["speed", "missing"]),
        (c, "at_date = \"last\"", "at_date = \"latest\"", &["at_date", "latest"]),
        (c, "student_degrees = 5", "averages = 5", &["averages", "frequency-response"]),
    ] {
        let (file, from) = from.split_once(": ").unwrap_or(("plan.toml", from));
        let (_folder, plan) = changed(set, file, from, &to.replace('+', from));
        let Err(error) = plan else {
            panic!("{to} is taken");
        };
        let english = error.to_string();
        for part in parts {
            assert!(english.contains(part), "{to}: {english}");
        }
        // What is wrong with the keys of a plan, the page says in German, too.
        let german = error.message().text(Language::German);
        assert!(file != "plan.toml" || german != english, "{english}");
    }
}

/// One date alone says nothing of growth.
/// What two instruments differ by is no growth: they are refused in one table, but for dates that have both.
#[test]
fn instruments_that_change_along_the_dates_are_refused() {
    let rows = fs::read_to_string(folder("b-three-dates").join("roughness.csv")).unwrap();
    for (column, device, is_read) in [
        ("device", (|date: usize, _| ["T1", "T2"][usize::from(date > 1)]) as fn(usize, usize) -> &'static str, false),
        ("Seriennummer", |date, _| ["12", "17", "19"][date], false),
        ("instrument", |_, row| ["T1", "T2"][row % 2], true),
        ("device", |_, _| "T1", true),
        ("remark", |date, _| ["dry", "wet", "dry"][date], true),
    ] {
        let mut dates: Vec<&str> = Vec::new();
        let mut lines = rows.lines();
        let mut with = format!("{},{column}\n", lines.next().unwrap());
        for (row, line) in lines.enumerate() {
            let date = line.split(',').next().unwrap();
            if dates.last() != Some(&date) {
                dates.push(date);
            }
            with.push_str(&format!("{line},{}\n", device(dates.len() - 1, row)));
        }
        let (_copy, plan) = changed("b-three-dates", "roughness.csv", &rows, &with);
        match plan {
            Ok(_) => assert!(is_read, "{column}"),
            Err(refusal) => {
                let refusal = refusal.to_string();
                assert!(!is_read && refusal.contains(column) && refusal.contains("line "), "{refusal}");
            }
        }
    }
}

#[test]
fn one_date_is_refused() {
    let text = fs::read_to_string(folder("b-three-dates").join("roughness.csv")).unwrap();
    let later = text.lines().skip(9).collect::<Vec<_>>().join("\n");
    let (_folder, plan) = changed("b-three-dates", "roughness.csv", &later, "");
    let error = plan.err().unwrap().to_string();
    assert!(error.contains("one date"), "{error}");
}

/// Growth is linear in the profile: its amplitude touches no data.
#[test]
fn a_key_that_no_data_touch_is_known() {
    let key =
        "[[parameter]]\nkey = \"corrugation.amplitude\"\nlognormal = { median = \"30 um\", factor = 2 }\n\n[[data]]";
    let (_folder, plan) = changed("b-three-dates", "plan.toml", "[[data]]", key);
    let plan = plan.unwrap();
    assert!(plan.posterior.data_of("corrugation.amplitude").is_empty());
    assert_eq!(plan.posterior.data_of("wheel.mass"), ["growth"]);
}

/// One of two dates tells no growth: neither can be left out.
#[test]
fn one_of_two_dates_is_not_left_out() {
    let text = fs::read_to_string(folder("b-three-dates").join("roughness.csv")).unwrap();
    let later = text.lines().skip(17).collect::<Vec<_>>().join("\n");
    let (copy, plan) = changed("b-three-dates", "roughness.csv", &later, "");
    drop(plan.unwrap());
    let path = copy.path().join("plan.toml");
    let text = fs::read_to_string(&path).unwrap();
    fs::write(&path, format!("{text}\n[hold_out]\ndate = \"last\"\n")).unwrap();
    let error = Plan::read(&path).err().unwrap().to_string();
    assert!(error.contains("three dates"), "{error}");
}

/// Levels beside the track: of the table and of the plan.
#[test]
fn pass_bys_that_cannot_be_used_are_said() {
    let speed = "speed = \"100 km/h\"\nset = { \"track.model\" = \"two-layer\" }\n";
    let good = "passages,level_dba\n0,80\n6000000,84\n";
    let with = |key: &str| format!("{speed}{key}\n");
    for (keys, table, parts) in [
        ("".to_owned(), good, &["pass-by.csv", "line 2", "speed_km_per_h", "`speed`"][..]),
        (speed.to_owned(), "passages,level_dba\n-5,80\n", &["passages", "-5", "before the first date"]),
        (speed.to_owned(), "passages,level_dba,trains\n0,80,0\n", &["trains", "is 0", "greater than zero"]),
        (speed.to_owned(), "passages,level_dba\n0,-84\n", &["level_dba", "-84", "between 30 and 140 dB(A)"]),
        (speed.to_owned(), "passages,level_dba\n2024-03-01,84\n", &["pass-by.csv", "below it no row", "`passages`"]),
        (speed.to_owned(), "passages,level_dba\n0,loud\n", &["line 2", "level_dba", "loud"]),
        (speed.replace("100 km/h", "5 km/h"), good, &["at 5 km/h", "no one-third octave", "100 Hz"]),
        (
            with("wheel_roughness = \"cast iron\""),
            good,
            &["data[4].wheel_roughness", "cast iron", "cnossos-disc-brakes"],
        ),
        (with("roughness = \"nothing.csv\""), good, &["nothing.csv"]),
        (with("distance = \"0.5 m\""), good, &["data[4].distance", "0.5", "beyond the rail"]),
        (with("wheels = 0"), good, &["data[4].wheels", "is 0", "greater than zero"]),
        (with("common_error = \"-2 dB\""), good, &["data[4].common_error", "-2 dB"]),
        (
            with("discrepancy = { kind = \"band\", standard_deviation = 1.0 }"),
            good,
            &["data[4].discrepancy", "belongs to", "not to pass-by"],
        ),
        (
            speed.replace("two-layer", "moving-beam"),
            good,
            &["data[4].kind", "moving-beam", "how far its vibration runs"],
        ),
    ] {
        let (copy, good_plan) = changed("c-all-together", "plan.toml", "seed = 1", "seed = 2");
        good_plan.unwrap();
        let path = copy.path().join("plan.toml");
        let text = fs::read_to_string(&path).unwrap();
        let data = format!("\n[[data]]\nkind = \"pass-by\"\nfile = \"pass-by.csv\"\n{keys}");
        fs::write(&path, text + &data).unwrap();
        fs::write(copy.path().join("pass-by.csv"), table).unwrap();
        let refusal = Plan::read(&path).map(|_| ()).unwrap_err().to_string();
        for part in parts {
            assert!(refusal.contains(part), "{part} not in: {refusal}");
        }
    }
}

/// Levels re 1 m are taken, and asked about; responses with the wrong signs are refused.
#[test]
fn data_that_no_rail_has_are_asked_about_or_refused() {
    let changed_file = |file: &str, change: &dyn Fn(usize, f64) -> f64| {
        let text = fs::read_to_string(folder("c-all-together").join(file)).unwrap();
        let (head, rows) = text.split_once('\n').unwrap();
        let row = |row: &str| {
            let cells = row.split(',').enumerate();
            let cells = cells.map(|(column, cell)| change(column, cell.parse().unwrap()).to_string());
            cells.collect::<Vec<_>>().join(",")
        };
        let other = format!("{head}\n{}\n", rows.lines().map(row).collect::<Vec<_>>().join("\n"));
        changed("c-all-together", file, &text, &other).1
    };
    let of_metres = |column: usize, level: f64| level - if column == 2 { 120.0 } else { 0.0 };
    let remarks = changed_file("roughness.csv", &of_metres).unwrap().remarks;
    let told = remarks.iter().any(|it| it.to_string().contains("they look like dB re 1 m"));
    assert!(told, "{remarks:?}");
    let of_sign = |turned: &'static [usize]| {
        move |column: usize, value: f64| {
            if turned.contains(&column) { -value } else { value }
        }
    };
    for (turned, words) in [(&[3][..], "it is conjugated"), (&[2, 3], "it is turned in sign")] {
        let refusal = changed_file("hammer.csv", &of_sign(turned)).map(|_| ()).unwrap_err();
        let refusal = refusal.to_string();
        assert!(refusal.contains("hammer.csv") && refusal.contains(words), "{refusal}");
    }
}
