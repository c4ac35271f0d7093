//! The ridge: the wavelength of highest growth at each speed.

use std::sync::Arc;

use num_complex::Complex64;
use rayon::prelude::*;
use riffel_numerics::golden_section::golden_section;

use super::branch::{Minimum, Place, RidgeBranch, chains, minima};
use super::fine_row::{FineRow, first_wavelengths};
use super::{Axis, GrowthMap, RowEvaluator};
use crate::cancel::check;
use crate::feedback::Loop;

/// Share of the growth of the strongest branch below which another is left out: it would take a hundred times as long.
const WEAKEST: f64 = 0.01;
/// Points that a branch has at least where the speeds are many: fewer are a ripple of the grid.
const FEWEST: usize = 3;
/// Speeds for each point that is asked of a branch, up to [`FEWEST`].
const SPEEDS_A_POINT: usize = 50;

/// The highest growth at one speed within the window of wavelengths.
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct RidgePoint {
    /// Speed V \[m/s\].
    pub speed: f64,
    /// Wavelength λ of the smallest Re Ŵ₁ \[m\].
    pub wavelength: f64,
    /// Frequency V/λ \[Hz\].
    pub frequency: f64,
    /// Re Ŵ₁ there \[-\]; growth only if negative.
    pub normalized_dissipation: f64,
    /// Growth rate per passage there \[-\].
    pub growth_rate: f64,
    /// The minimum sits at an end of the window, so a longer or shorter wavelength would grow
    /// faster.
    pub at_edge: bool,
}

/// What the ridge needs of one speed: the lowest point, and the local minima.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct RidgeRow {
    highest: RidgePoint,
    lowest: usize,
    minima: Vec<Minimum>,
}

/// The search of a ridge, row by row; for those who compute rows of their own. Holds scratch for a row; make one for each thread
/// with `clone`.
#[derive(Clone)]
pub struct RidgeSearch {
    feedback: Loop,
    window: Axis,
    first: Arc<[f64]>,
    evaluator: RowEvaluator,
}

impl RidgeSearch {
    /// The search over a window of wavelengths, whose number of points has no part, at speeds \[m/s\].
    pub fn new(feedback: impl Into<Loop>, window: Axis, speeds: &[f64]) -> Self {
        let feedback = feedback.into();
        let first = first_wavelengths(window);
        Self { evaluator: RowEvaluator::for_map(&feedback, &first, speeds), first: first.into(), feedback, window }
    }

    /// The row at a speed \[m/s\].
    pub fn row(&mut self, speed: f64) -> RidgeRow {
        check();
        let surface = Surface::of(&self.feedback);
        let value = |wavelength| (surface.normalized)(wavelength, speed);
        let row = FineRow::evaluated(&mut self.evaluator, &self.first, speed, value);
        surface.row(self.window, speed, &row)
    }

    /// The ridge of rows, one for each speed, with so many of its strongest branches: what the others cost is saved.
    pub fn ridge(&self, rows: &[RidgeRow], branches: usize) -> Ridge {
        Surface::of(&self.feedback).ridge(self.window, rows, branches)
    }
}

/// The highest growth at each speed, and the branches of which it consists.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct Ridge {
    /// One point per speed.
    pub points: Vec<RidgePoint>,
    /// Lines of growth that continue from speed to speed, the one of the highest growth rate first; those too that a
    /// stronger one hides at every speed. Empty where nothing grows.
    ///
    /// A branch with less than 1 % of the growth of the strongest is left out, and one of fewer than three points
    /// where there are 150 speeds or more.
    pub branches: Vec<RidgeBranch>,
}

impl Ridge {
    /// Search the ridge row by row, keeping no map: all local minima of Re Ŵ₁ over the wavelengths, however narrow (half a
    /// per cent of the wavelength and halves of it, until the course is straight between two values to 1 % of the largest growth),
    /// the lowest of each row and those of branches then refined by golden-section search to 1e-7 of the window.
    ///
    /// The number of points of the window has no part in it: a map of any resolution has the same ridge. A line of less than
    /// 0.02 % of the critical damping may be missed.
    pub fn search(feedback: impl Into<Loop>, wavelength: Axis, speed: Axis) -> Self {
        Self::search_at(feedback, wavelength, &speed.values())
    }

