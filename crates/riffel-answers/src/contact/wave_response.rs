//! What the geometry of a wave does to the exact contact over wavelength.

use std::f64::consts::TAU;

use riffel::Complex64;
use riffel::contact::{ContactResponse, CurvatureFilter};
use riffel_keys::CaseError;
use riffel_plot::{LinePanel, OKABE_ITO, Scale, Series};
use serde::Serialize;

use super::line;
use super::theories::{RollingTheories, refused};
use crate::{Column, Rows};

/// Responses per κ = R k² Δ under a constant load and slip speed, one for each wavelength.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WaveResponse {
    /// T = e₁/e₀: energy left at a point of the rail.
    #[serde(rename = "rail_dissipation", serialize_with = "crate::complex::as_pairs")]
    pub energy: Vec<Complex64>,
    /// T_Q: creep force along that of the mean state, over it.
    #[serde(serialize_with = "crate::complex::as_pairs")]
    pub force: Vec<Complex64>,
    /// Φ: T of a contact that slides everywhere.
    pub phi: Vec<f64>,
    /// What the grid of the contact may miss of T and of T_Q, upper bounds of the modulus of the error.
    #[serde(skip)]
    pub errors: [Vec<f64>; 2],
}

impl WaveResponse {
    pub(super) fn new(
        theories: &RollingTheories,
        responses: &[ContactResponse],
        ratios: &[f64],
    ) -> Result<Self, CaseError> {
        let filter = CurvatureFilter::of(&theories.hertz).map_err(refused("the ellipse"))?;
        let wavenumber = |ratio: &f64| TAU / (ratio * theories.hertz.semi_axis_longitudinal());
        let steady = theories.half_space.steady(&theories.state);
        let (energy, [along, across]) =
            (steady.energy_per_metre(), [steady.forces.longitudinal, steady.forces.lateral]);
        let force = along.hypot(across);
        let by = || responses.iter().filter_map(|response| response.by_curvature);
        let share = |force_1: [Complex64; 2]| (force_1[0] * along + force_1[1] * across) / (force * force);
        let errors = || by().filter_map(|by| by.error);
        Ok(Self {
            energy: by().map(|by| by.at_rail(0.0) / energy).collect(),
            force: by().map(|by| share(by.force)).collect(),
            phi: ratios.iter().map(|ratio| filter.share(wavenumber(ratio))).collect(),
            errors: [
                errors().map(|error| error.energy / energy).collect(),
                errors().map(|error| error.force / force).collect(),
            ],
        })
    }

    pub(super) fn columns(&self) -> impl Iterator<Item = Column> {
        let energy = Column::complex("wave_energy", self.energy.iter().copied());
        let force = Column::complex("wave_force", self.force.iter().copied());
        energy.into_iter().chain(force).chain([self.phi.exact("phi", |&value| value)])
    }

    pub(super) fn panel(&self, ratios: &[f64]) -> LinePanel {
        let parts =
            |values: &[Complex64], part: fn(&Complex64) -> f64| -> Vec<f64> { values.iter().map(part).collect() };
        let curves = [
            ("energy left on rail, in phase with the wave", parts(&self.energy, |t| t.re), 1),
            ("the same, behind it by a quarter of a wave", parts(&self.energy, |t| -t.im), 4),
            ("sliding everywhere, Φ", self.phi.clone(), 2),
        ];
        let series =
            curves.map(|(name, values, color)| Series { color: Some(OKABE_ITO[color]), ..line(name, ratios, &values) });
        LinePanel::new("wavelength λ/a [-]", "e₁/e₀ over R k²Δ [-]", series)
            .titled("geometry of a wave, under constant load and slip speed")
            .scaled(Scale::Log, Scale::Linear)
    }
}
