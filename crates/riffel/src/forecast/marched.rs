//! A band whose rates depend on its amplitude, passage after passage.

use num_complex::Complex64;

use super::hardening_wheel::HardeningWheel;

/// Rates of the lines of a band over the amplitude of the wave.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct RatesByAmplitude {
    /// Rising \[m\], with the rates of all lines.
    pub(super) rates: Vec<(f64, Vec<f64>)>,
}

impl RatesByAmplitude {
    /// Rate of a line at an amplitude \[m\]: between two amplitudes in proportion to the logarithm, beyond the ends those of the
    /// ends.
    fn at(&self, amplitude: f64, line: usize) -> f64 {
        let above = self.rates.partition_point(|(own, _)| *own < amplitude);
        let rate = |index: usize| self.rates[index].1[line];
        if above == 0 {
            return rate(0);
        }
        if above == self.rates.len() {
            return rate(above - 1);
        }
        let [low, high] = [self.rates[above - 1].0, self.rates[above].0];
        let share = (amplitude / low).ln() / (high / low).ln();
        rate(above - 1) + share * (rate(above) - rate(above - 1))
    }
}

/// Amplitude that no rail bears \[m\].
const HIGHEST: f64 = 0.05;
/// More than any rail lives.
const MOST_PASSAGES: f64 = 1e12;

/// The level of a band over the passages. Its wave has the amplitude √2 r of its RMS r; lines that decay keep their level.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Marched {
    /// Passages, rising, and ln r² \[m²\].
    course: Vec<(f64, f64)>,
}

impl Marched {
    /// From the mean squares of the lines now \[m²\].
    ///
    /// Method: midpoints, steps in which no line grows by more than 1 %; ended where the wave is as high as no rail bears, where
    /// nothing grows, or after more passages than any rail lives.
    pub(super) fn new(lines: &[f64], rates: &RatesByAmplitude) -> Self {
        const STEP: f64 = 0.01;
        let mut squares = lines.to_vec();
        let sum = |squares: &[f64]| squares.iter().sum::<f64>();
        let rates_of = |squares: &[f64]| -> Vec<f64> {
            let amplitude = (2.0 * sum(squares)).sqrt();
            (0..squares.len()).map(|line| rates.at(amplitude, line).max(0.0)).collect()
        };
        let grown = |squares: &[f64], rates: &[f64], passages: f64| -> Vec<f64> {
            let grown = squares.iter().zip(rates);
            grown.map(|(square, rate)| square * (2.0 * rate * passages).exp()).collect()
        };
        let mut now = 0.0;
        let mut course = vec![(now, sum(&squares).ln())];
        while sum(&squares) > 0.0 && 2.0 * sum(&squares) < HIGHEST * HIGHEST && now < MOST_PASSAGES {
            let begin = rates_of(&squares);
            let fastest = begin.iter().copied().fold(0.0, f64::max);
            if fastest == 0.0 {
                break;
            }
            let step = STEP / fastest;
            let middle = rates_of(&grown(&squares, &begin, 0.5 * step));
            squares = grown(&squares, &middle, step);
            now += step;
            course.push((now, sum(&squares).ln()));
        }
        Self { course }
    }