    /// [`search`](Self::search) at any speeds \[m/s\], in their order.
    pub fn search_at(feedback: impl Into<Loop>, wavelength: Axis, speeds: &[f64]) -> Self {
        let search = RidgeSearch::new(feedback, wavelength, speeds);
        let rows: Vec<RidgeRow> =
            speeds.par_iter().map_with(search.clone(), |search, &speed| search.row(speed)).collect();
        search.ridge(&rows, usize::MAX)
    }

    /// The ridge over the window of a map of the same loop.
    pub fn of_map(feedback: impl Into<Loop>, map: &GrowthMap) -> Self {
        Self::search(feedback, map.wavelength(), map.speed())
    }

    /// That of no wavelengths.
    pub fn nothing() -> Self {
        Self { points: Vec::new(), branches: Vec::new() }
    }

    /// The ridge of a map over a part of its wavelengths, refined between its points on the function Ŵ₁ of wavelength and
    /// speed that the map samples.
    pub(super) fn refined_from(
        map: &GrowthMap,
        window: Axis,
        normalized: impl Fn(f64, f64) -> Complex64 + Sync,
    ) -> Self {
        let surface = Surface {
            normalized: |wavelength, speed| normalized(wavelength, speed).re,
            rate: map.growth_rate_per_dissipation(),
        };
        let rows: Vec<RidgeRow> = (0..map.speed().points())
            .into_par_iter()
            .map(|index| {
                let speed = map.speed().value(index);
                let value = |wavelength| (surface.normalized)(wavelength, speed);
                let of_map = map.wavelength().values().into_iter().zip(map.row(index));
                let row = FineRow::filled(window, of_map, value);
                surface.row(window, speed, &row)
            })
            .collect();
        surface.ridge(window, &rows, usize::MAX)
    }

    /// Every line of growth at one speed \[m/s\]: the local minima of Re Ŵ₁ < 0 over the wavelengths,
    /// in order of wavelength, found and refined as in [`search`](Self::search).
    ///
    /// A track with supports has lines besides the ridge; each is a wavelength that may dominate
    /// where another mechanism filters the ridge out.
    pub fn lines_at(feedback: impl Into<Loop>, wavelength: Axis, speed: f64) -> Vec<RidgePoint> {
        let mut search = RidgeSearch::new(feedback, wavelength, &[speed]);
        let row = search.row(speed);
        let surface = Surface::of(&search.feedback);
        row.minima.iter().map(|minimum| surface.refined(wavelength, speed, minimum.between)).collect()
    }

    /// Frequency \[Hz\] that the strongest branch follows, see [`RidgeBranch::frequency`]; `None` where nothing
    /// grows.
    pub fn best_fit_frequency(&self) -> Option<f64> {
        self.branches.first().map(RidgeBranch::frequency)
    }

    /// The point of highest growth rate per passage.
    pub fn highest(&self) -> Option<&RidgePoint> {
        self.points.iter().max_by(|a, b| a.growth_rate.total_cmp(&b.growth_rate))
    }
}

/// Re Ŵ₁ as a function of wavelength and speed, with the growth rate for Ŵ₁ = 1.
struct Surface<F> {
    normalized: F,
    rate: f64,
}

impl Surface<()> {
    /// That of a loop.
    fn of(feedback: &Loop) -> Surface<impl Fn(f64, f64) -> f64 + Sync + '_> {
        let normalized = feedback.normalized_dissipation();
        Surface {
            normalized: move |wavelength, speed| normalized(wavelength, speed).re,
            rate: feedback.growth_rate_per_dissipation(),
        }
    }
}

impl<F: Fn(f64, f64) -> f64> Surface<F> {
    fn row(&self, window: Axis, speed: f64, row: &FineRow) -> RidgeRow {
        let minima = minima(&row.wavelengths, &row.values);
        let values = &row.values;
        let lowest = (0..values.len()).min_by(|&a, &b| values[a].total_cmp(&values[b]));
        let lowest = lowest.unwrap_or(0);
        let last = values.len() - 1;
        let between = [lowest.saturating_sub(1), (lowest + 1).min(last)];
        let between = between.map(|index| row.wavelengths[index]);
        RidgeRow { highest: self.refined(window, speed, between), lowest, minima }
    }

