//! Universal files: the functions at nodal degrees of freedom (dataset 58) that modal test systems
//! write, as text (58) and in the binary form (58b), with the units of the file (dataset 164).
//!
//! The format is one of punched cards. A dataset stands between two lines with -1 in columns 5 and 6
//! and begins with its number. Its records are lines of fields with fixed columns, which may touch,
//! so that nothing is ever split at blanks. Datasets other than 58 and 164 are skipped.

mod ascii;
mod binary;
mod error;
mod fields;
mod form;
mod lines;
mod signal;

use binary::Encoding;
use riffel::{Complex64, STANDARD_GRAVITY};

use crate::{Exponents, Unit};
pub use error::UniversalFileError;
use fields::Fields;
use form::Form;
use lines::Lines;
pub use signal::{Signal, SignalError, Signals, Values};

/// Kind of an axis: a displacement.
pub const DISPLACEMENT: i32 = 8;
/// Kind of an axis: a velocity.
pub const VELOCITY: i32 = 11;
/// Kind of an axis: an acceleration.
pub const ACCELERATION: i32 = 12;
/// Kind of an axis: time.
pub const TIME: i32 = 17;

/// What a universal file says that is of use here.
#[derive(Debug, Clone, PartialEq)]
pub struct UniversalFile {
    /// The functions in the order of the file.
    pub functions: Vec<Function>,
    /// Its units, if it states them.
    pub units: Option<Units>,
}

/// How many of the file's units make one unit of SI: a value of the file is divided by the factor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Units {
    /// Units of length in a metre.
    pub length: f64,
    /// Units of force in a newton.
    pub force: f64,
    /// Units of temperature in a kelvin.
    pub temperature: f64,
    /// What the file's temperature scale is off the absolute one.
    pub temperature_offset: f64,
}

/// One function of a universal file, in the units of the file.
#[derive(Debug, Clone, PartialEq)]
pub struct Function {
    /// Line with the mark that opens its dataset, from 1; a binary part counts as one line.
    pub line: usize,
    /// First of the five lines of description.
    pub title: String,
    /// Kind of function: 4 for a frequency response.
    pub function_type: i32,
    /// Load case; the reference means something only if this is 0, an excitation at one point.
    pub load_case: i32,
    /// Where the response was observed.
    pub response: Freedom,
    /// Where the excitation acted.
    pub reference: Freedom,
    /// What the abscissa is.
    pub abscissa_axis: Axis,
    /// What the ordinate is, or the numerator of it.
    pub numerator: Axis,
    /// What the ordinate is divided by; of kind 0 if by nothing.
    pub denominator: Axis,
    /// Whether the ordinate is complex in the file.
    pub complex: bool,
    /// Values of the abscissa.
    pub abscissa: Vec<f64>,
    /// Value of the ordinate at each one of the abscissa; real ones have no imaginary part.
    pub ordinate: Vec<Complex64>,
}

/// A degree of freedom of the tested structure.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Freedom {
    /// Part of the structure, "NONE" if unnamed.
    pub entity: String,
    /// Node of the part.
    pub node: i32,
    /// 1 to 3 along x, y, z, 4 to 6 about them, negative in the other sense, 0 for a scalar.
    pub direction: i32,
}

/// What one axis of a function measures.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Axis {
    /// Kind of quantity: 8 displacement, 9 reaction force, 11 velocity, 12 acceleration,
    /// 13 excitation force, 18 frequency; 0 unknown, 1 given by the exponents alone.
    pub kind: i32,
    /// Exponent of length; the three say something only for kind 1 and for scalars.
    pub length: i32,
    /// Exponent of force.
    pub force: i32,
    /// Exponent of temperature.
    pub temperature: i32,
    /// Name of the axis, "NONE" if unnamed.
    pub label: String,
    /// Its unit as text, "NONE" if unnamed.
    pub unit: String,
}

/// Read a universal file.
pub fn read(bytes: &[u8]) -> Result<UniversalFile, UniversalFileError> {
    let mut lines = Lines::new(bytes);
    let mut file = UniversalFile { functions: Vec::new(), units: None };
    let mut empty = true;
    while lines.open()? {
        empty = false;
        read_dataset(&mut lines, &mut file)?;
    }
    if empty {
        return Err(UniversalFileError::NoDataset);
    }
    Ok(file)
}

/// Read or skip the dataset of which the opening mark has been taken.
fn read_dataset(lines: &mut Lines, file: &mut UniversalFile) -> Result<(), UniversalFileError> {
    let name = lines.record("number")?;
    let mut fields = name.fields();
    let number = fields.integer(6, "the number of the dataset")?;
    let letter = fields.text(1);
    match (number, letter) {
        (..=0, _) => Err(UniversalFileError::NotPositive {
            line: name.number,
            what: "the number of the dataset",
            value: number.into(),
        }),
        (58, "") => {
            file.functions.push(Function::read(lines, None)?);
            Ok(())
        }
        (58, "b" | "B") => {
            let encoding = Encoding::read(fields)?;
            file.functions.push(Function::read(lines, Some(&encoding))?);
            Ok(())
        }
        (164, "") => file.set_units(Units::read(lines)?, name.number),
        (_, "") => lines.skip(),
        _ => Err(UniversalFileError::UnknownForm { line: name.number, text: letter.to_owned() }),
    }
}

