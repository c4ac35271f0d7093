//! What is said of a value that is not usual, or not possible.

use crate::message::quantity;
use crate::quantity::{Kind, WrittenQuantity};
use crate::unit::Unit;
use crate::{Message, PhysicalRange, Value, number, say};

/// What is said of a value.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Judgement {
    /// Nothing.
    Usual,
    /// It is computed, but the reader is asked; the sentence begins with the key.
    Unusual(Message),
    /// It is refused.
    Impossible {
        /// Value and rule, after the key: "is 460 m, but must be between …".
        rule: Message,
        /// "did you mean …?", or empty.
        help: Message,
    },
}

impl PhysicalRange {
    /// What is said of the value of a key as it was written.
    pub(crate) fn judge(&self, key: &str, written: &WrittenQuantity) -> Judgement {
        let kind = &self.kind;
        let [low, high] = self.hard;
        let words = written.in_words(kind);
        let value = quantity(written.si, kind.unit, &words);
        let bound = |si| quantity(si, kind.unit, amount(kind, si));
        if !(low..=high).contains(&written.si) {
            return Judgement::Impossible {
                rule: say!(is_outside, value, low = bound(low), high = bound(high)),
                help: self.question(written).unwrap_or_else(|| "".into()),
            };
        }
        let [from, to] = self.usual;
        let question = || match self.question(written) {
            Some(question) => Value::from(say!(in_brackets, words = question)),
            None => Value::from(""),
        };
        if !(from..=to).contains(&written.si) {
            return Judgement::Unusual(say!(
                unusual_value,
                key,
                value,
                from = bound(from),
                to = bound(to),
                question = question()
            ));
        }
        if written.unit.is_empty() && written.si > self.bare_up_to {
            let in_engineers_unit = kind.in_engineers_unit(written.si);
            let read = format!("{words} = {} {}", significant(in_engineers_unit.0), in_engineers_unit.1);
            return Judgement::Unusual(say!(number_without_unit, key, read = number(read), question = question()));
        }
        Judgement::Usual
    }

    /// The number with other units with which it would be usual, at most two of them, as a question.
    fn question(&self, written: &WrittenQuantity) -> Option<Message> {
        let kind = &self.kind;
        let [from, to] = self.usual;
        let is_usual = |unit: Unit| (from..=to).contains(&(written.number * unit.factor));
        let mut meant = units(kind)
            .iter()
            .filter(|&&unit| unit != written.unit && (unit != kind.unit || !written.unit.is_empty()))
            .filter(|unit| Unit::parse(unit).is_ok_and(is_usual))
            .map(|unit| say!(quoted, words = number(format_args!("{} {unit}", written.number))));
        match (meant.next()?, meant.next()) {
            (one, None) => Some(say!(did_you_mean, meant = one)),
            (one, Some(other)) => Some(say!(did_you_mean_either, one, other)),
        }
    }
}

/// Units in which engineers write a quantity, the likeliest first.
fn units(kind: &Kind) -> &'static [&'static str] {
    match kind.unit {
        // A count is not written in per cent.
        "" if !kind.example.contains('%') => &[],
        "" => &["%"],
        "m" => &["mm", "m", "cm", "µm", "in", "ft"],
        "m/s" => &["km/h", "mph", "m/s"],
        "Hz" => &["Hz", "kHz"],
        "kg" => &["kg", "t", "lb", "g"],
        "N" => &["kN", "N", "kip", "lbf", "MN"],
        "Pa" => &["GPa", "MPa", "Pa", "ksi"],
        "m2" => &["cm2", "mm2", "m2", "in2"],
        "m4" => &["cm4", "mm4", "m4", "in4"],
        "kg/m" => &["kg/m", "lb/yd"],
        "N/m" => &["MN/m", "kN/mm", "kN/m", "N/m", "GN/m", "kip/in"],
        "N s/m" => &["kN s/m", "N s/m", "MN s/m"],
        "N s/m2" => &["kN s/m2", "N s/m2"],
        "kg/m3" => &["kg/m3", "t/m3", "g/cm3"],
        "rad" => &["deg", "rad"],
        "m6" => &["cm6", "mm6", "m6"],
        _ => &[],
    }
}

/// Units in which bounds are written, from the smallest to the largest.
fn handy(kind: &Kind) -> &'static [&'static str] {
    match kind.unit {
        "m" => &["µm", "mm", "m"],
        "m/s" => &["m/s"],
        "Hz" => &["mHz", "Hz", "kHz", "MHz"],
        "kg" => &["g", "kg", "t"],
        "N" => &["N", "kN", "MN"],
        "Pa" => &["GPa"],
        "m2" => &["mm2", "cm2", "m2"],
        "m4" => &["mm4", "cm4", "m4"],
        "N/m" => &["N/m", "kN/m", "MN/m", "GN/m"],
        "N s/m" => &["N s/m", "kN s/m", "MN s/m"],
        "N s/m2" => &["N s/m2", "kN s/m2", "MN s/m2"],
        "rad" => &["deg"],
        "m6" => &["mm6", "cm6", "m6"],
        _ => &[],
    }
}

