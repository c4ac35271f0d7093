//! What data say of numbers that they depend on linearly.

use riffel_numerics::least_squares::triangle;
use riffel_numerics::matrix::Matrix;

/// Numbers that are normally distributed.
#[derive(Debug, Clone)]
pub(crate) struct Normal {
    pub(crate) mean: Vec<f64>,
    /// R of their precision RᵀR.
    upper: Matrix,
}

/// What is known of a number before.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Known {
    pub(crate) mean: f64,
    /// 1/variance; zero where nothing is known.
    pub(crate) precision: f64,
}

impl Normal {
    /// x after y = Σ x_i a_i + ε; `noise` is L of the covariance LLᵀ of ε. `None` if the data leave an x that nothing is known of.
    pub(crate) fn after(known: &[Known], columns: &[Vec<f64>], noise: &Matrix, data: &[f64]) -> Option<Self> {
        let white = |vector: &[f64]| noise.forward(vector.to_vec());
        let mut columns: Vec<Vec<f64>> = columns.iter().map(|column| white(column)).collect();
        let mut data = white(data);
        // What is known is a datum of its own.
        for (place, known) in known.iter().enumerate().filter(|(_, known)| known.precision > 0.0) {
            let weight = known.precision.sqrt();
            columns
                .iter_mut()
                .enumerate()
                .for_each(|(index, column)| column.push(if index == place { weight } else { 0.0 }));
            data.push(weight * known.mean);
        }
        let (upper, turned) = triangle(columns, data)?;
        Some(Self { mean: upper.backward(&turned), upper })
    }

    #[cfg(test)]
    pub(crate) fn covariance(&self) -> Matrix {
        self.upper.transposed().inverse_of_square()
    }

    /// One draw, from as many draws of mean 0 and variance 1.
    pub(crate) fn draw(&self, normal: &[f64]) -> Vec<f64> {
        let beside = self.upper.backward(normal);
        let pairs = self.mean.iter().zip(beside);
        pairs.map(|(mean, beside)| mean + beside).collect()
    }
}

#[cfg(test)]
mod tests {
    use riffel_numerics::normal_distribution::below;

    use super::*;
    use crate::conjugate::{U1, number, numbers};

    fn close(found: f64, expected: f64) {
        assert!((found - expected).abs() < 1e-10, "{found}, not {expected}");
    }

    /// U1: κ and levels of three bands at three dates, and what they say of a fourth.
    #[test]
    fn levels_of_three_dates_tell_growth_and_the_next_level() {
        let u1 = U1::read();
        let after = u1.after(&u1.proper());
        let covariance = after.covariance();
        for (place, mean) in u1.numbers("/posterior_mean").into_iter().enumerate() {
            close(after.mean[place], mean);
            let row = u1.numbers(&format!("/posterior_covariance/{place}"));
            for (column, value) in row.into_iter().enumerate() {
                close(covariance.at(place, column), value);
            }
        }
        let predicted = |key: &str| u1.numbers(&format!("/predictive_8e6/{key}"));
        for band in 0..3 {
            let by = 8.0 * u1.slopes[band];
            let mean = by * after.mean[0] + after.mean[1 + band];
            close(mean, predicted("mean_db")[band]);
            let at = |i: usize, j: usize| covariance.at(i, j);
            let variance = by * by * at(0, 0) + 2.0 * by * at(0, 1 + band) + at(1 + band, 1 + band);
            close(variance.sqrt(), predicted("sd_level_db")[band]);
            let measured = variance + 0.5f64.powi(2) + 0.3f64.powi(2);
            close(measured.sqrt(), predicted("sd_measured_db")[band]);
            if band == 0 {
                let above = below((mean - 8.0) / variance.sqrt());
                close(above, number("/U1/predictive_8e6/probability_band_1_over_8_db"));
            }
        }
        // Nothing known of the first levels.
        let flat = u1.after(&u1.flat());
        close(flat.mean[0], number("/U1/flat_first_levels/kappa_mean"));
        let deviation = flat.covariance().at(0, 0).sqrt();
        close(deviation, number("/U1/flat_first_levels/kappa_sd"));
    }

    /// U2: one datum of a sum parts nothing but the sum.
    #[test]
    fn a_sum_leaves_its_parts_to_the_prior() {
        let known = |deviation: f64| Known { mean: 0.0, precision: deviation.powi(-2) };
        let priors: Vec<Known> = numbers("/U2/prior_sd").into_iter().map(known).collect();
        let noise = Matrix::of(1, |_, _| number("/U2/error_sd"));
        let columns = [vec![1.0], vec![1.0]];
        let after = Normal::after(&priors, &columns, &noise, &[number("/U2/datum")]).unwrap();
        let covariance = after.covariance();
        for part in 0..2 {
            close(after.mean[part], numbers("/U2/mean")[part]);
            close(covariance.at(part, part).sqrt(), numbers("/U2/sd")[part]);
        }
        let sum: f64 = covariance.values.iter().sum();
        close(sum.sqrt(), number("/U2/sd_of_sum"));
        // The moments of draws: x = mean + R⁻¹ n has covariance R⁻¹R⁻ᵀ.
        let [one, other] = [[1.0, 0.0], [0.0, 1.0]].map(|n| after.draw(&n));
        let product = |i: usize, j: usize| {
            (one[i] - after.mean[i]) * (one[j] - after.mean[j])
                + (other[i] - after.mean[i]) * (other[j] - after.mean[j])
        };
        close(product(0, 1), covariance.at(0, 1));
        close(product(1, 1), covariance.at(1, 1));
    }
}
