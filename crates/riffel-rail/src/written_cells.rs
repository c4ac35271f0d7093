//! Cells of one rail written in other ways than those of its neighbours: read with the right value, or refused with the line,
//! the column and the cell, in every table of records; never lost.

use riffel_keys::CaseError;

use crate::{AxleBoxFile, AxleBoxLayout, AxleBoxReading, Layout, RoughnessFile};

/// How a number is written.
type Writing = fn(f64) -> String;

/// Ways that are read.
const READ: [(&str, Writing); 18] = [
    ("plus", |v| format!("{v:+.2}")),
    ("minus sign", |v| format!("{v:.2}").replace('-', "\u{2212}")),
    ("dash", |v| format!("{v:.2}").replace('-', "\u{2013}")),
    ("apostrophe", |v| format!("'{v:.2}")),
    ("apostrophe and plus", |v| format!("'{v:+.2}")),
    ("typographic apostrophe", |v| format!("\u{2019}{v:.2}")),
    ("quotes", |v| format!("\"{v:.2}\"")),
    ("single quotes", |v| format!("'{v:.2}'")),
    ("minus behind", |v| behind(v, "-")),
    ("minus sign behind", |v| behind(v, "\u{2212}")),
    ("exponent", |v| format!("{v:.4e}")),
    ("capital exponent", |v| format!("{v:.4E}")),
    ("Fortran", |v| format!("{v:.4e}").replace('e', "D")),
    ("exponent with sign", |v| format!("{:.3}E-01", 10.0 * v)),
    ("many digits", |v| format!("{v:.20}")),
    ("blanks", |v| format!("  {v:.2}  ")),
    ("no-break space", |v| format!("{v:.2}\u{a0}")),
    ("narrow no-break space", |v| format!("\u{202f}{v:.2}")),
];

/// Ways that are refused.
const REFUSED: [(&str, Writing); 46] = [
    ("unit", |v| format!("{v:.2} um")),
    ("unit at once", |v| format!("{v:.2}um")),
    ("unit with its sign", |v| format!("{v:.2} µm")),
    ("another unit", |v| format!("{v:.2} mm")),
    ("unit in brackets", |v| format!("{v:.2} [um]")),
    ("decibels", |v| format!("{v:.2} dB")),
    ("squares", |v| format!("{v:.2} m/s²")),
    ("percent", |v| format!("{v:.2} %")),
    ("degrees", |v| format!("{v:.2}°")),
    ("star", |v| format!("{v:.2}*")),
    ("star behind a blank", |v| format!("{v:.2} *")),
    ("two stars", |v| format!("{v:.2}**")),
    ("question mark", |v| format!("{v:.2}?")),
    ("exclamation mark", |v| format!("{v:.2}!")),
    ("hash behind", |v| format!("{v:.2}#")),
    ("letter behind", |v| format!("{v:.2} e")),
    ("footnote", |v| format!("{v:.2}(1)")),
    ("brackets", |v| format!("({:.2})", v.abs())),
    ("brackets of negative ones", |v| match v < 0.0 {
        true => format!("({:.2})", -v),
        false => format!("{v:.2}"),
    }),
    ("square brackets", |v| format!("[{v:.2}]")),
    ("braces", |v| format!("{{{v:.2}}}")),
    ("below", |v| format!("<{v:.2}")),
    ("above", |v| format!(">{v:.2}")),
    ("about", |v| format!("~{v:.2}")),
    ("plus or minus", |v| format!("±{:.2}", v.abs())),
    ("with its uncertainty", |v| format!("{v:.2}±0.02")),
    ("range", |v| format!("{v:.2}..{v:.2}")),
    ("plus behind", |v| format!("{:.2}+", v.abs())),
    ("minus behind a blank", |v| format!("{:.2} -", v.abs())),
    ("two signs", |v| format!("--{:.2}", v.abs())),
    ("equals", |v| format!("={v:.2}")),
    ("formula", |v| format!("z={v:.2}")),
    ("other decimal mark", |v| format!("{v:.2}").replace('.', ",")),
    ("decimal mark of Arabic", |v| format!("{v:.2}").replace('.', "\u{66b}")),
    ("apostrophe and other mark", |v| format!("'{v:.2}").replace('.', ",")),
    ("two points", |v| format!("{v:.2}").replace('.', "..")),
    ("letter for zero", |v| format!("{v:.2}").replace('0', "O").replace('1', "l")),
    ("full width", |v| wide(v)),
    ("power of ten in words", |v| format!("{v:.2}·10^0")),
    ("rail before", |v| format!("R {v:.2}")),
    ("word behind", |v| format!("{v:.2} right")),
    ("flag of some rows", |v| match (100.0 * v) as i64 % 3 {
        0 => format!("{v:.2}"),
        _ => format!("{v:.2}*"),
    }),
    ("words in half of the rows", |v| match v < 0.0 {
        true => "out of range".to_owned(),
        false => format!("{v:.2}"),
    }),
    ("words", |_| "see protocol".to_owned()),
    ("pair", |v| format!("{v:.2}/{v:.2}")),
    ("currency", |v| format!("${v:.2}")),
];

