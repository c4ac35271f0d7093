//! Measured receptances of a wheelset in a table of text.

use std::f64::consts::{PI, TAU};
use std::path::Path;

use riffel::wheelset::{MeasuredEntry, MeasuredWheelset, Port, Violation};
use riffel::{Complex64, Direction, Rail};
use riffel_keys::table::it_has;
use riffel_keys::{Message, fixed, say};

use super::columns::{Parts, Role, without_unit};
use super::doubts::check_sign;
use super::keys::AngleUnit;
use super::layout::{Layout, Row, find, rows, unit};
use super::response_unit::{Decoded, ValueUnit, after_decibel, response_of};
use super::table::{angle, hertz_of};
use super::{FrequencyResponse, MeasurementError, bytes_of, decoded};

/// Violations of reciprocity and passivity up to which nothing is said \[-\]: rounding to four digits stays below.
const ROUNDING: f64 = 1e-3;

/// A measured wheelset, and what the reader of the case should know of it.
pub struct WheelsetReceptances {
    /// The wheelset.
    pub wheelset: MeasuredWheelset,
    /// What was taken for granted, and what no wheelset can have.
    pub remarks: Vec<Message>,
}

impl WheelsetReceptances {
    /// The file at the path; where it holds one wheel, that on `rail`.
    ///
    /// # Errors
    /// [`MeasurementError`] for a file that cannot be read or is no table of receptances of a wheelset.
    pub fn read(path: &Path, rail: Rail) -> Result<Self, MeasurementError> {
        let bytes = bytes_of(path, "table of receptances")?;
        Self::parse(&decoded(bytes)?, rail)
    }

    pub(super) fn parse(text: &str, rail: Rail) -> Result<Self, MeasurementError> {
        let example = "frequency_hz,zz_re,zz_im";
        let layout = find(text, example, EntryColumns::find, EntryColumns::numbers)?;
        let EntryColumns { frequency, entries } = &layout.columns;
        let to_hertz = match unit(&layout, *frequency) {
            None => 1.0,
            Some(unit) => hertz_of(unit)
                .ok_or_else(|| wrong(&layout, *frequency, "write a unit of a frequency, Hz, kHz or rad/s"))?,
        };
        let mut responses = Vec::with_capacity(entries.len());
        let mut remarks = Vec::new();
        for entry in entries {
            let units = Units::of(&layout, entry.values)?;
            // Once for all.
            if remarks.is_empty() && unit(&layout, entry.values.first()).is_none() {
                let column = &layout.names[entry.values.first()];
                remarks.push(say!(column_of_wheelset_without_unit, column));
            }
            let response = FrequencyResponse {
                response: units.decoded.response,
                frequencies: Vec::new(),
                values: Vec::new(),
                coherence: None,
                places: Vec::new(),
            };
            responses.push((units, response));
        }
        for row in rows(&layout) {
            let row = row?;
            let frequency = to_hertz * row.number(*frequency)?;
            for (entry, (units, response)) in entries.iter().zip(&mut responses) {
                response.frequencies.push(frequency);
                response.values.push(units.value(&row, entry.values)?);
                response.places.push(row.place.clone());
            }
        }
        let mut left_out = Vec::new();
        let mut receptances = Vec::with_capacity(responses.len());
        for ((_, response), entry) in responses.into_iter().zip(entries) {
            let measured = response.read()?;
            if let Some(port) = entry.ports.own() {
                let check = check_sign(&measured.receptance, ROUNDING);
                check.map_err(|rule| MeasurementError::file(say!(about, subject = port, remark = rule)))?;
            }
            left_out = measured.remarks;
            receptances.push(measured.receptance);
        }
        remarks.extend(left_out);
        let ports = entries.iter().map(|entry| entry.ports).zip(receptances);
        let wheelset = match entries[0].ports {
            Ports::OneWheel(..) => {
                let entries = ports.filter_map(|(ports, receptance)| match ports {
                    Ports::OneWheel(at, from) => Some((at, from, receptance)),
                    Ports::Both(..) => None,
                });
                MeasuredWheelset::from_one_wheel(rail, entries.collect())
            }
            Ports::Both(..) => {
                let entries = ports.filter_map(|(ports, receptance)| match ports {
                    Ports::Both(at, from) => Some(MeasuredEntry { at, from, receptance }),
                    Ports::OneWheel(..) => None,
                });
                MeasuredWheelset::new(entries.collect())
            }
        };
        let wheelset = wheelset.map_err(|error| MeasurementError::file(error.to_string()))?;
        remarks.extend(layout.columns.not_measured());
        remarks.extend(violations(&wheelset));
        Ok(Self { wheelset, remarks })
    }
}

