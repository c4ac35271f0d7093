//! Rolling contact by all theories.

mod contact_patch;
mod creep_curves;
mod frequency_response;
mod patch;
mod question;
mod theories;
mod wave_response;
mod words;

use riffel_keys::{CaseError, Message, say};
use riffel_plot::{Arrangement, LineFigure, Series};
use serde::Serialize;

pub use contact_patch::ContactPatch;
pub use creep_curves::{CreepCurve, CreepCurves};
pub use frequency_response::{FrequencyResponse, InputResponse, OutputResponse};
pub use question::ContactQuestion;
pub use theories::RollingTheories;
pub use wave_response::WaveResponse;

use crate::parameters::{creepage, polach};
use crate::{Answer, ResultFile, Table};

/// What is asked of the contact of a case.
#[derive(Debug, Clone)]
pub struct ContactRequest {
    /// Creepages of the creep curves \[-\]; by default equally spaced to beyond full slip.
    pub creepages: Option<Vec<f64>>,
    /// Wavelengths of the responses in semi-axes \[-\]; by default equally spaced in their logarithm.
    pub ratios: Option<Vec<f64>>,
}

/// The contact of a case by all theories: creep curves and responses to small oscillations.
#[derive(Serialize)]
pub struct ContactAnswer {
    #[serde(flatten)]
    patch: ContactPatch,
    #[serde(rename = "creep_curve")]
    curves: CreepCurves,
    /// About the mean state; none near full slip, where no slope is left.
    #[serde(rename = "frequency_response")]
    response: Option<FrequencyResponse>,
    /// And the mean state by the exact one.
    #[serde(skip)]
    theories: RollingTheories,
    #[serde(skip)]
    remarks: Vec<Message>,
}

impl ContactAnswer {
    /// The contact by the theories; `progress` is told of every sample and of one more.
    ///
    /// # Errors
    /// [`CaseError::Physics`] where a wavelength is not resolved or the exact theory does not converge.
    pub fn new(theories: RollingTheories, request: ContactRequest, progress: impl Fn()) -> Result<Self, CaseError> {
        let ratios = request.ratios;
        let ratios = ratios.unwrap_or_else(FrequencyResponse::default_ratios);
        let creepages = request.creepages;
        let creepages = creepages.unwrap_or_else(|| theories.default_creepages());
        // First what is refused soonest.
        let response =
            theories.check_slope().is_ok().then(|| FrequencyResponse::new(&theories, ratios, &progress)).transpose()?;
        let curves = CreepCurves::new(&theories, creepages, &progress)?;
        let mut remarks = theories.contact.remarks.clone();
        if !curves.left_out.is_empty() {
            let percent = |creepage: &f64| format!("{:.4} %", 100.0 * creepage);
            let creepages: Vec<String> = curves.left_out.iter().map(percent).collect();
            remarks.push(say!(
                creepages_left_out,
                creepages = creepages.join(", "),
                grid = theories.contact.file.contact.grid
            ));
        }
        let patch = ContactPatch::new(&theories.hertz, theories.laws.kalker, &theories.steady);
        Ok(Self { patch, curves, response, theories, remarks })
    }
}

impl Answer for ContactAnswer {
    fn name(&self) -> &'static str {
        "contact"
    }

    fn introduction(&self) -> Vec<Message> {
        words::introduction(&self.theories, self.response.is_some())
    }

    fn tables(&self) -> Vec<Table> {
        let response = self.response.as_ref().map(frequency_response::table);
        let curves = [creep_curves::shown(&self.curves), creep_curves::table(&self.curves)];
        curves.into_iter().chain(response).chain([patch::table(&self.theories)]).collect()
    }

    fn figure(&self) -> LineFigure {
        let Self { theories, curves, response, .. } = self;
        let mut panels = vec![creep_curves::panel(curves, theories)];
        panels.extend(response.iter().flat_map(frequency_response::panels));
        LineFigure::new(
            "Rolling contact: creep curves and frequency response",
            format!(
                "Responses of the half-space about its mean state, exp(+iωt); the energy left on the rail is that of \
                 the whole passage, relative to the instant at which the wheel centre passes. {}",
                parameters(theories)
            ),
            panels,
        )
        .arranged(Arrangement::Stacked)
    }

    fn files(&self) -> Vec<ResultFile<'_>> {
        let figures = [("contact", self.figure()), ("patch", patch::figure(&self.theories))];
        let figures = figures.map(|(name, figure)| ResultFile::Lines(name, figure));
        figures.into_iter().chain(ResultFile::tables(self.tables())).collect()
    }

    fn remarks(&self) -> &[Message] {
        &self.remarks
    }
}

/// The parameters of the contact in one sentence.
fn parameters(patch: &RollingTheories) -> String {
    let file = &patch.contact.file;
    let creepages = patch.half_space.steady(&patch.state).creepages;
    let creepage = match patch.along_rail() {
        true => format!("ξ₀ = {:.4} %", 100.0 * creepages.longitudinal),
        false => creepage(creepages),
    };
    let material = patch.hertz.material();
    format!(
        "E = {:.0} GPa, ν = {}; R = {:.2} m, R_r = {:.2} m, P = {:.0} kN, μ = {}; ellipse {:.2} × {:.2} mm; \
         mean state τ = {:.3}, {creepage}; {} elements over a diameter{}.",
        1e-9 * file.steel.youngs_modulus.si(),
        material.poisson_ratio(),
        patch.hertz.rolling_radius(),
        file.contact.transverse_radius.si(),
        1e-3 * patch.hertz.normal_force(),
        patch.friction,
        2e3 * patch.hertz.semi_axis_longitudinal(),
        2e3 * patch.hertz.semi_axis_lateral(),
        patch.exact_tractive_ratio(),
        file.contact.grid,
        match polach(file).as_str() {
            "" => String::new(),
            words => format!("; Polach{words}"),
        },
    )
}

/// A curve from left to right, in whichever order its samples were asked for.
fn line(label: &str, x: &[f64], y: &[f64]) -> Series {
    let mut samples: Vec<(f64, f64)> = x.iter().copied().zip(y.iter().copied()).collect();
    samples.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (x, y) = samples.into_iter().unzip();
    Series::new(label, x, y)
}
