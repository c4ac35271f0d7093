//! The physics of a case for other numbers of some keys, without its text.

use riffel::wheelset::RigidInertia;
use riffel::{Loop, MeanWear};
use riffel_keys::CaseError;
use riffel_keys::quantity::Quantity;
use toml::Value;

use crate::file::{CaseFile, FromCurve};
use crate::keys::checked_keys::CheckedKeys;
use crate::keys::substitutes::Substitutes;
use crate::parts::window::Window;
use crate::{Case, CaseKey, Track};

/// Loop and track of a case.
#[derive(Clone)]
pub struct LoopOnTrack {
    /// The loop.
    pub feedback: Loop,
    /// The track, vertically.
    pub track: Track,
    /// Mass of an axle of the bogie \[kg\]; `None` if the load of the wheel tells it.
    axle_mass: Option<f64>,
}

/// Set a number of a file of keys; none for a key that is not known here.
type Write = fn(&mut CaseFile, f64) -> Option<()>;

/// Keys on which no other key depends but the inertia of a wheel.
const NUMBERS: [(&str, Write); 13] = [
    ("track.pad.stiffness", |file, value| {
        file.track.pad.as_mut()?.stiffness = Some(Quantity::new(value));
        Some(())
    }),
    ("track.pad.loss_factor", |file, value| {
        file.track.pad.as_mut()?.loss_factor = Some(Quantity::new(value));
        Some(())
    }),
    ("track.ballast.stiffness", |file, value| {
        file.track.ballast.as_mut()?.stiffness = Some(Quantity::new(value));
        Some(())
    }),
    ("track.ballast.loss_factor", |file, value| {
        file.track.ballast.as_mut()?.loss_factor = Some(Quantity::new(value));
        Some(())
    }),
    ("track.sleeper.mass", |file, value| {
        file.track.sleeper.as_mut()?.mass = Some(Quantity::new(value));
        Some(())
    }),
    ("track.support_spacing", |file, value| {
        file.track.support_spacing = Some(Quantity::new(value));
        Some(())
    }),
    ("rail.loss_factor", |file, value| {
        file.rail.loss_factor = Some(Quantity::new(value));
        Some(())
    }),
    ("wheel.mass", |file, value| {
        let before = file.wheel.mass.replace(Quantity::new(value))?;
        // An inertia that followed the mass follows it still.
        let radius = file.wheel.rolling_radius.si();
        let reduced = |mass: f64| Quantity::new(RigidInertia::reduced_inertia(mass, radius));
        let inertia = file.wheel.inertia.as_mut()?;
        if *inertia == reduced(before.si()) {
            *inertia = reduced(value);
        }
        Some(())
    }),
    ("contact.friction", |file, value| {
        file.contact.friction = Quantity::new(value);
        Some(())
    }),
    ("contact.tractive_ratio", |file, value| {
        file.contact.tractive_ratio.as_mut()?;
        file.contact.tractive_ratio = Some(Quantity::new(value));
        Some(())
    }),
    ("contact.normal_load", |file, value| {
        file.contact.normal_load = Quantity::new(value);
        Some(())
    }),
    ("contact.transverse_radius", |file, value| {
        file.contact.transverse_radius = Quantity::new(value);
        Some(())
    }),
    ("wear.coefficient", |file, value| {
        file.wear.coefficient = Quantity::new(value);
        Some(())
    }),
];

impl Case {
    /// The number that the case has for a key, in SI; none for a key without one.
    pub fn number(&self, key: &str) -> Option<f64> {
        let table = toml::Table::try_from(&self.file).ok()?;
        let inner = |value: Value, part: &str| value.get(part).cloned();
        match key.split('.').try_fold(Value::Table(table), inner)? {
            Value::Float(number) => Some(number),
            // With its unit.
            Value::String(text) => CaseKey::at(key)?.quantity?.read(&text).ok(),
            _ => None,
        }
    }

