//! Frequency responses as measuring systems and scripts write them, and what is refused of them.

mod modes;
mod wheelset;

use std::f64::consts::TAU;
use std::fs;
use std::path::PathBuf;

use riffel::{Complex64, Receptance};
use tempfile::TempDir;

use super::*;

/// The response of a file in a folder of its own, read with these keys; a refusal begins with its key.
fn read_with(name: &str, bytes: impl AsRef<[u8]>, keys: &str) -> Result<Measured, String> {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join(name), bytes).unwrap();
    let measurement: Measurement = toml::from_str(&format!("file = {name:?}\n{keys}")).unwrap();
    read(&measurement, folder.path()).map_err(|error| format!("`{}` {}", error.key, error.message))
}

/// A file of the test data.
fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join(name)
}

/// The response of a file of the test data made with NumPy and pyuff from a closed form (tests/measured-tables/make_fixtures.py).
fn of_instrument(name: &str, keys: &str) -> Result<Measured, String> {
    read_with(name, fs::read(file("measured-tables").join(name)).unwrap(), keys)
}

impl Measured {
    /// At a frequency \[Hz\].
    fn at(&self, frequency: f64) -> Complex64 {
        self.receptance.receptance(TAU * frequency, 0.0)
    }

    fn told(&self) -> String {
        self.remarks.iter().map(|remark| format!("{remark}\n")).collect()
    }
}

const CARTESIAN: &str = "real = \"re\"\nimaginary = \"im\"";

/// H = 1e-8/(1 + if/100) at 40 frequencies from 50 to 2500 Hz, times a factor.
fn table(header: &str, row: impl Fn(f64, Complex64) -> String) -> String {
    let mut text = format!("{header}\n");
    for step in 0..40 {
        let frequency = 50.0 * 50f64.powf(f64::from(step) / 39.0);
        let h = 1e-8 / Complex64::new(1.0, frequency / 100.0);
        text.push_str(&row(frequency, h));
        text.push('\n');
    }
    text
}

fn cartesian() -> String {
    table("frequency_hz,re,im", |f, h| format!("{f},{:e},{:e}", h.re, h.im))
}

fn check(measured: &Measured) {
    assert!(!measured.told().contains("energy"));
    let f = 50.0 * 50f64.powf(20.0 / 39.0);
    let h = measured.at(f);
    let expected = 1e-8 / Complex64::new(1.0, f / 100.0);
    assert!((h - expected).norm() < 1e-9 * expected.norm(), "{h} {expected}");
}

#[test]
fn reads_a_table() {
    check(&read_with("rail.csv", cartesian(), CARTESIAN).unwrap());
}

/// Semicolons, decimal commas, kilohertz, a comment, mobility in other units, modulus and phase.
#[test]
fn reads_a_table_as_instruments_write_it() {
    let text = "# exported\r\n".to_owned()
        + &table("f;mod;phase", |f, h| {
            let mobility = h * Complex64::new(0.0, TAU * f);
            // mm/s per kN: 1e-6 m/s per N.
            format!("{};{:e};{}", f / 1e3, 1e6 * mobility.norm(), mobility.arg().to_degrees()).replace('.', ",")
        });
    let keys = "quantity = \"mobility\"\nunit = \"mm/s/kN\"\nfrequency = \"f\"\nfrequency_unit = \"kHz\"\n\
                modulus = \"mod\"\nphase = \"phase\"";
    check(&read_with("rail.csv", text, keys).unwrap());
}

