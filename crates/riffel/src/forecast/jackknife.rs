//! How far the mean of a few records may be from the truth.

/// Fewest values of which neighbours are taken together.
const FEWEST: usize = 8;

/// Variance of an estimate over records with its degrees of freedom.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Variance {
    variance: f64,
    freedom: f64,
}

impl Variance {
    /// A variance with its degrees of freedom, infinite where it is known.
    pub(super) fn new(variance: f64, freedom: f64) -> Self {
        Self { variance, freedom }
    }

    /// Its size.
    pub(super) fn size(self) -> f64 {
        self.variance
    }

    /// So many times as large, and as well known.
    pub(super) fn times(self, factor: f64) -> Self {
        Self::new(factor * self.variance, self.freedom)
    }

    /// The variance of an estimate from what it is without each of the records, two or more, `along` a rail or in any order.
    ///
    /// Method: jackknife (Tukey 1958), n θ − (n − 1) θ₋ᵢ being the share of a record. Records of neighbouring places
    /// scatter together: along a rail, pairs of neighbours become one while those of eight or more correlate.
    pub(super) fn jackknife(all: f64, without_each: impl Iterator<Item = f64>, along: bool) -> Self {
        let without: Vec<f64> = without_each.collect();
        let count = without.len() as f64;
        let mut values: Vec<f64> = without.iter().map(|without| count * all - (count - 1.0) * without).collect();
        while along && values.len() >= FEWEST && neighbours_correlate(&values) {
            values = values.chunks_exact(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect();
        }
        let count = values.len() as f64;
        Self { variance: squares(&values) / (count - 1.0) / count, freedom: count - 1.0 }
    }

    /// The variance times a ratio that has its own degrees of freedom: their relative errors add by their squares.
    pub(super) fn known_less(self, freedom: f64) -> Self {
        let freedom = (self.freedom.recip() + freedom.recip()).recip();
        Self::new(self.variance, freedom.max(1.0))
    }

    /// That of the sum of two estimates of separate records (Welch 1947).
    pub(super) fn and(self, other: Self) -> Self {
        let variance = self.variance + other.variance;
        let part = |one: Self| one.variance.powi(2) / one.freedom;
        let parts = part(self) + part(other);
        let freedom = match parts > 0.0 {
            true => variance.powi(2) / parts,
            false => self.freedom.min(other.freedom),
        };
        Self { variance, freedom }
    }

    /// 95 % interval about the estimate by Student's t.
    pub(super) fn interval(self, estimate: f64) -> (f64, f64) {
        let half = student(OUTSIDE_95, self.freedom) * self.variance.sqrt();
        (estimate - half, estimate + half)
    }

    /// Bands of 50 and 80 % about the estimate by Student's t.
    pub(super) fn bands(self, estimate: f64) -> [[f64; 2]; 2] {
        [OUTSIDE_50, OUTSIDE_80].map(|outside| {
            let half = student(outside, self.freedom) * self.variance.sqrt();
            [estimate - half, estimate + half]
        })
    }
}

/// Sum of the squares of the differences from the mean.
fn squares(values: &[f64]) -> f64 {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    values.iter().map(|value| (value - mean).powi(2)).sum()
}

fn neighbours_correlate(values: &[f64]) -> bool {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let products = values.windows(2);
    products.map(|pair| (pair[0] - mean) * (pair[1] - mean)).sum::<f64>() > 0.0
}

/// What lies outside of 95 %, and the standard normal number of half as much.
const OUTSIDE_95: [f64; 2] = [0.05, -1.959_963_985];
/// What lies outside of 50 %, and the standard normal number of half as much.
const OUTSIDE_50: [f64; 2] = [0.5, -0.674_489_750];
/// What lies outside of 80 %, and the standard normal number of half as much.
const OUTSIDE_80: [f64; 2] = [0.2, -1.281_551_566];

/// The t outside of which Student's distribution has a share, for one degree of freedom or more, whole or not.
///
/// Method: Hill, Comm. ACM 13 (1970) 619; within 1e-3 (compared with tables).
fn student([outside, normal]: [f64; 2], freedom: f64) -> f64 {
    if freedom > 1e6 {
        return -normal;
    }
    let n = freedom;
    let a = 1.0 / (n - 0.5);
    let b = 48.0 / (a * a);
    let mut c = ((20_700.0 * a / b - 98.0) * a - 16.0) * a + 96.36;
    let d = ((94.5 / (b + c) - 3.0) / b + 1.0) * (a * std::f64::consts::FRAC_PI_2).sqrt() * n;
    let mut y = (d * outside).powf(2.0 / n);
    if y > 0.05 + a {
        let x = normal;
        y = x * x;
        if n < 5.0 {
            c += 0.3 * (n - 4.5) * (x + 0.6);
        }
        c += (((0.05 * d * x - 5.0) * x - 7.0) * x - 2.0) * x + b;
        y = (((((0.4 * y + 6.3) * y + 36.0) * y + 94.5) / c - y - 3.0) / b + 1.0) * x;
        y = (a * y * y).exp_m1();
    } else {
        let first = ((n + 6.0) / (n * y) - 0.089 * d - 0.822) * (n + 2.0) * 3.0;
        y = ((first.recip() + 0.5 / (n + 4.0)) * y - 1.0) * (n + 1.0) / (n + 2.0) + y.recip();
    }
    (n * y).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn student_is_that_of_the_tables() {
        for (outside, freedom, t) in [
            (OUTSIDE_95, 2.0, 4.303),
            (OUTSIDE_95, 3.0, 3.182),
            (OUTSIDE_95, 4.0, 2.776),
            (OUTSIDE_95, 7.0, 2.365),
            (OUTSIDE_95, 19.0, 2.093),
            (OUTSIDE_95, 120.0, 1.980),
            (OUTSIDE_50, 2.0, 0.816),
            (OUTSIDE_50, 22.0, 0.686),
            (OUTSIDE_80, 2.0, 1.886),
            (OUTSIDE_80, 4.0, 1.533),
            (OUTSIDE_80, 22.0, 1.321),
            (OUTSIDE_80, f64::INFINITY, 1.282),
        ] {
            let error = student(outside, freedom) - t;
            assert!(error.abs() < 6e-3, "{freedom}: {error}");
        }
    }

    /// The jackknife of a mean is its standard error; neighbours that are one count once.
    #[test]
    fn neighbours_that_are_one_count_once() {
        let without = |values: &[f64]| -> Vec<f64> {
            let sum: f64 = values.iter().sum();
            let count = values.len() as f64 - 1.0;
            values.iter().map(|value| (sum - value) / count).collect()
        };
        let few = [1.0, 5.0, 2.0, 4.0];
        let found = Variance::jackknife(3.0, without(&few).into_iter(), true);
        assert!((found.variance - 10.0 / 12.0).abs() < 1e-12 && found.freedom == 3.0);
        let twice = [1.0, 1.0, 5.0, 5.0, 2.0, 2.0, 4.0, 4.0];
        let found = Variance::jackknife(3.0, without(&twice).into_iter(), true);
        assert!((found.variance - 10.0 / 12.0).abs() < 1e-12 && found.freedom == 3.0);
    }
}
