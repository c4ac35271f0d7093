//! A point in the rail under a contact.

use schemars::JsonSchema;
use serde::Deserialize;

/// x/a, y/b and z/a.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(try_from = "String")]
#[schemars(with = "String", inline)]
pub(crate) struct PointInRail(pub(crate) [f64; 3]);

impl TryFrom<String> for PointInRail {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        let number = |text: &str| match text.trim().parse() {
            Ok(number) if f64::is_finite(number) => Ok(number),
            _ => Err(format!(
                "\"{text}\" is not a number; write digits with a decimal point and no separators of thousands, as in 2500000 or 2.5e6"
            )),
        };
        let numbers: Vec<f64> = text.split(',').map(number).collect::<Result<_, _>>()?;
        match <[f64; 3]>::try_from(numbers) {
            Ok(place) if place[2] >= 0.0 => Ok(Self(place)),
            Ok(_) => Err(format!("\"{text}\" lies above the rail; z/a is zero at its surface and above zero in it")),
            Err(_) => Err(format!("\"{text}\" is not a point; write x/a, y/b and z/a, as in -0.8,0,0.1")),
        }
    }
}
