//! Responses of the exact contact to small oscillations over wavelength.

use riffel::Complex64;
use riffel::contact::{ContactDerivative, ContactResponse, GridError, OscillatingCreepages};
use riffel_keys::CaseError;
use riffel_plot::{LinePanel, LineStyle, OKABE_ITO, Scale, Series};
use serde::ser::{Serialize, SerializeMap, Serializer};
use serde_json::{Map, Value, json};

use super::line;
use super::theories::{RollingTheories, refused};
use super::wave_response::WaveResponse;
use crate::complex::pairs;
use crate::{Column, Rows, Table};

/// What one output answers to one input.
#[derive(Debug, Clone, PartialEq)]
pub struct OutputResponse {
    /// Key in documents and tables.
    pub key: &'static str,
    /// Name in figures.
    pub name: &'static str,
    /// The response at each wavelength.
    pub values: Vec<Complex64>,
    /// What the grid of the contact may miss of each, an upper bound of the modulus of the error.
    pub errors: Vec<f64>,
    /// The quasi-static response, in the same unit.
    slow: Complex64,
}

/// What answers to an oscillation of one input.
#[derive(Debug, Clone, PartialEq)]
pub struct InputResponse {
    /// Key in documents and tables.
    pub key: &'static str,
    /// Name in figures.
    pub name: &'static str,
    /// What answers.
    pub outputs: Vec<OutputResponse>,
}

/// Responses of the exact contact about its mean state.
#[derive(Debug, Clone, PartialEq)]
pub struct FrequencyResponse {
    /// Wavelengths in longitudinal semi-axes λ/a \[-\].
    pub ratios: Vec<f64>,
    /// Input by input: about longitudinal creepage given by a number creepage and load, each response over the quasi-static
    /// one; about a table of creepages both creepages, spin and load, in SI per unit of the input.
    pub inputs: Vec<InputResponse>,
    /// True for responses over the quasi-static ones.
    pub normalized: bool,
    /// What the geometry of a wave does at each wavelength.
    pub wave: WaveResponse,
}

/// Key and name of an output, where it stands in a derivative, where in a quasi-static one, and its error.
type Output = (
    &'static str,
    &'static str,
    fn(&ContactDerivative) -> Complex64,
    fn(&ContactDerivative) -> Complex64,
    fn(&GridError) -> f64,
);

const FORCE: Output = ("force", "force", |by| by.force[0], |by| by.force[0], |error| error.force);
const LONGITUDINAL_FORCE: Output =
    ("longitudinal_force", "longitudinal force", |by| by.force[0], |by| by.force[0], |error| error.force);
const LATERAL_FORCE: Output =
    ("lateral_force", "lateral force", |by| by.force[1], |by| by.force[1], |error| error.force);
const DISSIPATION: Output = ("dissipation", "dissipation", |by| by.energy, |by| by.energy, |error| error.energy);
const RAIL_DISSIPATION: Output = (
    "rail_dissipation",
    "energy left on rail",
    |by| by.at_rail(0.0),
    // What a point of the rail receives slowly is what is dissipated.
    |by| by.energy,
    |error| error.energy,
);

/// Key and name of an input, and its derivative.
type Input = (&'static str, &'static str, fn(&ContactResponse) -> Option<ContactDerivative>);

const LOAD: Input = ("load", "load", |response| Some(response.by_load));
const CREEPAGE: Input = ("creepage", "creepage", |response| Some(response.by_longitudinal));
const LONGITUDINAL: Input =
    ("longitudinal_creepage", "longitudinal creepage", |response| Some(response.by_longitudinal));
const LATERAL: Input = ("lateral_creepage", "lateral creepage", |response| response.by_lateral);
const SPIN: Input = ("spin", "spin", |response| response.by_spin);

