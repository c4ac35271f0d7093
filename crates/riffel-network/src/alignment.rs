//! By how much the places of one survey are off those of another.

use crate::NetworkError;
use crate::record::{RailRecord, SurveyRecord};
use crate::store::{ROWS, Store};

/// Cells of a window that is moved as a whole.
const WINDOW: i64 = 256;
/// Farthest that an odometer is off along a window \[m\].
pub(crate) const FARTHEST: f64 = 20.0;
/// Most cells of that.
const MOST: i64 = 64;
/// Correlation from which two windows show the same rail: of two hundred cells by chance 0.3 at most.
const SAME: f64 = 0.5;
/// By how much a shift must be better than a smaller one: joints a rail apart look alike.
const BETTER: f64 = 0.05;

/// Shifts of a survey along the line \[m\], window by window; without any it stays where it is.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Alignment {
    from: f64,
    window: f64,
    shifts: Vec<f64>,
}

impl Alignment {
    /// What is to be added to a place of the survey \[m\].
    pub(crate) fn at(&self, place: f64) -> f64 {
        let last = self.shifts.len().saturating_sub(1);
        let window = ((place - self.from) / self.window).clamp(0.0, last as f64);
        self.shifts.get(window as usize).copied().unwrap_or(0.0)
    }

    /// The shift of a survey against another of the same line, which has the same places.
    ///
    /// Method: levels, averaged over the bands and rails that both have, of windows of 256 cells; of the shifts by whole cells up
    /// to 20 m the smallest of those that correlate best. Windows that show nothing go with the nearest that does.
    ///
    /// # Errors
    /// Errors of the files.
    pub(crate) fn of(store: &Store, survey: &SurveyRecord, reference: &SurveyRecord) -> Result<Self, NetworkError> {
        let resolution = store.resolution()?;
        let cell = |place: f64| (place / resolution).round() as i64;
        let (start, origin) = (cell(reference.start_m), cell(survey.start_m));
        let cells = reference.cells as i64;
        let farthest = ((FARTHEST / resolution).ceil() as i64).min(MOST);
        let rails = |of: &SurveyRecord, other: &SurveyRecord| -> Vec<RailRecord> {
            let is_there = |rail: &&RailRecord| other.rails.iter().any(|one| one.name == rail.name);
            of.rails.iter().filter(is_there).cloned().collect()
        };
        let mut there = Levels::new(store, reference, rails(reference, survey))?;
        let mut here = Levels::new(store, survey, rails(survey, reference))?;
        let mut found: Vec<Option<i64>> = Vec::new();
        for first in (0..cells).step_by(WINDOW as usize) {
            let count = WINDOW.min(cells - first);
            let fixed = there.between(first, count)?;
            let from = start + first - farthest - origin;
            let moved = here.between(from, count + 2 * farthest)?;
            found.push(best(&fixed, &moved, farthest));
        }
        let known: Vec<(usize, i64)> =
            found.iter().enumerate().filter_map(|(window, shift)| Some((window, (*shift)?))).collect();
        let shifts = (0..found.len()).map(|window| {
            let nearest = known.iter().min_by_key(|(other, _)| other.abs_diff(window));
            nearest.map_or(0.0, |(_, shift)| *shift as f64 * resolution)
        });
        Ok(Self { from: reference.start_m, window: WINDOW as f64 * resolution, shifts: shifts.collect() })
    }
}

/// By how many cells what is moved must go on to lie on what is fixed; `moved` begins and ends so many cells farther out.
fn best(fixed: &[f64], moved: &[f64], farthest: i64) -> Option<i64> {
    let correlations: Vec<(i64, f64)> =
        (0..=2 * farthest).map(|offset| (farthest - offset, correlation(fixed, &moved[offset as usize..]))).collect();
    let highest = correlations.iter().map(|(_, of)| *of).fold(f64::MIN, f64::max);
    if highest < SAME {
        return None;
    }
    let good = correlations.into_iter().filter(|(_, of)| *of > highest - BETTER);
    good.map(|(shift, _)| shift).min_by_key(|shift| shift.abs())
}

