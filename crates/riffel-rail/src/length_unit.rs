//! Units of heights and positions.

use std::fmt;
use std::str::FromStr;

use riffel_keys::{Exponents, Unit};
use serde::{Deserialize, Deserializer, de};

/// A unit of length, as in mm or um.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LengthUnit(pub(super) String);

impl FromStr for LengthUnit {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let text = text.trim();
        if metres(text).is_some() {
            Ok(Self(text.to_owned()))
        } else {
            Err(format!("\"{text}\" is no unit of length; write m, mm, um or km"))
        }
    }
}

impl<'de> Deserialize<'de> for LengthUnit {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        String::deserialize(deserializer)?.parse().map_err(de::Error::custom)
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
