//! The level of a band that grows.

use riffel::forecast::LINES_PER_BAND;

/// A band under traffic: D(N) = 10 lg mean exp(2 g_j N) over its lines and what is missed, N d.
#[derive(Debug, Clone, Copy)]
pub(crate) struct GrowingBand<'a> {
    /// Growth rates of the amplitude per passage.
    pub(crate) rates: &'a [f64],
    /// \[dB per passage\]
    pub(crate) missed: f64,
}

impl<'a> GrowingBand<'a> {
    /// The bands of the rates of all lines.
    pub(crate) fn all(rates: &'a [f64], missed: &'a [f64]) -> impl Iterator<Item = Self> {
        let bands = rates.chunks(LINES_PER_BAND).zip(missed);
        bands.map(|(rates, missed)| Self {
            rates,
            missed: *missed,
        })
    }

    /// Rise of the level after some passages \[dB\], and its slope.
    pub(crate) fn rise(&self, passages: f64) -> (f64, f64) {
        let decibels = 10.0 / std::f64::consts::LN_10;
        let fastest = self.rates.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let (mut sum, mut slopes) = (0.0, 0.0);
        for rate in self.rates {
            let energy = (2.0 * (rate - fastest) * passages).exp();
            sum += energy;
            slopes += 2.0 * rate * energy;
        }
        let mean = (sum / self.rates.len() as f64).ln();
        (
            decibels * (mean + 2.0 * fastest * passages) + self.missed * passages,
            decibels * slopes / sum + self.missed,
        )
    }

    /// Passages from `begin` on until the rise is `to`, at most until `end`; none where it is not until then.
    ///
    /// The rise is convex: what lies below the line at both ends stays below, and Newton's steps from the right do not leave
    /// its side.
    pub(crate) fn passages_until(&self, to: f64, begin: f64, end: f64) -> Option<f64> {
        if self.rise(begin).0 >= to {
            return Some(0.0);
        }
        let mut at = end;
        if self.rise(at).0 < to {
            return None;
        }
        for _ in 0..100 {
            let (rise, slope) = self.rise(at);
            let next = (at - (rise - to) / slope).max(begin);
            if at - next <= 1e-12 * at {
                break;
            }
            at = next;
        }
        Some(at - begin)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One rate has a line: 20 lg e · g N. Two have cosh: 10 lg ((e^{2gN} + e^{−2gN})/2), and never a fall at zero.
    #[test]
    fn a_rise_is_reached_where_its_closed_form_says() {
        let decibels = 10.0 / std::f64::consts::LN_10;
        let one = GrowingBand {
            rates: &[1e-7; 16],
            missed: 0.5e-6,
        };
        let per_passage = 2e-7 * decibels + 0.5e-6;
        let expected = 6.0 / per_passage;
        let found = one.passages_until(6.0, 0.0, 1e9).unwrap();
        assert!((found / expected - 1.0).abs() < 1e-12);
        // From a later begin as many less, and beyond the end none.
        let later = one.passages_until(6.0, 1e6, 1e9).unwrap();
        assert!((later - (expected - 1e6)).abs() < 1e-3);
        assert_eq!(one.passages_until(6.0, 0.0, 0.99 * expected), None);
        assert_eq!(one.passages_until(6.0, 1.01 * expected, 1e9), Some(0.0));
        let mut rates = [3e-7; 16];
        rates[..8].fill(-3e-7);
        let two = GrowingBand {
            rates: &rates,
            missed: 0.0,
        };
        let found = two.passages_until(6.0, 0.0, 1e9).unwrap();
        let expected = 10f64.powf(0.6).acosh() / 6e-7;
        assert!((found / expected - 1.0).abs() < 1e-10, "{found} {expected}");
        // No number is too large.
        assert!(two.rise(1e12).0.is_finite());
        // What falls never rises.
        let falls = GrowingBand {
            rates: &[-1e-7; 16],
            missed: 0.0,
        };
        assert_eq!(falls.passages_until(6.0, 0.0, 1e9), None);
    }
}
