//! What an outcome tells of its bands, its rails and its ridge.

use riffel::forecast::Reach;
use riffel::growth::RidgePoint;
use serde::Serialize;

use super::Outcome;
use crate::forecast::{RailForecast, ReachDocument};

/// Growth of a band beside that of the case as it is.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct BandRate {
    pub(super) wavelength_m: f64,
    pub(super) growth_rate_per_passage: f64,
    pub(super) change: f64,
}

/// When a rail reaches the limit.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct RailReach {
    pub(super) rail: Option<String>,
    #[serde(flatten)]
    pub(super) reach: ReachDocument,
    pub(super) linear_range_passages: Option<f64>,
}

impl RailReach {
    pub(super) fn of(rail: &RailForecast, outcome: &Outcome) -> Self {
        let passages = rail.reach.and_then(Reach::passages);
        let months = |passages| outcome.months(passages);
        Self {
            rail: rail.name().map(str::to_owned),
            reach: ReachDocument::new(rail.reach.map(Reach::name), passages, &outcome.growth, months),
            linear_range_passages: rail.forecast.linear_range(rail.forecast.bands()).passages,
        }
    }
}

/// Where a ridge is highest.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct HighestOfRidge {
    wavelength_m: f64,
    speed_m_per_s: f64,
    frequency_hz: f64,
    growth_rate_per_passage: f64,
}

impl HighestOfRidge {
    pub(super) fn of(point: &RidgePoint) -> Self {
        Self {
            wavelength_m: point.wavelength,
            speed_m_per_s: point.speed,
            frequency_hz: point.frequency,
            growth_rate_per_passage: point.growth_rate,
        }
    }
}
