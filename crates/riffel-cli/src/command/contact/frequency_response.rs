//! Responses to small oscillations over wavelength.

use std::io::{self, Write};

use riffel::{Complex64, ContactResponse};
use riffel_plot::{LinePanel, LineStyle, OKABE_ITO, Rgb, Scale, Series};

use super::patch::Patch;
use super::{line, refused};
use crate::error::CliError;
use crate::output::Progress;

/// Normalised responses to one input, 1 for long wavelengths.
#[derive(Default)]
pub(super) struct Outputs {
    pub(super) force: Vec<Complex64>,
    pub(super) dissipation: Vec<Complex64>,
    pub(super) rail_dissipation: Vec<Complex64>,
}

impl Outputs {
    pub(super) fn push(&mut self, [force, dissipation, rail_dissipation]: [Complex64; 3]) {
        self.force.push(force);
        self.dissipation.push(dissipation);
        self.rail_dissipation.push(rail_dissipation);
    }

    /// The outputs with their keys, names in the figure and colours.
    pub(super) fn all(&self) -> [(&'static str, &'static str, Rgb, &[Complex64]); 3] {
        [
            ("force", "force", OKABE_ITO[0], &self.force),
            (
                "dissipation",
                "dissipation",
                OKABE_ITO[2],
                &self.dissipation,
            ),
            (
                "rail_dissipation",
                "energy left on rail",
                OKABE_ITO[1],
                &self.rail_dissipation,
            ),
        ]
    }
}

/// Response at each wavelength divided by the quasi-static one.
pub(super) struct FrequencyResponse {
    pub(super) ratios: Vec<f64>,
    pub(super) creepage: Outputs,
    pub(super) load: Outputs,
}

impl FrequencyResponse {
    pub(super) fn new(
        patch: &Patch,
        ratios: Vec<f64>,
        progress: &Progress,
    ) -> Result<Self, CliError> {
        let at = |wavelength: f64, input: String| -> Result<ContactResponse, CliError> {
            let response = patch.half_space.response(&patch.state, wavelength);
            progress.advance(1);
            response.map_err(refused(input))
        };
        let slow = at(f64::INFINITY, "the mean state of the case".to_owned())?;
        let (mut creepage, mut load) = (Outputs::default(), Outputs::default());
        for &ratio in &ratios {
            let wavelength = ratio * patch.hertz.semi_axis_longitudinal();
            let response = at(wavelength, format!("--ratio {ratio}"))?;
            let rail = response.at_rail(0.0);
            creepage.push([
                response.dq_dxi / slow.dq_dxi,
                response.de_dxi / slow.de_dxi,
                rail.de_dxi / slow.de_dxi,
            ]);
            load.push([
                response.dq_dp / slow.dq_dp,
                response.de_dp / slow.de_dp,
                rail.de_dp / slow.de_dp,
            ]);
        }
        Ok(Self {
            ratios,
            creepage,
            load,
        })
    }

    pub(super) fn inputs(&self) -> [(&'static str, LineStyle, &Outputs); 2] {
        [
            ("creepage", LineStyle::Solid, &self.creepage),
            ("load", LineStyle::Dashed, &self.load),
        ]
    }

    pub(super) fn table(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        let inputs = self.inputs();
        let columns: Vec<(String, &[Complex64])> = inputs
            .iter()
            .flat_map(|(input, _, outputs)| {
                let column = |output| format!("{input}_{output}");
                outputs
                    .all()
                    .map(|(output, _, _, values)| (column(output), values))
            })
            .collect();
        let mut header = vec!["wavelength_over_semi_axis".to_owned()];
        let parts = |name: &String| ["re", "im"].map(|part| format!("{name}_{part}"));
        header.extend(columns.iter().flat_map(|(name, _)| parts(name)));
        writer.write_record(&header)?;
        for (index, &ratio) in self.ratios.iter().enumerate() {
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
    pub(super) fn panels(&self) -> [LinePanel; 2] {
        // Names stand in the first of the two panels only.
        let panel = |named: bool, value: &dyn Fn(&[Complex64]) -> Vec<f64>| LinePanel {
            x_label: "wavelength λ/a [-]".to_owned(),
            x_scale: Scale::Log,
            series: self
                .inputs()
                .into_iter()
                .flat_map(|(input, style, outputs)| {
                    outputs.all().map(|(_, output, color, values)| {
                        let label = if named {
                            format!("{output} by {input}")
                        } else {
                            String::new()
                        };
                        Series {
                            style,
                            color: Some(color),
                            ..line(&label, &self.ratios, &value(values))
                        }
                    })
                })
                .collect(),
            ..LinePanel::default()
        };
        let moduli = |values: &[Complex64]| values.iter().map(|value| value.norm()).collect();
        let largest = self
            .inputs()
            .iter()
            .flat_map(|(_, _, outputs)| outputs.all())
            .flat_map(|(_, _, _, values)| values)
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
                ..panel(false, &|values| self.phases(values))
            },
        ]
    }

    /// Phases \[°\] that pass ±180° without a jump, from zero at long wavelengths.
    pub(super) fn phases(&self, values: &[Complex64]) -> Vec<f64> {
        let mut order: Vec<usize> = (0..values.len()).collect();
        order.sort_by(|&a, &b| self.ratios[b].total_cmp(&self.ratios[a]));
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
}
