//! Stability of the loop without any profile.

use std::f64::consts::{FRAC_PI_2, PI};

use num_complex::Complex64;

use super::Loop;
use super::continued_fraction::ContinuedFraction;
use super::system::System;
use crate::Error;
use crate::cancel::check;

/// Largest turn of the phase \[rad\] in one step, small beside the half turn at which its sense would be lost.
const LARGEST_TURN: f64 = 0.5;

/// Steps a decade before any is halved.
const A_DECADE: f64 = 40.0;

/// Shortest step over its frequency: a phase that turns more within it is given up.
const SHORTEST: f64 = 1e-11;

/// Most steps of the phase, of which the presets of wheelsets need less than a thousand.
const MOST_STEPS: usize = 10_000;

/// What grows in the loop without any profile, at one speed.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct Stability {
    /// How many roots of the loop lie in the half-plane of growing oscillations, two for each oscillation; zero where
    /// the loop is stable.
    pub unstable_roots: usize,
    /// Frequency \[Hz\] of the oscillation that grows, as squeal or as stick and slip, the highest where there are several; none
    /// where the loop is stable.
    pub frequency: Option<f64>,
    /// How fast it grows \[1/s\]: its amplitude as the exponential of this times the time. `None` if the loop is stable, or
    /// where the root is not found.
    pub growth_rate: Option<f64>,
    /// Each oscillation that grows, the highest first; those that are not found are missing.
    pub roots: Vec<UnstableRoot>,
}

/// An oscillation that grows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UnstableRoot {
    /// \[Hz\].
    pub frequency: f64,
    /// \[1/s\].
    pub growth_rate: f64,
    /// Whether it lies where the loop is known: one beyond that does not decide.
    pub counts: bool,
}

impl Stability {
    /// Stability where the loop is known up to a frequency \[Hz\]: an oscillation beyond it does not count, and
    /// [`frequency`](Self::frequency) and [`growth_rate`](Self::growth_rate) are those of the highest that does.
    pub fn known_to(mut self, frequency: f64) -> Self {
        for root in &mut self.roots {
            root.counts = root.frequency <= frequency;
        }
        let highest = self.roots.iter().find(|root| root.counts);
        self.growth_rate = highest.map(|root| root.growth_rate);
        self.frequency = match self.roots.is_empty() {
            true => self.frequency.filter(|own| *own <= frequency),
            false => highest.map(|root| root.frequency),
        };
        self
    }
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
    /// negative real axis an oscillation that grows is near; its root is found beside the imaginary axis, on which alone receptances are known,
    /// by a continued fraction through values there and Newton's method: to 1e-6 where it lies within a third of its frequency (test
    /// `roots_are_found_beside_the_axis`). Range of validity: F is K s^{−m} to a few per cent at
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
        // F crosses the negative real axis where its phase is an odd number of half turns from that at the upper end.
        let end = turned - here.1.arg();
        let turns = |phase: f64| ((phase - end - PI) / (2.0 * PI)).floor();
        let crossings: Vec<f64> = (course.windows(2).rev())
            .filter(|pair| roots > 0.0 && turns(pair[1].1) < turns(pair[0].1))
            .map(|pair| (pair[0].0 * pair[1].0).sqrt())
            .collect();
        let found = roots_near(&crossings, [from, to], &mut quotient);
        let highest = found.first();
        Ok(Stability {
            unstable_roots: roots as usize,
            frequency: highest.map(|root| root.frequency).or(crossings.first().copied()),
            growth_rate: highest.map(|root| root.growth_rate),
            roots: found,
        })
    }
}

/// The roots of an analytic function to the right of the imaginary axis near some frequencies \[Hz\], the highest first.
///
/// Method: from values on the axis about each frequency it is continued beside the axis, [`ContinuedFraction`], where Newton's method goes on
/// until it converges, for one root after the other; then once more from values about the root alone, which takes away what is no root.
fn roots_near(crossings: &[f64], [from, to]: [f64; 2], value: &mut impl FnMut(f64) -> Complex64) -> Vec<UnstableRoot> {
    /// Values on the axis.
    const SAMPLES: usize = 96;
    /// Range about a frequency over it, and where it begins to look beside the axis.
    const FIRST: f64 = 0.5;
    const BESIDE: [f64; 4] = [0.003, 0.03, 0.1, 0.3];
    /// Range about a root, of what it lies beside the axis and over its frequency.
    const AROUND: f64 = 4.0;
    const LEAST: f64 = 0.02;
    /// How near both are to each other, over the frequency, and how near one root to itself.
    const AGREED: f64 = 1e-3;
    const SAME: f64 = 1e-7;
    let mut about = |middle: f64, half: f64| {
        let low = (middle * (1.0 - half)).max(from);
        let high = (middle * (1.0 + half)).min(to);
        let samples: Vec<(f64, Complex64)> = (0..SAMPLES)
            .map(|sample| low + (high - low) * sample as f64 / (SAMPLES - 1) as f64)
            .map(|frequency| (frequency, value(frequency)))
            .collect();
        ContinuedFraction::through(&samples)
    };
    // s = 2πi x: to the right of the axis is below the real frequencies.
    let mut found: Vec<Complex64> = Vec::new();
    for &near in crossings {
        check();
        let wide = about(near, FIRST);
        let mut known: Vec<Complex64> = Vec::new();
        for beside in BESIDE {
            let start = near * Complex64::new(1.0, -beside);
            let Some(zero) = wide.zero_from(start, &known) else {
                continue;
            };
            known.push(zero);
            if !(zero.im < 0.0 && (zero - near).norm() < FIRST * near) {
                continue;
            }
            let half = (AROUND * -zero.im / zero.re).clamp(LEAST, FIRST);
            let again = about(zero.re, half).zero_from(zero, &[]);
            let again = again.filter(|again| again.im < 0.0 && (again - zero).norm() < AGREED * near.max(zero.re));
            let is_new = |zero: &Complex64| {
                let same = |other: &Complex64| (zero - other).norm() < SAME * near;
                !found.iter().any(same)
            };
            found.extend(again.filter(is_new));
        }
    }
    found.sort_by(|one, other| other.re.total_cmp(&one.re));
    let root = |zero: &Complex64| UnstableRoot { frequency: zero.re, growth_rate: -2.0 * PI * zero.im, counts: true };
    found.iter().map(root).collect()
}