/// What no wheelset can have.
fn violations(wheelset: &MeasuredWheelset) -> impl Iterator<Item = Message> {
    let beyond_rounding = |violation: &Violation| violation.size > ROUNDING;
    let reciprocity = wheelset.reciprocity_violation().filter(beyond_rounding);
    let reciprocity = reciprocity.map(|violation| {
        let (percent, hertz) = (1e2 * violation.size, violation.angular_frequency / TAU);
        let [at, from] = violation.ports.map(name);
        say!(wheelset_not_reciprocal, at, from, percent = fixed(percent, 2), hertz = fixed(hertz, 1))
    });
    let passivity = wheelset.passivity_violation().filter(beyond_rounding);
    let passivity = passivity.map(|violation| {
        let (percent, hertz) = (1e2 * violation.size, violation.angular_frequency / TAU);
        let port = name(violation.ports[0]);
        say!(wheelset_gives_energy, percent = fixed(percent, 2), hertz = fixed(hertz, 1), port)
    });
    reciprocity.into_iter().chain(passivity)
}

/// A port as columns name it.
fn name(port: Port) -> String {
    format!("{}_{}", port.rail.name(), axis_name(port.direction))
}

fn axis_name(direction: Direction) -> &'static str {
    match direction {
        Direction::Longitudinal => "x",
        Direction::Lateral => "y",
        Direction::Vertical => "z",
    }
}

fn wrong(layout: &Layout<'_, EntryColumns>, column: usize, rule: &str) -> MeasurementError {
    let unit = unit(layout, column).unwrap_or_default();
    let name = &layout.names[column];
    MeasurementError::file(format!("has column `{name}` in \"{unit}\": {rule}"))
}

/// Displacement and force of an entry.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Ports {
    /// Of a wheelset.
    Both(Port, Port),
    /// Of one wheel of it.
    OneWheel(Direction, Direction),
}

impl Ports {
    /// Those that the name of a column begins with: `yz_re`, `left_y_right_z_re`.
    fn of(name: &str) -> Option<Self> {
        let own = without_unit(name).to_lowercase();
        let mut words = own.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
        let first = words.next()?;
        let Some(rail) = rail(first) else {
            let (at, from) = first.split_at_checked(1)?;
            return Some(Self::OneWheel(axis(at)?, axis(from)?));
        };
        let at = Port::new(rail, axis(words.next()?)?);
        let rail = self::rail(words.next()?)?;
        Some(Self::Both(at, Port::new(rail, axis(words.next()?)?)))
    }
}

impl Ports {
    /// What columns call the port whose displacement and force these are; None of two ports.
    fn own(self) -> Option<String> {
        match self {
            Self::Both(at, from) => (at == from).then(|| name(at)),
            Self::OneWheel(at, from) => (at == from).then(|| axis_name(at).to_owned()),
        }
    }
}

fn rail(word: &str) -> Option<Rail> {
    match word {
        "left" | "l" => Some(Rail::Left),
        "right" | "r" => Some(Rail::Right),
        _ => None,
    }
}

fn axis(word: &str) -> Option<Direction> {
    match word {
        "x" => Some(Direction::Longitudinal),
        "y" => Some(Direction::Lateral),
        "z" => Some(Direction::Vertical),
        _ => None,
    }
}

/// An entry of the receptances and its two columns.
struct Entry {
    ports: Ports,
    values: Parts,
}

/// Which column of a table of receptances holds what.
struct EntryColumns {
    frequency: usize,
    /// One or more, all of one wheel or all of both.
    entries: Vec<Entry>,
}

impl EntryColumns {
    fn find(header: &[String]) -> Result<Self, MeasurementError> {
        let mut frequency = None;
        // Real, imaginary, modulus, phase.
        let mut found: Vec<(Ports, [Option<usize>; 4])> = Vec::new();
        for (column, name) in header.iter().enumerate().filter(|(_, name)| !name.is_empty()) {
            let part = Role::of(name).and_then(part);
            let slot = match (Ports::of(name), part) {
                (Some(ports), Some(part)) => {
                    let index = found.iter().position(|(known, _)| *known == ports);
                    let index = index.unwrap_or_else(|| {
                        found.push((ports, [None; 4]));
                        found.len() - 1
                    });
                    &mut found[index].1[part]
                }
                _ if Role::of(name) == Some(Role::Frequency) => &mut frequency,
                _ => {
                    return Err(MeasurementError::file(format!(
                        "has column `{name}`, which is no frequency and no part of a receptance: those of one wheel \
                         are called as xx_re, yz_im, zz_modulus, zz_phase (displacement, force, part), those of both \
                         as left_x_right_x_re"
                    )));
                }
            };
            if let Some(first) = slot.replace(column) {
                return Err(MeasurementError::file(format!(
                    "has two columns for one quantity: `{}`, `{name}`",
                    header[first]
                )));
            }
        }
        let Some(frequency) = frequency else {
            let message = format!("names no frequency; {}", it_has(header));
            return Err(MeasurementError::file(message));
        };
        let entries = found.into_iter().map(|(ports, columns)| {
            let values = match columns {
                [Some(real), Some(imaginary), None, None] => Parts::Cartesian([real, imaginary]),
                [None, None, Some(modulus), Some(phase)] => Parts::Polar([modulus, phase]),
                _ => {
                    let columns: Vec<&str> = columns.iter().flatten().map(|&column| &*header[column]).collect();
                    return Err(MeasurementError::file(format!(
                        "has {} of a receptance, which needs its real and imaginary part, or its modulus and phase",
                        columns.join(", ")
                    )));
                }
            };
            Ok(Entry { ports, values })
        });
        let entries: Vec<Entry> = entries.collect::<Result<_, _>>()?;
        let Some(first) = entries.first() else {
            return Err(MeasurementError::file(format!("names no receptance, as zz_re and zz_im; {}", it_has(header))));
        };
        let of_both = |entry: &Entry| matches!(entry.ports, Ports::Both(..));
        if let Some(other) = entries.iter().find(|other| of_both(other) != of_both(first)) {
            return Err(MeasurementError::file(format!(
                "has receptances of one wheel and of both: `{}`, `{}`",
                header[first.values.first()],
                header[other.values.first()]
            )));
        }
        Ok(Self { frequency, entries })
    }

