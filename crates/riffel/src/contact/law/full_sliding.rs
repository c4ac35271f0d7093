//! Coulomb friction of a patch that slips everywhere.

use super::{CreepDerivatives, CreepForces, CreepLaw, Creepages, ForceLimit};
use crate::Error;

/// Full sliding: F = μP c/|c|, along the slip c = (ξ, η), whatever its size.
///
/// The limit of every frictional contact at large creepage, and the state of a leading wheelset in a narrow curve. The
/// contact is no spring any more: along the slip the force does not answer to creepage at all, across it
/// ∂F/∂c = μP/|c|, and ∂F/∂P = μ c/|c|. Laws that saturate by shortening Kalker's linear force, as
/// [`ShenHedrickElkins`](super::ShenHedrickElkins), keep its direction at full slip instead, which is up to a few
/// degrees off the slip where C₁₁ ≠ C₂₂.
///
/// Range of validity: creepages beyond full slip, a spin whose slip φa is small beside them, constant friction. The
/// slope at zero creepage is infinite: not that of Kalker's linear theory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FullSliding {
    friction: f64,
}

impl FullSliding {
    /// The law for the coefficient of friction μ \[-\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless it is positive.
    pub fn new(friction: f64) -> Result<Self, Error> {
        Error::unless_positive("coefficient of friction", friction, "")?;
        Ok(Self { friction })
    }
}

impl CreepLaw for FullSliding {
    fn friction(&self) -> f64 {
        self.friction
    }

    fn forces(&self, normal_force: f64, creepages: Creepages) -> CreepForces {
        let magnitude = creepages.magnitude();
        if magnitude == 0.0 {
            return CreepForces::default();
        }
        let factor = self.friction * normal_force / magnitude;
        CreepForces { longitudinal: factor * creepages.longitudinal, lateral: factor * creepages.lateral }
    }

    fn derivatives(&self, normal_force: f64, creepages: Creepages) -> CreepDerivatives {
        let magnitude = creepages.magnitude();
        // Across the slip alone: μP/|c| (I − ĉĉᵀ).
        let (along, across) = (creepages.longitudinal / magnitude, creepages.lateral / magnitude);
        let slope = self.friction * normal_force / magnitude;
        CreepDerivatives {
            by_normal_force: CreepForces { longitudinal: self.friction * along, lateral: self.friction * across },
            by_longitudinal: CreepForces { longitudinal: slope * across * across, lateral: -slope * along * across },
            by_lateral: CreepForces { longitudinal: -slope * along * across, lateral: slope * along * along },
        }
    }

    fn limit(&self, _normal_force: f64) -> ForceLimit {
        ForceLimit::FullSlip(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::super::checks::derivatives_match;
    use super::*;
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    proptest! {
        /// Slopes by differences, homogeneity, and no answer along the slip (check of the limit of all laws).
        #[test]
        fn slopes_and_null_vectors(
            force in 5e3..150e3f64, friction in 0.05..0.8f64, magnitude in 1e-3..0.05f64, angle in 0.0..std::f64::consts::TAU,
        ) {
            let law = FullSliding::new(friction).unwrap();
            let creepages = Creepages {
                longitudinal: magnitude * angle.cos(), lateral: magnitude * angle.sin(), spin: 0.0,
            };
            let at = law.derivatives(force, creepages);
            prop_assert!((law.forces(force, creepages).magnitude() / (friction * force) - 1.0).abs() < 1e-14);
            let slope = friction * force / magnitude;
            for component in [
                at.by_longitudinal.longitudinal * angle.cos() + at.by_lateral.longitudinal * angle.sin(),
                at.by_longitudinal.lateral * angle.cos() + at.by_lateral.lateral * angle.sin(),
            ] {
                assert_relative_eq!(component, 0.0, epsilon = 1e-13 * slope);
            }
            derivatives_match(&law, force, creepages, 1e-5, 1e-3);
        }
    }
}
