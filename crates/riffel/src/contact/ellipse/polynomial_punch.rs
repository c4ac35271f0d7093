//! Punches whose face is a polynomial along the rail, pressed on an elliptic patch.

use std::f64::consts::PI;

use riffel_numerics::matrix::Matrix;

/// Most terms of a wave e^{ikx} over a patch: enough up to ka = 55.
pub(in crate::contact) const TERMS: usize = 72;

/// What presses an ellipse into the displacements P_n(x/a), the Legendre polynomials, of which e^{ikx} is the sum (2n + 1) iⁿ j_n(ka) P_n.
///
/// On an ellipse each is pressed by a polynomial of the same degree over ζ = √(1 − ρ²) alone, where x/a = ρ cos φ and y/b = ρ sin φ,
///
/// ```text
/// p ∝ (1/ζ) Σ c_m cos mφ P_n^m(ζ)/P_n^m(0),   m = n, n − 2, … ≥ 0,   I_n c = 1
/// (I_n)_{mm'} = ∫ cos mψ cos m'ψ / √(b² cos²ψ/a² + sin²ψ) dψ over a turn
/// ```
///
/// with one factor for all n. Since cos mφ of the rim is the Chebyshev polynomial T_m(x/a), so is the numerator there.
///
/// Source: derived in the book, after L. A. Galin's theorem of polynomial punches. Error: 1e-12 up to n = 72.
pub(in crate::contact) struct PolynomialPunch {
    /// Integrals over a turn of cos 2jψ/√(b² cos²ψ/a² + sin²ψ).
    harmonics: Vec<f64>,
}

impl PolynomialPunch {
    /// On an ellipse of the aspect ratio a/b.
    pub(in crate::contact) fn new(aspect_ratio: f64) -> Self {
        Self { harmonics: harmonics(aspect_ratio.recip()) }
    }

    /// c_m of the degree n with their orders m, from the highest down.
    pub(in crate::contact) fn pressure(&self, n: usize) -> Vec<(usize, f64)> {
        let orders: Vec<usize> = (0..=n).rev().step_by(2).collect();
        let (size, matrix) = (orders.len(), self.matrix(&orders));
        // I_n is positive.
        let lower = matrix.cholesky();
        let solved = lower.map(|lower| lower.transposed().backward(&lower.forward(vec![1.0; size])));
        let values = solved.unwrap_or_else(|| vec![f64::NAN; size]);
        orders.into_iter().zip(values).collect()
    }

    /// s_n = (2n + 1) 1ᵀ I_n⁻¹ 1 from n = 1 to [`TERMS`], the resistance to the displacement P_n.
    ///
    /// Method: with rising orders I_n is a corner of all later ones, and one factor I = LLᵀ serves all degrees that are even, or odd: of
    /// Ly = 1 the sum of y² as far as n.
    pub(in crate::contact) fn stiffnesses(&self) -> Vec<f64> {
        let [even, odd] = [0, 1].map(|first| {
            let orders: Vec<usize> = (first..=TERMS).step_by(2).collect();
            let ones = vec![1.0; orders.len()];
            let lower = self.matrix(&orders).cholesky();
            let solved = lower.map_or_else(|| vec![f64::NAN; orders.len()], |lower| lower.forward(ones));
            let mut sum = 0.0;
            let stiffness = |(n, y): (usize, f64)| {
                sum += y * y;
                (2 * n + 1) as f64 * sum
            };
            orders.into_iter().zip(solved).map(stiffness).collect::<Vec<f64>>()
        });
        (1..=TERMS).map(|n| if n % 2 == 0 { even[n / 2] } else { odd[n / 2] }).collect()
    }

    /// I_n of some orders.
    fn matrix(&self, orders: &[usize]) -> Matrix {
        Matrix::of(orders.len(), |row, column| {
            let (m, other) = (orders[row], orders[column]);
            0.5 * (self.harmonics[m.abs_diff(other) / 2] + self.harmonics[usize::midpoint(m, other)])
        })
    }
}

/// Integrals over a turn of cos 2jψ/√(q² cos²ψ + sin²ψ), j = 0 … [`TERMS`], by the trapezoidal rule: it converges as e^{−2qM}.
fn harmonics(q: f64) -> Vec<f64> {
    let shorter = q.min(q.recip());
    let points = 4 * TERMS + (40.0 / shorter).min(4096.0) as usize;
    let step = PI / points as f64;
    // Half a turn is the other half.
    let weights = (0..points).map(|index| {
        let (sine, cosine) = (step * index as f64).sin_cos();
        2.0 * step / (q * cosine).hypot(sine)
    });
    let weights: Vec<f64> = weights.collect();
    // The angle 2jψ, whole turns taken off in integers.
    let cosines: Vec<f64> = (0..points).map(|index| (2.0 * step * index as f64).cos()).collect();
    let of = |j: usize| -> f64 {
        let terms = weights.iter().enumerate();
        let terms = terms.map(|(index, weight)| weight * cosines[j * index % points]);
        terms.sum()
    };
    (0..=TERMS).map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Around a circle all orders have one weight, whose integral over a turn is that of two turns for the mean.
    #[test]
    fn a_circle_is_pressed_evenly() {
        let circle = PolynomialPunch::new(1.0);
        for n in 1..6 {
            for (m, c) in circle.pressure(n) {
                let turns = if m == 0 { 2.0 } else { 1.0 };
                assert!((c * turns * PI - 1.0).abs() < 1e-12, "{n} {m}: {c}");
            }
        }
    }
}