    /// Loop and track of the case with other numbers of some keys, in SI. They are those of
    /// [`with`](Self::with); the numbers must lie in the ranges of their keys, which are not looked at again
    /// for those that are set without the text: some twenty times as fast.
    ///
    /// # Errors
    /// Errors of [`edit`](Self::edit).
    pub fn with_numbers(&self, numbers: &[(&str, f64)]) -> Result<LoopOnTrack, CaseError> {
        if let Some(keys) = self.keys_with_numbers(numbers) {
            let axle_mass = keys.axle_mass();
            let (feedback, track) = keys.loop_and_track()?;
            return Ok(LoopOnTrack { feedback, track, axle_mass });
        }
        let Self { feedback, track, keys, .. } = self.settled(numbers)?;
        Ok(LoopOnTrack { feedback, track, axle_mass: keys.axle_mass() })
    }

    /// The case with other numbers of keys that its mean state may follow from, without the remarks that take time.
    ///
    /// # Errors
    /// Errors of [`edit`](Self::edit).
    pub fn settled(&self, numbers: &[(&str, f64)]) -> Result<Self, CaseError> {
        let numbers = numbers.iter();
        let settings: Vec<_> = numbers.map(|(key, value)| ((*key).to_owned(), Value::Float(*value))).collect();
        let given = Substitutes { quick: true, wear: None, ..self.keys.given.clone() };
        let (text, folder) = (self.text_with(&[&settings])?, self.keys.folder.as_deref());
        Self::of_text(text, folder, given, Window::BesideAnother)
    }

    /// Whether the mean state is that of a vehicle in a curve, whose equilibrium takes hundredths of a second.
    pub fn is_in_curve(&self) -> bool {
        self.keys.mean.wheel().is_some()
    }

    /// Whether a key acts beside the mean state: a vehicle in a curve stands as before, whatever its number.
    pub fn is_beside_mean_state(key: &str) -> bool {
        let beside = ["rail.loss_factor", "wear.coefficient"];
        key.starts_with("track.") || beside.contains(&key)
    }

    /// Which contact of which curve the mean state is that of, the curve here or in another file; none without one.
    pub fn from_curve(&self) -> Option<FromCurve> {
        self.keys.mean.wheel().map(|wheel| wheel.from.clone())
    }

    /// Names of the rail that a mean state from a curve is of: which one of the curve, and which side; none without such a state, where
    /// both rails are alike.
    pub fn rail_in_curve(&self) -> Vec<&'static str> {
        let Some(from) = self.from_curve() else {
            return Vec::new();
        };
        let wheelset = self.file.wheelset.as_ref();
        let side = wheelset.map(|wheelset| wheelset.rail.of_track().name());
        std::iter::once(from.rail.name()).chain(side).collect()
    }

    /// `None` if a key is not known here, or a curve, a wheelset or the wear may depend on one.
    fn keys_with_numbers(&self, numbers: &[(&str, f64)]) -> Option<CheckedKeys> {
        let file = &self.keys.file;
        let dependent = file.wheelset.is_some()
            || self.is_in_curve()
            || file.curve.is_some()
            || self.unfilled.keys.has("contact.profiles")
            || file.profiles.is_some()
            || file.wear.measured.is_some();
        if dependent && !numbers.iter().all(|(key, _)| Self::is_beside_mean_state(key)) {
            return None;
        }
        let mut keys = self.keys.clone();
        let by_preset = |key: &str| self.keys.text.filled_in.contains(key);
        for (key, value) in numbers {
            // Where a key is written, a preset leaves out what goes with it.
            let file = &mut keys.file;
            match *key {
                "wheel.mass" if by_preset("wheel.inertia") => {
                    let radius = file.wheel.rolling_radius.si();
                    let own = RigidInertia::reduced_inertia(file.wheel.mass?.si(), radius);
                    file.wheel.inertia = Some(Quantity::new(own));
                }
                "track.pad.loss_factor" if by_preset("track.pad.damping") => {
                    file.track.pad.as_mut()?.damping = None;
                }
                "track.ballast.loss_factor" if by_preset("track.ballast.damping") => {
                    file.track.ballast.as_mut()?.damping = None;
                }
                _ => {}
            }
            let (_, write) = NUMBERS.iter().find(|(known, _)| known == key)?;
            write(&mut keys.file, *value)?;
        }
        Some(keys)
    }
}

