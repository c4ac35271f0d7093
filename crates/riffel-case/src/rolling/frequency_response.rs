//! Responses of the exact contact to small oscillations over wavelength.

use riffel::Complex64;
use riffel::contact::ContactResponse;
use riffel_keys::CaseError;

use super::{RollingTheories, refused};

/// Normalised responses to one input, 1 for long wavelengths.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ResponseOutputs {
    /// Tangential force.
    pub force: Vec<Complex64>,
    /// Dissipated energy.
    pub dissipation: Vec<Complex64>,
    /// Energy left on the rail by the whole passage.
    pub rail_dissipation: Vec<Complex64>,
}

impl ResponseOutputs {
    fn push(&mut self, [force, dissipation, rail_dissipation]: [Complex64; 3]) {
        self.force.push(force);
        self.dissipation.push(dissipation);
        self.rail_dissipation.push(rail_dissipation);
    }

    /// The outputs with their keys and names in figures.
    pub fn all(&self) -> [(&'static str, &'static str, &[Complex64]); 3] {
        [
            ("force", "force", &self.force),
            ("dissipation", "dissipation", &self.dissipation),
            (
                "rail_dissipation",
                "energy left on rail",
                &self.rail_dissipation,
            ),
        ]
    }
}

/// Response at each wavelength divided by the quasi-static one.
#[derive(Debug, Clone, PartialEq)]
pub struct FrequencyResponse {
    /// Wavelengths in longitudinal semi-axes λ/a \[-\].
    pub ratios: Vec<f64>,
    /// By an oscillation of creepage.
    pub creepage: ResponseOutputs,
    /// By an oscillation of the normal load.
    pub load: ResponseOutputs,
}

impl FrequencyResponse {
    /// The responses at some wavelengths λ/a; `progress` is told of each of them and of one more.
    ///
    /// # Errors
    /// [`CaseError::Physics`] where the grid does not resolve a wavelength or the theory does not converge.
    pub fn new(
        theories: &RollingTheories,
        ratios: Vec<f64>,
        progress: impl Fn(),
    ) -> Result<Self, CaseError> {
        let at = |wavelength: f64, input: String| -> Result<ContactResponse, CaseError> {
            let response = theories.half_space.response(&theories.state, wavelength);
            progress();
            response.map_err(refused(input))
        };
        let slow = at(f64::INFINITY, "the mean state of the case".to_owned())?;
        let (mut creepage, mut load) = (ResponseOutputs::default(), ResponseOutputs::default());
        for &ratio in &ratios {
            let wavelength = ratio * theories.hertz.semi_axis_longitudinal();
            let response = at(wavelength, format!("λ/a = {ratio}"))?;
            let rail = [
                response.by_load.at_rail(0.0),
                response.by_longitudinal.at_rail(0.0),
            ];
            creepage.push([
                response.by_longitudinal.force[0] / slow.by_longitudinal.force[0],
                response.by_longitudinal.energy / slow.by_longitudinal.energy,
                rail[1] / slow.by_longitudinal.energy,
            ]);
            load.push([
                response.by_load.force[0] / slow.by_load.force[0],
                response.by_load.energy / slow.by_load.energy,
                rail[0] / slow.by_load.energy,
            ]);
        }
        Ok(Self {
            ratios,
            creepage,
            load,
        })
    }

    /// Wavelengths in semi-axes λ/a, some equally spaced in their logarithm.
    pub fn default_ratios() -> Vec<f64> {
        const POINTS: u32 = 61;
        const SHORTEST: f64 = 2.0;
        const LONGEST: f64 = 100.0;
        let last = POINTS - 1;
        (0..POINTS)
            .map(|index| match index {
                0 => SHORTEST,
                _ if index == last => LONGEST,
                _ => SHORTEST * (LONGEST / SHORTEST).powf(f64::from(index) / f64::from(last)),
            })
            .collect()
    }

    /// The inputs with their keys.
    pub fn inputs(&self) -> [(&'static str, &ResponseOutputs); 2] {
        [("creepage", &self.creepage), ("load", &self.load)]
    }
}
