//! Waves that grow at rates of their own.

use std::f64::consts::LN_10;

/// Rounding of a sum of logarithms; 4e-12 dB.
const ROUNDING: f64 = 1e-12;

/// Steps of Newton's method; it needs some ten.
const MOST_STEPS: usize = 200;

/// Mean square of waves that each grow or decay exponentially with the passages N:
/// r²(N) = Σ_j r_j² exp(2 g_j N).
///
/// ln r² is convex in N: what is below a level now crosses it once, or never.
#[derive(Debug, Clone, PartialEq)]
pub struct GrowingSum {
    /// ln r_j² and 2 g_j.
    terms: Vec<(f64, f64)>,
}

impl GrowingSum {
    /// The sum of waves of the mean squares r_j² now, in any unit, and the growth rates g_j of their
    /// amplitudes per passage \[-\]. A wave of no mean square is left out.
    pub fn new(waves: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Self {
            terms: waves
                .into_iter()
                .filter(|wave| wave.0 > 0.0)
                .map(|(square, rate)| (square.ln(), 2.0 * rate))
                .collect(),
        }
    }

    /// The waves as they are after some passages.
    #[must_use]
    pub fn after(mut self, passages: f64) -> Self {
        for (square, growth) in &mut self.terms {
            *square += *growth * passages;
        }
        self
    }

    /// ln r² after some passages, without overflow.
    fn ln_at(&self, passages: f64) -> f64 {
        self.sums(passages).0
    }

    /// ln r² and its derivative by N.
    fn sums(&self, passages: f64) -> (f64, f64) {
        let exponent = |term: &(f64, f64)| term.0 + term.1 * passages;
        let largest = self.terms.iter().map(exponent).fold(f64::NEG_INFINITY, f64::max);
        let (mut sum, mut slope) = (0.0, 0.0);
        for term in &self.terms {
            let part = (exponent(term) - largest).exp();
            sum += part;
            slope += part * term.1;
        }
        (largest + sum.ln(), slope / sum)
    }

    /// Mean square after some passages; infinite where it is beyond all numbers.
    pub fn mean_square(&self, passages: f64) -> f64 {
        if self.terms.is_empty() {
            return 0.0;
        }
        self.ln_at(passages).exp()
    }

    /// Change of level after some passages \[dB\], 10 lg(r²(N)/r²(0)).
    pub fn level_change(&self, passages: f64) -> f64 {
        if self.terms.is_empty() {
            return 0.0;
        }
        10.0 / LN_10 * (self.ln_at(passages) - self.ln_at(0.0))
    }

    /// Growth rate of the RMS per passage \[-\] after some passages, the mean of the g_j by energy.
    pub fn rate(&self, passages: f64) -> f64 {
        if self.terms.is_empty() {
            return 0.0;
        }
        0.5 * self.sums(passages).1
    }

    /// Passages until the mean square reaches a value; `None` if it never does, 0 where it is there now.
    ///
    /// Newton's method on ln r², from where the first wave alone is there: convex, so it comes down to the
    /// crossing from above without leaving it; to rounding.
    pub fn passages_to(&self, mean_square: f64) -> Option<f64> {
        if self.terms.is_empty() {
            return None;
        }
        let goal = mean_square.ln();
        if self.ln_at(0.0) >= goal - ROUNDING {
            return Some(0.0);
        }
        let mut passages = self
            .terms
            .iter()
            .filter(|term| term.1 > 0.0)
            .map(|term| (goal - term.0) / term.1)
            .min_by(f64::total_cmp)?;
        for _ in 0..MOST_STEPS {
            let (value, slope) = self.sums(passages);
            let step = (value - goal) / slope;
            passages -= step;
            if step <= 4.0 * f64::EPSILON * passages {
                break;
            }
        }
        Some(passages)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_wave_grows_by_twenty_over_ln_ten() {
        let wave = GrowingSum::new([(4e-12, 3e-7)]);
        for passages in [0.0, 1e5, 1e7, 1e12] {
            let expected = 20.0 / LN_10 * 3e-7 * passages;
            assert!((wave.level_change(passages) - expected).abs() <= 1e-12 * expected.max(1.0));
        }
        assert!((wave.rate(1e6) - 3e-7).abs() < 1e-20);
        // To four times the amplitude.
        let passages = wave.passages_to(64e-12).unwrap();
        assert!((passages / (4f64.ln() / 3e-7) - 1.0).abs() < 1e-14);
    }

    #[test]
    fn what_decays_arrives_only_where_it_is() {
        let wave = GrowingSum::new([(1.0, -1e-6), (2.0, -3e-6)]);
        assert_eq!(wave.passages_to(3.1), None);
        assert_eq!(wave.passages_to(3.0), Some(0.0));
        assert!(wave.level_change(1e6) < 0.0);
        assert_eq!(GrowingSum::new([]).passages_to(1.0), None);
        assert_eq!(GrowingSum::new([(1.0, 0.0)]).passages_to(2.0), None);
    }

    /// Later waves have as many passages less before them, also where their squares are beyond all numbers.
    #[test]
    fn waves_begin_anew_after_some_passages() {
        let sum = GrowingSum::new([(1.0, -1e-6), (1e-4, 2e-6)]);
        let later = sum.clone().after(3e5);
        let (early, late) = (sum.passages_to(4.0), later.passages_to(4.0));
        assert!((early.unwrap() - late.unwrap() - 3e5).abs() < 1e-4);
        assert_eq!(sum.clone().after(1e12).passages_to(4.0), Some(0.0));
        assert!(sum.after(1e12).level_change(1e3).is_finite());
    }

    /// A strong wave fades while a weak one rises: down first, then up to where it began.
    #[test]
    fn the_fastest_wave_takes_over() {
        let sum = GrowingSum::new([(1.0, -1e-6), (1e-4, 2e-6)]);
        assert!(sum.level_change(5e5) < 0.0 && sum.rate(0.0) < 0.0);
        let passages = sum.passages_to(4.0).unwrap();
        assert!((sum.mean_square(passages) / 4.0 - 1.0).abs() < 1e-12);
        assert!((sum.rate(1e8) / 2e-6 - 1.0).abs() < 1e-12);
    }
}
