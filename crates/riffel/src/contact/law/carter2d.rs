//! Carter's exact law of a rolling line contact.

use std::f64::consts::PI;

use super::{CreepDerivatives, CreepEllipse, CreepForces, CreepLaw, Creepages, ForceLimit};
use crate::Error;

/// Line contact of two equal materials in plane strain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineContact {
    /// Reference normal force P₀ \[N\], spread evenly over the width.
    pub normal_force: f64,
    /// Half-length a₀ in the rolling direction under P₀ \[m\].
    pub half_length: f64,
    /// Half-width b \[m\]; the load per width is P/2b.
    pub half_width: f64,
    /// Shear modulus G of both bodies \[Pa\].
    pub shear_modulus: f64,
    /// Poisson's ratio ν of both bodies \[-\].
    pub poisson_ratio: f64,
}

/// Carter's creep law, longitudinal only.
///
/// Q = μP \[1 − (1 − ξ/ξ_max)²\] for 0 ≤ ξ ≤ ξ_max, with ξ_max = μa/R = 4μ(1 − ν)P′/(πGa), where P′ is
/// the load per width and R the relative radius of curvature. Lateral creepage and spin are ignored,
/// and the lateral force is zero.
///
/// Source: Carter (1926, Proceedings of the Royal Society A 112, 151–157); Johnson (1985, section
/// 8.3). Range of validity: exact for [`line_contact`](Self::line_contact). For an ellipse it is a rough estimate:
/// against CONTACT at a/b = 1.59 Q/μP is up to 27 % low, at small creepage, since the strip knows
/// nothing of its neighbours. Test: `deviation_from_exact_theory_is_as_documented`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Carter2d {
    line: LineContact,
    friction: f64,
    /// n in a ∝ P^n; then ξ_max ∝ P^n and the width ∝ P^{1 − 2n}.
    load_exponent: f64,
}

impl Carter2d {
    /// A line contact of constant width, exact: a and ξ_max ∝ P^{1/2}, with the coefficient of
    /// friction μ \[-\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless all values are positive and ν ≤ 0.5; zero is allowed for ν.
    pub fn line_contact(line: LineContact, friction: f64) -> Result<Self, Error> {
        Self::new(line, friction, 0.5)
    }

    /// An ellipse, taken as the line contact of the same length 2a and the same area πab: its width
    /// is πb/2 and its load per width P′ = 2P/πb. Poisson's ratio ν and the coefficient of friction μ
    /// are without unit.
    ///
    /// This mapping keeps the mean pressure, and makes the slope at zero creepage that of Kalker's
    /// linear theory for a patch much shorter than wide, C₁₁ = π²/4(1 − ν). The coefficients of the
    /// ellipse are not used. The load changes a, b and ξ_max as P^{1/3}.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless all values are positive and ν ≤ 0.5; zero is allowed for ν.
    pub fn of_ellipse(ellipse: CreepEllipse, poisson_ratio: f64, friction: f64) -> Result<Self, Error> {
        ellipse.check()?;
        let line = LineContact {
            normal_force: ellipse.normal_force,
            half_length: ellipse.semi_axis_longitudinal,
            half_width: PI / 4.0 * ellipse.semi_axis_lateral,
            shear_modulus: ellipse.shear_modulus,
            poisson_ratio,
        };
        Self::new(line, friction, 1.0 / 3.0)
    }

    fn new(line: LineContact, friction: f64, load_exponent: f64) -> Result<Self, Error> {
        Error::unless_positive("normal force", line.normal_force, "N")?;
        Error::unless_positive("half-length of the contact", line.half_length, "m")?;
        Error::unless_positive("half-width of the contact", line.half_width, "m")?;
        Error::unless_positive("shear modulus", line.shear_modulus, "Pa")?;
        Error::unless_positive("coefficient of friction", friction, "")?;
        if !(0.0..=0.5).contains(&line.poisson_ratio) {
            return Err(Error::OutOfRange {
                quantity: "Poisson's ratio",
                value: line.poisson_ratio,
                unit: "",
                rule: "must lie between 0 and 0.5",
            });
        }
        Ok(Self { line, friction, load_exponent })
    }

    /// Half-length a of the contact under the normal force P > 0 \[N\], in metres.
    pub fn half_length(&self, normal_force: f64) -> f64 {
        self.line.half_length * self.growth(normal_force)
    }

    /// Creepage ξ_max \[-\] at which full slip begins, under the normal force P > 0 \[N\].
    pub fn saturation_creepage(&self, normal_force: f64) -> f64 {
        let line = self.line;
        let load_per_width = line.normal_force / (2.0 * line.half_width);
        4.0 * self.friction * (1.0 - line.poisson_ratio) * load_per_width / (PI * line.shear_modulus * line.half_length)
            * self.growth(normal_force)
    }

    /// Half-length c = a (1 − |ξ|/ξ_max) \[m\] of the stick region, which touches the leading edge;
    /// zero in full slip.
    pub fn stick_half_length(&self, normal_force: f64, creepage: f64) -> f64 {
        self.half_length(normal_force) * self.stick(normal_force, creepage)
    }