/// Responses with the wrong signs are refused by their name, whatever keys are set, and turned by the keys that the refusal names.
#[test]
fn responses_with_the_wrong_signs_are_refused_and_turned() {
    let text = |signs: [f64; 2]| {
        table("frequency_hz,re,im", |f, h| format!("{f},{:e},{:e}", signs[0] * h.re, signs[1] * h.im))
    };
    let active = "gives energy away (Im H > 0) at 40 of 40 frequencies, and";
    for (signs, says, keys) in [
        ([1.0, 1.0], "", [false, false]),
        ([1.0, -1.0], "the sign of its real part is right: it is conjugated", [true, false]),
        ([-1.0, -1.0], "it is turned in sign", [false, true]),
        ([-1.0, 1.0], "it is conjugated, as with exp(−iωt), and turned in sign", [true, true]),
    ] {
        for set in [[false, false], [true, false], [false, true], [true, true]] {
            let of = |keys: [bool; 2]| format!("conjugate = {}\nnegate = {}", keys[0], keys[1]);
            let read = read_with("rail.csv", text(signs), &format!("{CARTESIAN}\n{}", of(set)));
            if set == keys {
                check(&read.unwrap());
                continue;
            }
            let refusal = read.err().unwrap();
            let key = |name: &str, value: bool| format!("track.measurement.{name} = {value}");
            for part in [key("conjugate", keys[0]), key("negate", keys[1])] {
                assert!(refusal.contains(&part), "{signs:?} {set:?}: {refusal}");
            }
            if set == [false, false] {
                assert!(refusal.contains(says), "{signs:?}: {refusal}");
                assert_eq!(refusal.contains(active), signs[1] < 0.0);
            }
        }
    }
}

/// A mobility that is read as a receptance is none that is conjugated.
#[test]
fn another_quantity_is_told_from_a_wrong_sign() {
    let text = table("frequency_hz,re,im", |f, h| {
        let mobility = 1e-3 * h * Complex64::new(0.0, TAU * f);
        format!("{f},{:e},{:e}", mobility.re, mobility.im)
    });
    let refusal = read_with("rail.csv", text, CARTESIAN).err().unwrap();
    assert!(refusal.contains("as that of a mobility or an accelerance does"), "{refusal}");
}

/// Files written by pyuff: see tests/universal-files/make_fixtures.py. Their displacement points up
/// (direction 3) and their force down (−3), so the receptance in one direction is the negative, which is turned back, for
/// their values are those of one direction. An uneven abscissa in text has six digits, which near a
/// resonance is five of the value, and all values in single precision have six.
#[test]
fn reads_universal_files() {
    for (name, tolerance) in [
        ("receptance_double_even.uff", 1e-10),
        ("receptance_double_uneven.uff", 1e-4),
        ("receptance_binary_even.uff", 1e-10),
        ("mobility_single_even.uff", 1e-5),
        ("accelerance_single_uneven.uff", 1e-4),
    ] {
        let folder = file("universal-files");
        let measured = read_with(name, fs::read(folder.join(name)).unwrap(), "negate = true").unwrap();
        let exact = fs::read_to_string(folder.join("exact.csv")).unwrap();
        let mut compared = 0;
        for line in exact.lines().skip(1) {
            let cells: Vec<f64> = line.split(',').filter_map(|cell| cell.parse().ok()).collect();
            let [frequency, re, im] = cells[..] else {
                continue;
            };
            let uneven = name.contains("uneven");
            let is_even = (frequency / 20.0 - (frequency / 20.0).round()).abs() < 1e-9;
            if uneven == is_even {
                continue;
            }
            let h = measured.at(frequency);
            if h.is_nan() {
                continue; // the last frequency, rounded down in the file
            }
            let expected = Complex64::new(re, im);
            assert!((h - expected).norm() < tolerance * expected.norm(), "{frequency} {h} {expected}");
            compared += 1;
        }
        assert!(compared > 90, "{compared}");
    }
}

