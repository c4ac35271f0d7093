//! Normal displacement of a half-space under pressure.

use super::convolution::Convolution;
use super::grid::ContactGrid;

/// Approach of the surfaces of both bodies to one another under pressures that are constant on
/// each element.
///
/// Boussinesq (1885): a point load F at the distance r moves the surfaces apart by F/(πE\*r), both
/// bodies together. Over a rectangle the integral is closed (Love 1929):
/// ∬ dξ dη/r = \[x ln(y + r) + y ln(x + r)\], differences over the four corners, seen from the place
/// of the displacement. Displacements are those at the centres of the elements.
pub(super) struct Boussinesq {
    convolution: Convolution,
    /// Displacement of an element under its own unit pressure \[m/Pa\].
    own: f64,
}

impl Boussinesq {
    /// For the contact modulus E\* \[Pa\].
    pub(super) fn new(contact_modulus: f64, grid: &ContactGrid) -> Self {
        let (dx, dy) = (grid.dx(), grid.dy());
        let scale = (std::f64::consts::PI * contact_modulus).recip();
        Self {
            convolution: Convolution::new(grid.columns(), grid.rows(), |column, row| {
                scale * potential(column * dx, row * dy, dx, dy)
            }),
            own: scale * potential(0.0, 0.0, dx, dy),
        }
    }

    /// Displacements \[m\] under pressures \[Pa\]. Cost: two transforms of four times the grid.
    pub(super) fn displacements(&self, pressures: &[f64]) -> Vec<f64> {
        self.convolution.apply(pressures)
    }

    /// Displacement of an element under its own unit pressure \[m/Pa\].
    pub(super) fn own(&self) -> f64 {
        self.own
    }
}

/// ∬ dξ dη/r \[m\] over a rectangle of the sides dx and dy whose centre is (x, y) away.
fn potential(x: f64, y: f64, dx: f64, dy: f64) -> f64 {
    let mut sum = 0.0;
    for (x, sign_x) in [(x + 0.5 * dx, 1.0), (x - 0.5 * dx, -1.0)] {
        for (y, sign_y) in [(y + 0.5 * dy, 1.0), (y - 0.5 * dy, -1.0)] {
            // asinh(y/|x|) is ln(y + r) less ln|x|, which cancels between the corners; it has no
            // cancellation for y < 0. No corner has x = 0 or y = 0, since distances are whole steps.
            sum += sign_x * sign_y * (x * (y / x.abs()).asinh() + y * (x / y.abs()).asinh());
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// In the middle of a square of side s: 4 s ln(1 + √2) (Johnson 1985, equation 3.25 at its centre).
    #[test]
    fn own_influence_of_a_square() {
        let exact = 4.0 * 3e-3 * (1.0 + 2.0_f64.sqrt()).ln();
        assert_relative_eq!(potential(0.0, 0.0, 3e-3, 3e-3), exact, max_relative = 1e-14);
    }

    /// By quadrature, midpoint rule on 200 × 200 points, at distances of two elements and more: error
    /// (h²/24)∇²(1/r) ~ 1e-6. Far away a point load: 1/r, next term (dx/r)²/24.
    #[test]
    fn potential_is_the_integral_of_a_point_load() {
        let (dx, dy) = (2.0, 1.0);
        for (x, y) in [(4.0, 0.0), (0.0, 2.0), (-4.0, 3.0), (6.0, -2.0)] {
            const POINTS: usize = 200;
            let offset = |index: usize| (index as f64 + 0.5) / POINTS as f64 - 0.5;
            let mut sum = 0.0;
            for i in 0..POINTS {
                for j in 0..POINTS {
                    sum += (x + offset(i) * dx).hypot(y + offset(j) * dy).recip();
                }
            }
            let quadrature = sum * dx * dy / (POINTS * POINTS) as f64;
            assert_relative_eq!(potential(x, y, dx, dy), quadrature, max_relative = 1e-5);
        }
        let far = potential(2000.0, 1000.0, dx, dy) * 2000.0_f64.hypot(1000.0) / (dx * dy);
        assert_relative_eq!(far, 1.0, max_relative = 1e-6);
    }

    /// The convolution is the sum over all elements. 1e-13: rounding.
    #[test]
    fn convolution_is_the_sum() {
        let grid = ContactGrid::new(11, 8, 2e-3, 3e-3).unwrap();
        let influence = Boussinesq::new(1e11, &grid);
        let pressures: Vec<f64> = (0..88).map(|i| f64::from(i * 37 % 23)).collect();
        let displacements = influence.displacements(&pressures);
        for ((x, y), displacement) in grid.centres().zip(displacements) {
            let sum: f64 = grid
                .centres()
                .zip(&pressures)
                .map(|((from_x, from_y), pressure)| {
                    pressure * potential(x - from_x, y - from_y, 2e-3, 3e-3)
                })
                .sum();
            let exact = sum / (std::f64::consts::PI * 1e11);
            assert_relative_eq!(displacement, exact, max_relative = 1e-13);
        }
    }
}
