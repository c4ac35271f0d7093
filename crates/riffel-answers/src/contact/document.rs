//! Rolling contact as data.

use riffel::Complex64;
use riffel::contact::KalkerCoefficients;
use serde::Serialize;

use super::{CreepCurves, FrequencyResponse, ResponseOutputs, RollingTheories};

/// What `riffel contact --json` prints.
#[derive(Serialize)]
pub struct ContactDocument {
    semi_axis_longitudinal_m: f64,
    semi_axis_lateral_m: f64,
    approach_m: f64,
    peak_pressure_pa: f64,
    stiffness_n_per_m: f64,
    kalker: KalkerDocument,
    creep_curve: CreepCurveDocument,
    frequency_response: FrequencyResponseDocument,
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

#[derive(Serialize)]
struct FrequencyResponseDocument {
    wavelength_over_semi_axis: Vec<f64>,
    creepage: serde_json::Map<String, serde_json::Value>,
    load: serde_json::Map<String, serde_json::Value>,
}

pub(super) fn document(
    patch: &RollingTheories,
    curves: &CreepCurves,
    response: &FrequencyResponse,
) -> ContactDocument {
    let KalkerCoefficients { c11, c22, c23, c33 } = patch.laws.kalker;
    let laws = curves
        .laws
        .iter()
        .map(|law| (law.key.to_owned(), law.tractive_ratios.clone().into()));
    let outputs = |outputs: &ResponseOutputs| {
        let pairs = |values: &[Complex64]| -> serde_json::Value {
            values
                .iter()
                .map(|value| serde_json::Value::from(vec![value.re, value.im]))
                .collect()
        };
        outputs
            .all()
            .map(|(key, _, values)| (key.to_owned(), pairs(values)))
            .into_iter()
            .collect()
    };
    ContactDocument {
        semi_axis_longitudinal_m: patch.hertz.semi_axis_longitudinal(),
        semi_axis_lateral_m: patch.hertz.semi_axis_lateral(),
        approach_m: patch.hertz.approach(),
        peak_pressure_pa: patch.hertz.peak_pressure(),
        stiffness_n_per_m: patch.hertz.stiffness(),
        kalker: KalkerDocument { c11, c22, c23, c33 },
        creep_curve: CreepCurveDocument {
            creepage: curves.creepages.clone(),
            tractive_ratio: laws.collect(),
        },
        frequency_response: FrequencyResponseDocument {
            wavelength_over_semi_axis: response.ratios.clone(),
            creepage: outputs(&response.creepage),
            load: outputs(&response.load),
        },
    }
}
