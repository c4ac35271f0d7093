//! The Hertz ellipse of two curvatures, solved once for the unit load.

use std::f64::consts::PI;

use super::elliptic_integrals::EllipticIntegrals;
use crate::Error;

/// Semi-axes and approach of a Hertz contact under 1 N; those under a load P follow by
/// a ∝ P^{1/3}, b ∝ P^{1/3} and δ ∝ P^{2/3}.
///
/// With the long semi-axis c, the short one d = q c, the contact modulus E\*, and the combined
/// curvatures κ_c < κ_d of those directions (Johnson 1985, equations 4.24–4.26):
///
/// ```text
/// κ_d/κ_c = B(k')/(q² D(k')),   k' = q
/// c³ = 3 P D / (π E* κ_c),   δ = 3 P K / (2π E* c),   p₀ = 3P / (2π c d)
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct UnitEllipse {
    /// a/P^{1/3} \[m/N^{1/3}\], along the rail.
    longitudinal: f64,
    /// b/P^{1/3} \[m/N^{1/3}\], across it.
    lateral: f64,
    /// δ/P^{2/3} \[m/N^{2/3}\].
    approach: f64,
}

impl UnitEllipse {
    /// Largest ratio of the combined curvatures, that of an axis ratio of 244.
    const LARGEST_CURVATURE_RATIO: f64 = 1e4;

    /// `Ok` for a larger combined curvature over the smaller one that still makes an ellipse.
    pub(super) fn check_curvature_ratio(curvature_ratio: f64) -> Result<(), Error> {
        if curvature_ratio <= Self::LARGEST_CURVATURE_RATIO {
            return Ok(());
        }
        Err(Error::OutOfRange {
            quantity: "ratio of the combined curvatures",
            value: curvature_ratio,
            unit: "",
            rule: "must be at most 10000; beyond that the contact is a line contact",
        })
    }

    /// The ellipse of the contact modulus E\* \[Pa\] and the combined curvatures \[1/m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless both curvatures are positive and their ratio is at most 1e4.
    pub(super) fn new(
        contact_modulus: f64,
        longitudinal_curvature: f64,
        lateral_curvature: f64,
    ) -> Result<Self, Error> {
        unless_convex("combined curvature along the rolling direction", longitudinal_curvature)?;
        unless_convex("combined curvature across the rolling direction", lateral_curvature)?;
        let least = longitudinal_curvature.min(lateral_curvature);
        let curvature_ratio = longitudinal_curvature.max(lateral_curvature) / least;
        Self::check_curvature_ratio(curvature_ratio)?;
        let axis_ratio = solve_axis_ratio(curvature_ratio);
        let integrals = EllipticIntegrals::evaluate(axis_ratio);
        let long = (3.0 * integrals.d() / (PI * contact_modulus * least)).cbrt();
        let short = long * axis_ratio;
        // The weaker curvature lies along the long axis.
        let (longitudinal, lateral) =
            if longitudinal_curvature <= lateral_curvature { (long, short) } else { (short, long) };
        Ok(Self { longitudinal, lateral, approach: 1.5 * integrals.first_kind() / (PI * contact_modulus * long) })
    }

    /// Combined curvatures along and across \[1/m\] of which semi-axes a along and b across \[m\] are the ellipse under a
    /// load \[N\], of the contact modulus E\* \[Pa\]: the equations above the other way round, without any iteration.
    pub(super) fn curvatures(contact_modulus: f64, [a, b]: [f64; 2], load: f64) -> [f64; 2] {
        let (long, short) = (a.max(b), a.min(b));
        let axis_ratio = short / long;
        let integrals = EllipticIntegrals::evaluate(axis_ratio);
        let least = 3.0 * load * integrals.d() / (PI * contact_modulus * long.powi(3));
        let most = least * integrals.b() / (axis_ratio * axis_ratio * integrals.d());
        if a >= b { [least, most] } else { [most, least] }
    }

    /// a/b \[-\].
    pub(super) fn axis_ratio(&self) -> f64 {
        self.longitudinal / self.lateral
    }

    /// a \[m\] under a load \[N\].
    pub(super) fn semi_axis_longitudinal(&self, normal_force: f64) -> f64 {
        self.longitudinal * normal_force.cbrt()
    }

    /// b \[m\] under a load \[N\].
    pub(super) fn semi_axis_lateral(&self, normal_force: f64) -> f64 {
        self.lateral * normal_force.cbrt()
    }

    /// δ \[m\] under a load \[N\].
    pub(super) fn approach(&self, normal_force: f64) -> f64 {
        self.approach * normal_force.cbrt().powi(2)
    }

    /// dP/dδ = 3P/(2δ) \[N/m\] under a load \[N\].
    pub(super) fn stiffness(&self, normal_force: f64) -> f64 {
        1.5 * normal_force.cbrt() / self.approach
    }

