//! Physical quantities of the case file: a bare number in SI or a string with its unit.

use std::borrow::Cow;
use std::fmt;
use std::marker::PhantomData;
use std::str::FromStr;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Deserializer, Serialize, Serializer, de};
use thiserror::Error;

use crate::unit::{Exponents, Unit};

/// What a quantity measures.
pub trait Dimension {
    /// In the field's words, with its article: "a stiffness".
    const NAME: &'static str;
    /// SI unit, empty for a ratio.
    const UNIT: &'static str;
    /// What one writes in a case file.
    const EXAMPLE: &'static str;
}

/// A dimension where only the key of the case file tells which.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Kind {
    /// In the field's words, with its article: "a stiffness".
    pub name: &'static str,
    /// SI unit, empty for a ratio.
    pub unit: &'static str,
    /// What one writes in a case file.
    pub example: &'static str,
}

impl Kind {
    /// The words of a dimension.
    pub const fn of<D: Dimension>() -> Self {
        Self {
            name: D::NAME,
            unit: D::UNIT,
            example: D::EXAMPLE,
        }
    }

    /// A number in SI in the unit in which engineers write it, and that unit: (50, "kN") for 50 000. A ratio stays
    /// as it is, without a unit.
    pub fn in_engineers_unit(&self, si: f64) -> (f64, &'static str) {
        let unit = self.example.split_once(' ').map_or("", |(_, unit)| unit);
        match Unit::parse(unit) {
            Ok(parsed) if !self.unit.is_empty() => (si / parsed.factor, unit),
            _ => (si, self.unit),
        }
    }

    /// Read a number in SI, or one with its unit.
    ///
    /// # Errors
    /// [`QuantityError`] for a text that is no quantity of this kind.
    pub fn read(&self, text: &str) -> Result<f64, QuantityError> {
        self.read_written(text).map(|written| written.si)
    }

    /// [`read`](Self::read), with number and unit as they were written.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub(crate) fn read_written(&self, text: &str) -> Result<Written, QuantityError> {
        self.read_one(text)
            .map_err(|error| match self.read_range(text) {
                Some(_) => QuantityError::Range {
                    text: text.to_owned(),
                    name: self.name,
                    example: self.example,
                },
                None => error,
            })
    }

    /// The lowest and the highest value of a range: `"60-90 km/h"`, `"60..90 km/h"`, `"0.02 to 0.08 m"`,
    /// `"5 m/s – 60 m/s"`. A unit at the end is that of both. None for a text that is no range of this kind.
    pub(crate) fn read_range(&self, text: &str) -> Option<[Written; 2]> {
        /// No range is longer; foreign data may be.
        const LONGEST: usize = 100;
        if text.len() > LONGEST {
            return None;
        }
        const MARKS: [&str; 8] = ["...", "..", "…", "–", "—", " to ", " bis ", "-"];
        let both = |low: &str, high: &str| {
            let (mut low, high) = (self.read_one(low).ok()?, self.read_one(high).ok()?);
            match (low.unit.is_empty(), high.unit.is_empty()) {
                (true, false) => {
                    low = self
                        .read_one(&format!("{} {}", low.number, high.unit))
                        .ok()?
                }
                // "5 m-1" is no range of 5 m to 1.
                (false, true) => return None,
                _ => {}
            }
            Some([low, high])
        };
        MARKS.iter().find_map(|mark| {
            text.match_indices(mark)
                .find_map(|(place, _)| both(&text[..place], &text[place + mark.len()..]))
        })
    }

    /// The ends of a range as [`read`](Self::read) takes them: "60 km/h" and "90 km/h" for "60-90 km/h".
    pub fn range_in_words(&self, text: &str) -> Option<[String; 2]> {
        let ends = self.read_range(text)?;
        Some(ends.map(|end| format!("{} {}", end.number, end.unit).trim_end().to_owned()))
    }

    fn read_one(&self, text: &str) -> Result<Written, QuantityError> {
        /// Characters of the largest number written out, and some to spare; foreign data may be longer.
        const LONGEST_NUMBER: usize = 400;
        let Self {
            name,
            unit,
            example,
        } = *self;
        let trimmed = text.trim();
        // The longest beginning that reads as a number: "5 km" must not lose "5e3 m".
        let number = (1..=trimmed.len().min(LONGEST_NUMBER))
            .rev()
            .filter(|&end| trimmed.is_char_boundary(end))
            .find_map(|end| Some((trimmed[..end].parse::<f64>().ok()?, &trimmed[end..])));
        let Some((number, rest)) = number else {
            return Err(QuantityError::NoNumber {
                text: text.to_owned(),
                name,
                example,
            });
        };
        // No unit begins with a digit: "50,000", "50 000", "50'000" and "50.000.000" are numbers with separators.
        let after = rest
            .trim_start()
            .trim_start_matches([',', '.', '\'', '’', '_', '\u{202f}']);
        if after.starts_with(|c: char| c.is_ascii_digit()) {
            return Err(QuantityError::Separator {
                text: text.to_owned(),
                name,
                example,
            });
        }
        let mut written = Written {
            number,
            unit: rest.trim().to_owned(),
            si: number,
        };
        if !written.unit.is_empty() {
            let read = Unit::parse(&written.unit).map_err(|unit| QuantityError::UnknownUnit {
                text: text.to_owned(),
                unit,
                name,
                example,
            })?;
            // The unit of a dimension is a constant that the tests read for every dimension.
            let own = Unit::parse(unit).map_or(Exponents::new(0, 0, 0), |unit| unit.exponents);
            if read.exponents != own {
                return Err(QuantityError::WrongUnit {
                    text: text.to_owned(),
                    got: read.exponents.to_string(),
                    name,
                    in_unit: match unit {
                        "" => String::new(),
                        unit => format!(" in {unit}"),
                    },
                    example,
                });
            }
            written.si = number * read.factor;
        }
        self.finite(written.si, trimmed)?;
        Ok(written)
    }

    fn finite(&self, si: f64, text: &str) -> Result<f64, QuantityError> {
        if si.is_finite() {
            return Ok(si);
        }
        Err(QuantityError::NotFinite {
            text: text.to_owned(),
            name: self.name,
        })
    }
}

