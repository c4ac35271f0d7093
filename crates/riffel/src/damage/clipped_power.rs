//! A power of what lies above a limit, over a wave and over the loads of traffic.

use std::f64::consts::PI;

use riffel_numerics::gauss::{equal_panels, panels};
use riffel_numerics::normal_distribution::{below, density};

/// E⟨X + σz⟩^m, z normal, ⟨·⟩ zero below zero; for a cosine X = X₀ + U cos θ its mean and its first harmonic.
///
/// A wave of which only a part lies above the limit is answered by its first harmonic (describing function): nothing until
/// U = |X₀|, then rising to half the rate of one that lies above it as a whole, for X₀ = 0 and m = 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClippedPower {
    exponent: f64,
    spread: f64,
}

impl ClippedPower {
    /// The power m \[-\], one or more, under a normal spread of the standard deviation σ of X \[-\]; zero: sharp.
    pub fn new(exponent: f64, spread: f64) -> Self {
        Self { exponent, spread }
    }

    /// Whether there is a spread.
    pub(crate) fn is_spread(&self) -> bool {
        self.spread > 0.0
    }

    /// σ \[-\].
    pub(crate) fn spread(&self) -> f64 {
        self.spread
    }

    /// m \[-\].
    pub(crate) fn exponent(&self) -> f64 {
        self.exponent
    }

    /// E⟨X + σz⟩^m.
    pub fn value(&self, x: f64) -> f64 {
        power(x, self.exponent, self.spread)
    }

    /// Its slope over X, m E⟨X + σz⟩^(m−1).
    pub fn slope(&self, x: f64) -> f64 {
        self.exponent * power(x, self.exponent - 1.0, self.spread)
    }

    /// Mean over a wave.
    pub fn mean(&self, excess: f64, amplitude: f64) -> f64 {
        if self.spread > 0.0 {
            let mut sum = 0.0;
            self.over_wave(excess, amplitude, |x, _| sum += self.value(x));
            return sum / self.steps(amplitude);
        }
        let Some(angle) = angle_above(excess, amplitude) else {
            return 0.0;
        };
        let (sine, cosine) = angle.sin_cos();
        if self.exponent == 1.0 {
            return (excess * angle + amplitude * sine) / PI;
        }
        if self.exponent == 2.0 {
            let square = excess * excess + 0.5 * amplitude * amplitude;
            let cross = 2.0 * excess * amplitude + 0.5 * amplitude * amplitude * cosine;
            return (square * angle + cross * sine) / PI;
        }
        let mut sum = 0.0;
        above(excess, amplitude, angle, |x, _, weight| {
            sum += weight * x.powf(self.exponent);
        });
        sum / PI
    }

    /// First harmonic over a wave: the amplitude of cos θ.
    pub fn first(&self, excess: f64, amplitude: f64) -> f64 {
        amplitude * self.first_over_amplitude(excess, amplitude)
    }

    /// What a wave is multiplied by: the first harmonic over U, for small waves the slope. With a spread, the slope as long as the mean
    /// demand stays on one side of the limit, U ≤ |X₀|.
    pub fn rate(&self, excess: f64, amplitude: f64) -> f64 {
        match self.is_small(excess, amplitude) {
            true => self.slope(excess),
            false => self.first_over_amplitude(excess, amplitude),
        }
    }

    /// Mean at an amplitude: with a spread, that of small waves as far as [`rate`](Self::rate) is theirs.
    pub fn depth(&self, excess: f64, amplitude: f64) -> f64 {
        match self.is_small(excess, amplitude) {
            true => self.value(excess),
            false => self.mean(excess, amplitude),
        }
    }

    fn is_small(&self, excess: f64, amplitude: f64) -> bool {
        self.spread > 0.0 && amplitude <= excess.abs()
    }

