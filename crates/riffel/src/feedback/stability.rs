//! Stability of the loop without any profile.

use std::f64::consts::{FRAC_PI_2, PI};

use num_complex::Complex64;

use super::Loop;
use super::system::System;
use crate::Error;

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
    /// Frequency \[Hz\] of the oscillation that grows, as squeal or as stick and slip, the highest where there are several:
    /// that at which F crosses the negative real axis; none where the loop is stable.
    pub frequency: Option<f64>,
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
    /// decade down to 1e-11 of the frequency, 10 000 steps at most; m is the slope of |F| at the lower frequency. Range of validity: F is K s^{−m} to a few per cent at
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
        Ok(Stability {
            unstable_roots: roots as usize,
            frequency: crossing.filter(|_| roots > 0.0),
        })
    }
}

/// The phase of a number beyond that of K (iω)^{−m} with K real of either sign, nearest to zero.
fn from_asymptote(value: Complex64, order: f64) -> f64 {
    let beyond = value.arg() + order * FRAC_PI_2;
    beyond - PI * (beyond / PI).round()
}
