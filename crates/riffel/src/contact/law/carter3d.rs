//! The paper's three-dimensional counterpart of Carter's creep law, quasi-static.

use num_complex::Complex64;

use crate::Error;
use crate::contact::{
    ContactResponse, HertzContact, MeanRolling, RollingContact, creep_coefficient,
};

/// Creep law (5) with the quasi-static derivatives (9)–(12).
///
/// Q = μP \[1 − (1 − ξ/ξ_max)³\] for 0 ≤ ξ ≤ ξ_max, where the saturation creepage ξ_max ∝ P^{1/3}
/// of equation (6) marks the beginning of full slip.
///
/// Source: Bhaskar, Johnson, Wood & Woodhouse (1997, equation 5a); Afferrante & Ciavarella (2009).
/// Range of validity: against Kalker's exact half-space theory the law is 1.5–3 % low at the
/// paper's own ellipse and 8–10 % low at a/b = 0.5. The quasi-static response holds for wavelengths
/// much longer than the patch; below λ ≈ 40 a₀ a real contact answers visibly weaker and later.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Carter3d {
    hertz: HertzContact,
    friction: f64,
    saturation_creepage: f64,
    creepage: f64,
}

impl Carter3d {
    /// Mean state given by the tractive ratio τ = Q₀/μP₀ \[-\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless μ > 0 and 0 < τ < 1.
    pub fn from_tractive_ratio(
        hertz: HertzContact,
        friction: f64,
        tractive_ratio: f64,
    ) -> Result<Self, Error> {
        if !(tractive_ratio > 0.0 && tractive_ratio < 1.0) {
            return Err(Error::OutOfRange {
                quantity: "tractive ratio",
                value: tractive_ratio,
                unit: "",
                rule: "must lie between 0 and 1, both excluded",
            });
        }
        let law = Self::free_rolling(hertz, friction)?;
        // Equation (5).
        let creepage = law.saturation_creepage() * (1.0 - (1.0 - tractive_ratio).cbrt());
        Ok(Self { creepage, ..law })
    }

    /// Mean state given by the creepage ξ₀ \[-\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless μ > 0 and ξ₀ > 0, [`Error::FullSlip`] if ξ₀ ≥ ξ_max.
    pub fn from_creepage(hertz: HertzContact, friction: f64, creepage: f64) -> Result<Self, Error> {
        Error::unless_positive("creepage", creepage, "")?;
        let law = Self::free_rolling(hertz, friction)?;
        if creepage >= law.saturation_creepage() {
            return Err(Error::FullSlip {
                creepage,
                saturation_creepage: law.saturation_creepage(),
            });
        }
        Ok(Self { creepage, ..law })
    }

    fn free_rolling(hertz: HertzContact, friction: f64) -> Result<Self, Error> {
        Error::unless_positive("coefficient of friction", friction, "")?;
        Ok(Self {
            hertz,
            friction,
            saturation_creepage: saturation_creepage(hertz, friction),
            creepage: 0.0,
        })
    }

    /// Creep coefficient C₀₀ of the patch \[-\], equation (7).
    pub fn creep_coefficient(&self) -> f64 {
        creep_coefficient(self.hertz.axis_ratio())
    }

    /// Saturation creepage ξ_max at the mean load \[-\], equation (6).
    pub fn saturation_creepage(&self) -> f64 {
        self.saturation_creepage
    }

    /// Tangential force Q(P, ξ) \[N\], the inverse of equation (5), for any normal force P > 0 \[N\]
    /// and creepage ξ ≥ 0 \[-\]; μP in full slip.
    pub fn tangential_force(&self, normal_force: f64, creepage: f64) -> f64 {
        let saturation = saturation_creepage(self.hertz.under(normal_force), self.friction);
        let limit = self.friction * normal_force;
        let stick = 1.0 - creepage / saturation;
        if stick > 0.0 {
            limit * (1.0 - stick.powi(3))
        } else {
            limit
        }
    }

    /// ξ₀/ξ_max \[-\].
    fn saturation(&self) -> f64 {
        self.creepage / self.saturation_creepage()
    }

    /// ∂Q/∂P at constant creepage \[-\], equation (9): it keeps ξ_max ∝ P^{1/3}.
    pub fn dq_dp(&self) -> f64 {
        let x = self.saturation();
        2.0 * self.friction * x * (1.0 - x / 2.0)
    }

    /// ∂Q/∂ξ at constant normal force \[N\]; equation (10) is −(R/V) times this.
    pub fn dq_dxi(&self) -> f64 {
        let stick = 1.0 - self.saturation();
        3.0 * self.friction * self.hertz.normal_force() / self.saturation_creepage() * stick * stick
    }

