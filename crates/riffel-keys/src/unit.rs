//! Units as engineers write them: `"50 kN"`, `"80 km/h"`, `"63 kNs/m"`, `"27.77 kg m2"`, `"0.4 %"`, `"115 lb/yd"`.

use std::fmt;

/// Exponents of kilogram, metre, second and radian.
///
/// The radian is kept apart from pure numbers, so that an angle is no ratio.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Exponents {
    /// Of the kilogram.
    pub kilogram: i8,
    /// Of the metre.
    pub metre: i8,
    /// Of the second.
    pub second: i8,
    /// Of the radian.
    pub radian: i8,
}

impl Exponents {
    /// Exponents in the order kilogram, metre, second; without angles.
    pub const fn new(kilogram: i8, metre: i8, second: i8) -> Self {
        Self { kilogram, metre, second, radian: 0 }
    }

    /// Unit of an angle.
    const ANGLE: Self = Self { radian: 1, ..Self::new(0, 0, 0) };

    /// True for the unit of a quantity with exponents `own`. The radian may be left out beside other units: 1/m is
    /// rad/m, but a pure number is no angle.
    pub(crate) fn measure(self, own: Self) -> bool {
        let without_angle = Self { radian: 0, ..own };
        self == own || without_angle != Self::new(0, 0, 0) && self == without_angle
    }

    /// Exponents of the product with another unit raised to a power; `None` on overflow.
    fn times(self, other: Self, power: i8) -> Option<Self> {
        let sum = |a: i8, b: i8| a.checked_add(b.checked_mul(power)?);
        Some(Self {
            kilogram: sum(self.kilogram, other.kilogram)?,
            metre: sum(self.metre, other.metre)?,
            second: sum(self.second, other.second)?,
            radian: sum(self.radian, other.radian)?,
        })
    }
}

impl fmt::Display for Exponents {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let symbols = [("kg", self.kilogram), ("m", self.metre), ("s", self.second), ("rad", self.radian)];
        let parts: Vec<String> = symbols
            .into_iter()
            .filter(|&(_, exponent)| exponent != 0)
            .map(|(symbol, exponent)| match exponent {
                1 => symbol.to_owned(),
                _ => format!("{symbol}{exponent}"),
            })
            .collect();
        f.write_str(&parts.join(" "))
    }
}

/// A unit: its size in SI base units and their exponents.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// Its size in SI base units.
    pub factor: f64,
    /// Exponents of the base units.
    pub exponents: Exponents,
}

/// Units that take a prefix.
const PREFIXED: [(&str, f64, Exponents); 9] = [
    ("m", 1.0, Exponents::new(0, 1, 0)),
    ("g", 1e-3, Exponents::new(1, 0, 0)),
    ("s", 1.0, Exponents::new(0, 0, 1)),
    ("N", 1.0, Exponents::new(1, 1, -2)),
    ("Pa", 1.0, Exponents::new(1, -1, -2)),
    ("J", 1.0, Exponents::new(1, 2, -2)),
    ("W", 1.0, Exponents::new(1, 2, -3)),
    ("Hz", 1.0, Exponents::new(0, 0, -1)),
    ("rad", 1.0, Exponents::ANGLE),
];

/// Newtons of a pound-force: a pound, 0.453 592 37 kg, under standard gravity.
const POUND_FORCE: f64 = 0.453_592_37 * riffel::STANDARD_GRAVITY;
/// Radians of a degree.
const DEGREE: f64 = std::f64::consts::PI / 180.0;
/// Metres of an inch.
const INCH: f64 = 0.0254;

/// Units that take no prefix. Those of the inch and the pound are exact by the agreement of 1959; a pound is a mass,
/// and its weight is `lbf`.
const ALONE: [(&str, f64, Exponents); 22] = [
    ("%", 1e-2, Exponents::new(0, 0, 0)),
    ("‰", 1e-3, Exponents::new(0, 0, 0)),
    ("deg", DEGREE, Exponents::ANGLE),
    ("°", DEGREE, Exponents::ANGLE),
    ("t", 1e3, Exponents::new(1, 0, 0)),
    // A million gross tonnes.
    ("MGT", 1e9, Exponents::new(1, 0, 0)),
    ("h", 3600.0, Exponents::new(0, 0, 1)),
    ("min", 60.0, Exponents::new(0, 0, 1)),
    ("in", INCH, Exponents::new(0, 1, 0)),
    ("mil", 1e-3 * INCH, Exponents::new(0, 1, 0)),
    ("thou", 1e-3 * INCH, Exponents::new(0, 1, 0)),
    ("ft", 12.0 * INCH, Exponents::new(0, 1, 0)),
    ("yd", 36.0 * INCH, Exponents::new(0, 1, 0)),
    ("mi", 63_360.0 * INCH, Exponents::new(0, 1, 0)),
    ("mph", 63_360.0 * INCH / 3600.0, Exponents::new(0, 1, -1)),
    ("kph", 1.0 / 3.6, Exponents::new(0, 1, -1)),
    ("lb", 0.453_592_37, Exponents::new(1, 0, 0)),
    ("lbs", 0.453_592_37, Exponents::new(1, 0, 0)),
    ("lbf", POUND_FORCE, Exponents::new(1, 1, -2)),
    ("kip", 1e3 * POUND_FORCE, Exponents::new(1, 1, -2)),
    ("psi", POUND_FORCE / (INCH * INCH), Exponents::new(1, -1, -2)),
    ("ksi", 1e3 * POUND_FORCE / (INCH * INCH), Exponents::new(1, -1, -2)),
];

