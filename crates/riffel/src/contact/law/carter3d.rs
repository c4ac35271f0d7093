//! The paper's three-dimensional counterpart of Carter's creep law.

use super::{CreepDerivatives, CreepForces, CreepLaw, Creepages, ForceLimit, OwnSlope};
use crate::Error;
use crate::contact::{HertzContact, creep_coefficient};

/// Creep law (5) with the derivatives (9)–(12).
///
/// Q = μP \[1 − (1 − ξ/ξ_max)³\] for 0 ≤ ξ ≤ ξ_max, where the saturation creepage ξ_max ∝ P^{1/3}
/// of equation (6) marks the beginning of full slip. With lateral creepage ξ is the magnitude of both and the force
/// has their direction; spin takes no part.
///
/// Source: Bhaskar, Johnson, Wood & Woodhouse (1997, equation 5a); Afferrante & Ciavarella (2009).
/// Range of validity: against Kalker's exact half-space theory the law is 1.5–3 % low at the
/// paper's own ellipse and 8–10 % low at a/b = 0.5. Its slope at zero creepage is not Kalker's but that of the line
/// (7), one for both directions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Carter3d {
    hertz: HertzContact,
    friction: f64,
    /// At the load of the contact.
    saturation_creepage: f64,
}

impl Carter3d {
    /// The law on a contact, with the coefficient of friction μ \[-\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless μ > 0.
    pub fn new(hertz: HertzContact, friction: f64) -> Result<Self, Error> {
        Error::unless_positive("coefficient of friction", friction, "")?;
        Ok(Self { hertz, friction, saturation_creepage: saturation_creepage(hertz, friction) })
    }

    /// Creep coefficient C₀₀ of the patch \[-\], equation (7).
    pub fn creep_coefficient(&self) -> f64 {
        creep_coefficient(self.hertz.axis_ratio())
    }

    /// Saturation creepage ξ_max \[-\] under the load of the contact, equation (6).
    pub fn saturation_creepage(&self) -> f64 {
        self.saturation_creepage
    }

    /// ξ_max ∝ P^{1/3} \[-\] under any load \[N\].
    fn saturation_under(&self, normal_force: f64) -> f64 {
        self.saturation_creepage * (normal_force / self.hertz.normal_force()).cbrt()
    }
}

/// ξ_max = (3μ/C₀₀) \[16 P / (9 (1 − ν)² R_e² G)\]^{1/3}, equation (6).
fn saturation_creepage(hertz: HertzContact, friction: f64) -> f64 {
    let steel = hertz.material();
    let radius = (1.0 - steel.poisson_ratio()) * hertz.equivalent_radius();
    let load = hertz.normal_force() / (radius * radius * steel.shear_modulus());
    3.0 * friction / creep_coefficient(hertz.axis_ratio()) * (16.0 / 9.0 * load).cbrt()
}

/// A size along the direction of the creepages.
fn along(creepages: Creepages, size: f64) -> CreepForces {
    if creepages.lateral == 0.0 {
        return CreepForces { longitudinal: size * creepages.longitudinal.signum(), lateral: 0.0 };
    }
    let per_creepage = size / creepages.magnitude();
    CreepForces { longitudinal: per_creepage * creepages.longitudinal, lateral: per_creepage * creepages.lateral }
}

impl CreepLaw for Carter3d {
    fn friction(&self) -> f64 {
        self.friction
    }

    fn forces(&self, normal_force: f64, creepages: Creepages) -> CreepForces {
        let limit = self.friction * normal_force;
        let stick = 1.0 - creepages.magnitude() / self.saturation_under(normal_force);
        let force = if stick > 0.0 { limit * (1.0 - stick.powi(3)) } else { limit };
        along(creepages, force)
    }

    /// Along the creepage, with x = ξ/ξ_max: ∂Q/∂P = 2μx(1 − x/2), equation (9), which keeps ξ_max ∝ P^{1/3}, and
    /// ∂Q/∂ξ = 3μP(1 − x)²/ξ_max, equation (10) but for the factor −R/V; across it Q/ξ.
    fn derivatives(&self, normal_force: f64, creepages: Creepages) -> CreepDerivatives {
        let saturation = self.saturation_under(normal_force);
        let size = creepages.magnitude();
        let x = (size / saturation).min(1.0);
        let stick = 1.0 - x;
        let slope = 3.0 * self.friction * normal_force / saturation * stick * stick;
        // Q/ξ = (μP/ξ_max)(3 − 3x + x²) below full slip: finite at zero creepage.
        let across = if x < 1.0 {
            self.friction * normal_force / saturation * (3.0 - 3.0 * x + x * x)
        } else {
            self.friction * normal_force / size
        };
        // Direction of the creepages; without any, both slopes are one.
        let direction = along(creepages, 1.0);
        let by = |axis: CreepForces| {
            let share = axis.dot(direction);
            direction.combine(share * (slope - across), axis, across)
        };
        let full_slip = x >= 1.0;
        let by_load = if full_slip { self.friction } else { 2.0 * self.friction * x * (1.0 - x / 2.0) };
        CreepDerivatives {
            by_normal_force: along(creepages, by_load),
            by_longitudinal: by(CreepForces { longitudinal: 1.0, lateral: 0.0 }),
            by_lateral: by(CreepForces { longitudinal: 0.0, lateral: 1.0 }),
        }
    }

    fn limit(&self, normal_force: f64) -> ForceLimit {
        ForceLimit::FullSlip(self.saturation_under(normal_force))
    }

