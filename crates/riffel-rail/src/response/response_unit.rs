//! The unit of a frequency response: "mm/s/kN", "g/N", "dB re 1 m/N".

use riffel::STANDARD_GRAVITY;
use riffel_keys::table::{is_one_of, words};
use riffel_keys::{Message, Unit, say};

use super::MeasurementError;
use super::keys::Response;

/// What is known of the unit of a column.
pub(super) struct ValueUnit<'a> {
    /// Key `unit`.
    pub(super) key: Option<&'a str>,
    /// Key `quantity`.
    pub(super) quantity: Option<Response>,
    /// Name of the column.
    pub(super) column: &'a str,
    /// What the file says.
    pub(super) in_file: Option<&'a str>,
    /// Whether the column is a modulus, and not a part.
    pub(super) is_modulus: bool,
}

/// What makes a response in SI of a number.
pub(super) struct Decoded {
    pub(super) response: Response,
    scale: Scale,
    /// What was taken for granted.
    pub(super) remarks: Vec<Message>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Scale {
    /// SI units in one unit of the column.
    Linear(f64),
    /// Decibels over a reference in SI.
    Decibels(f64),
}

impl Decoded {
    /// The modulus in SI; none for a negative one.
    pub(super) fn modulus(&self, value: f64) -> Option<f64> {
        match self.scale {
            Scale::Linear(_) if value < 0.0 => None,
            Scale::Linear(factor) => Some(factor * value),
            Scale::Decibels(reference) => Some(reference * 10f64.powf(value / 20.0)),
        }
    }

    /// SI units in one unit of a part; parts are never in decibels.
    pub(super) fn linear(&self) -> f64 {
        match self.scale {
            Scale::Linear(factor) | Scale::Decibels(factor) => factor,
        }
    }
}

impl ValueUnit<'_> {
    /// The unit of the case, or else of the file.
    pub(super) fn decode(&self) -> Result<Decoded, MeasurementError> {
        let wrong = |message: String| Err(MeasurementError::new("unit", message));
        let column = self.column;
        let decibels = self.in_file.and_then(after_decibel);
        let name = self.quantity.or_else(|| response_in(column));
        let name = name.unwrap_or_default();
        let example = format!("unit = \"dB re 1 {}\"", name.si_unit());
        if let (Some(key), Some(_)) = (self.key, decibels)
            && after_decibel(key).is_none()
        {
            return wrong(format!(
                "is \"{key}\", but column `{column}` is in decibels: write the reference, as {example}"
            ));
        }
        let Some(unit) = self.key.or(self.in_file) else {
            return Ok(self.taken_for_granted(name));
        };
        let Some(reference) = after_decibel(unit) else {
            return match (response_of(unit), self.key) {
                (Some((response, factor)), _) => self.checked(unit, response, Scale::Linear(factor)),
                // What is no unit may be a symbol, as in "Re(H)".
                (None, None) if !unit.contains('/') => Ok(self.taken_for_granted(name)),
                (None, None) => wrong(format!(
                    "is left out, and column `{column}` is in {unit}, which is no unit of {}: convert it, or write its unit",
                    self.expected()
                )),
                (None, Some(_)) => wrong(match Unit::parse(unit) {
                    Err(part) => format!("is \"{unit}\", with the unknown unit \"{part}\""),
                    Ok(_) => format!("is \"{unit}\", which is no unit of {}", self.expected()),
                }),
            };
        };
        if !self.is_modulus {
            return wrong(format!(
                "is in decibels, but column `{column}` is a part of a complex number: decibels are of a modulus"
            ));
        }
        match reference_of(reference) {
            Some((response, size)) => self.checked(unit, response, Scale::Decibels(size)),
            None if reference.is_empty() => wrong(match self.key {
                Some(key) => format!("is \"{key}\", decibels without a reference: write the reference, as {example}"),
                None => format!("is left out, but column `{column}` is in decibels: write the reference, as {example}"),
            }),
            None => wrong(format!(
                "is \"{unit}\", whose reference \"{reference}\" is no unit of {}: write it as {example}",
                self.expected()
            )),
        }
    }

    fn expected(&self) -> &'static str {
        self.quantity.map_or("a receptance in m/N, a mobility in m/s/N or an accelerance in m/s2/N", Response::name)
    }

    fn checked(&self, unit: &str, response: Response, scale: Scale) -> Result<Decoded, MeasurementError> {
        match self.quantity {
            Some(quantity) if quantity != response => Err(MeasurementError::new(
                if self.key.is_some() { "unit" } else { "quantity" },
                match self.key {
                    Some(_) => format!("is \"{unit}\", which is no unit of {}", quantity.name()),
                    None => format!(
                        "is {}, but column `{}` is in {unit}, {}",
                        quantity.name(),
                        self.column,
                        response.name()
                    ),
                },
            )),
            _ => Ok(Decoded { response, scale, remarks: Vec::new() }),
        }
    }

    /// SI, with a remark where nobody says what was measured.
    fn taken_for_granted(&self, response: Response) -> Decoded {
        let column = self.column;
        let remark = self.quantity.is_none().then(|| {
            let what = match response {
                Response::Receptance => say!(receptance_in_si),
                Response::Mobility => say!(mobility_in_si),
                Response::Accelerance => say!(accelerance_in_si),
            };
            say!(column_without_unit, column, what)
        });
        Decoded { response, scale: Scale::Linear(1.0), remarks: remark.into_iter().collect() }
    }
}

