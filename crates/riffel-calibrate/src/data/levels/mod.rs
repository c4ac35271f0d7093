//! Levels of roughness at several dates, runs of axle boxes over the same rail, and trains that pass beside it.

mod axle_box;
mod dated;
mod measured;
mod pass_by;
mod rail;
mod row;

pub(crate) use axle_box::AxleBoxRun;
pub(crate) use dated::{DatedLevels, SinceGround};
pub(crate) use measured::MeasuredRail;
pub(crate) use pass_by::{PassBys, Passage, Train};

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::f64::consts::TAU;

use riffel::forecast::{LINES_PER_BAND, band_lines};
use riffel::roughness::ThirdOctave;
use riffel_case::LoopOnTrack;
use riffel_noise::BandRadiation;
use riffel_numerics::matrix::Matrix;

use self::measured::{LevelRow, RowPlace, Weights};
use self::pass_by::Passing;
use self::row::Row;
use super::{Block, Group, Held, Observable, Place, UNIT, sum_of, table};
use crate::gaussian::Gaussian;
use crate::kernel::Kernel;
use crate::model::Trial;

/// Fewest dates of which one can be left out: two of the rest tell of growth.
const LEAST_DATES: usize = 3;
/// dB from 1 µm to 1 m.
const MICROMETRE: f64 = 120.0;

/// Levels of one rail: y_tb = L_b + D_b(N_t) + N_t d_b + c_t + ε, L_b flat, of runs over it what the axle box feels of the same
/// levels, and of trains beside it what is heard of them.
///
/// D_b = 10 lg mean exp(2 g_j N) over 16 lines of the band; an axle box feels 10 lg mean(exp(2 g_j N) |A/Δ|²_j) more, less 120
/// dB. What is heard is taken to change with each L_b by the share of its band, about the levels that were measured. A flat L_b is
/// left out by contrasts with the first level of each band: C y, covariance C Σ Cᵀ.
pub(crate) struct Levels {
    rows: Vec<LevelRow>,
    /// Rows with what they are compared with: the first levels of their bands, by weight.
    contrasts: Vec<(usize, Weights)>,
    lines: Vec<f64>,
    gaussian: Gaussian,
    bands: Vec<ThirdOctave>,
    /// Errors of the rows themselves.
    of_rows: Gaussian,
    /// L of the covariance LLᵀ over the bands of what is missed of growth, for a size of one; `None` if nothing is.
    missed: Option<Matrix>,
    /// What they were made of.
    measured: MeasuredRail,
}

impl Levels {
    /// `None` if errors are zero within rounding.
    pub(crate) fn new(measured: &MeasuredRail) -> Option<Self> {
        let MeasuredRail { dated, runs, .. } = measured;
        let bands = measured.bands();
        let rows = measured.rows(&bands);
        let noise = Matrix::of(rows.len(), |i, j| {
            let own = if i == j { rows[i].error } else { 0.0 };
            own.powi(2) + measured.shared_error(&rows[i], &rows[j]).powi(2)
        });
        let of_bands = |kernel: Kernel, one: usize, other: usize| match kernel {
            Kernel::Band => f64::from(u8::from(one == other)),
            kernel => kernel.at((bands[one].wavelength() / bands[other].wavelength()).ln()),
        };
        let kernel = |kernel: Kernel, one: &LevelRow, other: &LevelRow| -> f64 {
            let pairs = one.bands.iter();
            let pairs = pairs.flat_map(|one| other.bands.iter().map(move |other| (one, other)));
            pairs.map(|((one, a), (other, b))| a * b * of_bands(kernel, *one, *other)).sum()
        };
        let missed = |of: &dyn Fn(&LevelRow, &LevelRow) -> f64| Matrix::of(rows.len(), |i, j| of(&rows[i], &rows[j]));
        // What is missed of growth, a run feels as well, and a receiver hears it.
        let of_growth = dated.missed.map(|of_dates| {
            missed(&|one, other| {
                let passages = one.passages * other.passages;
                passages / (UNIT * UNIT) * kernel(of_dates, one, other)
            })
        });
        let of_runs = runs.iter().enumerate().filter_map(|(number, run)| {
            let of_run = run.missed?;
            let is_own = |row: &LevelRow| matches!(row.place, RowPlace::Run(own, _) if own == number);
            Some(missed(&|one, other| match is_own(one) && is_own(other) {
                true => kernel(of_run, one, other),
                false => 0.0,
            }))
        });
        let of_runs: Vec<Matrix> = of_runs.collect();
        let of_rows = Gaussian::new(noise.clone(), of_runs.clone())?;
        let over_bands = dated.missed.map(|of_dates| {
            Matrix::of(bands.len(), |i, j| {
                // A smooth kernel is singular within rounding.
                let rounding = if i == j && of_dates != Kernel::Band { 1e-9 } else { 0.0 };
                of_bands(of_dates, i, j) + rounding
            })
        });
        let missed = match over_bands {
            Some(matrix) => Some(matrix.cholesky()?),
            None => None,
        };
        let of_size: Vec<Matrix> = of_growth.into_iter().chain(of_runs).collect();
        let contrasts = contrasts(&rows, bands.len())?;
        let terms: Vec<Weights> = contrasts
            .iter()
            .map(|(row, firsts)| {
                let less = firsts.iter().map(|(first, weight)| (*first, -weight));
                std::iter::once((*row, 1.0)).chain(less).collect()
            })
            .collect();
        let of_size = of_size.into_iter().map(|matrix| matrix.of_sums(&terms));
        Some(Self {
            gaussian: Gaussian::new(noise.of_sums(&terms), of_size.collect())?,
            contrasts,
            lines: band_lines(&bands),
            rows,
            bands,
            of_rows,
            missed,
            measured: measured.clone(),
        })
    }

