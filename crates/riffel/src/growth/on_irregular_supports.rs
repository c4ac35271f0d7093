//! Growth along a stretch of supports that do not stand at equal distances.

use std::sync::Arc;

use num_complex::Complex64;

use crate::Error;
use crate::feedback::Loop;
use crate::receptance::{IrregularTrack, Receptance, Uncoupled};

/// Growth of one wave at every place of a stretch, as if the wheel stayed there, beside that over a bay of equal supports.
///
/// Quasi-static in position, as [`Bay`](super::Bay) is: for wavelengths much shorter than the spacing, and a track that forgets in a small part of
/// a bay. Of a stretch of N supports the outer two bays at either end are left out, which have equal supports beside them.
///
/// Method: 24 places to a mean bay; the mean over a bay of equal supports is that of [`Bay`](super::Bay) to 10⁻³ at the pinned-pinned
/// resonance of a rail with a loss factor of 0.01, 10⁻⁴ elsewhere (test `bay_mean`).
#[derive(Debug, Clone, PartialEq)]
pub struct GrowthOnIrregularSupports {
    /// Places from where the first support of the stretch stood \[m\].
    pub places: Vec<f64>,
    /// Growth rate per passage at each.
    pub growth_rates: Vec<f64>,
    /// Growth rate per passage over a bay of equal supports, from one of them on.
    pub even: Vec<f64>,
    /// Where the supports of the stretch stand \[m\].
    pub supports: Vec<f64>,
}

impl GrowthOnIrregularSupports {
    /// Fewest supports of a stretch: two bays at either end are left out.
    pub const LEAST_SUPPORTS: usize = 8;

    /// Growth of a wave \[m\] at a speed \[m/s\]. `feedback` gives wheel, contact and wear; its track is not used.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for fewer than 8 supports and for a wavelength or speed that is not positive.
    pub fn new(feedback: &Loop, track: &IrregularTrack, wavelength: f64, speed: f64) -> Result<Self, Error> {
        const TO_A_BAY: usize = 24;
        const LEFT_OUT: usize = 2;
        Error::unless_positive("wavelength", wavelength, "m")?;
        Error::unless_positive("speed", speed, "m/s")?;
        let supports = track.places();
        if supports.len() < Self::LEAST_SUPPORTS {
            return Err(Error::OutOfRange {
                quantity: "number of supports of the stretch",
                value: supports.len() as f64,
                unit: "",
                rule: "must be at least 8",
            });
        }
        let angular_frequency = std::f64::consts::TAU * speed / wavelength;
        let growth = |receptance: Complex64| {
            let track = Uncoupled { vertical: Some(Arc::new(Known(receptance))), ..Uncoupled::default() };
            let feedback = feedback.clone().with_track(Arc::new(track));
            feedback.at(wavelength, speed).growth_rate
        };
        let waves = track.waves(angular_frequency);
        let even = track.even().floquet_waves(angular_frequency);
        let bays = supports.len() - 1 - 2 * LEFT_OUT;
        let (from, to) = (supports[LEFT_OUT], supports[supports.len() - 1 - LEFT_OUT]);
        let step = (to - from) / (bays * TO_A_BAY) as f64;
        // In the middle of each step, so that none counts twice.
        let places: Vec<f64> = (0..bays * TO_A_BAY).map(|index| from + step * (index as f64 + 0.5)).collect();
        Ok(Self {
            growth_rates: places.iter().map(|&place| growth(waves.receptance(place, place))).collect(),
            even: (0..TO_A_BAY)
                .map(|index| {
                    let place = track.even().spacing() * index as f64 / TO_A_BAY as f64;
                    growth(even.receptance(place, place))
                })
                .collect(),
            places,
            supports: supports.to_vec(),
        })
    }
}

/// A track of which the receptance at one frequency is known.
struct Known(Complex64);

impl Receptance for Known {
    fn receptance(&self, _angular_frequency: f64, _speed: f64) -> Complex64 {
        self.0
    }
}
