//! A frequency response in a table of text.

use riffel::Complex64;
use riffel_keys::{Exponents, Remark, Unit};

use super::columns::{Columns, Parts};
use super::response_unit::{Decoded, ValueUnit};
use super::{FrequencyResponse, MeasurementError};
use crate::file::{AngleUnit, Measurement};

/// Most lines: a frequency response has some thousand, a time record has more.
const MOST_LINES: usize = 200_000;

/// Lines among which the header is looked for.
const PREAMBLE: usize = 500;

/// A table as it was read, and what was taken for granted.
pub(super) struct Table {
    pub(super) response: FrequencyResponse,
    pub(super) remarks: Vec<Remark>,
}

/// Read a table: lines before its header are left out, as are those that begin with `#`; columns are
/// separated by semicolon, tab, comma or blanks; unless by a comma, a decimal comma is understood; a row
/// of units may follow the header.
pub(super) fn read(text: &str, measurement: &Measurement) -> Result<Table, MeasurementError> {
    let layout = Layout::find(text, measurement)?;
    let units = Units::new(&layout, measurement)?;
    let Columns {
        frequency,
        values,
        coherence,
    } = layout.columns;
    let mut table = Table {
        response: FrequencyResponse {
            response: units.decoded.response,
            frequencies: Vec::new(),
            values: Vec::new(),
            coherence: coherence.map(|_| Vec::new()),
            places: Vec::new(),
        },
        remarks: units.decoded.remarks.clone(),
    };
    let mut largest_phase = 0.0_f64;
    let rows = text.lines().enumerate().skip(layout.first_row);
    for (index, line) in rows.filter(|(_, line)| !is_blank(line) && !is_comment(line)) {
        let response = &mut table.response;
        if response.values.len() == MOST_LINES {
            return Err(MeasurementError::file(format!(
                "has more than {MOST_LINES} lines; a frequency response has some thousand, so this may \
                 be a time record"
            )));
        }
        let place = format!("line {}", index + 1);
        let cells = layout.separator.cells(line);
        let number = |column: usize| {
            let cell = cells.get(column).map_or("", String::as_str);
            number(cell, layout.separator).map_err(|rule| layout.wrong(&place, column, &rule))
        };
        response
            .frequencies
            .push(units.to_hertz * number(frequency)?);
        response.values.push(match values {
            Parts::Cartesian([real, imaginary]) => {
                units.decoded.linear() * Complex64::new(number(real)?, number(imaginary)?)
            }
            Parts::Polar([modulus, phase]) => {
                let (size, angle) = (number(modulus)?, number(phase)?);
                largest_phase = largest_phase.max(angle.abs());
                let modulus = units.decoded.modulus(size).ok_or_else(|| {
                    let rule = format!(
                        "is {size}, but a modulus is not negative (for a column in decibels write \
                         track.measurement.unit = \"dB re 1 {}\")",
                        units.decoded.response.si_unit()
                    );
                    layout.wrong(&place, modulus, &rule)
                })?;
                Complex64::from_polar(modulus, units.to_radians * angle)
            }
        });
        if let (Some(column), Some(list)) = (coherence, &mut response.coherence) {
            let value = number(column)?;
            if !(0.0..=1.0).contains(&value) {
                let rule = format!("is {value}, but a coherence lies between 0 and 1");
                return Err(layout.wrong(&place, column, &rule));
            }
            list.push(value);
        }
        response.places.push(place);
    }
    // Half a turn and rounding: no phase of a rail stays within 3.2 degrees.
    const HALF_A_TURN: f64 = 3.2;
    if let Parts::Polar([_, phase]) = values
        && !units.phase_is_known
        && table.response.values.len() > 1
        && largest_phase <= HALF_A_TURN
    {
        return Err(MeasurementError::new(
            "phase_unit",
            format!(
                "is left out, and column `{}` stays within ±{largest_phase:.2}: write \"radians\", or \"degrees\" if it \
                 is so",
                layout.header[phase]
            ),
        ));
    }
    Ok(table)
}

