//! Levels of roughness at several dates, and runs of axle boxes over the same rail.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::f64::consts::TAU;
use std::path::Path;

use rand_xoshiro::Xoshiro256PlusPlus;
use riffel::forecast::{LINES_PER_BAND, band_lines};
use riffel::roughness::ThirdOctave;
use riffel_case::{Case, LoopOnTrack};
use riffel_keys::CaseError;

use super::{Block, Group, Held, differences, sums, table};
use crate::file::Kind;
use crate::gaussian::{Density, Gaussian};
use crate::kernel::Kernel;
use crate::linear::{Known, Normal};
use crate::matrix::Matrix;
use crate::model::Trial;
use crate::nuts::normal;

/// Passages of the unit of what the model misses of growth.
const UNIT: f64 = 1e6;
/// Fewest dates of which one can be left out: two of the rest tell of growth.
const LEAST_DATES: usize = 3;
/// dB from 1 µm to 1 m.
const MICROMETRE: f64 = 120.0;

/// Levels of a trolley.
#[derive(Clone)]
pub(crate) struct DatedLevels {
    pub(crate) view: usize,
    pub(crate) rows: Vec<Row>,
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
    level: f64,
    error: f64,
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
    pub(crate) fn rows(path: &Path, case: &Case) -> Result<Vec<Row>, CaseError> {
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
        Ok(rows)
    }
}

impl AxleBoxRun {
    pub(crate) fn rows(path: &Path, case: &Case, passages: f64) -> Result<Vec<Row>, CaseError> {
        let numbers = table::read(path, Kind::AxleBox.columns(), &[])?;
        rows(&numbers, path, case, |_| passages)
    }
}

/// Levels of one rail: y_tb = L_b + D_b(N_t) + N_t d_b + c_t + ε, L_b flat, and of runs over it what the axle box feels of the
/// same levels.
///
/// D_b = 10 lg mean exp(2 g_j N) over 16 lines of the band; an axle box feels 10 lg mean(exp(2 g_j N) |A/Δ|²_j) more, less 120
/// dB. A flat L_b is left out by contrasts with the first level of each band: C y, covariance C Σ Cᵀ.
pub(crate) struct Levels {
    rows: Vec<LevelRow>,
    /// Rows of a band with the one that they are compared with.
    contrasts: Vec<(usize, usize)>,
    lines: Vec<f64>,
    gaussian: Gaussian,
    bands: Vec<ThirdOctave>,
    /// Errors of the rows themselves.
    of_rows: Gaussian,
    /// L of the covariance LLᵀ over the bands of what is missed of growth, for a size of one; none where nothing is.
    missed: Option<Matrix>,
    /// What they were made of.
    measured: (DatedLevels, Vec<AxleBoxRun>),
}

/// The rail that levels tell of.
pub(crate) struct Rail {
    normal: Normal,
    /// dB per passage that is missed, by what is normal behind the levels.
    missed: Option<Matrix>,
}

/// A level with what its model needs.
struct LevelRow {
    row: Row,
    view: usize,
    /// Place of its band among the bands.
    band: usize,
    /// Which run it is of, and its speed \[m/s\]; none for a trolley.
    run: Option<(usize, f64)>,
}