#[test]
fn bad_tables() {
    for (text, keys, sentence) in [
        ("frequency_hz,re,im\n1,1,-1\n2,,-1\n", CARTESIAN, "line 3: column `re` is empty"),
        ("frequency_hz,re,im\n1,1,-1\n2,NaN,-1\n", CARTESIAN, "line 3: column `re` is NaN, but must be finite"),
        ("frequency_hz,re,im\n1,1,-1\n2,x,-1\n", CARTESIAN, "line 3: column `re` is \"x\", not a number"),
        ("frequency_hz,re,im\n1,1,-1\n1,1,-1\n", CARTESIAN, "line 3: the frequency 1 Hz is there twice"),
        ("frequency_hz,re,im\n2,1,-1\n1,1,-1\n", CARTESIAN, "line 3: the frequency falls from 2 Hz to 1 Hz"),
        (
            "frequency_hz,re,im\n1,1,-1\n0,1,-1\n",
            CARTESIAN,
            "line 3: the frequency is 0 Hz, but must be greater than zero",
        ),
        (
            "frequency_hz,mod,phase\n100,1e-9,-10\n110,-1e-9,-20\n",
            "",
            "line 3: column `mod` is -0.000000001, but a modulus is not negative (for a column in decibels write \
     track.measurement.unit = \"dB re 1 m/N\")",
        ),
        (
            "frequency_hz,mod [dB],phase\n100,-170,-10\n110,-171,-20\n",
            "",
            "`unit` is left out, but column `mod [dB]` is in decibels: write the \
     reference, as unit = \"dB re 1 m/N\"",
        ),
        (
            "frequency_hz,mod,phase\n100,60,-10\n110,61,-20\n",
            "",
            "those of rails are some 1e-11 to 1e-7 m/N: check track.measurement.quantity and unit",
        ),
        (
            "frequency_hz,mod,phase\n100,1e-9,-0.1\n110,1e-9,-0.2\n",
            "",
            "`phase_unit` is left out, and column `phase` stays within ±0.20",
        ),
        (
            "frequency_hz,re,im,coherence\n100,1e-9,-1e-9,0.9\n110,1e-9,-1e-9,1.2\n",
            "",
            "line 3: column `coherence` is 1.2, but a coherence lies between 0 and 1",
        ),
        (
            "frequency_hz,rail re,wheel re,im\n100,1,1,-1\n",
            "",
            "`real` is left out, and more than one column could be it: `rail re`, `wheel re`",
        ),
        ("100,1e-9,-1e-9\n110,1e-9,-1e-9\n", "", "has no header"),
        ("frequency_hz,re,im\n-1,1,-1\n1,1,-1\n", CARTESIAN, "line 2: the frequency is -1 Hz"),
        ("frequency_hz,re,im\n100,1,-1\n300,1,-1\n", CARTESIAN, "line 3: nothing between 100 Hz and 300 Hz"),
        ("frequency_hz,re,im\n100,1,-1\n", CARTESIAN, "needs two frequencies or more"),
        ("frequency_hz,re,im\n", CARTESIAN, "needs two frequencies or more"),
        ("frequency_hz,re,im\n100,1\n", CARTESIAN, "column `im` is empty"),
        ("", CARTESIAN, "`file` is empty"),
        (
            "f,re,im\n1,1,-1\n",
            "frequency = \"frequency_hz\"\nreal = \"re\"\nimaginary = \"im\"",
            "`frequency` is \"frequency_hz\", but the file has no such column; it has f, re, im",
        ),
        (
            "frequency_hz,re,im\n1,1,-1\n2,1,-1\n",
            "real = \"re\"",
            "`real` and `imaginary`, or by `modulus` and `phase`",
        ),
        (
            "frequency_hz,re,im\n1,1,-1\n2,1,-1\n",
            "real = \"re\"\nimaginary = \"im\"\nunit = \"m/s\"",
            "`unit` is \"m/s\", which is no unit of a receptance in m/N, a mobility",
        ),
        (
            "frequency_hz,re,im\n1,1,-1\n2,1,-1\n",
            "real = \"re\"\nimaginary = \"im\"\nunit = \"furlong\"",
            "unknown unit",
        ),
        (
            "frequency_hz,re,im\n1,1,-1\n2,1,-1\n",
            "real = \"re\"\nimaginary = \"im\"\nfrequency_unit = \"s\"",
            "is no unit of a frequency",
        ),
    ] {
        let error = read_with("rail.csv", text, keys).err().unwrap_or_else(|| panic!("{text:?} is read"));
        assert!(error.contains(sentence), "{text:?}: {error}");
    }
}