const PREFIXES: [(&str, f64); 10] = [
    ("n", 1e-9),
    ("µ", 1e-6), // U+00B5 micro sign
    ("μ", 1e-6), // U+03BC Greek mu
    ("u", 1e-6),
    ("m", 1e-3),
    ("c", 1e-2),
    ("d", 1e-1),
    ("k", 1e3),
    ("M", 1e6),
    ("G", 1e9),
];

impl Unit {
    const ONE: Self = Self { factor: 1.0, exponents: Exponents::new(0, 0, 0) };

    /// Read a unit.
    ///
    /// Factors stand side by side or are joined by a space, `·` or `*`; `/` divides by the one
    /// factor that follows it; a power is written `m2`, `m²`, `m^2` or `s-1`. `1` stands for no unit, as in `1/m`.
    ///
    /// # Errors
    /// The part of the text that is no unit.
    pub fn parse(text: &str) -> Result<Self, String> {
        let mut unit = Self::ONE;
        let mut divide = false;
        let mut expected = false;
        let mut rest = text.trim();
        while !rest.is_empty() {
            let separator = |c: char| c.is_whitespace() || matches!(c, '·' | '*' | '/');
            let end = rest.find(separator).unwrap_or(rest.len());
            if end > 0 {
                let factor = product(&rest[..end]).ok_or_else(|| rest[..end].to_owned())?;
                // In "kN/ms" the slash divides by the whole factor "ms", read as milliseconds.
                unit = unit.times(factor, if divide { -1 } else { 1 }).ok_or_else(|| text.to_owned())?;
                (divide, expected) = (false, false);
                rest = &rest[end..];
                continue;
            }
            let mut chars = rest.chars();
            if let Some(mark @ ('/' | '·' | '*')) = chars.next() {
                if expected {
                    return Err(rest.to_owned());
                }
                expected = true;
                divide = mark == '/';
            }
            rest = chars.as_str();
        }
        if expected {
            return Err(text.to_owned());
        }
        Ok(unit)
    }

    fn times(self, other: Self, power: i8) -> Option<Self> {
        Some(Self {
            factor: self.factor * other.factor.powi(power.into()),
            exponents: self.exponents.times(other.exponents, power)?,
        })
    }
}

/// Most bytes of a run of symbols: the ways to split it grow exponentially.
const LONGEST_RUN: usize = 24;

/// A run of symbols without a separator: the longest first symbol that leaves a readable rest.
fn product(text: &str) -> Option<Unit> {
    if text.len() > LONGEST_RUN {
        return None;
    }
    if text.is_empty() || text == "1" {
        return Some(Unit::ONE);
    }
    let mut ends: Vec<usize> = text.char_indices().map(|(start, _)| start).skip(1).collect();
    ends.push(text.len());
    // A symbol and its power have at most six characters.
    ends.truncate(6);
    ends.into_iter().rev().find_map(|end| {
        let first = power_of_symbol(&text[..end])?;
        first.times(product(&text[end..])?, 1)
    })
}

/// One symbol with its power.
fn power_of_symbol(text: &str) -> Option<Unit> {
    let name =
        text.trim_end_matches(|c: char| c.is_ascii_digit() || matches!(c, '²' | '³' | '⁴' | '-' | '⁻' | '¹' | '^'));
    let power: String = text[name.len()..]
        .chars()
        .filter(|&c| c != '^')
        .map(|c| match c {
            '¹' => '1',
            '²' => '2',
            '³' => '3',
            '⁴' => '4',
            '⁻' => '-',
            other => other,
        })
        .collect();
    let power: i8 = if power.is_empty() { 1 } else { power.parse().ok()? };
    if power.abs() > 6 {
        return None;
    }
    Unit::ONE.times(symbol(name)?, power)
}