impl Levels {
    /// None where errors are zero within rounding.
    pub(crate) fn new(dated: &DatedLevels, runs: &[AxleBoxRun]) -> Option<Self> {
        let mut bands: Vec<ThirdOctave> = dated.rows.iter().map(|row| row.band).collect();
        bands.extend(
            runs.iter()
                .flat_map(|run| run.rows.iter().map(|row| row.band)),
        );
        bands.sort();
        bands.dedup();
        let level = |row: &Row, view: usize, run: Option<(usize, f64)>| LevelRow {
            row: *row,
            view,
            band: bands.partition_point(|band| *band < row.band),
            run,
        };
        let own = dated.rows.iter().map(|row| level(row, dated.view, None));
        let mut rows: Vec<LevelRow> = own.collect();
        rows.sort_by(|a, b| a.row.passages.total_cmp(&b.row.passages));
        for (number, run) in runs.iter().enumerate() {
            let of_run = run.rows.iter();
            rows.extend(of_run.map(|row| level(row, run.view, Some((number, run.speed)))));
        }
        // Levels of a date share an error, and those of a run.
        let shared = |one: &LevelRow, other: &LevelRow| match (one.run, other.run) {
            (None, None) if one.row.passages == other.row.passages => dated.common_error,
            (Some((one, _)), Some((other, _))) if one == other => runs[one].common_error,
            _ => 0.0,
        };
        let noise = Matrix::of(rows.len(), |i, j| {
            let own = if i == j { rows[i].row.error } else { 0.0 };
            own.powi(2) + shared(&rows[i], &rows[j]).powi(2)
        });
        let kernel = |kernel: Kernel, one: &LevelRow, other: &LevelRow| match kernel {
            Kernel::Band => f64::from(u8::from(one.band == other.band)),
            kernel => kernel.at((one.row.band.wavelength() / other.row.band.wavelength()).ln()),
        };
        let missed = |of: &dyn Fn(&LevelRow, &LevelRow) -> f64| {
            Matrix::of(rows.len(), |i, j| of(&rows[i], &rows[j]))
        };
        // What is missed of growth, a run feels as well.
        let of_growth = dated.missed.map(|of_dates| {
            missed(&|one, other| {
                let passages = one.row.passages * other.row.passages;
                passages / (UNIT * UNIT) * kernel(of_dates, one, other)
            })
        });
        let of_runs = runs.iter().enumerate().filter_map(|(number, run)| {
            let of_run = run.missed?;
            let is_own = |row: &LevelRow| row.run.is_some_and(|(own, _)| own == number);
            Some(missed(&|one, other| match is_own(one) && is_own(other) {
                true => kernel(of_run, one, other),
                false => 0.0,
            }))
        });
        let of_runs: Vec<Matrix> = of_runs.collect();
        let of_rows = Gaussian::new(noise.clone(), of_runs.clone())?;
        let of_bands = dated.missed.map(|of_dates| {
            let distance = |i: usize, j: usize| bands[i].wavelength() / bands[j].wavelength();
            Matrix::of(bands.len(), |i, j| match of_dates {
                Kernel::Band => f64::from(u8::from(i == j)),
                // A smooth kernel is singular within rounding.
                kernel => kernel.at(distance(i, j).ln()) + if i == j { 1e-9 } else { 0.0 },
            })
        });
        let missed = match of_bands {
            Some(matrix) => Some(matrix.cholesky()?),
            None => None,
        };
        let of_size: Vec<Matrix> = of_growth.into_iter().chain(of_runs).collect();
        let first = |row: usize| (0..row).find(|other| rows[*other].band == rows[row].band);
        let contrasts: Vec<(usize, usize)> = (0..rows.len())
            .filter_map(|row| Some((row, first(row)?)))
            .collect();
        let contrast = |matrix: Matrix| {
            Matrix::of(contrasts.len(), |i, j| {
                let ((a, b), (c, d)) = (contrasts[i], contrasts[j]);
                matrix.at(a, c) - matrix.at(a, d) - matrix.at(b, c) + matrix.at(b, d)
            })
        };
        let of_size = of_size.into_iter().map(contrast);
        Some(Self {
            gaussian: Gaussian::new(contrast(noise), of_size.collect())?,
            contrasts,
            lines: band_lines(&bands),
            rows,
            bands,
            of_rows,
            missed,
            measured: (dated.clone(), runs.to_vec()),
        })
    }

    pub(crate) fn bands(&self) -> &[ThirdOctave] {
        &self.bands
    }

    /// Passages from the first date to the last.
    pub(crate) fn last(&self) -> f64 {
        let dates = self.measured.0.rows.iter().map(|row| row.passages);
        dates.fold(0.0, f64::max)
    }

    /// Passages of all dates and runs, in order.
    fn dates(&self) -> Vec<f64> {
        let mut dates: Vec<f64> = self.rows.iter().map(|row| row.row.passages).collect();
        dates.sort_by(f64::total_cmp);
        dates.dedup();
        dates
    }

    /// Growth rates of the amplitude of the lines of all bands, 16 each.
    pub(crate) fn rates(&self, trial: &Trial<'_>) -> Result<Vec<f64>, String> {
        trial.growth_rates(self.view(), &self.lines)
    }

    pub(crate) fn view(&self) -> usize {
        self.measured.0.view
    }

