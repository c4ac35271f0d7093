//! What the rows and columns of tables of measurements say, or are refused for.

use std::fs;

use riffel_calibrate::Plan;
use riffel_keys::{CaseError, Language};

/// Set b or c with another text of one of its tables.
fn with(set: &str, file: &str, text: &str) -> Result<Plan, CaseError> {
    let copy = tempfile::tempdir().unwrap();
    crate::copy_set(set, copy.path());
    fs::write(copy.path().join(file), text).unwrap();
    Plan::read(&copy.path().join("plan.toml"))
}

fn table(set: &str, file: &str) -> String {
    fs::read_to_string(crate::folder(set).join(file)).unwrap()
}

/// What a table is refused for, in both languages.
fn refused(set: &str, file: &str, text: &str) -> [String; 2] {
    let error = with(set, file, text).err().unwrap();
    [Language::English, Language::German].map(|language| error.message().text(language))
}

fn remarks(plan: &Plan) -> String {
    let remarks = plan.remarks.iter().map(|it| it.text(Language::English));
    remarks.collect::<Vec<String>>().join("\n")
}

/// ln likelihood of the data of a name at the medians of the priors.
fn likelihood(plan: &Plan, name: &str) -> f64 {
    let priors = plan.posterior.parameters().iter();
    let values: Vec<f64> = priors.map(|it| it.prior.quantile(0.5)).collect();
    let blocks = plan.posterior.log_likelihood(&values).unwrap();
    blocks.iter().find(|it| it.0.contains(name)).unwrap().1
}

const C: &str = "c-all-together";
const B: &str = "b-three-dates";

/// The error of a rate in dB/m over the rate is that of its logarithm; both at once are refused, and a column of another name is told.
#[test]
fn decay_rates_have_one_error() {
    let own = table(C, "decay.csv");
    let rows = || own.lines().skip(1).map(|row| row.split(',').collect::<Vec<&str>>());
    let of_rate = rows().map(|row| {
        let [rate, error] = [1, 2].map(|cell| row[cell].parse::<f64>().unwrap());
        format!("{},{},{:e}\n", row[0], row[1], rate * error)
    });
    let head = "frequency_hz,decay_rate_db_per_m,standard_error_db_per_m\n";
    let of_rate = with(C, "decay.csv", &(head.to_owned() + &of_rate.collect::<String>())).unwrap();
    let of_ln = with(C, "decay.csv", &own).unwrap();
    let apart = likelihood(&of_rate, "decay") - likelihood(&of_ln, "decay");
    assert!(apart.abs() < 1e-9, "{apart}");
    assert!(!remarks(&of_rate).contains("not used"));
    let both = rows().map(|row| format!("{},{},0.1,0.4\n", row[0], row[1]));
    let head = "frequency_hz,decay_rate_db_per_m,standard_error_ln,standard_error_db_per_m\n";
    let both = refused(C, "decay.csv", &(head.to_owned() + &both.collect::<String>()));
    assert!(both[0].contains("an error must have one"), "{both:?}");
    assert!(both[1].contains("nur eines davon"), "{both:?}");
    let other = with(C, "decay.csv", &own.replace("standard_error_ln", "sd_ln")).unwrap();
    let remarks = remarks(&other);
    assert!(remarks.contains("decay.csv has columns that are not used: sd_ln"), "{remarks}");
}

/// A table behind itself counts every row twice: refused with both lines, of rates, levels and runs.
#[test]
fn doubled_rows_are_refused() {
    for (set, file) in [(C, "decay.csv"), (B, "roughness.csv"), (C, "axlebox.csv")] {
        let own = table(set, file);
        let rows: Vec<&str> = own.lines().collect();
        let twice = [&rows[..], &rows[1..]].concat().join("\n");
        let error = with(set, file, &twice).err().unwrap();
        let line = format!("line {}", rows.len() + 1);
        let said = error.to_string() + &error.message().to_string();
        assert!(said.contains("repeats line 2"), "{file}: {said}");
        assert!(format!("{error:?}").contains(&(rows.len() + 1).to_string()), "{line}");
    }
}

