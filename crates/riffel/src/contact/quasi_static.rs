//! A steady creep law as the rolling contact of the loop.

use num_complex::Complex64;

use super::{ContactResponse, CreepLaw, Creepages, ForceLimit, MeanRolling, RollingContact};
use crate::Error;

/// Any creep law, answering to oscillations as if each instant were steady.
///
/// The mean state has longitudinal creepage only. With e = ξQ: ∂e/∂P = ξ ∂Q/∂P and
/// ∂e/∂ξ = Q + ξ ∂Q/∂ξ. Range of validity: wavelengths much longer than the patch; below λ ≈ 40 a a
/// real contact answers visibly weaker and later.
///
/// The response is the same at every wavelength, so the law is linearised once, at construction: a loop asks
/// for it at every point of a map.
#[derive(Debug, Clone, PartialEq)]
pub struct QuasiStatic<L> {
    law: L,
    steady: MeanRolling,
    response: ContactResponse,
}

impl<L: CreepLaw> QuasiStatic<L> {
    /// Mean state given by the normal force P₀ \[N\] and the tractive ratio τ = Q₀/μP₀ \[-\], with the μ
    /// of [`CreepLaw::friction`].
    ///
    /// The creepage is bracketed between zero and the limit of the law and bisected to rounding.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless P₀ > 0 and 0 < τ < 1, and if the law does not reach τ at any
    /// creepage up to one; [`Error::BeyondAdhesion`] above its maximum of adhesion.
    pub fn from_tractive_ratio(
        law: L,
        normal_force: f64,
        tractive_ratio: f64,
    ) -> Result<Self, Error> {
        Error::unless_positive("normal force", normal_force, "N")?;
        let out_of_range = |rule| Error::OutOfRange {
            quantity: "tractive ratio",
            value: tractive_ratio,
            unit: "",
            rule,
        };
        if !(tractive_ratio > 0.0 && tractive_ratio < 1.0) {
            return Err(out_of_range("must lie between 0 and 1, both excluded"));
        }
        let target = tractive_ratio * law.friction() * normal_force;
        let force = |creepage: f64| {
            law.forces(normal_force, Creepages::longitudinal(creepage))
                .longitudinal
        };
        let limit = law.limit(normal_force);
        let (mut low, mut high) = (0.0, limit.creepage());
        if force(high) <= target {
            return Err(match limit {
                ForceLimit::AdhesionMaximum(_) => Error::BeyondAdhesion {
                    quantity: "tractive ratio",
                    value: tractive_ratio,
                    maximum: force(high) / (law.friction() * normal_force),
                },
                _ => out_of_range("is not reached by the creep law at any creepage"),
            });
        }
        loop {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if force(middle) < target {
                low = middle;
            } else {
                high = middle;
            }
        }
        Ok(Self::about(law, normal_force, high))
    }

    /// Mean state given by the normal force P₀ \[N\] and the creepage ξ₀ \[-\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless P₀ > 0 and ξ₀ > 0; [`Error::BeyondAdhesion`] from the law's maximum
    /// of adhesion on, [`Error::FullSlip`] from its full slip on.
    pub fn from_creepage(law: L, normal_force: f64, creepage: f64) -> Result<Self, Error> {
        Error::unless_positive("normal force", normal_force, "N")?;
        Error::unless_positive("creepage", creepage, "")?;
        let limit = law.limit(normal_force);
        if creepage >= limit.creepage() {
            return Err(match limit {
                ForceLimit::FullSlip(saturation_creepage) => Error::FullSlip {
                    creepage,
                    saturation_creepage,
                },
                ForceLimit::AdhesionMaximum(maximum) => Error::BeyondAdhesion {
                    quantity: "creepage",
                    value: creepage,
                    maximum,
                },
                ForceLimit::None => Error::OutOfRange {
                    quantity: "creepage",
                    value: creepage,
                    unit: "",
                    rule: "must be less than 1, the locked wheel",
                },
            });
        }
        Ok(Self::about(law, normal_force, creepage))
    }

    /// The law with its slopes at the mean state.
    fn about(law: L, normal_force: f64, creepage: f64) -> Self {
        let creepages = Creepages::longitudinal(creepage);
        let tangential_force = law.forces(normal_force, creepages).longitudinal;
        let slopes = law.derivatives(normal_force, creepages);
        let dq_dp = slopes.by_normal_force.longitudinal;
        let dq_dxi = slopes.by_longitudinal.longitudinal;
        Self {
            steady: MeanRolling {
                normal_force,
                friction: law.friction(),
                creepage,
                tangential_force,
            },
            response: ContactResponse {
                dq_dp: Complex64::from(dq_dp),
                dq_dxi: Complex64::from(dq_dxi),
                de_dp: Complex64::from(creepage * dq_dp),
                de_dxi: Complex64::from(tangential_force + creepage * dq_dxi),
                at_rail: None,
            },
            law,
        }
    }

    /// The creep law.
    pub fn law(&self) -> &L {
        &self.law
    }
}

impl<L: CreepLaw> RollingContact for QuasiStatic<L> {
    fn steady(&self) -> MeanRolling {
        self.steady
    }