/// Which response the name of a column says.
fn response_in(column: &str) -> Option<Response> {
    let known = [
        (Response::Receptance, "receptance|compliance|rezeptanz"),
        (Response::Mobility, "mobility|mobilität|admittance|admittanz"),
        (Response::Accelerance, "accelerance|inertance|akzeleranz|inertanz"),
    ];
    let words = words(column);
    let mut known = known.into_iter();
    let said = known.find(|(_, names)| words.iter().any(|word| is_one_of(word, names)));
    said.map(|(response, _)| response)
}

/// What follows "dB", "dB re", "dB rel.", "dB ref", without a colon and an outer pair of brackets.
pub(super) fn after_decibel(unit: &str) -> Option<&str> {
    let head = unit.get(..2)?;
    let rest = head.eq_ignore_ascii_case("db").then(|| inside(unit[2..].trim()))?;
    let word = ["relative to", "rel.", "rel", "ref.", "ref", "re", "//"]
        .into_iter()
        .find(|word| rest.get(..word.len()).is_some_and(|head| head.eq_ignore_ascii_case(word)));
    let rest = word.map_or(rest, |word| &rest[word.len()..]);
    Some(inside(rest.trim_start_matches([':', ' ', '.']).trim()))
}

/// What stands within the brackets around a text, or the text.
fn inside(text: &str) -> &str {
    match text.strip_prefix('(').and_then(|rest| rest.strip_suffix(')')) {
        Some(inside) if !inside.contains(')') => inside,
        _ => text,
    }
}

/// A reference: a number, 1 if there is none, with a unit.
fn reference_of(text: &str) -> Option<(Response, f64)> {
    let end = text
        .find(|c: char| c.is_whitespace() || c.is_alphabetic() && !matches!(c, 'e' | 'E') || c == '(')
        .unwrap_or(text.len());
    let (number, unit) = text.split_at(end);
    let number: f64 = match number.trim() {
        "" => 1.0,
        number => number.parse().ok()?,
    };
    let (response, factor) = response_of(unit.trim())?;
    (number > 0.0).then_some((response, number * factor))
}

/// Which response a unit is of, and its size in SI.
pub(super) fn response_of(unit: &str) -> Option<(Response, f64)> {
    let plain = without_brackets(unit);
    // Per force, "g" is no gram.
    let per_force = plain.strip_prefix('g').and_then(|rest| rest.trim_start().strip_prefix('/'));
    let (text, gravity) = match per_force {
        Some(force) => (format!("m/s2/{force}"), STANDARD_GRAVITY),
        None => (plain, 1.0),
    };
    let parsed = Unit::parse(&text).ok()?;
    [Response::Receptance, Response::Mobility, Response::Accelerance]
        .into_iter()
        .find(|response| response.exponents() == parsed.exponents)
        .map(|response| (response, gravity * parsed.factor))
}

/// "(m/s²)/N" as "m/s²/N", "m/(s N)" as "m/s/N", "m_per_s_per_kn" as "m/s/kN".
fn without_brackets(unit: &str) -> String {
    if let Some((motion, force)) = unit.rsplit_once("_per_") {
        // Names in small letters; "mn" may be milli or mega, and is no unit.
        let force = match force {
            "n" => "N",
            "kn" => "kN",
            force => force,
        };
        return format!("{}/{force}", motion.replace("_per_", "/"));
    }
    let mut plain = String::new();
    let mut divided = false;
    let mut before = ' ';
    for character in unit.chars() {
        match character {
            '(' => divided = before == '/',
            ')' => divided = false,
            ' ' | '·' | '*' if divided => plain.push('/'),
            _ => plain.push(character),
        }
        if character != ' ' {
            before = character;
        }
    }
    plain
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units() {
        for (text, response, size) in [
            ("m/N", Response::Receptance, 1.0),
            ("mm/kN", Response::Receptance, 1e-6),
            ("mm_per_n", Response::Receptance, 1e-3),
            ("mm_per_s_per_kn", Response::Mobility, 1e-6),
            ("m/s/N", Response::Mobility, 1.0),
            ("m/(s N)", Response::Mobility, 1.0),
            ("mm/(s·kN)", Response::Mobility, 1e-6),
            ("(m/s²)/N", Response::Accelerance, 1.0),
            ("g/N", Response::Accelerance, 9.806_65),
            ("g/kN", Response::Accelerance, 9.806_65e-3),
        ] {
            let (found, factor) = response_of(text).unwrap();
            assert_eq!(found, response);
            assert!((factor / size - 1.0).abs() < 1e-12, "{factor} {size}");
        }
    }

    #[test]
    fn references() {
        for (text, expected) in [
            ("dB re 1 m/N", Some((Response::Receptance, 1.0))),
            ("dB re 1e-6 m/s/N", Some((Response::Mobility, 1e-6))),
            ("dB (re 1 m/N)", Some((Response::Receptance, 1.0))),
            ("DB REF 1 g/N", Some((Response::Accelerance, 9.806_65))),
            ("dB(m/N)", Some((Response::Receptance, 1.0))),
            ("dB re 0 m/N", None),
            ("dB re 1 s", None),
            ("dB", None),
        ] {
            assert_eq!(reference_of(after_decibel(text).unwrap()), expected);
        }
    }
}