#[test]
fn too_many_lines_are_no_frequency_response() {
    let mut text = "frequency_hz,re,im\n".to_owned();
    for line in 1..=200_001 {
        text.push_str(&format!("{line},1e-9,-1e-9\n"));
    }
    let error = read_with("rail.csv", text, CARTESIAN).err().expect("too long");
    assert!(error.contains("more than 200000 lines"), "{error}");
}

#[test]
fn bad_universal_files() {
    let cases: [(&[u8], &str); 2] = [(b"", "the file holds no dataset"), (b"    -1\n    58\n", "line")];
    for (bytes, sentence) in cases {
        let error = read_with("rail.uff", bytes, "").err().expect("a bad file");
        assert!(error.contains(sentence), "{error}");
    }
}

/// Frequencies in radians a second, and what a file does not say of its own: the key that says it is asked for.
#[test]
fn what_a_universal_file_leaves_unsaid_is_asked_for() {
    let text = fs::read_to_string(file("universal-files/receptance_double_even.uff")).unwrap();
    let changed = |changes: &[(&str, &str)], keys: &str| {
        let text = changes.iter().fold(text.clone(), |text, (from, to)| {
            assert!(text.contains(from), "{from}");
            text.replace(from, to)
        });
        // Its displacement and its force point against each other, its values do not.
        let negate = format!("negate = {}\n{keys}", !keys.contains("function"));
        read_with("rail.uff", text, &negate)
    };
    let plain = changed(&[], "").unwrap().at(400.0);
    let radians = changed(&[("Frequency            Hz   ", "Frequency            rad/s")], "");
    let at_400 = radians.unwrap().at(400.0 / TAU);
    assert!((at_400 / plain - 1.0).norm() < 1e-9);
    let no_unit = ("Displacement         m   ", "Displacement         NONE");
    let general = ("         8    1", "         1    1");
    let nowhere = [("RAIL         1   3", "RAIL         1   0"), ("RAIL         1  -3", "RAIL         1   0")];
    for (changes, key, says) in [
        (&[no_unit][..], "unit = \"m/N\"", "track.measurement.unit"),
        (&[general], "quantity = \"receptance\"", "track.measurement.quantity"),
        (&nowhere, "function = 1", "track.measurement.function"),
    ] {
        let refusal = changed(changes, "").err().unwrap();
        assert!(refusal.contains(says), "{refusal}");
        let found = changed(changes, key).unwrap().at(400.0);
        assert!((found / plain - 1.0).norm() < 1e-9, "{key}: {found} {plain}");
    }
    let unknown = changed(&[("Frequency            Hz   ", "Frequency            m/s  ")], "");
    assert!(unknown.err().unwrap().contains("frequency_unit"));
}

#[test]
fn remarks_say_what_was_done() {
    let words = |file: &str, keys: &str| of_instrument(file, keys).unwrap().told();
    let analyser = words("accelerance_g.csv", "");
    assert!(analyser.contains("the measured value at 0 Hz is left out"), "{analyser}");
    assert!(analyser.contains("coherence is below 0.8 at 4 of 250 frequencies, between 10 and 40 Hz"), "{analyser}");
    assert!(!analyser.contains("names no unit"), "{analyser}");
    // Nothing is said where nothing had to be guessed, and it is where something was.
    let spreadsheet = words("receptance_db.txt", "");
    assert!(!spreadsheet.contains("measured") && !spreadsheet.contains("taken as"), "{spreadsheet}");
    let unnamed = words("mobility_savetxt.txt", "quantity = \"mobility\"\nunit = \"mm/s/kN\"");
    assert!(!unnamed.contains("names no unit"), "{unnamed}");
}

