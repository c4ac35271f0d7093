//! Stability of the loop without any profile.

use std::f64::consts::{FRAC_PI_2, PI};

use num_complex::Complex64;

use super::Loop;
use super::system::System;
use crate::Error;
use crate::wanted::check;

/// Largest turn of the phase \[rad\] in one step, small beside the half turn at which its sense would be lost.
const LARGEST_TURN: f64 = 0.5;

/// Steps a decade before any is halved.
const A_DECADE: f64 = 40.0;

/// Shortest step over its frequency: a phase that turns more within it is given up.
const SHORTEST: f64 = 1e-11;

/// Most steps of the phase, of which the presets of wheelsets need less than a thousand.
const MOST_STEPS: usize = 10_000;

/// What grows in the loop without any profile, at one speed.
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct Stability {
    /// How many roots of the loop lie in the half-plane of growing oscillations, two for each oscillation; zero where
    /// the loop is stable.
    pub unstable_roots: usize,
    /// Frequency \[Hz\] of the oscillation that grows, as squeal or as stick and slip, the highest where there are several; none
    /// where the loop is stable.
    pub frequency: Option<f64>,
    /// How fast it grows \[1/s\]: its amplitude as the exponential of this times the time. None where the loop is stable, or
    /// where the step from the imaginary axis does not find the root.
    pub growth_rate: Option<f64>,
}

impl Loop {
    /// Whether oscillations grow without any profile at a speed \[m/s\], by Nyquist's criterion between two frequencies
    /// \[Hz\]. Growth rates of corrugation mean nothing where they do.
    ///
    /// With M(s) the matrix of the loop at s = iω and M₀ that of the normal forces alone, F = det M / det M₀ has no pole
    /// with Re s > 0 if track and wheels are passive; its zeros there are the oscillations that grow. F tends to one
    /// where inertia outweighs the creep forces, and to K s^{−m} below all resonances, where bodies move freely. By the
    /// argument principle there are m/2 − Δ/π such zeros, Δ the turn of the phase of F from s = 0 to i∞.
    ///
    /// Method: the phase is followed in steps that are halved until it turns by less than 0.5 rad in each, from 40 steps a
    /// decade down to 1e-11 of the frequency, 10 000 steps at most; m is the slope of |F| at the lower frequency. Where F crosses the
    /// negative real axis an oscillation that grows is near; its root is found by Newton's step from the imaginary axis, −F/F′ with
    /// F′ = −i dF/dω, taken from the frequency at which that step is along the real axis: to some (σ/ω)² of either. Range of validity: F is K s^{−m} to a few per cent at
    /// the lower frequency, and nearer to one than to the origin at the upper; resonances narrower than the steps that
    /// do not show beside their own frequency are missed.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless 0 < from < to; [`Error::NotConverged`] where the phase cannot be followed.
    pub fn stability(&self, speed: f64, from: f64, to: f64) -> Result<Stability, Error> {
        Error::unless_positive("lowest frequency", from, "Hz")?;
        Error::unless_positive("width of the band of frequencies", to - from, "Hz")?;
        let mut system = System::new(self);
        let mut quotient = |frequency: f64| system.determinant(self, 2.0 * PI * frequency, speed);
        let begin = quotient(from);
        let order = -(quotient(1.01 * from).norm() / begin.norm()).ln() / 1.01_f64.ln();
        let order = order.round();

        let steps = (A_DECADE * (to / from).log10()).ceil().max(1.0);
        let mut turned = 0.0;
        let mut here = (from, begin);
        // The phase of F from the lower frequency on.
        let mut course = vec![(from, 0.0)];
        for step in 1..=steps as usize {
            check();
            let frequency = from * (to / from).powf(step as f64 / steps);
            let mut ahead = vec![(frequency, quotient(frequency))];
            while let Some(&next) = ahead.last() {
                let turn = (next.1 / here.1).arg();
                if turn.abs() < LARGEST_TURN {
                    turned += turn;
                    course.push((next.0, turned));
                    here = next;
                    ahead.pop();
                } else if next.0 - here.0 > SHORTEST * next.0
                    && course.len() + ahead.len() < MOST_STEPS
                    && turn.is_finite()
                {
                    let middle = (here.0 * next.0).sqrt();
                    ahead.push((middle, quotient(middle)));
                } else {
                    return Err(Error::NotConverged {
                        problem: "the phase of the loop without profile",
                        residual: turn.abs(),
                        tolerance: LARGEST_TURN,
                        remedy: "a resonance without damping may stand there: give it a loss",
                    });
                }
            }
        }
        let whole = turned - here.1.arg() + from_asymptote(begin, order);
        let roots = (order / 2.0 - whole / PI).round().max(0.0);
        // F crosses the negative real axis where its phase is a half turn short of that at the upper end.
        let end = turned - here.1.arg();
        let crossing = course.windows(2).rev().find_map(|pair| {
            let [before, after] = [pair[0].1 - end - PI, pair[1].1 - end - PI];
            (before >= 0.0 && after < 0.0).then(|| (pair[0].0 * pair[1].0).sqrt())
        });
        let crossing = crossing.filter(|_| roots > 0.0);
        let root = crossing.and_then(|near| root_near(near, [from, to], &mut quotient));
        Ok(Stability {
            unstable_roots: roots as usize,
            frequency: root.map(|(frequency, _)| frequency).or(crossing),
            growth_rate: root.map(|(_, growth)| growth),
        })
    }
}