fn behind(value: f64, sign: &str) -> String {
    let sign = if value < 0.0 { sign } else { "" };
    format!("{:.2}{sign}", value.abs())
}

/// With the digits of East Asian printing.
fn wide(value: f64) -> String {
    let digit = |c: char| char::from_u32(0xff10 + c.to_digit(10)?);
    let text = format!("{value:.2}");
    text.chars().map(|c| digit(c).unwrap_or(c)).collect()
}

/// The value of a row, of both signs, never zero.
fn value(row: usize) -> f64 {
    ((row * 7919 % 101) as f64 - 50.5).round() / 5.0
}

/// What a file of some text gives for its right rail, from the words "right" and beyond.
fn read_as(kind: &str, text: &str) -> Result<Vec<f64>, String> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("record.csv");
    std::fs::write(&path, text).unwrap();
    let shown = |error: CaseError| error.to_string();
    if kind != "run" {
        let file = RoughnessFile::read(&path, &Layout::default(), &|_| ()).map_err(shown)?;
        return Ok(match file {
            RoughnessFile::Profile(record) => {
                let right = record.rails.iter().find(|rail| rail.name == "right");
                right.unwrap().stretches[0].heights().to_vec()
            }
            RoughnessFile::Spectra(spectra, _) => {
                let right = spectra.iter().find(|one| one.label("rail") == Some("right_db"));
                let levels = right.unwrap().spectrum.levels();
                levels.iter().map(|level| level.level).collect()
            }
        });
    }
    let file = AxleBoxFile::open(&path, &AxleBoxLayout::default()).map_err(shown)?;
    let mut values = Vec::new();
    let right = file.channels().iter().position(|name| name == "right");
    let mut visit = |reading: AxleBoxReading<'_>| {
        if let AxleBoxReading::Sample(channels, _) = reading {
            values.push(channels[right.unwrap()]);
        }
        Ok(())
    };
    file.read(None, &mut visit, &|_| ()).map_err(shown)?;
    Ok(values)
}

/// A table of some kind whose right rail is written in a way, and whose decimal mark is `mark`.
fn table(kind: &str, write: Writing, mark: &str) -> String {
    let own = |value: f64| format!("{value:.3}").replace('.', mark);
    let bands = [200.0, 160.0, 125.0, 100.0, 80.0, 63.0, 50.0, 40.0, 31.5, 25.0];
    let (head, count) = match kind {
        "profile" => ("x_m;left_um;right_um", 300),
        "spectrum" => ("wavelength_mm;left_db;right_db", bands.len()),
        _ => ("time_s;acceleration_left_m_per_s2;acceleration_right_m_per_s2;speed_km_per_h", 300),
    };
    let rows = (0..count).map(|row| {
        let (left, right) = (own(value(row + 40)), write(value(row)));
        match kind {
            "profile" => format!("{};{left};{right}\n", own(4e-3 * row as f64)),
            "spectrum" => format!("{};{left};{right}\n", own(bands[row])),
            _ => format!("{};{left};{right};{}\n", own(1e-3 * row as f64), own(72.0)),
        }
    });
    format!("{head}\n{}", rows.collect::<String>())
}

