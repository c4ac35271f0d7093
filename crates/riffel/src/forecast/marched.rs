//! A band whose rates depend on its amplitude, passage after passage.

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

/// The level of a band over the passages. Its wave has the amplitude √2 r of its RMS r; lines that decay keep their level.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Marched {
    /// Passages and ln r² \[m²\], both rising.
    course: Vec<(f64, f64)>,
}

impl Marched {
    /// From the mean squares of the lines now \[m²\].
    ///
    /// Method: midpoints, steps in which no line grows by more than 1 %; ended where the wave is as high as no rail bears, where
    /// nothing grows, or after more passages than any rail lives.
    pub(super) fn new(lines: &[f64], rates: &RatesByAmplitude) -> Self {
        /// \[m\].
        const HIGHEST: f64 = 0.05;
        const MOST_PASSAGES: f64 = 1e12;
        const STEP: f64 = 0.01;
        let mut squares = lines.to_vec();
        let sum = |squares: &[f64]| squares.iter().sum::<f64>();
        let rates_of = |squares: &[f64]| -> Vec<f64> {
            let amplitude = (2.0 * sum(squares)).sqrt();
            (0..squares.len())
                .map(|line| rates.at(amplitude, line).max(0.0))
                .collect()
        };
        let grown = |squares: &[f64], rates: &[f64], passages: f64| -> Vec<f64> {
            let grown = squares.iter().zip(rates);
            grown
                .map(|(square, rate)| square * (2.0 * rate * passages).exp())
                .collect()
        };
        let mut now = 0.0;
        let mut course = vec![(now, sum(&squares).ln())];
        while sum(&squares) > 0.0 && 2.0 * sum(&squares) < HIGHEST * HIGHEST && now < MOST_PASSAGES
        {
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

    /// Passages until ln r² is there; none where it never is.
    pub(super) fn passages_to(&self, goal: f64) -> Option<f64> {
        let above = self.course.partition_point(|(_, ln)| *ln < goal);
        let high = *self.course.get(above)?;
        let Some(low) = above.checked_sub(1).map(|below| self.course[below]) else {
            return Some(0.0);
        };
        Some(low.0 + (high.0 - low.0) * (goal - low.1) / (high.1 - low.1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