impl UniversalFile {
    /// Units hold for the whole file, so that it may repeat but not change them.
    fn set_units(&mut self, units: Units, line: usize) -> Result<(), UniversalFileError> {
        if self.units.replace(units).is_some_and(|old| old != units) {
            return Err(UniversalFileError::OtherUnits { line });
        }
        Ok(())
    }
}

impl Units {
    fn read(lines: &mut Lines) -> Result<Self, UniversalFileError> {
        const WIDTH: usize = 25;
        // The code of the system of units is left aside: the factors alone decide.
        lines.record("record 1")?;
        let line = lines.record("record 2")?;
        let mut fields = line.fields();
        let mut factor = |what| match fields.number(WIDTH, what)? {
            value if value > 0.0 => Ok(value),
            value => Err(UniversalFileError::NotPositive { line: line.number, what, value }),
        };
        let (length, force, temperature) =
            (factor("the factor of length")?, factor("the factor of force")?, factor("the factor of temperature")?);
        let offset = lines.record("temperature offset")?;
        let units = Self {
            length,
            force,
            temperature,
            temperature_offset: offset.fields().number(WIDTH, "the temperature offset")?,
        };
        lines.skip()?;
        Ok(units)
    }
}

impl Function {
    /// Read the dataset after its number, with its closing mark.
    fn read(lines: &mut Lines, encoding: Option<&Encoding>) -> Result<Self, UniversalFileError> {
        let (mut function, form) = Self::read_head(lines)?;
        let numbers = match encoding {
            Some(encoding) => encoding.numbers(lines, &form)?,
            None => ascii::numbers(lines, &form)?,
        };
        (function.abscissa, function.ordinate) = form.points_of(&numbers);
        Ok(function)
    }

    /// Read the eleven records before the values; the function has none yet.
    fn read_head(lines: &mut Lines) -> Result<(Self, Form), UniversalFileError> {
        let line = lines.opening();
        let title = lines.record("record 1")?.text.trim().to_owned();
        for name in ["record 2", "record 3", "record 4", "record 5"] {
            lines.record(name)?;
        }
        let freedoms = lines.record("record 6")?;
        let mut fields = freedoms.fields();
        let function_type = fields.integer(5, "the type of the function")?;
        fields.integer(10, "the number of the function")?;
        fields.integer(5, "the version of the function")?;
        let load_case = fields.integer(10, "the load case")?;
        let response = Freedom::read(&mut fields)?;
        let reference = Freedom::read(&mut fields)?;
        let form = Form::read(lines.record("record 7")?.fields())?;
        let abscissa_axis = Axis::read(lines.record("record 8")?.fields())?;
        let numerator = Axis::read(lines.record("record 9")?.fields())?;
        let denominator = Axis::read(lines.record("record 10")?.fields())?;
        // The axis of a third dimension, which one function does not have.
        lines.record("record 11")?;
        let function = Self {
            line,
            title,
            function_type,
            load_case,
            response,
            reference,
            abscissa_axis,
            numerator,
            denominator,
            complex: form.complex,
            abscissa: Vec::new(),
            ordinate: Vec::new(),
        };
        Ok((function, form))
    }
}

impl Freedom {
    fn read(fields: &mut Fields) -> Result<Self, UniversalFileError> {
        // A name too long for its field shifts the numbers after it, where they may still read.
        fields.gap()?;
        Ok(Self {
            entity: fields.text(10).to_owned(),
            node: fields.integer(10, "the node")?,
            direction: fields.integer(4, "the direction")?,
        })
    }
}

impl Axis {
    fn read(mut fields: Fields) -> Result<Self, UniversalFileError> {
        Ok(Self {
            kind: fields.integer(10, "the kind of quantity")?,
            length: fields.integer(5, "the exponent of length")?,
            force: fields.integer(5, "the exponent of force")?,
            temperature: fields.integer(5, "the exponent of temperature")?,
            // Each label is preceded by one blank column.
            label: fields.text(21).to_owned(),
            unit: fields.text(21).to_owned(),
        })
    }
}

/// SI units in one unit of an axis: by its label, or by the units of the file where it has none. `None` if the label does
/// not fit the dimensions, which are those of `exponents`; `per_si` is how many of the file's units make one of SI.
pub fn unit_size(axis: &Axis, exponents: Exponents, per_si: f64) -> Option<f64> {
    if !axis.has_unit() {
        return Some(per_si.recip());
    }
    let label = axis.unit.trim();
    // Of an acceleration, "g" is no gram.
    if label == "g" && exponents == Exponents::new(0, 1, -2) {
        return Some(STANDARD_GRAVITY);
    }
    let unit = Unit::parse(label).ok()?;
    (unit.exponents == exponents).then_some(unit.factor)
}

impl Axis {
    /// Whether its unit is named.
    pub fn has_unit(&self) -> bool {
        let label = self.unit.trim();
        !label.is_empty() && !label.eq_ignore_ascii_case("none")
    }
}

#[cfg(test)]
mod tests;