/// A quantity as it was written.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Written {
    /// The number.
    pub(crate) number: f64,
    /// Its unit, empty for a bare number.
    pub(crate) unit: String,
    /// The value in SI.
    pub(crate) si: f64,
}

impl Written {
    /// A bare number in SI.
    pub(crate) fn bare(si: f64) -> Self {
        Self {
            number: si,
            unit: String::new(),
            si,
        }
    }

    /// Number and unit; a bare number with the unit in which it is read.
    pub(crate) fn in_words(&self, kind: &Kind) -> String {
        let unit = match self.unit.as_str() {
            "" => kind.unit,
            unit => unit,
        };
        match self.number.abs() {
            size if size != 0.0 && !(1e-6..1e12).contains(&size) => {
                format!("{:e} {unit}", self.number)
            }
            _ => format!("{} {unit}", self.number),
        }
        .trim_end()
        .to_owned()
    }
}

macro_rules! dimensions {
    ($($(#[$doc:meta])* $name:ident = $words:literal, $unit:literal, $example:literal;)*) => {$(
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub struct $name;

        impl Dimension for $name {
            const NAME: &'static str = $words;
            const UNIT: &'static str = $unit;
            const EXAMPLE: &'static str = $example;
        }
    )*
        /// Every kind of quantity of the case file.
        pub(crate) const KINDS: &[Kind] = &[$(Kind::of::<$name>()),*];
    };
}

dimensions! {
    /// Ratio, also in per cent.
    Ratio = "a ratio", "", "0.4 %";
    /// Length.
    Length = "a length", "m", "40 mm";
    /// Speed.
    Speed = "a speed", "m/s", "80 km/h";
    /// Frequency.
    Frequency = "a frequency", "Hz", "500 Hz";
    /// Mass.
    Mass = "a mass", "kg", "350 kg";
    /// Force.
    Force = "a force", "N", "50 kN";
    /// Moment of inertia.
    Inertia = "a moment of inertia", "kg m2", "27.77 kg m2";
    /// Elastic modulus.
    Modulus = "an elastic modulus", "Pa", "207 GPa";
    /// Area.
    Area = "an area", "m2", "76.7 cm2";
    /// Second moment of area.
    SecondMoment = "a second moment of area", "m4", "2350 cm4";
    /// Mass per length.
    MassPerLength = "a mass per length", "kg/m", "56 kg/m";
    /// Stiffness.
    Stiffness = "a stiffness", "N/m", "280 MN/m";
    /// Viscous damping.
    Damping = "a viscous damping", "N s/m", "63 kNs/m";
    /// Viscous damping per length.
    DampingPerLength = "a viscous damping per length", "N s/m2", "2 kNs/m2";
    /// Density.
    Density = "a density", "kg/m3", "7850 kg/m3";
    /// Mass worn per dissipated energy.
    WearCoefficient = "a wear coefficient", "kg/J", "2.5e-9 kg/J";
    /// Decay over slip velocity.
    VelocityDecay = "a decay over slip velocity", "s/m", "0.6 s/m";
}

/// A quantity of the dimension `D`, held in SI.
pub struct Quantity<D> {
    si: f64,
    dimension: PhantomData<fn() -> D>,
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

/// A text that is not the quantity it should be.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum QuantityError {
    /// No number at the beginning.
    #[error("\"{text}\" does not begin with a number; write {name} as in \"{example}\"")]
    NoNumber {
        /// What was written.
        text: String,
        /// What is needed, with its article.
        name: &'static str,
        /// How to write it.
        example: &'static str,
    },
    /// Infinite or not a number.
    #[error("{text} is not finite, as {name} must be")]
    NotFinite {
        /// What was written.
        text: String,
        /// What is needed, with its article.
        name: &'static str,
    },
    /// A comma or a separator of thousands in the number.
    #[error(
        "\"{text}\" has a comma or a gap in its number; write a decimal point and no separators of thousands, as in \
         \"{example}\" for {name}"
    )]
    Separator {
        /// What was written.
        text: String,
        /// What is needed, with its article.
        name: &'static str,
        /// How to write it.
        example: &'static str,
    },
    /// A range where one value is needed.
    #[error("\"{text}\" is a range, but one value is needed; write {name} as in \"{example}\"")]
    Range {
        /// What was written.
        text: String,
        /// What is needed, with its article.
        name: &'static str,
        /// How to write it.
        example: &'static str,
    },
    /// A unit that is not known.
    #[error("unknown unit \"{unit}\" in \"{text}\"; write {name} as in \"{example}\"")]
    UnknownUnit {
        /// What was written.
        text: String,
        /// The part of it that is not understood.
        unit: String,
        /// What is needed, with its article.
        name: &'static str,
        /// How to write it.
        example: &'static str,
    },
    /// The unit of another kind of quantity.
    #[error("\"{text}\" is in {got}, not {name}{in_unit}; write it as in \"{example}\"")]
    WrongUnit {
        /// What was written.
        text: String,
        /// Its unit in SI base units.
        got: String,
        /// What is needed, with its article.
        name: &'static str,
        /// Its unit, as the words " in N/m".
        in_unit: String,
        /// How to write it.
        example: &'static str,
    },
}

