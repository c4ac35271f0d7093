//! What a user says of how a record is laid out.

use std::fmt;
use std::str::FromStr;

use super::format::{Column, ReaderFormat};
use crate::quantity::{Length, Quantity};
use crate::unit::{Exponents, Unit};

/// How to read records; what is left out is found from their first lines.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Layout {
    /// The reader profile.
    pub format: Option<ReaderFormat>,
    /// Step between samples of a file without positions.
    pub spacing: Option<Quantity<Length>>,
    /// Unit of the heights, whatever the file or the reader profile says.
    pub height_unit: Option<LengthUnit>,
    /// Unit of the positions, whatever the file or the reader profile says.
    pub position_unit: Option<LengthUnit>,
}

impl Layout {
    /// The reader profile with what was said besides it.
    pub(super) fn apply(&self, format: &ReaderFormat) -> ReaderFormat {
        let mut format = format.clone();
        if format.position.is_none() && self.spacing.is_some() {
            format.spacing = self.spacing;
        }
        let set = |column: &mut Column, unit: &Option<LengthUnit>| {
            if let Some(unit) = unit {
                column.unit.clone_from(&unit.0);
            }
        };
        for rail in &mut format.rails {
            set(rail, &self.height_unit);
        }
        if let Some(position) = &mut format.position {
            set(position, &self.position_unit);
        }
        format
    }
}

/// A unit of length, as in mm or um.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LengthUnit(String);

impl FromStr for LengthUnit {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let text = text.trim();
        if metres(text).is_some() {
            Ok(Self(text.to_owned()))
        } else {
            Err(format!(
                "\"{text}\" is no unit of length; write m, mm, um or km"
            ))
        }
    }
}

impl fmt::Display for LengthUnit {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.0)
    }
}

/// Size of a unit in metres; None if it is no length.
pub(super) fn metres(unit: &str) -> Option<f64> {
    let unit = Unit::parse(unit).ok()?;
    (unit.exponents == Exponents::new(0, 1, 0)).then_some(unit.factor)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_lengths_are_units_of_heights() {
        for unit in ["mm", "um", "µm", "m", "km"] {
            assert!(unit.parse::<LengthUnit>().is_ok(), "{unit}");
        }
        for unit in ["kg", "", "mm/s", "5 mm"] {
            assert!(unit.parse::<LengthUnit>().is_err(), "{unit}");
        }
    }
}
