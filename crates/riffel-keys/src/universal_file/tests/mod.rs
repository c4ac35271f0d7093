//! The reader against files of pyuff, against the definition's layouts, and against damaged files.

mod binary;
mod damage;

use std::fs;
use std::path::{Path, PathBuf};

use riffel::Complex64;

use super::{Axis, Freedom, Function, Units, UniversalFile, read};

pub(super) use binary::binary;

/// Rounding to six digits, as E13.5 writes them: half a unit of the last one.
const SINGLE: f64 = 5e-6;
/// Rounding to the twelve digits that pyuff writes in the field E20.12, and twice the rounding of
/// the formula, which loses some digits at the resonances.
const DOUBLE: f64 = 5e-12 + 2.0 * FORMULA;
/// Binary doubles lose nothing: what is left is the rounding of the formula here and there.
const FORMULA: f64 = 1e-12;

pub(super) const FIXTURES: [&str; 11] = [
    "accelerance_single_uneven.uff",
    "mobility_single_even.uff",
    "modulus_double_even.uff",
    "modulus_double_uneven.uff",
    "modulus_single_even.uff",
    "modulus_single_uneven.uff",
    "receptance_binary_even.uff",
    "receptance_binary_uneven.uff",
    "receptance_double_even.uff",
    "receptance_double_uneven.uff",
    "several.uff",
];

fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../riffel-rail/tests/universal-files").join(name)
}

pub(super) fn fixture(name: &str) -> Vec<u8> {
    fs::read(path(name)).unwrap()
}

fn only_function(file: UniversalFile) -> Function {
    let [function] = file.functions.try_into().unwrap();
    function
}

fn sentence(bytes: &[u8]) -> String {
    read(bytes).unwrap_err().to_string()
}

fn even() -> Vec<f64> {
    (1..=100).map(|step| 20.0 * f64::from(step)).collect()
}

fn uneven() -> Vec<f64> {
    let exponent = |step| 2.0 * f64::from(step) / 99.0;
    (0..100).map(|step| 20.0 * 10f64.powf(exponent(step))).collect()
}

fn laplace(frequency: f64) -> Complex64 {
    Complex64::new(0.0, std::f64::consts::TAU * frequency)
}

/// Receptance of the two masses of the fixtures.
fn receptance(frequency: f64) -> Complex64 {
    let s = laplace(frequency);
    let (m1, m2) = (2.0, 0.5);
    let ground = 2e6 + 40.0 * s;
    let between = 5e6 + 30.0 * s;
    let second = m2 * s * s + between;
    second / ((m1 * s * s + ground + between) * second - between * between)
}

fn mobility(frequency: f64) -> Complex64 {
    receptance(frequency) * laplace(frequency)
}

fn accelerance(frequency: f64) -> Complex64 {
    mobility(frequency) * laplace(frequency)
}

fn modulus(frequency: f64) -> Complex64 {
    receptance(frequency).norm().into()
}

fn assert_near(read: &[Complex64], exact: impl Iterator<Item = Complex64>, tolerance: f64) {
    let exact: Vec<Complex64> = exact.collect();
    assert_eq!(read.len(), exact.len());
    for (index, (read, exact)) in read.iter().zip(&exact).enumerate() {
        let error = (read - exact).norm() / exact.norm();
        assert!(error <= tolerance, "point {index}: {read} for {exact}");
    }
}