const KINDS: [&str; 3] = ["profile", "spectrum", "run"];

// Long: reads three kinds of tables in every way of writing a cell.
#[test]
fn a_rail_is_read_or_refused_however_its_cells_are_written() {
    for kind in KINDS {
        let plain = read_as(kind, &table(kind, |v| format!("{v:.2}"), ".")).unwrap();
        for (way, write) in READ {
            let read = read_as(kind, &table(kind, write, "."));
            assert!(read.as_ref() == Ok(&plain), "{kind}, {way}");
        }
        let point: (&str, Writing) = ("decimal point", |v| format!("{v:.2}"));
        let ways = REFUSED.iter().map(|(way, write)| (way, write, "."));
        for (way, write, mark) in ways.chain([(&point.0, &point.1, ",")]) {
            let text = table(kind, *write, mark);
            let plainly = |v: f64| format!("{v:.2}");
            let row = (0..).find(|&row| write(value(row)) != plainly(value(row)) || mark == ",");
            let row = row.unwrap();
            let refusal = read_as(kind, &text).expect_err(&format!("{kind}, {way}"));
            let cell = write(value(row));
            let cell = cell.trim_matches(['"', '\'']);
            for part in [&format!("line {}", row + 2)[..], "column ", cell] {
                assert!(refusal.contains(part), "{kind}, {way}: {part} in {refusal}");
            }
            let named = refusal.contains("column 3") || refusal.contains("`right_db`");
            assert!(named, "{kind}, {way}: {refusal}");
        }
    }
}

/// Positions [m] in other ways: read, or refused with the first of them.
#[test]
fn a_position_is_read_or_refused_however_it_is_written() {
    let record = |write: Writing| {
        let rows = (0..1200).map(|row| format!("{};{:.2}\n", write(1e-3 * row as f64), value(row)));
        format!("position;height_um\n{}", rows.collect::<String>())
    };
    let of = |write: Writing| {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("record.csv");
        std::fs::write(&path, record(write)).unwrap();
        match RoughnessFile::read(&path, &Layout::default(), &|_| ()) {
            Ok(RoughnessFile::Profile(record)) => Ok((record.from, record.to)),
            Ok(other) => panic!("{other:?}"),
            Err(error) => Err(error.to_string()),
        }
    };
    let read: [(Writing, f64); 8] = [
        (|x| format!("12+{:07.3}", 400.0 + x), 12_400.0),
        (|x| format!("km 12+{:07.3}", 400.0 + x), 12_400.0),
        (|x| format!("km {:.6}", 12.4 + 1e-3 * x), 12_400.0),
        (|x| format!("26.0+{:.3}", 100.0 + x), 26_100.0),
        (|x| format!("26,0+{:.3}", 100.0 + x), 26_100.0),
        (|x| format!("mi:{:.9}", (16_093.44 + x) / 1609.344), 16_093.44),
        (|x| format!("'{:.3}", 5.0 + x), 5.0),
        (|x| format!("12'{:07.3}", 400.0 + x), 12_400.0),
    ];
    for (write, begin) in read {
        let (from, to) = of(write).unwrap();
        // Miles are written to 2 µm.
        assert!((from - begin).abs() < 1e-5 && (to - begin - 1.199).abs() < 1e-5, "{}", write(0.0));
    }
    let refused: [Writing; 8] = [
        |x| format!("26.00+{:.3}", 100.0 + x),
        |x| format!("{:.3} m", 12.0 + x),
        |x| format!("{:.6} km", 12.0 + 1e-3 * x),
        |x| format!("MP {:.6}", 12.0 + 1e-3 * x),
        |x| format!("12/{:.3}", 400.0 + x),
        |x| format!("12:{:.3}", 400.0 + x),
        |x| format!("({:.3})", 12.0 + x),
        |x| format!("00:00:{:06.3}", 12.0 + x),
    ];
    for write in refused {
        let (refusal, cell) = (of(write).unwrap_err(), write(0.0));
        assert!(refusal.contains("column 1") && refusal.contains(&cell), "{cell}: {refusal}");
    }
}