    /// That of the band of a row.
    fn wavelength(&self, row: &LevelRow) -> f64 {
        let band = row.bands.first();
        band.map_or(f64::NAN, |(band, _)| self.bands[*band].wavelength())
    }

    pub(crate) fn bands(&self) -> &[ThirdOctave] {
        &self.bands
    }

    /// Passages from the first date to the last.
    pub(crate) fn last(&self) -> f64 {
        let dates = self.measured.dated.rows.iter().map(|row| row.passages);
        dates.fold(0.0, f64::max)
    }

    /// Passages of all dates and runs, in order.
    fn dates(&self) -> Vec<f64> {
        let mut dates: Vec<f64> = self.rows.iter().map(|row| row.passages).collect();
        dates.sort_by(f64::total_cmp);
        dates.dedup();
        dates
    }

    /// Growth rates of the amplitude of the lines of all bands, 16 each.
    pub(crate) fn rates(&self, trial: &Trial<'_>) -> Result<Vec<f64>, String> {
        trial.growth_rates(self.view(), &self.lines)
    }

    pub(crate) fn view(&self) -> usize {
        self.measured.dated.view
    }

    /// The levels above L_b that the model says of all rows \[dB\], of what is heard above its share of L_b: about the L_b that the
    /// first levels tell.
    fn levels(&self, trial: &Trial<'_>) -> Result<Vec<f64>, String> {
        // The rail grows as the trolley finds it, whatever else differs for those that feel or hear it.
        let rates = self.rates(trial)?;
        let (mut shaken, mut radiated) = Default::default();
        let mut levels: Vec<f64> = Vec::new();
        // The level of each band at the first date, from the first row of it.
        let mut first: Vec<Option<f64>> = vec![None; self.bands.len()];
        for row in &self.rows {
            let grown = |band: usize| {
                let own = &rates[band * LINES_PER_BAND..(band + 1) * LINES_PER_BAND];
                own.iter().map(|g| (2.0 * g * row.passages).exp())
            };
            let mean = |energies: f64| 10.0 * (energies / LINES_PER_BAND as f64).log10();
            levels.push(match (row.place, &row.bands[..]) {
                (RowPlace::Run(run, _), [(band, _)]) => {
                    let speed = self.measured.runs[run].speed;
                    let shakes = || Ok(accelerations(trial.case(row.view)?, &self.lines, speed));
                    let shaken = &once(&mut shaken, run, shakes)?[band * LINES_PER_BAND..];
                    let energies = grown(*band).zip(shaken).map(|(grown, shaken)| grown * shaken);
                    mean(energies.sum()) - MICROMETRE
                }
                (RowPlace::PassBy(site, pass), bands) => {
                    let pass_bys = &self.measured.pass_bys[site];
                    let Passing { speed, audible, .. } = &pass_bys.rows[pass];
                    let key = (site, speed.to_bits());
                    let radiates = || trial.radiation(row.view, *speed, audible);
                    let radiation: &[BandRadiation] = once(&mut radiated, key, radiates)?;
                    let of_bands = bands.iter().map(|(band, _)| {
                        let first = first[*band].unwrap_or_default();
                        (self.bands[*band], first + mean(grown(*band).sum()))
                    });
                    let level = pass_bys.train.level(radiation, *speed, of_bands)?;
                    let of_first = bands.iter().map(|(band, w)| w * first[*band].unwrap_or_default());
                    level - of_first.sum::<f64>()
                }
                (_, bands) => bands.iter().map(|(band, w)| w * mean(grown(*band).sum())).sum(),
            });
            if let ([(band, _)], Some(level)) = (&row.bands[..], levels.last()) {
                // Rows of what is heard stand behind the others.
                first[*band].get_or_insert(row.level - level);
            }
        }
        Ok(levels)
    }

