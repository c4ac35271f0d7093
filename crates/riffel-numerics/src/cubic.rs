//! Cubics between knots: coefficients in closed form, to rounding.

/// Coefficients, the lowest power first, of Hermite's cubic in t between 0 and 1: the values are those of its ends, the slopes d/dt
/// there. Error on a smooth function with exact slopes: h⁴/384 of its fourth derivative. Source: de Boor (1978), *A Practical
/// Guide to Splines*, chapter IV.
#[inline]
pub fn hermite([from, to]: [f64; 2], [begin, end]: [f64; 2]) -> [f64; 4] {
    [from, begin, 3.0 * (to - from) - 2.0 * begin - end, 2.0 * (from - to) + begin + end]
}

/// Value of a cubic of some coefficients, the lowest power first, at t.
#[inline]
pub fn cubic_at([a, b, c, d]: [f64; 4], t: f64) -> f64 {
    a + t * (b + t * (c + t * d))
}

/// Slope of a cubic of some coefficients, the lowest power first, at t.
pub fn cubic_slope([_, b, c, d]: [f64; 4], t: f64) -> f64 {
    b + t * (2.0 * c + 3.0 * d * t)
}

/// Value of the cubic through four equidistant values (Lagrange), a share of the way from the second to the third.
pub fn cubic([a, b, c, d]: [f64; 4], share: f64) -> f64 {
    let third = (d - a) / 6.0 + (b - c) / 2.0;
    let second = (a + c) / 2.0 - b;
    let first = c - b / 2.0 - a / 3.0 - d / 6.0;
    cubic_at([b, first, second, third], share)
}
