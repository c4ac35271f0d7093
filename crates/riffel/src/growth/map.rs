//! The growth map.

use num_complex::Complex64;
use rayon::prelude::*;

use super::{Axis, RowEvaluator};
use crate::cancel::check;
use crate::feedback::Loop;
use crate::tile::TILE;

/// Normalised dissipation Ŵ₁ over wavelength and speed, as in Figs. 4 and 5 of the paper.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct GrowthMap {
    wavelength: Axis,
    speed: Axis,
    /// Rows of equal speed, each of whole tiles.
    tiles: Vec<[Complex64; TILE]>,
    growth_rate_per_dissipation: f64,
}

impl GrowthMap {
    /// Evaluate the loop on a grid, rows of equal speed in parallel on the current rayon pool.
    ///
    /// `progress` is called from any thread with the number of rows just finished, one at a time.
    /// Memory: 16 bytes a point. A point agrees with [`Loop::at`] to rounding, or to 1e-9
    /// where a large map reads the track from a [`Tabulated`](crate::receptance::Tabulated) receptance.
    pub fn compute(feedback: impl Into<Loop>, wavelength: Axis, speed: Axis, progress: impl Fn(usize) + Sync) -> Self {
        let feedback = feedback.into();
        let (wavelengths, speeds) = (wavelength.values(), speed.values());
        let growth_rate_per_dissipation = feedback.growth_rate_per_dissipation();
        Self {
            wavelength,
            speed,
            tiles: Grid::new(&wavelengths, &speeds, &progress).evaluated(feedback),
            growth_rate_per_dissipation,
        }
    }

    /// Write Ŵ₁ over any wavelengths \[m\] and speeds \[m/s\], not only equally spaced ones, to `tiles`: for each
    /// speed as many whole tiles as hold the wavelengths, of which the last is filled up with values that mean
    /// nothing.
    ///
    /// Method, `progress` and accuracy are those of [`compute`](Self::compute).
    ///
    /// # Panics
    ///
    /// If there are not that many tiles.
    pub fn compute_into(
        feedback: impl Into<Loop>,
        wavelengths: &[f64],
        speeds: &[f64],
        tiles: &mut [[Complex64; TILE]],
        progress: impl Fn(usize) + Sync,
    ) {
        Grid::new(wavelengths, speeds, &progress).evaluate_into(feedback.into(), tiles);
    }

    /// The map with every value multiplied by a factor.
    pub(super) fn scaled(&self, factor: f64) -> Self {
        let mut scaled = self.clone();
        for value in scaled.tiles.as_flattened_mut() {
            *value *= factor;
        }
        scaled
    }

    /// Add another map of the same window, multiplied by a factor.
    pub(super) fn add(&mut self, other: &Self, factor: f64) {
        let values = other.tiles.as_flattened();
        for (value, other) in self.tiles.as_flattened_mut().iter_mut().zip(values) {
            *value += other * factor;
        }
    }

    /// Wavelengths \[m\], the fast axis.
    pub fn wavelength(&self) -> Axis {
        self.wavelength
    }

    /// Speeds \[m/s\], the slow axis.
    pub fn speed(&self) -> Axis {
        self.speed
    }

    /// Growth rate per passage for a value of Ŵ₁: g = this factor · Re Ŵ₁, negative factor.
    pub fn growth_rate_per_dissipation(&self) -> f64 {
        self.growth_rate_per_dissipation
    }

    /// Ŵ₁ over the wavelengths at the speed of the given index.
    pub fn row(&self, index: usize) -> &[Complex64] {
        let tiles_a_row = self.wavelength.points().div_ceil(TILE);
        let tiles = &self.tiles[index * tiles_a_row..(index + 1) * tiles_a_row];
        &tiles.as_flattened()[..self.wavelength.points()]
    }

    /// Rows of the map in order of speed: the speed \[m/s\] and Ŵ₁ over the wavelengths.
    pub fn rows(&self) -> impl Iterator<Item = (f64, &[Complex64])> {
        (0..self.speed.points()).map(|index| (self.speed.value(index), self.row(index)))
    }
}

/// The tiles of a map, row by row.
// Without a parameter of type: the loop over the tiles is compiled here, with the optimisation of this crate,
// and not in whichever crate asks for a map.
struct Grid<'a> {
    wavelengths: &'a [f64],
    speeds: &'a [f64],
    tiles_a_row: usize,
    progress: &'a (dyn Fn(usize) + Sync),
}

impl<'a> Grid<'a> {
    fn new(wavelengths: &'a [f64], speeds: &'a [f64], progress: &'a (dyn Fn(usize) + Sync)) -> Self {
        Self { wavelengths, speeds, tiles_a_row: wavelengths.len().div_ceil(TILE), progress }
    }

    fn tiles(&self) -> usize {
        self.speeds.len() * self.tiles_a_row
    }

    /// All tiles, in parallel.
    fn evaluated(&self, feedback: Loop) -> Vec<[Complex64; TILE]> {
        let evaluator = RowEvaluator::for_map(feedback, self.wavelengths, self.speeds);
        let mut tiles = Vec::new();
        (0..self.tiles())
            .into_par_iter()
            .with_min_len(self.tiles_a_row)
            .map_init(|| Self::part(&evaluator), |part, index| self.evaluate(part, index))
            .collect_into_vec(&mut tiles);
        tiles
    }

    /// Evaluate into tiles that are there.
    fn evaluate_into(&self, feedback: Loop, tiles: &mut [[Complex64; TILE]]) {
        assert_eq!(tiles.len(), self.tiles(), "tiles of a map");
        let evaluator = RowEvaluator::for_map(feedback, self.wavelengths, self.speeds);
        let parts = tiles.par_iter_mut().enumerate().with_min_len(self.tiles_a_row);
        parts.for_each_init(|| Self::part(&evaluator), |part, (index, tile)| *tile = self.evaluate(part, index));
    }

    /// What evaluates some tiles one after another on one thread.
    ///
    /// Work that is broken off is divided further while it unwinds, and few of its parts begin with a row: each asks before it begins.
    fn part(evaluator: &RowEvaluator) -> RowEvaluator {
        check();
        evaluator.clone()
    }

    /// One tile.
    fn evaluate(&self, evaluator: &mut RowEvaluator, index: usize) -> [Complex64; TILE] {
        let (row, tile) = (index / self.tiles_a_row, index % self.tiles_a_row);
        if tile == 0 {
            check();
        }
        let values = evaluator.evaluate_tile(self.speeds[row], tile);
        if tile + 1 == self.tiles_a_row {
            (self.progress)(1);
        }
        values
    }
}
