//! What matters in a study, as data.

use riffel_study::sensitivity::{Bands, Estimate, Tornado};
use riffel_study::{Parameter, ParameterValue, Study};
use serde::Serialize;

use super::Analysis;
use super::four_figures;

/// What `riffel study sensitivity --json` prints.
#[derive(Serialize)]
pub struct SensitivityDocument<'a> {
    title: Option<&'a str>,
    fingerprint: &'a str,
    samples: u64,
    outputs: Vec<Output<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    growth_bands: Option<GrowthBands<'a>>,
    notes: &'a [String],
}

#[derive(Serialize)]
struct Output<'a> {
    name: &'a str,
    unit: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    variance: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    base_samples: Option<usize>,
    /// With every parameter at its median.
    at_medians: Option<f64>,
    parameters: Vec<Entry<'a>>,
}

#[derive(Serialize)]
struct Entry<'a> {
    key: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    first_order: Option<Interval>,
    #[serde(skip_serializing_if = "Option::is_none")]
    total: Option<Interval>,
    /// One at a time: the 10 % and the 90 % quantile, and the output there.
    low: &'a ParameterValue,
    high: &'a ParameterValue,
    at_low: Option<f64>,
    at_high: Option<f64>,
}

#[derive(Serialize)]
struct Interval {
    value: f64,
    low: f64,
    high: f64,
}

#[derive(Serialize)]
struct GrowthBands<'a> {
    samples: usize,
    wavelength_m: &'a [f64],
    quantiles: &'a [f64],
    /// For each quantile the growth rate at each wavelength.
    growth_rate_per_passage: &'a [Vec<f64>],
}

impl From<Estimate> for Interval {
    fn from(Estimate { value, low, high }: Estimate) -> Self {
        Self { value, low, high }
    }
}

impl<'a> SensitivityDocument<'a> {
    pub(super) fn new(
        study: &'a Study,
        analyses: &'a [Analysis<'a>],
        tornado: &'a Tornado,
        bands: Option<&'a Bands>,
        notes: &'a [String],
    ) -> Self {
        let outputs = analyses.iter().map(|analysis| {
            let at = |outputs: &Result<Vec<f64>, String>| outputs.as_ref().ok().map(|values| values[analysis.place]);
            let indices = analysis.indices.as_ref();
            let parameters = study.parameters().iter().zip(&tornado.swings).enumerate();
            Output {
                name: &analysis.name,
                unit: analysis.variable.unit,
                variance: indices.map(|indices| indices.variance),
                base_samples: indices.map(|indices| indices.base_samples),
                at_medians: at(&tornado.middle),
                parameters: parameters
                    .map(|(index, (parameter, swing))| Entry {
                        key: &parameter.key.key,
                        first_order: indices.map(|found| found.parameters[index].first.into()),
                        total: indices.map(|found| found.parameters[index].total.into()),
                        low: &swing.values[0],
                        high: &swing.values[1],
                        at_low: at(&swing.outputs[0]),
                        at_high: at(&swing.outputs[1]),
                    })
                    .collect(),
            }
        });
        Self {
            title: study.plan.file.title.as_deref(),
            fingerprint: &study.fingerprint,
            samples: study.samples(),
            outputs: outputs.collect(),
            growth_bands: bands.map(|bands| GrowthBands {
                samples: bands.samples,
                wavelength_m: study.outputs().wavelengths(),
                quantiles: &bands.shares,
                growth_rate_per_passage: &bands.curves,
            }),
            notes,
        }
    }
}

/// A value of a parameter in the unit in which engineers write it.
pub fn with_unit(parameter: &Parameter, value: &ParameterValue) -> String {
    match (value, parameter.key.quantity) {
        (ParameterValue::Number(number), Some(kind)) => {
            let (number, unit) = kind.in_engineers_unit(*number);
            format!("{} {unit}", four_figures(number)).trim_end().to_owned()
        }
        (value, _) => value.to_string(),
    }
}