    /// First harmonic over U.
    ///
    /// By parts it is (2/π) ∫ F′ sin² θ dθ, which loses nothing where U is small: 1 and 2X₀ for a wave above the limit as a whole and
    /// m = 1 and 2, mX₀^(m−1) ₂F₁((1−m)/2, (2−m)/2; 2; U²/X₀²) for others, 3X₀² + ¾U² for m = 3.
    fn first_over_amplitude(&self, excess: f64, amplitude: f64) -> f64 {
        if self.spread > 0.0 {
            let mut sum = 0.0;
            self.over_wave(excess, amplitude, |x, cosine| {
                sum += self.slope(x) * (1.0 - cosine * cosine);
            });
            return 2.0 * sum / self.steps(amplitude);
        }
        let Some(angle) = angle_above(excess, amplitude) else {
            return 0.0;
        };
        let whole = angle == PI;
        let (sine, cosine) = angle.sin_cos();
        match self.exponent {
            1.0 if whole => 1.0,
            1.0 => (angle - sine * cosine) / PI,
            2.0 if whole => 2.0 * excess,
            2.0 => 2.0 * amplitude / PI * (sine - sine.powi(3) / 3.0 - angle * cosine),
            exponent => {
                let mut sum = 0.0;
                above(excess, amplitude, angle, |x, cosine, weight| {
                    sum += weight * x.powf(exponent - 1.0) * (1.0 - cosine * cosine);
                });
                2.0 * exponent * sum / PI
            }
        }
    }

    /// Whether all waves with U ≤ |X₀| have one rate, that of small ones.
    pub(crate) fn is_linear_above(&self) -> bool {
        self.spread > 0.0 || self.exponent == 1.0 || self.exponent == 2.0
    }

    /// Steps over half a wave that resolve the spread: the n-th harmonic of what a normal spread has smoothed falls off as
    /// exp(−(nσ/U)²/2), so that they are good to rounding.
    fn steps(&self, amplitude: f64) -> f64 {
        (12.0 + 5.0 * amplitude / self.spread).min(1e4).ceil()
    }

    /// Rectangles over half a wave, which converge faster than any power for what is smooth.
    fn over_wave(&self, excess: f64, amplitude: f64, mut at: impl FnMut(f64, f64)) {
        let steps = self.steps(amplitude);
        for index in 0..steps as usize {
            let cosine = ((index as f64 + 0.5) * PI / steps).cos();
            at(excess + amplitude * cosine, cosine);
        }
    }
}

/// Half the part of a wave above the limit as an angle; `None` if all lies below.
fn angle_above(excess: f64, amplitude: f64) -> Option<f64> {
    if excess >= amplitude {
        return (excess > 0.0).then_some(PI);
    }
    (excess > -amplitude).then(|| (-excess / amplitude).acos())
}

/// Sum over that part. θ = θ_c(1 − w²) takes the corner at its end, the panels the rest.
fn above(excess: f64, amplitude: f64, angle: f64, mut at: impl FnMut(f64, f64, f64)) {
    for (w, weight) in panels(&equal_panels([0.0, 1.0], 1.0 / 24.0)) {
        let theta = angle * (1.0 - w * w);
        // cos θ − cos θ_c without loss where they are close.
        let rise = 2.0 * (0.5 * (angle + theta)).sin() * (0.5 * angle * w * w).sin();
        let x = match angle == PI {
            true => (excess - amplitude) + amplitude * rise,
            false => amplitude * rise,
        };
        at(x, theta.cos(), 2.0 * angle * w * weight);
    }
}