    fn contrast(&self, levels: &[f64]) -> Vec<f64> {
        let contrasts = self.contrasts.iter();
        contrasts.map(|(row, firsts)| levels[*row] - sum_of(levels, firsts)).collect()
    }
}

/// The rows that are no first level of a band, each with the first levels that it is compared with; `None` if a band has none.
fn contrasts(rows: &[LevelRow], bands: usize) -> Option<Vec<(usize, Weights)>> {
    let firsts: Vec<usize> =
        (0..bands).map(|band| rows.iter().position(|row| row.is_of(band))).collect::<Option<_>>()?;
    let compared = |row: usize| {
        let bands = rows[row].bands.iter();
        (row, bands.map(|(band, w)| (firsts[*band], *w)).collect())
    };
    let others = (0..rows.len()).filter(|row| !firsts.contains(row));
    Some(others.map(compared).collect())
}

/// The values of a key, made where they are not known yet.
fn once<K: Ord, V>(
    known: &mut BTreeMap<K, Vec<V>>,
    key: K,
    make: impl FnOnce() -> Result<Vec<V>, String>,
) -> Result<&[V], String> {
    Ok(match known.entry(key) {
        Entry::Occupied(entry) => entry.into_mut(),
        Entry::Vacant(entry) => entry.insert(make()?),
    })
}

/// |A/Δ|² of the axle box \[1/s⁴\] over wavelengths \[m\] at a speed \[m/s\]: the wheel as one mass.
fn accelerations(case: &LoopOnTrack, lines: &[f64], speed: f64) -> Vec<f64> {
    let lines = lines.iter();
    lines
        .map(|wavelength| {
            let w = TAU * speed / wavelength;
            let [track, wheel] = case.feedback.normal_receptances(w, speed);
            let contact = case.feedback.contacts()[0].stiffness;
            (w * w * wheel / (track + wheel + contact.recip())).norm_sqr()
        })
        .collect()
}

impl Block for Levels {
    fn predict(&self, trial: &Trial<'_>) -> Result<Vec<f64>, String> {
        Ok(self.contrast(&self.levels(trial)?))
    }

    fn gaussian(&self) -> Option<&Gaussian> {
        Some(&self.gaussian)
    }

    /// The first level of each band stays.
    fn with_data(&self, contrasts: &[f64]) -> Option<Box<dyn Block>> {
        let levels: Vec<f64> = self.rows.iter().map(|row| row.level).collect();
        let mut measured = self.measured.clone();
        for ((row, firsts), contrast) in self.contrasts.iter().zip(contrasts) {
            let level = contrast + sum_of(&levels, firsts);
            *measured.level_mut(self.rows[*row].place) = level;
        }
        Some(Box::new(Self::new(&measured)?))
    }

    fn views(&self) -> Vec<usize> {
        let mut views: Vec<usize> = self.rows.iter().map(|row| row.view).collect();
        views.dedup();
        views
    }

