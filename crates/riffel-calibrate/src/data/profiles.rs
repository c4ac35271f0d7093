//! Profiles of the same rail at several dates.

use std::f64::consts::{LN_10, TAU};
use std::path::{Component, Path, PathBuf};

use riffel::Complex64;
use riffel::diagnosis::{FALL_BY_GRINDING, fall_of_bands, first_since_ground};
use riffel::roughness::{Profile, Spectrum, WaveGrowth, WaveGrowths};
use riffel_case::Case;
use riffel_keys::{CaseError, Message, say};
use riffel_numerics::matrix::Matrix;
use riffel_rail::{Layout, RoughnessFile};

use super::{Block, Observable, Place, UNIT, table, too_few};
use crate::file::Kind;
use crate::gaussian::Gaussian;
use crate::kernel::Kernel;
use crate::model::Trial;

/// Np of one dB.
const OF_DECIBEL: f64 = LN_10 / 20.0;
/// Share of its variance that the error of a date has from the first date, whose noise is in all of them.
const OF_FIRST: f64 = 0.5;

/// Which way trains run along the positions of the profiles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Travel {
    Rising,
    Falling,
}

/// How profiles are compared.
pub(crate) struct Comparison<'a> {
    /// The rail of files with several.
    pub(crate) rail: Option<&'a str>,
    /// `None` if it is not known, and waves tell how they grow, but not how they move.
    pub(crate) travel: Option<Travel>,
    /// Standard deviation of the gain that the lines of a date share \[dB\].
    pub(crate) common_error: f64,
    pub(crate) missed: Option<Kernel>,
}

/// Growth of waves from the first date to others: ln of complex amplitudes over those of the first date, N(g + i Im G), real parts
/// and, where the direction of travel is known, imaginary ones.
pub(crate) struct DatedProfiles {
    view: usize,
    lines: Vec<Line>,
    /// What is measured: real parts of all lines, then imaginary ones.
    data: Vec<f64>,
    /// Errors of all of it.
    gaussian: Gaussian,
    /// Wavelengths at which growth is asked for \[m\], seven a line.
    wavelengths: Vec<f64>,
    /// Shares of these.
    seen: [(f64, f64); 7],
}

/// A wave at a date.
#[derive(Debug, Clone, Copy)]
struct Line {
    passages: f64,
    wave: WaveGrowth,
}

/// Profiles of a table: passages since the first date and as they are counted, file and profile, by date.
struct Dated {
    passages: f64,
    counted: f64,
    path: PathBuf,
    profile: Profile,
}

impl DatedProfiles {
    /// The growth of waves in the window of a case between profiles that a table names, remarks, and the files of the profiles.
    ///
    /// # Errors
    /// [`CaseError`] with the file, what is wrong in it and the rule.
    pub(crate) fn read(
        path: &Path,
        (view, case): (usize, &Case),
        comparison: &Comparison<'_>,
    ) -> Result<(Self, Vec<Message>, Vec<PathBuf>), CaseError> {
        let window = [case.wavelength.min(), case.wavelength.max()];
        let (dated, remark) = since_ground(path, profiles(path, comparison.rail)?, window[1])?;
        let [first, later @ ..] = &dated[..] else {
            return Err(CaseError::data(path, "has no rows"));
        };
        let (mut lines, mut seen) = (Vec::new(), None);
        let mut remarks: Vec<Message> = remark.into_iter().collect();
        for date in later {
            let found = WaveGrowths::between(&first.profile, &date.profile, window);
            let found = found.map_err(|error| CaseError::data(&date.path, error.to_string()))?;
            if found.lost > 0 {
                let all = found.lost + found.waves.len();
                let remark = say!(lines_left_out, lost = found.lost as f64, all = all as f64);
                remarks.push(remark.about(date.path.display()));
            }
            lines.extend(found.waves.iter().map(|wave| Line { passages: date.passages, wave: *wave }));
            seen = Some((found.seen, found.segment));
        }
        let Some((seen, segment)) = seen else {
            let message =
                "all profiles are of one date, which says nothing of growth; measure again, or leave the file out";
            return Err(CaseError::data(path, message));
        };
        let gaussian = errors(&lines, comparison, window[1]);
        let gaussian =
            gaussian.ok_or_else(|| CaseError::data(path, "the errors of the lines are zero within rounding"))?;
        let wavelengths = lines.iter().flat_map(|line| {
            let wave = line.wave.wavelength.recip();
            seen.map(|(beside, _)| (wave + beside / segment).recip())
        });
        let sign = match comparison.travel {
            Some(Travel::Falling) => -1.0,
            _ => 1.0,
        };
        let real = lines.iter().map(|line| line.wave.logarithm.re);
        let imaginary = lines.iter().map(|line| sign * line.wave.logarithm.im);
        let with_phase = comparison.travel.is_some();
        let imaginary = imaginary.filter(|_| with_phase);
        let block = Self {
            view,
            data: real.chain(imaginary).collect(),
            gaussian,
            wavelengths: wavelengths.collect(),
            seen,
            lines,
        };
        let files = dated.into_iter().map(|date| date.path);
        Ok((block, remarks, files.collect()))
    }
}

