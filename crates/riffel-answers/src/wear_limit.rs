//! Mean wear beside a growth rate, and how far that rate can last.

use riffel::MeanWear;
use riffel::forecast::WearSpread;
use riffel_case::Case;
use riffel_keys::{Message, fixed, say};
use serde::Serialize;

/// What every document that tells a growth rate tells beside it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct WearLimitDocument {
    /// Mean depth worn off the rail under 100 million gross tonnes.
    pub mean_wear_mm_per_100_mgt: f64,
    /// Amplitude beyond which the rate cannot last, for the oscillating part of the wear would exceed its mean; null where
    /// nothing grows.
    pub amplitude_limit_m: Option<f64>,
}

impl WearLimitDocument {
    /// Of a growth rate per passage, the fastest of a document.
    pub fn new(wear: MeanWear, growth_rate: Option<f64>) -> Self {
        Self {
            mean_wear_mm_per_100_mgt: 1e3 * wear.depth_per_100_mgt(),
            amplitude_limit_m: growth_rate.and_then(|rate| wear.amplitude_limit(rate)),
        }
    }
}

/// Whose growth a rate without traffic is: wheels of one kind alone, over the width that their wear comes off.
pub fn for_whom(case: &Case) -> Message {
    let contact = case
        .feedback
        .contacts()
        .iter()
        .find(|it| it.rail == case.feedback.rail());
    let width = contact.map_or(f64::NAN, |it| 1e3 * it.wear.width());
    match case.file.wear.band_width {
        None => say!(rate_of_wheels_on_one_line, width = fixed(width, 1)),
        Some(_) => say!(rate_of_wheels_over_a_band, width = fixed(width, 0)),
    }
}

/// How well the wear coefficient is known that growth goes by, before a measurement tells more; none where other damage has a part,
/// which does not go with it.
pub(crate) fn wear_spread(case: &Case) -> Option<WearSpread> {
    (!case.has_other_damage()).then_some(WearSpread::UNMEASURED)
}
