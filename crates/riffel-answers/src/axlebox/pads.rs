//! What pads of unknown stiffness leave open.

use std::f64::consts::TAU;

use riffel::axlebox::AxleBoxTransfer;
use riffel::roughness::{Spectrum, ThirdOctave};
use riffel_case::Case;

use super::LevelRange;
use crate::Result;
use crate::pads::with_pads_of;

/// By how much pads may be softer or stiffer than those of the case.
const FACTOR: f64 = 2.0;
/// Frequencies in a band, evenly spaced in their logarithm.
const LINES: u32 = 16;

/// The levels of a spectrum with those that pads of half and of twice the stiffness make of the same accelerations, at the mean
/// speed, where the energy of a band is spread evenly over it.
pub(super) fn ranges(case: &Case, spectrum: &Spectrum, speed: f64) -> Result<Vec<LevelRange>> {
    let transfer = |case: &Case| AxleBoxTransfer::new(case.places(), case.known_frequencies());
    let own = transfer(case);
    let pad = case.file.track.pad.as_ref().and_then(|pad| pad.stiffness);
    let mut others = Vec::new();
    if let Some(stiffness) = pad {
        for factor in [1.0 / FACTOR, FACTOR] {
            others.push(transfer(&with_pads_of(case, factor * stiffness.si())?));
        }
    }
    let levels = spectrum.levels().iter().map(|level| {
        let changes = others.iter().map(|other| change(&own, other, level.band, speed));
        let range = changes.fold([level.level; 2], |[low, high], change| {
            [low.min(level.level + change), high.max(level.level + change)]
        });
        LevelRange { band: level.band, level: level.level, range }
    });
    Ok(levels.collect())
}

/// What another transfer makes of a level \[dB\].
fn change(own: &AxleBoxTransfer, other: &AxleBoxTransfer, band: ThirdOctave, speed: f64) -> f64 {
    let (low, high) = band.wavenumber_range();
    let ratios = (0..LINES).map(|line| {
        let share = (f64::from(line) + 0.5) / f64::from(LINES);
        let frequency = speed * low * (high / low).powf(share);
        let size = |transfer: &AxleBoxTransfer| transfer.at(TAU * frequency, speed).norm_sqr();
        size(own) / size(other)
    });
    10.0 * (ratios.sum::<f64>() / f64::from(LINES)).log10()
}
