//! Where the growth of a wave meets the mean wear of its rail.

use super::GrowingSum;
use super::passages_until::passages_until;

/// From some passages on a wave can no longer grow by its rate, for it would need more than the mean wear.
///
/// What a passage wears off is never negative, so that the amplitude A of a wave grows by the mean depth w̄ per passage at most,
/// see [`MeanWear`](crate::MeanWear): dA/dN = min(gA, w̄). Up to gA = w̄ it grows by its exponentials, from there on along a
/// straight line; a rate that is steady turns into one that falls as 1/A.
///
/// Range of validity: a bound, no course. What saturates corrugation on a line, as loss of contact does, comes on top.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bend {
    /// Axle passages until then.
    pub(super) passages: f64,
    /// Amplitude there \[m\].
    amplitude: f64,
    /// w̄ \[m\].
    depth: f64,
}

impl Bend {
    /// Where a sum of waves, of mean squares in m², meets a mean depth of wear \[m\]; `None` if it never does.
    ///
    /// A is convex in N, so that it does so once.
    pub(super) fn of(sum: &GrowingSum, depth: f64) -> Option<Self> {
        let amplitude = |passages: f64| (2.0 * sum.mean_square(passages)).sqrt();
        let is_beyond = |passages: f64| sum.rate(passages) * amplitude(passages) >= depth;
        let passages = passages_until(0.0, f64::MAX, is_beyond)?;
        Some(Self { passages, amplitude: amplitude(passages), depth })
    }

    /// Mean square \[m²\] after passages beyond it.
    pub(super) fn mean_square(&self, passages: f64) -> f64 {
        0.5 * (self.amplitude + self.depth * (passages - self.passages)).powi(2)
    }

    /// Axle passages until a mean square \[m²\] beyond it; `None` if nothing wears.
    pub(super) fn passages_to(&self, mean_square: f64) -> Option<f64> {
        let more = ((2.0 * mean_square).sqrt() - self.amplitude) / self.depth;
        more.is_finite().then_some(self.passages + more)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        /// However many waves grow and decay at whatever rates, no passage adds more to their amplitude than the mean wear.
        #[test]
        fn no_passage_adds_more_than_the_mean_wear(
            waves in proptest::collection::vec((-14.0..-8.0, -1e-4..1e-4), 1..6),
            depth in -12.0..-7.0,
            steps in proptest::collection::vec(0.0..3e5, 12),
        ) {
            let squares = waves.iter().map(|&(power, rate)| (10f64.powf(power), rate));
            let (sum, depth) = (GrowingSum::new(squares), 10f64.powf(depth));
            let bend = Bend::of(&sum, depth);
            let amplitude = |passages: f64| {
                let square = match bend.filter(|bend| passages > bend.passages) {
                    Some(bend) => bend.mean_square(passages),
                    None => sum.mean_square(passages),
                };
                (2.0 * square).sqrt()
            };
            let mut passages = 0.0;
            for step in steps {
                let (before, after) = (amplitude(passages), amplitude(passages + step));
                // Rounding of the amplitudes.
                prop_assert!(after - before <= depth * step + 1e-9 * after, "{before} {after} {depth} {step}");
                passages += step;
            }
        }
    }

    /// One wave of 10 µm that grows by 1e-5 per passage over 1 nm of wear bends at 100 µm, after ln 10/g.
    #[test]
    fn a_wave_bends_where_it_needs_all_wear() {
        let sum = GrowingSum::new([(0.5 * 1e-5_f64.powi(2), 1e-5)]);
        let bend = Bend::of(&sum, 1e-9).unwrap();
        assert!((bend.passages / (10f64.ln() / 1e-5) - 1.0).abs() < 1e-12);
        assert!((bend.amplitude / 1e-4 - 1.0).abs() < 1e-12);
        // 50 µm more take 50 000 passages.
        let later = bend.passages + 5e4;
        assert!((bend.mean_square(later) / (0.5 * 1.5e-4_f64.powi(2)) - 1.0).abs() < 1e-9);
        let back = bend.passages_to(bend.mean_square(later)).unwrap();
        assert!((back / later - 1.0).abs() < 1e-12);
        // Now already.
        assert_eq!(Bend::of(&sum, 1e-11).unwrap().passages, 0.0);
        let still = GrowingSum::new([(1e-10, 0.0)]);
        assert_eq!(Bend::of(&still, 1e-9), None);
    }
}