/// Covariance of the errors of real parts, and of imaginary ones where the direction of travel is known.
fn errors(lines: &[Line], comparison: &Comparison<'_>, longest: f64) -> Option<Gaussian> {
    let count = lines.len();
    let gain = comparison.common_error * OF_DECIBEL;
    let noise = |i: usize, j: usize| {
        let (one, other) = (&lines[i], &lines[j]);
        let errors = (one.wave.variance * other.wave.variance).sqrt();
        match (one.passages == other.passages, one.wave.wavelength == other.wave.wavelength) {
            (true, true) => errors,
            (false, true) => OF_FIRST * errors,
            _ => 0.0,
        }
    };
    let same_date = |i: usize, j: usize| lines[i].passages == lines[j].passages;
    let real = |i: usize, j: usize| {
        let common = if same_date(i, j) { gain * gain } else { OF_FIRST * gain * gain };
        noise(i, j) + common
    };
    // What is a shift of the record and what a drift of waves, only the waves tell: it may be as long as the longest of them.
    let turned = |i: usize| TAU * longest / lines[i].wave.wavelength;
    let imaginary = |i: usize, j: usize| {
        let shift = if same_date(i, j) { turned(i) * turned(j) } else { 0.0 };
        noise(i, j) + shift
    };
    let missed = comparison.missed.map(|kernel| {
        move |i: usize, j: usize| {
            let (one, other) = (&lines[i], &lines[j]);
            let passages = one.passages * other.passages / (UNIT * UNIT);
            let distance = (one.wave.wavelength / other.wave.wavelength).ln();
            OF_DECIBEL * OF_DECIBEL * passages * kernel.at(distance)
        }
    });
    let parts = if comparison.travel.is_some() { 2 } else { 1 };
    let matrix = |of: &dyn Fn(usize, usize, usize) -> f64| {
        Matrix::of(parts * count, |i, j| match i / count == j / count {
            true => of(i / count, i % count, j % count),
            false => 0.0,
        })
    };
    let noise = matrix(&|part, i, j| {
        if part == 0 { real(i, j) } else { imaginary(i, j) }
    });
    let missed = missed.map(|missed| matrix(&|_, i, j| missed(i, j)));
    Gaussian::new(noise, missed.into_iter().collect())
}

/// The profiles that a table names, beside it, by date.
fn profiles(path: &Path, rail: Option<&str>) -> Result<Vec<Dated>, CaseError> {
    let rows = table::named(path, Kind::DatedProfiles.columns())?;
    let folder = path.parent().unwrap_or_else(|| Path::new(""));
    let begins = rows.iter().map(|(passages, _)| *passages);
    let begins = begins.fold(f64::INFINITY, f64::min);
    let mut dated: Vec<Dated> = Vec::new();
    for (passages, name) in rows {
        let passages = passages - begins;
        if name.is_empty() {
            let message = format!("has no name in `profile` for the passages {passages}, counted from the first date");
            return Err(CaseError::data(path, &message));
        }
        // A table that is sent to a server must not make it read other files.
        let is_below = |part: Component<'_>| matches!(part, Component::Normal(_) | Component::CurDir);
        if !Path::new(&name).components().all(is_below) {
            let message =
                format!("names the profile \"{name}\", but profiles must lie beside the table or in a folder there");
            return Err(CaseError::data(path, &message));
        }
        let path = folder.join(name);
        if dated.iter().any(|other| other.passages == passages) {
            let message = "is of a date that another profile is of; give each date one";
            return Err(CaseError::data(&path, message));
        }
        let profile = profile(&path, rail)?;
        dated.push(Dated { passages, counted: passages + begins, path, profile });
    }
    dated.sort_by(|one, other| one.passages.total_cmp(&other.passages));
    if let [_, .., last] = &dated[..]
        && let Some(rule) = too_few(last.passages)
    {
        return Err(CaseError::data(path, rule));
    }
    Ok(dated)
}

