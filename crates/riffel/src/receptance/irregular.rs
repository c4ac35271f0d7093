//! Rail on supports of which a stretch does not stand at equal distances.

use num_complex::Complex64;
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::SeedableRng;
use riffel_numerics::elimination::inverse;
use riffel_numerics::random_numbers::normal;

use super::periodic::Station;
use super::{Beam, FloquetWaves, PeriodicTrack, Waveguide};
use crate::Error;

/// An infinite rail on equal supports every d, of which some N side by side have moved along the rail, such as the sleepers of a
/// track as it was laid.
///
/// Each support of the stretch is taken from its place nd (a support of the dynamic stiffness −κ is put beside it) and
/// put where it stands (+κ). With the 2N places y and the receptance H₀ of the [`PeriodicTrack`],
///
/// H(x, x₀) = H₀(x, x₀) − h(x)ᵀ M⁻¹ h(x₀), h_a(x) = H₀(x, y_a), M_ab = H₀(y_a, y_b) ± δ_ab/κ.
///
/// Method: exact, one inverse of 2N × 2N for each frequency. Accuracy: 10⁻⁹ of H₀ at mid-span (test `against_all_supports`).
/// Cost: 2 ms a frequency for N = 40, and 10 µs a place.
///
/// Source: superposition, as for Mead's periodic track; random sleeper spacing as in Wu & Thompson (2000), *The influence of random
/// sleeper spacing and ballast stiffness on the vibration behaviour of railway track*, Acustica 86. Range of validity: that of the periodic track; equal
/// supports.
#[derive(Debug, Clone, PartialEq)]
pub struct IrregularTrack<R = Beam> {
    even: PeriodicTrack<R>,
    places: Vec<f64>,
}

impl<R: Waveguide> IrregularTrack<R> {
    /// Most supports of a stretch.
    pub const MOST_SUPPORTS: usize = 200;

    /// Supports 0 … N − 1 of a periodic track moved to these places \[m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for no support or more than 200, and unless they stay in their order, those before and after them included.
    pub fn new(even: PeriodicTrack<R>, places: Vec<f64>) -> Result<Self, Error> {
        check_count(places.len())?;
        let ends = [-even.spacing(), places.len() as f64 * even.spacing()];
        let before = std::iter::once(&ends[0]).chain(&places);
        let after = places.iter().chain(std::iter::once(&ends[1]));
        if let Some((_, after)) = before.zip(after).find(|(before, after)| {
            let distance = *after - *before;
            distance.is_nan() || distance <= 0.0
        }) {
            return Err(Error::OutOfRange {
                quantity: "place of a support",
                value: *after,
                unit: "m",
                rule: "must lie after the one before",
            });
        }
        Ok(Self { even, places })
    }

    /// N supports at distances that are drawn: normal, independent, with the spacing of the track as their mean and this standard
    /// deviation \[m\], none farther than three of it from the mean; the same for the same seed on every machine. They fill the stretch between the
    /// equal ones, so that what their sum is off is taken off all alike.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for no support or more than 200, and unless the deviation is positive and at most a quarter of the spacing.
    pub fn drawn(even: PeriodicTrack<R>, deviation: f64, supports: usize, seed: u64) -> Result<Self, Error> {
        const FARTHEST: f64 = 3.0;
        let spacing = even.spacing();
        check_count(supports)?;
        if !(deviation > 0.0 && deviation <= 0.25 * spacing) {
            return Err(Error::OutOfRange {
                quantity: "standard deviation of the support spacing",
                value: deviation,
                unit: "m",
                rule: "must be above zero and at most a quarter of the spacing",
            });
        }
        let mut random = Xoshiro256PlusPlus::seed_from_u64(seed);
        let mut drawn: Vec<f64> = Vec::with_capacity(supports + 1);
        while drawn.len() <= supports {
            let number = normal(&mut random);
            if number.abs() <= FARTHEST {
                drawn.push(number);
            }
        }
        let count = drawn.len() as f64;
        let mean = drawn.iter().sum::<f64>() / count;
        // What the mean takes of the variance.
        let scale = deviation * (count / (count - 1.0)).sqrt();
        let mut place = -spacing;
        let mut places = Vec::with_capacity(supports);
        for number in &drawn[..supports] {
            place += spacing + scale * (number - mean);
            places.push(place);
        }
        Self::new(even, places)
    }

