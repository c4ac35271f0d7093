//! A receptance read from a table over frequency.

use std::sync::Arc;

use num_complex::Complex64;
use pulp::Arch;

use super::{Frequencies, Receptance};
use crate::numerics::chebyshev::{NODES, polynomial_at, through_nodes};
use crate::tile::{SplitComplex, TILE, Tile};

/// Equal cells to begin with.
const FIRST_CELLS: usize = 64;
/// How often a cell may be halved: what is too sharp for the smallest is a resonance without loss,
/// and is left to the source.
const MOST_HALVINGS: u32 = 10;

/// Copy of a receptance that depends on frequency alone, interpolated to a stated accuracy.
///
/// Method: 64 equal cells in √ω (which follows the spacing of track resonances better than ω and
/// costs one square root, not a logarithm); in each the polynomial of degree 7 through Chebyshev's
/// nodes. A cell is halved, up to ten times, until the relative error at five points between its nodes
/// is within the tolerance. A cell that never holds it, which takes a resonance without loss, asks the
/// source instead, so that the table is as good as its tolerance everywhere. Neighbouring points of
/// a row of wavelengths lie in one cell and are evaluated together, in the widest vector instructions
/// of the machine. Cost: 13 receptances and 160 bytes a cell, some hundred cells for 1e-9 over two
/// decades of a periodic track, some fifty more for each resonance without loss; one square root and
/// seven multiply-adds for each part of a value.
#[derive(Clone)]
pub struct Tabulated {
    source: Arc<dyn Receptance>,
    /// In order of frequency, without gaps.
    cells: Vec<Cell>,
    arch: Arch,
}

/// A part of the range.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Cell {
    /// √ω at the lower end.
    begin: f64,
    /// √ω at the upper end.
    end: f64,
    /// Coefficients in t ∈ \[−1, 1\], lowest power first; `None` if the source is to be asked.
    polynomial: Option<[Complex64; NODES]>,
}

impl Tabulated {
    /// Tabulate `source`, at rest, over the angular frequencies `lowest..=highest` \[rad/s\] to the
    /// relative `tolerance`.
    pub fn new(source: Arc<dyn Receptance>, lowest: f64, highest: f64, tolerance: f64) -> Self {
        let (lowest, highest) = (lowest.sqrt(), highest.sqrt());
        let end = |cell: usize| lowest + (highest - lowest) * cell as f64 / FIRST_CELLS as f64;
        let mut cells = Vec::new();
        for cell in 0..FIRST_CELLS {
            let ends = (end(cell), end(cell + 1));
            divide(&*source, ends, tolerance, MOST_HALVINGS, &mut cells);
        }
        Self { source, cells, arch: Arch::new() }
    }

    /// Number of cells.
    pub fn cells(&self) -> usize {
        self.cells.len()
    }

    /// Index of the cell of a √ω; the first or the last where it lies outside.
    fn cell(&self, root: f64) -> usize {
        self.cells.partition_point(|cell| cell.end < root).min(self.cells.len() - 1)
    }

    #[inline(always)]
    fn fill(&self, frequencies: &Frequencies, receptances: &mut SplitComplex) {
        let roots: Tile = frequencies.angular.map(f64::sqrt);
        let mut index = self.cell(roots[0]);
        let mut done = 0;
        while done < TILE {
            if !self.cells[index].holds(roots[done]) {
                index = self.next(index, roots[done]);
            }
            let cell = &self.cells[index];
            // At least one, or a point outside the table would never be done.
            let run = 1 + roots[done + 1..].iter().take_while(|&&root| cell.holds(root)).count();
            let points = done..done + run;
            done += run;
            let Some(polynomial) = &cell.polynomial else {
                for j in points {
                    let value = self.source.receptance(frequencies.angular[j], 0.0);
                    (receptances.re[j], receptances.im[j]) = (value.re, value.im);
                }
                continue;
            };
            let middle = cell.middle();
            let per_half = cell.per_half();
            let places = &roots[points.clone()];
            let re = polynomial.map(|c| c.re);
            let im = polynomial.map(|c| c.im);
            horner(&re, middle, per_half, places, &mut receptances.re[points.clone()]);
            horner(&im, middle, per_half, places, &mut receptances.im[points]);
        }
    }

    /// The cell of a √ω, most likely beside the one of its neighbour.
    #[inline(always)]
    fn next(&self, index: usize, root: f64) -> usize {
        let below = index.saturating_sub(1);
        if self.cells[below].holds(root) {
            return below;
        }
        self.cell(root)
    }
}

/// A real polynomial at many places.
#[inline(always)]
fn horner(
    [c0, c1, c2, c3, c4, c5, c6, c7]: &[f64; NODES],
    middle: f64,
    per_half: f64,
    places: &[f64],
    values: &mut [f64],
) {
    for (value, place) in values.iter_mut().zip(places) {
        let t = (place - middle) * per_half;
        let t2 = t * t;
        let even = c0 + (c2 + (c4 + c6 * t2) * t2) * t2;
        let odd = c1 + (c3 + (c5 + c7 * t2) * t2) * t2;
        *value = even + odd * t;
    }
}