/// A value in the largest handy unit that leaves no less than one, as in "5 mm".
pub(crate) fn amount(kind: &Kind, si: f64) -> String {
    let in_unit = |unit: &str| Unit::parse(unit).map_or(si, |unit| si / unit.factor);
    let handy = handy(kind);
    let unit = match handy {
        [only] => only,
        _ if si == 0.0 => &kind.unit,
        _ => handy.iter().rev().find(|unit| in_unit(unit).abs() >= 1.0).or(handy.first()).unwrap_or(&kind.unit),
    };
    let number = significant(in_unit(unit));
    match *unit {
        "" => number,
        unit => format!("{number} {unit}"),
    }
}

/// A number with six digits, in powers of ten where it is very small or large.
fn significant(number: f64) -> String {
    // Written with six digits, it reads back as a number.
    let rounded: f64 = format!("{number:.5e}").parse().unwrap_or(number);
    match rounded.abs() {
        size if size != 0.0 && !(1e-4..1e6).contains(&size) => format!("{rounded:e}"),
        _ => rounded.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Language;

    fn judged(key: &str, text: &str) -> Judgement {
        let range = PhysicalRange::of(key).unwrap();
        range.judge(key, &range.kind.read_written(text).unwrap())
    }

    #[test]
    fn the_impossible_is_refused() {
        for (key, text, rule, help) in [
            ("contact.friction", "40", "is 40, but must be between 0.001 and 1.5", "did you mean \"40 %\"?"),
            ("wheel.rolling_radius", "460", "is 460 m, but must be between 5 mm and 5 m", "did you mean \"460 mm\"?"),
            (
                "wheel.rolling_radius",
                "0.46 mm",
                "is 0.46 mm, but must be between 5 mm and 5 m",
                "did you mean \"0.46 m\"?",
            ),
            (
                "steel.youngs_modulus",
                "207",
                "is 207 Pa, but must be between 1 GPa and 1000 GPa",
                "did you mean \"207 GPa\"?",
            ),
            (
                "map.wavelength.min",
                "55",
                "is 55 m, but must be between 100 µm and 10 m",
                "did you mean \"55 mm\" or \"55 cm\"?",
            ),
            ("wheel.mass", "-350 kg", "is -350 kg, but must be between 10 g and 100 t", ""),
        ] {
            let Judgement::Impossible { rule: own, help: advice } = judged(key, text) else {
                panic!("{key} = {text} is possible");
            };
            assert_eq!((&*own.to_string(), &*advice.to_string()), (rule, help));
        }
    }

    #[test]
    fn the_unusual_is_asked_about() {
        for (key, text, english, german) in [
            (
                "contact.normal_load",
                "50",
                "contact.normal_load is 50 N; usual values are 10 kN to 250 kN (did you mean \"50 kN\" or \"50 kip\"?)",
                "contact.normal_load ist 50 N; üblich sind 10 kN bis 250 kN (gemeint: „50 kN“ oder „50 kip“?)",
            ),
            (
                "map.speed.max",
                "108",
                "map.speed.max is 108 m/s; usual values are 1 m/s to 100 m/s (did you mean \"108 km/h\" or \"108 mph\"?)",
                "map.speed.max ist 108 m/s; üblich sind 1 m/s bis 100 m/s (gemeint: „108 km/h“ oder „108 mph“?)",
            ),
            (
                "map.speed.max",
                "52",
                "map.speed.max has no unit and is read as 52 m/s = 187.2 km/h (did you mean \"52 km/h\" or \"52 mph\"?)",
                "map.speed.max hat keine Einheit und wird als 52 m/s = 187,2 km/h gelesen (gemeint: „52 km/h“ oder „52 mph“?)",
            ),
            (
                "contact.friction",
                "0.9",
                "contact.friction is 0.9; usual values are 0.02 to 0.8",
                "contact.friction ist 0,9; üblich sind 0,02 bis 0,8",
            ),
        ] {
            let Judgement::Unusual(remark) = judged(key, text) else {
                panic!("{key} = {text} is usual");
            };
            assert_eq!(remark.text(Language::English), english);
            assert_eq!(remark.text(Language::German), german);
        }
    }

    #[test]
    fn the_usual_is_not() {
        for (key, text) in [
            ("map.speed.max", "52 m/s"),
            ("map.speed.max", "40"),
            ("contact.normal_load", "11 kip"),
            ("track.pad.damping", "0"),
        ] {
            assert_eq!(judged(key, text), Judgement::Usual);
        }
    }
}
