//! Equivalent conicity.

use std::f64::consts::{FRAC_PI_2, PI};

use riffel_numerics::bisection::bisection;

/// Pieces of a quarter wave. The integrands are smooth in the phase but for kinks and jumps of the table, at which the
/// midpoint rule errs with the square of the piece: 1e-7.
const PIECES: usize = 4000;

/// Equivalent conicity at an amplitude: the conicity of the cone that moves alike, by three rules.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct EquivalentConicity {
    /// That with the wavelength of the free motion y″ = −Δr/(e r₀): γ = (π/λ)² 2 e r₀.
    pub klingel: f64,
    /// Mean of Δr(A sin τ) sin τ / A over a wave.
    pub harmonic: f64,
    /// ∫yΔr / 2∫y² over the amplitude.
    pub regression: f64,
    /// Wavelength of the free motion \[m\], infinite without conicity.
    pub wavelength: f64,
}

impl EquivalentConicity {
    /// Of the rolling radius difference Δr(y) \[m\], right less left, over the lateral shift \[m\] between two ends, at half
    /// the peak-to-peak amplitude A \[m\]; e \[m\] is the spacing of the contacts, r₀ \[m\] the rolling radius. The motion has
    /// its middle where wheels of unequal diameter run, and not at y = 0. `None` if no motion between the ends swings at
    /// this amplitude.
    ///
    /// On a cone of conicity γ, Δr = 2γy, all three are γ, and so for γ = 0, whose wave has no end. Source: Klingel (1883); the
    /// rules are those of EN 15302.
    pub fn at(
        rolling_radius_difference: impl Fn(f64) -> f64,
        [leftmost, rightmost]: [f64; 2],
        amplitude: f64,
        contact_spacing: f64,
        rolling_radius: f64,
    ) -> Option<Self> {
        let scale = contact_spacing * rolling_radius;
        let motion = Swing { difference: rolling_radius_difference, amplitude };
        let (low, high) = (leftmost + amplitude, rightmost - amplitude);
        // Ends of a table are steps of a rounded number.
        if high - low < -1e-9 {
            return None;
        }
        let is_between = low <= 0.0 && high >= 0.0;
        if is_between && motion.is_without_difference() {
            return Some(Self { klingel: 0.0, harmonic: 0.0, regression: 0.0, wavelength: f64::INFINITY });
        }
        let middle = motion.middle([low, high])?;
        let wavelength = motion.wavelength(middle, scale)?;
        Some(Self {
            klingel: (PI / wavelength).powi(2) * 2.0 * scale,
            harmonic: motion.harmonic(middle),
            regression: motion.regression(middle),
            wavelength,
        })
    }
}

/// y = middle + A sin τ under a rolling radius difference Δr(y) \[m\].
struct Swing<F> {
    difference: F,
    /// A \[m\].
    amplitude: f64,
}

/// Phases τ of half a wave at the midpoints of pieces.
fn phases(pieces: usize) -> impl Iterator<Item = f64> {
    let step = PI / pieces as f64;
    (0..pieces).map(move |index| -FRAC_PI_2 + (index as f64 + 0.5) * step)
}

impl<F: Fn(f64) -> f64> Swing<F> {
    /// Δr at a phase of the motion about a middle.
    fn difference(&self, middle: f64, phase: f64) -> f64 {
        (self.difference)(middle + self.amplitude * phase.sin())
    }

    fn is_without_difference(&self) -> bool {
        /// Less \[m\] is no difference: profiles are not known to a nanometre.
        const NO_DIFFERENCE: f64 = 1e-9;
        phases(PIECES).all(|phase| self.difference(0.0, phase).abs() < NO_DIFFERENCE)
    }

    /// The middle of the motion between two ends: as much work to either side.
    fn middle(&self, [low, high]: [f64; 2]) -> Option<f64> {
        let step = PI / PIECES as f64;
        let work = |middle: f64| {
            let piece = |phase: f64| self.difference(middle, phase) * phase.cos() * step;
            phases(PIECES).map(piece).sum::<f64>()
        };
        let (at_low, at_high) = (work(low), work(high));
        let is_between = low <= 0.0 && high >= 0.0;
        if is_between && work(0.0).abs() <= 1e-12 * at_high.abs().max(at_low.abs()) {
            return Some(0.0);
        }
        if at_low > 0.0 || at_high < 0.0 {
            return None;
        }
        let [low, high] = bisection([low, high], 0.0, |middle| work(middle) >= 0.0);
        Some(0.5 * (low + high))
    }

    /// Wavelength of the free motion \[m\], of e r₀ \[m²\]; `None` if it does not swing back.
    fn wavelength(&self, middle: f64, scale: f64) -> Option<f64> {
        let amplitude = self.amplitude;
        // y = middle + A sin τ from each end inward, as far as the speed grows: v² = 2∫ Δr/(e r₀) dy, time ∫ dy/v. From one end
        // alone, what a step of Δr costs the rule would be left at the other, where v is zero.
        let pieces = 2 * PIECES;
        let step = PI / pieces as f64;
        let at = |phase: f64| self.difference(middle, phase) * amplitude * phase.cos() / scale;
        // Simpson's rule over either half of each piece.
        let halves = (0..pieces).map(|index| {
            let begin = -FRAC_PI_2 + index as f64 * step;
            let (centre, end) = (begin + 0.5 * step, begin + step);
            let first = (at(begin) + 4.0 * at(begin + 0.25 * step) + at(centre)) * step / 12.0;
            let second = (at(centre) + 4.0 * at(begin + 0.75 * step) + at(end)) * step / 12.0;
            [first, second]
        });
        let halves: Vec<[f64; 2]> = halves.collect();
        let along = |energy: &mut f64, [outer, inner]: [f64; 2]| {
            let there = *energy + outer;
            *energy = there + inner;
            Some(there)
        };
        let from_left = halves.iter().map(|[first, second]| [-first, -second]);
        let from_left: Vec<f64> = from_left.scan(0.0, along).collect();
        let from_right = halves.iter().rev().map(|[first, second]| [*second, *first]);
        let mut from_right: Vec<f64> = from_right.scan(0.0, along).collect();
        from_right.reverse();
        let by_speed = |one: &usize, other: &usize| from_right[*one].total_cmp(&from_right[*other]);
        let fastest = (0..pieces).max_by(by_speed).unwrap_or(0);
        let mut half_wave = 0.0;
        for index in 0..pieces {
            let energy = match index < fastest {
                true => from_left[index],
                false => from_right[index],
            };
            if energy <= 0.0 || energy.is_nan() {
                return None;
            }
            let centre = -FRAC_PI_2 + (index as f64 + 0.5) * step;
            half_wave += amplitude * centre.cos() / (2.0 * energy).sqrt() * step;
        }
        Some(2.0 * half_wave)
    }

    /// Integral over the phases of half a wave.
    fn integral(&self, value: impl Fn(f64) -> f64) -> f64 {
        let pieces = 2 * PIECES;
        phases(pieces).map(value).sum::<f64>() * (PI / pieces as f64)
    }

    fn harmonic(&self, middle: f64) -> f64 {
        let value = |phase: f64| self.difference(middle, phase) * phase.sin();
        self.integral(value) / (PI * self.amplitude)
    }

    fn regression(&self, middle: f64) -> f64 {
        let moment = self.integral(|phase| {
            let y = self.amplitude * phase.sin();
            y * (self.difference)(middle + y) * self.amplitude * phase.cos()
        });
        moment / (4.0 / 3.0 * self.amplitude.powi(3))
    }
}