fn symbol(name: &str) -> Option<Unit> {
    let find = |name: &str, table: &[(&str, f64, Exponents)]| {
        table.iter().find(|(symbol, ..)| *symbol == name).map(|&(_, factor, exponents)| Unit { factor, exponents })
    };
    find(name, &ALONE).or_else(|| find(name, &PREFIXED)).or_else(|| {
        PREFIXES.iter().find_map(|(prefix, scale)| {
            let unit = find(name.strip_prefix(prefix)?, &PREFIXED)?;
            Some(Unit { factor: unit.factor * scale, ..unit })
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads() {
        let cases: [(&str, f64, [i8; 3]); 38] = [
            ("kN", 1e3, [1, 1, -2]),
            ("km/h", 1.0 / 3.6, [0, 1, -1]),
            ("kNs/m", 1e3, [1, 0, -1]),
            ("kN s/m", 1e3, [1, 0, -1]),
            ("kN·s·m-1", 1e3, [1, 0, -1]),
            ("kg m2", 1.0, [1, 2, 0]),
            ("kgm²", 1.0, [1, 2, 0]),
            ("m^4", 1.0, [0, 4, 0]),
            ("cm4", 1e-8, [0, 4, 0]),
            ("N/mm2", 1e6, [1, -1, -2]),
            ("N / mm²", 1e6, [1, -1, -2]),
            ("µm", 1e-6, [0, 1, 0]),
            ("ms", 1e-3, [0, 0, 1]),
            ("t/m3", 1e3, [1, -3, 0]),
            ("kg/J", 1.0, [0, -2, 2]),
            ("min", 60.0, [0, 0, 1]),
            ("%", 1e-2, [0, 0, 0]),
            ("", 1.0, [0, 0, 0]),
            ("mph", 0.44704, [0, 1, -1]),
            ("mi/h", 0.44704, [0, 1, -1]),
            ("kph", 1.0 / 3.6, [0, 1, -1]),
            ("in", 0.0254, [0, 1, 0]),
            ("in4", 4.162_314_256e-7, [0, 4, 0]),
            ("ft", 0.3048, [0, 1, 0]),
            ("mil", 25.4e-6, [0, 1, 0]),
            ("thou", 25.4e-6, [0, 1, 0]),
            ("dm", 0.1, [0, 1, 0]),
            ("lb", 0.453_592_37, [1, 0, 0]),
            ("lbs/yd", 0.453_592_37 / 0.9144, [1, -1, 0]),
            ("lbf", 4.448_221_615_260_5, [1, 1, -2]),
            ("kip", 4_448.221_615_260_5, [1, 1, -2]),
            ("kip/in", 4_448.221_615_260_5 / 0.0254, [1, 0, -2]),
            ("lb ft2", 0.042_140_110_093_804_8, [1, 2, 0]),
            ("ksi", 6_894_757.293_168_361, [1, -1, -2]),
            ("t", 1e3, [1, 0, 0]),
            ("m6", 1.0, [0, 6, 0]),
            ("1/m", 1.0, [0, -1, 0]),
            ("1 / mm", 1e3, [0, -1, 0]),
        ];
        for (text, factor, exponents) in cases {
            let unit = Unit::parse(text).unwrap();
            assert!((unit.factor / factor - 1.0).abs() < 1e-15, "{unit:?}");
            let [kilogram, metre, second] = exponents;
            assert_eq!(unit.exponents, Exponents::new(kilogram, metre, second));
        }
    }

    #[test]
    fn angles_are_no_pure_numbers() {
        let [ratio, angle, spin, inverse] = ["%", "deg", "mrad/mm", "1/m"].map(|text| Unit::parse(text).unwrap());
        assert_eq!(angle.factor, std::f64::consts::PI / 180.0);
        assert_eq!(spin.factor, 1.0);
        assert_eq!(spin.exponents.to_string(), "m-1 rad");
        assert!(!angle.exponents.measure(ratio.exponents));
        assert!(!ratio.exponents.measure(angle.exponents));
        assert!(inverse.exponents.measure(spin.exponents));
        assert!(!spin.exponents.measure(inverse.exponents));
        // Angular frequencies are no frequencies.
        let hertz = Unit::parse("Hz").unwrap().exponents;
        assert!(!Unit::parse("rad/s").unwrap().exponents.measure(hertz));
    }

    #[test]
    // in no time
    fn refuses() {
        for text in [
            "kNx",
            "furlong",
            "m/",
            "/ / m",
            "m-",
            "m999999",
            "MM",
            &format!("{}p{}km", "m".repeat(70), "m".repeat(20)),
        ] {
            assert!(Unit::parse(text).is_err());
        }
    }
}
