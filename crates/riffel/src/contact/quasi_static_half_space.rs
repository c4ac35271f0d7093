//! Rolling contact that answers at once, with the slopes of the exact creep curve.

use super::{
    ContactDerivative, ContactResponse, HalfSpace, HalfSpaceRolling, MeanRolling, Oscillating, RollingContact,
};
use crate::Error;

/// A [`HalfSpace`] that answers at once, by the slopes of its creep curve.
pub struct QuasiStaticHalfSpace {
    steady: MeanRolling,
    response: ContactResponse,
}

impl QuasiStaticHalfSpace {
    /// The slopes about a state to the load and what else oscillates.
    ///
    /// # Errors
    /// Errors of [`HalfSpace::response`].
    pub fn new(
        contact: &HalfSpace,
        state: &HalfSpaceRolling,
        oscillating: impl Into<Oscillating>,
    ) -> Result<Self, Error> {
        // Where the energy goes is the place of wear's to say.
        let at_once = |by: ContactDerivative| ContactDerivative { energy_at_rail: None, ..by };
        let response = contact.sweep(state, oscillating.into()).at(f64::INFINITY)?;
        Ok(Self {
            steady: contact.steady(state),
            response: ContactResponse {
                by_load: at_once(response.by_load),
                by_longitudinal: at_once(response.by_longitudinal),
                by_lateral: response.by_lateral.map(at_once),
                by_spin: response.by_spin.map(at_once),
                by_curvature: response.by_curvature.map(at_once),
            },
        })
    }
}

impl RollingContact for QuasiStaticHalfSpace {
    fn steady(&self) -> MeanRolling {
        self.steady
    }

    fn response(&self, _wavelength: f64) -> ContactResponse {
        self.response
    }
}
