//! A receptance read from a table over frequency.

use num_complex::Complex64;
use thiserror::Error;

use super::Receptance;

/// Number of nodes of the interpolating polynomial.
const NODES: usize = 6;
const FEWEST_CELLS: usize = 64;
const MOST_CELLS: usize = 1 << 16;

/// Copy of a receptance that depends on frequency alone, interpolated to a stated accuracy.
///
/// Method: equal cells in √ω (which follow the spacing of track resonances better than ω and cost
/// one square root to find, not a logarithm); in each cell the polynomial of degree 5 through the
/// six nearest nodes, error ∝ h⁶. The number of cells is doubled until the relative error at two
/// points inside every cell is within the tolerance. Cost: six complex coefficients a cell (96
/// bytes), one square root and five multiply-adds for a value; 1e-9 over two decades of a damped
/// two-layer track takes some thousand cells.
#[derive(Debug, Clone, PartialEq)]
pub struct Tabulated {
    lowest_root: f64,
    cells_per_root: f64,
    /// Coefficients of each cell in t ∈ [0, 1], lowest power first.
    cells: Vec<[Complex64; NODES]>,
}

/// A receptance too sharp for a table of sensible size.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[error(
    "a table of {MOST_CELLS} cells leaves a relative error of {error:.1e}, above {tolerance:.1e}"
)]
pub struct TabulationError {
    /// Largest relative error of the finest table.
    pub error: f64,
    /// Tolerance asked for.
    pub tolerance: f64,
}

impl Tabulated {
    /// Tabulate `source`, at rest, over the angular frequencies `lowest..=highest` \[rad/s\] to the
    /// relative `tolerance`.
    ///
    /// # Errors
    /// [`TabulationError`] where a resonance is too sharp for the largest table.
    pub fn new(
        source: &dyn Receptance,
        lowest: f64,
        highest: f64,
        tolerance: f64,
    ) -> Result<Self, TabulationError> {
        let mut cells = FEWEST_CELLS;
        loop {
            let table = Self::with_cells(source, lowest, highest, cells);
            let error = table.largest_error(source);
            if error <= tolerance {
                return Ok(table);
            }
            if cells == MOST_CELLS {
                return Err(TabulationError { error, tolerance });
            }
            cells *= 2;
        }
    }

    /// Number of cells.
    pub fn cells(&self) -> usize {
        self.cells.len()
    }

    fn with_cells(source: &dyn Receptance, lowest: f64, highest: f64, cells: usize) -> Self {
        let lowest_root = lowest.sqrt();
        let step = (highest.sqrt() - lowest_root) / cells as f64;
        let value = |node: usize| {
            let root = lowest_root + step * node as f64;
            source.receptance(root * root, 0.0)
        };
        let values: Vec<Complex64> = (0..=cells).map(value).collect();
        let cells = (0..cells)
            .map(|cell| {
                // The six nodes nearest the cell, moved inward at both ends.
                let first = cell.saturating_sub(NODES / 2 - 1).min(values.len() - NODES);
                let nodes = std::array::from_fn(|j| values[first + j]);
                shifted(newton_coefficients(nodes), (cell - first) as f64)
            })
            .collect();
        Self {
            lowest_root,
            cells_per_root: 1.0 / step,
            cells,
        }
    }

    /// Largest relative error at 0.29 and 0.71 of every cell, where the error of the polynomial is
    /// not near one of its zeros.
    fn largest_error(&self, source: &dyn Receptance) -> f64 {
        (0..self.cells.len())
            .flat_map(|cell| [cell as f64 + 0.29, cell as f64 + 0.71])
            .map(|position| {
                let root = self.lowest_root + position / self.cells_per_root;
                let w = root * root;
                let exact = source.receptance(w, 0.0);
                (self.receptance(w, 0.0) - exact).norm() / exact.norm()
            })
            .fold(0.0, f64::max)
    }
}

