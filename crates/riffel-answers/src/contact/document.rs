//! Rolling contact as data.

use riffel::Complex64;
use riffel::contact::KalkerCoefficients;
use serde::Serialize;

use super::{CreepCurves, FrequencyResponse, OutputResponse, RollingTheories};
use riffel_case::SteadyContact;

/// What `riffel contact --json` prints.
#[derive(Serialize)]
pub struct ContactDocument {
    semi_axis_longitudinal_m: f64,
    semi_axis_lateral_m: f64,
    approach_m: f64,
    peak_pressure_pa: f64,
    stiffness_n_per_m: f64,
    kalker: KalkerDocument,
    steady: SteadyDocument,
    creep_curve: CreepCurveDocument,
    /// None near full slip, where no slope is left.
    frequency_response: Option<FrequencyResponseDocument>,
}

/// Steady rolling by the law of the case.
#[derive(Serialize)]
pub struct SteadyDocument {
    /// Along and across the rail.
    pub force_n: [f64; 2],
    /// None where the law does not tell it.
    pub spin_moment_nm: Option<f64>,
    /// With the work of the spin moment; none where there is spin and the law does not tell it.
    pub dissipation_j_per_m: Option<f64>,
}

impl SteadyDocument {
    /// Steady rolling as data.
    pub fn new(steady: &SteadyContact) -> Self {
        let forces = steady.rolling.forces;
        Self {
            force_n: [forces.longitudinal, forces.lateral],
            spin_moment_nm: steady.spin_moment,
            dissipation_j_per_m: steady.energy_per_metre(),
        }
    }
}

#[derive(Serialize)]
struct KalkerDocument {
    c11: f64,
    c22: f64,
    c23: f64,
    c33: f64,
}

#[derive(Serialize)]
struct CreepCurveDocument {
    creepage: Vec<f64>,
    tractive_ratio: serde_json::Map<String, serde_json::Value>,
}

type Map = serde_json::Map<String, serde_json::Value>;

#[derive(Serialize)]
struct FrequencyResponseDocument {
    wavelength_over_semi_axis: Vec<f64>,
    /// Input by input, output by output.
    #[serde(flatten)]
    responses: Map,
    /// By κ = R k² Δ.
    wave_geometry: WaveDocument,
    /// What the grid may miss of each response.
    error: Map,
}

#[derive(Serialize)]
struct WaveDocument {
    /// T = e₁/e₀ at points of the rail.
    rail_dissipation: serde_json::Value,
    /// T_Q.
    force: serde_json::Value,
    phi: Vec<f64>,
}

impl FrequencyResponseDocument {
    fn new(response: &FrequencyResponse) -> Self {
        let each = |value: &dyn Fn(&OutputResponse) -> serde_json::Value| -> Map {
            let of_input = |outputs: &[OutputResponse]| -> Map {
                let outputs = outputs.iter();
                outputs.map(|output| (output.key.to_owned(), value(output))).collect()
            };
            let inputs = response.inputs.iter();
            inputs.map(|input| (input.key.to_owned(), of_input(&input.outputs).into())).collect()
        };
        let pairs = |values: &[Complex64]| -> serde_json::Value {
            values.iter().map(|value| serde_json::Value::from(vec![value.re, value.im])).collect()
        };
        let wave = &response.wave;
        let mut error = each(&|output| output.errors.clone().into());
        let [of_energy, of_force] = wave.errors.clone();
        let of_wave = serde_json::json!({ "rail_dissipation": of_energy, "force": of_force });
        error.insert("wave_geometry".to_owned(), of_wave);
        Self {
            wavelength_over_semi_axis: response.ratios.clone(),
            responses: each(&|output| pairs(&output.values)),
            wave_geometry: WaveDocument {
                rail_dissipation: pairs(&wave.energy),
                force: pairs(&wave.force),
                phi: wave.phi.clone(),
            },
            error,
        }
    }
}

pub(super) fn document(
    patch: &RollingTheories,
    curves: &CreepCurves,
    response: Option<&FrequencyResponse>,
) -> ContactDocument {
    let KalkerCoefficients { c11, c22, c23, c33 } = patch.laws.kalker;
    let laws = curves.laws.iter().map(|law| (law.key.to_owned(), law.tractive_ratios.clone().into()));
    ContactDocument {
        semi_axis_longitudinal_m: patch.hertz.semi_axis_longitudinal(),
        semi_axis_lateral_m: patch.hertz.semi_axis_lateral(),
        approach_m: patch.hertz.approach(),
        peak_pressure_pa: patch.hertz.peak_pressure(),
        stiffness_n_per_m: patch.hertz.stiffness(),
        kalker: KalkerDocument { c11, c22, c23, c33 },
        steady: SteadyDocument::new(&patch.steady),
        creep_curve: CreepCurveDocument { creepage: curves.creepages.clone(), tractive_ratio: laws.collect() },
        frequency_response: response.map(FrequencyResponseDocument::new),
    }
}
