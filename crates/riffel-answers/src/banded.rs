//! Numbers with bands.

use riffel::forecast::WearSpread;
use riffel_study::sensitivity::quantile;
use serde::Serialize;

/// A number with the bands that hold 50 and 80 % of what it may be.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Banded {
    /// Half lies below.
    pub median: f64,
    /// From the quantile of 25 to that of 75 %.
    pub band_50: [f64; 2],
    /// From the quantile of 10 to that of 90 %.
    pub band_80: [f64; 2],
}

impl Banded {
    /// What is in proportion to a wear coefficient.
    pub fn by_wear(median: f64, spread: WearSpread) -> Self {
        Self { median, band_50: spread.band_50(median), band_80: spread.band_80(median) }
    }

    /// Bands in a unit of which the present one has so many.
    pub(crate) fn times(self, factor: f64) -> Self {
        Self {
            median: factor * self.median,
            band_50: self.band_50.map(|end| factor * end),
            band_80: self.band_80.map(|end| factor * end),
        }
    }

    /// Of samples in any order, those that are no number left out; none of none.
    pub fn of_samples(mut samples: Vec<f64>) -> Option<Self> {
        samples.retain(|sample| sample.is_finite());
        samples.sort_by(f64::total_cmp);
        let at = |share: f64| quantile(&samples, share);
        (!samples.is_empty()).then(|| Self {
            median: at(0.5),
            band_50: [at(0.25), at(0.75)],
            band_80: [at(0.1), at(0.9)],
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_of_a_ramp() {
        let ramp = (0..=100).rev().map(f64::from).collect();
        let found = Banded::of_samples(ramp).unwrap();
        assert_eq!(found.median, 50.0);
        assert_eq!((found.band_50, found.band_80), ([25.0, 75.0], [10.0, 90.0]));
        assert_eq!(Banded::of_samples(vec![f64::NAN]), None);
    }

    /// Decay has its larger size first.
    #[test]
    fn bounds_are_in_order() {
        for median in [-3.0, 2.0] {
            let Banded { band_50, band_80, .. } = Banded::by_wear(median, WearSpread::UNMEASURED);
            let places = [band_80[0], band_50[0], median, band_50[1], band_80[1]];
            assert!(places.is_sorted(), "{places:?}");
        }
    }
}
