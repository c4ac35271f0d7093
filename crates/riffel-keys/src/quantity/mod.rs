//! Physical quantities in files of keys: a bare number in SI or a string with its unit.

mod dimension;
mod error;
mod kind;
mod name;
mod written;

use std::borrow::Cow;
use std::cell::RefCell;
use std::fmt;
use std::marker::PhantomData;
use std::str::FromStr;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

use crate::message::{self, Value};

pub use dimension::*;
pub use error::QuantityError;
pub use kind::Kind;
pub use name::named;
pub(crate) use written::WrittenQuantity;

/// A quantity of the dimension `D`, held in SI.
pub struct Quantity<D> {
    si: f64,
    dimension: PhantomData<fn() -> D>,
}

/// In its SI unit.
impl<D: Dimension> From<Quantity<D>> for Value {
    fn from(value: Quantity<D>) -> Self {
        Self::from(&value)
    }
}

/// In its SI unit.
impl<D: Dimension> From<&Quantity<D>> for Value {
    fn from(value: &Quantity<D>) -> Self {
        message::quantity(value.si(), D::UNIT, value)
    }
}

impl<D> Clone for Quantity<D> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<D> Copy for Quantity<D> {}

impl<D> PartialEq for Quantity<D> {
    fn eq(&self, other: &Self) -> bool {
        self.si == other.si
    }
}

impl<D: Dimension> fmt::Debug for Quantity<D> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl<D: Dimension> Quantity<D> {
    /// A quantity of the given SI value.
    pub const fn new(si: f64) -> Self {
        Self { si, dimension: PhantomData }
    }

    /// Value in SI units.
    pub const fn si(&self) -> f64 {
        self.si
    }
}

impl<D: Dimension> FromStr for Quantity<D> {
    type Err = QuantityError;

    fn from_str(text: &str) -> Result<Self, QuantityError> {
        Kind::of::<D>().read(text).map(Self::new)
    }
}

impl<D: Dimension> fmt::Display for Quantity<D> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.si.abs();
        if size > 0.0 && !(1e-3..1e6).contains(&size) {
            write!(f, "{:e}", self.si)?;
        } else {
            write!(f, "{}", self.si)?;
        }
        if D::UNIT.is_empty() {
            return Ok(());
        }
        write!(f, " {}", D::UNIT)
    }
}

impl<D: Dimension> Serialize for Quantity<D> {
    /// A ratio as a number, anything else as a string with its SI unit, which reads back.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if D::UNIT.is_empty() { serializer.serialize_f64(self.si) } else { serializer.collect_str(self) }
    }
}

thread_local! {
    /// The last quantity that was refused while a file was read: errors of serde are text.
    static REFUSED: RefCell<Option<QuantityError>> = const { RefCell::new(None) };
}

fn refused<E: de::Error>(error: QuantityError) -> E {
    let text = E::custom(&error);
    REFUSED.replace(Some(error));
    text
}

/// What an error of serde is about, if it is about a quantity.
pub(crate) fn refused_as(text: &str) -> Option<QuantityError> {
    let last = REFUSED.take();
    last.filter(|error| error.to_string() == text)
}

impl<'de, D: Dimension> Deserialize<'de> for Quantity<D> {
    fn deserialize<T: Deserializer<'de>>(deserializer: T) -> Result<Self, T::Error> {
        struct Visitor<D>(PhantomData<fn() -> D>);

        impl<D: Dimension> de::Visitor<'_> for Visitor<D> {
            type Value = Quantity<D>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, "{}", Kind::of::<D>().expected())
            }

            fn visit_f64<E: de::Error>(self, value: f64) -> Result<Self::Value, E> {
                Kind::of::<D>().finite(value, &value.to_string()).map(Quantity::new).map_err(refused)
            }

            fn visit_i64<E: de::Error>(self, value: i64) -> Result<Self::Value, E> {
                self.visit_f64(value as f64)
            }

            fn visit_u64<E: de::Error>(self, value: u64) -> Result<Self::Value, E> {
                self.visit_f64(value as f64)
            }

            fn visit_str<E: de::Error>(self, text: &str) -> Result<Self::Value, E> {
                text.parse().map_err(refused)
            }
        }

        deserializer.deserialize_any(Visitor(PhantomData))
    }
}

impl<D: Dimension> JsonSchema for Quantity<D> {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        Cow::Borrowed(D::NAME)
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "type": ["number", "string"],
            "pattern": r"^\s*[+-]?[0-9.]+([eE][+-]?[0-9]+)?\s*[^0-9]*.*$",
            "unit": D::UNIT,
            "examples": [D::EXAMPLE],
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::unit::Unit;

    fn si<D: Dimension>(text: &str) -> Result<f64, String> {
        text.parse::<Quantity<D>>().map(|quantity| quantity.si()).map_err(|error| error.to_string())
    }

