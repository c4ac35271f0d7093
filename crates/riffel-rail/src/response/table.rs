//! A frequency response in a table of text.

use riffel::Complex64;
use riffel_keys::table::marks;
use riffel_keys::{Exponents, Message, Unit};

use super::columns::{Columns, Parts};
use super::keys::{AngleUnit, Measurement};
use super::layout::{Layout, find, rows, unit};
use super::response_unit::{Decoded, ValueUnit};
use super::{FrequencyResponse, MeasurementError};

/// Read a table below the names of its columns, with what was taken for granted.
pub(super) fn read(
    text: &str,
    measurement: &Measurement,
) -> Result<(FrequencyResponse, Vec<Message>), MeasurementError> {
    let layout = layout(text, measurement)?;
    let units = Units::new(&layout, measurement)?;
    let Columns { frequency, values, coherence } = layout.columns;
    let mut response = FrequencyResponse {
        response: units.decoded.response,
        frequencies: Vec::new(),
        values: Vec::new(),
        coherence: coherence.map(|_| Vec::new()),
        places: Vec::new(),
    };
    let mut largest_phase = 0.0_f64;
    // As they stand in the file, column by column.
    let mut written: Vec<Vec<f64>> = vec![Vec::new(); values.all().len()];
    for row in rows(&layout) {
        let row = row?;
        response.frequencies.push(units.to_hertz * row.number(frequency)?);
        for (column, written) in values.all().into_iter().zip(&mut written) {
            written.push(match values {
                Parts::Complex(_) => row.complex(column)?.re,
                Parts::Cartesian(_) | Parts::Polar(_) => row.number(column)?,
            });
        }
        response.values.push(match values {
            Parts::Cartesian([real, imaginary]) => {
                units.decoded.linear() * Complex64::new(row.number(real)?, row.number(imaginary)?)
            }
            Parts::Complex(column) => units.decoded.linear() * row.complex(column)?,
            Parts::Polar([modulus, phase]) => {
                let (size, angle) = (row.number(modulus)?, row.number(phase)?);
                largest_phase = largest_phase.max(angle.abs());
                let modulus = units.decoded.modulus(size).ok_or_else(|| {
                    let rule = format!(
                        "is {size}, but a modulus is not negative (for a column in decibels write \
                         track.measurement.unit = \"dB re 1 {}\")",
                        units.decoded.response.si_unit()
                    );
                    row.wrong(modulus, &rule)
                })?;
                Complex64::from_polar(modulus, units.to_radians * angle)
            }
        });
        if let (Some(column), Some(list)) = (coherence, &mut response.coherence) {
            let value = row.number(column)?;
            if !(0.0..=1.0).contains(&value) {
                let rule = format!("is {value}, but a coherence lies between 0 and 1");
                return Err(row.wrong(column, &rule));
            }
            list.push(value);
        }
        response.places.push(row.place);
    }
    for (column, written) in values.all().into_iter().zip(&written) {
        check_marks(written, &layout.names[column], &response.places)?;
    }
    let is_course = response.values.len() > 1;
    if let Parts::Polar([_, phase]) = values
        && !units.phase_is_known
        && is_course
    {
        check_phase(&layout.names[phase], largest_phase)?;
    }
    Ok((response, units.decoded.remarks))
}

/// The columns: those of parts by their names, or whole complex numbers.
fn layout<'a>(text: &'a str, measurement: &Measurement) -> Result<Layout<'a, Columns>, MeasurementError> {
    let example = "frequency_hz,real,imaginary";
    let in_parts = find(text, example, |header| Columns::find(header, measurement), Columns::all);
    match in_parts {
        Ok(layout) => Ok(layout),
        // Whole numbers may be complex where names tell of no parts.
        Err(reason) => {
            let columns = |header: &[String]| Columns::complex(header, measurement);
            let whole = find(text, example, columns, Columns::all).ok();
            let is_complex = |layout: &Layout<'_, Columns>| {
                let mut rows = layout.rows();
                rows.any(|row| row.is_complex(layout.columns.values.first()))
            };
            whole.filter(is_complex).ok_or(reason)
        }
    }
}

