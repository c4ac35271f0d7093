//! Heads, dates and cells as other programs write them: every reader takes them for what they are, or refuses them with column and line.

use std::path::Path;

use jiff::civil::Date;
use riffel_keys::Message;
use riffel_network::SurveyFile;
use riffel_rail::{AxleBoxFile, AxleBoxLayout, Layout, RoughnessFile, Survey};

use crate::{store, take};

/// A file of some text.
fn with<T>(text: &str, read: impl FnOnce(&Path) -> T) -> T {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("file.csv");
    std::fs::write(&path, text).unwrap();
    read(&path)
}

/// What is shown of a refusal.
fn shown(error: impl ToString) -> String {
    error.to_string()
}

/// Two dates of a column as they are written, with the later one where they are read.
const DATES: [([&str; 2], Option<&str>); 36] = [
    (["2025-06-01", "2026-06-01"], Some("2026-06-01")),
    (["2025/06/01", "2026/06/01"], Some("2026-06-01")),
    (["20250601", "20260601"], Some("2026-06-01")),
    (["01.06.2025", "01.06.2026"], Some("2026-06-01")),
    (["1.6.2025", "1.6.2026"], Some("2026-06-01")),
    (["'01.06.2025", "'01.06.2026"], Some("2026-06-01")),
    (["\"2025-06-01\"", "\"2026-06-01\""], Some("2026-06-01")),
    (["2025-06-01 10:00", "2026-06-01 23:59"], Some("2026-06-01")),
    (["2025-06-01T10:00:00Z", "2026-06-01T10:00:00Z"], Some("2026-06-01")),
    (["13/06/2025", "13/06/2026"], Some("2026-06-13")),
    (["06/13/2025", "06/13/2026"], Some("2026-06-13")),
    (["13-06-2025", "13-06-2026"], Some("2026-06-13")),
    (["45809", "46174"], Some("2026-06-01")),
    (["45809.5", "46174.25"], Some("2026-06-01")),
    (["45809", "01.06.2026"], Some("2026-06-01")),
    (["06/01/2025", "06/01/2026"], None),
    (["01-06-2025", "01-06-2026"], None),
    (["01.06.25", "01.06.26"], None),
    (["Jun 2025", "Jun 2026"], None),
    (["01-Jun-2025", "01-Jun-2026"], None),
    (["1 June 2025", "1 June 2026"], None),
    (["1. Juni 2025", "1. Juni 2026"], None),
    (["Jun 1 2025", "Jun 1 2026"], None),
    (["1er juin 2025", "1er juin 2026"], None),
    (["2025-06", "2026-06"], None),
    (["2025.42", "2026.42"], None),
    (["2025", "2026"], None),
    (["2025-W22", "2026-W22"], None),
    (["KW 22/2025", "KW 22/2026"], None),
    (["2025 Q2", "2026 Q2"], None),
    (["1748736000", "1780272000"], None),
    (["1748736000000", "1780272000000"], None),
    (["2025-02-30", "2026-02-30"], None),
    (["before", "after"], None),
    (["2025-06-01", ""], None),
    (["2025年6月1日", "2026年6月1日"], None),
];

/// Heads of a column of dates, besides `date`, with how it is written there.
const HEADS_OF_DATES: [(&str, [&str; 2], Option<&str>); 17] = [
    ("Datum", ["45809", "46174"], Some("2026-06-01")),
    ("Messdatum", ["01.06.2025", "01.06.2026"], Some("2026-06-01")),
    ("measured on", ["45809", "46174"], Some("2026-06-01")),
    ("campaign", ["2025-06-01", "2026-06-01"], Some("2026-06-01")),
    ("survey", ["45809", "46174"], Some("2026-06-01")),
    ("anything", ["2025-06-01", "2026-06-01"], Some("2026-06-01")),
    ("anything", ["Jun 2025", "Jun 2026"], None),
    ("survey", ["2025", "2026"], None),
    ("Kampagne", ["2025", "2026"], None),
    ("when", ["2025.42", "2026.42"], None),
    ("measured", ["2025", "2026"], None),
    ("year", ["2025", "2026"], None),
    ("Jahr", ["2025", "2026"], None),
    ("KW", ["22", "23"], None),
    ("run", ["2025", "2026"], None),
    ("run", ["45809", "46174"], Some("2026-06-01")),
    ("Messfahrt", ["2025.42", "2026.42"], None),
];