    /// What all levels say of the rail under values of the parameters: generalised least squares of L_b, and of d_b with what was
    /// known of it.
    pub(crate) fn rail(&self, trial: &Trial<'_>, sizes: &[f64]) -> Result<Rail, String> {
        let grown = self.levels(trial)?;
        let data: Vec<f64> = self
            .rows
            .iter()
            .zip(grown)
            .map(|(row, grown)| row.row.level - grown)
            .collect();
        let (of_growth, of_runs) = sizes.split_at(usize::from(self.missed.is_some()));
        let covariance = self.of_rows.covariance(of_runs);
        let missed = self
            .missed
            .as_ref()
            .zip(of_growth.first())
            .map(|(lower, size)| Matrix {
                values: lower.values.iter().map(|it| it * size / UNIT).collect(),
                ..*lower
            });
        let bands = 0..self.bands.len();
        let column =
            |value: &dyn Fn(&LevelRow) -> f64| self.rows.iter().map(value).collect::<Vec<f64>>();
        let mut columns: Vec<Vec<f64>> = (bands.clone())
            .map(|band| column(&|row| f64::from(u8::from(row.band == band))))
            .collect();
        let mut known = vec![Known::default(); self.bands.len()];
        if let Some(missed) = &missed {
            columns.extend(bands.map(|w| column(&|row| row.row.passages * missed.at(row.band, w))));
            known.resize(
                2 * self.bands.len(),
                Known {
                    mean: 0.0,
                    precision: 1.0,
                },
            );
        }
        let beyond = "the errors of the levels are beyond numbers";
        let noise = covariance.cholesky().ok_or(beyond)?;
        let normal = Normal::after(&known, &columns, &noise, &data).ok_or(beyond)?;
        Ok(Rail { normal, missed })
    }

    /// The levels above L_b that the model says of all rows \[dB\].
    fn levels(&self, trial: &Trial<'_>) -> Result<Vec<f64>, String> {
        let (mut rates, mut felt) = (BTreeMap::new(), BTreeMap::new());
        let level = |row: &LevelRow| {
            let grows = || trial.growth_rates(row.view, &self.lines);
            let rates = once(&mut rates, row.view, grows)?;
            let own = row.band * LINES_PER_BAND..(row.band + 1) * LINES_PER_BAND;
            let grown = rates[own.clone()]
                .iter()
                .map(|g| (2.0 * g * row.row.passages).exp());
            let (mean, less) = match row.run {
                None => (grown.sum::<f64>(), 0.0),
                Some((run, speed)) => {
                    let shakes = || Ok(accelerations(trial.case(row.view)?, &self.lines, speed));
                    let felt = once(&mut felt, run, shakes)?;
                    let energies = grown.zip(&felt[own]).map(|(grown, felt)| grown * felt);
                    (energies.sum::<f64>(), MICROMETRE)
                }
            };
            Ok(10.0 * (mean / LINES_PER_BAND as f64).log10() - less)
        };
        self.rows.iter().map(level).collect()
    }

    fn contrast(&self, levels: &[f64]) -> Vec<f64> {
        let contrasts = self.contrasts.iter();
        contrasts
            .map(|(row, first)| levels[*row] - levels[*first])
            .collect()
    }
}

impl Rail {
    /// One draw, from draws of mean 0 and variance 1: levels at the first date \[dB\], and what is missed of growth \[dB per passage\].
    pub(crate) fn draw(&self, mut normal: impl FnMut() -> f64) -> (Vec<f64>, Vec<f64>) {
        let count = self.normal.mean.len();
        let mut drawn = self
            .normal
            .draw(&(0..count).map(|_| normal()).collect::<Vec<f64>>());
        match &self.missed {
            None => {
                let nothing = vec![0.0; count];
                (drawn, nothing)
            }
            Some(missed) => {
                let behind = drawn.split_off(count / 2);
                (drawn, missed.times(&behind))
            }
        }
    }
}

