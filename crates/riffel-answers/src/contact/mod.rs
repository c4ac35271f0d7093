//! Rolling contact by all theories.

mod creep_curves;
mod document;
mod frequency_response;
mod patch;
mod theories;
mod wave_response;

use std::io::{self, Write};

use riffel_keys::{CaseError, Message, say};
use riffel_plot::{Arrangement, LineFigure, Series};

pub use creep_curves::{CreepCurve, CreepCurves};
pub use document::{ContactDocument, SteadyDocument};
pub use frequency_response::{FrequencyResponse, InputResponse, OutputResponse};
pub use theories::RollingTheories;
pub use wave_response::WaveResponse;

use crate::parameters::{creepage, polach};

/// What is asked of the contact of a case.
#[derive(Debug, Clone)]
pub struct ContactRequest {
    /// Creepages of the creep curves \[-\]; by default equally spaced to beyond full slip.
    pub creepages: Option<Vec<f64>>,
    /// Wavelengths of the responses in semi-axes \[-\]; by default equally spaced in their logarithm.
    pub ratios: Option<Vec<f64>>,
}

/// The contact of a case by all theories: creep curves and responses to small oscillations.
pub struct ContactAnswer {
    /// The theories, and the mean state by the exact one.
    pub theories: RollingTheories,
    /// Creep curves of all laws.
    pub curves: CreepCurves,
    /// Responses about the mean state; none near full slip, where no slope is left.
    pub response: Option<FrequencyResponse>,
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
        Ok(Self { theories, curves, response })
    }

    /// The contact as data: what `riffel contact --json` prints.
    pub fn document(&self) -> ContactDocument {
        document::document(&self.theories, &self.curves, self.response.as_ref())
    }

    /// Creep curves, and modulus and phase of the responses.
    pub fn figure(&self) -> LineFigure {
        let Self { theories, curves, response } = self;
        let mut panels = vec![creep_curves::panel(curves, theories)];
        panels.extend(response.iter().flat_map(frequency_response::panels));
        LineFigure {
            title: "Rolling contact: creep curves and frequency response".to_owned(),
            caption: format!(
                "Responses of the half-space about its mean state, exp(+iωt); the energy left on the rail is that of \
                 the whole passage, relative to the instant at which the wheel centre passes. {}",
                parameters(theories)
            ),
            panels,
            arrangement: Arrangement::Stacked,
        }
    }

    /// What the reader should know about it.
    pub fn remarks(&self) -> Vec<Message> {
        let mut remarks = self.theories.contact.remarks.clone();
        if !self.curves.left_out.is_empty() {
            let percent = |creepage: &f64| format!("{:.4} %", 100.0 * creepage);
            let creepages: Vec<String> = self.curves.left_out.iter().map(percent).collect();
            remarks.push(say!(
                creepages_left_out,
                creepages = creepages.join(", "),
                grid = self.theories.contact.file.contact.grid
            ));
        }
        remarks
    }

    /// Stick, slip and tractions of the mean state.
    pub fn patch_figure(&self) -> LineFigure {
        patch::figure(&self.theories)
    }

    /// The elements of the patch, one row for each.
    ///
    /// # Errors
    /// Those of the file.
    pub fn patch_csv(&self, file: &mut impl Write) -> io::Result<()> {
        patch::table(&self.theories, file)
    }

    /// One row for each creepage, a column for each law.
    ///
    /// # Errors
    /// Those of the file.
    pub fn creep_curve_csv(&self, file: &mut impl Write) -> io::Result<()> {
        creep_curves::table(&self.curves, file)
    }

    /// One row for each wavelength; none where there is no response.
    ///
    /// # Errors
    /// Those of the file.
    pub fn frequency_response_csv(&self, file: &mut impl Write) -> io::Result<()> {
        let response = self.response.as_ref();
        response.map_or(Ok(()), |response| frequency_response::table(response, file))
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
    Series { label: label.to_owned(), x, y, ..Series::default() }
}
