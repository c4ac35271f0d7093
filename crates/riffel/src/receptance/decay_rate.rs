//! How fast vibration dies out along a track.

use std::f64::consts::{LN_10, TAU};

use super::CrossReceptance;

/// Places of the response in bays from the force, EN 15461:2008+A1:2010, Figure 2.
const BAYS: [f64; 29] = [
    0.0, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 1.75, 2.0, 2.25, 2.5, 3.0, 3.5, 4.0, 5.0, 6.0, 7.0, 8.0, 10.0, 12.0, 16.0,
    20.0, 24.0, 30.0, 36.0, 42.0, 48.0, 54.0, 66.0,
];
/// Length of a bay \[m\] where supports are continuous.
const NOMINAL_BAY: f64 = 0.6;
/// Frequencies in a band, evenly spaced as the lines of a Fourier transform.
const LINES: u32 = 64;

/// Track decay rate of one one-third-octave band.
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct DecayRate {
    /// Nominal centre frequency \[Hz\].
    pub nominal_frequency: f64,
    /// Decay rate \[dB/m\].
    pub decay_rate: f64,
    /// True where the grid is too short for so low a rate, which then is an upper bound: below twice
    /// (10/ln 10)/x_max, 0.22 dB/m for bays of 0.6 m.
    pub upper_bound: bool,
}

impl DecayRate {
    /// Nominal centre frequencies \[Hz\] of the bands that EN 15461 asks for.
    pub const NOMINAL_FREQUENCIES: [f64; 18] = [
        100.0, 125.0, 160.0, 200.0, 250.0, 315.0, 400.0, 500.0, 630.0, 800.0, 1000.0, 1250.0, 1600.0, 2000.0, 2500.0,
        3150.0, 4000.0, 5000.0,
    ];

    /// Track decay rates of EN 15461:2008+A1:2010 in the bands 100–5000 Hz.
    ///
    /// DR = (10/ln 10) / Σ (|A(x_n)|²/|A(x₀)|²) Δx_n with the accelerance A between x₀ in the middle
    /// of a bay and 29 places up to 66 bays away, Δx_n from halfway to the place before to halfway to
    /// the next; the first begins at x₀, the last is as long behind as before. The standard leaves
    /// open how a band is formed: here |A|² is averaged over 64 frequencies in the exact base-ten
    /// band before the sum. Averaging mobilities instead changes a band by up to 6 %.
    ///
    /// Cost: 33 000 receptances at 1152 frequencies, some milliseconds for a periodic track.
    pub fn of_track(track: &dyn CrossReceptance) -> Vec<Self> {
        let bay = track.support_spacing().unwrap_or(NOMINAL_BAY);
        (20..)
            .zip(Self::NOMINAL_FREQUENCIES)
            .map(|(band, nominal_frequency)| {
                let centre = 10f64.powf(f64::from(band) / 10.0);
                let decay_rate = Self::of_band(track, centre, LINES);
                let farthest = BAYS[BAYS.len() - 1] * bay;
                Self { nominal_frequency, decay_rate, upper_bound: decay_rate < 2.0 * (10.0 / LN_10) / farthest }
            })
            .collect()
    }

    /// Decay rate \[dB/m\] as [`of_track`](Self::of_track) in the one-third octave about a centre \[Hz\], |A|² averaged over a
    /// number of frequencies: 16 in place of its 64 change a band by 0.2 %, next to the pinned-pinned frequency by 1 %.
    pub fn of_band(track: &dyn CrossReceptance, centre: f64, lines: u32) -> f64 {
        let bay = track.support_spacing().unwrap_or(NOMINAL_BAY);
        let half_band = 10f64.powf(0.05);
        let (low, high) = (centre / half_band, centre * half_band);
        let from = 0.5 * bay;
        let places = BAYS.map(|bays| from + bays * bay);
        // |A|² up to a factor that all places share.
        let mut energies = [0.0; BAYS.len()];
        for line in 0..lines {
            let share = (f64::from(line) + 0.5) / f64::from(lines);
            let w = TAU * (low + (high - low) * share);
            let receptances = track.cross_receptances(w, from, &places);
            for (energy, receptance) in energies.iter_mut().zip(receptances) {
                *energy += w.powi(4) * receptance.norm_sqr();
            }
        }
        let sum: f64 =
            one_sided_places(1.0).zip(energies).map(|((_, length), energy)| energy / energies[0] * length * bay).sum();
        10.0 / LN_10 / sum
    }
}

/// Places of the response to one side of the force \[m\], with the length of rail \[m\] that each stands for, for bays of
/// the given length.
pub fn one_sided_places(bay: f64) -> impl Iterator<Item = (f64, f64)> {
    (0..BAYS.len()).map(move |n| {
        let before = n.checked_sub(1).map(|before| BAYS[n] - BAYS[before]);
        let after = BAYS.get(n + 1).map(|after| after - BAYS[n]);
        let length = match (before, after) {
            (Some(before), Some(after)) => 0.5 * (before + after),
            (None, Some(after)) => 0.5 * after,
            (before, None) => before.unwrap_or(0.0),
        };
        (BAYS[n] * bay, length * bay)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Complex64, Receptance};

    /// A track whose response falls by the same share each metre.
    struct Exponential {
        decibels_per_metre: f64,
    }

    impl Receptance for Exponential {
        fn receptance(&self, _angular_frequency: f64, _speed: f64) -> Complex64 {
            Complex64::ONE
        }
    }

    impl CrossReceptance for Exponential {
        fn cross_receptance(&self, _angular_frequency: f64, from: f64, to: f64) -> Complex64 {
            Complex64::from(10f64.powf(-self.decibels_per_metre * (to - from).abs() / 20.0))
        }

        fn support_spacing(&self) -> Option<f64> {
            None
        }

        fn under_load_at(&self, _place: f64) -> std::sync::Arc<dyn Receptance> {
            std::sync::Arc::new(Self { ..*self })
        }
    }

    /// The rate of one exponential comes back: to 2 % at rates that the grid resolves near its
    /// beginning, where steps are 0.15 m, and reaches at its end, where they are 7 m.
    #[test]
    fn one_wave_has_its_own_rate() {
        for expected in [1.0, 3.0, 10.0] {
            let track = Exponential { decibels_per_metre: expected };
            let rates = DecayRate::of_track(&track);
            assert_eq!(rates.len(), 18);
            assert!((rates[0].decay_rate / expected - 1.0).abs() < 0.02, "{rates:?}");
            assert!(!rates[0].upper_bound);
        }
        let hardly = Exponential { decibels_per_metre: 0.05 };
        assert!(DecayRate::of_track(&hardly)[0].upper_bound);
    }
}