    fn observed(&self) -> Vec<f64> {
        let levels: Vec<f64> = self.rows.iter().map(|row| row.level).collect();
        self.contrast(&levels)
    }

    fn places(&self) -> Vec<Place> {
        let place = |(row, _): &(usize, Weights)| {
            let row = &self.rows[*row];
            let (measured, at, of) = match row.place {
                RowPlace::PassBy(..) => (Observable::PassByLevelDb, row.passages, None),
                RowPlace::Run(..) => (Observable::AxleBoxLevelDb, self.wavelength(row), Some(row.passages)),
                RowPlace::Dated(_) => (Observable::LevelRiseDb, self.wavelength(row), Some(row.passages)),
            };
            Place { measured, at, of }
        };
        self.contrasts.iter().map(place).collect()
    }

    fn covariance(&self, sizes: &[f64], times: f64) -> Matrix {
        self.gaussian.covariance_of_mean(sizes, times)
    }

    fn as_levels(&self) -> Option<&Levels> {
        Some(self)
    }

    /// The dates, where two are left without one of them; a run is of its date, and so is what was heard. Levels of the rest are
    /// compared with the first that is left of their band.
    fn groups(&self) -> Vec<Group> {
        let dates = self.dates();
        if dates.len() < LEAST_DATES {
            return vec![Group::all(self.contrasts.len())];
        }
        let contrast = |row: usize| self.contrasts.iter().position(|it| it.0 == row);
        let group = |date: &f64| {
            let is_own = |row: usize| self.rows[row].passages == *date;
            let base = |band: usize| {
                let mut of_band = (0..self.rows.len()).filter(|row| self.rows[*row].is_of(band));
                let first = of_band.clone().next();
                of_band.find(|row| !is_own(*row)).or(first)
            };
            let bases: Vec<Option<usize>> = (0..self.bands.len()).map(base).collect();
            let (mut basis, mut own) = (Vec::new(), Vec::new());
            for row in (0..self.rows.len()).filter(|row| !bases.contains(&Some(*row))) {
                let bands = self.rows[row].bands.iter();
                let compared = bands.filter_map(|(band, w)| Some((bases[*band]?, *w)));
                let compared: Vec<(usize, f64)> = compared.collect();
                // What needs a level of this date, goes with it.
                if is_own(row) || compared.iter().any(|(base, _)| is_own(*base)) {
                    own.push(basis.len());
                }
                let less = compared.into_iter().map(|(base, w)| (base, -w));
                let terms = std::iter::once((row, 1.0)).chain(less);
                basis.push(terms.filter_map(|(row, w)| Some((contrast(row)?, w))).collect());
            }
            Group { held: Held::Date(*date), own, basis }
        };
        dates.iter().map(group).collect()
    }

    fn without(&self, held: Held) -> Option<Box<dyn Block>> {
        let Held::Date(date) = held else { return None };
        let mut measured = self.measured.clone();
        measured.dated.rows.retain(|row| row.passages != date);
        for run in &mut measured.runs {
            run.rows.retain(|row| row.passages != date);
        }
        let bands = measured.bands();
        for pass_bys in &mut measured.pass_bys {
            // What is heard of a band that is gone is not known.
            let is_left = |(band, _): &(ThirdOctave, f64)| bands.contains(band);
            let keep = |row: &Passing| row.passages != date && row.shares.iter().all(is_left);
            pass_bys.rows.retain(keep);
        }
        Some(Box::new(Self::new(&measured)?))
    }

    /// One more date, as long after the last as that is after the one before, with its bands and errors.
    fn once_more(&self) -> Option<Box<dyn Block>> {
        let mut measured = self.measured.clone();
        let rows = &mut measured.dated.rows;
        let last = self.last();
        let before = rows.iter().map(|row| row.passages).filter(|it| *it < last);
        let next = 2.0 * last - before.fold(0.0, f64::max);
        let of_last: Vec<Row> = rows.iter().filter(|row| row.passages == last).copied().collect();
        rows.extend(of_last.into_iter().map(|row| Row { passages: next, ..row }));
        Some(Box::new(Self::new(&measured)?))
    }
}

#[cfg(test)]
mod tests;
