//! Files of roughness: profiles and spectra.

use std::path::Path;

use riffel_keys::CaseError;
use riffel_keys::table::{NumberColumns, Table, is_comment, lines, rows};
use riffel_keys::text_file::Encoding;

use crate::format::ReaderFormat;
use crate::labelled_spectrum::LabelledSpectrum;
use crate::layout::Layout;
use crate::profile_columns::ProfileTable;
use crate::record::Record;
use crate::refusal::Refusal;
use crate::{input, plausibility, spectra};

/// What a file of roughness holds.
#[derive(Debug, Clone, PartialEq)]
pub enum RoughnessFile {
    /// A longitudinal profile.
    Profile(Record),
    /// One-third-octave spectra, and what was left out of their table.
    Spectra(Vec<LabelledSpectrum>, Vec<String>),
}

impl RoughnessFile {
    /// Read a file, or standard input for the path `-`: as the layout says, or as its first lines let it be understood.
    /// `progress` is told of bytes done, from several threads.
    ///
    /// Text in columns, with or without a header, in UTF-8, UTF-16 or Windows-1252; blank lines and those that begin
    /// with `#` or `%` are left out, but units are read from remarks above the numbers. A profile needs columns of
    /// heights and a position or a spacing; a table of spectra needs a header with a wavelength and a level, or with
    /// wavelengths. Some hundred megabytes a second.
    ///
    /// # Errors
    /// [`CaseError::Read`] if the file cannot be read, [`CaseError::Data`] with the line and the rule if it is none of
    /// these, or its values are unlike any rail. Defects of less than one row in a hundred are put right and counted in
    /// the warnings of the record.
    pub fn read(
        path: &Path,
        layout: &Layout,
        progress: &(dyn Fn(usize) + Sync),
    ) -> Result<Self, CaseError> {
        let bytes = input::read(path, &|head| match layout.format {
            Some(_) => Ok(()),
            None => Table::find(head).map(|_| ()).ok_or_else(|| no_table(head)),
        })?;
        Self::parse(&bytes, layout, progress).map_err(|refusal| refusal.of(path))
    }

    /// Text in UTF-8 or Windows-1252 whose lines end in line feeds.
    fn parse(
        bytes: &[u8],
        layout: &Layout,
        progress: &(dyn Fn(usize) + Sync),
    ) -> Result<Self, Refusal> {
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        refuse_what_is_no_text(bytes)?;
        let spacing = layout.spacing;
        if let Some(spacing) = spacing {
            if spacing.si() <= 0.0 {
                let message = format!("--spacing is {spacing}, but must be greater than zero");
                return Err(Refusal::new(None, message));
            }
            plausibility::check_spacing(spacing.si(), None)?;
        }
        let (format, count, text_behind, assumptions) = match &layout.format {
            Some(format) => {
                let format = layout.apply(format);
                let (count, text_behind) = count_of(bytes, &format)?;
                (format, count, text_behind, Vec::new())
            }
            None => {
                let table = Table::find(bytes).ok_or_else(|| no_table(bytes))?;
                check_marks(&table)?;
                if let Some(header) = table.heading.names.as_deref()
                    && let Some(columns) = spectra::Columns::of(header, &table)
                {
                    for (argument, given) in [
                        ("--height-unit", &layout.height_unit),
                        ("--position-unit", &layout.position_unit),
                    ] {
                        if given.is_some() {
                            let message = format!(
                                "{argument} is for profiles, but this is a table of levels"
                            );
                            return Err(Refusal::new(None, message));
                        }
                    }
                    progress(bytes.len());
                    let rows = spectra::Rows::new(bytes, &table, header);
                    let read = spectra::read(&rows, &columns);
                    return read.map(|spectra| Self::Spectra(spectra, columns.left_out(&rows)));
                }
                let profile = ProfileTable::new(&table, bytes, layout);
                let format = profile.format().map_err(|message| Refusal {
                    line: None,
                    message,
                    help: Some(HELP.to_owned()),
                })?;
                let assumptions = profile.assumptions(&format);
                (format, table.count(), table.text_behind, assumptions)
            }
        };
        let start = bytes.len() - from_line(bytes, format.header_lines).len();
        let rows = number_columns(&format, count, text_behind)
            .parse(bytes, start, format.header_lines + 1, progress)
            .map_err(|error| Refusal::new(Some(error.line), error.message))?;
        let insisted = layout.height_unit.is_some();
        let record = Record::new(format, rows, assumptions, insisted)?;
        if let Some(spacing) = spacing
            && (spacing.si() / record.spacing - 1.0).abs() > 0.02
        {
            return Err(Refusal::new(
                None,
                format!(
                    "--spacing is {spacing}, but the positions are {} m apart",
                    record.spacing
                ),
            ));
        }
        Ok(Self::Profile(record))
    }
}