    /// Where the supports of the stretch stand \[m\].
    pub fn places(&self) -> &[f64] {
        &self.places
    }

    /// The track if they stood at equal distances.
    pub fn even(&self) -> &PeriodicTrack<R> {
        &self.even
    }

    /// The waves at the angular frequency ω > 0 \[rad/s\].
    pub fn waves(&self, angular_frequency: f64) -> IrregularWaves {
        let even = self.even.floquet_waves(angular_frequency);
        let give_way = self.even.support_stiffness(angular_frequency).inv();
        let spacing = self.even.spacing();
        let from = (0..self.places.len()).map(|index| index as f64 * spacing);
        let stations: Vec<Station> = from.chain(self.places.iter().copied()).map(|place| even.station(place)).collect();
        let matrix = stations
            .iter()
            .enumerate()
            .map(|(row, one)| {
                let entry = |(column, other): (usize, &Station)| {
                    let own = match (row == column, row < self.places.len()) {
                        (false, _) => Complex64::ZERO,
                        (true, true) => -give_way,
                        (true, false) => give_way,
                    };
                    own + even.between(one, other)
                };
                stations.iter().enumerate().map(entry).collect()
            })
            .collect();
        IrregularWaves { even, inverse: inverse(matrix), stations }
    }
}

/// An irregular track at one frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct IrregularWaves {
    even: FloquetWaves,
    stations: Vec<Station>,
    inverse: Vec<Vec<Complex64>>,
}

impl IrregularWaves {
    /// Displacement at `to` per force at `from` \[m/N\], both \[m\] from where the first support of the stretch stood.
    pub fn receptance(&self, from: f64, to: f64) -> Complex64 {
        let stations = [from, to].map(|place| self.even.station(place));
        let reach = |station: &Station| -> Vec<Complex64> {
            let all = self.stations.iter();
            all.map(|other| self.even.between(station, other)).collect()
        };
        let [from, to] = [reach(&stations[0]), reach(&stations[1])];
        let moved: Complex64 = self
            .inverse
            .iter()
            .zip(&to)
            .map(|(row, to)| {
                let force: Complex64 = row.iter().zip(&from).map(|(one, other)| one * other).sum();
                to * force
            })
            .sum();
        self.even.between(&stations[0], &stations[1]) - moved
    }
}

