//! A frequency response in a table of text.

use riffel::Complex64;

use super::{FrequencyResponse, MeasurementError};
use crate::file::{AngleUnit, Measurement};
use crate::unit::{Exponents, Unit};

/// Most lines: a frequency response has some thousand, a time record has more.
const MOST_LINES: usize = 200_000;

/// The two columns of a complex value.
enum Parts {
    Cartesian([usize; 2]),
    Polar([usize; 2]),
}

/// Read a table with a header, columns separated by comma, semicolon or tab; lines that begin with
/// `#` are left out. With semicolons a decimal comma is understood.
pub(super) fn read(
    bytes: &[u8],
    measurement: &Measurement,
) -> Result<FrequencyResponse, MeasurementError> {
    let delimiter = delimiter(bytes);
    let mut reader = csv::ReaderBuilder::new()
        .delimiter(delimiter)
        .comment(Some(b'#'))
        .trim(csv::Trim::All)
        .from_reader(bytes);
    let broken = |error: &csv::Error| MeasurementError::file(error.to_string());
    let header = reader.headers().map_err(|error| broken(&error))?.clone();
    let frequency_column = column(&header, "frequency", &measurement.frequency)?;
    let parts = parts(&header, measurement)?;
    let to_hertz = factor(
        "frequency_unit",
        &measurement.frequency_unit,
        Exponents::new(0, 0, -1),
        "a frequency in Hz",
    )?;
    let to_si = match &measurement.unit {
        None => 1.0,
        Some(unit) => factor(
            "unit",
            unit,
            measurement.quantity.exponents(),
            measurement.quantity.name(),
        )?,
    };
    let to_radians = match measurement.phase_unit {
        AngleUnit::Degrees => std::f64::consts::PI / 180.0,
        AngleUnit::Radians => 1.0,
    };

    let mut response = FrequencyResponse {
        response: measurement.quantity,
        frequencies: Vec::new(),
        values: Vec::new(),
        places: Vec::new(),
    };
    for record in reader.records() {
        let record = record.map_err(|error| broken(&error))?;
        if response.values.len() == MOST_LINES {
            return Err(MeasurementError::file(format!(
                "has more than {MOST_LINES} lines; a frequency response has some thousand, so this may \
                 be a time record"
            )));
        }
        let line = record.position().map_or(0, csv::Position::line);
        let number = |index: usize| {
            let name = header.get(index).unwrap_or_default();
            let cell = record.get(index).unwrap_or_default();
            number(cell, delimiter).map_err(|rule| {
                MeasurementError::file(format!("line {line}: column `{name}` {rule}"))
            })
        };
        response
            .frequencies
            .push(to_hertz * number(frequency_column)?);
        response.values.push(match parts {
            Parts::Cartesian([real, imaginary]) => {
                to_si * Complex64::new(number(real)?, number(imaginary)?)
            }
            Parts::Polar([modulus, phase]) => {
                to_si * Complex64::from_polar(number(modulus)?, to_radians * number(phase)?)
            }
        });
        response.places.push(format!("line {line}"));
    }
    Ok(response)
}

/// The separator that the header has most of.
fn delimiter(bytes: &[u8]) -> u8 {
    let header = bytes
        .split(|&byte| byte == b'\n')
        .find(|line| !line.is_empty() && !line.starts_with(b"#"))
        .unwrap_or_default();
    let count = |mark: u8| header.iter().filter(|&&byte| byte == mark).count();
    [b';', b'\t']
        .into_iter()
        .filter(|&mark| count(mark) > count(b','))
        .max_by_key(|&mark| count(mark))
        .unwrap_or(b',')
}

/// A finite number, or what is wrong, as the end of a sentence.
fn number(cell: &str, delimiter: u8) -> Result<f64, String> {
    if cell.is_empty() {
        return Err("is empty".to_owned());
    }
    let text = if delimiter == b';' {
        cell.replace(',', ".")
    } else {
        cell.to_owned()
    };
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(_) => Err(format!("is {cell}, but must be finite")),
        Err(_) => Err(format!("is \"{cell}\", not a number")),
    }
}

fn column(
    header: &csv::StringRecord,
    key: &'static str,
    name: &str,
) -> Result<usize, MeasurementError> {
    header
        .iter()
        .position(|known| known == name)
        .ok_or_else(|| {
            let columns: Vec<&str> = header.iter().collect();
            MeasurementError::new(
                key,
                format!(
                    "is \"{name}\", but the file has no such column; it has {}",
                    columns.join(", ")
                ),
            )
        })
}

fn parts(header: &csv::StringRecord, measurement: &Measurement) -> Result<Parts, MeasurementError> {
    let Measurement {
        real,
        imaginary,
        modulus,
        phase,
        ..
    } = measurement;
    match (real, imaginary, modulus, phase) {
        (Some(real), Some(imaginary), None, None) => Ok(Parts::Cartesian([
            column(header, "real", real)?,
            column(header, "imaginary", imaginary)?,
        ])),
        (None, None, Some(modulus), Some(phase)) => Ok(Parts::Polar([
            column(header, "modulus", modulus)?,
            column(header, "phase", phase)?,
        ])),
        _ => Err(MeasurementError::new(
            "",
            "names its values by `real` and `imaginary`, or by `modulus` and `phase`: give the two \
             columns of one pair",
        )),
    }
}

/// Size of a unit in SI.
fn factor(
    key: &'static str,
    unit: &str,
    exponents: Exponents,
    name: &str,
) -> Result<f64, MeasurementError> {
    let parsed = Unit::parse(unit).map_err(|part| {
        MeasurementError::new(
            key,
            format!("is \"{unit}\", with the unknown unit \"{part}\""),
        )
    })?;
    if parsed.exponents != exponents {
        return Err(MeasurementError::new(
            key,
            format!("is \"{unit}\", which is no unit of {name}"),
        ));
    }
    Ok(parsed.factor)
}