/// Every file of pyuff gives back the function it was made from. An uneven abscissa has six digits
/// in the text form, whatever the ordinate has.
#[test]
fn reads_what_pyuff_writes() {
    type Row<'a> = (&'a str, fn(f64) -> Complex64, Vec<f64>, f64, i32, bool, f64);
    let cases: [Row<'_>; 10] = [
        ("receptance_double_even.uff", receptance, even(), 0.0, 8, true, DOUBLE),
        ("receptance_double_uneven.uff", receptance, uneven(), SINGLE, 8, true, DOUBLE),
        ("receptance_binary_even.uff", receptance, even(), 0.0, 8, true, FORMULA),
        ("receptance_binary_uneven.uff", receptance, uneven(), FORMULA, 8, true, FORMULA),
        ("mobility_single_even.uff", mobility, even(), 0.0, 11, true, SINGLE),
        ("accelerance_single_uneven.uff", accelerance, uneven(), SINGLE, 12, true, SINGLE),
        ("modulus_double_even.uff", modulus, even(), 0.0, 8, false, DOUBLE),
        ("modulus_double_uneven.uff", modulus, uneven(), SINGLE, 8, false, DOUBLE),
        ("modulus_single_even.uff", modulus, even(), 0.0, 8, false, SINGLE),
        ("modulus_single_uneven.uff", modulus, uneven(), SINGLE, 8, false, SINGLE),
    ];
    for (name, exact, frequencies, abscissa_tolerance, kind, complex, tolerance) in cases {
        let file = read(&fixture(name)).unwrap();
        assert_eq!(file.units, None);
        let function = only_function(file);
        assert_eq!(function.line, 1);
        assert_eq!(function.function_type, 4);
        assert_eq!(function.abscissa_axis.kind, 18);
        assert_eq!(function.numerator.kind, kind);
        assert_eq!(function.denominator.kind, 13);
        assert_eq!(function.complex, complex);
        assert_eq!(function.abscissa.len(), frequencies.len());
        for (read, exact) in function.abscissa.iter().zip(&frequencies) {
            assert!((read - exact).abs() <= abscissa_tolerance * exact, "{read} for {exact}");
        }
        assert_near(&function.ordinate, frequencies.iter().map(|&f| exact(f)), tolerance);
    }
}

/// The formula of the fixtures and the one of the tests are the same.
#[test]
fn formula_is_that_of_the_fixtures() {
    let table = fs::read_to_string(path("exact.csv")).unwrap();
    let frequencies = even().into_iter().chain(uneven());
    assert_eq!(table.lines().count(), 201);
    for (row, frequency) in table.lines().skip(1).zip(frequencies) {
        let row: Vec<f64> = row.split(',').map(|cell| cell.parse().unwrap()).collect();
        let exact = receptance(frequency);
        assert!((row[0] / frequency - 1.0).abs() < 1e-14);
        assert!((Complex64::new(row[1], row[2]) - exact).norm() < FORMULA * exact.norm());
    }
}

/// Every field of the header, units in millimetres, and two functions after a skipped dataset.
#[test]
fn reads_several_datasets_and_units() {
    let file = read(&fixture("several.uff")).unwrap();
    let units = file.units.unwrap();
    assert_eq!(units, Units { length: 1000.0, force: 1.0, temperature: 1.0, temperature_offset: 273.15 });
    let [first, second] = <[Function; 2]>::try_from(file.functions).unwrap();
    assert_eq!((first.line, second.line), (17, 81));
    assert_eq!(first.title, "displacement over force");
    assert_eq!(first.load_case, 0);
    let freedom = |node, direction| Freedom { entity: "RAIL".to_owned(), node, direction };
    assert_eq!(first.response, freedom(1, 3));
    assert_eq!(second.response, freedom(2, 3));
    assert_eq!(second.reference, freedom(1, -3));
    let axis = |kind, length, force, label: &str, unit: &str| Axis {
        kind,
        length,
        force,
        temperature: 0,
        label: label.to_owned(),
        unit: unit.to_owned(),
    };
    assert_eq!(first.abscissa_axis, axis(18, 0, 0, "Frequency", "Hz"));
    assert_eq!(first.numerator, axis(8, 1, 0, "Displacement", "m"));
    assert_eq!(first.denominator, axis(13, 0, 1, "Force", "N"));
    let si: Vec<Complex64> = first.ordinate.iter().map(|value| value / units.length * units.force).collect();
    assert_near(&si, even().into_iter().map(receptance), DOUBLE);
}

/// A dataset 58 of two complex points, single precision, even spacing.
const SMALL: &str = "    -1
    58
Receptance
NONE
NONE
NONE
NONE
    4         0    0         0       NONE         1   3       NONE         1   3
         5         2         1  2.00000e+01  1.00000e+01  0.00000e+00
        18    0    0    0 NONE                 Hz
         8    0    0    0 NONE                 m
        13    0    0    0 NONE                 N
         0    0    0    0 NONE                 NONE
  1.00000e+00 -2.00000e+00  3.00000e+00 -4.00000e+00
    -1
";

const SMALL_DATA: &str = "  1.00000e+00 -2.00000e+00  3.00000e+00 -4.00000e+00\n";

/// A dataset 164 in millimetres.
const MILLIMETRES: &str = "    -1
   164
         9mm and N                     1
  1.00000000000000000D+03  1.00000000000000000D+00  1.00000000000000000D+00
  2.73149999999999980D+02
    -1
