//! Rails that instruments call by other names, and dates of blocks.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use riffel_network::{NetworkError, SurveyFile, growth, left_out_of_growth};
use tempfile::TempDir;

use crate::{grassie, store, survey};

/// A survey whose rails have other names than left and right.
fn named(folder: &TempDir, file: &str, names: [&str; 2], rms: f64) -> PathBuf {
    let (path, _) = survey(folder.path(), file, [0, 200], |_, _| rms);
    let text = fs::read_to_string(&path).unwrap();
    let text = text.replace("\nleft,", &format!("\n{},", names[0]));
    fs::write(&path, text.replace("\nright,", &format!("\n{},", names[1]))).unwrap();
    path
}

/// Left and right grow from 4 to 8 µm in two years, 3.01 dB a year, whatever the last survey calls them.
#[test]
fn one_rail_has_one_name_in_its_line() -> Result<(), NetworkError> {
    for names in [
        ["Höhe links", "Höhe rechts"],
        ["L", "R"],
        ["1", "2"],
        ["gauche", "droite"],
        ["Schiene 1", "Schiene 2"],
        ["izquierda", "derecha"],
        ["sinistra", "destra"],
    ] {
        let folder = tempfile::tempdir().unwrap();
        let store = store(&folder);
        for (date, names, rms) in [("2024-01-01", ["left", "right"], 4.0), ("2026-01-01", names, 8.0)] {
            let file = SurveyFile::check(&named(&folder, date, names, rms))?;
            let found = store.ingest("A", date, &file, false, &|_| ())?;
            assert!(found.new_rails.is_empty(), "{names:?}");
            assert_eq!(found.renamed.len(), if rms == 8.0 { 2 } else { 0 });
            // The same again changes nothing.
            assert!(store.ingest("A", date, &file, false, &|_| ())?.there_already);
        }
        let grown = growth(&store, &grassie(&store), 100.0, None)?;
        assert_eq!(grown.len(), 4, "{names:?}");
        // 20 lg 2 over 731 days.
        let right = 20.0 * 2f64.log10() * 365.2425 / 731.0;
        for section in grown {
            assert!((section.growth_db_per_year.unwrap() - right).abs() < 1e-6);
        }
        assert!(left_out_of_growth(&store, None)?.is_empty());
    }
    Ok(())
}

/// A rail that the line has not had is told, as is the survey whose rails are lost for growth; `rename` puts both right.
#[test]
fn a_new_rail_is_told_and_renamed() -> Result<(), NetworkError> {
    let folder = tempfile::tempdir().unwrap();
    let store = store(&folder);
    let take = |date: &str, names, replace, rename: &[(&str, &str)]| {
        let file = SurveyFile::check(&named(&folder, date, names, 5.0))?;
        let pairs = rename.iter();
        let pairs = pairs.map(|(old, new)| ((*old).to_owned(), (*new).to_owned()));
        let file = file.rename(pairs.collect::<BTreeMap<_, _>>())?;
        store.ingest("A", date, &file, replace, &|_| ())
    };
    take("2024-01-01", ["left", "right"], false, &[])?;
    let found = take("2025-01-01", ["north", "south"], false, &[])?;
    assert_eq!(found.new_rails, ["north", "south"]);
    take("2026-01-01", ["left", "right"], false, &[])?;
    let told = left_out_of_growth(&store, None)?.join("\n");
    assert!(told.contains("north, south of 2025-01-01"), "{told}");
    let names = [("north", "left"), ("south", "right")];
    let refusal = take("2025-01-01", ["north", "south"], false, &names).unwrap_err();
    assert!(matches!(refusal, NetworkError::Conflict { .. }), "{refusal}");
    let found = take("2025-01-01", ["north", "south"], true, &names)?;
    assert!(found.new_rails.is_empty());
    assert_eq!(found.renamed.get("north").map(String::as_str), Some("left"));
    assert!(take("2025-01-01", ["north", "south"], false, &names)?.there_already);
    assert!(left_out_of_growth(&store, None)?.is_empty());
    for (names, part) in [
        ([("east", "left")], "no rail \"east\" in the file; there are north, south"),
        ([("north", "south")], "the only one of that name"),
    ] {
        let refusal = take("2026-02-01", ["north", "south"], false, &names).unwrap_err();
        assert!(refusal.to_string().contains(part), "{refusal}");
    }
    Ok(())
}