    /// Tangential traction q \[Pa\] at x \[m\] from the centre, positive in the rolling direction,
    /// under the normal force P > 0 \[N\] at the creepage ξ \[-\]; zero outside the contact.
    ///
    /// q = μp₀ \[√(1 − (x/a)²) − (c/a) √(1 − ((x − a + c)/c)²)\], the second root in the stick region
    /// only, with p₀ = 2P′/πa.
    pub fn traction(&self, normal_force: f64, creepage: f64, x: f64) -> f64 {
        let a = self.half_length(normal_force);
        let c = self.stick_half_length(normal_force, creepage);
        let growth = self.growth(normal_force);
        // The width grows as P^{1 − 2n}.
        let width = 2.0 * self.line.half_width * normal_force / (self.line.normal_force * growth * growth);
        let largest = 2.0 * self.friction * normal_force / (PI * a * width);
        let bow = |offset: f64, half: f64| (half * half - offset * offset).max(0.0).sqrt() / a;
        creepage.signum() * largest * (bow(x, a) - bow(x - a + c, c))
    }

    /// (P/P₀)^n.
    fn growth(&self, normal_force: f64) -> f64 {
        (normal_force / self.line.normal_force).powf(self.load_exponent)
    }

    /// 1 − |ξ|/ξ_max, not below zero.
    fn stick(&self, normal_force: f64, creepage: f64) -> f64 {
        (1.0 - creepage.abs() / self.saturation_creepage(normal_force)).max(0.0)
    }
}

impl CreepLaw for Carter2d {
    fn friction(&self) -> f64 {
        self.friction
    }

    fn forces(&self, normal_force: f64, creepages: Creepages) -> CreepForces {
        let stick = self.stick(normal_force, creepages.longitudinal);
        let force = self.friction * normal_force * (1.0 - stick * stick);
        CreepForces { longitudinal: force * creepages.longitudinal.signum(), lateral: 0.0 }
    }

    fn derivatives(&self, normal_force: f64, creepages: Creepages) -> CreepDerivatives {
        let xi = creepages.longitudinal;
        let stick = self.stick(normal_force, xi);
        let slope = 2.0 * self.friction * normal_force * stick / self.saturation_creepage(normal_force);
        let longitudinal = |value| CreepForces { longitudinal: value, lateral: 0.0 };
        let force = self.forces(normal_force, creepages).longitudinal;
        CreepDerivatives {
            // ξ_max ∝ P^n at constant ξ.
            by_normal_force: longitudinal((force - self.load_exponent * xi * slope) / normal_force),
            by_longitudinal: longitudinal(slope),
            by_lateral: CreepForces::default(),
        }
    }

    fn limit(&self, normal_force: f64) -> ForceLimit {
        ForceLimit::FullSlip(self.saturation_creepage(normal_force))
    }
}

#[cfg(test)]
mod tests {
    use super::super::checks::{ELLIPSE, derivatives_match, grows_to_limit, stays_below_friction};
    use super::*;
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    /// The roller of CONTACT's example carter2d: 178.9 N/mm, radius 0.5 m against a plane.
    fn roller() -> Carter2d {
        let line = LineContact {
            normal_force: 35_780.0,
            half_length: 1e-3,
            half_width: 0.1,
            shear_modulus: 82e9,
            poisson_ratio: 0.28,
        };
        Carter2d::line_contact(line, 0.3).unwrap()
    }

    /// Exact: Q/μP = 0.64 and c/a = 0.6. The load is printed with four digits, hence 2e-4.
    #[test]
    fn rolls_like_the_published_case() {
        let (law, force, xi) = (roller(), 35_780.0, 0.000_24);
        let ratio = law.forces(force, Creepages::longitudinal(xi)).longitudinal / (0.3 * force);
        assert_relative_eq!(ratio, 0.64, epsilon = 2e-4);
        assert_relative_eq!(law.stick_half_length(force, xi), 0.6e-3, max_relative = 2e-4);
        assert_relative_eq!(law.traction(force, 1.0, 0.0), 0.3 * 113.9e6, max_relative = 2e-4);
    }

    /// The traction integrates to the force, also away from the reference load. The midpoint rule at
    /// the square-root edges leaves 1e-5 at 4000 points.
    #[test]
    fn traction_integrates_to_the_force() {
        let ellipse = Carter2d::of_ellipse(ELLIPSE, 0.3, 0.4).unwrap();
        for (law, width) in [(roller(), 0.2), (ellipse, PI / 2.0 * ELLIPSE.under(90e3).semi_axis_lateral)] {
            let (force, points) = (90e3, 4000);
            let xi = 0.4 * law.saturation_creepage(force);
            let step = 2.0 * law.half_length(force) / f64::from(points);
            let sum: f64 = (0..points)
                .map(|i| law.traction(force, xi, -law.half_length(force) + (f64::from(i) + 0.5) * step))
                .sum();
            let exact = law.forces(force, Creepages::longitudinal(xi)).longitudinal;
            assert_relative_eq!(sum * step * width, exact, max_relative = 1e-5);
        }
    }

    proptest! {
        #[test]
        fn slopes_bounds_and_growth(
            force in 5e3..150e3, friction in 0.05..0.8, xi in -0.01..0.01, line: bool,
        ) {
            let law = if line {
                Carter2d { friction, ..roller() }
            } else {
                Carter2d::of_ellipse(ELLIPSE, 0.3, friction).unwrap()
            };
            derivatives_match(&law, force, Creepages::longitudinal(xi), 1e-5, 1e-6);
            stays_below_friction(&law, force, Creepages::longitudinal(xi));
            grows_to_limit(&law, force);
        }
    }
}