fn is_blank(line: &str) -> bool {
    line.trim_matches(|c: char| c.is_whitespace() || matches!(c, ',' | ';'))
        .is_empty()
}

fn is_comment(line: &str) -> bool {
    line.trim_start().starts_with('#')
}

/// What stands between two cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Separator {
    Mark(char),
    Blanks,
}

impl Separator {
    const ALL: [Self; 4] = [
        Self::Mark(';'),
        Self::Mark('\t'),
        Self::Mark(','),
        Self::Blanks,
    ];

    /// The cells of a line without quotation marks and the blanks around them.
    fn cells(self, line: &str) -> Vec<String> {
        let Self::Mark(mark) = self else {
            return line.split_whitespace().map(str::to_owned).collect();
        };
        let mut quoted = false;
        let cells = line.split(|c: char| {
            quoted ^= c == '"';
            c == mark && !quoted
        });
        cells
            .map(|cell| cell.trim().trim_matches('"').trim().to_owned())
            .collect()
    }
}

/// Where the numbers stand.
struct Layout {
    separator: Separator,
    header: Vec<String>,
    /// Cells of the row of units, if there is one.
    units: Vec<String>,
    columns: Columns,
    /// Lines before the first row of numbers.
    first_row: usize,
}

impl Layout {
    /// The first line in which the columns are found and below which numbers stand in them.
    fn find(text: &str, measurement: &Measurement) -> Result<Self, MeasurementError> {
        let head: Vec<&str> = text.lines().take(PREAMBLE).collect();
        for (index, line) in head.iter().enumerate() {
            let found = Separator::ALL
                .into_iter()
                .find_map(|separator| Self::below(&head, index, line, separator, measurement));
            if let Some(layout) = found {
                return Ok(layout);
            }
        }
        Err(Self::reason(&head, measurement))
    }

    fn below(
        head: &[&str],
        index: usize,
        line: &str,
        separator: Separator,
        measurement: &Measurement,
    ) -> Option<Self> {
        let header = separator.cells(line.trim_start_matches(['#', '%', ' ']));
        let columns = Columns::find(&header, measurement).ok()?;
        let mut rows = head.iter().enumerate().skip(index + 1);
        let mut next = || {
            let (index, line) = rows.find(|(_, line)| !is_blank(line) && !is_comment(line))?;
            Some((index, separator.cells(line)))
        };
        let is_row = |cells: &[String]| {
            columns.all().any(|column| {
                cells
                    .get(column)
                    .is_some_and(|cell| number(cell, separator).is_ok())
            })
        };
        let layout = |first_row, units| Self {
            separator,
            header: header.clone(),
            units,
            columns,
            first_row,
        };
        let (first, cells) = match next() {
            Some(row) => row,
            // A header without rows is told of later, as too few frequencies.
            None => return Some(layout(index + 1, Vec::new())),
        };
        if is_row(&cells) {
            return Some(layout(first, Vec::new()));
        }
        let (second, below) = next()?;
        is_row(&below).then(|| layout(second, cells))
    }

    /// Why there is no header.
    fn reason(head: &[&str], measurement: &Measurement) -> MeasurementError {
        // The likeliest header stands over the first row of numbers.
        let of_numbers = |line: &str, separator: Separator| {
            let cells = separator.cells(line);
            let numbers = cells.iter().filter(|cell| number(cell, separator).is_ok());
            numbers.count()
        };
        let lines = || head.iter().filter(|line| !is_blank(line));
        let first = lines().position(|line| {
            let most = Separator::ALL.map(|separator| of_numbers(line, separator));
            most.into_iter().max() > Some(1)
        });
        if first == Some(0) {
            return MeasurementError::file(
                "has no header: its columns need names above them, such as \"frequency_hz,real,imaginary\"",
            );
        }
        let header = lines()
            .nth(first.map_or(0, |first| first - 1))
            .copied()
            .unwrap_or_default();
        let separator = Separator::ALL
            .into_iter()
            .rev()
            .max_by_key(|separator| separator.cells(header).len());
        let header = separator.map_or_else(Vec::new, |separator| separator.cells(header));
        match Columns::find(&header, measurement) {
            Err(error) => error,
            Ok(_) => MeasurementError::file("has no row of numbers below its header"),
        }
    }

