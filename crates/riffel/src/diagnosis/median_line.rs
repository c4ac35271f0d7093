//! The straight line with the median of all slopes (Theil 1950, Sen 1968), which single points do not bend.

/// Variance of the line through some points at x, over the variance of one of them: that of least squares,
/// times π/2 for a median.
pub(super) fn extrapolation(points: &[(f64, f64)], x: f64) -> f64 {
    let count = points.len() as f64;
    let mean = points.iter().map(|point| point.0).sum::<f64>() / count;
    let squares: f64 = points.iter().map(|point| (point.0 - mean).powi(2)).sum();
    std::f64::consts::FRAC_PI_2 * (count.recip() + (x - mean).powi(2) / squares)
}

/// The line of Theil and Sen through some points, at x; None for less than four points.
pub(super) fn median_line(points: &[(f64, f64)], x: f64) -> Option<f64> {
    if points.len() < 4 {
        return None;
    }
    let mut slopes: Vec<f64> = points
        .iter()
        .enumerate()
        .flat_map(|(index, a)| points[index + 1..].iter().map(move |b| (b.1 - a.1) / (b.0 - a.0)))
        .collect();
    let slope = median(&mut slopes);
    let mut levels: Vec<f64> = points.iter().map(|point| point.1 + slope * (x - point.0)).collect();
    Some(median(&mut levels))
}

/// Found without sorting: a line has hundreds of slopes, and a spectrum hundreds of lines.
fn median(values: &mut [f64]) -> f64 {
    let middle = values.len() / 2;
    let even = values.len().is_multiple_of(2);
    let (below, upper, _) = values.select_nth_unstable_by(middle, f64::total_cmp);
    if even {
        let lower = below.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        0.5 * (lower + *upper)
    } else {
        *upper
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A third of the points may lie anywhere: the line is that of the others.
    #[test]
    fn outliers_do_not_bend_it() {
        let line = |x: f64| 2.0 - 3.0 * x;
        let points: Vec<(f64, f64)> = (0..12)
            .map(|index| {
                let x = f64::from(index);
                (x, if index % 5 == 2 { 1e3 } else { line(x) })
            })
            .collect();
        assert!((median_line(&points, 20.0).unwrap() - line(20.0)).abs() < 1e-9);
        assert_eq!(median_line(&points[..3], 0.0), None);
    }

    /// Least squares through n points has the variance σ²/n in their middle; at the end of an even row of
    /// n, (4n − 2)/(n (n + 1)).
    #[test]
    fn it_is_known_best_in_the_middle() {
        let points: Vec<(f64, f64)> = (0..9).map(|x| (f64::from(x), 0.0)).collect();
        let of_median = std::f64::consts::FRAC_PI_2;
        assert!((extrapolation(&points, 4.0) / (of_median / 9.0) - 1.0).abs() < 1e-12);
        let end = of_median * 34.0 / 90.0;
        assert!((extrapolation(&points, 8.0) / end - 1.0).abs() < 1e-12);
    }
}
