//! A prediction: a value over all samples of the choices.

use serde::Serialize;

/// Median and bands of a value over the samples.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Prediction {
    /// Half of the samples lie below.
    pub median: f64,
    /// From the quantile of 25 to that of 75 %.
    pub band_50: [f64; 2],
    /// From the quantile of 10 to that of 90 %.
    pub band_80: [f64; 2],
}

impl Prediction {
    /// Of values in any order; none of none.
    pub(super) fn of(mut values: Vec<f64>) -> Option<Self> {
        values.retain(|value| value.is_finite());
        values.sort_by(f64::total_cmp);
        let last = values.len().checked_sub(1)?;
        let at = |share: f64| {
            let place = share * last as f64;
            let (below, part) = (place.floor() as usize, place.fract());
            values[below] + part * (values[(below + 1).min(last)] - values[below])
        };
        Some(Self {
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
        let found = Prediction::of(ramp).unwrap();
        assert_eq!(found.median, 50.0);
        assert_eq!((found.band_50, found.band_80), ([25.0, 75.0], [10.0, 90.0]));
        assert_eq!(Prediction::of(vec![f64::NAN]), None);
    }
}
