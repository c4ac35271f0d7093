//! Resonances of a track, found on its receptance and named.

use std::fmt;

use num_complex::Complex64;
use riffel_numerics::golden_section::golden_section;

use super::Receptance;

/// What a resonance is, in the field's words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ResonanceKind {
    /// Unsprung mass of the wheel on the stiffness of the track: normal force largest for a given
    /// roughness.
    P2,
    /// Rail and sleepers together on the ballast.
    FullTrack,
    /// Rail on its pads, against the sleepers or the slab.
    RailOnPad,
    /// Rail bending between supports, half a wave in each bay.
    PinnedPinned,
    /// Rail across the track on its pads or on the ballast.
    LateralCutOn,
    /// Rail turning about its axis on its pads.
    RollCutOn,
    /// Rail bending across the track between supports, half a wave in each bay.
    LateralPinnedPinned,
    /// Peak of a receptance that was measured, whichever mode it is.
    MeasuredPeak,
    /// Dip of a receptance that was measured.
    MeasuredDip,
    /// Peak of a receptance that the caller gives as a function.
    FunctionPeak,
    /// Dip of such a receptance.
    FunctionDip,
}

impl fmt::Display for ResonanceKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::P2 => "P2",
            Self::FullTrack => "full-track",
            Self::RailOnPad => "rail on pad",
            Self::PinnedPinned => "pinned-pinned",
            Self::LateralCutOn => "lateral cut-on",
            Self::RollCutOn => "roll cut-on",
            Self::LateralPinnedPinned => "lateral pinned-pinned",
            Self::MeasuredPeak => "peak of the measured receptance",
            Self::MeasuredDip => "dip of the measured receptance",
            Self::FunctionPeak => "peak of the given receptance",
            Self::FunctionDip => "dip of the given receptance",
        })
    }
}

/// A peak with its name.
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub struct Resonance {
    /// What it is.
    pub kind: ResonanceKind,
    /// Angular frequency of the peak \[rad/s\].
    pub angular_frequency: f64,
    /// Receptance of the rail there, or for P2 the sum of all joints \[m/N\].
    pub receptance: Complex64,
    /// Damping ratio by the width at half power \[-\], of a receptance without a model, where it can be read.
    pub damping_ratio: Option<f64>,
    /// Distance of the lines of a measurement there \[rad/s\].
    pub resolution: Option<f64>,
}

impl Resonance {
    /// P2: where within \[rad/s\] the range the sum of the receptances of rail, wheel and contact is least and the wheel
    /// moves as its unsprung mass: `inertia` is that which it has there, −1/(ω² Re H_wheel), over that mass. Where a suspension
    /// or an axle holds the wheel still, the sum is least, too, and the wheel seems many times as heavy. Of several, as the
    /// bending of an axle makes of one, that of the least sum.
    pub fn p2(total: impl Fn(f64) -> Complex64, inertia: impl Fn(f64) -> f64, range: [f64; 2]) -> Option<Self> {
        let places = local_maxima(|w| -total(w).norm(), range);
        let least = places.into_iter().filter(|&w| Self::is_as_mass(inertia(w)));
        let angular_frequency = least.min_by(|&a, &b| total(a).norm().total_cmp(&total(b).norm()))?;
        Some(Self {
            kind: ResonanceKind::P2,
            angular_frequency,
            receptance: total(angular_frequency),
            damping_ratio: None,
            resolution: None,
        })
    }

    /// Whether a wheel moves as its unsprung mass, where it has an inertia over that mass as [`p2`](Self::p2) takes it: within a
    /// factor of two.
    pub fn is_as_mass(inertia: f64) -> bool {
        /// The bending of an axle takes some tenths of the mass.
        const AT_MOST: f64 = 2.0;
        (AT_MOST.recip()..=AT_MOST).contains(&inertia)
    }

    /// The peak of a rail's receptance that belongs to a frequency \[rad/s\] which theory gives for an
    /// undamped or evenly supported track: the nearest, at most `factor` times above or below it.
    /// `None` if damping leaves no peak.
    pub fn near(rail: &dyn Receptance, kind: ResonanceKind, expected: f64, factor: f64) -> Option<Self> {
        let distance = |w: f64| (w / expected).ln().abs();
        let angular_frequency =
            local_maxima(|w| rail.receptance(w, 0.0).norm(), [expected / factor, expected * factor])
                .into_iter()
                .min_by(|&a, &b| distance(a).total_cmp(&distance(b)))?;
        Some(Self {
            kind,
            angular_frequency,
            receptance: rail.receptance(angular_frequency, 0.0),
            damping_ratio: None,
            resolution: None,
        })
    }
}

/// Places of the local maxima of a function inside a range of positive numbers, lowest first.
///
/// Method: 400 points a decade, then golden section to 1e-7 of the place. A peak narrower than 0.6 %
/// of its place may be missed.
fn local_maxima(f: impl Fn(f64) -> f64, [low, high]: [f64; 2]) -> Vec<f64> {
    const POINTS_A_DECADE: f64 = 400.0;
    let steps = (POINTS_A_DECADE * (high / low).log10()).ceil().max(2.0);
    let place = |step: usize| low * (high / low).powf(step as f64 / steps);
    let values: Vec<f64> = (0..=steps as usize).map(|step| f(place(step))).collect();
    (1..steps as usize)
        .filter(|&step| values[step] > values[step - 1] && values[step] >= values[step + 1])
        .map(|step| {
            let bracket = [place(step - 1), place(step + 1)];
            golden_section(bracket, 1e-7 * bracket[0], |x| -f(x))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_every_peak() {
        let peaks = local_maxima(|x| (x / 10.0).sin(), [10.0, 200.0]);
        let expected = [0.5, 2.5, 4.5].map(|n| 10.0 * n * std::f64::consts::PI);
        assert_eq!(peaks.len(), 3);
        for (peak, expected) in peaks.iter().zip(expected) {
            assert!((peak - expected).abs() < 1e-5 * expected, "{peak} {expected}");
        }
        assert!(local_maxima(|x| x, [1.0, 2.0]).is_empty());
    }
}
