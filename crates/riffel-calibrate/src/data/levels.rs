//! Levels of roughness at several dates, and runs of axle boxes over the same rail.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::path::Path;

use riffel::forecast::{LINES_PER_BAND, band_lines};
use riffel::roughness::ThirdOctave;
use riffel_case::{Case, LoopOnTrack};
use riffel_keys::CaseError;

use super::{Block, table};
use crate::gaussian::{Density, Gaussian};
use crate::kernel::Kernel;
use crate::matrix::Matrix;
use crate::model::Trial;

/// Passages of the unit of what the model misses of growth.
const UNIT: f64 = 1e6;
/// dB from 1 µm to 1 m.
const MICROMETRE: f64 = 120.0;

/// Levels of a trolley.
pub(crate) struct DatedLevels {
    pub(crate) view: usize,
    pub(crate) rows: Vec<Row>,
    /// Standard deviation of the level that the bands of a date share \[dB\].
    pub(crate) common_error: f64,
    pub(crate) missed: Option<Kernel>,
}

/// Levels of acceleration on an axle box.
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

impl DatedLevels {
    pub(crate) fn rows(path: &Path, case: &Case) -> Result<Vec<Row>, CaseError> {
        let columns = ["wavelength_mm", "level_db", "standard_error_db", "passages"];
        let numbers = table::read(path, &columns, &[])?;
        let bands = bands(&numbers, path, case)?;
        let [level, error, passages] = [1, 2, 3].map(|column| &numbers.needed[column]);
        numbers.check(
            path,
            "standard_error_db",
            error,
            "must be greater than zero",
            |e| e > 0.0,
        )?;
        let first = passages.iter().copied().fold(f64::INFINITY, f64::min);
        if passages.iter().all(|n| *n == first) {
            let message = "all levels are of one date, which says nothing of growth; measure again, or leave the file out";
            return Err(numbers.refuse(path, 0, message));
        }
        let rows: Vec<Row> = (0..bands.len())
            .map(|row| Row {
                band: bands[row],
                passages: passages[row] - first,
                level: level[row],
                error: error[row],
            })
            .collect();
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
        let columns = [
            "wavelength_mm",
            "level_db_re_1_m_per_s2",
            "standard_error_db",
        ];
        let numbers = table::read(path, &columns, &[])?;
        let bands = bands(&numbers, path, case)?;
        let [level, error] = [1, 2].map(|column| &numbers.needed[column]);
        numbers.check(
            path,
            "standard_error_db",
            error,
            "must be greater than zero",
            |e| e > 0.0,
        )?;
        Ok((0..bands.len())
            .map(|row| Row {
                band: bands[row],
                passages,
                level: level[row],
                error: error[row],
            })
            .collect())
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
}

/// A level with what its model needs.
struct LevelRow {
    row: Row,
    view: usize,
    /// Place of its band among the bands.
    band: usize,
    /// Speed of a run \[m/s\]; none for a trolley.
    run: Option<f64>,
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
        let level = |row: &Row, view: usize, run: Option<f64>| LevelRow {
            row: *row,
            view,
            band: bands.partition_point(|band| *band < row.band),
            run,
        };
        let mut rows: Vec<LevelRow> = dated
            .rows
            .iter()
            .map(|row| level(row, dated.view, None))
            .collect();
        rows.sort_by(|a, b| a.row.passages.total_cmp(&b.row.passages));
        // Which common error each row has: that of its date, or of its run.
        let mut common: Vec<(usize, f64)> = Vec::new();
        let mut parts = vec![(dated.missed, 0..rows.len())];
        for row in &rows {
            common.push((row.row.passages.to_bits() as usize, dated.common_error));
        }
        for (number, run) in runs.iter().enumerate() {
            let begin = rows.len();
            rows.extend(
                run.rows
                    .iter()
                    .map(|row| level(row, run.view, Some(run.speed))),
            );
            common.resize(rows.len(), (number, run.common_error));
            parts.push((run.missed, begin..rows.len()));
        }
        let noise = Matrix::of(rows.len(), |i, j| {
            let own = if i == j {
                rows[i].row.error.powi(2)
            } else {
                0.0
            };
            let shared =
                common[i].0 == common[j].0 && rows[i].run.is_some() == rows[j].run.is_some();
            own + if shared {
                common[i].1 * common[j].1
            } else {
                0.0
            }
        });
        let missed = |index: usize, kernel: Kernel, own: std::ops::Range<usize>| {
            Matrix::of(rows.len(), |i, j| {
                let [one, other] = [&rows[i], &rows[j]];
                let distance = (one.row.band.wavelength() / other.row.band.wavelength()).ln();
                let kernel = match kernel {
                    Kernel::Band => f64::from(u8::from(one.band == other.band)),
                    kernel => kernel.at(distance),
                };
                match index {
                    // What is missed of growth, a run feels as well.
                    0 => one.row.passages * other.row.passages / (UNIT * UNIT) * kernel,
                    _ if own.contains(&i) && own.contains(&j) => kernel,
                    _ => 0.0,
                }
            })
        };
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
        let of_size = parts.into_iter().enumerate();
        let of_size = of_size
            .filter_map(|(index, (kernel, own))| Some(contrast(missed(index, kernel?, own))));
        Some(Self {
            gaussian: Gaussian::new(contrast(noise), of_size.collect())?,
            contrasts,
            lines: band_lines(&bands),
            rows,
        })
    }

    /// The levels above L_b that the model says of all rows \[dB\].
    fn levels(&self, trial: &Trial<'_>) -> Result<Vec<f64>, String> {
        let known: RefCell<BTreeMap<usize, Vec<f64>>> = RefCell::default();
        let mut felt: BTreeMap<(usize, u64), Vec<f64>> = BTreeMap::new();
        let mut levels = Vec::with_capacity(self.rows.len());
        for row in &self.rows {
            let mut known = known.borrow_mut();
            let rates = match known.entry(row.view) {
                std::collections::btree_map::Entry::Occupied(entry) => entry.into_mut(),
                std::collections::btree_map::Entry::Vacant(entry) => {
                    entry.insert(trial.growth_rates(row.view, &self.lines)?)
                }
            };
            let own = row.band * LINES_PER_BAND..(row.band + 1) * LINES_PER_BAND;
            let grown = rates[own.clone()]
                .iter()
                .map(|g| (2.0 * g * row.row.passages).exp());
            let (mean, less) = match row.run {
                None => (grown.sum::<f64>(), 0.0),
                Some(speed) => {
                    let felt = match felt.entry((row.view, speed.to_bits())) {
                        std::collections::btree_map::Entry::Occupied(entry) => entry.into_mut(),
                        std::collections::btree_map::Entry::Vacant(entry) => {
                            let case = trial.case(row.view)?;
                            entry.insert(accelerations(case, &self.lines, speed))
                        }
                    };
                    let energies = grown.zip(&felt[own]).map(|(grown, felt)| grown * felt);
                    (energies.sum::<f64>(), MICROMETRE)
                }
            };
            levels.push(10.0 * (mean / LINES_PER_BAND as f64).log10() - less);
        }
        Ok(levels)
    }

    fn contrast(&self, levels: &[f64]) -> Vec<f64> {
        let contrasts = self.contrasts.iter();
        contrasts
            .map(|(row, first)| levels[*row] - levels[*first])
            .collect()
    }
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
        let observed = self.observed();
        let residuals: Vec<f64> = observed.iter().zip(predicted).map(|(y, m)| y - m).collect();
        self.gaussian.density(&residuals, sizes)
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
}
