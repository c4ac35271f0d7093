//! Kalker's creep coefficients of an elliptic contact.

use riffel_numerics::cubic::{cubic_at, hermite};

use super::kalker_table::{COEFFICIENTS, POISSON_RATIOS, ROW_OF_THE_CIRCLE, ROWS_TO_A_DECADE};
use crate::Error;

/// Kalker's creep coefficients of the linear theory of rolling contact \[-\].
///
/// With the longitudinal creepage ξ, the lateral creepage η \[-\] and the spin φ \[1/m\], all small,
/// the creep forces on an ellipse of semi-axes a along and b across the rolling direction are
///
/// ```text
/// |F_x| = G ab C₁₁ ξ
/// |F_y| = G ab (C₂₂ η + √(ab) C₂₃ φ)
/// |M_z| = G ab (−√(ab) C₂₃ η + ab C₃₃ φ)
/// ```
///
/// Source: linear theory of Kalker (1967, thesis Delft; 1990, *Three-Dimensional Elastic Bodies in
/// Rolling Contact*, section 2.2.3 and table E.3), solved anew and tabulated for 25 axis ratios and
/// five Poisson's ratios. Between them (1 − ν) C is interpolated by the quartic in ν, and ln C by
/// cubic Hermite polynomials in ln(a/b), with a continuous slope.
///
/// Error against the linear theory: 0.03 % for 0.01 ≤ a/b ≤ 100, 0.1 % beyond. The three printed
/// digits of table E.3 (C₁₁, C₂₂, C₂₃) differ by at most 1.2 %, and by more than 0.8 % only at
/// a/b = 0.1 and 10; its quadratic interpolation of 1/C in ν would do for these three, but is 11 %
/// wrong for C₃₃ at a/b = 10.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KalkerCoefficients {
    /// C₁₁ \[-\], longitudinal force to longitudinal creepage.
    pub c11: f64,
    /// C₂₂ \[-\], lateral force to lateral creepage.
    pub c22: f64,
    /// C₂₃ = −C₃₂ \[-\], lateral force to spin.
    pub c23: f64,
    /// C₃₃ \[-\], spin moment to spin.
    pub c33: f64,
}

impl KalkerCoefficients {
    /// Longest ellipse; a/b may lie between its reciprocal and this.
    const LARGEST_AXIS_RATIO: f64 = 316.0;

    /// The coefficients for Poisson's ratio ν \[-\] of both bodies and the axis ratio a/b \[-\], the
    /// semi-axis along the rolling direction over the one across it.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless 0 ≤ ν ≤ 0.5 and 1/316 ≤ a/b ≤ 316. Every ellipse of an exact
    /// [`HertzContact`](super::HertzContact) is within. Beyond, the asymptotes of Kalker are up to
    /// 2 % off, that of C₃₃ for a ≫ b has no source, and none of them is used.
    pub fn new(poisson_ratio: f64, axis_ratio: f64) -> Result<Self, Error> {
        if !(0.0..=0.5).contains(&poisson_ratio) {
            return Err(Error::OutOfRange {
                quantity: "Poisson's ratio",
                value: poisson_ratio,
                unit: "",
                rule: "must lie between 0 and 0.5 for Kalker's coefficients",
            });
        }
        let largest = Self::LARGEST_AXIS_RATIO;
        if !(1.0 / largest..=largest).contains(&axis_ratio) {
            return Err(Error::OutOfRange {
                quantity: "axis ratio of the contact patch",
                value: axis_ratio,
                unit: "",
                rule: "must lie between 1/316 and 316, where Kalker's coefficients are tabulated",
            });
        }
        let place = Place::of(axis_ratio);
        let weights = poisson_weights(poisson_ratio);
        let [c11, c22, c23, c33] = std::array::from_fn(|coefficient| {
            weights.iter().enumerate().map(|(column, weight)| weight * place.interpolate(coefficient, column)).sum()
        });
        Ok(Self { c11, c22, c23, c33 })
    }
}

