//! A receptance read from a table over frequency.

use std::sync::Arc;

use num_complex::Complex64;
use pulp::Arch;
use riffel_numerics::chebyshev::{Cell, Cut, NODES};

use super::{Frequencies, Receptance};
use crate::tile::{SplitComplex, TILE, Tile};

/// What is too sharp for the smallest cell is a resonance without loss, and is left to the source. The ends of cells are checked, too.
const CUT: Cut = Cut { first_cells: 64, most_halvings: 10, checks: [-1.0, -0.56, 0.07, 0.7, 1.0] };

/// Copy of a receptance that depends on frequency alone, interpolated to a stated accuracy.
///
/// Method: 64 equal cells in √ω (which follows the spacing of track resonances better than ω and
/// costs one square root, not a logarithm); in each the polynomial of degree 7 through Chebyshev's
/// nodes. A cell is halved, up to ten times, until the relative error at five points between its nodes
/// is within the tolerance. A cell that never holds it, which takes a resonance without loss, asks the
/// source instead, so that the table is as good as its tolerance everywhere. Neighbouring points of
/// a row of wavelengths lie in one cell and are evaluated together, in the widest vector instructions
/// of the machine. Cost: 13 receptances and 170 bytes a cell, some hundred cells for 1e-9 over two
/// decades of a periodic track, some fifty more for each resonance without loss; one square root and
/// seven multiply-adds for each part of a value.
#[derive(Clone)]
pub struct Tabulated {
    source: Arc<dyn Receptance>,
    /// Over √ω.
    cells: Vec<Cell<Complex64>>,
    arch: Arch,
}

impl Tabulated {
    /// Tabulate `source`, at rest, over the angular frequencies `lowest..=highest` \[rad/s\] to the
    /// relative `tolerance`.
    pub fn new(source: Arc<dyn Receptance>, lowest: f64, highest: f64, tolerance: f64) -> Self {
        let (lowest, highest) = (lowest.sqrt(), highest.sqrt());
        let value = |root: f64| source.receptance(root * root, 0.0);
        // False where either is not a number.
        let holds = |exact: Complex64, value: Complex64| (value - exact).norm() <= tolerance * exact.norm();
        let cells = Cell::table(value, [lowest, highest], &CUT, holds);
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
            if !contains(&self.cells[index], roots[done]) {
                index = self.next(index, roots[done]);
            }
            let cell = &self.cells[index];
            // At least one, or a point outside the table would never be done.
            let run = 1 + roots[done + 1..].iter().take_while(|&&root| contains(cell, root)).count();
            let points = done..done + run;
            done += run;
            if !cell.holds {
                for j in points {
                    let value = self.source.receptance(frequencies.angular[j], 0.0);
                    (receptances.re[j], receptances.im[j]) = (value.re, value.im);
                }
                continue;
            }
            let places = &roots[points.clone()];
            let re = cell.polynomial.map(|c| c.re);
            let im = cell.polynomial.map(|c| c.im);
            horner(&re, cell, places, &mut receptances.re[points.clone()]);
            horner(&im, cell, places, &mut receptances.im[points]);
        }
    }

    /// The cell of a √ω, most likely beside the one of its neighbour.
    #[inline(always)]
    fn next(&self, index: usize, root: f64) -> usize {
        let below = index.saturating_sub(1);
        if contains(&self.cells[below], root) {
            return below;
        }
        self.cell(root)
    }
}

/// Whether a cell has a √ω, its ends included.
#[inline(always)]
fn contains(cell: &Cell<Complex64>, root: f64) -> bool {
    cell.begin <= root && root <= cell.end
}

/// A real polynomial at many places.
#[inline(always)]
fn horner([c0, c1, c2, c3, c4, c5, c6, c7]: &[f64; NODES], cell: &Cell<Complex64>, places: &[f64], values: &mut [f64]) {
    for (value, place) in values.iter_mut().zip(places) {
        let t = (place - cell.middle) * cell.per_half;
        let t2 = t * t;
        let even = c0 + (c2 + (c4 + c6 * t2) * t2) * t2;
        let odd = c1 + (c3 + (c5 + c7 * t2) * t2) * t2;
        *value = even + odd * t;
    }
}

impl Receptance for Tabulated {
    /// Outside its range the table continues the polynomial of its first or last cell; a map asks
    /// only within.
    fn receptance(&self, angular_frequency: f64, _speed: f64) -> Complex64 {
        let root = angular_frequency.sqrt();
        let cell = &self.cells[self.cell(root)];
        match cell.holds {
            true => cell.at(root),
            false => self.source.receptance(angular_frequency, 0.0),
        }
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
