//! What a study tells of its parameters and of its growth.

use riffel_study::ParameterValue;
use riffel_study::sensitivity::Estimate;
use serde::Serialize;

/// What a parameter does to an output.
#[derive(Serialize)]
pub(super) struct ParameterEffect {
    pub(super) key: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) first_order: Option<Interval>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) total: Option<Interval>,
    /// One at a time: the 10 % and the 90 % quantile, and the output there.
    pub(super) low: ParameterValue,
    pub(super) high: ParameterValue,
    pub(super) at_low: Option<f64>,
    pub(super) at_high: Option<f64>,
}

#[derive(Serialize)]
pub(super) struct Interval {
    value: f64,
    low: f64,
    high: f64,
}

impl From<Estimate> for Interval {
    fn from(Estimate { value, low, high }: Estimate) -> Self {
        Self { value, low, high }
    }
}

/// Quantiles of growth against wavelength.
#[derive(Serialize)]
pub(super) struct GrowthBands {
    pub(super) samples: usize,
    pub(super) wavelength_m: Vec<f64>,
    pub(super) quantiles: Vec<f64>,
    /// For each quantile the growth rate at each wavelength.
    pub(super) growth_rate_per_passage: Vec<Vec<f64>>,
}
