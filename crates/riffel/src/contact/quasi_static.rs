//! A steady creep law as the rolling contact of the loop.

use num_complex::Complex64;

use super::{
    ContactDerivative, ContactResponse, CreepForces, CreepLaw, Creepages, ForceLimit, MeanRolling, MeanState,
    RollingContact, WaveGeometry,
};
use crate::Error;

/// Any creep law, answering to oscillations as if each instant were steady.
///
/// With e = ξ·Q: ∂e/∂P = ξ·∂Q/∂P and ∂e/∂ξ = Q + ξ·∂Q/∂ξ, for both components of the creepage; a moment of spin is
/// left out. Spin, which no law tells the slope of, has a central difference over 2·10⁻³ 1/m. Range of validity: wavelengths much longer than the patch; below
/// λ ≈ 40 a a real contact answers visibly weaker and later.
///
/// The response is the same at every wavelength, so the law is linearised once, at construction: a loop asks
/// for it at every point of a map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct QuasiStatic<L> {
    law: L,
    steady: MeanRolling,
    response: ContactResponse,
}

/// Step of the difference by spin \[1/m\]: on the rim of a patch of 5 mm a creepage of 5·10⁻⁶, small beside those of any mean
/// state, and the force changes by parts in 10⁴ of friction, ten digits above rounding.
const SPIN_STEP: f64 = 1e-3;

impl<L: CreepLaw> QuasiStatic<L> {
    /// A law about a mean state under the normal force P₀ \[N\]. A tractive ratio refers to the μ of
    /// [`CreepLaw::friction`].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless P₀ > 0, 0 < τ < 1 and the creepage is not zero (longitudinal creepage alone: is
    /// positive), and if the law does not reach τ at any creepage up to one; [`Error::BeyondAdhesion`] from the law's maximum
    /// of adhesion on, [`Error::FullSlip`] from its full slip on, in longitudinal creepage alone. A vector of creepages may
    /// slide everywhere. A law of full sliding takes every creepage but zero, and no tractive ratio.
    pub fn new(law: L, normal_force: f64, mean: MeanState) -> Result<Self, Error> {
        Error::unless_positive("normal force", normal_force, "N")?;
        let creepages = match mean {
            MeanState::TractiveRatio(ratio) => Creepages::longitudinal(creepage_at(&law, normal_force, ratio)?),
            MeanState::Creepages(creepages) => {
                check(&law, normal_force, creepages)?;
                creepages
            }
        };
        Ok(Self::about(law, normal_force, creepages))
    }

    /// The law with its slopes at the mean state.
    fn about(law: L, normal_force: f64, creepages: Creepages) -> Self {
        let forces = law.forces(normal_force, creepages);
        let slopes = law.derivatives(normal_force, creepages);
        let with_spin = |change: f64| {
            let spin = creepages.spin + change;
            law.forces(normal_force, Creepages { spin, ..creepages })
        };
        let by_spin = with_spin(SPIN_STEP).combine(0.5 / SPIN_STEP, with_spin(-SPIN_STEP), -0.5 / SPIN_STEP);
        let derivative = |force: CreepForces, energy: f64| ContactDerivative {
            force: [force.longitudinal.into(), force.lateral.into()],
            energy: Complex64::from(
                energy + creepages.longitudinal * force.longitudinal + creepages.lateral * force.lateral,
            ),
            energy_at_rail: None,
            error: None,
        };
        Self {
            steady: MeanRolling { normal_force, friction: law.friction(), creepages, forces },
            response: ContactResponse {
                by_load: derivative(slopes.by_normal_force, 0.0),
                by_longitudinal: derivative(slopes.by_longitudinal, forces.longitudinal),
                by_lateral: Some(derivative(slopes.by_lateral, forces.lateral)),
                by_spin: Some(derivative(by_spin, 0.0)),
                by_curvature: None,
            },
            law,
        }
    }

    /// Contact on waves; `law` is that of the wheel of the radius R/(1 + κ).
    ///
    /// Method: [`WaveGeometry::derivative`], which for a law in the creepages over ab·C_ii is −F_ξ ξ₀σ₁ − F_η η₀σ₂,
    /// σ_i = −d ln(ab C_ii)/dκ, to 1e-11 of friction (test `curvature_of_a_scaled_law`).
    ///
    /// # Errors
    /// Errors of `law`.
    pub fn on_waves<M: CreepLaw, E>(self, law: impl Fn(f64) -> Result<M, E>) -> Result<Self, E> {
        const STEP: f64 = 1e-3;
        let steady = self.steady;
        let [longitudinal, lateral] = WaveGeometry::derivative(STEP, |curvature| {
            let forces = law(curvature)?.forces(steady.normal_force, steady.creepages);
            Ok([forces.longitudinal, forces.lateral])
        })?;
        let by_radius = CreepForces { longitudinal, lateral };
        Ok(Self { response: self.response.with_curvature(by_radius, &steady), ..self })
    }

    /// The creep law.
    pub fn law(&self) -> &L {
        &self.law
    }
}