/// The profiles since the rail was last ground, with passages since the first of them, and what to say of it.
fn since_ground(table: &Path, mut dated: Vec<Dated>, longest: f64) -> Result<(Vec<Dated>, Option<Message>), CaseError> {
    let spectrum = |date: &Dated| {
        let levels = Spectrum::of_record(std::slice::from_ref(&date.profile), longest);
        levels.map_err(|error| CaseError::data(&date.path, error.to_string()))
    };
    let spectra: Vec<Spectrum> = dated.iter().map(spectrum).collect::<Result<_, _>>()?;
    let falls = spectra.windows(2).map(|pair| {
        let bands = pair[0].levels().iter();
        fall_of_bands(bands.filter_map(|before| Some(before.level - pair[1].level(before.band)?)))
    });
    let since = first_since_ground(falls);
    if since == 0 {
        return Ok((dated, None));
    }
    let last = since + 1 == dated.len();
    dated.drain(..since);
    let before = dated[0].passages;
    let counted = dated[0].counted;
    if last {
        let ground = say!(only_ground, passages = counted, fall = FALL_BY_GRINDING);
        return Err(CaseError::data(table, ground));
    }
    dated.iter_mut().for_each(|date| date.passages -= before);
    let said =
        say!(ground_between_dates, file = table.display().to_string(), passages = counted, fall = FALL_BY_GRINDING);
    Ok((dated, Some(said)))
}

/// The longest stretch without gaps of a rail in a file.
fn profile(path: &Path, rail: Option<&str>) -> Result<Profile, CaseError> {
    let refuse = |message: &str| CaseError::data(path, message);
    let RoughnessFile::Profile(record) = RoughnessFile::read(path, &Layout::default(), &|_| ())? else {
        return Err(refuse("has spectra, but a profile is needed: heights along the rail"));
    };
    if let Some(before) = record.earlier.first() {
        let message = format!("has profiles of several dates, the first {}; give each date a file", before.date);
        return Err(refuse(&message));
    }
    let names: Vec<&str> = record.rails.iter().map(|rail| &*rail.name).collect();
    let own = match (rail, &record.rails[..]) {
        (None, [only]) => Some(only),
        (None, _) => None,
        (Some(name), rails) => rails.iter().find(|rail| rail.name == name),
    };
    let own =
        own.ok_or_else(|| refuse(&format!("has the rails {}; `rail` of the plan must name one", names.join(", "))))?;
    let longest = own.stretches.iter();
    let longest = longest.max_by(|one, other| one.length().total_cmp(&other.length()));
    longest.cloned().ok_or_else(|| refuse("has no stretch without gaps"))
}

impl Block for DatedProfiles {
    fn predict(&self, trial: &Trial<'_>) -> Result<Vec<f64>, String> {
        let rates = trial.complex_growth_rates(self.view, &self.wavelengths)?;
        let lines = self.lines.iter().zip(rates.chunks(self.seen.len()));
        let grown = lines.map(|(line, rates)| {
            let seen = rates.iter().zip(&self.seen);
            let grown = seen.map(|(rate, (_, share))| (line.passages * rate).exp() * *share);
            grown.sum::<Complex64>().ln()
        });
        let grown: Vec<Complex64> = grown.collect();
        let real = grown.iter().map(|grown| grown.re);
        // Phases next to those of the data.
        let phases = self.data.get(self.lines.len()..).unwrap_or_default();
        let imaginary = grown.iter().zip(phases).map(|(grown, measured)| {
            let beside = measured - grown.im;
            measured - (beside - TAU * (beside / TAU).round())
        });
        Ok(real.chain(imaginary).collect())
    }

    fn gaussian(&self) -> Option<&Gaussian> {
        Some(&self.gaussian)
    }

    fn with_data(&self, data: &[f64]) -> Option<Box<dyn Block>> {
        Some(Box::new(Self {
            lines: self.lines.clone(),
            data: data.to_vec(),
            gaussian: self.gaussian.clone(),
            wavelengths: self.wavelengths.clone(),
            ..*self
        }))
    }

    fn views(&self) -> Vec<usize> {
        vec![self.view]
    }

    fn observed(&self) -> Vec<f64> {
        self.data.clone()
    }

    fn places(&self) -> Vec<Place> {
        let parts = [Observable::WaveGrowthNp, Observable::WaveDriftRad];
        let of_part = |measured: Observable| {
            self.lines.iter().map(move |line| Place { measured, at: line.wave.wavelength, of: Some(line.passages) })
        };
        let places = parts.into_iter().flat_map(of_part);
        places.take(self.data.len()).collect()
    }

    fn covariance(&self, sizes: &[f64], times: f64) -> Matrix {
        self.gaussian.covariance_of_mean(sizes, times)
    }
}
