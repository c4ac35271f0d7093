//! Wavelengths that stand beside a higher one because the supports let it swell and fade.

use riffel::diagnosis::{Mechanism, MechanismKind, Place, Prediction};
use riffel_rail::history::Measured;

/// Orders that are looked for.
const ORDERS: u32 = 3;
/// How far a wavenumber may lie from a sideband, as a part of 1/d: at 0.6 m less than two lines of the spectrum of a window.
const NEAR: f64 = 0.1;

/// A wavelength λ with 1/λ = 1/λ₀ ± n/d: a wave of λ₀ that is modulated over the distance d of the supports.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sideband {
    /// n.
    pub order: u32,
    /// λ₀ \[m\].
    pub of: f64,
    /// d \[m\].
    pub spacing: f64,
}

impl Sideband {
    /// Sideband of the nearest higher wave on the same length of rail, if this wave may be one.
    pub(super) fn new(one: &Measured, all: &[Measured], mechanisms: &[Mechanism]) -> Option<Self> {
        let spacing = mechanisms.iter().find_map(|mechanism| match (mechanism.kind, &mechanism.prediction) {
            (MechanismKind::SupportSpacing, Prediction::Orders { length, .. }) => Some(*length),
            _ => None,
        })?;
        let higher = all.iter().filter(|other| {
            other.peak.level > one.peak.level && other.rail == one.rail && Place::any_shared(&other.places, &one.places)
        });
        let sidebands = higher.filter_map(|other| {
            let of = other.peak.wavelength;
            let distance = (one.peak.wavelength.recip() - of.recip()).abs() * spacing;
            let order = distance.round();
            let near = (distance - order).abs() <= NEAR;
            (near && (1.0..=f64::from(ORDERS)).contains(&order)).then_some(Self { order: order as u32, of, spacing })
        });
        sidebands.min_by_key(|sideband| sideband.order)
    }
}
