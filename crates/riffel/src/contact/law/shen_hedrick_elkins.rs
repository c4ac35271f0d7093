//! Kalker's linear forces, with spin, saturated by the cubic of Vermeulen and Johnson.

use super::{CreepDerivatives, CreepEllipse, CreepForces, CreepLaw, Creepages, ForceLimit};
use crate::Error;

/// Creep law of Shen, Hedrick & Elkins.
///
/// The force F̃ of Kalker's linear theory, lateral creepage and spin included, is shortened by
/// s(u) = 1 − u/3 + u²/27, with u = |F̃|/μP, and keeps its direction; from u = 3 on |F| = μP. Along F̃
/// this is F = μP \[1 − (1 − u/3)³\].
///
/// Source: Shen, Hedrick & Elkins (1983, Vehicle System Dynamics 12, 79–83). Range of validity:
/// small spin, since a force shortened as a whole cannot know that spin makes part of the patch slip
/// sideways. Deviation from exact theory in pure longitudinal creepage: that of
/// [`JohnsonVermeulen`](super::JohnsonVermeulen), which it then equals.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShenHedrickElkins {
    ellipse: CreepEllipse,
    friction: f64,
}

impl ShenHedrickElkins {
    /// The law on an ellipse, with the coefficient of friction μ \[-\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless all values are positive.
    pub fn new(ellipse: CreepEllipse, friction: f64) -> Result<Self, Error> {
        ellipse.check()?;
        Error::unless_positive("coefficient of friction", friction, "")?;
        Ok(Self { ellipse, friction })
    }
}

impl CreepLaw for ShenHedrickElkins {
    fn friction(&self) -> f64 {
        self.friction
    }

    fn forces(&self, normal_force: f64, creepages: Creepages) -> CreepForces {
        let linear = self.ellipse.under(normal_force).linear_forces(creepages);
        let shortening = shortening(linear.magnitude() / (self.friction * normal_force));
        linear.combine(shortening, CreepForces::default(), 0.0)
    }

    fn derivatives(&self, normal_force: f64, creepages: Creepages) -> CreepDerivatives {
        let ellipse = self.ellipse.under(normal_force);
        let linear = ellipse.linear_forces(creepages);
        let limit = self.friction * normal_force;
        let magnitude = linear.magnitude();
        let u = magnitude / limit;
        // The change of length of F̃ vanishes with F̃ itself, where its direction is not defined.
        let bend = match magnitude {
            0.0 => 0.0,
            _ => shortening_slope(u) / (magnitude * limit),
        };
        let along =
            |linear_slope: CreepForces| linear_slope.combine(shortening(u), linear, bend * linear.dot(linear_slope));
        let [by_longitudinal, by_lateral] = ellipse.linear_slopes();
        CreepDerivatives::of_ellipse(
            normal_force,
            creepages,
            self.forces(normal_force, creepages),
            along(CreepForces { longitudinal: by_longitudinal, lateral: 0.0 }),
            along(CreepForces { longitudinal: 0.0, lateral: by_lateral }),
        )
    }

    fn limit(&self, normal_force: f64) -> ForceLimit {
        let [by_longitudinal, _] = self.ellipse.under(normal_force).linear_slopes();
        ForceLimit::FullSlip(3.0 * self.friction * normal_force / by_longitudinal)
    }
}

/// s(u), the saturated force over the linear one.
fn shortening(u: f64) -> f64 {
    if u < 3.0 { 1.0 - u / 3.0 + u * u / 27.0 } else { 1.0 / u }
}

/// ds/du.
fn shortening_slope(u: f64) -> f64 {
    if u < 3.0 { 2.0 * u / 27.0 - 1.0 / 3.0 } else { -1.0 / (u * u) }
}

#[cfg(test)]
mod tests {
    use super::super::checks::{ELLIPSE, derivatives_match, starts_linear, stays_below_friction};
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn slopes_and_bounds(
            force in 5e3..150e3, friction in 0.05..0.8,
            xi in -0.01..0.01, eta in -0.01..0.01, spin in -2.0..2.0,
        ) {
            let law = ShenHedrickElkins::new(ELLIPSE, friction).unwrap();
            let creepages = Creepages { longitudinal: xi, lateral: eta, spin };
            derivatives_match(&law, force, creepages, 1e-5, 1e-6);
            stays_below_friction(&law, force, creepages);
            starts_linear(&law, &ELLIPSE, force, creepages, 1e-5);
        }
    }
}