impl FrequencyResponse {
    /// The responses at some wavelengths λ/a; `progress` is told of each of them and of one more.
    ///
    /// # Errors
    /// [`CaseError::Physics`] where the grid does not resolve a wavelength or the theory does not converge.
    pub fn new(theories: &RollingTheories, ratios: Vec<f64>, progress: impl Fn()) -> Result<Self, CaseError> {
        let normalized = theories.along_rail();
        let oscillating = match normalized {
            true => OscillatingCreepages::Longitudinal,
            false => OscillatingCreepages::All,
        }
        .on_waves();
        let semi_axis = theories.hertz.semi_axis_longitudinal();
        let wavelengths = [f64::INFINITY].into_iter().chain(ratios.iter().copied());
        let wavelengths: Vec<f64> = wavelengths.map(|ratio| ratio * semi_axis).collect();
        let half_space = &theories.half_space;
        let mut responses = half_space.responses(&theories.state, &wavelengths, oscillating, progress);
        let slow = responses.remove(0);
        let slow = slow.map_err(refused("the mean state of the case"))?;
        let responses: Vec<ContactResponse> = responses
            .into_iter()
            .zip(&ratios)
            .map(|(response, ratio)| response.map_err(refused(format!("λ/a = {ratio}"))))
            .collect::<Result<_, _>>()?;
        let (inputs, outputs): (&[Input], &[Output]) = match normalized {
            true => (&[CREEPAGE, LOAD], &[FORCE, DISSIPATION, RAIL_DISSIPATION]),
            false => (
                &[LONGITUDINAL, LATERAL, SPIN, LOAD],
                &[LONGITUDINAL_FORCE, LATERAL_FORCE, DISSIPATION, RAIL_DISSIPATION],
            ),
        };
        let inputs = inputs.iter().filter_map(|&(key, name, input)| {
            let slow = input(&slow)?;
            let derivatives: Vec<ContactDerivative> = responses.iter().filter_map(input).collect();
            let outputs = outputs.iter().map(|&(key, name, output, slowly, error)| {
                let scale = match normalized {
                    true => slowly(&slow),
                    false => Complex64::ONE,
                };
                let of = |by: &ContactDerivative| by.error.as_ref().map_or(f64::NAN, error);
                let errors = derivatives.iter().map(|by| of(by) / scale.norm());
                OutputResponse {
                    key,
                    name,
                    values: derivatives.iter().map(|by| output(by) / scale).collect(),
                    errors: errors.collect(),
                    slow: slowly(&slow) / scale,
                }
            });
            Some(InputResponse { key, name, outputs: outputs.collect() })
        });
        let inputs = inputs.collect();
        let wave = WaveResponse::new(theories, &responses, &ratios)?;
        Ok(Self { inputs, ratios, normalized, wave })
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
}

impl InputResponse {
    /// A value of each output.
    fn by_output(&self, value: impl Fn(&OutputResponse) -> Value) -> Map<String, Value> {
        self.outputs.iter().map(|output| (output.key.to_owned(), value(output))).collect()
    }
}

/// Input by input and output by output, with what the grid may miss of each response at the end.
impl Serialize for FrequencyResponse {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("wavelength_over_semi_axis", &self.ratios)?;
        for input in &self.inputs {
            map.serialize_entry(input.key, &input.by_output(|output| json!(pairs(&output.values))))?;
        }
        map.serialize_entry("wave_geometry", &self.wave)?;
        let errors = |input: &InputResponse| json!(input.by_output(|output| json!(output.errors)));
        let mut error: Map<String, Value> =
            self.inputs.iter().map(|input| (input.key.to_owned(), errors(input))).collect();
        let [of_energy, of_force] = &self.wave.errors;
        error.insert("wave_geometry".to_owned(), json!({ "rail_dissipation": of_energy, "force": of_force }));
        map.serialize_entry("error", &error)?;
        map.end()
    }
}

/// One row for each sample.
pub(super) fn table(response: &FrequencyResponse) -> Table {
    let mut columns = vec![response.ratios.exact("wavelength_over_semi_axis", |&value| value)];
    for input in &response.inputs {
        for output in &input.outputs {
            columns.extend(Column::complex(&format!("{}_{}", input.key, output.key), output.values.iter().copied()));
        }
    }
    columns.extend(response.wave.columns());
    Table { name: "frequency-response", columns }
}

/// Modulus and phase against wavelength; about a table of creepages the moduli, input by input.
pub(super) fn panels(response: &FrequencyResponse) -> Vec<LinePanel> {
    let mut panels: Vec<LinePanel> = match response.normalized {
        true => normalized_panels(response).into(),
        false => response.inputs.iter().map(|input| input_panel(&response.ratios, input)).collect(),
    };
    panels.push(response.wave.panel(&response.ratios));
    panels
}

