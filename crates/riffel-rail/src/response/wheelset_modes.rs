//! Modes of a wheelset in a table of text.

use std::f64::consts::TAU;
use std::path::Path;

use riffel::wheelset::{ElasticMode, ModalWheelset, RigidWheelset};
use riffel_keys::table::it_has;
use riffel_keys::{Exponents, Unit};

use super::columns::{unit_in_name, without_unit};
use super::layout::{Layout, Row, find, rows};
use super::table::hertz_of;
use super::{MeasurementError, bytes_of, decoded};

/// The shape, in the order of [`riffel::wheelset::Port::ALL`].
const SHAPE: [&str; 6] = ["left_x", "left_y", "left_z", "right_x", "right_y", "right_z"];

/// Names of the other columns; the first of each is told of where it is missing.
const FREQUENCY: [&str; 3] = ["frequency", "natural_frequency", "eigenfrequency"];
const DAMPING_RATIO: [&str; 4] = ["damping_ratio", "damping", "zeta", "ζ"];
const GENERALISED_MASS: [&str; 3] = ["generalised_mass", "generalized_mass", "modal_mass"];

/// What stands in place of a frequency in a row of the residual compliance.
const RESIDUAL: &str = "residual";

/// Modes as they stand in a file, in SI.
pub struct WheelsetModes {
    modes: Vec<ElasticMode>,
    /// Where each mode stands, as "line 12".
    places: Vec<String>,
    /// Rows of the residual compliance \[m/N\].
    residual: Vec<[f64; 6]>,
    /// Where each of them stands.
    residual_places: Vec<String>,
}

impl WheelsetModes {
    /// The file at the path.
    ///
    /// # Errors
    /// [`MeasurementError`] for a file that cannot be read or is no table of modes.
    pub fn read(path: &Path) -> Result<Self, MeasurementError> {
        Self::parse(&decoded(bytes_of(path, "table of modes")?)?)
    }

    pub(super) fn parse(text: &str) -> Result<Self, MeasurementError> {
        let example = "frequency_hz,damping_ratio,generalised_mass_kg,left_x,left_y,left_z,right_x,right_y,right_z";
        let layout = find(text, example, ModeColumns::find, ModeColumns::numbers)?;
        let units = Units::of(&layout)?;
        let mut read =
            Self { modes: Vec::new(), places: Vec::new(), residual: Vec::new(), residual_places: Vec::new() };
        let columns = &layout.columns;
        for row in rows(&layout) {
            let row = row?;
            if row.text(columns.frequency).eq_ignore_ascii_case(RESIDUAL) {
                read.residual.push(shape(&row, columns, 1.0)?);
                read.residual_places.push(row.place);
                continue;
            }
            read.modes.push(ElasticMode {
                angular_frequency: TAU * units.to_hertz * row.number(columns.frequency)?,
                damping_ratio: units.to_ratio * row.number(columns.damping_ratio)?,
                generalised_mass: match columns.generalised_mass {
                    Some(column) => units.to_kilograms * row.number(column)?,
                    None => 1.0,
                },
                shape: shape(&row, columns, units.of_shape)?,
            });
            read.places.push(row.place);
        }
        if read.modes.is_empty() {
            return Err(MeasurementError::file("has no mode below its header"));
        }
        if !matches!(read.residual.len(), 0 | 1 | 6) {
            return Err(MeasurementError::file(format!(
                "has {} rows `{RESIDUAL}`: give one, the compliance of each contact along each axis by itself, or six, \
                 the whole matrix from left_x to right_z",
                read.residual.len()
            )));
        }
        Ok(read)
    }