    /// March of a rail that flows and hardens under some wheels, besides `rates` of all else.
    ///
    /// Every line has an amplitude a and a first harmonic D₁ of what has flowed, the band its mean D₀: the demand of a wheel is X = X₀ −
    /// D₀/D_h in the mean and u₁ − D₁/D_h along the wave, and flow is that of [`ClippedPower`](crate::damage::ClippedPower) over the
    /// wave of the whole band. Method: Runge and Kutta's of fourth order, steps in which nothing changes by more than a tenth.
    pub(super) fn hardening(lines: &[f64], rates: &RatesByAmplitude, wheels: &[HardeningWheel]) -> Self {
        const STEP: f64 = 0.1;
        const MOST_STEPS: usize = 20_000;
        /// Growth per step of what is at rest.
        const REST: f64 = 1e-6;
        let band = HardeningBand { rates, wheels, lines: lines.len() };
        let mut state = vec![Complex64::ZERO; 1 + 2 * lines.len()];
        for (own, square) in state[1..].iter_mut().zip(lines) {
            *own = (2.0 * square).sqrt().into();
        }
        let begin = band.square(&state);
        let mut now = 0.0;
        let mut course = vec![(now, (0.5 * begin).ln())];
        for _ in 0..MOST_STEPS {
            let square = band.square(&state);
            let (first, fastest) = band.slope(&state);
            if !(fastest > 0.0 && now < MOST_PASSAGES && square < HIGHEST * HIGHEST) || square < 0.25 * begin {
                break;
            }
            let step = STEP / fastest;
            let moved = |by: &[Complex64], share: f64| -> Vec<Complex64> {
                let pairs = state.iter().zip(by);
                pairs.map(|(own, by)| own + share * step * by).collect()
            };
            let (second, _) = band.slope(&moved(&first, 0.5));
            let (third, _) = band.slope(&moved(&second, 0.5));
            let (fourth, _) = band.slope(&moved(&third, 1.0));
            let mean: Vec<Complex64> =
                (0..state.len()).map(|i| (first[i] + 2.0 * second[i] + 2.0 * third[i] + fourth[i]) / 6.0).collect();
            state = moved(&mean, 1.0);
            now += step;
            let after = band.square(&state);
            course.push((now, (0.5 * after.max(begin)).ln()));
            let grows = (0..lines.len()).any(|line| rates.at(after.sqrt(), line) > 0.0);
            if !grows && (after - square).abs() < REST * square {
                break;
            }
        }
        Self { course }
    }

    /// ln r² after some passages; beyond the end it stays.
    pub(super) fn ln_at(&self, passages: f64) -> f64 {
        let above = self.course.partition_point(|(own, _)| *own < passages);
        let last = self.course.len() - 1;
        if above == 0 || above > last {
            return self.course[above.min(last)].1;
        }
        let [low, high] = [self.course[above - 1], self.course[above]];
        low.1 + (high.1 - low.1) * (passages - low.0) / (high.0 - low.0)
    }

    /// Passages after which ln r² has come to rest, but for a twentieth of its way; `None` if it goes on at the end.
    pub(super) fn rests_after(&self) -> Option<f64> {
        const LEFT: f64 = 0.05;
        const REST: f64 = 1e-4;
        let [.., before, end] = self.course[..] else {
            return None;
        };
        let off = |at: &(f64, f64)| (at.1 - end.1).abs();
        let way = self.course.iter().map(off).fold(0.0, f64::max);
        let moving = self.course.iter().rposition(|at| off(at) > LEFT * way)?;
        (off(&before) <= REST * way).then(|| self.course[moving + 1].0)
    }

    /// Passages until ln r² is there; `None` if it never is.
    pub(super) fn passages_to(&self, goal: f64) -> Option<f64> {
        let above = self.course.iter().position(|(_, ln)| *ln >= goal)?;
        let high = self.course[above];
        let Some(low) = above.checked_sub(1).map(|below| self.course[below]) else {
            return Some(0.0);
        };
        Some(low.0 + (high.0 - low.0) * (goal - low.1) / (high.1 - low.1))
    }
}

/// A band under wheels that make it flow and harden. Its state: D₀, then the amplitudes of the lines, then their D₁.
struct HardeningBand<'a> {
    rates: &'a RatesByAmplitude,
    wheels: &'a [HardeningWheel],
    lines: usize,
}

