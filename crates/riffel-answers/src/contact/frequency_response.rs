//! Responses of the exact contact to small oscillations over wavelength.

use std::io::{self, Write};

use riffel::{Complex64, contact::ContactResponse};
use riffel_keys::CaseError;
use riffel_plot::{LinePanel, LineStyle, OKABE_ITO, Scale, Series};

use super::line;
use super::theories::{RollingTheories, refused};

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

/// One row for each sample.
pub(super) fn table(response: &FrequencyResponse, file: &mut impl Write) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(file);
    let columns: Vec<(String, &[Complex64])> = response
        .inputs()
        .into_iter()
        .flat_map(|(input, outputs)| {
            let column = |output| format!("{input}_{output}");
            outputs
                .all()
                .map(|(output, _, values)| (column(output), values))
        })
        .collect();
    let mut header = vec!["wavelength_over_semi_axis".to_owned()];
    let parts = |name: &String| ["re", "im"].map(|part| format!("{name}_{part}"));
    header.extend(columns.iter().flat_map(|(name, _)| parts(name)));
    writer.write_record(&header)?;
    for (index, &ratio) in response.ratios.iter().enumerate() {
        let mut row = vec![ratio];
        row.extend(
            columns
                .iter()
                .flat_map(|(_, values)| [values[index].re, values[index].im]),
        );
        writer.serialize(row)?;
    }
    writer.flush()
}

/// Modulus and phase against wavelength.
pub(super) fn panels(response: &FrequencyResponse) -> [LinePanel; 2] {
    // Names stand in the first of the two panels only.
    let panel = |named: bool, value: &dyn Fn(&[Complex64]) -> Vec<f64>| LinePanel {
        x_label: "wavelength λ/a [-]".to_owned(),
        x_scale: Scale::Log,
        series: response
            .inputs()
            .into_iter()
            .zip([LineStyle::Solid, LineStyle::Dashed])
            .flat_map(|((input, outputs), style)| {
                let colors = [OKABE_ITO[0], OKABE_ITO[2], OKABE_ITO[1]];
                let outputs = outputs.all().into_iter().zip(colors);
                outputs.map(move |((_, output, values), color)| {
                    let label = if named {
                        format!("{output} by {input}")
                    } else {
                        String::new()
                    };
                    Series {
                        style,
                        color: Some(color),
                        ..line(&label, &response.ratios, &value(values))
                    }
                })
            })
            .collect(),
        ..LinePanel::default()
    };
    let moduli = |values: &[Complex64]| values.iter().map(|value| value.norm()).collect();
    let largest = response
        .inputs()
        .into_iter()
        .flat_map(|(_, outputs)| outputs.all())
        .flat_map(|(_, _, values)| values)
        .map(|value| value.norm())
        .fold(0.0, f64::max);
    /// Room for the names above the curves, which end at 1.
    const HIGHEST: f64 = 2.4;
    [
        LinePanel {
            subtitle: "response to small oscillations over quasi-static response".to_owned(),
            y_label: "modulus [-]".to_owned(),
            y_range: Some((0.0, HIGHEST.max(1.05 * largest))),
            ..panel(true, &moduli)
        },
        LinePanel {
            y_label: "phase [°]".to_owned(),
            ..panel(false, &|values| phases(&response.ratios, values))
        },
    ]
}

/// Phases \[°\] that pass ±180° without a jump, from zero at long wavelengths.
fn phases(ratios: &[f64], values: &[Complex64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|&a, &b| ratios[b].total_cmp(&ratios[a]));
    let mut phases = vec![0.0; values.len()];
    let mut previous = 0.0;
    for index in order {
        let phase = values[index].arg().to_degrees();
        let turns = ((previous - phase) / 360.0_f64).round();
        previous = phase + 360.0 * turns;
        phases[index] = previous;
    }
    phases
}