    /// The wheelset of these modes over its motion as a rigid body.
    ///
    /// # Errors
    /// [`MeasurementError`] with the line of a mode that no wheelset has.
    pub fn wheelset(self, rigid: RigidWheelset) -> Result<ModalWheelset, MeasurementError> {
        let wheelset = ModalWheelset::new(Some(rigid), self.modes);
        let wheelset = wheelset.map_err(|error| at(&self.places, error))?;
        let matrix = match self.residual[..] {
            [] => return Ok(wheelset),
            [diagonal] => std::array::from_fn(|row| {
                let mut entries = [0.0; 6];
                entries[row] = diagonal[row];
                entries
            }),
            _ => std::array::from_fn(|row| self.residual[row]),
        };
        let residual = wheelset.with_residual(matrix);
        residual.map_err(|error| at(&self.residual_places, error))
    }
}

/// An error of the physics, at the line of the value that causes it.
fn at(places: &[String], error: riffel::Error) -> MeasurementError {
    if let riffel::Error::Measurement { index, rule } = error
        && let Some(place) = places.get(index)
    {
        return MeasurementError::file(format!("{place}: {rule}"));
    }
    MeasurementError::file(error.to_string())
}

fn shape(row: &Row<'_>, columns: &ModeColumns, unit: f64) -> Result<[f64; 6], MeasurementError> {
    let mut shape = [0.0; 6];
    for (value, &column) in shape.iter_mut().zip(&columns.shape) {
        *value = unit * row.number(column)?;
    }
    Ok(shape)
}

/// Which column of a table of modes holds what.
struct ModeColumns {
    frequency: usize,
    damping_ratio: usize,
    generalised_mass: Option<usize>,
    shape: [usize; 6],
}

impl ModeColumns {
    fn find(header: &[String]) -> Result<Self, MeasurementError> {
        let need = |names: &[&str]| {
            told(header, names)?
                .ok_or_else(|| MeasurementError::file(format!("has no column `{}`; {}", names[0], it_has(header))))
        };
        let mut shape = [0; 6];
        for (column, name) in shape.iter_mut().zip(SHAPE) {
            *column = need(&[name])?;
        }
        Ok(Self {
            frequency: need(&FREQUENCY)?,
            damping_ratio: need(&DAMPING_RATIO)?,
            generalised_mass: told(header, &GENERALISED_MASS)?,
            shape,
        })
    }
}

impl ModeColumns {
    /// All columns.
    fn numbers(&self) -> Vec<usize> {
        let mut columns = self.shape.to_vec();
        columns.extend([self.frequency, self.damping_ratio]);
        columns.extend(self.generalised_mass);
        columns
    }
}

/// The one column with one of the names, whatever its unit.
fn told(header: &[String], names: &[&str]) -> Result<Option<usize>, MeasurementError> {
    let is = |name: &String| names.iter().any(|known| behind(name, known).is_some());
    let mut columns = (0..header.len()).filter(|&column| is(&header[column]));
    match (columns.next(), columns.next()) {
        (Some(first), Some(second)) => Err(MeasurementError::file(format!(
            "has two columns for `{}`: `{}`, `{}`",
            names[0], header[first], header[second]
        ))),
        (first, _) => Ok(first),
    }
}

/// What follows the name of a quantity in that of a column, without its underscore: the unit in `left_x_per_sqrt_kg`.
fn behind(column: &str, name: &str) -> Option<String> {
    let own = without_unit(column).trim().to_lowercase().replace([' ', '-'], "_");
    let rest = own.strip_prefix(name)?;
    match rest.strip_prefix('_') {
        Some(unit) => Some(unit.to_owned()),
        None => rest.is_empty().then(String::new),
    }
}

/// What makes SI of the numbers.
struct Units {
    to_hertz: f64,
    to_ratio: f64,
    to_kilograms: f64,
    of_shape: f64,
}