    fn response(&self, _wavelength: f64) -> ContactResponse {
        self.response
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;
    use std::sync::atomic::{AtomicUsize, Ordering};

    use super::super::law::checks::ELLIPSE;
    use super::super::{
        Carter2d, CreepDerivatives, CreepForces, FallingFriction, Fastsim, JohnsonVermeulen,
        Polach, ShenHedrickElkins, SlopeReduction, TractionBound,
    };
    use super::*;
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    fn falling() -> Polach {
        let friction = FallingFriction {
            static_friction: 0.4,
            limit_ratio: 0.4,
            decay: 0.6,
        };
        Polach::new(ELLIPSE, friction, SlopeReduction::NONE, 20.0).unwrap()
    }

    fn laws() -> Vec<Arc<dyn CreepLaw>> {
        vec![
            Arc::new(Carter2d::of_ellipse(ELLIPSE, 0.3, 0.4).unwrap()),
            Arc::new(JohnsonVermeulen::new(ELLIPSE, 0.4).unwrap()),
            Arc::new(ShenHedrickElkins::new(ELLIPSE, 0.4).unwrap()),
            Arc::new(falling()),
            Arc::new(Fastsim::new(ELLIPSE, 0.4, TractionBound::Parabolic, 20).unwrap()),
            Arc::new(Fastsim::new(ELLIPSE, 0.4, TractionBound::Elliptic, 20).unwrap()),
        ]
    }

    proptest! {
        /// The force found is the force asked for. Bisection ends between neighbouring numbers; where
        /// full slip is near, the force is rounded to 1e-14 of μP.
        #[test]
        fn tractive_ratio_round_trip(force in 5e3..150e3, ratio in 0.001..0.9f64) {
            for law in laws() {
                let contact = QuasiStatic::from_tractive_ratio(law, force, ratio).unwrap();
                assert_relative_eq!(contact.steady().tractive_ratio(), ratio, epsilon = 1e-13);
                let again = QuasiStatic::from_creepage(
                    contact.law().clone(), force, contact.steady().creepage,
                ).unwrap();
                assert_eq!(again.steady(), contact.steady());
            }
        }

        /// e = ξQ: the response is that of the cubic in closed form, Carter3d's (9)–(12).
        #[test]
        fn response_of_the_cubic(force in 5e3..150e3, ratio in 0.001..0.99f64) {
            let law = JohnsonVermeulen::new(ELLIPSE, 0.4).unwrap();
            let contact = QuasiStatic::from_tractive_ratio(law, force, ratio).unwrap();
            let xi = contact.steady().creepage;
            let x = xi / law.limit(force).creepage();
            let response = contact.response(0.05);
            let limit = 0.4 * force;
            let close = |value: Complex64, exact: f64, scale: f64| {
                assert_relative_eq!(value.re, exact, epsilon = 1e-12 * scale);
                assert_eq!(value.im, 0.0);
            };
            close(response.dq_dp, 0.8 * x * (1.0 - x / 2.0), 1.0);
            close(response.dq_dxi, 3.0 * limit * x / xi * (1.0 - x).powi(2), limit / xi);
            close(response.de_dp, xi * 0.8 * x * (1.0 - x / 2.0), xi);
            close(response.de_dxi, 6.0 * limit * x * (1.0 - 1.5 * x * (1.0 - 4.0 / 9.0 * x)), limit);
        }
    }

    /// A law that counts how often it is asked for its slopes.
    struct Counted {
        law: JohnsonVermeulen,
        linearised: AtomicUsize,
    }

    impl CreepLaw for Counted {
        fn friction(&self) -> f64 {
            self.law.friction()
        }

        fn forces(&self, normal_force: f64, creepages: Creepages) -> CreepForces {
            self.law.forces(normal_force, creepages)
        }

        fn derivatives(&self, normal_force: f64, creepages: Creepages) -> CreepDerivatives {
            self.linearised.fetch_add(1, Ordering::Relaxed);
            self.law.derivatives(normal_force, creepages)
        }

        fn limit(&self, normal_force: f64) -> ForceLimit {
            self.law.limit(normal_force)
        }
    }

    #[test]
    fn the_law_is_linearised_once() {
        let law = Counted {
            law: JohnsonVermeulen::new(ELLIPSE, 0.4).unwrap(),
            linearised: AtomicUsize::new(0),
        };
        let contact = QuasiStatic::from_tractive_ratio(law, 50e3, 0.1).unwrap();
        let responses: Vec<_> = (1..100)
            .map(|mm| contact.response(1e-3 * f64::from(mm)))
            .collect();
        assert!(responses.iter().all(|response| *response == responses[0]));
        assert_eq!(contact.law().linearised.load(Ordering::Relaxed), 1);
    }

    #[test]
    fn refusals_name_their_reason() {
        let law = JohnsonVermeulen::new(ELLIPSE, 0.4).unwrap();
        let refusal = |error: Error| error.to_string();
        let slip = refusal(QuasiStatic::from_creepage(law, 50e3, 0.02).unwrap_err());
        assert!(slip.contains("full slip begins at"), "{slip}");
        let beyond = refusal(QuasiStatic::from_creepage(falling(), 50e3, 0.1).unwrap_err());
        assert!(beyond.contains("below the maximum of adhesion"), "{beyond}");
        let high = refusal(QuasiStatic::from_tractive_ratio(falling(), 50e3, 0.999).unwrap_err());
        assert!(high.contains("below the maximum of adhesion"), "{high}");
        let negative = refusal(QuasiStatic::from_tractive_ratio(law, 50e3, -0.1).unwrap_err());
        assert!(negative.contains("between 0 and 1"), "{negative}");
    }
}
