//! What it is worth to know more before one decides.

use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::SeedableRng;
use riffel_numerics::matrix::{Matrix, dot};
use riffel_numerics::normal_distribution::{below, density};

use riffel_numerics::random_numbers::normal;

/// Draws of what a measurement may find, where there are more than two actions.
const FINDINGS: u32 = 20_000;

/// What it is worth to know everything: min_a E C_a − E min_a C_a over costs of actions in the same draws.
pub fn of_everything(costs: &[Vec<f64>]) -> f64 {
    let draws = costs.first().map_or(0, Vec::len);
    let least = costs.iter().map(|costs| mean(costs)).fold(f64::INFINITY, f64::min);
    let of_draw = |draw: usize| costs.iter().map(|costs| costs[draw]).fold(f64::INFINITY, f64::min);
    let best: Vec<f64> = (0..draws).map(of_draw).collect();
    least - mean(&best)
}

/// What it is worth to learn of two actions whose costs differ by `difference` in the mean, where that mean will move by a
/// standard deviation: sφ(d/s) − |d|Φ(−|d|/s).
pub fn of_a_difference(difference: f64, deviation: f64) -> f64 {
    if deviation <= 0.0 {
        return 0.0;
    }
    let t = difference.abs() / deviation;
    deviation * density(t) - difference.abs() * below(-t)
}

/// What a measurement is worth that takes the covariance of the parameters from Σ to Σ′: costs are linear in the parameters, with
/// their means and slopes given, so that means of costs move by hᵀ(Σ − Σ′)h.
pub(crate) fn of_a_measurement(means: &[f64], slopes: &[Vec<f64>], told: &Matrix) -> f64 {
    if let ([one, other], [by_one, by_other]) = (means, slopes) {
        let h: Vec<f64> = by_one.iter().zip(by_other).map(|(a, b)| a - b).collect();
        let variance = dot(&h, &told.times(&h));
        return of_a_difference(one - other, variance.max(0.0).sqrt());
    }
    let (values, vectors) = told.eigenvectors();
    // Of each action, by each of the independent things that are told.
    let moves: Vec<Vec<f64>> = slopes
        .iter()
        .map(|slopes| {
            let parts = vectors.times(slopes).into_iter().zip(&values);
            parts.map(|(part, value)| part * value.max(0.0).sqrt()).collect()
        })
        .collect();
    let mut random = Xoshiro256PlusPlus::seed_from_u64(1);
    let mut best = 0.0;
    for _ in 0..FINDINGS {
        let found: Vec<f64> = values.iter().map(|_| normal(&mut random)).collect();
        // A finding and its opposite: means stay where they are.
        for sign in [1.0, -1.0] {
            let costs = means.iter().zip(&moves);
            let costs = costs.map(|(mean, moves)| mean + sign * dot(moves, &found));
            best += costs.fold(f64::INFINITY, f64::min);
        }
    }
    let least = means.iter().copied().fold(f64::INFINITY, f64::min);
    (least - best / (2.0 * f64::from(FINDINGS))).max(0.0)
}

/// Mean of numbers.
pub(crate) fn mean(numbers: &[f64]) -> f64 {
    numbers.iter().sum::<f64>() / numbers.len() as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::conjugate::{U1, number};

    /// U3: a loss of 100κ against 45 + 40κ, before any data and after two of three dates.
    #[test]
    fn a_normal_difference_has_its_worth_in_closed_form() {
        let u1 = U1::read();
        let (slope, cost) = (60.0, 45.0);
        let of_kappa = |dates: usize| {
            let after = u1.after_dates(&u1.proper(), &(0..dates).collect::<Vec<_>>());
            (after.mean[0], after.covariance().at(0, 0))
        };
        let ((_, at_three), (two, at_two)) = (of_kappa(3), of_kappa(2));
        let close = |found: f64, key: &str| {
            let expected = number(&format!("/U3/{key}"));
            assert!((found - expected).abs() < 1e-10, "{key}: {found}");
        };
        close(of_a_difference(slope - cost, slope), "prior/evpi");
        let told = |before: f64, after: f64| slope * (before - after).sqrt();
        close(of_a_difference(slope - cost, told(1.0, at_three)), "prior/evsi_of_dates_0_2_5");
        let mean = slope * two - cost;
        close(mean, "after_dates_0_2/mean_difference");
        close(of_a_difference(mean, slope * at_two.sqrt()), "after_dates_0_2/evpi");
        let worth = of_a_difference(mean, told(at_two, at_three));
        close(worth, "after_dates_0_2/evsi_of_date_5");
        // The same by what is told of κ, and by findings, with an action that no finding makes the best.
        let told = Matrix::of(1, |_, _| at_two - at_three);
        let (means, slopes) = ([100.0 * two, 45.0 + 40.0 * two], [vec![100.0], vec![40.0]]);
        close(of_a_measurement(&means, &slopes, &told), "after_dates_0_2/evsi_of_date_5");
        let (means, slopes) = ([means[0], means[1], 1e6], [vec![100.0], vec![40.0], vec![0.0]]);
        let by_findings = of_a_measurement(&means, &slopes, &told);
        assert!((by_findings - worth).abs() < 0.05 * worth, "{by_findings}");
    }

    /// Costs in two states of the world that are as likely: 3 and 9 against 5 and 5. Knowing the state saves (5 − 3)/2.
    #[test]
    fn to_know_everything_is_worth_the_mean_of_what_it_saves() {
        let worth = of_everything(&[vec![3.0, 9.0], vec![5.0, 5.0]]);
        assert!((worth - 1.0).abs() < 1e-15);
        // What changes no action is worth nothing.
        assert_eq!(of_everything(&[vec![3.0, 4.0], vec![5.0, 5.0]]), 0.0);
        assert_eq!(of_a_difference(3.0, 0.0), 0.0);
    }
}