/// E⟨x + σz⟩^m.
fn power(x: f64, exponent: f64, spread: f64) -> f64 {
    /// Beyond these standard deviations nothing is left of the bell.
    const TAIL: f64 = 9.0;
    if spread == 0.0 {
        return match exponent == 0.0 {
            true => f64::from(x > 0.0),
            false => x.max(0.0).powf(exponent),
        };
    }
    let ratio = x / spread;
    let share = below(ratio);
    if exponent == 0.0 {
        return share;
    }
    if exponent == 1.0 {
        return spread * density(ratio) + x * share;
    }
    if exponent == 2.0 {
        return x * spread * density(ratio) + (x * x + spread * spread) * share;
    }
    let sum: f64 = match ratio > TAIL {
        true => panels(&equal_panels([-TAIL, TAIL], 0.5))
            .map(|(z, weight)| weight * (z + ratio).powf(exponent) * density(z))
            .sum(),
        // t = z + x/σ = w², which takes the corner at t = 0.
        false => panels(&equal_panels([0.0, (ratio + TAIL).max(0.0).sqrt()], 0.1))
            .map(|(w, weight)| 2.0 * w * weight * (w * w).powf(exponent) * density(w * w - ratio))
            .sum(),
    };
    spread.powf(exponent) * sum
}

#[cfg(test)]
mod tests {
    use super::super::rate_table::RateTable;
    use super::*;

    /// Steps over a wave are good to rounding: against Gauss's rule on panels over the angle.
    #[test]
    fn steps_resolve_the_spread() {
        for exponent in [1.0, 1.5, 2.0] {
            for ratio in [0.1, 1.0, 7.0, 60.0] {
                for place in [-1.2, -0.4, 0.0, 0.9] {
                    let (spread, amplitude) = (0.1, 0.1 * ratio);
                    let law = ClippedPower::new(exponent, spread);
                    let excess = place * amplitude;
                    let width = 0.5 / (1.0 + ratio);
                    let sum: f64 = panels(&equal_panels([0.0, PI], width))
                        .map(|(angle, weight)| {
                            let slope = law.slope(excess + amplitude * angle.cos());
                            weight * slope * angle.sin().powi(2)
                        })
                        .sum();
                    let expected = 2.0 * amplitude * sum / PI;
                    let scale = amplitude * law.slope(amplitude);
                    let found = law.first(excess, amplitude);
                    assert!(
                        (found - expected).abs() < 1e-12 * scale,
                        "m = {exponent}, U/σ = {ratio}, X₀/U = {place}: {found:e} {expected:e}"
                    );
                }
            }
        }
    }

    /// X₀, m, U and σ, and the first harmonic over U: by mpmath 1.3, thirty digits without a spread and fifteen with one, over the
    /// part of the wave above the limit. For m = 3 it is 3X₀² + ¾U², for m = 4 4X₀³ + 3X₀U², also where the wave begins to be clipped.
    const RATES: [([f64; 4], f64); 18] = [
        ([0.2, 3.0, 0.05, 0.0], 0.121_875),
        ([0.2, 3.0, 0.2, 0.0], 0.15),
        ([0.2, 3.0, 0.200_000_1, 0.0], 0.150_000_030_000_007_5),
        ([0.2, 3.0, 0.25, 0.0], 0.166_784_521_201_116_1),
        ([-0.2, 3.0, 0.25, 0.0], 9.047_879_888_391_376e-5),
        ([0.0, 3.0, 0.2, 0.0], 0.015),
        ([0.2, 4.0, 0.1, 0.0], 0.038),
        ([0.2, 4.0, 0.2, 0.0], 0.056),
        ([0.2, 4.0, 0.5, 0.0], 0.186_397_122_517_962_53),
        ([-0.1, 4.0, 0.3, 0.0], 0.001_518_177_863_391_250_7),
        ([0.3, 1.5, 0.15, 0.0], 0.814_891_260_540_425_7),
        ([0.3, 1.5, 0.3, 0.0], 0.788_997_688_398_719_8),
        ([0.3, 2.7, 0.29, 0.0], 0.398_078_893_510_931_6),
        ([-0.05, 2.7, 0.2, 0.0], 0.010_297_453_392_762_841),
        ([0.3, 5.0, 1e-4, 0.0], 0.040_500_006_750_000_05),
        ([0.1, 1.0, 0.05, 0.1], 0.833_938_258_059_338_6),
        ([0.1, 1.0, 0.1, 0.1], 0.813_467_874_528_182_4),
        ([0.2, 3.0, 0.1, 0.05], 0.134_998_018_045_189_24),
    ];