#[test]
// Without a unit, values of 1e-2 are not those of a rail.
fn what_does_not_fit_is_refused() {
    for row in [
        "mobility_savetxt.txt =>  => but those of rails are some 1e-11 to 1e-7 m/N",
        "accelerance_g.csv => unit = \"m/N\"\nquantity = \"mobility\" => no unit of a mobility",
        "accelerance_g.csv => quantity = \"receptance\" => is in g/N, an accelerance",
        "receptance_db.txt => unit = \"m/N\" => is in decibels: write the reference",
        "receptance_db.txt => unit = \"dB\" => without a reference: write the reference, as unit = \"dB re 1 m/N\"",
        "three_directions.uff => function = 1 => responds along y to a force along y",
        "three_directions.uff => function = 3 => responds along z to a force along y",
        "three_directions.uff => vertical_axis = \"x\" => 3 frequency responses: choose one",
    ] {
        let [file, keys, sentence] = row.split(" => ").collect::<Vec<_>>()[..] else { panic!("{row}") };
        let error = of_instrument(file, keys).err().expect("refused");
        assert!(error.contains(sentence), "{error}");
    }
}

/// A case may say that the test stood on its side.
#[test]
fn another_axis_may_be_vertical() {
    let soft = of_instrument("three_directions.uff", "vertical_axis = \"y\"").unwrap();
    let vertical = of_instrument("three_directions.uff", "").unwrap();
    let [h, vertical] = [&soft, &vertical].map(|measured| measured.at(490.0));
    assert!((h - 3.0 * vertical).norm() < 1e-6 * h.norm());
}

/// An angular frequency is converted; what is no frequency is refused.
#[test]
fn frequencies_are_converted() {
    for (head, per_hertz) in [("frequency [rad/s]", TAU), ("frequency_rad_s", TAU), ("frequency [kHz]", 1e-3)] {
        let measured = with_frequencies(head, per_hertz).unwrap();
        let found = measured.at(500.0);
        assert!((found.re - 5e-9).abs() < 1e-17, "{head}: {found}");
    }
}

#[test]
fn other_frequencies_are_refused() {
    for (head, part) in [
        ("frequency [rpm]", "column `frequency [rpm]` is in rpm"),
        ("frequency [mm]", "column `frequency [mm]` is in mm"),
    ] {
        let error = with_frequencies(head, 1.0).err().unwrap();
        assert!(error.contains(part), "{error}");
    }
}

/// Receptance with its frequencies in another unit.
fn with_frequencies(head: &str, per_hertz: f64) -> Result<Measured, String> {
    let head = format!("{head},real [m/N],imaginary [m/N]");
    with_rows(&head, |f, re, im| format!("{:.12},{re:.12e},{im:e}", per_hertz * f), "")
}

/// A receptance of 1e-11 m/N for each hertz less 1e-10i m/N, 50 to 3000 Hz, with rows of frequency, real and imaginary part.
fn with_rows(head: &str, row: impl Fn(f64, f64, f64) -> String, keys: &str) -> Result<Measured, String> {
    let rows = (5..=300).map(|line| {
        let hertz = 10.0 * f64::from(line);
        row(hertz, 1e-11 * hertz, -1e-10) + "\n"
    });
    read_with("rail.csv", format!("{head}\n{}", rows.collect::<String>()), keys)
}

/// A factor of a thousand is within what is read, but not within what rails have.
#[test]
fn a_receptance_unlike_any_rail_is_asked_about() {
    let asked = |unit: &str| {
        let measured = of_instrument("receptance_quoted.csv", &format!("unit = \"{unit}\"")).unwrap();
        measured.told().contains("but rails have 1e-11 to 1e-7 m/N")
    };
    assert!(!asked("m/N"));
    assert!(asked("m/mN"));
}