    /// The minimum between two wavelengths.
    fn refined(&self, window: Axis, speed: f64, between: [f64; 2]) -> RidgePoint {
        let normalized = |wavelength| (self.normalized)(wavelength, speed);
        let tolerance = 1e-7 * (window.max() - window.min());
        let minimum = golden_section(between, tolerance, normalized);
        // At an end of the window the search walks to that end.
        let end = [window.min(), window.max()].into_iter().find(|end| (minimum - end).abs() < 2.0 * tolerance);
        let place = end.unwrap_or(minimum);
        let normalized_dissipation = normalized(place);
        RidgePoint {
            speed,
            wavelength: place,
            frequency: speed / place,
            normalized_dissipation,
            growth_rate: self.rate * normalized_dissipation,
            at_edge: end.is_some(),
        }
    }
}

impl<F: Fn(f64, f64) -> f64 + Sync> Surface<F> {
    /// The ridge of rows in any order, with so many of the strongest branches.
    fn ridge(&self, window: Axis, rows: &[RidgeRow], most: usize) -> Ridge {
        let mut points: Vec<RidgePoint> = rows.iter().map(|row| row.highest).collect();
        let mut order: Vec<usize> = (0..rows.len()).collect();
        order.sort_by(|&a, &b| points[a].speed.total_cmp(&points[b].speed));
        let mut branches: Vec<(Vec<usize>, RidgeBranch)> = strongest(rows, &order)
            .into_par_iter()
            .take(most)
            .map(|chain| {
                let refined = |&(row, place): &Place| {
                    let row = &rows[row];
                    let minimum = row.minima[place];
                    if minimum.index == row.lowest {
                        return row.highest;
                    }
                    self.refined(window, row.highest.speed, minimum.between)
                };
                let points = chain.iter().map(refined).collect();
                let rows = chain.iter().map(|&(row, _)| row).collect();
                (rows, RidgeBranch::new(points))
            })
            .collect();
        // Between two minima that the grid hardly tells apart, the refined values decide.
        for (rows, branch) in &branches {
            for (&row, point) in rows.iter().zip(branch.points()) {
                if point.growth_rate > points[row].growth_rate {
                    points[row] = *point;
                }
            }
        }
        let rate = |branch: &RidgeBranch| branch.highest().growth_rate;
        branches.sort_by(|(_, a), (_, b)| rate(b).total_cmp(&rate(a)));
        Ridge { points, branches: branches.into_iter().map(|(_, branch)| branch).collect() }
    }
}

/// The chains of minima in rows that are taken in an order of rising speed, the strongest first; without those that
/// are noise: weaker than [`WEAKEST`] of the strongest, or shorter than [`FEWEST`] points on a map of many speeds.
fn strongest(rows: &[RidgeRow], order: &[usize]) -> Vec<Vec<Place>> {
    let in_order: Vec<(f64, &[Minimum])> =
        order.iter().map(|&row| (rows[row].highest.speed, &rows[row].minima[..])).collect();
    let value = |&(row, place): &Place| {
        let row: &RidgeRow = &rows[row];
        let minimum = row.minima[place];
        match minimum.index == row.lowest {
            true => row.highest.normalized_dissipation,
            false => minimum.value,
        }
    };
    let mut chains: Vec<(f64, Vec<Place>)> = chains(&in_order)
        .into_iter()
        .map(|chain| {
            let chain: Vec<Place> = chain.into_iter().map(|(row, place)| (order[row], place)).collect();
            let least = chain.iter().map(value).fold(0.0, f64::min);
            (least, chain)
        })
        .collect();
    chains.sort_by(|a, b| a.0.total_cmp(&b.0));
    let least = chains.first().map_or(0.0, |(least, _)| *least);
    let fewest = (rows.len() / SPEEDS_A_POINT).clamp(1, FEWEST);
    let kept =
        |(value, chain): &(f64, Vec<Place>)| *value == least || (*value <= WEAKEST * least && chain.len() >= fewest);
    chains.retain(kept);
    chains.into_iter().map(|(_, chain)| chain).collect()
}
