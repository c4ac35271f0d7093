//! Mean wear beside a growth rate, and how far that rate can last.

use std::ops::RangeInclusive;

use riffel::MeanWear;
use riffel::forecast::WearSpread;
use riffel_case::Case;
use riffel_case::file::WearLaw;
use riffel_keys::{Message, fixed, say, significant};
use serde::Serialize;

/// What every document that tells a growth rate tells beside it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WearLimitDocument {
    /// Wear coefficient that the rate goes by; null where other laws than energy have a part in it.
    pub wear_coefficient_kg_per_j: Option<f64>,
    /// Between what that lies by 80 %.
    pub wear_coefficient_band_80: Option<[f64; 2]>,
    /// Mean depth worn off the rail under 100 million gross tonnes.
    pub mean_wear_mm_per_100_mgt: f64,
    /// Amplitude beyond which the rate cannot last, for the oscillating part of the wear would exceed its mean; null where
    /// nothing grows.
    pub amplitude_limit_m: Option<f64>,
    /// That no rail is known to wear so little or so much; null where rails do, or where the wear was measured.
    pub unlikely_wear: Option<Message>,
}

impl WearLimitDocument {
    /// What limits a growth rate per passage of the wheels of a case, the fastest of a document.
    pub fn new(case: &Case, growth_rate: Option<f64>) -> Self {
        let coefficient = case.file.wear.coefficient.si();
        Self::under(case, case.mean_wear(), coefficient, growth_rate)
    }

    /// What limits one under a traffic, with the wear coefficient that growth goes by there.
    pub fn under(case: &Case, wear: MeanWear, coefficient: f64, growth_rate: Option<f64>) -> Self {
        let by_energy = case.file.wear.law == WearLaw::Energy;
        let spread = wear_spread(case).filter(|_| by_energy);
        Self {
            wear_coefficient_kg_per_j: spread.map(|_| coefficient),
            wear_coefficient_band_80: spread.map(|spread| spread.band_80(coefficient)),
            unlikely_wear: unlikely_wear(case, wear),
            mean_wear_mm_per_100_mgt: 1e3 * wear.depth_per_100_mgt(),
            amplitude_limit_m: growth_rate.and_then(|rate| wear.amplitude_limit(rate)),
        }
    }
}

/// That no rail is known to wear so little or so much, so that rates and times of growth are as far off; `None` if rails do, or where
/// the wear was measured.
pub fn unlikely_wear(case: &Case, wear: MeanWear) -> Option<Message> {
    /// Millimetres under 100 MGT, from straight track to the high rails of tight curves: the lists of `docs/src/forecast.md`.
    const KNOWN: RangeInclusive<f64> = 0.1..=5.0;
    let depth = 1e3 * wear.depth_per_100_mgt();
    if case.file.wear.measured.is_some() || KNOWN.contains(&depth) {
        return None;
    }
    let place = match &case.file.curve {
        Some(curve) => say!(in_this_curve_of, radius = fixed(curve.radius.si(), 0)),
        None if case.steady.creepages.lateral != 0.0 => say!(in_this_curve),
        None => say!(on_straight_track),
    };
    Some(say!(wear_unlike_rails, place, depth = significant(depth, 2), low = *KNOWN.start(), high = *KNOWN.end()))
}

/// Whose growth a rate without traffic is: wheels of one kind alone, over the width that their wear comes off.
pub fn for_whom(case: &Case) -> Message {
    let contact = case.feedback.contacts().iter().find(|it| it.rail == case.feedback.rail());
    let width = contact.map_or(f64::NAN, |it| 1e3 * it.wear.width());
    match case.file.wear.band_width {
        None => say!(rate_of_wheels_on_one_line, width = fixed(width, 1)),
        Some(_) => say!(rate_of_wheels_over_a_band, width = fixed(width, 0)),
    }
}

/// How well the wear coefficient is known that growth goes by, before a measurement tells more; `None` if other damage has a part,
/// which does not go with it.
pub(crate) fn wear_spread(case: &Case) -> Option<WearSpread> {
    (!case.has_other_damage()).then(|| riffel_case::wear_spread(case))
}
