//! Whether two accounts of how far a train ran agree.

use riffel_keys::{Message, fixed, say};

use super::head::PlaceBy;
use crate::refusal::Refusal;

/// Share by which they may differ: wheels are worn, and slip, by some per cent.
const AGREED: f64 = 0.05;
/// Share that no wheel makes up: one of the two is in another unit, or is another thing.
const CONTRARY: f64 = 0.25;

/// An odometer or speeds beside what the place is told by.
#[derive(Debug)]
pub(super) struct Witness {
    place: PlaceBy,
    by: PlaceBy,
    /// Samples per second \[Hz\].
    rate: f64,
    /// Last reading of the odometer \[m\], if it is one.
    odometer: Option<f64>,
    /// Samples of which both speak.
    samples: f64,
    /// Length that each says \[m\].
    lengths: [f64; 2],
    /// Largest step of an odometer \[m\], by which a length may be off.
    step: f64,
}

impl Witness {
    pub(super) fn new(place: PlaceBy, by: PlaceBy, rate: f64) -> Self {
        Self { place, by, rate, odometer: None, samples: 0.0, lengths: [0.0; 2], step: 0.0 }
    }

    /// One sample further by the place \[m\], with what the witness says; behind a gap nothing is compared.
    pub(super) fn hear(&mut self, length: f64, said: f64, gap: bool) {
        if !said.is_finite() {
            return;
        }
        let own = match self.by {
            PlaceBy::Odometer => self.odometer.replace(said).map_or(0.0, |last| said - last),
            _ => said / self.rate,
        };
        if gap {
            return;
        }
        self.samples += 1.0;
        self.lengths[0] += length;
        self.lengths[1] += own;
        self.step = match (self.place, self.by) {
            (PlaceBy::Odometer, _) => self.step.max(length),
            _ => self.step.max(own.abs()),
        };
    }

    /// What is to be said of the two.
    ///
    /// # Errors
    /// A sentence where they contradict each other and nobody has said which holds.
    pub(super) fn judged(self) -> Result<Option<Message>, Refusal> {
        let [length, other] = self.lengths;
        let longer = length.max(other);
        let off = (length - other).abs() / longer;
        // A step at either end is no contradiction.
        let rounding = 2.0 * self.step / longer;
        if longer <= 0.0 || off.is_nan() || off <= AGREED + rounding {
            return Ok(None);
        }
        let words = |by: PlaceBy, length: f64| {
            let speed = fixed(3.6 * length * self.rate / self.samples, 1);
            match by {
                PlaceBy::Odometer => say!(odometer_makes, speed),
                PlaceBy::Speed => say!(speeds_make, speed),
                PlaceBy::Constant(_) => say!(given_speed_says, speed),
            }
        };
        let (one, other) = (words(self.place, length), words(self.by, other));
        let sentence = say!(but_other_says, one, other);
        let is_given = matches!(self.place, PlaceBy::Constant(_));
        if off > CONTRARY + rounding && !is_given {
            return Err(Refusal {
                line: None,
                message: say!(one_is_wrong, sentence),
                help: Some(say!(take_the_wrong_one_out)),
            });
        }
        Ok(Some(say!(first_is_taken, sentence)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is said of an odometer that counts whole metres, and of speeds, at 20 m/s and 1 kHz for some seconds.
    fn judged(factor: f64, seconds: u32, place: PlaceBy) -> Result<Option<String>, String> {
        let mut witness = Witness::new(place, PlaceBy::Speed, 1e3);
        let at = |n: u32| match place {
            PlaceBy::Odometer => (0.02 * factor * f64::from(n)).floor(),
            _ => 0.02 * factor * f64::from(n),
        };
        for n in 0..1000 * seconds {
            witness.hear(at(n + 1) - at(n), 20.0, false);
        }
        let said = witness.judged().map_err(|refusal| refusal.message.to_string())?;
        Ok(said.map(|said| said.to_string()))
    }

    #[test]
    fn a_worn_wheel_is_no_contradiction_and_a_factor_of_two_is() {
        assert_eq!(judged(0.97, 20, PlaceBy::Odometer), Ok(None));
        let said = judged(0.9, 20, PlaceBy::Odometer).unwrap().unwrap();
        assert!(said.starts_with("the odometer makes 64.8 km/h"), "{said}");
        assert!(said.ends_with("the speeds make 72.0 km/h in the mean; the first is taken"), "{said}");
        for factor in [0.5, 1.609, 2.0, 3.6] {
            let refused = judged(factor, 20, PlaceBy::Odometer).unwrap_err();
            assert!(refused.contains("one of the two is wrong"), "{refused}");
            // Whoever says the speed has said which holds.
            let said = judged(factor, 20, PlaceBy::Constant(20.0 * factor));
            assert!(said.unwrap().unwrap().starts_with("--speed says"));
        }
        // In a second whole metres tell the speed to a tenth.
        assert_eq!(judged(0.9, 1, PlaceBy::Odometer), Ok(None));
    }
}