impl Units {
    fn of(layout: &Layout<'_, ModeColumns>) -> Result<Self, MeasurementError> {
        let ModeColumns { frequency, damping_ratio, generalised_mass, shape } = layout.columns;
        let unit = |column: usize| unit_of(layout, column);
        let wrong = |column: usize, rule: &str| {
            let (name, unit) = (&layout.names[column], unit(column));
            MeasurementError::file(format!("has column `{name}` in \"{unit}\": {rule}"))
        };
        let to_hertz = match &unit(frequency)[..] {
            "" => 1.0,
            unit => hertz_of(unit).ok_or_else(|| wrong(frequency, "write a unit of a frequency, Hz, kHz or rad/s"))?,
        };
        let to_ratio = match &unit(damping_ratio)[..] {
            "" | "-" | "1" => 1.0,
            "%" | "percent" => 0.01,
            _ => {
                let rule = "a damping ratio has none, or %";
                return Err(wrong(damping_ratio, rule));
            }
        };
        let to_kilograms = match generalised_mass {
            None => 1.0,
            Some(column) => match &unit(column)[..] {
                "" => 1.0,
                unit => kilograms(unit).ok_or_else(|| wrong(column, "write a unit of a mass, kg or t"))?,
            },
        };
        let plain = |column: usize| matches!(&unit(column)[..], "" | "-" | "1");
        let of_shape = match generalised_mass {
            Some(mass) => {
                if let Some(&column) = shape.iter().find(|&&column| !plain(column)) {
                    let mass = &layout.names[mass];
                    let rule = format!(
                        "beside `{mass}` a shape has no unit; leave that column out if the shapes are mass-normalised"
                    );
                    return Err(wrong(column, &rule));
                }
                1.0
            }
            None => {
                if let Some(&column) = shape.iter().find(|&&column| plain(column)) {
                    return Err(MeasurementError::file(format!(
                        "does not say how its shapes are normalised: give a column `generalised_mass_kg`, or, if they \
                         are mass-normalised, their unit, as in `{} [1/√kg]`",
                        without_unit(&layout.names[column]).trim()
                    )));
                }
                let factors = shape.map(|column| per_root_of_mass(&unit(column)));
                let Some(first) = factors[0] else {
                    return Err(wrong(shape[0], "a mass-normalised shape is in 1/√kg or 1/√t"));
                };
                if let Some(other) = factors.iter().position(|&factor| factor != Some(first)) {
                    let rule = format!("all shapes have one unit, that of `{}`", layout.names[shape[0]]);
                    return Err(wrong(shape[other], &rule));
                }
                first
            }
        };
        Ok(Self { to_hertz, to_ratio, to_kilograms, of_shape })
    }
}

/// The unit of a column: in the row of units, in brackets, or behind its name; empty where there is none.
fn unit_of(layout: &Layout<'_, ModeColumns>, column: usize) -> String {
    let name = &layout.names[column];
    let written = layout.unit_below(column).or_else(|| unit_in_name(name));
    if let Some(unit) = written {
        return unit.to_owned();
    }
    let names = SHAPE.iter().chain(&FREQUENCY);
    let names = names.chain(&DAMPING_RATIO).chain(&GENERALISED_MASS);
    names.filter_map(|known| behind(name, known)).min_by_key(String::len).unwrap_or_default()
}

/// Kilograms in a unit of mass.
fn kilograms(unit: &str) -> Option<f64> {
    Unit::parse(unit).ok().filter(|unit| unit.exponents == Exponents::new(1, 0, 0)).map(|unit| unit.factor)
}

/// 1/√kg in a unit such as "1/√kg", "1/sqrt(t)", "kg^-0.5" or "per_sqrt_kg".
fn per_root_of_mass(unit: &str) -> Option<f64> {
    let plain: String = unit.chars().filter(|c| !c.is_whitespace() && !matches!(c, '(' | ')' | '^')).collect();
    let ends = ["-0.5", "-1/2"].into_iter();
    let mass = ["1/√", "1/sqrt", "per_sqrt_"]
        .into_iter()
        .find_map(|start| plain.strip_prefix(start))
        .or_else(|| ends.into_iter().find_map(|end| plain.strip_suffix(end)))?;
    kilograms(mass).map(|mass| mass.powf(-0.5))
}
