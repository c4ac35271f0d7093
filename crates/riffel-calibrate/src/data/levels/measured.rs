//! Levels of one rail as they were measured: by a trolley at several dates, by axle boxes and beside the track.

use riffel::roughness::ThirdOctave;

use super::axle_box::AxleBoxRun;
use super::dated::DatedLevels;
use super::pass_by::PassBys;
use super::row::Row;

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
            rows.extend(of_run.map(|(index, row)| level(row, run.view, RowPlace::Run(number, index))));
        }
        for (number, pass_bys) in self.pass_bys.iter().enumerate() {
            let passes = pass_bys.rows.iter().enumerate();
            rows.extend(passes.map(|(index, row)| LevelRow {
                place: RowPlace::PassBy(number, index),
                view: pass_bys.view,
                passages: row.passages,
                level: row.level,
                error: row.error,
                bands: (row.shares.iter()).map(|(band, share)| (place_of(*band), *share)).collect(),
            }));
        }
        rows
    }

    /// Standard deviation of what two levels share \[dB\]: those of a date, of a run or of a site.
    pub(super) fn shared_error(&self, one: &LevelRow, other: &LevelRow) -> f64 {
        match (one.place, other.place) {
            (RowPlace::Dated(_), RowPlace::Dated(_)) if one.passages == other.passages => self.dated.common_error,
            (RowPlace::Run(one, _), RowPlace::Run(other, _)) if one == other => self.runs[one].common_error,
            (RowPlace::PassBy(one, _), RowPlace::PassBy(other, _)) if one == other => self.pass_bys[one].common_error,
            _ => 0.0,
        }
    }

    pub(super) fn level_mut(&mut self, place: RowPlace) -> &mut f64 {
        match place {
            RowPlace::Dated(row) => &mut self.dated.rows[row].level,
            RowPlace::Run(run, row) => &mut self.runs[run].rows[row].level,
            RowPlace::PassBy(site, row) => &mut self.pass_bys[site].rows[row].level,
        }
    }
}

/// Places, each with its weight.
pub(super) type Weights = Vec<(usize, f64)>;

/// A level with what its model needs.
pub(super) struct LevelRow {
    /// Where it stands in what was measured.
    pub(super) place: RowPlace,
    pub(super) view: usize,
    /// Since the first date.
    pub(super) passages: f64,
    /// \[dB\]
    pub(super) level: f64,
    pub(super) error: f64,
    /// The bands that it is of, by how it changes with them.
    pub(super) bands: Weights,
}

impl LevelRow {
    /// Its share of a band.
    pub(super) fn share(&self, band: usize) -> f64 {
        let own = self.bands.iter().filter(|(own, _)| *own == band);
        own.map(|(_, weight)| weight).sum()
    }

    /// Whether it is the level of a band, and of no other.
    pub(super) fn is_of(&self, band: usize) -> bool {
        matches!(self.bands[..], [(own, _)] if own == band) && !matches!(self.place, RowPlace::PassBy(..))
    }
}
