//! Levels by a trolley at several dates.

use std::path::Path;

use riffel::diagnosis::{FALL_BY_GRINDING, fall_of_bands, first_since_ground};
use riffel::roughness::ThirdOctave;
use riffel_case::Case;
use riffel_keys::{CaseError, say};

use super::row::{self, Row};
use super::table;
use crate::data::too_few;
use crate::file::Kind;
use crate::kernel::Kernel;

/// Levels of a trolley.
#[derive(Clone)]
pub(crate) struct DatedLevels {
    pub(crate) view: usize,
    pub(crate) rows: Vec<Row>,
    /// What was counted at the first date.
    pub(crate) begins: f64,
    /// Passages from the first date of the table to that: of dates before the rail was ground.
    pub(crate) before: f64,
    /// Standard deviation of the level that the bands of a date share \[dB\].
    pub(crate) common_error: f64,
    pub(crate) missed: Option<Kernel>,
}

/// Rows of a table since the rail was last ground.
pub(crate) struct SinceGround {
    pub(crate) rows: Vec<Row>,
    /// What was counted at the first of their dates, and passages from that of the table to it.
    pub(crate) begins: f64,
    pub(crate) before: f64,
}

/// By how much the rail falls from one date to another, by the bands that both have \[dB\].
fn fall(rows: &[Row], dates: &[f64]) -> f64 {
    let of = |date: f64| rows.iter().filter(move |row| row.passages == date);
    let falls = of(dates[0]).flat_map(|one| {
        let same = of(dates[1]).filter(|other| other.band == one.band);
        same.map(|other| one.level - other.level)
    });
    fall_of_bands(falls)
}

impl DatedLevels {
    /// The rows of a table since the rail was last ground.
    pub(crate) fn rows(path: &Path, case: &Case) -> Result<SinceGround, CaseError> {
        let numbers = table::Numbers::of(path, Kind::DatedLevels)?;
        let passages = &numbers.needed[3];
        let first = passages.iter().copied().fold(f64::INFINITY, f64::min);
        let mut rows = row::rows(&numbers, path, case, |row| passages[row] - first)?;
        if rows.iter().all(|row| row.passages == 0.0) {
            let message =
                "all levels are of one date, which says nothing of growth; measure again, or leave the file out";
            return Err(numbers.refuse(path, 0, message));
        }
        let last = (0..rows.len()).max_by(|a, b| rows[*a].passages.total_cmp(&rows[*b].passages));
        if let Some(last) = last
            && let Some(rule) = too_few(rows[last].passages)
        {
            return Err(numbers.refuse(path, last, rule));
        }
        let mut dates: Vec<f64> = rows.iter().map(|row| row.passages).collect();
        dates.sort_by(f64::total_cmp);
        dates.dedup();
        let since = first_since_ground(dates.windows(2).map(|pair| fall(&rows, pair)));
        let before = dates[since];
        if since > 0 && since + 1 == dates.len() {
            let ground = say!(only_ground, passages = before + first, fall = FALL_BY_GRINDING);
            return Err(numbers.refuse(path, last.unwrap_or_default(), ground));
        }
        rows.retain(|row| row.passages >= before);
        rows.iter_mut().for_each(|row| row.passages -= before);
        Ok(SinceGround { rows, begins: first + before, before })
    }

    /// The level of each band at the date nearest to some passages.
    pub(super) fn nearest(&self, passages: f64) -> Vec<(ThirdOctave, f64)> {
        let mut bands: Vec<ThirdOctave> = self.rows.iter().map(|row| row.band).collect();
        bands.sort();
        bands.dedup();
        let away = |row: &&Row| (row.passages - passages).abs();
        let nearest = |band: ThirdOctave| {
            let own = self.rows.iter().filter(|row| row.band == band);
            let row = own.min_by(|one, other| away(one).total_cmp(&away(other)))?;
            Some((band, row.level))
        };
        bands.into_iter().filter_map(nearest).collect()
    }
}
