//! One table of spellings, asked of every reader of dates.

use std::fmt::Write as _;
use std::path::Path;

use super::*;
use crate::{Layout, RoughnessFile, Survey};

/// Head, an earlier and a later date as they are written, and the later one, or a part of the refusal.
const SPELLINGS: [(&str, [&str; 2], Result<&str, &str>); 48] = [
    ("date", ["2024-06-01", "2026-06-01"], Ok("2026-06-01")),
    ("Datum", ["01.06.2024", "01.06.2026"], Ok("2026-06-01")),
    ("Datum", ["1.6.2024", "1.6.2026"], Ok("2026-06-01")),
    ("date", ["2024/06/01", "2026/06/01"], Ok("2026-06-01")),
    ("date", ["20240601", "20260601"], Ok("2026-06-01")),
    ("date", ["45444", "46174"], Ok("2026-06-01")),
    ("date", ["45444.0", "46174.0"], Ok("2026-06-01")),
    ("date", ["45444.375", "46174.5"], Ok("2026-06-01")),
    ("date", ["40000", "60000"], Ok("2064-04-08")),
    ("date", ["15/06/2024", "13/06/2026"], Ok("2026-06-13")),
    ("date", ["06/15/2024", "06/13/2026"], Ok("2026-06-13")),
    ("date", ["15-06-2024", "13-06-2026"], Ok("2026-06-13")),
    ("date", ["06/06/2024", "06/06/2026"], Ok("2026-06-06")),
    ("date", ["2024-06-01 09:30", "2026-06-01 10:00"], Ok("2026-06-01")),
    ("date", ["2024-06-01T09:30:00Z", "2026-06-01T10:00:00Z"], Ok("2026-06-01")),
    ("timestamp", ["2024-06-01T09:30", "2026-06-01T10:00"], Ok("2026-06-01")),
    ("fecha", ["2024-06-01", "2026-06-01"], Ok("2026-06-01")),
    ("Messdatum", ["01.06.2024", "01.06.2026"], Ok("2026-06-01")),
    ("päivämäärä", ["1.6.2024", "1.6.2026"], Ok("2026-06-01")),
    ("survey", ["2024-06-01", "2026-06-01"], Ok("2026-06-01")),
    ("data", ["2024-06-01", "2026-06-01"], Ok("2026-06-01")),
    ("dato", ["45444", "46174"], Ok("2026-06-01")),
    ("campaña", ["01.06.2024", "01.06.2026"], Ok("2026-06-01")),
    ("date", ["06/01/2024", "06/01/2026"], Err("may be two dates")),
    ("date", ["06-01-2024", "06-01-2026"], Err("may be two dates")),
    ("survey", ["06/01/2024", "06/01/2026"], Err("may be two dates")),
    ("date", ["15/06/2024", "06/15/2026"], Err("different orders")),
    ("date", ["01.06.24", "01.06.26"], Err("two digits")),
    ("date", ["01/06/24", "01/06/26"], Err("two digits")),
    ("date", ["24-06-01", "26-06-01"], Err("two digits")),
    ("date", ["Jun 2024", "Jun 2026"], Err("is no date")),
    ("date", ["June 2024", "June 2026"], Err("is no date")),
    ("survey", ["Jun 2024", "Jun 2026"], Err("is no date")),
    ("Messung", ["Juni 2024", "Juni 2026"], Err("is no date")),
    ("date", ["01-Jun-2024", "01-Jun-2026"], Err("is no date")),
    ("run", ["1 Jun 2024", "1 Jun 2026"], Err("is no date")),
    ("date", ["2024.42", "2026.42"], Err("is no date")),
    ("date", ["2024-06", "2026-06"], Err("is no date")),
    ("date", ["1717200000", "1780272000"], Err("is no date")),
    ("date", ["1717200000000", "1780272000000"], Err("is no date")),
    ("date", ["39999", "39998"], Err("is no date")),
    ("date", ["60001", "60002"], Err("is no date")),
    ("date", ["before", "after"], Err("is no date")),
    ("date", ["31.02.2024", "31.02.2026"], Err("not in the calendar")),
    ("year", ["2024", "2026"], Err("is no date")),
    ("Jahr", ["2024", "2026"], Err("is no date")),
    ("KW", ["23", "24"], Err("is no date")),
    ("Monat", ["202406", "202606"], Err("is no date")),
];

/// A row for each band of each date.
fn long_levels(head: &str, dates: [&str; 2]) -> String {
    let mut text = format!("{head};wavelength_mm;level_db\n");
    for (date, level) in dates.iter().zip([3, 9]) {
        for wavelength in [100, 80, 63, 50] {
            writeln!(text, "{date};{wavelength};{level}").unwrap();
        }
    }
    text
}

/// A row for each date.
fn wide_levels(head: &str, dates: [&str; 2]) -> String {
    let [before, now] = dates;
    format!("{head};100 mm;80 mm;63 mm\n{before};3;3;3\n{now};9;9;9\n")
}