/// The last date of a table of levels, of profiles below each other, and of blocks; or what is said of the column.
fn latest(kind: &str, head: &str, cells: [&str; 2]) -> Result<Option<Date>, String> {
    let rows = |row: &dyn Fn(usize) -> String, count: usize| -> String {
        let dated = cells.iter().flat_map(|cell| (0..count).map(move |at| (cell, at)));
        dated.map(|(cell, at)| format!("{cell};{}\n", row(at))).collect()
    };
    let text = match kind {
        "levels" => {
            let row = |at: usize| format!("{};{}", [50.0, 40.0, 31.5][at], at as f64 - 8.5);
            format!("{head};wavelength_mm;level_db\n{}", rows(&row, 3))
        }
        _ => {
            let row = |at: usize| format!("{:.3};{:.2}", 4e-3 * at as f64, (at * 7919 % 101) as f64);
            // A profile is of a metre and more.
            format!("{head};x_m;height_um\n{}", rows(&row, 280))
        }
    };
    with(&text, |path| {
        let file = RoughnessFile::read(path, &Layout::default(), &|_| ()).map_err(shown)?;
        let survey = Survey::of(path, file).map_err(shown)?;
        let dates = survey.groups(survey.date_column()).map_err(shown)?.len();
        assert!(dates == 2 || survey.date_column().is_none(), "{kind}: {head} {cells:?}");
        Ok(survey.latest().1)
    })
}

/// The date of a survey of blocks whose column of dates is written in a way.
fn ingested(head: &str, cell: &str, date: &str) -> Result<(), String> {
    let rows = (0..300).map(|at| format!("{cell},{at},{},2.5\n", at + 1));
    let text = format!("{head},from_m,to_m,rms_30_to_100_mm_um\n{}", rows.collect::<String>());
    with(&text, |path| {
        let file = SurveyFile::check(path).map_err(shown)?;
        let folder = tempfile::tempdir().unwrap();
        take(&store(&folder), "A", date, &file);
        Ok(())
    })
}

// Long: stores a survey for every spelling of a date.
#[test]
fn dates_are_read_or_refused_however_they_are_written() {
    let heads = HEADS_OF_DATES.iter().map(|&(head, cells, read)| (head, cells, read));
    let all = DATES.iter().map(|&(cells, read)| ("date", cells, read)).chain(heads);
    for (head, cells, read) in all {
        let bare = |cell: &str| cell.trim_matches(['"', '\'']).to_owned();
        for kind in ["levels", "profile"] {
            let found = latest(kind, head, cells);
            let Some(date) = read else {
                let refusal = found.expect_err(&format!("{kind}: {head} {cells:?}"));
                let [first, second] = cells.map(bare);
                let cell = if second.is_empty() { &second } else { &first };
                for part in [&format!("\"{cell}\""), &format!("`{head}`"), ", line "] {
                    assert!(refusal.contains(part), "{kind}: {head} {cells:?}: {refusal}");
                }
                continue;
            };
            assert_eq!(found, Ok(Some(date.parse().unwrap())), "{kind}: {head} {cells:?}");
        }
    }
    for (cells, read) in DATES {
        let found = ingested("date", cells[1], read.unwrap_or("2026-06-01"));
        match read {
            Some("2026-06-01") => assert_eq!(found, Ok(()), "{cells:?}"),
            None if !cells[1].is_empty() => {
                let refusal = found.unwrap_err();
                assert!(refusal.contains("line 2: column `date`"), "{refusal}");
            }
            _ => {}
        }
    }
}