    /// Radius of the sphere on a plane whose patch has the same area: 4E\*(ab)^{3/2}/(3P) \[m\].
    pub(super) fn equivalent_radius(&self, contact_modulus: f64) -> f64 {
        let square = self.longitudinal * self.lateral;
        4.0 / 3.0 * contact_modulus * square * square.sqrt()
    }
}

fn unless_convex(quantity: &'static str, curvature: f64) -> Result<(), Error> {
    let rule = if curvature == 0.0 {
        "must be greater than zero; without curvature the bodies touch along a line, which has no \
         Hertz ellipse"
    } else {
        "must be finite and greater than zero; where it is negative the bodies conform, and the \
         theory of Hertz does not hold"
    };
    if curvature.is_finite() && curvature > 0.0 {
        return Ok(());
    }
    Err(Error::OutOfRange { quantity, value: curvature, unit: "1/m", rule })
}

/// q = d/c \[-\], the short over the long semi-axis, from the ratio κ_d/κ_c ≥ 1 of the curvatures.
///
/// Newton's method on F(s) = ln(B/D) + 2s − ln(κ_d/κ_c) with q = e^{−s}. The slope of F lies
/// between 3/2 (circle) and 2 (line contact), so the root lies between half and two thirds of the
/// logarithm and no step may leave that bracket. It ends when a step is below 1e-14, the relative
/// tolerance of q; six steps reach it over the whole range, ten are allowed.
fn solve_axis_ratio(curvature_ratio: f64) -> f64 {
    const MOST_STEPS: usize = 10;
    const TOLERANCE: f64 = 1e-14;
    let logarithm = curvature_ratio.ln();
    let (lowest, highest) = (0.5 * logarithm, logarithm / 1.5);
    let mut s = highest;
    for _ in 0..MOST_STEPS {
        let step = newton_step(s, logarithm);
        s = (s - step).clamp(lowest, highest);
        if step.abs() <= TOLERANCE {
            break;
        }
    }
    (-s).exp()
}

/// F/F' at s, with F' = 2 + q² C/B − (D − C)/D and C = (D − B)/k².
fn newton_step(s: f64, logarithm: f64) -> f64 {
    let q = (-s).exp();
    let integrals = EllipticIntegrals::evaluate(q);
    let (b, d) = (integrals.b(), integrals.d());
    let modulus_squared = (1.0 - q) * (1.0 + q);
    // Below, the difference D − B is rounding; the slope needs only a few digits.
    let c = if modulus_squared > 1e-6 { (d - b) / modulus_squared } else { PI / 16.0 };
    let slope = 2.0 + q * q * c / b - (d - c) / d;
    ((b / d).ln() + 2.0 * s - logarithm) / slope
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    #[test]
    fn equal_curvatures_make_a_circle_exactly() {
        assert_eq!(solve_axis_ratio(1.0), 1.0);
    }

    /// Four steps more or less would show here: the work of the solution, over the whole range.
    #[test]
    fn newton_converges_in_six_steps() {
        for decade in 0..=80 {
            let logarithm = 10_f64.powf(f64::from(decade) / 20.0).ln();
            let mut s = logarithm / 1.5;
            for _ in 0..6 {
                s -= newton_step(s, logarithm);
            }
            assert!(newton_step(s, logarithm).abs() < 1e-14, "{decade}");
            assert!(s <= logarithm / 1.5 + 1e-15 && s >= 0.5 * logarithm, "{decade}");
        }
    }

    proptest! {
        /// Both equations of the ellipse, κ_c/2 = 3PD/(2π E* c³) and κ_d/2 = 3PB/(2π E* c d²).
        /// 1e-12: the tolerance of the axis ratio and the rounding of the cubes.
        #[test]
        fn residual_of_the_ellipse(
            longitudinal in -2.0..2.0f64, lateral in -2.0..2.0f64, load in 1.0..1e6f64,
        ) {
            let (along, across) = (10_f64.powf(longitudinal), 10_f64.powf(lateral));
            let modulus = 113e9;
            let ellipse = UnitEllipse::new(modulus, along, across).unwrap();
            let a = ellipse.semi_axis_longitudinal(load);
            let b = ellipse.semi_axis_lateral(load);
            let (long, short) = (a.max(b), a.min(b));
            let integrals = EllipticIntegrals::evaluate(short / long);
            let pressure = 1.5 * load / (PI * modulus * long);
            assert_relative_eq!(
                2.0 * pressure * integrals.d() / (long * long), along.min(across), max_relative = 1e-12
            );
            assert_relative_eq!(
                2.0 * pressure * integrals.b() / (short * short), along.max(across), max_relative = 1e-12
            );
            assert_relative_eq!(
                pressure * integrals.first_kind(), ellipse.approach(load), max_relative = 1e-12
            );
        }
    }
}
