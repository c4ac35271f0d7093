//! Mean wear of a rail, and how far a growth rate can last beside it.

use crate::STANDARD_GRAVITY;
use crate::feedback::Loop;

/// Mean depth worn off a rail, and the mass of the axles that wear it.
///
/// What a passage wears off a rail is never negative. So the oscillating part of the wear, gΔ for a wave of the amplitude Δ that
/// grows by g per passage, cannot exceed the mean depth w̄: gΔ ≤ w̄. A linear loop knows nothing of that, and its rate cannot last
/// beyond the amplitude w̄/g.
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub struct MeanWear {
    /// Depth w̄ worn off per axle passage \[m\].
    pub depth: f64,
    /// Mass of an axle \[kg\].
    pub axle_mass: f64,
    /// Whether it bounds a rate of growth; not where a law of damage moves the profile and takes nothing away.
    pub bounds_growth: bool,
}

impl MeanWear {
    /// A hundred million gross tonnes \[kg\].
    pub const HUNDRED_MILLION_TONNES: f64 = 1e11;

    /// Depth worn off under 100 million gross tonnes \[m\].
    pub fn depth_per_100_mgt(self) -> f64 {
        self.depth * Self::HUNDRED_MILLION_TONNES / self.axle_mass
    }

    /// The wear under axles of this mass \[kg\], where it is known: twice the load of one wheel is not that of its axle in a curve.
    pub fn under_axle(self, mass: Option<f64>) -> Self {
        Self { axle_mass: mass.unwrap_or(self.axle_mass), ..self }
    }

    /// Amplitude \[m\] beyond which a growth rate per passage cannot last; `None` if nothing grows.
    pub fn amplitude_limit(self, growth_rate: f64) -> Option<f64> {
        (growth_rate > 0.0 && self.bounds_growth).then(|| self.depth / growth_rate)
    }
}

impl Loop {
    /// Mean wear of the rail under study, in the mean over the wheels on it; both wheels of an axle carry the load of the first.
    pub fn mean_wear(&self) -> MeanWear {
        let on_rail = self.contacts().iter().filter(|it| it.rail == self.rail());
        let (mut depth, mut wheels, mut bounds_growth) = (0.0, 0.0, true);
        for contact in on_rail {
            let steady = contact.rolling.steady();
            depth += match &contact.damage {
                Some(damage) => {
                    bounds_growth &= damage.is_bound_by_depth();
                    damage.mean_depth(contact.mean_of_damage(), steady.normal_force)
                }
                None => contact.wear.depth_per_energy() * steady.energy_per_metre(),
            };
            wheels += 1.0;
        }
        MeanWear {
            depth: depth / wheels,
            axle_mass: 2.0 * self.steady().normal_force / STANDARD_GRAVITY,
            bounds_growth,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A leading wheel in 120 m: 333 J/m, 2.5e-9 kg/J over 12 mm, half of axles of 10.2 t: 43 mm per 100 Mt.
    #[test]
    fn wear_of_a_sharp_curve() {
        let depth = 0.5 * 2.5e-9 * 333.0 / (7850.0 * 0.012);
        let wear = MeanWear { depth, axle_mass: 10_200.0, bounds_growth: true };
        assert!((1e3 * wear.depth_per_100_mgt() - 43.3).abs() < 0.1);
        assert_eq!(wear.amplitude_limit(0.0), None);
        assert_eq!(wear.amplitude_limit(-1e-6), None);
        let limit = wear.amplitude_limit(1e-4).unwrap();
        assert!((1e-4 * limit / depth - 1.0).abs() < 1e-15);
    }
}