/// Frequency \[Hz\] and growth \[1/s\] of the root of an analytic function that lies to the right of the imaginary axis near a
/// frequency, by Newton's step from there; none where it leads away, or to the left.
fn root_near(
    near: f64,
    [from, to]: [f64; 2],
    value: &mut impl FnMut(f64) -> Complex64,
) -> Option<(f64, f64)> {
    /// Steps along the axis, to a billionth of the frequency.
    const STEPS: usize = 40;
    const FOUND: f64 = 1e-9;
    /// Longest step and shift over the frequency.
    const LONGEST: f64 = 0.05;
    const FARTHEST: f64 = 0.5;
    /// Of the frequency, for the derivative: resonances are wider.
    const DIFFERENCE: f64 = 1e-5;
    let mut frequency = near;
    for _ in 0..STEPS {
        let half = DIFFERENCE * frequency;
        let rise = value(frequency + half) - value(frequency - half);
        // dF/ds = −i dF/dω.
        let slope = -Complex64::I * rise / (2.0 * PI * 2.0 * half);
        let step = -value(frequency) / slope;
        let along = step.im / (2.0 * PI);
        if !along.is_finite() {
            return None;
        }
        if along.abs() < FOUND * frequency {
            return (step.re > 0.0).then_some((frequency, step.re));
        }
        frequency += along.clamp(-LONGEST * frequency, LONGEST * frequency);
        let far = (frequency / near).ln().abs() > FARTHEST;
        if far || !(from..=to).contains(&frequency) {
            return None;
        }
    }
    None
}

/// The phase of a number beyond that of K (iω)^{−m} with K real of either sign, nearest to zero.
fn from_asymptote(value: Complex64, order: f64) -> f64 {
    let beyond = value.arg() + order * FRAC_PI_2;
    beyond - PI * (beyond / PI).round()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A pair of roots at σ ± iω beside a damped pair: found to (σ/ω)², 4e-4 here.
    #[test]
    fn a_root_is_found_from_the_axis() {
        let (growth, frequency) = (25.0, 200.0);
        let root = Complex64::new(growth, 2.0 * PI * frequency);
        let other = Complex64::new(-40.0, 2.0 * PI * 300.0);
        let mut value = |frequency: f64| {
            let s = Complex64::new(0.0, 2.0 * PI * frequency);
            (s - root) * (s - root.conj()) * (s - other) * (s - other.conj()) / (s - 1000.0).powi(4)
        };
        for near in [180.0, 192.0, 210.0] {
            let (found, rate) = root_near(near, [1.0, 1e4], &mut value).unwrap();
            assert!((found / frequency - 1.0).abs() < 2e-3, "{near}: {found}");
            assert!((rate / growth - 1.0).abs() < 0.05, "{near}: {rate}");
        }
        // One on the left is none.
        assert_eq!(root_near(300.0, [1.0, 1e4], &mut value), None);
    }
}