/// Of pairs that are both known; none of fewer than half.
fn correlation(fixed: &[f64], moved: &[f64]) -> f64 {
    let pairs = || {
        let pairs = fixed.iter().zip(moved);
        pairs.filter(|(one, other)| one.is_finite() && other.is_finite())
    };
    let count = pairs().count() as f64;
    if count < 0.5 * fixed.len() as f64 || count < 8.0 {
        return f64::MIN;
    }
    let (one_sum, other_sum) = pairs().fold((0.0, 0.0), |(a, b), (one, other)| (a + one, b + other));
    let (mut own, mut others, mut both) = (0.0, 0.0, 0.0);
    for (one, other) in pairs() {
        let (one, other) = (one - one_sum / count, other - other_sum / count);
        own += one * one;
        others += other * other;
        both += one * other;
    }
    match own > 0.0 && others > 0.0 {
        true => both / (own * others).sqrt(),
        false => f64::MIN,
    }
}

/// Levels of the cells of a survey \[dB\], averaged over some rails and all bands. Memory: a chunk of each rail.
struct Levels<'a> {
    store: &'a Store,
    survey: &'a SurveyRecord,
    rails: Vec<RailRecord>,
    bands: usize,
    /// The chunk that is held, and its levels.
    held: Option<(u64, Vec<f64>)>,
}

impl<'a> Levels<'a> {
    fn new(store: &'a Store, survey: &'a SurveyRecord, rails: Vec<RailRecord>) -> Result<Self, NetworkError> {
        Ok(Self { bands: store.bands()?.len(), store, survey, rails, held: None })
    }

    /// Of so many cells from one on; NaN of those that are not known.
    fn between(&mut self, first: i64, count: i64) -> Result<Vec<f64>, NetworkError> {
        let mut levels = Vec::new();
        for cell in first..first + count {
            let cell = u64::try_from(cell).ok().filter(|cell| *cell < self.survey.cells);
            levels.push(match cell {
                Some(cell) => self.chunk(cell / ROWS)?[(cell % ROWS) as usize],
                None => f64::NAN,
            });
        }
        Ok(levels)
    }

    fn chunk(&mut self, chunk: u64) -> Result<&[f64], NetworkError> {
        if self.held.as_ref().is_none_or(|(held, _)| *held != chunk) {
            let mut sums = vec![(0.0, 0.0); ROWS as usize];
            for rail in &self.rails {
                let values = self.store.chunk(self.survey, rail, self.bands, chunk)?;
                let rows = values.iter().flat_map(|values| values.chunks(self.bands));
                for (sum, row) in sums.iter_mut().zip(rows) {
                    for rms in row.iter().filter(|rms| rms.is_finite() && **rms > 0.0) {
                        *sum = (sum.0 + 20.0 * rms.log10(), sum.1 + 1.0);
                    }
                }
            }
            let levels = sums.into_iter().map(|(sum, count)| sum / count);
            self.held = Some((chunk, levels.collect()));
        }
        Ok(self.held.as_ref().map_or(&[][..], |(_, levels)| levels))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Joints every 18 cells with a jitter, a cell off: one cell, not 17; of noise nothing is known.
    #[test]
    fn joints_one_cell_off_are_moved_by_one() {
        let noise = |cell: i64, seed: i64| ((cell * 7919 + seed * 104_729) % 1000) as f64 / 2000.0;
        let line = |cell: i64, seed: i64| match cell.rem_euclid(18) {
            0 => 30.0 + noise(cell, seed),
            _ => 5.0 + noise(cell, seed),
        };
        let fixed: Vec<f64> = (0..256).map(|cell| line(cell, 1)).collect();
        for shift in [-3, 0, 1, 8] {
            let moved: Vec<f64> = (-20..276).map(|cell| line(cell + shift, 2)).collect();
            assert_eq!(best(&fixed, &moved, 20), Some(shift));
        }
        let other: Vec<f64> = (-20..276).map(|cell: i64| noise(cell.pow(2), 3)).collect();
        let plain: Vec<f64> = (0..256).map(|cell: i64| noise(cell.pow(3), 5)).collect();
        assert_eq!(best(&plain, &other, 20), None);
    }
}