    fn wrong(&self, place: &str, column: usize, rule: &str) -> MeasurementError {
        let name = &self.header[column];
        MeasurementError::file(format!("{place}: column `{name}` {rule}"))
    }

    /// The unit of a column, as the row of units or its name has it.
    fn unit(&self, column: usize) -> Option<&str> {
        let below = self.units.get(column).map(String::as_str);
        below
            .map(|unit| unit.trim_matches(['[', ']']).trim())
            .filter(|unit| !unit.is_empty())
            .or_else(|| super::columns::unit_in_name(&self.header[column]))
    }
}

/// What makes SI of the numbers.
struct Units {
    to_hertz: f64,
    to_radians: f64,
    phase_is_known: bool,
    decoded: Decoded,
}

impl Units {
    fn new(layout: &Layout, measurement: &Measurement) -> Result<Self, MeasurementError> {
        let phase_in_header = match layout.columns.values {
            Parts::Polar([_, phase]) => layout.unit(phase).and_then(angle),
            Parts::Cartesian(_) => None,
        };
        let phase = measurement.phase_unit.or(phase_in_header);
        let (column, is_modulus) = match layout.columns.values {
            Parts::Polar([modulus, _]) => (modulus, true),
            Parts::Cartesian([real, _]) => (real, false),
        };
        let decoded = ValueUnit {
            key: measurement.unit.as_deref(),
            quantity: measurement.quantity,
            column: &layout.header[column],
            in_file: layout.unit(column),
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
fn hertz_of(unit: &str) -> Option<f64> {
    let plain: String = unit.chars().filter(|c| !c.is_whitespace()).collect();
    match plain.to_lowercase().as_str() {
        "rad/s" | "rad_s" | "rad_per_s" | "rads-1" | "rads^-1" => {
            Some(std::f64::consts::TAU.recip())
        }
        "hz" => Some(1.0),
        _ => Unit::parse(unit)
            .ok()
            .filter(|unit| unit.exponents == Exponents::new(0, 0, -1))
            .map(|unit| unit.factor),
    }
}

/// Hertz of the unit of the column of frequencies, as the key or else the head says it; 1 where neither does.
fn to_hertz(layout: &Layout, key: Option<&String>) -> Result<f64, MeasurementError> {
    let wrong = |message: String| MeasurementError::new("frequency_unit", message);
    if let Some(unit) = key {
        return hertz_of(unit).ok_or_else(|| {
            wrong(format!(
                "is \"{unit}\", which is no unit of a frequency: write \"Hz\", \"kHz\" or \"rad/s\""
            ))
        });
    }
    let column = layout.columns.frequency;
    match layout.unit(column) {
        None => Ok(1.0),
        Some(unit) => hertz_of(unit).ok_or_else(|| {
            wrong(format!(
                "is left out, but column `{}` is in {unit}, which is no unit of a frequency: convert it, or write \
                 \"Hz\", \"kHz\" or \"rad/s\"",
                layout.header[column]
            ))
        }),
    }
}

fn angle(unit: &str) -> Option<AngleUnit> {
    match unit.to_lowercase().as_str() {
        "°" | "deg" | "degree" | "degrees" | "grad" => Some(AngleUnit::Degrees),
        "rad" | "radian" | "radians" => Some(AngleUnit::Radians),
        _ => None,
    }
}

/// A finite number, or what is wrong, as the end of a sentence.
fn number(cell: &str, separator: Separator) -> Result<f64, String> {
    if cell.is_empty() {
        return Err("is empty".to_owned());
    }
    let has_decimal_comma = separator != Separator::Mark(',') && !cell.contains('.');
    let text = match has_decimal_comma {
        true => cell.replace(',', "."),
        false => cell.to_owned(),
    };
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(_) => Err(format!("is {cell}, but must be finite")),
        Err(_) => Err(format!("is \"{cell}\", not a number")),
    }
}
