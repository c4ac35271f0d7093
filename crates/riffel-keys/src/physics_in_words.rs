//! What the physics refuses, as a message.

use riffel::Error;
use riffel::error::as_typed;

use crate::quantity::named;
use crate::{Message, Words, fixed, number, say};

/// An error of the physics. Those of values and of a vehicle in its curve have every language, others are English.
pub fn physics_in_words(error: &Error) -> Message {
    match *error {
        Error::OutOfRange { quantity, value, unit, rule } => say!(
            out_of_range,
            quantity = named(quantity),
            value = number(as_typed(value)),
            unit = match unit {
                "" => String::new(),
                unit => format!(" {unit}"),
            },
            rule = Words::by_english("Rule", rule)
        ),
        Error::OffTheRails { wheelset, lateral_shift, yaw } => say!(
            off_the_rails,
            wheelset,
            shift = fixed(1e3 * lateral_shift, 0),
            yaw = fixed(1e3 * yaw, 0),
            farthest_shift = fixed(1e3 * riffel::FARTHEST_SHIFT, 0),
            largest_yaw = fixed(1e3 * riffel::LARGEST_YAW, 0)
        ),
        Error::NoEquilibrium { reached } => {
            say!(no_equilibrium_beyond, percent = fixed(100.0 * reached, 0))
        }
        Error::TorqueBeyondFriction { torque, wheelset, largest } => {
            say!(torque_beyond_friction, torque = fixed(torque, 0), wheelset, largest = fixed(largest, 0))
        }
        Error::FullSlip { creepage, saturation_creepage } => {
            say!(beyond_full_slip, creepage = fixed(100.0 * creepage, 4), limit = fixed(100.0 * saturation_creepage, 4))
        }
        ref other => Message::verbatim(other.to_string()),
    }
}

impl From<&Error> for Message {
    fn from(error: &Error) -> Self {
        physics_in_words(error)
    }
}

/// The crates of the physics.
#[cfg(test)]
pub(crate) const PHYSICS: [&str; 3] = ["riffel", "riffel-curving", "riffel-noise"];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Language;

    /// All literals of the physics that begin like a rule.
    fn rules() -> Vec<String> {
        fn collect(folder: &std::path::Path, found: &mut Vec<String>) {
            for entry in std::fs::read_dir(folder).unwrap() {
                let path = entry.unwrap().path();
                if path.is_dir() {
                    collect(&path, found);
                    continue;
                }
                let source = std::fs::read_to_string(&path).unwrap();
                let mut pieces = source.split("\\\n");
                let mut joined = pieces.next().unwrap_or_default().to_owned();
                pieces.for_each(|piece| joined += piece.trim_start());
                let literals = joined.split('"');
                let is_rule = |text: &&str| text.starts_with("must ") || text.starts_with("may ");
                let whole = literals.filter(is_rule).filter(|text| !text.contains('\n'));
                found.extend(whole.map(str::to_owned));
            }
        }
        let crates = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let mut found = Vec::new();
        for physics in PHYSICS {
            collect(&crates.join(physics).join("src"), &mut found);
        }
        found
    }

    #[test]
    fn every_rule_has_its_german() {
        let rules = rules();
        let lacking = |rule: &&String| !Words::by_english("Rule", rule).is_in(Language::German);
        let lacking: Vec<_> = rules.iter().filter(lacking).collect();
        assert!(lacking.is_empty(), "no German of {lacking:#?}");
        assert!(rules.len() > 80, "{}", rules.len());
    }

    #[test]
    fn the_english_is_that_of_the_physics() {
        let errors = [
            Error::OutOfRange {
                quantity: "wheel load",
                value: -1234.5,
                unit: "N",
                rule: "must be finite and greater than zero",
            },
            Error::OutOfRange { quantity: "Poisson ratio", value: 0.7, unit: "", rule: "must lie between -1 and 0.5" },
            Error::OffTheRails { wheelset: 2, lateral_shift: -0.031, yaw: 0.012 },
            Error::NoEquilibrium { reached: 0.42 },
            Error::TorqueBeyondFriction { torque: 22_000.0, wheelset: 1, largest: 18_400.0 },
            Error::FullSlip { creepage: 0.02, saturation_creepage: 0.0031 },
        ];
        for error in errors {
            let message = physics_in_words(&error);
            assert_eq!(message.to_string(), error.to_string());
            assert_ne!(message.text(Language::German), error.to_string());
        }
    }
}