/// Power coefficients in x of the polynomial through values at x = 0, 1, …, 5: Newton's forward
/// differences, expanded from the highest by Horner's rule.
fn newton_coefficients(values: [Complex64; NODES]) -> [Complex64; NODES] {
    let mut differences = values;
    for order in 1..NODES {
        for j in (order..NODES).rev() {
            differences[j] = (differences[j] - differences[j - 1]) / order as f64;
        }
    }
    let mut powers = [Complex64::ZERO; NODES];
    for node in (0..NODES).rev() {
        // powers ← powers · (x − node) + differences[node]
        for power in (1..NODES).rev() {
            powers[power] = powers[power - 1] - powers[power] * node as f64;
        }
        powers[0] = differences[node] - powers[0] * node as f64;
    }
    powers
}

/// Power coefficients about another origin: p(x + origin), by repeated synthetic division.
fn shifted(mut powers: [Complex64; NODES], origin: f64) -> [Complex64; NODES] {
    for start in 0..NODES {
        for power in (start..NODES - 1).rev() {
            let next = powers[power + 1];
            powers[power] += next * origin;
        }
    }
    powers
}

impl Receptance for Tabulated {
    /// Outside its range the table continues the polynomial of its first or last cell; a map asks
    /// only within.
    #[inline]
    fn receptance(&self, angular_frequency: f64, _speed: f64) -> Complex64 {
        let position = (angular_frequency.sqrt() - self.lowest_root) * self.cells_per_root;
        // A negative position saturates to the first cell.
        let cell = (position as usize).min(self.cells.len() - 1);
        let t = position - cell as f64;
        let [c0, c1, c2, c3, c4, c5] = self.cells[cell];
        c0 + (c1 + (c2 + (c3 + (c4 + c5 * t) * t) * t) * t) * t
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ElasticMaterial, EulerBernoulliBeam, Layer, TwoLayerTrack};

    fn track(damping: f64) -> TwoLayerTrack {
        let steel = ElasticMaterial::new(207e9, 0.3).unwrap();
        let rail = EulerBernoulliBeam::new(steel, 2.35e-5, 56.0).unwrap();
        let (pad, ballast) = (
            Layer::new(1.1e8, damping).unwrap(),
            Layer::new(8.6e7, damping).unwrap(),
        );
        TwoLayerTrack::new(rail, pad, 157.0, ballast).unwrap()
    }

    /// Points that share no divisor with the cells; the factor 2 allows for an error between the
    /// two places at which the table was checked.
    #[test]
    fn accurate_to_the_tolerance_everywhere() {
        let track = track(3e4);
        let table = Tabulated::new(&track, 100.0, 20e3, 1e-9).unwrap();
        assert!(table.cells() <= 4096, "{}", table.cells());
        for j in 0..=9973 {
            let w = 100.0 * 200f64.powf(f64::from(j) / 9973.0);
            let (h, exact) = (table.receptance(w, 0.0), track.receptance(w, 0.0));
            assert!((h - exact).norm() < 2e-9 * exact.norm(), "{w}");
        }
    }

    #[test]
    fn a_polynomial_of_degree_five_is_exact() {
        let values = std::array::from_fn(|j| Complex64::new((j as f64).powi(5), 1.0));
        let at = |powers: [Complex64; NODES], x: f64| {
            powers
                .iter()
                .rev()
                .fold(Complex64::ZERO, |sum, c| sum * x + c)
        };
        let powers = newton_coefficients(values);
        assert!((at(powers, 2.5).re - 2.5f64.powi(5)).abs() < 1e-12);
        assert!((at(shifted(powers, 2.0), 0.5).re - 2.5f64.powi(5)).abs() < 1e-11);
    }

    #[test]
    fn an_undamped_resonance_is_refused() {
        assert!(Tabulated::new(&track(0.0), 100.0, 20e3, 1e-9).is_err());
    }
}