/// What the head of a second column says: that it is a rail, or else why it is none.
const HEADS: [(&str, Option<&str>); 44] = [
    ("right", None),
    ("rechts", None),
    ("R", None),
    ("droite", None),
    ("right raw", None),
    ("right corrected", None),
    ("right filtered", None),
    ("left filtered", Some("computed")),
    ("left bandpass 30 300", Some("computed")),
    ("left lowpass", Some("computed")),
    ("left tiefpass", Some("computed")),
    ("left gefiltert", Some("computed")),
    ("left smoothed", Some("computed")),
    ("left detrended", Some("computed")),
    ("left integrated", Some("computed")),
    ("mean", Some("computed")),
    ("Mittelwert", Some("computed")),
    ("difference left right", Some("computed")),
    ("right derivative", Some("computed")),
    ("right slope", Some("computed")),
    ("Steigung rechts", Some("computed")),
    ("right abs", Some("without a sign")),
    ("Betrag rechts", Some("without a sign")),
    ("right rms", Some("without a sign")),
    ("right RMS 1 s", Some("without a sign")),
    ("Effektivwert rechts", Some("without a sign")),
    ("right envelope", Some("without a sign")),
    ("Hüllkurve rechts", Some("without a sign")),
    ("right peak", Some("without a sign")),
    ("lateral right", Some("across")),
    ("lat right", Some("left out")),
    ("hor right", Some("across")),
    ("quer rechts", Some("across")),
    ("longitudinal", Some("across")),
    ("wagon floor", Some("above its axle boxes")),
    ("coach", Some("above its axle boxes")),
    ("bogie frame left", Some("above its axle boxes")),
    ("Wagenkasten", Some("above its axle boxes")),
    ("std right", Some("statistic")),
    ("count", Some("statistic")),
    ("limit", Some("statistic")),
    ("versine right", Some("chord")),
    ("Pfeilhöhe rechts", Some("chord")),
    ("cant", Some("geometry")),
];

// Long: reads a profile and a run under every head.
#[test]
fn columns_are_rails_or_left_out_and_told_in_both_readers() {
    let value = |row: usize| (row * 7919 % 101) as f64 - 50.25;
    for (head, why) in HEADS {
        let rows = (0..280).map(|at| format!("{:.3};{};{}\n", 4e-3 * at as f64, value(at + 40), value(at)));
        let text = format!("x_m;left [um];{head} [um]\n{}", rows.collect::<String>());
        let (rails, said) = with(&text, |path| match RoughnessFile::read(path, &Layout::default(), &|_| ()) {
            Ok(RoughnessFile::Profile(record)) => {
                let said: Vec<String> = record.warnings.iter().map(|it| it.to_string()).collect();
                (record.rails.len(), said.join("; "))
            }
            other => panic!("{head}: {other:?}"),
        });
        let is_told = |said: &str| why.is_some_and(|why| said.contains(why) && said.contains(head));
        assert!(rails == 2 && why.is_none() || rails == 1 && is_told(&said), "roughness, {head}: {said}");
        let rows = (0..1100).map(|at| format!("{:.3};{};{};72\n", 1e-3 * at as f64, value(at + 40), value(at)));
        let text = format!("time_s;left [m/s²];{head} [m/s²];speed_km_per_h\n{}", rows.collect::<String>());
        with(&text, |path| {
            let file = AxleBoxFile::open(path, &AxleBoxLayout::default()).unwrap();
            let (remarks, _) = file.read(None, &mut |_| Ok(()), &|_| ()).unwrap();
            let (channels, said) = (file.channels().len(), in_words(remarks));
            let is_right = channels == 2 && why.is_none() || channels == 1 && is_told(&said);
            assert!(is_right, "axlebox, {head}: {said}");
        });
    }
}

