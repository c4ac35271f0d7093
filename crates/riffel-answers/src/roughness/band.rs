//! What stands in a band of a rail, as data.

use riffel::roughness::BandSummary;
use serde::Serialize;

#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Band {
    rail: String,
    from_m: f64,
    to_m: f64,
    rms_m: f64,
    peak_to_peak_max_m: f64,
    share_over_limit: Option<f64>,
    limit_rms_m: Option<f64>,
    moving_rms_max_m: f64,
    window_m: f64,
    length_m: f64,
}

pub(crate) fn bands(rail: &str, bands: &[BandSummary]) -> Vec<Band> {
    bands
        .iter()
        .map(|band| Band {
            rail: rail.to_owned(),
            from_m: band.band.from(),
            to_m: band.band.to(),
            rms_m: band.rms,
            peak_to_peak_max_m: band.peak_to_peak_max,
            share_over_limit: band.share_over_limit,
            limit_rms_m: band.limit,
            moving_rms_max_m: band.moving_rms_max,
            window_m: band.window,
            length_m: band.length,
        })
        .collect()
}