    /// Good to 1e-9: Gauss's panels leave 1e-10 where a power is not whole. The table reads them to 1e-9 as well.
    #[test]
    fn rates_are_the_first_harmonic() {
        for ([excess, exponent, amplitude, spread], expected) in RATES {
            let law = ClippedPower::new(exponent, spread);
            let table = RateTable::new(law, excess);
            let first = law.first(excess, amplitude) / amplitude;
            // With a spread, that of small waves up to the limit.
            let rate = match spread > 0.0 && amplitude <= excess {
                true => law.slope(excess),
                false => expected,
            };
            for (got, expected) in [
                (first, expected),
                (law.rate(excess, amplitude), rate),
                (table.map_or(rate, |table| table.rate(amplitude)), rate),
            ] {
                let off = got / expected - 1.0;
                assert!(off.abs() < 2e-9, "{excess} {exponent} {amplitude}: {off:e}");
            }
        }
    }

    /// A wave above the limit as a whole is answered by the slope for m = 1 and 2, by more for m above; one about the limit by half of it;
    /// none below. Small waves of any m have the slope.
    #[test]
    fn limits_of_a_wave() {
        for exponent in [1.0, 1.5, 2.0, 3.0] {
            let law = ClippedPower::new(exponent, 0.0);
            assert!((law.rate(0.2, 1e-8) / law.slope(0.2) - 1.0).abs() < 1e-12);
            assert!((law.rate(0.2, 0.0) / law.slope(0.2) - 1.0).abs() < 1e-12);
            let at_limit = [1.0 - 1e-9, 1.0 + 1e-9].map(|share| law.rate(0.2, 0.2 * share));
            assert!((at_limit[0] / at_limit[1] - 1.0).abs() < 1e-7, "{exponent}");
        }
        for exponent in [1.0, 2.0] {
            let law = ClippedPower::new(exponent, 0.0);
            let slope = law.first(0.2, 0.1) / 0.1;
            assert!((slope / law.slope(0.2) - 1.0).abs() < 1e-14);
            assert_eq!(law.first(-0.2, 0.1), 0.0);
            assert_eq!(law.mean(-0.2, 0.1), 0.0);
        }
        assert!((ClippedPower::new(1.0, 0.0).first(0.0, 0.3) - 0.15).abs() < 1e-15);
    }

    /// Closed forms of m = 1 and 2 are the quadrature of those between, and a narrow spread is sharp.
    #[test]
    fn powers_between_and_narrow_spreads() {
        for (excess, amplitude) in [(-0.2, 0.25), (-0.05, 0.3), (0.0, 0.2), (0.1, 0.3)] {
            for exponent in [1.0, 2.0] {
                let [law, near] = [exponent, exponent + 1e-9].map(|exponent| ClippedPower::new(exponent, 0.0));
                let mean = law.mean(excess, amplitude) - near.mean(excess, amplitude);
                let first = law.first(excess, amplitude) - near.first(excess, amplitude);
                assert!(mean.abs() < 1e-9 && first.abs() < 1e-9, "{mean} {first}");
            }
            let sharp = ClippedPower::new(1.0, 0.0);
            let narrow = ClippedPower::new(1.0, 1e-4);
            let difference = sharp.first(excess, amplitude) - narrow.first(excess, amplitude);
            assert!(difference.abs() < 1e-7, "{difference}");
        }
    }

    /// The slope of the spread law is that of its value, at whole exponents and others.
    #[test]
    fn slope_is_that_of_the_value() {
        for exponent in [1.0, 1.5, 2.0, 2.7] {
            let law = ClippedPower::new(exponent, 0.1);
            for x in [-0.2, 0.0, 0.15] {
                let step = 1e-4;
                let difference = (law.value(x + step) - law.value(x - step)) / (2.0 * step);
                assert!((difference - law.slope(x)).abs() < 1e-6, "{exponent} {x}");
            }
        }
    }
}
