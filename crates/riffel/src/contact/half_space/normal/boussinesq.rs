//! Normal displacement of a half-space under pressure.

use num_complex::Complex64;

use super::convolution::Convolution;
use super::grid::ContactGrid;

/// Approach of the surfaces of both bodies to one another under pressures that are constant on
/// each element.
///
/// Boussinesq (1885): a point load F at the distance r moves the surfaces apart by F/(πE\*r), both
/// bodies together. Over a rectangle the integral is closed (Love 1929):
/// ∬ dξ dη/r = \[x ln(y + r) + y ln(x + r)\], differences over the four corners, seen from the place
/// of the displacement. Displacements are those at the centres of the elements.
///
/// Rows of elements may be inclined to one another, on a surface that is curved across: the displacement that a pressure
/// causes along its own normal counts with the cosine of the angle between both normals. Those along the surface are alike
/// in two bodies of one material.
pub(super) struct Boussinesq {
    convolution: Convolution,
    /// Displacement of an element under its own unit pressure \[m/Pa\].
    own: f64,
    /// Normal of each element, as cosine and sine of its inclination.
    normals: Vec<Complex64>,
    cosines: Vec<f64>,
}

impl Boussinesq {
    /// For the contact modulus E\* \[Pa\]; `inclination` is that of a row of elements \[rad\].
    pub(super) fn new(contact_modulus: f64, grid: &ContactGrid, inclination: impl Fn(usize) -> f64) -> Self {
        let (dx, dy) = (grid.dx(), grid.dy());
        let scale = (std::f64::consts::PI * contact_modulus).recip();
        let rows = (0..grid.rows()).map(|row| Complex64::cis(inclination(row)));
        let normals: Vec<Complex64> = rows.flat_map(|normal| std::iter::repeat_n(normal, grid.columns())).collect();
        Self {
            cosines: normals.iter().map(|normal| normal.re).collect(),
            normals,
            convolution: Convolution::new(grid.columns(), grid.rows(), |column, row| {
                scale * potential(column * dx, row * dy, dx, dy)
            }),
            own: scale * potential(0.0, 0.0, dx, dy),
        }
    }

    /// Displacements \[m\] under pressures \[Pa\]. Cost: two transforms of four times the grid.
    pub(super) fn displacements(&self, pressures: &[f64]) -> Vec<f64> {
        let forces = self.normals.iter().zip(pressures);
        let displacements = self.convolution.apply(forces.map(|(normal, p)| normal * p));
        let along = self.normals.iter().zip(displacements);
        along.map(|(normal, u)| normal.re * u.re + normal.im * u.im).collect()
    }

    /// Cosines of the inclinations of all elements.
    pub(super) fn cosines(&self) -> &[f64] {
        &self.cosines
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
        let influence = Boussinesq::new(1e11, &grid, |_| 0.0);
        let pressures: Vec<f64> = (0..88).map(|i| f64::from(i * 37 % 23)).collect();
        let displacements = influence.displacements(&pressures);
        for ((x, y), displacement) in grid.centres().zip(displacements) {
            let sum: f64 = grid
                .centres()
                .zip(&pressures)
                .map(|((from_x, from_y), pressure)| pressure * potential(x - from_x, y - from_y, 2e-3, 3e-3))
                .sum();
            let exact = sum / (std::f64::consts::PI * 1e11);
            assert_relative_eq!(displacement, exact, max_relative = 1e-13);
        }
    }

    /// A disc of radius R in a hole, both of one material and in plane strain, under p = √(ε² − θ²). Michell (1899): radial
    /// displacements under the pressure cos nθ open the gap by R/E\*·2n/(n² − 1), and under any pressure by
    /// −(R/πE\*) ∫ p (2 cos t ln(2 sin(t/2)) + ½) dt with the angle t between load and place. Elements long beside the circle have
    /// all of it but ½, up to a shift of the disc, A cos θ. Tolerance, of the displacement of the middle against the edge: arcs in
    /// the place of chords, t²/24, and elements, 1e-3.
    #[test]
    fn a_disc_in_a_hole() {
        const RADIUS: f64 = 0.01;
        const ROWS: usize = 200;
        for half_angle in [0.2, 0.4, 0.6_f64] {
            let step = 2.0 * half_angle / ROWS as f64;
            let grid = ContactGrid::new(8, ROWS, 100.0 * RADIUS, RADIUS * step).unwrap();
            let angle = |row: usize| (row as f64 + 0.5) * step - half_angle;
            let pressure = |angle: f64| (half_angle * half_angle - angle * angle).sqrt();
            let influence = Boussinesq::new(1.0, &grid, angle);
            let pressures: Vec<f64> = (0..8 * ROWS).map(|index| pressure(angle(index / 8))).collect();
            let elements = influence.displacements(&pressures);
            // Sixteen points in each element.
            let exact = |place: f64| {
                let points = (0..16 * ROWS).map(|index| {
                    let load = (index as f64 + 0.5) * step / 16.0 - half_angle;
                    let between = (place - load).abs();
                    let kernel = 2.0 * between.cos() * (2.0 * (0.5 * between).sin()).ln();
                    -kernel * pressure(load) * step / 16.0
                });
                RADIUS / std::f64::consts::PI * points.sum::<f64>()
            };
            let differences: Vec<[f64; 2]> =
                (0..ROWS).map(|row| [elements[8 * row + 4] - exact(angle(row)), angle(row).cos()]).collect();
            let shift = differences[ROWS / 2][0] / differences[ROWS / 2][1];
            let off =
                differences.iter().map(|[difference, cosine]| (difference - shift * cosine).abs()).fold(0.0, f64::max);
            let range = exact(0.0) - exact(half_angle) / half_angle.cos();
            assert!(off < (half_angle * half_angle / 24.0 + 1e-3) * range.abs(), "{half_angle}: {off} of {range}");
        }
    }
}
