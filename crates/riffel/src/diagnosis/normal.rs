//! Numbers that are brought to the normal distribution.

/// Standard normal number as unlikely as the mean x of `freedom` squared normal numbers of variance one
/// (Wilson & Hilferty 1931); within 0.01 for 4 degrees of freedom or more.
pub(super) fn of_mean_square(x: f64, freedom: f64) -> f64 {
    let variance = 2.0 / (9.0 * freedom);
    (x.cbrt() - (1.0 - variance)) / variance.sqrt()
}

/// Ratio of the median of such a mean to its expectation, one.
pub(super) fn median_of_mean_square(freedom: f64) -> f64 {
    (1.0 - 2.0 / (9.0 * freedom)).powi(3)
}

/// Standard normal number as unlikely as Student's t (Wallace 1959); within 2 % of the probability for 3
/// degrees of freedom or more.
pub(super) fn of_student(t: f64, freedom: f64) -> f64 {
    let distance = (freedom * (t * t / freedom).ln_1p()).sqrt();
    distance.copysign(t) * (8.0 * freedom + 1.0) / (8.0 * freedom + 3.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use riffel_numerics::normal_distribution::above;

    #[test]
    fn tails_are_those_of_the_tables() {
        // Upper 1 % of chi-square with 20 degrees of freedom is 37.566; of t with 7 it is 2.998.
        assert!((above(of_mean_square(37.566 / 20.0, 20.0)) / 0.01 - 1.0).abs() < 0.02);
        assert!((above(of_student(2.998, 7.0)) / 0.01 - 1.0).abs() < 0.04);
        // The median of chi-square with 10 degrees of freedom is 9.342.
        assert!((10.0 * median_of_mean_square(10.0) - 9.342).abs() < 0.01);
    }
}