impl LoopOnTrack {
    /// Loops and weights of [`Case::places`].
    pub fn places(&self) -> Vec<(Loop, f64)> {
        self.track.places(&self.feedback)
    }

    /// Mean wear of the rail per axle, in the mean over its places.
    pub fn mean_wear(&self) -> MeanWear {
        let mut all = MeanWear { depth: 0.0, axle_mass: 0.0, bounds_growth: true };
        for (feedback, weight) in self.places() {
            let own = feedback.mean_wear();
            all.depth += weight * own.depth;
            all.axle_mass += weight * own.axle_mass;
            all.bounds_growth &= own.bounds_growth;
        }
        all.under_axle(self.axle_mass)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::METRO_CASE;

    /// Every key that is set without the text gives the numbers of the text, to the last bit.
    #[test]
    fn numbers_are_those_of_settings() {
        let case = Case::parse("metro", METRO_CASE, &[]).unwrap();
        let missing = |key: &&str| case.number(key).is_none();
        let keys = NUMBERS.map(|(key, _)| key).into_iter();
        // A slab on fastenings whose damping is viscous.
        let no_sleepers =
            ["track.pad.loss_factor", "track.ballast.stiffness", "track.ballast.loss_factor", "track.sleeper.mass"];
        assert_eq!(keys.filter(missing).collect::<Vec<&str>>(), no_sleepers);
        for (key, _) in NUMBERS {
            let Some(number) = case.number(key) else {
                continue;
            };
            let number = 1.07 * number;
            assert!(case.keys_with_numbers(&[(key, number)]).is_some(), "{key}");
            let quick = case.with_numbers(&[(key, number)]).unwrap();
            let settings = [(key.to_owned(), Value::Float(number))];
            let slow = case.with(&settings[..]).unwrap();
            for (wavelength, speed) in [(0.05, 20.0), (0.08, 35.0)] {
                let rate = |feedback: &Loop| feedback.complex_growth_rate(wavelength, speed);
                assert_eq!(rate(&quick.feedback), rate(&slow.feedback), "{key}");
                assert_ne!(rate(&quick.feedback), rate(&case.feedback), "{key}");
            }
        }
    }

    /// In a curve, too: keys beside the mean state without the text, others by it, one after the other as together.
    #[test]
    fn numbers_in_a_curve_are_those_of_settings() {
        let curve = include_str!("../../cases/metro-curve.toml");
        let case = Case::parse("curve", curve, &[]).unwrap().sharing_profiles();
        assert!(case.is_in_curve());
        let rate = |feedback: &Loop| feedback.complex_growth_rate(0.05, 12.5);
        let friction = ("contact.friction", 0.35);
        let settled = case.settled(&[friction]).unwrap();
        let set = |(key, value): (&str, f64)| (key.to_owned(), Value::Float(value));
        let base = case.with(&[set(friction)][..]).unwrap();
        assert_eq!(rate(&settled.feedback), rate(&base.feedback));
        assert_ne!(rate(&base.feedback), rate(&case.feedback));
        let beside = NUMBERS
            .into_iter()
            .filter(|(key, _)| Case::is_beside_mean_state(key) && case.keys_with_numbers(&[(key, 1.0)]).is_some());
        let mut count = 0;
        for (key, _) in beside {
            let Some(number) = case.number(key) else {
                continue;
            };
            let number = (key, 1.07 * number);
            let slow = case.with(&[set(friction), set(number)][..]).unwrap();
            let at_once = case.with_numbers(&[friction, number]).unwrap();
            let [after, at_once] =
                [settled.with_numbers(&[number]).unwrap(), at_once].map(|found| rate(&found.feedback));
            assert_eq!(after, rate(&slow.feedback), "{key}");
            assert_eq!(at_once, after, "{key}");
            assert_ne!(after, rate(&base.feedback), "{key}");
            count += 1;
        }
        assert_eq!(count, 4);
    }
}