";

fn small_with(from: &str, to: &str) -> String {
    let text = SMALL.replacen(from, to, 1);
    assert_ne!(text, SMALL);
    text
}

fn small_points() -> Vec<Complex64> {
    vec![Complex64::new(1.0, -2.0), Complex64::new(3.0, -4.0)]
}

#[test]
fn reads_the_manners_of_writers() {
    for text in [
        SMALL.to_owned(),
        SMALL.replace('\n', "\r\n"),
        SMALL.replace('\n', "                    \n"),
        SMALL.trim_end().to_owned(),
        format!("\n{SMALL}\n  \n"),
        SMALL.replace('e', "E"),
        small_with(SMALL_DATA, "  1.00000D+00 -2.00000d+00  3.00000D+00 -4.00000D+00\n"),
        small_with(SMALL_DATA, "            1          -2.          3.0        -4.00\n"),
        small_with("-4.00000e+00\n", "-4.00000e+00  0.00000e+00  0.00000e+00\n"),
        format!("    -1\n    15\n         1         0\n        -1\n    -1\n{SMALL}"),
    ] {
        let function = only_function(read(text.as_bytes()).unwrap());
        assert_eq!(function.abscissa, [20.0, 30.0]);
        assert_eq!(function.ordinate, small_points());
    }
}

/// Fields are columns: they may touch, and a large exponent displaces its letter.
#[test]
fn reads_fields_that_touch() {
    let text = small_with(SMALL_DATA, "-0.10000E+001-2.0000000000-1.00000e-300-1.23450-100\n");
    let function = only_function(read(text.as_bytes()).unwrap());
    let expected = [Complex64::new(-1.0, -2.0), Complex64::new(-1e-300, -1.2345e-100)];
    assert_eq!(function.ordinate, expected);
}

/// A unit of an older system, a micrometre in Latin-1, takes one column as it does in UTF-8.
#[test]
fn reads_labels_of_either_encoding() {
    let cases: [&[u8]; 2] = [b"\xb5m", "µm".as_bytes()];
    for unit in cases {
        let axis = b"         8    0    0    0 NONE                 m\n";
        let at = SMALL.find(str::from_utf8(axis).unwrap()).unwrap() + axis.len() - 2;
        let mut bytes = SMALL.as_bytes().to_vec();
        bytes.splice(at..at + 1, unit.iter().copied());
        assert_eq!(only_function(read(&bytes).unwrap()).numerator.unit, "µm");
    }
}

/// Units stand alone, and may be repeated.
#[test]
fn reads_units_alone() {
    let file = read(MILLIMETRES.repeat(2).as_bytes()).unwrap();
    assert!(file.functions.is_empty());
    assert_eq!(file.units.unwrap().length, 1000.0);
}

const POINTS: [[f64; 3]; 3] = [[20.0, 1.5, -2.25], [40.0, -3.0, 4.5], [80.0, 5.0, 0.125]];

#[test]
fn refuses_what_is_no_universal_file() {
    for row in [
        " => the file holds no dataset, which would begin with -1 in columns 5 and 6",
        "\n \n => the file holds no dataset, which would begin with -1 in columns 5 and 6",
        "20.0,1.0\n => line 1: this stands outside of the datasets, which begin and end with -1 in columns 5 and 6",
        "-1\n    58\n => line 1: this stands outside of the datasets, which begin and end with -1 in columns 5 and 6",
        "    -1\n => line 1: the dataset that begins here is cut short by the end of the file",
        "    -1\n    15\n => line 1: the dataset that begins here is cut short by the end of the file",
        "    -1\n    -1\n => line 2: the dataset ends where its number must stand",
        "    -1\nabcdef\n => line 2: the number of the dataset must be a whole number within 32 bits, not \"abcdef\"",
        "    -1\n\n => line 2: the number of the dataset must be positive, not 0",
        "    -1\n    58c\n => line 2: column 7 must be blank, or \"b\" in a dataset 58, not \"c\"",
        "    -1\n    55b\n => line 2: column 7 must be blank, or \"b\" in a dataset 58, not \"b\"",
    ] {
        let (text, expected) = row.split_once(" => ").unwrap();
        assert_eq!(sentence(text.as_bytes()), expected);
    }
}

