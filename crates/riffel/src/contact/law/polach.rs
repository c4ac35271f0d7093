//! Polach's creep law with reduced slopes and falling friction.

use std::f64::consts::{FRAC_PI_2, PI};

use riffel_numerics::bisection::bisection;

use super::{CreepDerivatives, CreepEllipse, CreepForces, CreepLaw, Creepages, ForceLimit};
use crate::Error;

/// Friction that falls with slip velocity, μ = μ₀ \[(1 − A) e^{−Bw} + A\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FallingFriction {
    /// Static coefficient of friction μ₀ \[-\], the one at w = 0.
    pub static_friction: f64,
    /// A \[-\], the coefficient of friction at infinite slip velocity over μ₀, above 0 and at most 1.
    pub limit_ratio: f64,
    /// Rate of decay B \[s/m\], zero or more.
    pub decay: f64,
}

impl FallingFriction {
    /// Coulomb friction μ \[-\], the same at every slip velocity.
    pub fn constant(friction: f64) -> Self {
        Self { static_friction: friction, limit_ratio: 1.0, decay: 0.0 }
    }

    /// Coefficient of friction \[-\] at the slip velocity w ≥ 0 \[m/s\].
    pub fn at(&self, slip_velocity: f64) -> f64 {
        let fading = (-self.decay * slip_velocity).exp();
        self.static_friction * ((1.0 - self.limit_ratio) * fading + self.limit_ratio)
    }

    /// dμ/dw \[s/m\].
    fn slope(&self, slip_velocity: f64) -> f64 {
        let fading = (-self.decay * slip_velocity).exp();
        -self.static_friction * (1.0 - self.limit_ratio) * self.decay * fading
    }
}

/// Reduction factors of the contact stiffness, 0 < k_S ≤ k_A ≤ 1. A clean dry contact has both at
/// one; layers of water, dirt or oil lower them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlopeReduction {
    /// k_A \[-\], in the area of adhesion.
    pub adhesion: f64,
    /// k_S \[-\], in the area of slip.
    pub slip: f64,
}

impl SlopeReduction {
    /// k_A = k_S = 1.
    pub const NONE: Self = Self { adhesion: 1.0, slip: 1.0 };
}

/// Creep law of Polach, longitudinal and lateral, at a constant speed V.
///
/// F = (2μP/π) \[k_A ε/(1 + (k_A ε)²) + arctan(k_S ε)\] in the direction of the creepage (ξ, η), with
/// ε = πGab √((C₁₁ξ)² + (C₂₂η)²)/(4μP) and the friction of the slip velocity w = V √(ξ² + η²). Spin is
/// ignored. The slope at zero creepage is (k_A + k_S)/2 times Kalker's in pure longitudinal or pure
/// lateral creepage. [`friction`](CreepLaw::friction) is μ₀, so a tractive ratio of one is never
/// reached.
///
/// Source: Polach (2000, Vehicle System Dynamics Supplement 33, 728–739; 2005, Wear 258, 992–1000,
/// equations 1–6). Range of validity: no spin; one speed. With falling friction, or with k_S well
/// below k_A, the force has a maximum, and a mean state beyond it is not stable under a given torque.
/// Largest deviations of Q/μP from
/// CONTACT in pure longitudinal creepage at a/b = 1.59, constant friction, k_A = k_S = 1: −5.1 % near
/// saturation and +6.8 % at Q/μP = 0.4. Test: `deviation_from_exact_theory_is_as_documented`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Polach {
    ellipse: CreepEllipse,
    friction: FallingFriction,
    reduction: SlopeReduction,
    speed: f64,
}

impl Polach {
    /// The law on an ellipse at the rolling speed V \[m/s\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless the values of the ellipse, μ₀ and V are positive, 0 < A ≤ 1,
    /// B ≥ 0 and 0 < k_S ≤ k_A ≤ 1.
    pub fn new(
        ellipse: CreepEllipse,
        friction: FallingFriction,
        reduction: SlopeReduction,
        speed: f64,
    ) -> Result<Self, Error> {
        ellipse.check()?;
        Error::unless_positive("static coefficient of friction", friction.static_friction, "")?;
        Error::unless_not_negative("decay of friction", friction.decay, "s/m")?;
        Error::unless_positive("speed", speed, "m/s")?;
        unless_fraction("limit ratio of friction", friction.limit_ratio)?;
        unless_fraction("reduction factor in the area of adhesion", reduction.adhesion)?;
        unless_fraction("reduction factor in the area of slip", reduction.slip)?;
        if reduction.slip > reduction.adhesion {
            return Err(Error::OutOfRange {
                quantity: "reduction factor in the area of slip",
                value: reduction.slip,
                unit: "",
                rule: "must not exceed the one in the area of adhesion",
            });
        }
        Ok(Self { ellipse, friction, reduction, speed })
    }