/// Refuse a number that stands for a missing one.
fn check_marks(written: &[f64], column: &str, places: &[String]) -> Result<(), MeasurementError> {
    let Some(marked) = marks(written) else {
        return Ok(());
    };
    let message = format!(
        "{}: column `{column}` is {}, which marks a missing value: leave the line out",
        places[marked.first], marked.mark
    );
    Err(MeasurementError::file(message))
}

/// Refuse phases of an unknown unit that may be radians.
fn check_phase(column: &str, largest: f64) -> Result<(), MeasurementError> {
    // A turn and rounding, from 0 or about it: no phase of a rail stays within 6.3 degrees.
    const A_TURN: f64 = 6.3;
    if largest > A_TURN {
        return Ok(());
    }
    Err(MeasurementError::new(
        "phase_unit",
        format!(
            "is left out, and column `{column}` stays within ±{largest:.2}: write \"radians\", or \"degrees\" if it \
             is so"
        ),
    ))
}

/// What makes SI of the numbers.
struct Units {
    to_hertz: f64,
    to_radians: f64,
    phase_is_known: bool,
    decoded: Decoded,
}

impl Units {
    fn new(layout: &Layout<'_, Columns>, measurement: &Measurement) -> Result<Self, MeasurementError> {
        let phase_in_header = match layout.columns.values {
            Parts::Polar([_, phase]) => unit(layout, phase).and_then(angle),
            Parts::Cartesian(_) | Parts::Complex(_) => None,
        };
        let phase = measurement.phase_unit.or(phase_in_header);
        let (column, is_modulus) = match layout.columns.values {
            Parts::Polar([modulus, _]) => (modulus, true),
            Parts::Cartesian([column, _]) | Parts::Complex(column) => (column, false),
        };
        let decoded = ValueUnit {
            key: measurement.unit.as_deref(),
            quantity: measurement.quantity,
            column: &layout.names[column],
            in_file: unit(layout, column),
            is_modulus,
        }
        .decode()?;
        Ok(Self {
            to_hertz: to_hertz(layout, measurement.frequency_unit.as_ref())?,
            to_radians: match phase.unwrap_or_default() {
                AngleUnit::Degrees => std::f64::consts::PI / 180.0,
                AngleUnit::Radians => 1.0,
            },
            phase_is_known: phase.is_some(),
            decoded,
        })
    }
}

/// Hertz of a unit of frequency.
pub(super) fn hertz_of(unit: &str) -> Option<f64> {
    let plain: String = unit.chars().filter(|c| !c.is_whitespace()).collect();
    match plain.to_lowercase().as_str() {
        "rad/s" | "rad_s" | "rad_per_s" | "rads-1" | "rads^-1" => Some(std::f64::consts::TAU.recip()),
        "hz" => Some(1.0),
        "khz" => Some(1e3),
        _ => Unit::parse(unit).ok().filter(|unit| unit.exponents == Exponents::new(0, 0, -1)).map(|unit| unit.factor),
    }
}

/// Hertz of the unit of the column of frequencies, as the key or else the head says it; 1 where neither does.
fn to_hertz(layout: &Layout<'_, Columns>, key: Option<&String>) -> Result<f64, MeasurementError> {
    let wrong = |message: String| MeasurementError::new("frequency_unit", message);
    if let Some(unit) = key {
        return hertz_of(unit).ok_or_else(|| {
            wrong(format!("is \"{unit}\", which is no unit of a frequency: write \"Hz\", \"kHz\" or \"rad/s\""))
        });
    }
    let column = layout.columns.frequency;
    match unit(layout, column) {
        None => Ok(1.0),
        Some(unit) => hertz_of(unit).ok_or_else(|| {
            wrong(format!(
                "is left out, but column `{}` is in {unit}, which is no unit of a frequency: convert it, or write \
                 \"Hz\", \"kHz\" or \"rad/s\"",
                layout.names[column]
            ))
        }),
    }
}

/// The unit of an angle.
pub(super) fn angle(unit: &str) -> Option<AngleUnit> {
    match unit.to_lowercase().as_str() {
        "°" | "deg" | "degree" | "degrees" | "grad" => Some(AngleUnit::Degrees),
        "rad" | "radian" | "radians" => Some(AngleUnit::Radians),
        _ => None,
    }
}
