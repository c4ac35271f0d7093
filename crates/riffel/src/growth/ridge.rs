//! The ridge: the wavelength of highest growth at each speed.

use num_complex::Complex64;
use rayon::prelude::*;

use super::branch::{Minimum, Place, RidgeBranch, chains, minima};
use super::{Axis, GrowthMap, RowEvaluator};
use crate::feedback::Loop;
use crate::golden_section::golden_section;

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

/// What the ridge needs of one row: the lowest point, refined, and the local minima on the grid.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct RidgeRow {
    highest: RidgePoint,
    lowest: usize,
    minima: Vec<Minimum>,
}

impl RidgeRow {
    /// The row that a [`RowEvaluator`] computed for the wavelengths at one speed \[m/s\], for those who keep the
    /// rows too; see [`Ridge::with_strongest_branch`].
    pub fn new(feedback: impl Into<Loop>, wavelength: Axis, speed: f64, row: &[Complex64]) -> Self {
        let feedback = feedback.into();
        Self::on(&Surface::of(&feedback), wavelength, speed, row)
    }

    fn on(
        surface: &Surface<impl Fn(f64, f64) -> f64>,
        wavelength: Axis,
        speed: f64,
        row: &[Complex64],
    ) -> Self {
        let lowest = lowest(row);
        Self {
            highest: surface.refined(wavelength, speed, lowest),
            lowest,
            minima: minima(wavelength, row),
        }
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
    /// Search the ridge row by row, keeping no map: the smallest Re Ŵ₁ on the grid of wavelengths,
    /// then refined between its neighbours by golden-section search to 1e-7 of the window, some 35
    /// evaluations a speed and branch. A second minimum narrower than the grid's step is missed.
    pub fn search(feedback: impl Into<Loop>, wavelength: Axis, speed: Axis) -> Self {
        Self::search_at(feedback, wavelength, &speed.values())
    }

    /// [`search`](Self::search) at any speeds \[m/s\], in their order.
    pub fn search_at(feedback: impl Into<Loop>, wavelength: Axis, speeds: &[f64]) -> Self {
        let feedback = feedback.into();
        let evaluator = RowEvaluator::for_map(&feedback, &wavelength.values(), speeds);
        let row = vec![Complex64::ZERO; wavelength.points()];
        let surface = Surface::of(&feedback);
        let rows: Vec<RidgeRow> = speeds
            .par_iter()
            .map_with((evaluator, row), |(evaluator, row), &speed| {
                evaluator.evaluate(speed, row);
                RidgeRow::on(&surface, wavelength, speed, row)
            })
            .collect();
        surface.ridge(wavelength, &rows, usize::MAX)
    }

    /// The ridge of a map of the same loop, as [`search`](Self::search) without computing the rows anew.
    pub fn of_map(feedback: impl Into<Loop>, map: &GrowthMap) -> Self {
        Self::on(&Surface::of(&feedback.into()), map)
    }

    /// The ridge of rows of the same loop and wavelengths, one for each speed, with its strongest branch alone: what
    /// the other branches cost is saved.
    pub fn with_strongest_branch(
        feedback: impl Into<Loop>,
        wavelength: Axis,
        rows: &[RidgeRow],
    ) -> Self {
        Surface::of(&feedback.into()).ridge(wavelength, rows, 1)
    }

    /// The ridge of a map, refined between its points on the function Ŵ₁ of wavelength and speed
    /// that the map samples.
    pub(super) fn refined_from(
        map: &GrowthMap,
        normalized: impl Fn(f64, f64) -> Complex64 + Sync,
    ) -> Self {
        let surface = Surface {
            normalized: |wavelength, speed| normalized(wavelength, speed).re,
            rate: map.growth_rate_per_dissipation(),
        };
        Self::on(&surface, map)
    }

    fn on(surface: &Surface<impl Fn(f64, f64) -> f64 + Sync>, map: &GrowthMap) -> Self {
        let rows: Vec<RidgeRow> = (0..map.speed().points())
            .into_par_iter()
            .map(|index| {
                let speed = map.speed().value(index);
                RidgeRow::on(surface, map.wavelength(), speed, map.row(index))
            })
            .collect();
        surface.ridge(map.wavelength(), &rows, usize::MAX)
    }

    /// Every line of growth at one speed \[m/s\]: the local minima of Re Ŵ₁ < 0 over the wavelengths,
    /// in order of wavelength, refined as in [`search`](Self::search).
    ///
    /// A track with supports has lines besides the ridge; each is a wavelength that may dominate
    /// where another mechanism filters the ridge out.
    pub fn lines_at(feedback: impl Into<Loop>, wavelength: Axis, speed: f64) -> Vec<RidgePoint> {
        let feedback = feedback.into();
        let mut row = vec![Complex64::ZERO; wavelength.points()];
        RowEvaluator::new(&feedback, &wavelength.values()).evaluate(speed, &mut row);
        let surface = Surface::of(&feedback);
        minima(wavelength, &row)
            .iter()
            .map(|minimum| surface.refined(wavelength, speed, minimum.index))
            .collect()
    }

    /// Frequency \[Hz\] that the strongest branch follows, see [`RidgeBranch::frequency`]; `None` where nothing
    /// grows.
    pub fn best_fit_frequency(&self) -> Option<f64> {
        self.branches.first().map(RidgeBranch::frequency)
    }

    /// The point of highest growth rate per passage.
    pub fn highest(&self) -> Option<&RidgePoint> {
        self.points
            .iter()
            .max_by(|a, b| a.growth_rate.total_cmp(&b.growth_rate))
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
    /// The minimum between the neighbours of a point of the grid.
    fn refined(&self, wavelength: Axis, speed: f64, lowest: usize) -> RidgePoint {
        let normalized = |wavelength| (self.normalized)(wavelength, speed);
        let last = wavelength.points() - 1;
        let bracket = [
            wavelength.value(lowest.saturating_sub(1)),
            wavelength.value((lowest + 1).min(last)),
        ];
        let tolerance = 1e-7 * (wavelength.max() - wavelength.min());
        let minimum = golden_section(bracket, tolerance, normalized);
        // At an end of the window the search walks to that end.
        let at_edge = minimum - wavelength.min() < 2.0 * tolerance
            || wavelength.max() - minimum < 2.0 * tolerance;
        let end = if lowest == 0 {
            wavelength.min()
        } else {
            wavelength.max()
        };
        let place = if at_edge { end } else { minimum };
        let normalized_dissipation = normalized(place);
        RidgePoint {
            speed,
            wavelength: place,
            frequency: speed / place,
            normalized_dissipation,
            growth_rate: self.rate * normalized_dissipation,
            at_edge,
        }
    }
}

impl<F: Fn(f64, f64) -> f64 + Sync> Surface<F> {
    /// The ridge of rows in any order, with so many of the strongest branches.
    fn ridge(&self, wavelength: Axis, rows: &[RidgeRow], most: usize) -> Ridge {
        let mut points: Vec<RidgePoint> = rows.iter().map(|row| row.highest).collect();
        let mut order: Vec<usize> = (0..rows.len()).collect();
        order.sort_by(|&a, &b| points[a].speed.total_cmp(&points[b].speed));
        let mut branches: Vec<(Vec<usize>, RidgeBranch)> = strongest(wavelength, rows, &order)
            .into_par_iter()
            .take(most)
            .map(|chain| {
                let refined = |&(row, place): &Place| {
                    let row = &rows[row];
                    let index = row.minima[place].index;
                    if index == row.lowest {
                        return row.highest;
                    }
                    self.refined(wavelength, row.highest.speed, index)
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
        Ridge {
            points,
            branches: branches.into_iter().map(|(_, branch)| branch).collect(),
        }
    }
}

/// The chains of minima in rows that are taken in an order of rising speed, the strongest first; without those that
/// are noise: weaker than [`WEAKEST`] of the strongest, or shorter than [`FEWEST`] points on a map of many speeds.
fn strongest(wavelength: Axis, rows: &[RidgeRow], order: &[usize]) -> Vec<Vec<Place>> {
    let in_order: Vec<(f64, &[Minimum])> = order
        .iter()
        .map(|&row| (rows[row].highest.speed, &rows[row].minima[..]))
        .collect();
    let value = |&(row, place): &Place| {
        let row: &RidgeRow = &rows[row];
        let minimum = row.minima[place];
        match minimum.index == row.lowest {
            true => row.highest.normalized_dissipation,
            false => minimum.value,
        }
    };
    let mut chains: Vec<(f64, Vec<Place>)> = chains(wavelength, &in_order)
        .into_iter()
        .map(|chain| {
            let chain: Vec<Place> = chain
                .into_iter()
                .map(|(row, place)| (order[row], place))
                .collect();
            let least = chain.iter().map(value).fold(0.0, f64::min);
            (least, chain)
        })
        .collect();
    chains.sort_by(|a, b| a.0.total_cmp(&b.0));
    let least = chains.first().map_or(0.0, |(least, _)| *least);
    let fewest = (rows.len() / SPEEDS_A_POINT).clamp(1, FEWEST);
    let kept = |(value, chain): &(f64, Vec<Place>)| {
        *value == least || (*value <= WEAKEST * least && chain.len() >= fewest)
    };
    chains.retain(kept);
    chains.into_iter().map(|(_, chain)| chain).collect()
}

/// Index of the smallest Re Ŵ₁.
fn lowest(row: &[Complex64]) -> usize {
    (0..row.len())
        .min_by(|&a, &b| row[a].re.total_cmp(&row[b].re))
        .unwrap_or(0)
}