/// Refuse a table whose decimal marks leave doubts.
fn check_marks(table: &Table) -> Result<(), Refusal> {
    let line = Some(table.header_lines + 1);
    if table.has_decimal_commas() {
        let message = format!(
            "has {} columns, but its head has {}; where commas divide columns, numbers have a decimal point",
            table.count(),
            table.count() / 2
        );
        let help = "write the file with semicolons or tabs between its columns";
        return Err(Refusal {
            help: Some(help.to_owned()),
            ..Refusal::new(line, message)
        });
    }
    if table.mixed_marks {
        let message = format!(
            "numbers have a {} from here on, but a {} above",
            table.decimal.words(),
            table.decimal.other().words()
        );
        return Err(Refusal::new(line, message));
    }
    Ok(())
}

/// The cells of a format: the position, if there is one, then the rails, and the labels.
fn number_columns(format: &ReaderFormat, count: usize, text_behind: bool) -> NumberColumns {
    let columns = format.position.iter().chain(&format.rails);
    let columns: Vec<usize> = columns.map(|column| column.column - 1).collect();
    let labels: Vec<usize> = format.labels.iter().map(|label| label - 1).collect();
    let marks = (format.delimiter, format.decimal);
    NumberColumns::new(marks, &columns, &labels, count, text_behind)
}

fn no_table(bytes: &[u8]) -> Refusal {
    let first = lines(bytes).position(|line| !is_comment(line));
    Refusal {
        line: first.map(|line| line + 1),
        message: "no table of numbers begins here or below".to_owned(),
        help: Some(HELP.to_owned()),
    }
}

const HELP: &str = "a profile is a position and a height in columns, or heights alone with --spacing; \
                    --format names the columns of any other file";

fn refuse_what_is_no_text(bytes: &[u8]) -> Result<(), Refusal> {
    if bytes.iter().all(u8::is_ascii_whitespace) {
        let what = if bytes.is_empty() {
            "is empty"
        } else {
            "holds only blanks"
        };
        return Err(Refusal::new(None, format!("the file {what}")));
    }
    Encoding::of(bytes).map_err(|byte| Refusal::new(Some(byte.line), byte.to_string()))?;
    Ok(())
}

/// Cells of the first row below the header up to the last number, which must reach to the last column of the format,
/// and whether text stands behind them.
fn count_of(bytes: &[u8], format: &ReaderFormat) -> Result<(usize, bool), Refusal> {
    let columns = format.position.iter().chain(&format.rails);
    let columns = columns.map(|column| column.column);
    let needed = columns
        .chain(format.labels.iter().copied())
        .max()
        .unwrap_or(0);
    let first = rows(
        bytes,
        format.header_lines,
        format.delimiter,
        Some(format.decimal),
    )
    .next();
    let Some(row) = first else {
        let message = format!(
            "nothing follows the {} lines of the header",
            format.header_lines
        );
        return Err(Refusal::new(None, message));
    };
    let refuse = |message: String| Err(Refusal::new(Some(row.line), message));
    if format.delimiter.byte() == format.decimal.byte()
        && !row.cells.iter().any(|cell| cell.starts_with(b"\""))
    {
        let rule = "the reader profile has commas between cells and in numbers, which then stand in quotes";
        return refuse(rule.to_owned());
    }
    let has = row.cells.iter().rposition(|cell| !cell.is_empty());
    let has = has.map_or(0, |last| last + 1);
    let numbers = (0..has).rfind(|&column| row.value(column).is_some());
    if row.cells.len() >= needed {
        let count = numbers.map_or(0, |last| last + 1).max(needed);
        return Ok((count, count < has));
    }
    refuse(format!(
        "the reader profile asks for column {needed}, but there are {has}, separated by {}",
        format.delimiter.words()
    ))
}