/// Times of day of a run, also over midnight and behind a date: places as those of plain seconds.
#[test]
fn a_clock_is_read_where_a_time_is_wanted() {
    let clock = |seconds: f64| {
        let whole = seconds.floor() as u64;
        let (hours, minutes) = (whole / 3600 % 24, whole / 60 % 60);
        format!("{hours:02}:{minutes:02}:{:08.5}", seconds - (whole / 60 * 60) as f64)
    };
    let run = |head: &str, write: &dyn Fn(f64) -> String| {
        let rows = (0..1200).map(|row| {
            let speed = 72.0 + 0.01 * row as f64;
            format!("{};{:.2};{speed}\n", write(1e-3 * row as f64), value(row))
        });
        let text = format!("{head};acceleration_right_m_per_s2;speed_km_per_h\n{}", rows.collect::<String>());
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("run.csv");
        std::fs::write(&path, text).unwrap();
        let shown = |error: CaseError| error.to_string();
        let file = AxleBoxFile::open(&path, &AxleBoxLayout::default()).map_err(shown)?;
        let mut places = Vec::new();
        let mut visit = |reading: AxleBoxReading<'_>| {
            if let AxleBoxReading::Sample(_, place) = reading {
                places.push(place);
            }
            Ok(())
        };
        let (said, _) = file.read(None, &mut visit, &|_| ()).map_err(shown)?;
        Ok::<_, String>((places, said))
    };
    let (plain, said) = run("time_s", &|t| format!("{t:.5}")).unwrap();
    assert!(plain.len() == 1200 && said.is_empty(), "{said:?}");
    let day = |begin: f64| move |t: f64| clock(begin + t);
    let read: [(&str, &dyn Fn(f64) -> String); 7] = [
        ("time", &day(10_794.000_25)),
        ("time_s", &day(10_794.0)),
        ("Uhrzeit", &day(9999.0)),
        ("clock", &day(86_399.5)),
        ("timestamp", &|t| format!("2026-06-01 {}", clock(86_399.9 + t))),
        ("timestamp", &|t| format!("2026-06-01T{}Z", clock(36_000.0 + t))),
        ("time", &|t| format!("\"{}\"", clock(36_000.0 + t).replace('.', ","))),
    ];
    for (head, write) in read {
        let (places, said) = run(head, write).unwrap_or_else(|it| panic!("{head} {}: {it}", write(0.0)));
        assert!(said.is_empty(), "{head} {}: {said:?}", write(0.0));
        let off = places.iter().zip(&plain).map(|(one, other)| (one - other).abs());
        // Clocks are written to 10 µs, in which the train runs 0.2 mm; the rate is their mean.
        let farthest = off.fold(0.0, f64::max);
        assert!(places.len() == 1200 && farthest < 1e-3, "{head} {}: {farthest}", write(0.0));
    }
    for (cell, line) in [("24:00:00", 2), ("02:60:00", 2), ("02:59", 2), ("2:59:54 pm", 2), ("later", 502)] {
        let write = |t: f64| match t > 0.4999 || line == 2 {
            true => cell.to_owned(),
            false => clock(36_000.0 + t),
        };
        let refusal = run("time", &write).unwrap_err();
        for part in [cell, "column 1", &format!("line {line}")] {
            assert!(refusal.contains(part), "{refusal}");
        }
    }
}
