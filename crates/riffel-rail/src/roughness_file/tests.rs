use super::*;
use proptest::prelude::*;
use riffel_keys::quantity::Quantity;

fn parse(text: &[u8], spacing: Option<f64>) -> Result<RoughnessFile, String> {
    let layout = Layout { spacing: spacing.map(Quantity::new), ..Layout::default() };
    RoughnessFile::parse(text, &layout, &|_| ()).map_err(|refusal| match refusal.line {
        Some(line) => format!("line {line}: {}", refusal.message),
        None => refusal.message.to_string(),
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
    (0..count).map(|row| format!("{:.3},{:.1}", 10.0 + 1e-3 * row as f64, height(row))).collect()
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
    let text: String = (0..1500).map(|row| format!("{:.1}\n", height(row))).collect();
    assert!(parse(text.as_bytes(), None).unwrap_err().contains("no position"));
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
    assert!(wrong.starts_with("line 1501: column 2 is \"abc\""), "{wrong}");
    let wrong = refusal(&|rows| rows[1500] = "11.500".to_owned());
    assert!(wrong.starts_with("line 1501: has 1 column"), "{wrong}");
    let wrong = refusal(&|rows| (700..800).for_each(|row| rows[row] = rows[700].clone()));
    assert!(wrong.starts_with("line 702: 99 rows"), "{wrong}");
    let wrong = refusal(&|rows| (0..2000).for_each(|row| rows[row] = format!("{},1.0", 1e-3 * row as f64)));
    assert!(wrong.contains("every height is 1"), "{wrong}");
    let clip = |row: usize| format!("{:.3},{:.1}", 1e-3 * row as f64, height(row).clamp(-5.0, 5.0) * 3.0);
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
    assert!(wrong.starts_with("line 1701: column 2 is \"2,5\", with a decimal comma"), "{wrong}");
    // However many rows there are of either mark.
    let turns: String = (0..2000)
        .map(|row| {
            let line = format!("{:.3};{:.1}\n", 1e-3 * row as f64, height(row));
            if row < 900 { line } else { line.replace('.', ",") }
        })
        .collect();
    let wrong = parse(turns.as_bytes(), None).unwrap_err();
    assert!(wrong.starts_with("line 901: numbers have a decimal comma from here on"), "{wrong}");
    let wrong = refusal(&|rows| rows[1500] = "11.500,-1e9".to_owned());
    assert!(wrong.starts_with("line 1501: rail column 2: a height of -1000 m"), "{wrong}");
    assert_eq!(parse(b"", None).unwrap_err(), "the file is empty");
    assert!(parse(b"\x7fELF\x02\x01\x00\x00", None).unwrap_err().starts_with("line 1: the file is binary"));
    assert!(parse(b"only words\nand more\n", None).unwrap_err().starts_with("line 1: no table"));
}

#[test]
fn what_can_be_put_right_is_counted() {
    let mut some = rows(4000);
    some[500] = format!("{:.3},NaN", 10.5);
    some[1000] = format!("{:.3},", 11.0);
    some[1500] = some[1499].clone();
    some.insert(3, "# a remark".to_owned());
    let record = profile(&some.join("\n"));
    let warnings: Vec<String> = record.warnings.iter().map(ToString::to_string).collect();
    let warnings = warnings.join("\n");
    assert!(warnings.contains("2 heights missing") && warnings.contains("line 502"), "{warnings}");
    assert!(warnings.contains("1 row with the position of the row before"), "{warnings}");
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
        (",x_m,height_um\n", &|row| format!("{row},{:.3},{:.1}", x(row), height(row))),
        ("\"x (m)\",\"z (um)\"\n", &|row| format!("\"{}\",\"{}\"", comma(x(row)), comma(height(row)))),
        ("", &|row| format!("  {} {}", fortran(x(row)), fortran(height(row)))),
        ("x_m,z_um\n", &|row| format!("{:.3},{:.1}", x(row), height(row)).replace('-', "\u{2212}")),
        ("x_m,z [um],cant [mm]\n", &|row| format!("{:.3},{:.1},0.{}", x(row), height(row), row % 7)),
        ("x_m,z_um,limit_um\n", &|row| format!("{:.3},{:.1},5", x(row), height(row))),
        ("rail,x_m,z_um\n", &|row| format!("L,{:.3},{:.1}", x(row), height(row))),
    ];
    for (head, row) in others {
        assert_eq!(written(head, row), plain, "{head}");
    }
}

#[test]
fn rows_of_other_labels_are_other_rails() {
    let of = |rail: &str, size: f64| -> Vec<String> {
        let rows = (0..1500).map(|row| (1e-3 * row as f64, size * height(row)));
        rows.map(|(x, z)| format!("{rail},{x:.3},{z:.1}\n")).collect()
    };
    let (left, right) = (of("L", 1.0), of("R", 2.0));
    let blocks = format!("rail,x_m,z_um\n{}{}", left.concat(), right.concat());
    let mixed: String = left.iter().zip(&right).map(|(l, r)| l.clone() + r).collect();
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
        assert!(record.warnings.iter().any(|warning| warning.to_string().starts_with(&said)), "{mark}");
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
    assert_eq!(names("wavelength_mm,mean_db,min_db,max_db,std_db", "2,-1,5,1"), 1);
    assert_eq!(names("wavelength_mm,L (dB),R (dB),ISO 3095 (dB)", "2,-1,5"), 2);
    let octaves = "wavelength_mm,level_db\n500,10\n250,8\n125,6\n63,4\n31.5,2\n";
    let wrong = parse(octaves.as_bytes(), None).unwrap_err();
    assert!(wrong.contains("those of octaves"), "{wrong}");
}

#[test]
fn track_geometry_is_called_so() {
    let rows = (0..400).map(|row| format!("{},0.0{}\n", 0.25 * f64::from(row), row % 9));
    let text = format!("chainage_m,left_mm\n{}", rows.collect::<String>());
    let wrong = parse(text.as_bytes(), None).unwrap_err();
    assert!(wrong.contains("0.25 m apart, as those of track geometry"), "{wrong}");
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
    assert!(parse(twice.as_bytes(), None).unwrap_err().starts_with("line 3: 20 mm is there twice"));
    // Lines are those of the file, whatever stands above the table and between it and its header.
    let below = "a title\n\n# wavelength_mm,level_db\n\n20,-4.0\n25,-2.0\n19.953,-3.0\n";
    assert!(parse(below.as_bytes(), None).unwrap_err().starts_with("line 7: 20 mm is there twice"));
    let odd = "site,wavelength_mm,level_db\nA,20,-4.0\nA,25,-2.0\nA,31.5\nA,40,1\n";
    let wrong = parse(odd.as_bytes(), None).unwrap_err();
    assert_eq!(wrong, "line 4: has 2 columns, the header has 3");
    let none = "wavelength_mm,level_db\n20,-4.0\n22.4,-3.0\n25,1\n";
    assert!(parse(none.as_bytes(), None).unwrap_err().starts_with("line 3: 22.4 mm is no"));
}

#[test]
fn bands_may_be_columns() {
    for header in
        ["site;31,5 mm;40 mm;50 mm;63 mm", "site / wavelength mm;31,5;40;50;63", "site;L_31.5mm;L_40mm;L_50mm;L_63mm"]
    {
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
    // Long: reads 300 fuzzed profiles.
    #[test]
    fn no_broken_profile_panics(
        changes in prop::collection::vec((0..550usize, "[0-9.,;aN-]{0,10}"), 0..20),
    ) {
        // A stretch is of a metre and more.
        let row = |row: usize| format!("{:.3},{:.1}", 10.0 + 4e-3 * row as f64, height(row));
        let mut rows: Vec<String> = (0..550).map(row).collect();
        for (row, text) in changes {
            rows[row] = text;
        }
        if let Ok(RoughnessFile::Profile(record)) = parse(rows.join("\n").as_bytes(), None) {
            prop_assert!(record.rails.iter().all(|rail| !rail.stretches.is_empty()));
        }
    }
}