    #[test]
    fn reads_what_engineers_write() {
        assert_eq!(si::<Force>("50 kN"), Ok(50e3));
        assert_eq!(si::<Force>("50kN"), Ok(50e3));
        assert_eq!(si::<Force>("5e4"), Ok(50e3));
        assert_eq!(si::<Speed>(" 90 km/h "), Ok(25.0));
        assert_eq!(si::<Ratio>("0.4 %"), Ok(0.004));
        assert_eq!(si::<Length>("5e3 m"), Ok(5000.0));
    }

    #[test]
    fn reads_angles_and_spins() {
        assert_eq!(si::<Angle>("180 deg"), Ok(std::f64::consts::PI));
        assert_eq!(si::<Angle>("90°"), Ok(std::f64::consts::FRAC_PI_2));
        assert_eq!(si::<Angle>("50 mrad"), Ok(0.05));
        assert_eq!(si::<Spin>("0.3 1/m"), Ok(0.3));
        assert_eq!(si::<Spin>("-0.3 rad/m"), Ok(-0.3));
        assert_eq!(si::<Ratio>("20 deg").unwrap_err(), "\"20 deg\" is in rad, not a ratio; write it as in \"0.4 %\"");
        assert_eq!(
            si::<Angle>("3 %").unwrap_err(),
            "\"3 %\" is a plain number, not an angle in rad; write it as in \"3 deg\""
        );
        assert!(si::<Spin>("0,3 1/m").unwrap_err().contains("a comma"));
    }

    #[test]
    fn refuses_with_a_sentence() {
        for (text, sentence) in [
            ("280 kg", "\"280 kg\" is in kg, not a stiffness in N/m; write it as in \"280 MN/m\""),
            ("280 MM/m", "unknown unit \"MM\" in \"280 MM/m\"; write a stiffness as in \"280 MN/m\""),
            ("stiff", "\"stiff\" does not begin with a number; write a stiffness as in \"280 MN/m\""),
            ("inf", "inf is not finite, as a stiffness must be"),
            ("1e400 N/m", "1e400 N/m is not finite, as a stiffness must be"),
            (
                "0,4 MN/m",
                "\"0,4 MN/m\" has a comma or a gap in its number; write a decimal point and no separators of thousands, \
         as in \"280 MN/m\" for a stiffness",
            ),
            (
                "280 000 000 N/m",
                "\"280 000 000 N/m\" has a comma or a gap in its number; write a decimal point and no separators of \
         thousands, as in \"280 MN/m\" for a stiffness",
            ),
            (
                "100-280 MN/m",
                "\"100-280 MN/m\" is a range, but one value is needed; write a stiffness as in \"280 MN/m\"",
            ),
        ] {
            assert_eq!(si::<Stiffness>(text), Err(sentence.to_owned()));
        }
    }

    /// The example of every dimension reads as that dimension, and what is written reads back.
    #[test]
    fn examples_read() {
        fn check<D: Dimension>() -> Kind {
            let quantity: Quantity<D> = D::EXAMPLE.parse().unwrap();
            assert!(Unit::parse(D::UNIT).is_ok());
            assert_eq!(quantity.to_string().parse::<Quantity<D>>().unwrap(), quantity);
            // As engineers write it, the same again.
            let (number, unit) = Kind::of::<D>().in_engineers_unit(quantity.si());
            let again: Quantity<D> = format!("{number} {unit}").parse().unwrap();
            assert!((again.si() / quantity.si() - 1.0).abs() < 4.0 * f64::EPSILON);
            Kind::of::<D>()
        }
        assert_eq!(Kind::of::<Force>().in_engineers_unit(5e4), (50.0, "kN"));
        assert_eq!(Kind::of::<Ratio>().in_engineers_unit(0.4), (0.4, ""));
        let checked = [
            check::<Ratio>(),
            check::<Length>(),
            check::<Speed>(),
            check::<Frequency>(),
            check::<Mass>(),
            check::<Force>(),
            check::<Moment>(),
            check::<Inertia>(),
            check::<Modulus>(),
            check::<Area>(),
            check::<SecondMoment>(),
            check::<MassPerLength>(),
            check::<Stiffness>(),
            check::<TorsionalStiffness>(),
            check::<TorsionalDamping>(),
            check::<Damping>(),
            check::<DampingPerLength>(),
            check::<Density>(),
            check::<WearCoefficient>(),
            check::<Angle>(),
            check::<Spin>(),
            check::<RelativeSlope>(),
            check::<WarpingConstant>(),
            check::<LengthPerForce>(),
            check::<VelocityDecay>(),
        ];
        assert_eq!(checked, KINDS);
    }
}