/// Passages of levels by date, each date with the eight levels of set b and what it changes them by.
fn dates(dates: &[(f64, f64)]) -> String {
    let own = table(B, "roughness.csv");
    let rows = own.lines().skip(1).filter(|row| row.starts_with("0,"));
    let rows: Vec<Vec<&str>> = rows.map(|row| row.split(',').collect()).collect();
    let mut text = own.lines().next().unwrap().to_owned() + "\n";
    for (passages, change) in dates {
        for (band, row) in rows.iter().enumerate() {
            // Not all bands grow alike.
            let level = row[2].parse::<f64>().unwrap() + change * (1.0 + 0.01 * band as f64);
            text += &format!("{passages},{},{level},{}\n", row[1], row[3]);
        }
    }
    text
}

/// 0, 2 and 4 are of millions, and so is 9999; 10000 may be.
#[test]
fn passages_in_millions_are_refused() {
    for last in [4.0, 9999.0] {
        let few = refused(B, "roughness.csv", &dates(&[(0.0, 0.0), (2.0, 1.0), (last, 2.0)]));
        assert!(few[0].contains("but must rise by 10000 or more"), "{few:?}");
        assert!(few[1].contains("sind es Millionen?"), "{few:?}");
    }
    assert!(with(B, "roughness.csv", &dates(&[(7e6, 0.0), (7e6 + 1e4, 1.0)])).is_ok());
}

/// A fall of the bands by more than 3 dB is grinding: dates before it are left out, which is told, and growth is that of the later
/// dates alone; of one date after it nothing is known.
#[test]
fn growth_begins_anew_where_the_rail_was_ground() {
    let ground = [(1e6, 0.0), (3e6, 2.0), (5e6, -8.0), (8e6, -6.0)];
    let plan = with(B, "roughness.csv", &dates(&ground)).unwrap();
    let alone = with(B, "roughness.csv", &dates(&[(0.0, -8.0), (3e6, -6.0)])).unwrap();
    assert_eq!(plan.posterior.observed(), alone.posterior.observed());
    assert_eq!(likelihood(&plan, "growth"), likelihood(&alone, "growth"));
    let told = remarks(&plan);
    assert!(told.contains("before the date of 5000000 passages"), "{told}");
    assert!(!remarks(&alone).contains("ground"));
    let only = refused(B, "roughness.csv", &dates(&ground[..3]));
    assert!(only[0].contains("the rail was ground"), "{only:?}");
    assert!(only[1].contains("geschliffen"), "{only:?}");
    let wear = with(B, "roughness.csv", &dates(&[(0.0, 0.0), (2e6, -2.7), (4e6, -5.4)])).unwrap();
    assert_eq!(wear.posterior.observed()[0].len(), 16);
    // One coarse band that does not fall hides no grinding; half of the bands that rise speak against it.
    let text = dates(&ground[..3]);
    let rows: Vec<Vec<&str>> = text.lines().map(|row| row.split(',').collect()).collect();
    let with_high = |count: usize| {
        let row = |(at, row): (usize, &Vec<&str>)| match at + count >= rows.len() {
            true => format!("{},{},20,{}\n", row[0], row[1], row[3]),
            false => row.join(",") + "\n",
        };
        rows.iter().enumerate().map(row).collect::<String>()
    };
    let hidden = refused(B, "roughness.csv", &with_high(1));
    assert!(hidden[0].contains("the rail was ground"), "{hidden:?}");
    let none = with(B, "roughness.csv", &with_high(4)).unwrap();
    assert_eq!(none.posterior.observed()[0].len(), 16);
}

/// Of 391 lines of a hammer 100 means are compared, which is told; fewer than 100 stay as they are.
#[test]
fn many_lines_are_taken_together() {
    let lines = |count: u32| {
        let row = |line: u32| {
            let f = 80.0 + 5.0 * f64::from(line);
            let square = (f / 700.0).powi(2);
            let (re, im) = (1e-9 * (1.0 - square), -2e-10);
            let size = (1.0 - square).powi(2) + 0.04;
            format!("{f},0.3,{:e},{:e},0.99\n", re / size, im / size)
        };
        "frequency_hz,position_m,receptance_re_m_per_n,receptance_im_m_per_n,coherence\n".to_owned()
            + &(0..count).map(row).collect::<String>()
    };
    let plan = with(C, "hammer.csv", &lines(391)).unwrap();
    assert_eq!(plan.posterior.observed()[0].len(), 200);
    let told = remarks(&plan);
    assert!(told.contains("the 391 lines of hammer.csv are taken together to 100 means"), "{told}");
    let plan = with(C, "hammer.csv", &lines(100)).unwrap();
    assert_eq!(plan.posterior.observed()[0].len(), 200);
    assert!(!remarks(&plan).contains("taken together"));
}