/// A column of dates in the blocks is read, or refused with its line; the day of the survey is one of them.
#[test]
fn dates_of_blocks_are_read_or_refused() -> Result<(), NetworkError> {
    let folder = tempfile::tempdir().unwrap();
    let store = store(&folder);
    let (path, _) = survey(folder.path(), "a.csv", [0, 200], |_, _| 5.0);
    let plain = fs::read_to_string(&path).unwrap();
    let checked = |head: &str, date: &str| {
        let rows = plain.lines().enumerate().map(|(row, line)| match row {
            0 => format!("{line},{head}\n"),
            _ => format!("{line},{date}\n"),
        });
        fs::write(&path, rows.collect::<String>()).unwrap();
        SurveyFile::check(&path)
    };
    for date in ["2026-01-31", "31.01.2026", "46053", "2026-01-31 02:59"] {
        let file = checked("date", date)?;
        store.ingest("A", "2026-01-31", &file, true, &|_| ())?;
        let refusal = store.ingest("A", "2025-01-31", &file, true, &|_| ()).unwrap_err();
        assert!(refusal.to_string().contains("2026-01-31 to 2026-01-31"), "{refusal}");
    }
    for (head, date, part) in [
        ("date", "01/02/2026", "may be two dates"),
        ("Datum", "31.01.26", "two digits"),
        ("date", "Jan 2026", "is no date"),
        ("date", "2026.08", "is no date"),
        ("date", "1769817600", "is no date"),
    ] {
        let refusal = checked(head, date).unwrap_err().to_string();
        assert!(refusal.contains(part) && refusal.contains(&format!("column `{head}`")), "{refusal}");
    }
    // A year of which all blocks are tells them not apart.
    let file = checked("year", "2026")?;
    store.ingest("B", "2026-01-31", &file, false, &|_| ())?;
    Ok(())
}

/// A rail that grows by 4 dB a year, as instruments show it that differ by 3 dB: growth is that of one instrument, or none is told.
#[test]
fn what_instruments_differ_by_is_no_growth() -> Result<(), NetworkError> {
    let more = 10f64.powf(3.0 / 20.0);
    let rms = |years: f64| 4.0 * 10f64.powf(4.0 * years / 20.0);
    let dates = ["2024-01-01", "2025-01-01", "2026-01-01", "2027-01-01"];
    // Head and cell of each survey, how much more it shows, and the growth that is told, to what 366 days are of a year.
    let (own, none) = (Some(4.0), None);
    for (head, surveys, growth_told, left_out) in [
        ("device", &[("T1", 1.0), ("T1", 1.0), ("T1", 1.0)][..], own, 0),
        ("device", &[("T1", 1.0), ("T1", 1.0), ("T2", more)], none, 2),
        ("Messgerät", &[("T1", 1.0), ("T2", more), ("T2", more)], own, 1),
        ("serial", &[("17", more), ("12", 1.0), ("17", more), ("12", 1.0)], own, 2),
        ("instrument", &[("A", 1.0), ("B", more), ("C", 2.0), ("A", 1.0)], own, 2),
        // Where one is not named, nobody knows that it was another.
        ("device", &[("", 1.0), ("T2", 1.0)], own, 0),
        ("remark", &[("T1", 1.0), ("T2", 1.0)], own, 0),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let store = store(&folder);
        for (year, (device, shown)) in surveys.iter().enumerate() {
            let level = shown * rms(year as f64);
            let path = named(&folder, dates[year], ["left", "right"], level);
            let text = fs::read_to_string(&path).unwrap();
            let mut lines = text.lines();
            let mut with = format!("{},{head}\n", lines.next().unwrap());
            lines.for_each(|line| with.push_str(&format!("{line},{device}\n")));
            fs::write(&path, with).unwrap();
            store.ingest("A", dates[year], &SurveyFile::check(&path)?, false, &|_| ())?;
        }
        let grown = growth(&store, &grassie(&store), 100.0, None);
        match growth_told {
            Some(right) => {
                let grown = grown?;
                let off = |section: &riffel_network::SectionGrowth| (section.growth_db_per_year.unwrap() - right).abs();
                assert!(grown.len() == 4 && grown.iter().all(|it| off(it) < 0.02), "{head}");
            }
            None => assert!(matches!(grown, Err(NetworkError::Nothing(_))), "{head}"),
        }
        let told = left_out_of_growth(&store, None)?.join("\n");
        assert_eq!(told.is_empty(), left_out == 0, "{head}: {told}");
        assert_eq!(told.matches(" (").count(), left_out, "{head}: {told}");
    }
    Ok(())
}
