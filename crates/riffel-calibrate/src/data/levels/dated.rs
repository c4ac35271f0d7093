//! Levels by a trolley at several dates.

use std::path::Path;

use riffel::roughness::ThirdOctave;
use riffel_case::Case;
use riffel_keys::CaseError;

use super::row::{self, Row};
use super::table;
use crate::file::Kind;
use crate::kernel::Kernel;

/// Levels of a trolley.
#[derive(Clone)]
pub(crate) struct DatedLevels {
    pub(crate) view: usize,
    pub(crate) rows: Vec<Row>,
    /// What was counted at the first date.
    pub(crate) begins: f64,
    /// Standard deviation of the level that the bands of a date share \[dB\].
    pub(crate) common_error: f64,
    pub(crate) missed: Option<Kernel>,
}

impl DatedLevels {
    /// The rows of a table, and the passages that were counted at the first date.
    pub(crate) fn rows(path: &Path, case: &Case) -> Result<(Vec<Row>, f64), CaseError> {
        let numbers = table::read(path, Kind::DatedLevels.columns(), &[])?;
        let passages = &numbers.needed[3];
        let first = passages.iter().copied().fold(f64::INFINITY, f64::min);
        let rows = row::rows(&numbers, path, case, |row| passages[row] - first)?;
        if rows.iter().all(|row| row.passages == 0.0) {
            let message = "all levels are of one date, which says nothing of growth; measure again, or leave the file out";
            return Err(numbers.refuse(path, 0, message));
        }
        for (index, row) in rows.iter().enumerate() {
            let same = |other: &Row| (other.band, other.passages) == (row.band, row.passages);
            if rows[..index].iter().any(same) {
                return Err(numbers.refuse(path, index, "the band of this date is there already"));
            }
        }
        Ok((rows, first))
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