    /// ∂e/∂P at constant creepage \[-\]; equation (11) is V times this.
    pub fn de_dp(&self) -> f64 {
        self.creepage * self.dq_dp()
    }

    /// ∂e/∂ξ at constant normal force \[J/m\]; equation (12) is −R times this.
    pub fn de_dxi(&self) -> f64 {
        let x = self.saturation();
        6.0 * self.friction
            * self.hertz.normal_force()
            * x
            * (1.0 - 1.5 * x * (1.0 - 4.0 / 9.0 * x))
    }
}

/// ξ_max = (3μ/C₀₀) \[16 P / (9 (1 − ν)² R_e² G)\]^{1/3}, equation (6).
fn saturation_creepage(hertz: HertzContact, friction: f64) -> f64 {
    let steel = hertz.material();
    let radius = (1.0 - steel.poisson_ratio()) * hertz.equivalent_radius();
    let load = hertz.normal_force() / (radius * radius * steel.shear_modulus());
    3.0 * friction / creep_coefficient(hertz.axis_ratio()) * (16.0 / 9.0 * load).cbrt()
}

impl RollingContact for Carter3d {
    fn steady(&self) -> MeanRolling {
        let normal_force = self.hertz.normal_force();
        MeanRolling {
            normal_force,
            friction: self.friction,
            creepage: self.creepage,
            tangential_force: self.tangential_force(normal_force, self.creepage),
        }
    }

    fn response(&self, _wavelength: f64) -> ContactResponse {
        ContactResponse {
            dq_dp: Complex64::from(self.dq_dp()),
            dq_dxi: Complex64::from(self.dq_dxi()),
            de_dp: Complex64::from(self.de_dp()),
            de_dxi: Complex64::from(self.de_dxi()),
            at_rail: None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    fn contact(normal_force: f64, friction: f64, tractive_ratio: f64) -> Carter3d {
        let steel = ElasticMaterial::new(207e9, 0.3).unwrap();
        let hertz = HertzContact::new(steel, 0.46, 0.23, normal_force).unwrap();
        Carter3d::from_tractive_ratio(hertz, friction, tractive_ratio).unwrap()
    }

    use crate::ElasticMaterial;

    #[test]
    fn full_slip_is_refused_with_the_creepage_at_which_it_begins() {
        let hertz = contact(50e3, 0.4, 0.1).hertz;
        let error = Carter3d::from_creepage(hertz, 0.4, 0.008).unwrap_err();
        assert!(error.to_string().contains("full slip begins at 0.7036 %"));
    }

    proptest! {
        /// (5) and its inverse are each other's inverse; 1e-12 is rounding amplified near τ = 1.
        #[test]
        fn creep_law_round_trip(
            force in 5e3..150e3, friction in 0.05..0.8, ratio in 0.001..0.999f64,
        ) {
            let steady = contact(force, friction, ratio).steady();
            assert_relative_eq!(steady.tractive_ratio(), ratio, max_relative = 1e-12);
        }

        /// (9)–(12) against central differences of Q and ξQ. With a relative step of 1e-5 the
        /// truncation is 1e-10 of the third derivative and rounding 1e-11 of the value: 1e-7 of the
        /// largest slope covers both, also where the slope itself nearly vanishes (τ → 1).
        #[test]
        fn derivatives_match_finite_differences(
            force in 5e3..150e3, friction in 0.05..0.8, ratio in 0.01..0.98f64,
        ) {
            let law = contact(force, friction, ratio);
            let xi = law.creepage;
            let q = |p: f64, xi: f64| law.tangential_force(p, xi);
            let e = |p: f64, xi: f64| xi * q(p, xi);
            let (dp, dxi) = (1e-5 * force, 1e-5 * xi);
            let along_p = |f: &dyn Fn(f64, f64) -> f64| (f(force + dp, xi) - f(force - dp, xi)) / (2.0 * dp);
            let along_xi = |f: &dyn Fn(f64, f64) -> f64| (f(force, xi + dxi) - f(force, xi - dxi)) / (2.0 * dxi);
            let q0 = friction * force;
            assert_relative_eq!(law.dq_dp(), along_p(&q), epsilon = 1e-7 * friction);
            assert_relative_eq!(law.dq_dxi(), along_xi(&q), epsilon = 1e-7 * 3.0 * q0 / xi);
            assert_relative_eq!(law.de_dp(), along_p(&e), epsilon = 1e-7 * friction * xi);
            assert_relative_eq!(law.de_dxi(), along_xi(&e), epsilon = 1e-7 * 6.0 * q0);
        }
    }
}