/// The phase of a number beyond that of K (iω)^{−m} with K real of either sign, nearest to zero.
fn from_asymptote(value: Complex64, order: f64) -> f64 {
    let beyond = value.arg() + order * FRAC_PI_2;
    beyond - PI * (beyond / PI).round()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A made-up loop: pairs of roots (growth 1/s, frequency Hz) over as many poles, beside a damped root and the root of s of a free rail.
    fn loop_with(roots: &[[f64; 2]]) -> impl FnMut(f64) -> Complex64 {
        move |frequency: f64| {
            let s = Complex64::new(0.0, 2.0 * PI * frequency);
            let pair = |[growth, frequency]: [f64; 2]| {
                let root = Complex64::new(growth, 2.0 * PI * frequency);
                (s - root) * (s - root.conj())
            };
            let zeros: Complex64 = roots.iter().map(|&root| pair(root)).product();
            let poles = (s + 1000.0).powu(2 * roots.len() as u32);
            zeros / poles * pair([-40.0, 300.0]) / pair([-15.0, 240.0]) * (s + 20.0).sqrt()
        }
    }

    /// The highest oscillation up to a frequency decides; where none was found, the place where one must be.
    #[test]
    fn an_oscillation_beyond_what_is_known_does_not_decide() {
        let root = |frequency: f64| UnstableRoot { frequency, growth_rate: 0.1 * frequency, counts: true };
        for (roots, crossing, decides) in [
            (&[][..], None, None),
            (&[], Some(180.0), Some(180.0)),
            (&[], Some(3000.0), None),
            (&[3000.0], Some(3000.0), None),
            (&[3000.0, 180.0, 80.0], Some(3000.0), Some(180.0)),
        ] {
            let found = Stability {
                unstable_roots: 2 * roots.len(),
                frequency: crossing,
                growth_rate: None,
                roots: roots.iter().copied().map(root).collect(),
            };
            let known = found.known_to(2000.0);
            assert_eq!(known.frequency, decides, "{roots:?}");
            assert_eq!(known.roots.len(), roots.len());
        }
    }

    /// Each root with its rate, near the axis and far from it, from places a tenth off; two that nearly are one too. The values have
    /// fifteen digits, some of which the way beside the axis and a close pair take.
    #[test]
    fn roots_are_found_beside_the_axis() {
        let far: &[[f64; 2]] = &[[131.0, 162.47]];
        for (roots, crossings) in [
            (&[[25.0, 200.0]][..], vec![180.0, 210.0]),
            (far, vec![173.53]),
            (&[[1.51, 15.17], [4.87, 15.16]], vec![15.2]),
            (&[[131.0, 162.47], [0.3, 80.0]], vec![80.1, 170.0]),
        ] {
            let mut value = loop_with(roots);
            let mut found = roots_near(&crossings, [1.0, 1e4], &mut value);
            let by_growth = |one: &UnstableRoot, other: &UnstableRoot| one.growth_rate.total_cmp(&other.growth_rate);
            found.sort_by(by_growth);
            let mut expected = roots.to_vec();
            expected.sort_by(|one, other| one[0].total_cmp(&other[0]));
            assert_eq!(found.len(), expected.len(), "{found:?}");
            for (found, [growth, frequency]) in found.iter().zip(expected) {
                let off = [found.growth_rate / growth, found.frequency / frequency];
                assert!(off.iter().all(|ratio| (ratio - 1.0).abs() < 1e-6), "{found:?}");
            }
        }
        // Those on the left are none.
        let mut damped = loop_with(&[[-25.0, 200.0]]);
        assert_eq!(roots_near(&[200.0], [1.0, 1e4], &mut damped), []);
    }
}
