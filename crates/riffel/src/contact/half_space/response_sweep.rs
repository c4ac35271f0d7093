//! Responses of both grids, extrapolated.

use std::f64::consts::PI;

use super::grid_sweep::{Found, GridSweep, TOLERANCE};
use super::input::Input;
use super::response::Response;
use super::{HalfSpace, HalfSpaceRolling, REMEDY};
use crate::Error;
use crate::contact::{ContactDerivative, ContactResponse, Creepages, GridError};

/// Responses of a [`HalfSpace`] about one steady state, one wavelength after the other: each begins with what those
/// before have found.
pub(in crate::contact) struct ResponseSweep<'a> {
    contact: &'a HalfSpace,
    creepages: Creepages,
    inputs: Vec<Input>,
    fine: GridSweep<'a>,
    coarse: GridSweep<'a>,
}

/// What [`ResponseSweep`] have found on both grids.
pub(in crate::contact) struct FoundResponses {
    fine: Found,
    coarse: Found,
}

impl<'a> ResponseSweep<'a> {
    pub(super) fn new(contact: &'a HalfSpace, state: &'a HalfSpaceRolling, inputs: &[Input]) -> Self {
        let creepages = state.creepages;
        let sweep = |grid, steady| GridSweep::new(grid, steady, creepages, inputs);
        Self {
            contact,
            creepages,
            inputs: inputs.to_vec(),
            fine: sweep(&contact.fine, &state.fine),
            coarse: sweep(&contact.coarse, &state.coarse),
        }
    }

    /// Begin anew with what some wavelengths have found.
    pub(in crate::contact) fn begin_with(&mut self, found: &[&FoundResponses]) {
        let fine: Vec<&Found> = found.iter().map(|found| &found.fine).collect();
        let coarse: Vec<&Found> = found.iter().map(|found| &found.coarse).collect();
        self.fine.begin_with(&fine);
        self.coarse.begin_with(&coarse);
    }

    /// All that has been found since the beginning.
    pub(in crate::contact) fn found(&self) -> FoundResponses {
        FoundResponses { fine: self.fine.found(), coarse: self.coarse.found() }
    }

    /// The response at a wavelength \[m\].
    ///
    /// # Errors
    /// Errors of [`HalfSpace::response`].
    pub(in crate::contact) fn at(&mut self, wavelength: f64) -> Result<ContactResponse, Error> {
        self.contact.check_wavelength(wavelength)?;
        let responses = self.extrapolated(2.0 * PI / wavelength)?;
        let by = |input: Input, per_unit: f64| {
            let place = self.inputs.iter().position(|other| *other == input)?;
            let (response, error) = responses[place];
            Some(ContactDerivative {
                force: response.force.map(|force| force * per_unit),
                energy: response.dissipation * per_unit,
                energy_at_rail: Some(response.rail_dissipation * per_unit),
                error: Some(GridError { force: error.force * per_unit, energy: error.energy * per_unit }),
            })
        };
        let load = self.contact.hertz.normal_force();
        Ok(ContactResponse {
            by_load: by(Input::Load, load.recip()).expect("every sweep has both"),
            by_longitudinal: by(Input::Longitudinal, 1.0).expect("every sweep has both"),
            by_lateral: by(Input::Lateral, 1.0),
            by_spin: by(Input::Spin, 1.0),
            by_curvature: by(Input::Profile, 1.0),
        })
    }

    /// Extrapolated responses to the inputs at a wavenumber \[rad/m\], and what the grid may miss of them.
    pub(super) fn extrapolated(&mut self, wavenumber: f64) -> Result<Vec<(Response, GridError)>, Error> {
        let failure = |residual| Error::NotConverged {
            problem: "frequency response of rolling contact",
            residual,
            tolerance: TOLERANCE,
            remedy: REMEDY,
        };
        let fine = self.fine.at(wavenumber).map_err(failure)?;
        let coarse = self.coarse.at(wavenumber).map_err(failure)?;
        // Creepage at the edge of the patch, a length for the spin: what energy is measured by where it vanishes.
        let hertz = &self.contact.hertz;
        let reach = hertz.semi_axis_longitudinal().max(hertz.semi_axis_lateral());
        let creepage = self.creepages.magnitude().hypot(self.creepages.spin * reach);
        let across = self.contact.fine.patch.across;
        let both = fine.into_iter().zip(coarse);
        Ok(both
            .map(|(fine, coarse)| {
                let response = fine.extrapolated(coarse);
                (response, response.error(fine, coarse, creepage, across))
            })
            .collect())
    }
}