#[test]
fn refuses_damaged_functions() {
    for row in [
        "        13    0    0    0 =>     -1\n => line 12: the dataset ends where its record 10 must stand",
        "-4.00000e+00\n    -1\n => -4.00000e+00\n => line 1: the dataset that begins here is cut short by the end of the file",
        "       NONE         1   3       NONE         1   3 =>  RAILWAYSET1         1   3       NONE         1   3 => line 8: column 56 must be blank, as it lies between two fields",
        "NONE         1   3 => NONE         x   3 => line 8: the node must be a whole number within 32 bits, not \"x\"",
        "         5         2 =>          3         2 => line 9: the data type of the ordinate must be 2 or 4 or 5 or 6, not 3",
        "         2         1 =>          2         2 => line 9: the spacing of the abscissa must be 0 or 1, not 2",
        "         5         2 =>          5         0 => line 9: the number of points must be positive, not 0",
        "         5         2 =>          5        -2 => line 9: the number of points must be positive, not -2",
        "         5         2 =>          59999999999 => line 9: the number of points must be a whole number within 32 bits, not \"9999999999\"",
        "         5         2 =>          52147483647 => line 9: the number of points is 2147483647, which takes 4294967294 numbers, but the dataset holds 4",
        "         5         2 =>          5         3 => line 9: the number of points is 3, which takes 6 numbers, but the dataset holds 4",
        "         5         2 =>          5         1 => line 14: the number of points is 1, which takes 2 numbers, but the dataset goes on after them",
        "-4.00000e+00\n => -4.00000e+00\n  0.00000e+00\n => line 15: the number of points is 2, which takes 4 numbers, but the dataset goes on after them",
        "-4.00000e+00\n => -4.00000e+00  0.00000e+00  1.00000e+00\n => line 14: the number of points is 2, which takes 4 numbers, but the dataset goes on after them",
        "  3.00000e+00 -4.00000e+00\n => \n  3.00000e+00 -4.00000e+00\n => line 14: this line must hold 4 numbers, not 2",
        "-4.00000e+00\n => -4.00000e+00                           x\n => line 14: the numbers of this line end in column 52, but text follows",
        "  1.00000e+01  0.0 =>   0.00000e+00  0.0 => line 9: the increment of the abscissa must be positive, not 0",
        "  2.00000e+01 =>           NaN => line 9: the minimum of the abscissa must be a finite number, not \"NaN\"",
        "  2.00000e+01  1.00000e+01 =>  1.00000e+308 1.79000e+308 => line 9: the last value of the abscissa must be a finite number, not \"inf\"",
        "  3.00000e+00 =>           NaN => line 14: a value must be a finite number, not \"NaN\"",
        "  3.00000e+00 =>      Infinity => line 14: a value must be a finite number, not \"Infinity\"",
        "  3.00000e+00 =>  3.00000e+999 => line 14: a value must be a finite number, not \"3.00000e+999\"",
        "  3.00000e+00 => ************* => line 14: a value must be a finite number, not \"*************\"",
        "  3.00000e+00 =>   3,00000e+00 => line 14: a value must be a finite number, not \"3,00000e+00\"",
        "         8    0 =>          8    m => line 11: the exponent of length must be a whole number within 32 bits, not \"m\"",
    ] {
        let [from, to, expected] = row.split(" => ").collect::<Vec<_>>()[..] else { panic!("{row}") };
        assert_eq!(sentence(small_with(from, to).as_bytes()), expected);
    }
}

#[test]
fn refuses_damaged_units() {
    for row in [
        "1.00000000000000000D+03 => 0.00000000000000000D+00 => line 4: the factor of length must be positive, not 0",
        "1.00000000000000000D+03 =>             millimetres => line 4: the factor of length must be a finite number, not \"millimetres\"",
        "  2.73149999999999980D+02\n =>  => line 5: the dataset ends where its temperature offset must stand",
    ] {
        let [from, to, expected] = row.split(" => ").collect::<Vec<_>>()[..] else { panic!("{row}") };
        let text = MILLIMETRES.replacen(from, to, 1);
        assert_eq!(sentence(text.as_bytes()), expected);
    }
}

#[test]
fn refuses_two_units() {
    let other = MILLIMETRES.replacen("1.00000000000000000D+03", "1.00000000000000000D+00", 1);
    assert_eq!(
        sentence(format!("{MILLIMETRES}{other}").as_bytes()),
        "line 8: the file states its units a second time, and differently"
    );
}