    /// Axes along which no wheel was measured.
    fn not_measured(&self) -> Option<Message> {
        let measured = |axis: Direction| {
            self.entries.iter().any(|entry| match entry.ports {
                Ports::OneWheel(at, from) => at == axis && from == axis,
                Ports::Both(at, from) => at == from && at.direction == axis,
            })
        };
        let missing: Vec<&str> = [Direction::Longitudinal, Direction::Lateral, Direction::Vertical]
            .into_iter()
            .filter(|&axis| !measured(axis))
            .map(axis_name)
            .collect();
        (!missing.is_empty()).then(|| {
            let axes = missing.join(", ");
            say!(wheelset_not_measured_along, axes)
        })
    }
}

impl EntryColumns {
    /// All columns.
    fn numbers(&self) -> Vec<usize> {
        let entries = self.entries.iter().flat_map(|entry| entry.values.all());
        [self.frequency].into_iter().chain(entries).collect()
    }
}

/// Which of real part, imaginary part, modulus and phase it is.
fn part(role: Role) -> Option<usize> {
    match role {
        Role::Real => Some(0),
        Role::Imaginary => Some(1),
        Role::Modulus => Some(2),
        Role::Phase => Some(3),
        Role::Frequency | Role::Coherence => None,
    }
}

/// What makes SI of the values of an entry.
struct Units {
    decoded: Decoded,
    to_radians: f64,
}

impl Units {
    fn of(layout: &Layout<'_, EntryColumns>, values: Parts) -> Result<Self, MeasurementError> {
        let column = values.first();
        let in_file = unit(layout, column);
        let value_unit = ValueUnit {
            key: None,
            quantity: None,
            column: &layout.names[column],
            in_file,
            is_modulus: matches!(values, Parts::Polar(_)),
        };
        let is_known = |unit: &str| response_of(unit).is_some() || after_decibel(unit).is_some();
        let decoded = value_unit.decode().ok();
        let decoded = decoded.filter(|_| in_file.is_none_or(is_known));
        let decoded = decoded.ok_or_else(|| {
            let rule = "write m/N, m/s/N, m/s2/N or the like, or for a modulus \"dB re 1 m/N\"";
            wrong(layout, column, rule)
        })?;
        let to_radians = match values {
            Parts::Cartesian(_) | Parts::Complex(_) => 1.0,
            Parts::Polar([_, phase]) => match unit(layout, phase).and_then(angle) {
                Some(AngleUnit::Degrees) => PI / 180.0,
                Some(AngleUnit::Radians) => 1.0,
                None => {
                    let name = &layout.names[phase];
                    let message =
                        format!("has column `{name}` without its unit: write `{name} [deg]` or `{name} [rad]`");
                    return Err(MeasurementError::file(message));
                }
            },
        };
        Ok(Self { decoded, to_radians })
    }

    fn value(&self, row: &Row<'_>, values: Parts) -> Result<Complex64, MeasurementError> {
        match values {
            Parts::Cartesian([real, imaginary]) => {
                let value = Complex64::new(row.number(real)?, row.number(imaginary)?);
                Ok(self.decoded.linear() * value)
            }
            Parts::Complex(column) => Ok(self.decoded.linear() * row.complex(column)?),
            Parts::Polar([modulus, phase]) => {
                let (size, angle) = (row.number(modulus)?, row.number(phase)?);
                let size = self
                    .decoded
                    .modulus(size)
                    .ok_or_else(|| row.wrong(modulus, &format!("is {size}, but a modulus is not negative")))?;
                Ok(Complex64::from_polar(size, self.to_radians * angle))
            }
        }
    }
}
