//! Natural cubic splines.

/// Slopes at the knots of the natural cubic spline through values over an increasing parameter.
///
/// Method: the tridiagonal system of the second derivatives by elimination. Source: de Boor (1978), *A Practical Guide to
/// Splines*, chapter IV.
pub(super) fn slopes(parameter: &[f64], values: &[f64]) -> Vec<f64> {
    let last = parameter.len() - 1;
    let width = |i: usize| parameter[i + 1] - parameter[i];
    let secant = |i: usize| (values[i + 1] - values[i]) / width(i);
    // Second derivatives, zero at both ends.
    let (mut upper, mut right) = (vec![0.0; last + 1], vec![0.0; last + 1]);
    for i in 1..last {
        let diagonal = 2.0 * (width(i - 1) + width(i)) - width(i - 1) * upper[i - 1];
        upper[i] = width(i) / diagonal;
        right[i] = (6.0 * (secant(i) - secant(i - 1)) - width(i - 1) * right[i - 1]) / diagonal;
    }
    let mut bend = vec![0.0; last + 1];
    for i in (1..last).rev() {
        bend[i] = right[i] - upper[i] * bend[i + 1];
    }
    let slope = |i: usize| secant(i) - width(i) * (2.0 * bend[i] + bend[i + 1]) / 6.0;
    let mut slopes: Vec<f64> = (0..last).map(slope).collect();
    slopes.push(secant(last - 1) + width(last - 1) * (bend[last - 1] + 2.0 * bend[last]) / 6.0);
    slopes
}

#[cfg(test)]
mod tests {
    /// Away from the ends, where the curvature of a natural spline vanishes, the error of a slope falls with h⁴.
    #[test]
    fn slopes_are_those_of_a_sine() {
        let x: Vec<f64> = (0..=200).map(|i| 0.05 * f64::from(i)).collect();
        let y: Vec<f64> = x.iter().map(|x| x.sin()).collect();
        let slopes = super::slopes(&x, &y);
        for i in 40..160 {
            assert!((slopes[i] - x[i].cos()).abs() < 1e-7);
        }
    }
}