/// The longitudinal creepage \[-\] of a tractive ratio.
fn creepage_at(law: &impl CreepLaw, normal_force: f64, ratio: f64) -> Result<f64, Error> {
    MeanState::check_tractive_ratio(ratio)?;
    let most = law.friction() * normal_force;
    law.creepage(normal_force, ratio).ok_or_else(|| {
        let limit = law.limit(normal_force);
        match limit {
            ForceLimit::AdhesionMaximum(creepage) => Error::BeyondAdhesion {
                quantity: "tractive ratio",
                value: ratio,
                maximum: law.forces(normal_force, Creepages::longitudinal(creepage)).longitudinal / most,
            },
            ForceLimit::FullSlip(0.0) => Error::OutOfRange {
                quantity: "tractive ratio",
                value: ratio,
                unit: "",
                rule: "is no mean state of a law of full sliding, whose force is friction times load: give a creepage",
            },
            _ => Error::OutOfRange {
                quantity: "tractive ratio",
                value: ratio,
                unit: "",
                rule: "is not reached by the creep law at any creepage",
            },
        }
    })
}

/// `Ok` if the law has slopes at the creepages.
fn check(law: &impl CreepLaw, normal_force: f64, creepages: Creepages) -> Result<(), Error> {
    let sliding = law.limit(normal_force) == ForceLimit::FullSlip(0.0);
    let alone = creepages == Creepages::longitudinal(creepages.longitudinal.abs());
    if sliding || !alone {
        return Error::unless_positive("magnitude of the creepage", creepages.magnitude(), "");
    }
    let creepage = creepages.longitudinal;
    Error::unless_positive("creepage", creepage, "")?;
    let limit = law.limit(normal_force);
    if creepage < limit.creepage() {
        return Ok(());
    }
    Err(match limit {
        ForceLimit::FullSlip(saturation_creepage) => Error::FullSlip { creepage, saturation_creepage },
        ForceLimit::AdhesionMaximum(maximum) => {
            Error::BeyondAdhesion { quantity: "creepage", value: creepage, maximum }
        }
        ForceLimit::None => Error::OutOfRange {
            quantity: "creepage",
            value: creepage,
            unit: "",
            rule: "must be less than 1, the locked wheel",
        },
    })
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
        Carter2d, CreepDerivatives, FallingFriction, Fastsim, JohnsonVermeulen, Polach, ShenHedrickElkins,
        SlopeReduction, TractionBound,
    };
    use super::*;
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    fn falling() -> Polach {
        let friction = FallingFriction { static_friction: 0.4, limit_ratio: 0.4, decay: 0.6 };
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
                let contact = QuasiStatic::new(law, force, MeanState::TractiveRatio(ratio)).unwrap();
                assert_relative_eq!(contact.steady().tractive_ratio(), ratio, epsilon = 1e-13);
                let again = QuasiStatic::new(
                    contact.law().clone(), force, MeanState::Creepages(contact.steady().creepages),
                ).unwrap();
                assert_eq!(again.steady(), contact.steady());
            }
        }

        /// e = ξQ: the response is that of the cubic in closed form, Carter3d's (9)–(12).
        #[test]
        fn response_of_the_cubic(force in 5e3..150e3, ratio in 0.001..0.99f64) {
            let law = JohnsonVermeulen::new(ELLIPSE, 0.4).unwrap();
            let contact = QuasiStatic::new(law, force, MeanState::TractiveRatio(ratio)).unwrap();
            let xi = contact.steady().creepages.longitudinal;
            let x = xi / law.limit(force).creepage();
            let response = contact.response(0.05);
            let limit = 0.4 * force;
            let close = |value: Complex64, exact: f64, scale: f64| {
                assert_relative_eq!(value.re, exact, epsilon = 1e-12 * scale);
                assert_eq!(value.im, 0.0);
            };
            close(response.by_load.force[0], 0.8 * x * (1.0 - x / 2.0), 1.0);
            close(response.by_longitudinal.force[0], 3.0 * limit * x / xi * (1.0 - x).powi(2), limit / xi);
            close(response.by_load.energy, xi * 0.8 * x * (1.0 - x / 2.0), xi);
            close(response.by_longitudinal.energy, 6.0 * limit * x * (1.0 - 1.5 * x * (1.0 - 4.0 / 9.0 * x)), limit);
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
        let law = Counted { law: JohnsonVermeulen::new(ELLIPSE, 0.4).unwrap(), linearised: AtomicUsize::new(0) };
        let contact = QuasiStatic::new(law, 50e3, MeanState::TractiveRatio(0.1)).unwrap();
        let responses: Vec<_> = (1..100).map(|mm| contact.response(1e-3 * f64::from(mm))).collect();
        assert!(responses.iter().all(|response| *response == responses[0]));
        assert_eq!(contact.law().linearised.load(Ordering::Relaxed), 1);
    }

    #[test]
    fn refusals_name_their_reason() {
        let law = JohnsonVermeulen::new(ELLIPSE, 0.4).unwrap();
        let refusal = |error: Error| error.to_string();
        let slip = refusal(QuasiStatic::new(law, 50e3, MeanState::creepage(0.02)).unwrap_err());
        assert!(slip.contains("full slip begins at"), "{slip}");
        let beyond = refusal(QuasiStatic::new(falling(), 50e3, MeanState::creepage(0.1)).unwrap_err());
        assert!(beyond.contains("below the maximum of adhesion"), "{beyond}");
        let high = refusal(QuasiStatic::new(falling(), 50e3, MeanState::TractiveRatio(0.999)).unwrap_err());
        assert!(high.contains("below the maximum of adhesion"), "{high}");
        let negative = refusal(QuasiStatic::new(law, 50e3, MeanState::TractiveRatio(-0.1)).unwrap_err());
        assert!(negative.contains("between 0 and 1"), "{negative}");
    }
}