impl<D: Dimension> Quantity<D> {
    /// A quantity of the given SI value.
    pub const fn new(si: f64) -> Self {
        Self {
            si,
            dimension: PhantomData,
        }
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
        if D::UNIT.is_empty() {
            serializer.serialize_f64(self.si)
        } else {
            serializer.collect_str(self)
        }
    }
}

impl<'de, D: Dimension> Deserialize<'de> for Quantity<D> {
    fn deserialize<T: Deserializer<'de>>(deserializer: T) -> Result<Self, T::Error> {
        struct Visitor<D>(PhantomData<fn() -> D>);

        impl<D: Dimension> de::Visitor<'_> for Visitor<D> {
            type Value = Quantity<D>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                match D::UNIT {
                    "" => write!(f, "{} such as 0.4 or \"{}\"", D::NAME, D::EXAMPLE),
                    unit => write!(f, "{} in {unit} or as in \"{}\"", D::NAME, D::EXAMPLE),
                }
            }

            fn visit_f64<E: de::Error>(self, value: f64) -> Result<Self::Value, E> {
                Kind::of::<D>()
                    .finite(value, &value.to_string())
                    .map(Quantity::new)
                    .map_err(E::custom)
            }

            fn visit_i64<E: de::Error>(self, value: i64) -> Result<Self::Value, E> {
                self.visit_f64(value as f64)
            }

            fn visit_u64<E: de::Error>(self, value: u64) -> Result<Self::Value, E> {
                self.visit_f64(value as f64)
            }

            fn visit_str<E: de::Error>(self, text: &str) -> Result<Self::Value, E> {
                text.parse().map_err(E::custom)
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
    use rstest::rstest;

    fn si<D: Dimension>(text: &str) -> Result<f64, String> {
        text.parse::<Quantity<D>>()
            .map(|quantity| quantity.si())
            .map_err(|error| error.to_string())
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

    #[rstest]
    #[case(
        "280 kg",
        "\"280 kg\" is in kg, not a stiffness in N/m; write it as in \"280 MN/m\""
    )]
    #[case(
        "280 MM/m",
        "unknown unit \"MM\" in \"280 MM/m\"; write a stiffness as in \"280 MN/m\""
    )]
    #[case(
        "stiff",
        "\"stiff\" does not begin with a number; write a stiffness as in \"280 MN/m\""
    )]
    #[case("inf", "inf is not finite, as a stiffness must be")]
    #[case("1e400 N/m", "1e400 N/m is not finite, as a stiffness must be")]
    #[case(
        "0,4 MN/m",
        "\"0,4 MN/m\" has a comma or a gap in its number; write a decimal point and no separators of thousands, \
         as in \"280 MN/m\" for a stiffness"
    )]
    #[case(
        "280 000 000 N/m",
        "\"280 000 000 N/m\" has a comma or a gap in its number; write a decimal point and no separators of \
         thousands, as in \"280 MN/m\" for a stiffness"
    )]
    #[case(
        "100-280 MN/m",
        "\"100-280 MN/m\" is a range, but one value is needed; write a stiffness as in \"280 MN/m\""
    )]
    fn refuses_with_a_sentence(#[case] text: &str, #[case] sentence: &str) {
        assert_eq!(si::<Stiffness>(text), Err(sentence.to_owned()));
    }

    #[rstest]
    #[case("60-90 km/h", [60.0 / 3.6, 25.0])]
    #[case("60..90 km/h", [60.0 / 3.6, 25.0])]
    #[case("60 – 90 km/h", [60.0 / 3.6, 25.0])]
    #[case("36 km/h to 90 km/h", [10.0, 25.0])]
    #[case("36 km/h bis 25 m/s", [10.0, 25.0])]
    #[case("10-25", [10.0, 25.0])]
    #[case("1e-3-2e-3 m/s", [1e-3, 2e-3])]
    #[case("1.5...2.5", [1.5, 2.5])]
    #[case("0-25 m/s", [0.0, 25.0])]
    #[case("-5--3", [-5.0, -3.0])]
    #[case("10 m s-1 - 25 m s-1", [10.0, 25.0])]
    fn reads_ranges(#[case] text: &str, #[case] ends: [f64; 2]) {
        let read = Kind::of::<Speed>().read_range(text).unwrap();
        for (read, end) in read.into_iter().zip(ends) {
            let read = read.si;
            assert!(
                (read - end).abs() <= 4.0 * f64::EPSILON * end.abs(),
                "{read}"
            );
        }
    }

    #[rstest]
    #[case("60 km/h")]
    #[case("1e-3")]
    #[case("-5")]
    #[case("5 m s-1")]
    #[case("60-90 kg")]
    #[case("5 km/h-10")]
    #[case("fast-slow")]
    fn what_is_no_range(#[case] text: &str) {
        assert_eq!(Kind::of::<Speed>().read_range(text), None);
    }

    /// The example of every dimension reads as that dimension, and what is written reads back.
    #[test]
    fn examples_read() {
        fn check<D: Dimension>() {
            let quantity: Quantity<D> = D::EXAMPLE.parse().unwrap();
            assert!(Unit::parse(D::UNIT).is_ok());
            assert_eq!(
                quantity.to_string().parse::<Quantity<D>>().unwrap(),
                quantity
            );
            // As engineers write it, the same again.
            let (number, unit) = Kind::of::<D>().in_engineers_unit(quantity.si());
            let again: Quantity<D> = format!("{number} {unit}").parse().unwrap();
            assert!((again.si() / quantity.si() - 1.0).abs() < 4.0 * f64::EPSILON);
        }
        assert_eq!(Kind::of::<Force>().in_engineers_unit(5e4), (50.0, "kN"));
        assert_eq!(Kind::of::<Ratio>().in_engineers_unit(0.4), (0.4, ""));
        check::<Ratio>();
        check::<Length>();
        check::<Speed>();
        check::<Frequency>();
        check::<Mass>();
        check::<Force>();
        check::<Inertia>();
        check::<Modulus>();
        check::<Area>();
        check::<SecondMoment>();
        check::<MassPerLength>();
        check::<Stiffness>();
        check::<Damping>();
        check::<DampingPerLength>();
        check::<Density>();
        check::<WearCoefficient>();
    }
}
