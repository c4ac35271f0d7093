//! Wear in proportion to the normal force.

use std::sync::Arc;

use num_complex::Complex64;

use super::{ContactDerivative, ContactResponse, MeanRolling, RollingContact};

/// A rolling contact that takes away the surface in proportion to the normal force of the moment, e₁ = (e₀/P₀) P₁,
/// whatever it creeps: flow and crushing, a road under tyres. Creep forces are those of the contact it wraps, and the
/// mean wear is what that one spends, so that growth rates compare.
///
/// Then corrugation grows exactly where Re P₁/Δ < 0, the force smallest on the crests: below the resonance of a mass on
/// a spring, above it the surface is levelled.
///
/// Source: R. M. Carson, K. L. Johnson, *Wear* 17 (1971), for discs on the spring of their contact; J. A. Both,
/// D. C. Hong, D. A. Kurtze, *Physica A* 301 (2001), for the road under sprung masses. Range of validity: amplitudes at
/// which the surface yields on every wave; a threshold of plastic flow is left out.
#[derive(Clone)]
pub struct LoadWear {
    contact: Arc<dyn RollingContact>,
}

impl LoadWear {
    /// The wear of a contact in proportion to its normal force.
    pub fn new(contact: Arc<dyn RollingContact>) -> Self {
        Self { contact }
    }
}

impl RollingContact for LoadWear {
    fn steady(&self) -> MeanRolling {
        self.contact.steady()
    }

    fn known_from(&self) -> f64 {
        self.contact.known_from()
    }

    fn response(&self, wavelength: f64) -> ContactResponse {
        let ContactResponse { by_load, by_longitudinal, by_lateral, by_spin, by_curvature } =
            self.contact.response(wavelength);
        let steady = self.steady();
        let wearing = |by: ContactDerivative, energy: f64| {
            let energy = Complex64::from(energy);
            ContactDerivative {
                energy,
                // Under the wheel, not later in the patch.
                energy_at_rail: Some(energy),
                error: None,
                ..by
            }
        };
        let idle = |by| wearing(by, 0.0);
        ContactResponse {
            by_load: wearing(by_load, steady.energy_per_metre() / steady.normal_force),
            by_longitudinal: idle(by_longitudinal),
            by_lateral: by_lateral.map(idle),
            by_spin: by_spin.map(idle),
            by_curvature: by_curvature.map(idle),
        }
    }
}
