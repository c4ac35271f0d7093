//! A point in the rail under a contact.

use std::str::FromStr;

use super::number::plain_number;

/// x/a, y/b and z/a.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PointInRail(pub(crate) [f64; 3]);

impl FromStr for PointInRail {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers = text.split(',').map(plain_number);
        let numbers: Vec<f64> = numbers.collect::<Result<_, _>>()?;
        match <[f64; 3]>::try_from(numbers) {
            Ok(place) if place[2] >= 0.0 => Ok(Self(place)),
            Ok(_) => Err(format!("\"{text}\" lies above the rail; z/a is zero at its surface and above zero in it")),
            Err(_) => Err(format!("\"{text}\" is not a point; write x/a, y/b and z/a, as in -0.8,0,0.1")),
        }
    }
}
