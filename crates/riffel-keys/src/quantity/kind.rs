//! Quantities where only the key tells which, read from text.

use super::error::QuantityProblem;
use super::{Dimension, QuantityError, WrittenQuantity, named};
use crate::unit::{Exponents, Unit};
use crate::{Message, say};

/// A dimension where only the key tells which.
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
        Self { name: D::NAME, unit: D::UNIT, example: D::EXAMPLE }
    }

    /// What is expected of a value of this kind: "a force in N or as in "50 kN"".
    pub(crate) fn expected(&self) -> Message {
        let (kind, example) = (named(self.name), self.example);
        match self.unit {
            "" => say!(ratio_such_as, kind, example),
            unit => say!(kind_as_in, kind, unit, example),
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
    /// Errors of [`read`](Self::read).
    pub(crate) fn read_written(&self, text: &str) -> Result<WrittenQuantity, QuantityError> {
        self.read_one(text).map_err(|error| match self.read_range(text) {
            Some(_) => self.refuse(text, QuantityProblem::Range),
            None => error,
        })
    }

    /// The lowest and the highest value of a range: `"60-90 km/h"`, `"60..90 km/h"`, `"0.02 to 0.08 m"`,
    /// `"5 m/s – 60 m/s"`. A unit at the end is that of both. None for a text that is no range of this kind.
    pub(crate) fn read_range(&self, text: &str) -> Option<[WrittenQuantity; 2]> {
        /// No range is longer; foreign data may be.
        const LONGEST: usize = 100;
        if text.len() > LONGEST {
            return None;
        }
        const MARKS: [&str; 8] = ["...", "..", "…", "–", "—", " to ", " bis ", "-"];
        let both = |low: &str, high: &str| {
            let (mut low, high) = (self.read_one(low).ok()?, self.read_one(high).ok()?);
            match (low.unit.is_empty(), high.unit.is_empty()) {
                (true, false) => low = self.read_one(&format!("{} {}", low.number, high.unit)).ok()?,
                // "5 m-1" is no range of 5 m to 1.
                (false, true) => return None,
                _ => {}
            }
            Some([low, high])
        };
        MARKS.iter().find_map(|mark| {
            text.match_indices(mark).find_map(|(place, _)| both(&text[..place], &text[place + mark.len()..]))
        })
    }

    /// The ends of a range as [`read`](Self::read) takes them: "60 km/h" and "90 km/h" for "60-90 km/h".
    pub fn range_in_words(&self, text: &str) -> Option<[String; 2]> {
        let ends = self.read_range(text)?;
        Some(ends.map(|end| format!("{} {}", end.number, end.unit).trim_end().to_owned()))
    }

    fn read_one(&self, text: &str) -> Result<WrittenQuantity, QuantityError> {
        /// Characters of the largest number written out, and some to spare; foreign data may be longer.
        const LONGEST_NUMBER: usize = 400;
        let trimmed = text.trim();
        // The longest beginning that reads as a number: "5 km" must not lose "5e3 m".
        let number = (1..=trimmed.len().min(LONGEST_NUMBER))
            .rev()
            .filter(|&end| trimmed.is_char_boundary(end))
            .find_map(|end| Some((trimmed[..end].parse::<f64>().ok()?, &trimmed[end..])));
        let Some((number, rest)) = number else {
            return Err(self.refuse(text, QuantityProblem::NoNumber));
        };
        // No unit begins with a digit: "50,000", "50 000", "50'000" and "50.000.000" are numbers with separators.
        // One alone does: "0.3 1/m".
        let rest = rest.trim_start();
        let after = rest.trim_start_matches([',', '.', '\'', '’', '_', '\u{202f}']);
        if after.starts_with(|c: char| c.is_ascii_digit()) && !rest.starts_with("1/") {
            return Err(self.refuse(text, QuantityProblem::Separator));
        }
        let mut written = WrittenQuantity { number, unit: rest.trim().to_owned(), si: number };
        if !written.unit.is_empty() {
            let read =
                Unit::parse(&written.unit).map_err(|unit| self.refuse(text, QuantityProblem::UnknownUnit(unit)))?;
            // The unit of a dimension is a constant that the tests read for every dimension.
            let own = Unit::parse(self.unit).map_or(Exponents::new(0, 0, 0), |unit| unit.exponents);
            if !read.exponents.measure(own) {
                let got = read.exponents.to_string();
                return Err(self.refuse(text, QuantityProblem::WrongUnit(got)));
            }
            written.si = number * read.factor;
        }
        self.finite(written.si, trimmed)?;
        Ok(written)
    }

    pub(super) fn finite(&self, si: f64, text: &str) -> Result<f64, QuantityError> {
        if si.is_finite() {
            return Ok(si);
        }
        Err(self.refuse(text, QuantityProblem::NotFinite))
    }

    fn refuse(&self, text: &str, problem: QuantityProblem) -> QuantityError {
        QuantityError { text: text.to_owned(), kind: *self, problem }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quantity::Speed;

    #[test]
    fn reads_ranges() {
        let cases: [(&str, [f64; 2]); 11] = [
            ("60-90 km/h", [60.0 / 3.6, 25.0]),
            ("60..90 km/h", [60.0 / 3.6, 25.0]),
            ("60 – 90 km/h", [60.0 / 3.6, 25.0]),
            ("36 km/h to 90 km/h", [10.0, 25.0]),
            ("36 km/h bis 25 m/s", [10.0, 25.0]),
            ("10-25", [10.0, 25.0]),
            ("1e-3-2e-3 m/s", [1e-3, 2e-3]),
            ("1.5...2.5", [1.5, 2.5]),
            ("0-25 m/s", [0.0, 25.0]),
            ("-5--3", [-5.0, -3.0]),
            ("10 m s-1 - 25 m s-1", [10.0, 25.0]),
        ];
        for (text, ends) in cases {
            let read = Kind::of::<Speed>().read_range(text).unwrap();
            for (read, end) in read.into_iter().zip(ends) {
                let read = read.si;
                assert!((read - end).abs() <= 4.0 * f64::EPSILON * end.abs(), "{read}");
            }
        }
    }

    #[test]
    fn what_is_no_range() {
        for text in ["60 km/h", "1e-3", "-5", "5 m s-1", "60-90 kg", "5 km/h-10", "fast-slow"] {
            assert_eq!(Kind::of::<Speed>().read_range(text), None);
        }
    }
}