    /// f(ε) = k_A ε/(1 + (k_A ε)²) + arctan(k_S ε), and its slope; f tends to π/2.
    fn curve(&self, epsilon: f64) -> [f64; 2] {
        let SlopeReduction { adhesion, slip } = self.reduction;
        let (z, y) = (adhesion * epsilon, slip * epsilon);
        let bell = 1.0 / (1.0 + z * z);
        [(z * bell + y.atan()).min(FRAC_PI_2), adhesion * (1.0 - z * z) * bell * bell + slip / (1.0 + y * y)]
    }

    /// ∂Q/∂ξ \[N\] in pure longitudinal creepage.
    fn longitudinal_slope(&self, normal_force: f64, creepage: f64) -> f64 {
        self.derivatives(normal_force, Creepages::longitudinal(creepage)).by_longitudinal.longitudinal
    }
}

fn unless_fraction(quantity: &'static str, value: f64) -> Result<(), Error> {
    if value > 0.0 && value <= 1.0 {
        return Ok(());
    }
    Err(Error::OutOfRange { quantity, value, unit: "", rule: "must be greater than 0 and at most 1" })
}

impl CreepLaw for Polach {
    fn friction(&self) -> f64 {
        self.friction.static_friction
    }

    fn forces(&self, normal_force: f64, creepages: Creepages) -> CreepForces {
        let (xi, eta) = (creepages.longitudinal, creepages.lateral);
        let creepage = xi.hypot(eta);
        if creepage == 0.0 {
            return CreepForces::default();
        }
        let [stiffness_x, stiffness_y] = self.ellipse.under(normal_force).linear_slopes();
        let linear = (stiffness_x * xi).hypot(stiffness_y * eta);
        let limit = self.friction.at(self.speed * creepage) * normal_force;
        let [value, _] = self.curve(PI * linear / (4.0 * limit));
        let force = limit * value / FRAC_PI_2;
        CreepForces { longitudinal: force * xi / creepage, lateral: force * eta / creepage }
    }

    fn derivatives(&self, normal_force: f64, creepages: Creepages) -> CreepDerivatives {
        let (xi, eta) = (creepages.longitudinal, creepages.lateral);
        let [stiffness_x, stiffness_y] = self.ellipse.under(normal_force).linear_slopes();
        let creepage = xi.hypot(eta);
        if creepage == 0.0 {
            let reduction = 0.5 * (self.reduction.adhesion + self.reduction.slip);
            return CreepDerivatives {
                by_normal_force: CreepForces::default(),
                by_longitudinal: CreepForces { longitudinal: reduction * stiffness_x, lateral: 0.0 },
                by_lateral: CreepForces { longitudinal: 0.0, lateral: reduction * stiffness_y },
            };
        }
        let linear = (stiffness_x * xi).hypot(stiffness_y * eta);
        let friction = self.friction.at(self.speed * creepage);
        let epsilon = PI * linear / (4.0 * friction * normal_force);
        let [value, slope] = self.curve(epsilon);
        let force = friction * normal_force * value / FRAC_PI_2;
        let by_linear = 0.5 * slope;
        let by_friction = normal_force * (value - epsilon * slope) / FRAC_PI_2;
        let friction_slope = self.speed * self.friction.slope(self.speed * creepage);

        // The force has the magnitude F(|F̃|, μ(s)) and the direction (ξ, η)/s.
        let along = |component: f64, stiffness: f64, turn: [f64; 2]| {
            let magnitude = by_linear * stiffness * stiffness * component / linear
                + by_friction * friction_slope * component / creepage;
            CreepForces {
                longitudinal: (magnitude * xi + force * turn[0]) / creepage,
                lateral: (magnitude * eta + force * turn[1]) / creepage,
            }
        };
        let (cos, sin) = (xi / creepage, eta / creepage);
        // ε ∝ P^{−1/3}, because the linear force grows as P^{2/3}.
        let by_load = friction * (value - epsilon * slope / 3.0) / FRAC_PI_2;
        CreepDerivatives {
            by_normal_force: CreepForces { longitudinal: by_load * cos, lateral: by_load * sin },
            by_longitudinal: along(xi, stiffness_x, [sin * sin, -sin * cos]),
            by_lateral: along(eta, stiffness_y, [-sin * cos, cos * cos]),
        }
    }