fn check_count(supports: usize) -> Result<(), Error> {
    const MOST: usize = IrregularTrack::<Beam>::MOST_SUPPORTS;
    if (1..=MOST).contains(&supports) {
        return Ok(());
    }
    Err(Error::OutOfRange {
        quantity: "number of supports of the stretch",
        value: supports as f64,
        unit: "",
        rule: "must be between 1 and 200",
    })
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;
    use crate::fixtures::steel;
    use crate::receptance::{Layer, ShearSection, Support};

    const SPACING: f64 = 0.6;

    fn even() -> PeriodicTrack {
        let steel = steel();
        let shear = ShearSection {
            area: 7.67e-3,
            shear_coefficient: 0.4,
            shear_modulus: steel.shear_modulus(),
            density: 7850.0,
        };
        let rail = Beam::timoshenko(steel, 3.04e-5, 60.2, shear).unwrap();
        let pad = Layer::new(300e6, 40e3).unwrap();
        let ballast = Layer::new(80e6, 80e3).unwrap();
        let support = Support::two_layer(pad, 150.0, ballast).unwrap();
        let rail = rail.with_loss_factor(0.02).unwrap();
        PeriodicTrack::new(rail, support, SPACING).unwrap()
    }

    /// A free rail that is held by 140 supports on either side of the stretch and by those in it, solved at once.
    #[test]
    fn against_all_supports() {
        const BESIDE: i32 = 140;
        let track = IrregularTrack::drawn(even(), 0.05, 6, 3).unwrap();
        let moved = |number: i32| match usize::try_from(number) {
            Ok(index) if index < 6 => track.places()[index],
            _ => f64::from(number) * SPACING,
        };
        let supports: Vec<f64> = (-BESIDE..6 + BESIDE).map(moved).collect();
        let (rail, support, _) = even().parts();
        for hertz in [480.0, 1063.0, 2000.0] {
            let w = TAU * hertz;
            let free = rail.waves(w, Complex64::ZERO);
            let green = |x: f64| -> Complex64 {
                let waves = free.as_slice().iter();
                waves.map(|wave| wave.amplitude * (-wave.propagation * x.abs()).exp()).sum()
            };
            let give_way = support.dynamic_stiffness(w).inv();
            let matrix = supports.iter().map(|one| {
                let entry = |other: &f64| {
                    let own = if one == other { give_way } else { Complex64::ZERO };
                    green(one - other) + own
                };
                supports.iter().map(entry).collect()
            });
            let inverse = inverse(matrix.collect());
            let waves = track.waves(w);
            for (from, to) in [(1.3, 1.3), (0.0, 2.2), (3.4, 0.7), (-0.4, 3.9)] {
                let mut expected = green(to - from);
                for (row, one) in inverse.iter().zip(&supports) {
                    for (entry, other) in row.iter().zip(&supports) {
                        expected -= green(to - one) * entry * green(other - from);
                    }
                }
                let got = waves.receptance(from, to);
                let error = (got - expected).norm() / green(0.0).norm();
                assert!(error < 1e-9, "{hertz} Hz, {from} to {to}: {error:e}");
            }
        }
    }

    /// Supports that have not moved are the periodic track; and what is drawn has the mean and about the deviation it was asked for.
    #[test]
    fn even_and_drawn() {
        let places = (0..5).map(|index| f64::from(index) * SPACING).collect();
        let track = IrregularTrack::new(even(), places).unwrap();
        let w = TAU * 700.0;
        let (got, expected) = (track.waves(w).receptance(0.7, 1.1), even().floquet_waves(w).receptance(0.7, 1.1));
        assert!((got - expected).norm() < 1e-12 * expected.norm());

        let track = IrregularTrack::drawn(even(), 0.03, 199, 1).unwrap();
        let ends = [-SPACING, 199.0 * SPACING];
        let all: Vec<f64> = [&ends[..1], track.places(), &ends[1..]].concat();
        let square: f64 = all.windows(2).map(|pair| (pair[1] - pair[0] - SPACING).powi(2)).sum();
        // Its own scatter is 5 %.
        let deviation = (square / 199.0).sqrt();
        assert!((deviation / 0.03 - 1.0).abs() < 0.15, "{deviation}");
        let again = IrregularTrack::drawn(even(), 0.03, 199, 1).unwrap();
        assert_eq!(track, again);
    }

    #[test]
    fn what_is_no_stretch_is_refused() {
        assert!(IrregularTrack::new(even(), Vec::new()).is_err());
        assert!(IrregularTrack::new(even(), vec![0.5, 0.4]).is_err());
        assert!(IrregularTrack::new(even(), vec![0.0, 1.2]).is_err());
        assert!(IrregularTrack::new(even(), vec![f64::NAN]).is_err());
        for (deviation, supports) in [(0.0, 5), (0.2, 5), (f64::NAN, 5), (0.03, 0), (0.03, 201)] {
            assert!(IrregularTrack::drawn(even(), deviation, supports, 1).is_err());
        }
    }
}