impl HardeningBand<'_> {
    /// Square of the amplitude of the band \[m²\].
    fn square(&self, state: &[Complex64]) -> f64 {
        state[1..=self.lines].iter().map(Complex64::norm_sqr).sum()
    }

    /// Change per passage, and the fastest rate in it.
    fn slope(&self, state: &[Complex64]) -> (Vec<Complex64>, f64) {
        let amplitude = self.square(state).sqrt();
        let (waves, flowed) = state[1..].split_at(self.lines);
        let mut slope = vec![Complex64::ZERO; state.len()];
        let mut fastest: f64 = 0.0;
        for wheel in self.wheels {
            let softening = wheel.softening();
            let excess = wheel.excess - state[0].re * softening;
            let swings: Vec<Complex64> =
                (0..self.lines).map(|line| wheel.gains[line] * waves[line] - flowed[line] * softening).collect();
            let size = swings.iter().map(Complex64::norm_sqr).sum::<f64>().sqrt();
            let per_passage = wheel.share * wheel.flow.depth;
            let rate = per_passage * wheel.flow.law.rate(excess, size);
            slope[0] += per_passage * wheel.flow.law.depth(excess, size);
            for (slope, swing) in slope[1 + self.lines..].iter_mut().zip(&swings) {
                *slope += rate * swing;
            }
            let gain = wheel.gains.iter().map(|gain| gain.norm()).fold(0.0, f64::max);
            fastest += rate * (gain + softening);
        }
        let mut others: f64 = 0.0;
        for line in 0..self.lines {
            let drift: f64 = (self.wheels.iter()).map(|wheel| wheel.share * wheel.drifts[line]).sum();
            let rate = Complex64::new(self.rates.at(amplitude, line), drift);
            others = others.max(rate.norm());
            let flows = slope[1 + self.lines + line];
            slope[1 + line] = rate * waves[line] - flows;
        }
        (slope, fastest + others)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::damage::{ClippedPower, Flow};

    fn wheel(gain: Complex64, hardening_depth: f64) -> HardeningWheel {
        HardeningWheel {
            share: 1.0,
            flow: Flow { depth: 1e-7, law: ClippedPower::new(1.0, 0.0), hardening_depth: Some(hardening_depth) },
            excess: 0.5,
            gains: vec![gain],
            drifts: vec![0.0],
        }
    }

    /// Flow alone that hardens ends at r₀/|1 + D_h u₁/Δ|, as two wheels of half the passages do; where the runaway number is above one it
    /// goes on; half the depth takes twice the passages.
    #[test]
    fn hardening_ends_a_wave() {
        let none = RatesByAmplitude { rates: vec![(1.0, vec![0.0])] };
        let square = 0.5 * 20e-6_f64.powi(2);
        let gain = Complex64::new(-372.0, 196.0);
        let one = wheel(gain, 0.2e-3);
        let end = crate::forecast::HardeningEnd::of(std::slice::from_ref(&one), 0).unwrap();
        assert!((end.runaway_number - 0.0744).abs() < 1e-12);
        let closed = (1.0 + 0.2e-3 * gain).norm().recip();
        assert!((end.wave_ratio.unwrap() / closed - 1.0).abs() < 1e-12);
        let marched = Marched::hardening(&[square], &none, std::slice::from_ref(&one));
        let ratio = (0.5 * (marched.ln_at(1e9) - square.ln())).exp();
        assert!((ratio / closed - 1.0).abs() < 1e-4, "{ratio} {closed}");
        // At rest but for a twentieth after about ln 20 times D_h/H.
        let rests = marched.rests_after().unwrap();
        assert!((rests / (2e3 * 20f64.ln()) - 1.0).abs() < 0.2, "{rests}");
        // On the way, 1 − e^{−n H (1/D_h + G)} of what flows along the wave; the chords of a tenth of a step.
        let passages = 1500.0;
        let along = 1.0 / 0.2e-3 + gain;
        let left = 1.0 - (gain / along) * (1.0 - (-1e-7 * passages * along).exp());
        let ratio = (0.5 * (marched.ln_at(passages) - square.ln())).exp();
        assert!((ratio / left.norm() - 1.0).abs() < 1e-4, "{ratio} {left}");
        let halves = [one.part(0..1, 0.5), one.part(0..1, 0.5)];
        let two = Marched::hardening(&[square], &none, &halves);
        assert!((two.ln_at(passages) - marched.ln_at(passages)).abs() < 1e-9);
        let mut slow = one.clone();
        slow.flow.depth *= 0.5;
        let slow = Marched::hardening(&[square], &none, &[slow]);
        assert!((slow.ln_at(2.0 * passages) - marched.ln_at(passages)).abs() < 1e-9);
        let away = wheel(gain, 5e-3);
        let end = crate::forecast::HardeningEnd::of(std::slice::from_ref(&away), 0).unwrap();
        assert!(end.runaway_number > 1.0 && end.wave_ratio.is_none());
        let marched = Marched::hardening(&[square], &none, &[away]);
        assert!(marched.ln_at(1e12) - square.ln() > 10.0);
        assert_eq!(marched.rests_after(), None);
    }

    /// A band whose lines part, one growing by a half and one falling: together √((1.5² + 0.4²)/2), not the larger; it runs away where one does.
    #[test]
    fn a_band_ends_with_all_its_lines() {
        let gains = |ratios: [f64; 2]| HardeningWheel {
            gains: ratios.map(|ratio| Complex64::from((1.0 / ratio - 1.0) / 1e-3)).to_vec(),
            drifts: vec![0.0; 2],
            ..wheel(Complex64::ZERO, 1e-3)
        };
        let end = crate::forecast::HardeningEnd::of_band(&[gains([1.5, 0.4])], 2).unwrap();
        let together = f64::sqrt(0.5 * (1.5 * 1.5 + 0.4 * 0.4));
        assert!((end.wave_ratio.unwrap() / together - 1.0).abs() < 1e-12);
        assert!((end.runaway_number - 1.0 / 3.0).abs() < 1e-12);
        let end = crate::forecast::HardeningEnd::of_band(&[gains([-2.0, 0.4])], 2).unwrap();
        assert!(end.runaway_number > 1.0 && end.wave_ratio.is_none());
    }

    /// A steady rate is an exponential; one that falls as 1/A makes a straight line; one that begins at an amplitude never does below.
    #[test]
    fn rates_over_amplitudes() {
        let amplitudes: Vec<f64> = (0..=400).map(|step| 1e-6 * 1.02f64.powi(step)).collect();
        let of = |rate: &dyn Fn(f64) -> f64| RatesByAmplitude {
            rates: amplitudes.iter().map(|&a| (a, vec![rate(a)])).collect(),
        };
        let square = 0.5 * 1e-5_f64.powi(2);
        let steady = Marched::new(&[square], &of(&|_| 1e-6));
        let grown = steady.ln_at(1e6) - square.ln();
        assert!((grown - 2.0).abs() < 1e-9, "{grown}");
        assert!((steady.passages_to(square.ln() + 2.0).unwrap() / 1e6 - 1.0).abs() < 1e-9);
        let straight = Marched::new(&[square], &of(&|a| 1e-12 / a));
        let after = (2.0 * straight.ln_at(4e7).exp()).sqrt();
        // 10 µm and 40 µm; the chord of 1/A over 2 % of A is 2e-5 high.
        assert!((after / 5e-5 - 1.0).abs() < 2e-4, "{after}");
        let late = Marched::new(&[square], &of(&|a| if a > 2e-5 { 1e-6 } else { 0.0 }));
        assert_eq!(late.ln_at(1e9), square.ln());
        assert_eq!(late.passages_to(square.ln() + 0.1), None);
        // Half the rate takes twice the passages.
        let half = Marched::new(&[square], &of(&|a| 0.5e-12 / a));
        assert!((half.ln_at(8e7) - straight.ln_at(4e7)).abs() < 1e-9);
    }
}