/// Columns of axle boxes that are not read, each told.
#[test]
fn every_column_that_axle_boxes_leave_out_is_told() {
    for (head, cell, why) in [
        ("right", "1.5", "no acceleration, speed, odometer or time"),
        ("temperature_c", "21.5", "no acceleration, speed, odometer or time"),
        ("jerk_right_m_per_s3", "21.5", "no acceleration, speed, odometer or time"),
        ("comment", "dry", "it is text"),
        ("comment", "", "it is empty"),
        ("acceleration_right_m_per_s2", "", "it is empty"),
        ("gps_speed_km_per_h", "71.5", "one before it is of the same kind"),
        ("velocity_right_m_per_s", "20.5", "one before it is of the same kind"),
        ("time_2_s", "20.5", "one before it is of the same kind"),
        ("clock", "02:59:54", "one before it is of the same kind"),
    ] {
        let rows = (0..1100).map(|at| format!("{:.3};{};72;{cell}\n", 1e-3 * at as f64, at * 7919 % 101));
        let text = format!("time_s;left_m_per_s2;speed_km_per_h;{head}\n{}", rows.collect::<String>());
        with(&text, |path| {
            let file = AxleBoxFile::open(path, &AxleBoxLayout::default()).unwrap();
            let (remarks, _) = file.read(None, &mut |_| Ok(()), &|_| ()).unwrap();
            let said = in_words(remarks);
            assert!(said.contains(head) && said.contains(why), "{head}: {said}");
            assert_eq!(file.channels(), ["left"], "{head}");
        });
    }
}

/// Cells of blocks as a spreadsheet may write them.
#[test]
fn blocks_are_read_or_refused_with_column_and_line() {
    let check = |head: &str, cells: [&str; 3]| {
        let row = |rail: &str, at: usize, [from, to, rms]: [&str; 3]| match at {
            0 => format!("{rail},{from},{to},{rms}\n"),
            at => format!("{rail},{at},{},2.5\n", at + 1),
        };
        let rows: Vec<String> = (0..60).map(|at| row("left", at, cells)).collect();
        with(&format!("{head}\n{}", rows.concat()), |path| {
            SurveyFile::check(path).map(|file| file.rows()).map_err(shown)
        })
    };
    let head = "rail,from_m,to_m,rms_30_to_100_mm_um";
    let read = ["2.5", "+2.5", "\"2.5\"", " 2.5 ", "2.5e0", "2.5E+00", "", "NaN"];
    for cell in read {
        assert_eq!(check(head, ["0", "1", cell]), Ok(60), "{cell}");
    }
    let refused = [
        "'2.5",
        "2.5-",
        "\"2,5\"",
        "2.5D0",
        "2.5 um",
        "2.5*",
        "(2.5)",
        "<2.5",
        "2.5\u{a0}",
        "over",
        "-",
        "n/a",
        "#REF!",
        "2..5",
        "2.5.1",
        "12+000.5",
        "km 2.5",
        "\u{2212}2.5",
        "2·5",
        "２.５",
    ];
    for cell in refused {
        let bare = cell.trim_matches('"');
        for (column, cells) in [(2, [cell, "1", "2.5"]), (3, ["0", cell, "2.5"]), (4, ["0", "1", cell])] {
            let refusal = check(head, cells).unwrap_err();
            let part = format!("line 2: column {column} is \"{bare}\"");
            assert!(refusal.contains(&part), "{refusal}");
        }
    }
    for (rail, said) in [("Schiene", None), ("side", None), ("Gleis", None)] {
        let found = check(&head.replace("rail", rail), ["0", "1", "2.5"]);
        assert_eq!(found.as_ref().err().map(String::as_str), said, "{rail}");
    }
}

/// Remarks as one text.
fn in_words(remarks: Vec<Message>) -> String {
    let said = Message::one_after_other(remarks);
    said.map_or_else(String::new, |said| said.to_string())
}