/// Weights of the columns by which (1 − ν) C is the quartic of Lagrange in ν.
fn poisson_weights(poisson_ratio: f64) -> [f64; POISSON_RATIOS.len()] {
    POISSON_RATIOS.map(|node| {
        let lagrange: f64 = POISSON_RATIOS
            .iter()
            .filter(|&&other| other != node)
            .map(|other| (poisson_ratio - other) / (node - other))
            .product();
        lagrange * (1.0 - node) / (1.0 - poisson_ratio)
    })
}

/// Place of an axis ratio among the rows of the table.
struct Place {
    /// Row below.
    row: usize,
    /// Fraction of the way to the next row.
    fraction: f64,
}

impl Place {
    /// Two rows are kept to either side for the slopes.
    fn of(axis_ratio: f64) -> Self {
        let position = axis_ratio.log10() * ROWS_TO_A_DECADE as f64 + ROW_OF_THE_CIRCLE as f64;
        let row = (position.floor() as usize).clamp(2, COEFFICIENTS.len() - 4);
        Self { row, fraction: position - row as f64 }
    }

    /// One coefficient of one column: the Hermite cubic of ln C, with slopes by differences of
    /// fourth order.
    fn interpolate(&self, coefficient: usize, column: usize) -> f64 {
        let value = |row: usize| COEFFICIENTS[row][coefficient][column].ln();
        let slope = |row: usize| (value(row - 2) - 8.0 * value(row - 1) + 8.0 * value(row + 1) - value(row + 2)) / 12.0;
        let ends = [self.row, self.row + 1];
        cubic_at(hermite(ends.map(value), ends.map(slope)), self.fraction).exp()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use proptest::prelude::*;
    use std::f64::consts::PI;

    fn all(poisson_ratio: f64, axis_ratio: f64) -> [f64; 4] {
        let KalkerCoefficients { c11, c22, c23, c33 } = KalkerCoefficients::new(poisson_ratio, axis_ratio).unwrap();
        [c11, c22, c23, c33]
    }

    /// Linear theory with 36 degrees, between the columns and rows of the table.
    #[test]
    fn between_the_rows_the_error_is_that_stated() {
        for (poisson_ratio, axis_ratio, expected, tolerance) in BETWEEN {
            for (value, exact) in all(poisson_ratio, axis_ratio).into_iter().zip(expected) {
                assert_relative_eq!(value, exact, max_relative = tolerance);
            }
        }
    }

    /// Kalker's asymptotes as CONTACT prints them, at the slender end a ≪ b, where they converge
    /// like g ln g: C₁₁ = π²/4(1 − ν), C₂₂ = π²/4, C₂₃ = π√g/3(1 − ν) (1 + ν(ln(16/g) − 5)). C₃₃ =
    /// π²/16(1 − ν)g was not found in print; the table tends to it.
    #[test]
    fn wide_limit() {
        let g = 1.0 / 300.0_f64;
        for poisson_ratio in [0.0, 0.2, 0.3, 0.5] {
            let compressed = 1.0 - poisson_ratio;
            let limits = [
                PI * PI / (4.0 * compressed),
                PI * PI / 4.0,
                PI * g.sqrt() / (3.0 * compressed) * (1.0 + poisson_ratio * ((16.0 / g).ln() - 5.0)),
                PI * PI / (16.0 * compressed * g),
            ];
            for (value, limit) in all(poisson_ratio, g).into_iter().zip(limits) {
                assert_relative_eq!(value, limit, max_relative = 2e-3);
            }
        }
    }

    /// The asymptotes for a ≫ b, an expansion in 1/L, L = ln(16/g²): C₂₃ = 2π/(3g^{3/2}((1 − ν)L − 2 + 4ν))
    /// has an error of the order of g, C₁₁ of (3 − ln 4)²/L².
    #[test]
    fn long_limit() {
        let g = 1.0 / 300.0_f64;
        let logarithm = (16.0 / (g * g)).ln();
        for poisson_ratio in [0.0, 0.2, 0.3, 0.5] {
            let [c11, _, c23, _] = all(poisson_ratio, 1.0 / g);
            let spin = (1.0 - poisson_ratio) * logarithm - 2.0 + 4.0 * poisson_ratio;
            assert_relative_eq!(c23, 2.0 * PI / (3.0 * g.powf(1.5) * spin), max_relative = 1e-3);
            let reduced = logarithm - 2.0 * poisson_ratio;
            let limit = 2.0 * PI / (reduced * g) * (1.0 + (3.0 - 4.0_f64.ln()) / reduced);
            assert_relative_eq!(c11, limit, max_relative = 2.7 / (reduced * reduced));
        }
    }

    #[test]
    fn contacts_outside_the_table_are_refused() {
        for (poisson_ratio, axis_ratio) in
            [(-0.1, 1.0), (0.51, 1.0), (f64::NAN, 1.0), (0.3, 0.0), (0.3, -1.0), (0.3, 320.0), (0.3, f64::NAN)]
        {
            assert!(KalkerCoefficients::new(poisson_ratio, axis_ratio).is_err());
        }
        for end in [1.0 / 316.0, 316.0] {
            assert!(KalkerCoefficients::new(0.3, end).is_ok());
        }
    }

    proptest! {
        /// Value and slope are continuous at every row: across 2e-6 in ln(a/b) the second
        /// difference of ln C is far below the first.
        #[test]
        fn smooth_at_the_rows(row in 3..21_i32, poisson_ratio in 0.0..0.5f64) {
            let at = |offset: f64| {
                all(poisson_ratio, 10_f64.powf((f64::from(row) - 12.0) / 4.0) * (1.0 + offset))
            };
            let (below, middle, above) = (at(-1e-5), at(0.0), at(1e-5));
            for i in 0..4 {
                let second = (below[i] - 2.0 * middle[i] + above[i]) / middle[i];
                prop_assert!(second.abs() < 1e-9, "{second}");
            }
        }

        /// At ν = 0 the tractions do not couple: C₁₁ = C₂₂, and both grow with ν and a/b. Of a very slender ellipse C₂₂ (a ≪ b)
        /// or C₁₁ (a ≫ b) hardly depends on ν: there growth is held to the error of the interpolation, 3e-4.
        #[test]
        fn order_of_the_coefficients(axis_ratio in 0.01..100.0f64, poisson_ratio in 0.01..0.5f64) {
            let [c11, c22, ..] = all(0.0, axis_ratio);
            assert_relative_eq!(c11, c22, max_relative = 1e-12);
            let [with_c11, with_c22, ..] = all(poisson_ratio, axis_ratio);
            let is_slender = !(0.1..=10.0).contains(&axis_ratio);
            let least = if is_slender { 1.0 - 3e-4 } else { 1.0 };
            prop_assert!(with_c11 > least * c11 && with_c22 > least * c22);
            let [_, longer_c22, longer_c23, longer_c33] = all(poisson_ratio, 1.01 * axis_ratio);
            let [_, c22, c23, c33] = all(poisson_ratio, axis_ratio);
            prop_assert!(longer_c22 > c22 && longer_c23 > c23 && longer_c33 < c33);
        }
    }

    /// ν, a/b, the four coefficients, and the relative error allowed.
    const BETWEEN: [(f64, f64, [f64; 4], f64); 6] = [
        (0.3, 0.0133352, [3.52479, 2.46941, 0.281381, 66.0471], 3e-4),
        (0.28, 0.133352, [3.46349, 2.56181, 0.540298, 6.51883], 3e-4),
        (0.44, 0.421697, [4.45282, 2.98977, 0.953568, 2.52152], 3e-4),
        (0.3, 1.5874, [4.87142, 4.50569, 2.18014, 0.889084], 3e-4),
        (0.06, 13.3352, [13.3766, 13.6982, 17.7843, 0.731586], 3e-4),
        (0.44, 237.137, [132.673, 194.51, 1028.33, 0.142254], 1e-3),
    ];
}
