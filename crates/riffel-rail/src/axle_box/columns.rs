//! Which columns of a table hold what an axle box felt, and where the train was.

use riffel::STANDARD_GRAVITY;
use riffel_keys::table::{Heading, is_one_of, length_in, words};
use riffel_keys::{Message, say};

use crate::length_unit::metres;

/// What a column holds, with the size of its unit in SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Content {
    Acceleration(f64),
    Speed(f64),
    Odometer(f64),
    Time(f64),
}

impl Content {
    /// Column in units of this many.
    pub(super) fn scaled(self, scale: f64) -> Self {
        match self {
            Self::Acceleration(unit) => Self::Acceleration(scale * unit),
            Self::Speed(unit) => Self::Speed(scale * unit),
            Self::Odometer(unit) => Self::Odometer(scale * unit),
            Self::Time(unit) => Self::Time(scale * unit),
        }
    }
}

const ACCELERATION: &str = "acceleration|accel|acc|beschleunigung|axlebox|abox|a|az";
const SPEED: &str = "speed|velocity|geschwindigkeit|v";
const ODOMETER: &str = "odometer|odo|position|pos|chainage|distance|station|weg|x|kilometrierung";
const TIME: &str = "time|zeit|t";

/// What the head of a column says; none for a column of something else.
///
/// # Errors
/// A sentence where a column that is needed has no unit known here.
pub(super) fn content(heading: &Heading, column: usize) -> Result<Option<Content>, Message> {
    let Some(name) = heading.name(column) else {
        return Ok(None);
    };
    let below = heading.unit_below(column).unwrap_or_default();
    let written = format!("{name} {below}").to_lowercase();
    let own = words(name);
    let is = |known: &str| {
        let mut own = own.iter().enumerate();
        own.any(|(place, word)| (place == 0 || word.len() > 2) && is_one_of(word, known))
    };
    let missing = |one: &str, other: &str| Err(say!(column_has_no_unit, name, one, other));
    if is(ACCELERATION) {
        return match acceleration(&written) {
            Some(unit) => Ok(Some(Content::Acceleration(unit))),
            None => missing("acceleration_m_per_s2", "acceleration_g"),
        };
    }
    if is(SPEED) {
        return match speed(&written) {
            Some(unit) => Ok(Some(Content::Speed(unit))),
            None => missing("speed_km_per_h", "speed_m_per_s"),
        };
    }
    if is(ODOMETER) {
        return match length_in(&written).and_then(metres) {
            Some(unit) => Ok(Some(Content::Odometer(unit))),
            None => missing("odometer_m", "odometer_km"),
        };
    }
    if is(TIME) {
        let written = words(&written);
        let unit = written.iter().rev().find_map(|word| match word.as_str() {
            "s" | "sec" | "seconds" => Some(1.0),
            "ms" => Some(1e-3),
            _ => None,
        });
        return match unit {
            Some(unit) => Ok(Some(Content::Time(unit))),
            None => missing("time_s", "time_ms"),
        };
    }
    // A unit of acceleration says as much as the word; a bare letter may be any name.
    let written = written.trim_end();
    let is_marked = UNITS_OF_GRAVITY.iter().any(|unit| written.ends_with(unit));
    let has_unit = is_marked || SI.iter().any(|unit| written.contains(unit));
    Ok(acceleration(written).filter(|_| has_unit).map(Content::Acceleration))
}

/// Ends of heads that are units and no words.
const UNITS_OF_GRAVITY: [&str; 6] = ["[g]", "(g)", "_g", "[mg]", "(mg)", "_mg"];

/// Ways to write metres per second squared.
const SI: [&str; 8] = ["m/s2", "m/s²", "m/s^2", "m_per_s2", "m_s2", "ms-2", "mps2", "m/s/s"];

fn acceleration(written: &str) -> Option<f64> {
    if SI.iter().any(|unit| written.contains(unit)) {
        return Some(1.0);
    }
    words(written).iter().rev().find_map(|word| match word.as_str() {
        "g" | "gn" => Some(STANDARD_GRAVITY),
        "mg" => Some(1e-3 * STANDARD_GRAVITY),
        _ => None,
    })
}

fn speed(written: &str) -> Option<f64> {
    let has = |units: &[&str]| units.iter().any(|unit| written.contains(unit));
    if has(&["km/h", "km_h", "kmh", "km_per_h", "kph"]) {
        Some(1.0 / 3.6)
    } else if has(&["mph", "mi/h"]) {
        Some(0.447_04)
    } else if has(&["m/s", "m_s", "m_per_s", "mps"]) {
        Some(1.0)
    } else {
        None
    }
}

/// What the head calls a channel, without its unit and the words that all have.
pub(super) fn channel_name(heading: &Heading, column: usize) -> String {
    const OF_ALL: &str = "g|mg|gn|box|axle";
    let name = heading.name(column).unwrap_or_default().to_lowercase();
    let name = SI.iter().fold(name, |name, unit| name.replace(unit, " "));
    let mut own = words(&name);
    own.retain(|word| !is_one_of(word, ACCELERATION) && !is_one_of(word, OF_ALL));
    match own.is_empty() {
        true => format!("column {}", column + 1),
        false => own.join(" "),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(name: &str) -> Result<Option<Content>, Message> {
        content(&Heading::of_name(name), 0)
    }

    #[test]
    fn heads_are_understood() {
        for (name, expected) in [
            ("acceleration_m_per_s2", Content::Acceleration(1.0)),
            ("Beschleunigung links [m/s²]", Content::Acceleration(1.0)),
            ("acc left (g)", Content::Acceleration(STANDARD_GRAVITY)),
            ("speed_km_per_h", Content::Speed(1.0 / 3.6)),
            ("v [m/s]", Content::Speed(1.0)),
            ("odometer_km", Content::Odometer(1e3)),
            ("time_s", Content::Time(1.0)),
            ("t [ms]", Content::Time(1e-3)),
            ("left [m/s²]", Content::Acceleration(1.0)),
            ("gauche (g)", Content::Acceleration(STANDARD_GRAVITY)),
        ] {
            assert_eq!(of(name), Ok(Some(expected)), "{name}");
        }
        assert_eq!(of("temperature_c"), Ok(None));
        assert_eq!(of("part g"), Ok(None));
        for (name, part) in [
            ("acceleration left", "acceleration_g"),
            ("speed", "speed_km_per_h"),
            ("odometer", "odometer_m"),
            ("time", "time_s"),
        ] {
            assert!(of(name).unwrap_err().to_string().contains(part), "{name}");
        }
    }

    #[test]
    fn units_are_no_part_of_a_name() {
        for unit in ["[m/s²]", "[m/s2]", "(m/s^2)", "ms-2", "_m_per_s2", "[g]", "[m/s/s]"] {
            let heading = Heading::of_name(&format!("Beschleunigung links {unit}"));
            assert_eq!(channel_name(&heading, 0), "links", "{unit}");
        }
        assert_eq!(channel_name(&Heading::of_name("acc 2 [m/s²]"), 0), "2");
    }
}