/// The text from a line on, counted from zero.
fn from_line(bytes: &[u8], line: usize) -> &[u8] {
    match line.checked_sub(1) {
        None => bytes,
        Some(last) => memchr::memchr_iter(b'\n', bytes)
            .nth(last)
            .map_or(&[], |end| &bytes[end + 1..]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use riffel_keys::quantity::Quantity;

    fn parse(text: &[u8], spacing: Option<f64>) -> Result<RoughnessFile, String> {
        let layout = Layout {
            spacing: spacing.map(Quantity::new),
            ..Layout::default()
        };
        RoughnessFile::parse(text, &layout, &|_| ()).map_err(|refusal| match refusal.line {
            Some(line) => format!("line {line}: {}", refusal.message),
            None => refusal.message,
        })
    }

    fn profile(text: &str) -> Record {
        match parse(text.as_bytes(), None) {
            Ok(RoughnessFile::Profile(record)) => record,
            other => panic!("{other:?}"),
        }
    }

    fn height(row: usize) -> f64 {
        (row * 7919 % 101) as f64 * 0.1 - 5.0
    }

    fn rows(count: usize) -> Vec<String> {
        (0..count)
            .map(|row| format!("{:.3},{:.1}", 10.0 + 1e-3 * row as f64, height(row)))
            .collect()
    }

    #[test]
    fn positions_and_heights_come_back() {
        let text = rows(2000).join("\n");
        let record = profile(&text);
        assert_eq!((record.spacing, record.rails.len()), (1e-3, 1));
        let stretch = &record.rails[0].stretches[0];
        assert_eq!(stretch.start(), 10.0);
        for (row, found) in stretch.heights().iter().enumerate() {
            assert!((found - 1e-6 * height(row)).abs() < 1e-18);
        }
        // The other way round, the same rail.
        let mut falling = rows(2000);
        falling.reverse();
        let again = profile(&(falling.join("\r\n") + "\r\n"));
        assert!(again.falling);
        let (again, stretch) = (&again.rails[0].stretches[0], stretch.heights());
        assert!((again.start() - 10.0).abs() < 1e-9);
        assert_eq!(again.heights(), stretch);
    }

    #[test]
    fn heights_alone_need_a_spacing() {
        let text: String = (0..1500)
            .map(|row| format!("{:.1}\n", height(row)))
            .collect();
        assert!(
            parse(text.as_bytes(), None)
                .unwrap_err()
                .contains("no position")
        );
        let Ok(RoughnessFile::Profile(record)) = parse(text.as_bytes(), Some(1e-3)) else {
            panic!("no profile");
        };
        assert_eq!(record.rails[0].stretches[0].heights().len(), 1500);
    }

    #[test]
    fn defects_are_named_with_their_line() {
        let refusal = |change: &dyn Fn(&mut Vec<String>)| {
            let mut rows = rows(2000);
            change(&mut rows);
            parse(rows.join("\n").as_bytes(), None).unwrap_err()
        };
        let wrong = refusal(&|rows| rows[1500] = "11.500,abc".to_owned());
        assert!(
            wrong.starts_with("line 1501: column 2 is \"abc\""),
            "{wrong}"
        );
        let wrong = refusal(&|rows| rows[1500] = "11.500".to_owned());
        assert!(wrong.starts_with("line 1501: has 1 column"), "{wrong}");
        let wrong = refusal(&|rows| (700..800).for_each(|row| rows[row] = rows[700].clone()));
        assert!(wrong.starts_with("line 702: 99 rows"), "{wrong}");
        let wrong = refusal(&|rows| {
            (0..2000).for_each(|row| rows[row] = format!("{},1.0", 1e-3 * row as f64))
        });
        assert!(wrong.contains("every height is 1"), "{wrong}");
        let clip = |row: usize| {
            format!(
                "{:.3},{:.1}",
                1e-3 * row as f64,
                height(row).clamp(-5.0, 5.0) * 3.0
            )
        };
        let wrong = refusal(&|rows| {
            for (row, line) in rows.iter_mut().enumerate() {
                *line = match row % 20 {
                    0..9 => format!("{:.3},15.0", 1e-3 * row as f64),
                    _ => clip(row),
                };
            }
        });
        assert!(wrong.contains("clipped"), "{wrong}");
        let wrong = refusal(&|rows| rows.truncate(900));
        assert!(wrong.contains("no stretch of 1 m"), "{wrong}");
        let mixed: String = (0..2000)
            .map(|row| match row {
                1700 => "1.700;2,5\n".to_owned(),
                _ => format!("{:.3};{:.1}\n", 1e-3 * row as f64, height(row)),
            })
            .collect();
        let wrong = parse(mixed.as_bytes(), None).unwrap_err();
        assert!(
            wrong.starts_with("line 1701: column 2 is \"2,5\", with a decimal comma"),
            "{wrong}"
        );
        // However many rows there are of either mark.
        let turns: String = (0..2000)
            .map(|row| {
                let line = format!("{:.3};{:.1}\n", 1e-3 * row as f64, height(row));
                if row < 900 {
                    line
                } else {
                    line.replace('.', ",")
                }
            })
            .collect();
        let wrong = parse(turns.as_bytes(), None).unwrap_err();
        assert!(
            wrong.starts_with("line 901: numbers have a decimal comma from here on"),
            "{wrong}"
        );
        let wrong = refusal(&|rows| rows[1500] = "11.500,-1e9".to_owned());
        assert!(
            wrong.starts_with("line 1501: rail column 2: a height of -1000 m"),
            "{wrong}"
        );
        assert_eq!(parse(b"", None).unwrap_err(), "the file is empty");
        assert!(
            parse(b"\x7fELF\x02\x01\x00\x00", None)
                .unwrap_err()
                .starts_with("line 1: the file is binary")
        );
        assert!(
            parse(b"only words\nand more\n", None)
                .unwrap_err()
                .starts_with("line 1: no table")
        );
    }

    #[test]
    fn what_can_be_put_right_is_counted() {
        let mut some = rows(4000);
        some[500] = format!("{:.3},NaN", 10.5);
        some[1000] = format!("{:.3},", 11.0);
        some[1500] = some[1499].clone();
        some.insert(3, "# a remark".to_owned());
        let record = profile(&some.join("\n"));
        let warnings = record.warnings.join("\n");
        assert!(
            warnings.contains("2 heights missing") && warnings.contains("line 502"),
            "{warnings}"
        );
        assert!(
            warnings.contains("1 row with the position of the row before"),
            "{warnings}"
        );
        assert!(warnings.contains("line 1502"), "{warnings}");
        assert_eq!(record.rails[0].stretches.len(), 1);
        assert_eq!(record.rails[0].stretches[0].heights().len(), 4000);
    }

    /// A title of one cell above two columns divided by commas says nothing of decimal commas.
    #[test]
    fn a_title_is_no_head() {
        let mut text = String::from("a title\n");
        for sample in 0..4000 {
            let position = f64::from(sample) * 1e-3;
            text += &format!("{position:.3},{:.2}\n", 7.0 * (140.0 * position).sin());
        }
        let Ok(RoughnessFile::Profile(record)) = parse(text.as_bytes(), None) else {
            panic!("no profile");
        };
        assert_eq!(record.rails.len(), 1);
    }

    /// Ways of other programs to write the same record.
    #[test]
    fn the_same_rail_in_many_tables() {
        let written = |head: &str, row: &dyn Fn(usize) -> String| {
            let rows: Vec<String> = (0..1500).map(row).collect();
            let record = profile(&format!("{head}{}\n", rows.join("\n")));
            assert_eq!(record.rails.len(), 1, "{head}");
            record.rails[0].stretches.clone()
        };
        let x = |row: usize| 1e-3 * row as f64;
        let plain = written("", &|row| format!("{:.3},{:.1}", x(row), height(row)));
        let comma = |value: f64| format!("{value:.3}").replace('.', ",");
        let fortran = |value: f64| format!("{value:.6e}").replace('e', "D");
        let others: [(&str, &dyn Fn(usize) -> String); 7] = [
            (",x_m,height_um\n", &|row| {
                format!("{row},{:.3},{:.1}", x(row), height(row))
            }),
            ("\"x (m)\",\"z (um)\"\n", &|row| {
                format!("\"{}\",\"{}\"", comma(x(row)), comma(height(row)))
            }),
            ("", &|row| {
                format!("  {} {}", fortran(x(row)), fortran(height(row)))
            }),
            ("x_m,z_um\n", &|row| {
                format!("{:.3},{:.1}", x(row), height(row)).replace('-', "\u{2212}")
            }),
            ("x_m,z [um],cant [mm]\n", &|row| {
                format!("{:.3},{:.1},0.{}", x(row), height(row), row % 7)
            }),
            ("x_m,z_um,limit_um\n", &|row| {
                format!("{:.3},{:.1},5", x(row), height(row))
            }),
            ("rail,x_m,z_um\n", &|row| {
                format!("L,{:.3},{:.1}", x(row), height(row))
            }),
        ];
        for (head, row) in others {
            assert_eq!(written(head, row), plain, "{head}");
        }
    }

    #[test]
    fn rows_of_other_labels_are_other_rails() {
        let of = |rail: &str, size: f64| -> Vec<String> {
            let rows = (0..1500).map(|row| (1e-3 * row as f64, size * height(row)));
            rows.map(|(x, z)| format!("{rail},{x:.3},{z:.1}\n"))
                .collect()
        };
        let (left, right) = (of("L", 1.0), of("R", 2.0));
        let blocks = format!("rail,x_m,z_um\n{}{}", left.concat(), right.concat());
        let mixed: String = left
            .iter()
            .zip(&right)
            .map(|(l, r)| l.clone() + r)
            .collect();
        for text in [blocks, format!("rail,x_m,z_um\n{mixed}")] {
            let record = profile(&text);
            let names: Vec<&str> = record.rails.iter().map(|rail| &rail.name[..]).collect();
            assert_eq!(names, ["L", "R"]);
            assert_eq!((record.from, record.to), (0.0, 1.499));
            let height = |rail: usize| record.rails[rail].stretches[0].heights()[3];
            assert!((height(1) - 2.0 * height(0)).abs() < 1e-12);
        }
    }

    #[test]
    fn marks_of_missing_values_are_no_heights() {
        for mark in ["-9999", "-999", "9999", "-32768"] {
            let mut rows = rows(2000);
            rows[700] = format!("10.700,{mark}");
            let record = profile(&rows.join("\n"));
            let said = format!("column 2 has {mark} in 1 row,");
            assert!(
                record
                    .warnings
                    .iter()
                    .any(|warning| warning.starts_with(&said)),
                "{mark}"
            );
            let heights = record.rails[0].stretches[0].heights();
            assert!(heights.iter().all(|height| height.abs() < 6e-6), "{mark}");
        }
    }

    #[test]
    fn limits_and_scatter_are_no_levels_and_octaves_no_third_octaves() {
        let names = |head: &str, row: &str| {
            let bands = ["50", "40", "31.5", "25"].map(|band| format!("{band},{row}\n"));
            match parse(format!("{head}\n{}", bands.concat()).as_bytes(), None) {
                Ok(RoughnessFile::Spectra(spectra, _)) => spectra.len(),
                other => panic!("{head}: {other:?}"),
            }
        };
        assert_eq!(
            names("wavelength_mm,mean_db,min_db,max_db,std_db", "2,-1,5,1"),
            1
        );
        assert_eq!(
            names("wavelength_mm,L (dB),R (dB),ISO 3095 (dB)", "2,-1,5"),
            2
        );
        let octaves = "wavelength_mm,level_db\n500,10\n250,8\n125,6\n63,4\n31.5,2\n";
        let wrong = parse(octaves.as_bytes(), None).unwrap_err();
        assert!(wrong.contains("those of octaves"), "{wrong}");
    }

    #[test]
    fn track_geometry_is_called_so() {
        let rows = (0..400).map(|row| format!("{},0.0{}\n", 0.25 * f64::from(row), row % 9));
        let text = format!("chainage_m,left_mm\n{}", rows.collect::<String>());
        let wrong = parse(text.as_bytes(), None).unwrap_err();
        assert!(
            wrong.contains("0.25 m apart, as those of track geometry"),
            "{wrong}"
        );
    }

    #[test]
    fn spectra_are_told_by_their_header() {
        let text = "site,wavelength_mm,level_db\nA,20,-4.0\nA,25,-3.0\nB,19.95,-6\n";
        let Ok(RoughnessFile::Spectra(spectra, _)) = parse(text.as_bytes(), None) else {
            panic!("no spectra");
        };
        assert_eq!(spectra.len(), 2);
        assert_eq!(spectra[1].label("site"), Some("B"));
        assert_eq!(spectra[0].spectrum.levels().len(), 2);
        let twice = "wavelength_mm,level_db\n20,-4.0\n19.953,-3.0\n";
        assert!(
            parse(twice.as_bytes(), None)
                .unwrap_err()
                .starts_with("line 3: 20 mm is there twice")
        );
        // Lines are those of the file, whatever stands above the table and between it and its header.
        let below = "a title\n\n# wavelength_mm,level_db\n\n20,-4.0\n25,-2.0\n19.953,-3.0\n";
        assert!(
            parse(below.as_bytes(), None)
                .unwrap_err()
                .starts_with("line 7: 20 mm is there twice")
        );
        let odd = "site,wavelength_mm,level_db\nA,20,-4.0\nA,25,-2.0\nA,31.5\nA,40,1\n";
        let wrong = parse(odd.as_bytes(), None).unwrap_err();
        assert_eq!(wrong, "line 4: has 2 columns, the header has 3");
        let none = "wavelength_mm,level_db\n20,-4.0\n22.4,-3.0\n25,1\n";
        assert!(
            parse(none.as_bytes(), None)
                .unwrap_err()
                .starts_with("line 3: 22.4 mm is no")
        );
    }

    #[test]
    fn bands_may_be_columns() {
        for header in [
            "site;31,5 mm;40 mm;50 mm;63 mm",
            "site / wavelength mm;31,5;40;50;63",
            "site;L_31.5mm;L_40mm;L_50mm;L_63mm",
        ] {
            let text = format!("{header}\nBern;2,5;3;20,1;\nThun;1,5;2;4,5;3\n");
            let Ok(RoughnessFile::Spectra(spectra, _)) = parse(text.as_bytes(), None) else {
                panic!("{header}: {:?}", parse(text.as_bytes(), None));
            };
            assert_eq!(spectra.len(), 2, "{header}");
            assert_eq!(spectra[0].spectrum.levels().len(), 3, "{header}");
            assert_eq!(spectra[1].spectrum.levels().len(), 4, "{header}");
            assert_eq!(spectra[1].labels[0].1, "Thun");
        }
        let rails = "wavelength_mm,left,right\n50,2,3\n40,1,5\n";
        let Ok(RoughnessFile::Spectra(spectra, _)) = parse(rails.as_bytes(), None) else {
            panic!("no spectra");
        };
        assert_eq!(spectra[1].label("rail"), Some("right"));
        assert_eq!(spectra[1].spectrum.levels()[0].level, 5.0);
        let bare = "site;31.5;40;50;63;80\nBern;2;3;20;3;2\n";
        let wrong = parse(bare.as_bytes(), None).unwrap_err();
        assert!(wrong.contains("have no unit"), "{wrong}");
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(300))]
        /// Whatever is in a file, it is read or refused with a sentence.
        #[test]
        fn no_file_panics(bytes in prop::collection::vec(any::<u8>(), 0..400), spaced in any::<bool>()) {
            if let Err(message) = parse(&bytes, spaced.then_some(0.01)) {
                prop_assert!(message.len() > 10);
            }
        }

        #[test]
        fn no_table_panics(text in "([0-9NnaAeE+.,;\t# -]{0,12}\n){0,60}", spaced in any::<bool>()) {
            if let Err(message) = parse(text.as_bytes(), spaced.then_some(0.1)) {
                prop_assert!(message.len() > 10);
            }
        }

        /// A whole profile with lines changed at random is read or refused.
        #[test]
        fn no_broken_profile_panics(
            changes in prop::collection::vec((0..2200usize, "[0-9.,;aN-]{0,10}"), 0..20),
        ) {
            let mut rows = rows(2200);
            for (row, text) in changes {
                rows[row] = text;
            }
            if let Ok(RoughnessFile::Profile(record)) = parse(rows.join("\n").as_bytes(), None) {
                prop_assert!(record.rails.iter().all(|rail| !rail.stretches.is_empty()));
            }
        }
    }
}