/// The moduli of what answers to one input, forces over the whole quasi-static force and energies over the quasi-static
/// energy; where that vanishes, by symmetry of the mean state, there are none.
fn input_panel(ratios: &[f64], input: &InputResponse) -> LinePanel {
    /// Share of the largest modulus over wavelength below which a quasi-static one is none.
    const NONE: f64 = 1e-3;
    let forces: Vec<&OutputResponse> = input.outputs.iter().take(2).collect();
    let energies: Vec<&OutputResponse> = input.outputs.iter().skip(2).collect();
    let group = |outputs: Vec<&OutputResponse>, colors: [usize; 2]| {
        let slow = outputs[0].slow.norm();
        let slow = match colors {
            // Both components of one force.
            FORCE_COLORS => slow.hypot(outputs[1].slow.norm()),
            _ => slow,
        };
        let all = outputs.iter().flat_map(|output| &output.values);
        let largest = all.map(|value| value.norm()).fold(slow, f64::max);
        let curves = outputs.into_iter().zip(colors).filter_map(|(output, color)| {
            let moduli: Vec<f64> = output.values.iter().map(|value| value.norm() / slow).collect();
            let highest = moduli.iter().copied().fold(0.0, f64::max);
            (slow > NONE * largest && highest > NONE)
                .then(|| Series { color: Some(OKABE_ITO[color]), ..line(output.name, ratios, &moduli) })
        });
        curves.collect::<Vec<_>>()
    };
    const FORCE_COLORS: [usize; 2] = [0, 4];
    const ENERGY_COLORS: [usize; 2] = [2, 1];
    let mut series = group(forces, FORCE_COLORS);
    series.extend(group(energies, ENERGY_COLORS));
    let curves = series.iter().flat_map(|series| &series.y);
    let largest = curves.copied().fold(0.0, f64::max);
    /// Room for the names above the curves, which end at 1.
    const HIGHEST: f64 = 1.6;
    LinePanel {
        y_range: Some((0.0, HIGHEST.max(1.25 * largest))),
        ..LinePanel::new("wavelength λ/a [-]", "modulus [-]", series)
            .titled(format!("response to {} over quasi-static response", input.name))
            .scaled(Scale::Log, Scale::Linear)
    }
}

/// Modulus and phase of responses that are normalised.
fn normalized_panels(response: &FrequencyResponse) -> [LinePanel; 2] {
    // Names stand in the first of the two panels only.
    let panel = |named: bool, value: &dyn Fn(&[Complex64]) -> Vec<f64>| LinePanel {
        x_label: "wavelength λ/a [-]".to_owned(),
        x_scale: Scale::Log,
        series: response
            .inputs
            .iter()
            .zip([LineStyle::Solid, LineStyle::Dashed])
            .flat_map(|(input, style)| {
                let colors = [OKABE_ITO[0], OKABE_ITO[2], OKABE_ITO[1]];
                let outputs = input.outputs.iter().zip(colors);
                outputs.map(move |(output, color)| {
                    let label = if named { format!("{} by {}", output.name, input.name) } else { String::new() };
                    Series { style, color: Some(color), ..line(&label, &response.ratios, &value(&output.values)) }
                })
            })
            .collect(),
        ..LinePanel::default()
    };
    let moduli = |values: &[Complex64]| values.iter().map(|value| value.norm()).collect();
    let outputs = response.inputs.iter().flat_map(|input| &input.outputs);
    let largest = outputs.flat_map(|output| &output.values).map(|value| value.norm()).fold(0.0, f64::max);
    /// Room for the names above the curves, which end at 1.
    const HIGHEST: f64 = 2.4;
    [
        LinePanel {
            subtitle: "response to small oscillations over quasi-static response".to_owned(),
            y_label: "modulus [-]".to_owned(),
            y_range: Some((0.0, HIGHEST.max(1.05 * largest))),
            ..panel(true, &moduli)
        },
        LinePanel { y_label: "phase [°]".to_owned(), ..panel(false, &|values| phases(&response.ratios, values)) },
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