/// The values of a key, made where they are not known yet.
fn once(
    known: &mut BTreeMap<usize, Vec<f64>>,
    key: usize,
    make: impl FnOnce() -> Result<Vec<f64>, String>,
) -> Result<&[f64], String> {
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

    fn density(&self, predicted: &[f64], sizes: &[f64]) -> Option<Density> {
        let residuals = differences(&self.observed(), predicted);
        self.gaussian.density(&residuals, sizes)
    }

    fn of_each(&self, predicted: &[f64], sizes: &[f64]) -> Option<Vec<f64>> {
        self.gaussian
            .of_each(&differences(&self.observed(), predicted), sizes)
    }

    fn replicate(
        &self,
        predicted: &[f64],
        sizes: &[f64],
        random: &mut Xoshiro256PlusPlus,
    ) -> Option<Vec<f64>> {
        let errors = self.gaussian.draw(sizes, || normal(random))?;
        Some(sums(predicted, &errors))
    }

    /// The first level of each band stays.
    fn with_data(&self, contrasts: &[f64]) -> Option<Box<dyn Block>> {
        let mut levels: Vec<f64> = self.rows.iter().map(|row| row.row.level).collect();
        for ((row, first), contrast) in self.contrasts.iter().zip(contrasts) {
            levels[*row] = levels[*first] + contrast;
        }
        let (mut dated, mut runs) = self.measured.clone();
        dated.rows.clear();
        runs.iter_mut().for_each(|run| run.rows.clear());
        for (row, level) in self.rows.iter().zip(levels) {
            let rows = match row.run {
                None => &mut dated.rows,
                Some((run, _)) => &mut runs[run].rows,
            };
            rows.push(Row { level, ..row.row });
        }
        Some(Box::new(Self::new(&dated, &runs)?))
    }

    fn views(&self) -> Vec<usize> {
        let mut views: Vec<usize> = self.rows.iter().map(|row| row.view).collect();
        views.dedup();
        views
    }

    fn observed(&self) -> Vec<f64> {
        let levels: Vec<f64> = self.rows.iter().map(|row| row.row.level).collect();
        self.contrast(&levels)
    }

    fn covariance(&self, sizes: &[f64], times: f64) -> Matrix {
        self.gaussian.covariance_of_mean(sizes, times)
    }

    fn as_levels(&self) -> Option<&Levels> {
        Some(self)
    }

    /// The dates, where two are left without one of them; a run is of its date. Levels of the rest are compared with the first that
    /// is left of their band.
    fn groups(&self) -> Vec<Group> {
        let dates = self.dates();
        if dates.len() < LEAST_DATES {
            return vec![Group::all(self.contrasts.len())];
        }
        let contrast = |row: usize| self.contrasts.iter().position(|it| it.0 == row);
        let group = |date: &f64| {
            let is_own = |row: usize| self.rows[row].row.passages == *date;
            let base = |band: usize| {
                let mut of_band = (0..self.rows.len()).filter(|row| self.rows[*row].band == band);
                let first = of_band.clone().next();
                of_band.find(|row| !is_own(*row)).or(first)
            };
            let bases: Vec<Option<usize>> = (0..self.bands.len()).map(base).collect();
            let others: Vec<(usize, usize)> = (0..self.rows.len())
                .filter_map(|row| Some((row, bases[self.rows[row].band]?)))
                .filter(|(row, base)| row != base)
                .collect();
            let own = others.iter().enumerate();
            Group {
                held: Held::Date(*date),
                own: own
                    .filter_map(|(place, (row, _))| is_own(*row).then_some(place))
                    .collect(),
                basis: others
                    .into_iter()
                    .map(|(row, base)| (contrast(row), contrast(base)))
                    .collect(),
            }
        };
        dates.iter().map(group).collect()
    }

    fn without(&self, held: Held) -> Option<Box<dyn Block>> {
        let Held::Date(date) = held else { return None };
        let (mut dated, mut runs) = self.measured.clone();
        dated.rows.retain(|row| row.passages != date);
        runs.iter_mut()
            .for_each(|run| run.rows.retain(|row| row.passages != date));
        Some(Box::new(Self::new(&dated, &runs)?))
    }

    /// One more date, as long after the last as that is after the one before, with its bands and errors.
    fn once_more(&self) -> Option<Box<dyn Block>> {
        let (mut dated, runs) = self.measured.clone();
        let last = self.last();
        let before = dated
            .rows
            .iter()
            .map(|row| row.passages)
            .filter(|it| *it < last);
        let next = 2.0 * last - before.fold(0.0, f64::max);
        let rows: Vec<Row> = dated
            .rows
            .iter()
            .filter(|row| row.passages == last)
            .copied()
            .collect();
        dated.rows.extend(rows.into_iter().map(|row| Row {
            passages: next,
            ..row
        }));
        Some(Box::new(Self::new(&dated, &runs)?))
    }
}