    fn own_slope(&self) -> Option<OwnSlope> {
        Some(OwnSlope { creep_coefficient: self.creep_coefficient(), saturation_creepage: self.saturation_creepage })
    }

    /// The inverse of equation (5).
    fn creepage(&self, normal_force: f64, tractive_ratio: f64) -> Option<f64> {
        let stick = (1.0 - tractive_ratio).cbrt();
        (tractive_ratio < 1.0).then(|| self.saturation_under(normal_force) * (1.0 - stick))
    }
}

#[cfg(test)]
mod tests {
    use super::super::checks::{derivatives_match, grows_to_limit, stays_below_friction};
    use super::*;
    use crate::contact::{MeanState, QuasiStatic, RollingContact};
    use crate::fixtures::steel;
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    fn law(normal_force: f64, friction: f64) -> Carter3d {
        let steel = steel();
        let hertz = HertzContact::new(steel, 0.46, 0.23, normal_force).unwrap();
        Carter3d::new(hertz, friction).unwrap()
    }

    #[test]
    fn full_slip_is_refused_along_the_rail_alone() {
        let law = law(50e3, 0.4);
        let error = QuasiStatic::new(law, 50e3, MeanState::creepage(0.008)).unwrap_err();
        assert!(error.to_string().contains("full slip begins at 0.7036 %"));
        let oblique = Creepages { longitudinal: 0.006, lateral: 0.006, spin: 0.0 };
        // Beside its direction all slips: that is full sliding.
        let contact = QuasiStatic::new(law, 50e3, MeanState::Creepages(oblique)).unwrap();
        let sliding = crate::contact::FullSliding::new(0.4).unwrap();
        let sliding = QuasiStatic::new(sliding, 50e3, MeanState::Creepages(oblique)).unwrap();
        let [one, other] = [contact.response(0.1), sliding.response(0.1)];
        assert_eq!(one.by_load, other.by_load);
        for part in 0..2 {
            let [one, other] = [one, other].map(|by| by.by_longitudinal.force[part].re);
            assert!((one / other - 1.0).abs() < 1e-12, "{one} {other}");
        }
    }

    #[test]
    fn force_grows_to_full_slip() {
        grows_to_limit(&law(50e3, 0.4), 80e3);
    }

    proptest! {
        /// (5) and its inverse are each other's inverse; 1e-12 is rounding amplified near τ = 1.
        #[test]
        fn creep_law_round_trip(
            force in 5e3..150e3, friction in 0.05..0.8, ratio in 0.001..0.999f64,
        ) {
            let contact = QuasiStatic::new(law(force, friction), force, MeanState::TractiveRatio(ratio));
            let steady = contact.unwrap().steady();
            assert_relative_eq!(steady.tractive_ratio(), ratio, max_relative = 1e-12);
        }

        /// (9)–(12) against central differences of Q and ξ·Q. With a relative step of 1e-5 the
        /// truncation is 1e-10 of the third derivative and rounding 1e-11 of the value: 1e-7 of the
        /// largest slope covers both, also where the slope itself nearly vanishes (τ → 1).
        #[test]
        fn derivatives_match_finite_differences(
            force in 5e3..150e3, friction in 0.05..0.8, ratio in 0.01..0.98f64,
        ) {
            let law = law(force, friction);
            let contact = QuasiStatic::new(law, force, MeanState::TractiveRatio(ratio)).unwrap();
            let xi = contact.steady().creepages.longitudinal;
            let response = contact.response(0.05);
            let q = |p: f64, xi: f64| law.forces(p, Creepages::longitudinal(xi)).longitudinal;
            let e = |p: f64, xi: f64| xi * q(p, xi);
            let (dp, dxi) = (1e-5 * force, 1e-5 * xi);
            let along_p = |f: &dyn Fn(f64, f64) -> f64| (f(force + dp, xi) - f(force - dp, xi)) / (2.0 * dp);
            let along_xi = |f: &dyn Fn(f64, f64) -> f64| (f(force, xi + dxi) - f(force, xi - dxi)) / (2.0 * dxi);
            let q0 = friction * force;
            let (by_load, by_creepage) = (response.by_load, response.by_longitudinal);
            assert_relative_eq!(by_load.force[0].re, along_p(&q), epsilon = 1e-7 * friction);
            assert_relative_eq!(by_creepage.force[0].re, along_xi(&q), epsilon = 1e-7 * 3.0 * q0 / xi);
            assert_relative_eq!(by_load.energy.re, along_p(&e), epsilon = 1e-7 * friction * xi);
            assert_relative_eq!(by_creepage.energy.re, along_xi(&e), epsilon = 1e-7 * 6.0 * q0);
        }

        /// Both forces by both creepages, on both sides of full slip.
        #[test]
        fn vector_derivatives_match_finite_differences(
            force in 20e3..100e3, xi in -0.01..0.01f64, eta in -0.01..0.01f64,
        ) {
            let law = law(50e3, 0.4);
            let creepages = Creepages { longitudinal: xi, lateral: eta, spin: 0.0 };
            // A difference over the corner at full slip is not a slope.
            let x = creepages.magnitude() / law.saturation_under(force);
            prop_assume!(x > 0.01 && (x - 1.0).abs() > 0.01);
            derivatives_match(&law, force, creepages, 1e-5, 1e-7);
            stays_below_friction(&law, force, creepages);
        }
    }
}