/// A row for each sample of 3 m, of each date; the later one is three times as rough.
fn profile(head: &str, dates: [&str; 2]) -> String {
    let mut text = format!("{head};x_m;height_um\n");
    for (date, rough) in dates.iter().zip([4.0, 12.0]) {
        for sample in 0..600 {
            let x = 5e-3 * f64::from(sample);
            let height = rough * (std::f64::consts::TAU * x / 0.05).sin();
            writeln!(text, "{date};{x:.3};{height:.3}").unwrap();
        }
    }
    text
}

/// What a file says of now, and the error with which it is refused.
fn now(text: &str) -> Result<(String, Survey), String> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("rail.csv");
    std::fs::write(&path, text).unwrap();
    let read = RoughnessFile::read(&path, &Layout::default(), &|_| ());
    let survey = read.and_then(|file| Survey::of(&path, file));
    let survey = survey.map_err(|error| error.to_string())?;
    let (latest, date) = survey.clone().latest();
    assert!(latest.records.len() < survey.records.len(), "{text}");
    Ok((date.map(|date| date.to_string()).unwrap_or_default(), latest))
}

/// Of no spelling a mean over the dates is taken: the later is now, or the table is refused with its column and line.
// Long: reads three tables under every spelling of a date.
#[test]
fn every_reader_reads_a_date_or_refuses_it() {
    for (head, dates, right) in SPELLINGS {
        let tables = [(long_levels(head, dates), 2), (wide_levels(head, dates), 2), (profile(head, dates), 2)];
        for (text, line) in tables {
            let start: String = text.chars().take(60).collect();
            match (now(&text), right) {
                (Ok((date, _)), Ok(right)) => assert_eq!(date, right, "{start}"),
                (Err(error), Err(part)) => {
                    let of_column = format!("column `{head}`");
                    let at_line = error.contains(&format!(":{line}")) || error.contains(&format!("line {line}"));
                    assert!(error.contains(part) && error.contains(&of_column) && at_line, "{start}: {error}");
                }
                (found, _) => panic!("{start}: {found:?}"),
            }
        }
        // What another program has in memory.
        let labelled = dates.map(|date| {
            let band = riffel::roughness::ThirdOctave::containing(0.05).unwrap();
            LabelledSpectrum {
                labels: vec![(head.to_owned(), date.to_owned())],
                spectrum: riffel::roughness::Spectrum::new([(band, 1.0)]).unwrap(),
            }
        });
        let survey = Survey::new(Path::new("spectra"), labelled.to_vec(), Vec::new());
        match (survey.map(|survey| survey.latest().1), right) {
            (Ok(date), Ok(right)) => assert_eq!(date.unwrap().to_string(), right),
            (Err(error), Err(part)) => assert!(error.to_string().contains(part), "{error}"),
            (found, _) => panic!("{head} {dates:?}: {found:?}"),
        }
    }
}

/// The later profile is three times as rough as the earlier one, 20 lg 3 = 9.54 dB; it is now.
#[test]
fn the_latest_profile_is_the_rail_of_now() {
    let level = |survey: &Survey| {
        let mean = survey.mean();
        let band = riffel::roughness::ThirdOctave::containing(0.05).unwrap();
        mean.level(band).unwrap()
    };
    let (_, both) = now(&profile("date", ["2024-06-01", "2026-06-01"])).unwrap();
    let (_, turned) = now(&profile("date", ["2026-06-01", "2024-06-01"])).unwrap();
    // Levels are told to 1e-3 µm of 4 µm.
    assert!((level(&both) - level(&turned) - 20.0 * 3f64.log10()).abs() < 0.01);
    assert_eq!(both.rails(), ["height"]);
}

/// What is no date of a measurement stays what it is: a rail of two building years is one rail now.
#[test]
fn other_dates_and_words_are_no_dates_of_the_measurement() {
    for (head, cells) in [
        ("built", ["1999-05-01", "2003-04-01"]),
        ("date of grinding", ["01.05.2021", "01.06.2021"]),
        ("site", ["Marienhof 2024", "Marienhof 2025"]),
        ("run", ["1", "2"]),
        ("data", ["raw", "filtered"]),
        ("date", ["", ""]),
    ] {
        let heads = [head];
        let own = |_: usize| cells.map(str::to_owned).to_vec();
        assert_eq!(date_column(&heads, &own), None, "{head}");
    }
}

/// Dates at the heads of columns beside each other are dates, too, and their rails rails.
#[test]
fn dates_of_heads_are_dates() {
    let mut levels = "wavelength_mm;left 2024-06-01 [dB];left 2026-06-01 [dB]\n".to_owned();
    let mut heights = "x_m;01.06.2024 um;01.06.2026 um\n".to_owned();
    for wavelength in [100, 80, 63, 50] {
        writeln!(levels, "{wavelength};3;9").unwrap();
    }
    for sample in 0..600 {
        let x = 5e-3 * f64::from(sample);
        let wave = (std::f64::consts::TAU * x / 0.05).sin();
        writeln!(heights, "{x:.3};{:.3};{:.3}", 4.0 * wave, 12.0 * wave).unwrap();
    }
    for (text, rail) in [(levels, "left"), (heights, "rail")] {
        let (date, latest) = now(&text).unwrap();
        assert_eq!((date.as_str(), latest.rails()), ("2026-06-01", vec![rail.to_owned()]));
    }
}
