//! Quantiles over the samples.

use rayon::prelude::*;

/// The value below which a share of some sorted values lies, by linear interpolation between them (type 7 of
/// Hyndman & Fan 1996, that of NumPy); there must be one value or more.
pub fn quantile(sorted: &[f64], share: f64) -> f64 {
    let place = share * (sorted.len() - 1) as f64;
    let below = place.floor() as usize;
    let above = (below + 1).min(sorted.len() - 1);
    sorted[below] + (place - below as f64) * (sorted[above] - sorted[below])
}

/// Monte-Carlo bands: quantiles over the samples for each place of a curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Bands {
    /// The shares asked for.
    pub shares: Vec<f64>,
    /// For each share the quantile at each place; not a number where no sample has one.
    pub curves: Vec<Vec<f64>>,
    /// Samples with results.
    pub samples: usize,
}

impl Bands {
    /// Quantiles of curves of `width` places, one curve after the other; a curve with a value that is not a
    /// number is left out.
    pub fn new(values: &[f64], width: usize, shares: &[f64]) -> Self {
        let curves: Vec<&[f64]> =
            values.chunks_exact(width).filter(|curve| curve.iter().all(|value| !value.is_nan())).collect();
        let by_place: Vec<Vec<f64>> = (0..width)
            .into_par_iter()
            .map(|place| {
                let mut column: Vec<f64> = curves.iter().map(|curve| curve[place]).collect();
                column.sort_by(f64::total_cmp);
                let at = |&share: &f64| match column.is_empty() {
                    true => f64::NAN,
                    false => quantile(&column, share),
                };
                shares.iter().map(at).collect()
            })
            .collect();
        Self {
            shares: shares.to_vec(),
            curves: (0..shares.len()).map(|share| by_place.iter().map(|place| place[share]).collect()).collect(),
            samples: curves.len(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_those_of_numpy() {
        let sorted = [1.0, 2.0, 4.0, 8.0];
        // numpy.quantile([1, 2, 4, 8], [0, 0.25, 0.5, 0.9, 1])
        for (share, expected) in [(0.0, 1.0), (0.25, 1.75), (0.5, 3.0), (0.9, 6.8), (1.0, 8.0)] {
            assert!((quantile(&sorted, share) - expected).abs() < 1e-12);
        }
    }

    #[test]
    fn failed_samples_are_left_out() {
        let values = [1.0, 10.0, f64::NAN, f64::NAN, 3.0, 30.0];
        let bands = Bands::new(&values, 2, &[0.5]);
        assert_eq!((bands.samples, &bands.curves[0][..]), (2, &[2.0, 20.0][..]));
    }
}
