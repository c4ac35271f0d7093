//! When something first is so.

use riffel_numerics::bisection::bisection;

/// Axle passages from `least` on after which something is so, which then stays so; `None` if it is not up to `most`.
///
/// Method: doubling, then bisection to rounding.
pub(super) fn passages_until(least: f64, most: f64, is_so: impl Fn(f64) -> bool) -> Option<f64> {
    let (mut low, mut high) = (least, least);
    while !is_so(high) {
        (low, high) = (high, 2.0 * high.max(0.5));
        if high > most {
            return None;
        }
    }
    let [_, first] = bisection([low, high], 0.0, is_so);
    Some(first)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_when_it_begins() {
        for begins in [0.0, 0.3, 1.0, 7.5, 1e9] {
            let got = passages_until(0.0, 1e15, |passages| passages >= begins);
            assert!((got.unwrap() - begins).abs() <= 1e-15 * begins, "{begins}: {got:?}");
        }
        assert_eq!(passages_until(4.0, 1e15, |_| true), Some(4.0));
        assert_eq!(passages_until(0.0, 1e15, |_| false), None);
        assert_eq!(passages_until(0.0, f64::MAX, |_| false), None);
    }
}
