//! What becomes of lines with little coherence.

use riffel::Complex64;
use riffel_keys::{Message, fixed, number, say};

/// Coherence γ² from which a line is taken as it is; the usual limit of hammer tests.
const GOOD: f64 = 0.8;
/// Lines to either side that a weighted mean takes in \[octaves\].
const OCTAVES: f64 = 1.0 / 24.0;
/// Coherence above which a weight grows no more: what is left is no noise of the test.
const BEST: f64 = 0.999;

/// Replace each receptance of a coherence below 0.8 by the mean of the lines within 1/24 octave, weighted by γ²/(1 − γ²).
///
/// The variance of a frequency response estimated from n blows is |H|²(1 − γ²)/(2nγ²) (Bendat and Piersol, *Random
/// Data*, for the estimator H₁), so that the weights are those of least variance. A mean of passive receptances is passive.
/// It flattens what is narrower than 1/24 octave, so lines of good coherence are left as they are.
pub(super) fn smooth(angular: &[f64], receptances: &mut [Complex64], coherence: &[f64]) -> Option<Message> {
    let measured = receptances.to_vec();
    let widest = OCTAVES.exp2();
    let mut poor = Vec::new();
    for (index, &w) in angular.iter().enumerate() {
        if coherence[index] >= GOOD {
            continue;
        }
        poor.push(w / std::f64::consts::TAU);
        let first = angular.partition_point(|&other| other < w / widest);
        let end = angular.partition_point(|&other| other <= w * widest);
        let weight = |line: usize| {
            let coherence = coherence[line].min(BEST);
            coherence / (1.0 - coherence)
        };
        let sum: f64 = (first..end).map(weight).sum();
        if sum > 0.0 {
            let weighted = (first..end).map(|line| weight(line) * measured[line]);
            receptances[index] = weighted.sum::<Complex64>() / sum;
        }
    }
    let (count, points) = (poor.len(), angular.len());
    let (first, last) = (poor.first()?, poor.last()?);
    Some(say!(poor_coherence, good = number(GOOD), count, points, first = fixed(*first, 0), last = fixed(*last, 0)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// γ² = 0.5 weighs 1, 0.9 weighs 9: (2 + 9·4 + 9·6)/19.
    #[test]
    fn a_poor_line_is_a_weighted_mean() {
        let angular = [100.0, 101.0, 102.0, 150.0];
        let mut receptances = [4.0, 2.0, 6.0, 1.0].map(Complex64::from);
        let remark = smooth(&angular, &mut receptances, &[0.9, 0.5, 0.9, 0.1]).unwrap();
        assert!((receptances[1].re - 92.0 / 19.0).abs() < 1e-12);
        // Good lines stay, and one that is alone has no other to go by.
        assert_eq!([0, 2, 3].map(|line| receptances[line].re), [4.0, 6.0, 1.0]);
        let words = remark.to_string();
        assert!(words.contains("below 0.8 at 2 of 4 frequencies, between 16 and 24 Hz"), "{words}");
    }

    #[test]
    fn good_coherence_changes_nothing() {
        let mut receptances = [4.0, 2.0].map(Complex64::from);
        assert_eq!(smooth(&[100.0, 101.0], &mut receptances, &[0.8, 1.0]), None);
        assert_eq!(receptances, [4.0, 2.0].map(Complex64::from));
    }
}
