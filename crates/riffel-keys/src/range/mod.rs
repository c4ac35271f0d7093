//! Physical ranges: what values a quantity can have, and what values it usually has.

mod judgement;
mod table;

use schemars::Schema;
use serde_json::json;

use crate::quantity::{Dimension, Kind, WrittenQuantity};
use crate::{CaseError, Message, say};

pub(crate) use judgement::Judgement;

/// The range of a quantity, in SI.
///
/// A value outside the hard range is an error: there the models have no meaning, or numbers overflow. A value outside
/// the usual range is computed with a remark that asks for the unit, for a wrong unit is the most frequent reason.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PhysicalRange {
    /// Keys of the case and of the traffic file, and arguments of the program, that have this range.
    pub keys: &'static [&'static str],
    /// What they take.
    pub kind: Kind,
    /// Smallest and largest value that is computed, both included.
    pub hard: [f64; 2],
    /// Smallest and largest value of railways in service, both included.
    pub usual: [f64; 2],
    /// Largest number that is taken without a question where no unit is written.
    pub bare_up_to: f64,
    /// Where the ends come from.
    pub reason: &'static str,
}

impl PhysicalRange {
    /// Every range, in the order of the case file.
    pub fn all() -> impl Iterator<Item = &'static Self> {
        table::TABLES.into_iter().flatten()
    }

    /// The range of a key such as `contact.friction` or `vehicle[0].speed.mean`, or of an argument such as `--speed`.
    pub fn of(key: &str) -> Option<&'static Self> {
        let mut name = String::with_capacity(key.len());
        let mut inside = false;
        for c in key.chars() {
            match c {
                '[' => inside = true,
                ']' => inside = false,
                c if !inside => name.push(c),
                _ => {}
            }
        }
        Self::all().find(|range| range.keys.contains(&name.as_str()))
    }

    /// The value in SI of an argument such as `--speed` from its text, with what is to be asked about it.
    ///
    /// # Errors
    /// The sentence after the name of the argument, for a value outside its range: "is 55 m, but must be …".
    pub fn read<D: Dimension>(argument: &str, text: &str) -> Result<(f64, Option<Message>), Message> {
        let written = Kind::of::<D>().read_written(text).map_err(|error| error.message())?;
        let si = written.si;
        match Self::of(argument).map(|range| range.judge(argument, &written)) {
            None | Some(Judgement::Usual) => Ok((si, None)),
            Some(Judgement::Unusual(remark)) => Ok((si, Some(remark))),
            Some(Judgement::Impossible { rule, help }) if help.is_empty() => Err(rule),
            Some(Judgement::Impossible { rule, help }) => Err(say!(one_after_other, one = rule, other = help)),
        }
    }

    /// `Ok` if numbers in SI, which are called `what`, have the range of an argument.
    ///
    /// # Errors
    /// [`CaseError::Point`] with the value and the rule.
    pub fn check(argument: &str, what: &str, values: [f64; 2]) -> Result<(), CaseError> {
        let Some(range) = Self::of(argument) else {
            return Ok(());
        };
        for value in values {
            let written = WrittenQuantity { unit: range.kind.unit.to_owned(), ..WrittenQuantity::bare(value) };
            if let Judgement::Impossible { rule, .. } = range.judge(what, &written) {
                return Err(CaseError::Point { message: say!(name_as_subject, name = what, rule) });
            }
        }
        Ok(())
    }

    /// Two ends in the units of engineers, as in "5 mm" and "5 m".
    pub fn in_words(&self, ends: [f64; 2]) -> [String; 2] {
        ends.map(|end| judgement::amount(&self.kind, end))
    }
}

/// Write the hard ranges of keys into a schema, each at its JSON pointer. A definition that several keys share has the
/// widest of their ranges. They hold for bare numbers.
pub fn bound<'a>(schema: &mut Schema, pointers: impl IntoIterator<Item = (&'a str, &'a str)>) {
    for (key, pointer) in pointers {
        let Some(range) = PhysicalRange::of(key) else {
            continue;
        };
        let Some(node) = schema.pointer_mut(pointer) else {
            continue;
        };
        let [low, high] = range.hard;
        let known = |end: &str, value: f64| node[end].as_f64().unwrap_or(value);
        let (low, high) = (low.min(known("minimum", low)), high.max(known("maximum", high)));
        node["minimum"] = json!(low);
        node["maximum"] = json!(high);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn usual_ranges_lie_in_the_hard_ones() {
        for range in PhysicalRange::all() {
            let ([low, high], [from, to]) = (range.hard, range.usual);
            assert!(low <= from && from < to && to <= high, "{range:?}");
            assert!(range.bare_up_to > from, "{range:?}");
            assert!(!range.reason.is_empty() && range.reason.ends_with('.'), "{range:?}");
        }
        assert!(PhysicalRange::of("vehicle[12].speeds[3].speed").is_some());
        assert!(PhysicalRange::of("contact.colour").is_none());
    }

    /// The widest window is one of finite frequencies that the program's own limits on frequency allow.
    #[test]
    fn every_window_has_frequencies_within_their_range() {
        let ends = |key: &str| PhysicalRange::of(key).unwrap().hard;
        let ([shortest, longest], [slowest, fastest]) = (ends("map.wavelength.min"), ends("map.speed.min"));
        let [lowest, highest] = ends("--from");
        assert!(slowest / longest >= lowest && fastest / shortest <= highest * (1.0 + 1e-12));
    }

    #[test]
    fn amounts_are_written_in_handy_units() {
        use super::judgement::amount;
        let of = |unit: &str, si: f64| {
            let kind = crate::quantity::KINDS.iter().find(|kind| kind.unit == unit);
            amount(kind.unwrap_or(&Kind::of::<crate::quantity::Ratio>()), si)
        };
        assert_eq!(of("m", 0.005), "5 mm");
        assert_eq!(of("m", 10.0), "10 m");
        assert_eq!(of("Pa", 207e9), "207 GPa");
        assert_eq!(of("N", 250e3), "250 kN");
        assert_eq!(of("m4", 2.35e-5), "2350 cm4");
        assert_eq!(of("", 0.0015), "0.0015");
        assert_eq!(of("", 1e-9), "1e-9");
        assert_eq!(of("N s/m", 0.0), "0 N s/m");
        assert_eq!(of("rad", 0.0), "0 deg");
        assert_eq!(of("rad", 0.5 * std::f64::consts::PI), "90 deg");
        assert_eq!(of("m6", 2.16e-8), "21600 cm6");
    }
}