    /// A scan of ∂Q/∂ξ in steps of 2 % up to a creepage of one, then bisection to rounding.
    fn limit(&self, normal_force: f64) -> ForceLimit {
        let [stiffness, _] = self.ellipse.under(normal_force).linear_slopes();
        let first = 1e-3 * self.friction.static_friction * normal_force / stiffness;
        // From zero, steps of 2 % lead nowhere.
        let mut low = first.max(f64::MIN_POSITIVE);
        while low < 1.0 {
            let high = 1.02 * low;
            let falls = |creepage: f64| self.longitudinal_slope(normal_force, creepage) < 0.0;
            if falls(high) {
                let [last, _] = bisection([low, high], 1e-15 * low, falls);
                return ForceLimit::AdhesionMaximum(last);
            }
            low = high;
        }
        ForceLimit::None
    }
}

#[cfg(test)]
mod tests {
    use super::super::checks::{ELLIPSE, derivatives_match, grows_to_limit, starts_linear, stays_below_friction};
    use super::*;
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    fn falling(static_friction: f64) -> FallingFriction {
        FallingFriction { static_friction, limit_ratio: 0.4, decay: 0.6 }
    }

    #[test]
    fn falling_friction_makes_a_maximum_and_constant_friction_none() {
        let new = |friction| Polach::new(ELLIPSE, friction, SlopeReduction::NONE, 20.0).unwrap();
        let ForceLimit::AdhesionMaximum(creepage) = new(falling(0.4)).limit(50e3) else { panic!("no maximum") };
        assert!(creepage > 1e-3 && creepage < 0.1, "{creepage}");
        assert_eq!(new(FallingFriction::constant(0.4)).limit(50e3), ForceLimit::None);
    }

    #[test]
    fn a_stiffer_area_of_slip_is_refused() {
        let reduction = SlopeReduction { adhesion: 0.3, slip: 0.4 };
        let error = Polach::new(ELLIPSE, falling(0.3), reduction, 20.0).unwrap_err();
        assert!(error.to_string().contains("must not exceed the one in the area of adhesion"));
    }

    /// The scan for the limit ends, also where its first step would be lost to rounding.
    #[test]
    fn the_limit_is_found_in_bounded_time() {
        let reduction = SlopeReduction { adhesion: 1.0, slip: 1.0 };
        for friction in [5e-324, 1e-320, 1e-300, 1e-12] {
            let friction = FallingFriction::constant(friction);
            let law = Polach::new(ELLIPSE, friction, reduction, 1.0).unwrap();
            assert!(matches!(law.limit(50e3), ForceLimit::None));
        }
    }

    proptest! {
        #[test]
        fn slopes_bounds_and_growth(
            force in 5e3..150e3, friction in 0.05..0.8, speed in 5.0..60.0,
            adhesion in 0.2..1.0, slip in 0.2..1.0,
            xi in -0.01..0.01, eta in -0.01..0.01,
        ) {
            let reduction = SlopeReduction { adhesion, slip: slip * adhesion };
            let law = Polach::new(ELLIPSE, falling(friction), reduction, speed).unwrap();
            let creepages = Creepages { longitudinal: xi, lateral: eta, spin: 0.0 };
            derivatives_match(&law, force, creepages, 1e-6, 1e-6);
            stays_below_friction(&law, force, creepages);
            grows_to_limit(&law, force);
            let clean = Polach::new(ELLIPSE, falling(friction), SlopeReduction::NONE, speed).unwrap();
            starts_linear(&clean, &ELLIPSE, force, Creepages::longitudinal(xi), 1e-4);
        }

        /// At rest the derivatives are those of a small creepage.
        #[test]
        fn rest_is_the_limit_of_small_creepage(adhesion in 0.2..1.0, slip in 0.2..1.0) {
            let reduction = SlopeReduction { adhesion, slip: slip * adhesion };
            let law = Polach::new(ELLIPSE, falling(0.4), reduction, 20.0).unwrap();
            let rest = law.longitudinal_slope(50e3, 0.0);
            assert_relative_eq!(rest, law.longitudinal_slope(50e3, 1e-12), max_relative = 1e-8);
        }
    }
}
