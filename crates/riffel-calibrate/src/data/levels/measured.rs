//! Levels of one rail as they were measured: by a trolley at several dates, by axle boxes and beside the track.

use std::path::Path;

use riffel::roughness::ThirdOctave;
use riffel_case::Case;
use riffel_keys::CaseError;

use super::pass_by::PassBys;
use super::{LevelRow, table};
use crate::file::Kind;
use crate::kernel::Kernel;

/// All that was measured of a rail.
#[derive(Clone)]
pub(crate) struct MeasuredRail {
    pub(crate) dated: DatedLevels,
    pub(crate) runs: Vec<AxleBoxRun>,
    pub(crate) pass_bys: Vec<PassBys>,
}

/// Where a level stands in what was measured: its row, of a run or a site by its number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum RowPlace {
    Dated(usize),
    Run(usize, usize),
    PassBy(usize, usize),
}

impl MeasuredRail {
    /// The bands that have levels, in order.
    pub(super) fn bands(&self) -> Vec<ThirdOctave> {
        let of_runs = self.runs.iter().flat_map(|run| &run.rows);
        let rows = self.dated.rows.iter().chain(of_runs);
        let mut bands: Vec<ThirdOctave> = rows.map(|row| row.band).collect();
        bands.sort();
        bands.dedup();
        bands
    }

    /// Its levels: by date, then those of runs, then those that were heard.
    pub(super) fn rows(&self, bands: &[ThirdOctave]) -> Vec<LevelRow> {
        let place_of = |band: ThirdOctave| bands.partition_point(|other| *other < band);
        let level = |row: &Row, view: usize, place: RowPlace| LevelRow {
            place,
            view,
            passages: row.passages,
            level: row.level,
            error: row.error,
            bands: vec![(place_of(row.band), 1.0)],
        };
        let own = self.dated.rows.iter().enumerate();
        let own = own.map(|(index, row)| level(row, self.dated.view, RowPlace::Dated(index)));
        let mut rows: Vec<LevelRow> = own.collect();
        rows.sort_by(|a, b| a.passages.total_cmp(&b.passages));
        for (number, run) in self.runs.iter().enumerate() {
            let of_run = run.rows.iter().enumerate();
            rows.extend(
                of_run.map(|(index, row)| level(row, run.view, RowPlace::Run(number, index))),
            );
        }
        for (number, pass_bys) in self.pass_bys.iter().enumerate() {
            let heard = pass_bys.rows.iter().enumerate();
            rows.extend(heard.map(|(index, row)| {
                LevelRow {
                    place: RowPlace::PassBy(number, index),
                    view: pass_bys.view,
                    passages: row.passages,
                    level: row.level,
                    error: row.error,
                    bands: (row.shares.iter())
                        .map(|(band, share)| (place_of(*band), *share))
                        .collect(),
                }
            }));
        }
        rows
    }

    pub(super) fn level_mut(&mut self, place: RowPlace) -> &mut f64 {
        match place {
            RowPlace::Dated(row) => &mut self.dated.rows[row].level,
            RowPlace::Run(run, row) => &mut self.runs[run].rows[row].level,
            RowPlace::PassBy(site, row) => &mut self.pass_bys[site].rows[row].level,
        }
    }
}

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

/// Levels of acceleration on an axle box.
#[derive(Clone)]
pub(crate) struct AxleBoxRun {
    pub(crate) view: usize,
    pub(crate) rows: Vec<Row>,
    /// \[m/s\]
    pub(crate) speed: f64,
    pub(crate) common_error: f64,
    pub(crate) missed: Option<Kernel>,
}

/// One level.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Row {
    pub(crate) band: ThirdOctave,
    /// Since the first date.
    pub(crate) passages: f64,
    /// \[dB\]
    pub(super) level: f64,
    pub(super) error: f64,
}

/// That the wavelengths of a table lie in the window of the case, as bands.
fn bands(
    numbers: &table::Numbers,
    path: &Path,
    case: &Case,
) -> Result<Vec<ThirdOctave>, CaseError> {
    let (shortest, longest) = (case.wavelength.min(), case.wavelength.max());
    let bands = numbers.needed[0].iter().enumerate();
    bands
        .map(|(row, millimetres)| {
            let refuse = |message: String| numbers.refuse(path, row, &message);
            let band = ThirdOctave::centred(1e-3 * millimetres);
            let band = band.map_err(|_| {
                refuse(format!("`wavelength_mm` is {millimetres}, but must be the centre of a one-third octave"))
            })?;
            if band.wavelength() < shortest || band.wavelength() > longest {
                return Err(refuse(format!(
                    "`wavelength_mm` is {millimetres}, outside the window of the case, map.wavelength from {:.1} to {:.1} mm",
                    1e3 * shortest,
                    1e3 * longest
                )));
            }
            Ok(band)
        })
        .collect()
}

/// The levels of a table, each with its passages.
fn rows(
    numbers: &table::Numbers,
    path: &Path,
    case: &Case,
    passages: impl Fn(usize) -> f64,
) -> Result<Vec<Row>, CaseError> {
    let bands = bands(numbers, path, case)?;
    let [level, error] = [1, 2].map(|column| &numbers.needed[column]);
    let rule = "must be greater than zero";
    numbers.check(path, "standard_error_db", error, rule, |e| e > 0.0)?;
    let row = |(row, band)| Row {
        band,
        passages: passages(row),
        level: level[row],
        error: error[row],
    };
    Ok(bands.into_iter().enumerate().map(row).collect())
}

impl DatedLevels {
    /// The rows of a table, and the passages that were counted at the first date.
    pub(crate) fn rows(path: &Path, case: &Case) -> Result<(Vec<Row>, f64), CaseError> {
        let numbers = table::read(path, Kind::DatedLevels.columns(), &[])?;
        let passages = &numbers.needed[3];
        let first = passages.iter().copied().fold(f64::INFINITY, f64::min);
        let rows = rows(&numbers, path, case, |row| passages[row] - first)?;
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
}

impl DatedLevels {
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

impl AxleBoxRun {
    pub(crate) fn rows(path: &Path, case: &Case, passages: f64) -> Result<Vec<Row>, CaseError> {
        let numbers = table::read(path, Kind::AxleBox.columns(), &[])?;
        rows(&numbers, path, case, |_| passages)
    }
}
