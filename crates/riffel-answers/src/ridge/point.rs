//! A point of a ridge, as documents hold it.

use riffel::growth::RidgePoint;
use serde::Serialize;

/// A point of a ridge with keys and units.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct RidgePointDocument {
    /// Speed.
    pub speed_m_per_s: f64,
    /// Wavelength of highest growth at this speed.
    pub wavelength_m: f64,
    /// Speed over wavelength.
    pub frequency_hz: f64,
    /// Re Ŵ₁, below zero where corrugation grows.
    pub normalized_dissipation_re: f64,
    /// Growth rate of the amplitude.
    pub growth_rate_per_passage: f64,
    /// It sits at the edge of the window.
    pub at_edge: bool,
}

impl From<&RidgePoint> for RidgePointDocument {
    fn from(point: &RidgePoint) -> Self {
        Self {
            speed_m_per_s: point.speed,
            wavelength_m: point.wavelength,
            frequency_hz: point.frequency,
            normalized_dissipation_re: point.normalized_dissipation,
            growth_rate_per_passage: point.growth_rate,
            at_edge: point.at_edge,
        }
    }
}