/// Complex numbers in one column, as NumPy, MATLAB and spreadsheets write them, and a modulus under the name of its quantity.
#[test]
fn values_are_read_as_programs_write_them() {
    type Row = fn(f64, f64, f64) -> String;
    let tables: [(&str, Row); 6] = [
        ("# frequency [Hz], H [m/N]", |f, re, im| format!("{f}, ({re:e}{im:+e}j)")),
        ("frequency [Hz],H [m/N]", |f, re, im| format!("{f},{re:e}{im:+e}i")),
        ("Frequenz [Hz];H [m/N]", |f, re, im| format!("{f};{re:e} {im:+e}i").replace('.', ",")),
        ("Frequency [Hz],Receptance [m/N],Phase [rad]", |f, re, im| format!("{f},{:e},{}", re.hypot(im), im.atan2(re))),
        ("Frequenz [Hz];real [m/N];imag [m/N]", |f, re, im| {
            let (thousands, rest) = (f.div_euclid(1e3), f.rem_euclid(1e3));
            match thousands > 0.0 {
                true => format!("{thousands}.{rest:03},0;{re:e};{im:e}"),
                false => format!("{rest},0;{re:e};{im:e}"),
            }
        }),
        ("frequency_hz real_m/N imag_m/N", |f, re, im| format!("{f} {re:.12e} {im:.12e}").replace('e', "D")),
    ];
    for (head, row) in tables {
        let measured = with_rows(head, row, "unit = \"m/N\"").unwrap();
        let found = measured.at(500.0);
        assert!((found.re - 5e-9).abs() < 1e-17 && (found.im + 1e-10).abs() < 1e-17, "{head}: {found}");
    }
}

/// What a head says of unit and quantity is taken, or refused where it is not known; a phase of one turn says no unit.
#[test]
fn what_a_head_says_is_not_passed_over() {
    type Row = fn(f64, f64, f64) -> String;
    let cartesian: Row = |f, re, im| format!("{f},{re:e},{im:e}");
    let of_mobility: Row = |f, re, im| {
        let mobility = Complex64::new(re, im) * Complex64::new(0.0, TAU * f);
        format!("{f},{:e},{}", mobility.norm(), mobility.arg().to_degrees())
    };
    let of_a_turn: Row = |f, re, im| {
        let phase = im.atan2(re).rem_euclid(TAU);
        format!("{f},{:e},{phase}", re.hypot(im))
    };
    for (head, row, expected) in [
        ("f (Hz),Re(H) (mm/kN),Im(H) (mm/kN)", cartesian, Ok(1e-6)),
        ("frequency [Hz],Re [m/N],Im [m/N]", cartesian, Ok(1.0)),
        ("Frequency [Hz],Mobility,Phase [deg]", of_mobility, Ok(1.0)),
        ("frequency [Hz],Re [mm/kgf],Im [mm/kgf]", cartesian, Err("is in mm/kgf, which is no unit")),
        ("frequency [Hz],modulus [m/N],phase", of_a_turn, Err("write \"radians\"")),
    ] {
        match (with_rows(head, row, ""), expected) {
            (Ok(measured), Ok(unit)) => {
                let found = measured.at(500.0);
                assert!((found.re / unit - 5e-9).abs() < 1e-14, "{head}: {found}");
            }
            (Err(error), Err(words)) => {
                assert!(error.contains(words), "{head}: {error}");
            }
            (found, _) => panic!("{head}: {:?}", found.map(|measured| measured.told())),
        }
    }
}

/// A mark of a missing value is no receptance.
#[test]
fn marks_of_missing_values_are_refused() {
    let rows = (5..=300).map(|line| match line {
        20 => "200,-9999,-9999\n".to_owned(),
        _ => format!("{},1e-9,-1e-10\n", 10 * line),
    });
    let text = format!("frequency_hz,real_m_per_n,imag_m_per_n\n{}", rows.collect::<String>());
    let error = read_with("rail.csv", text, "unit = \"m/N\"").err().unwrap();
    assert!(error.contains("line 17: column `real_m_per_n` is -9999, which marks"), "{error}");
}