impl Cell {
    #[inline(always)]
    fn holds(&self, root: f64) -> bool {
        self.begin <= root && root <= self.end
    }

    #[inline(always)]
    fn middle(&self) -> f64 {
        0.5 * (self.begin + self.end)
    }

    /// dt/d√ω.
    #[inline(always)]
    fn per_half(&self) -> f64 {
        2.0 / (self.end - self.begin)
    }
}

/// One cell, or its two halves where it does not hold the tolerance.
fn divide(source: &dyn Receptance, (begin, end): (f64, f64), tolerance: f64, halvings: u32, cells: &mut Vec<Cell>) {
    /// Points between the nodes, the ends of the cell among them.
    const CHECKS: [f64; 5] = [-1.0, -0.56, 0.07, 0.7, 1.0];
    let (middle, half) = (0.5 * (begin + end), 0.5 * (end - begin));
    let at = |t: f64| {
        let root = middle + half * t;
        source.receptance(root * root, 0.0)
    };
    let polynomial = through_nodes(at);
    let holds = CHECKS.iter().all(|&t| {
        let exact = at(t);
        let value = polynomial_at(&polynomial, t);
        // False where either is not a number.
        (value - exact).norm() <= tolerance * exact.norm()
    });
    if !holds && halvings > 0 {
        divide(source, (begin, middle), tolerance, halvings - 1, cells);
        divide(source, (middle, end), tolerance, halvings - 1, cells);
        return;
    }
    cells.push(Cell { begin, end, polynomial: holds.then_some(polynomial) });
}

impl Receptance for Tabulated {
    /// Outside its range the table continues the polynomial of its first or last cell; a map asks
    /// only within.
    fn receptance(&self, angular_frequency: f64, _speed: f64) -> Complex64 {
        let root = angular_frequency.sqrt();
        let cell = &self.cells[self.cell(root)];
        let Some(polynomial) = &cell.polynomial else {
            return self.source.receptance(angular_frequency, 0.0);
        };
        let t = (root - cell.middle()) * cell.per_half();
        polynomial_at(polynomial, t)
    }

    fn receptances(&self, frequencies: &Frequencies, _speed: f64, receptances: &mut SplitComplex) {
        self.arch.dispatch(
            #[inline(always)]
            || self.fill(frequencies, receptances),
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ElasticMaterial;
    use crate::fixtures::steel;
    use crate::receptance::{Beam, ContinuousTrack, EulerBernoulliBeam, Layer, PeriodicTrack, ShearSection, Support};

    fn track(damping: f64) -> ContinuousTrack {
        let steel = steel();
        let rail = EulerBernoulliBeam::new(steel, 2.35e-5, 56.0).unwrap();
        let (pad, ballast) = (Layer::new(1.1e8, damping).unwrap(), Layer::new(8.6e7, damping).unwrap());
        ContinuousTrack::new(rail.into(), Support::two_layer(pad, 157.0, ballast).unwrap())
    }

    /// Points that share no divisor with the cells; the factor 2 allows for an error between the
    /// places at which the table was checked.
    fn check(track: impl Receptance + 'static, tolerance: f64, most_cells: usize) {
        let track = Arc::new(track);
        let table = Tabulated::new(track.clone(), 100.0, 20e3, tolerance);
        assert!(table.cells() <= most_cells, "{}", table.cells());
        for j in 0..=9973 {
            let w = 100.0 * 200f64.powf(f64::from(j) / 9973.0);
            let (h, exact) = (table.receptance(w, 0.0), track.receptance(w, 0.0));
            assert!((h - exact).norm() <= 2.0 * tolerance * exact.norm(), "{w}");
        }
    }

    #[test]
    fn accurate_to_the_tolerance_on_an_even_foundation() {
        check(track(3e4), 1e-9, 200);
    }

    /// The resonances of a track without loss are left to the source.
    #[test]
    fn accurate_to_the_tolerance_without_loss() {
        check(track(0.0), 1e-9, 1000);
    }

    /// A rail without loss has pinned-pinned resonances without loss, whatever its supports.
    #[test]
    fn accurate_to_the_tolerance_on_discrete_supports() {
        let steel = ElasticMaterial::new(210e9, 0.3).unwrap();
        let shear = ShearSection { area: 7.67e-3, shear_coefficient: 0.393, shear_modulus: 80e9, density: 7850.0 };
        let rail = Beam::timoshenko(steel, 3.037e-5, 60.2, shear).unwrap();
        let (pad, ballast) = (Layer::new(8e8, 3e4).unwrap(), Layer::new(1e8, 6e4).unwrap());
        let support = Support::two_layer(pad, 162.0, ballast).unwrap();
        for (loss_factor, most_cells) in [(0.02, 200), (0.0, 2000)] {
            let rail = rail.with_loss_factor(loss_factor).unwrap();
            for position in [0.0, 0.17, 0.3] {
                let track = PeriodicTrack::new(rail, support, 0.6).unwrap().at(position);
                check(track, 1e-9, most_cells);
            }
        }
    }
}
