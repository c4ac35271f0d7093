//! The records of `diagnose`: what stands out of them, and what it did in time.

use std::path::Path;

use jiff::civil::Date;
use riffel::diagnosis::{
    Course, CoursePoint, DominantWavelength, FineSpectrum, TimeUnit, dominant_levels,
};
use riffel::roughness::{PIT_DEPTH, Profile, Spectrum, SpikeCriterion, ThirdOctave, WHEEL_RADIUS};
use riffel_case::CaseError;
use riffel_case::roughness::{LabelledSpectrum, ReaderFormat, RoughnessFile};

use crate::arguments::{DiagnosisArguments, positive};
use crate::command::roughness::choice::{columns, groups, refuse};
use crate::command::roughness::profile::counted;
use crate::command::roughness::with_progress;
use crate::error::CliError;

/// A dominant wavelength with what goes with it.
pub(crate) struct Measured {
    pub(crate) peak: DominantWavelength,
    pub(crate) course: Option<Course>,
    /// The same course on mean energies, where the levels are means of several spectra.
    pub(crate) energy_levels: Option<Vec<f64>>,
    /// Level by rail \[dB re 1 µm\].
    pub(crate) rails: Vec<(String, f64)>,
}

/// What a figure shows of the records.
pub(crate) enum Curves {
    /// Level and trend of a profile in narrow bands.
    Fine(FineSpectrum),
    /// Means of levels of one-third octaves, by group.
    Levels(Vec<(String, Spectrum)>),
}

/// All that was measured.
pub(crate) struct Records {
    pub(crate) measured: Vec<Measured>,
    pub(crate) curves: Curves,
    /// What the records are, in words.
    pub(crate) words: String,
    pub(crate) warnings: Vec<String>,
}

impl Records {
    pub(crate) fn read(arguments: &DiagnosisArguments) -> miette::Result<Self> {
        arguments
            .spacing
            .map(|spacing| positive("--spacing", spacing))
            .transpose()?;
        if !arguments.dates.is_empty() && arguments.dates.len() != arguments.earlier.len() + 1 {
            Err(CliError::Argument {
                argument: "--dates",
                value: arguments
                    .dates
                    .iter()
                    .map(Date::to_string)
                    .collect::<Vec<_>>()
                    .join(","),
                rule: format!(
                    "{} dates, one for each --earlier and one for --roughness",
                    arguments.earlier.len() + 1
                ),
            })?;
        }
        let format = arguments.format.as_deref();
        let format = format.map(ReaderFormat::read).transpose()?;
        let read = |path: &Path| -> Result<RoughnessFile, CaseError> {
            let size = std::fs::metadata(path).map_or(0, |file| file.len() as usize);
            with_progress("reading", size, |advance| {
                RoughnessFile::read(path, format.as_ref(), arguments.spacing, advance)
            })
        };
        let path = &arguments.roughness;
        match read(path)? {
            RoughnessFile::Profile(record) => {
                let mut earlier = Vec::new();
                for path in &arguments.earlier {
                    let RoughnessFile::Profile(record) = read(path)? else {
                        let message = "is a table of levels, but --roughness is a profile; both must be the same";
                        Err(refuse(path, message.to_owned()))?
                    };
                    earlier.push((path.as_path(), record));
                }
                Self::of_profiles(path, record, earlier, arguments)
            }
            RoughnessFile::Spectra(spectra) => {
                let mut earlier = Vec::new();
                for path in &arguments.earlier {
                    let RoughnessFile::Spectra(spectra) = read(path)? else {
                        let message = "is a profile, but --roughness is a table of levels; both must be the same";
                        Err(refuse(path, message.to_owned()))?
                    };
                    earlier.push((path.as_path(), spectra));
                }
                Self::of_tables(path, spectra, earlier, arguments)
            }
        }
    }

    fn of_profiles(
        path: &Path,
        record: riffel_case::roughness::Record,
        earlier: Vec<(&Path, riffel_case::roughness::Record)>,
        arguments: &DiagnosisArguments,
    ) -> miette::Result<Self> {
        let mut warnings = record.warnings.clone();
        let names: Vec<String> = record.rails.iter().map(|rail| rail.name.clone()).collect();
        let (mut unrolled, mut rails) = (Vec::new(), Vec::new());
        for rail in record.rails {
            let [plain, rolled] = cleaned(rail.stretches);
            unrolled.extend(plain);
            rails.push(rolled);
        }
        let fine = |path: &Path, stretches: &[Profile]| {
            FineSpectrum::of_record(stretches).map_err(|error| refuse(path, error.to_string()))
        };
        let all: Vec<Profile> = rails.iter().flatten().cloned().collect();
        let spectrum = fine(path, &all)?;
        let by_rail: Vec<FineSpectrum> = rails
            .iter()
            .map(|rail| fine(path, rail))
            .collect::<Result<_, _>>()?;
        let mut past = Vec::new();
        for (path, record) in earlier {
            warnings.extend(
                record
                    .warnings
                    .iter()
                    .map(|warning| format!("{}: {warning}", path.display())),
            );
            let rails = record.rails.into_iter();
            let stretches: Vec<Profile> = rails
                .flat_map(|rail| {
                    let [_, rolled] = cleaned(rail.stretches);
                    rolled
                })
                .collect();
            past.push((path, fine(path, &stretches)?));
        }
        let labels: Vec<String> = if arguments.dates.is_empty() {
            let files = past.iter().map(|past| past.0).chain([path]);
            files.map(|file| file.display().to_string()).collect()
        } else {
            arguments.dates.iter().map(Date::to_string).collect()
        };
        let (times, unit) = times(labels.len(), &arguments.dates);
        let peaks = on_rail_and_wheel(&fine(path, &unrolled)?, &spectrum);
        let measured = peaks.into_iter().map(|peak| {
            let records = past.iter().map(|past| &past.1).chain([&spectrum]);
            let points = records
                .zip(&labels)
                .zip(&times)
                .map(|((record, label), &time)| {
                    let (level, scatter) = record.level_between(peak.from, peak.to);
                    CoursePoint {
                        label: label.clone(),
                        time,
                        level,
                        scatter: Some(scatter),
                    }
                });
            let course = Course::new(points.collect(), unit).ok();
            let rails = if names.len() > 1 {
                let levels = by_rail
                    .iter()
                    .map(|rail| rail.level_between(peak.from, peak.to).0);
                names.iter().cloned().zip(levels).collect()
            } else {
                Vec::new()
            };
            Measured {
                peak,
                course,
                energy_levels: None,
                rails,
            }
        });
        Ok(Self {
            measured: measured.collect(),
            words: format!(
                "profile, {} of {:.1} m, {} segments of {:.2} m averaged{}",
                counted(names.len(), "rail"),
                all.iter().map(Profile::length).sum::<f64>() / names.len().max(1) as f64,
                spectrum.segments(),
                spectrum.segment_length(),
                match past.len() {
                    0 => String::new(),
                    count => format!("; {}", counted(count, "earlier record")),
                }
            ),
            curves: Curves::Fine(spectrum),
            warnings,
        })
    }

    fn of_tables(
        path: &Path,
        spectra: Vec<LabelledSpectrum>,
        earlier: Vec<(&Path, Vec<LabelledSpectrum>)>,
        arguments: &DiagnosisArguments,
    ) -> miette::Result<Self> {
        let has_dates = columns(&spectra).iter().any(|column| column == "date");
        let by = arguments.by.as_deref();
        let by = by.or_else(|| (has_dates && earlier.is_empty()).then_some("date"));
        let mut records: Vec<(String, Vec<LabelledSpectrum>)> = Vec::new();
        for (path, spectra) in earlier {
            let spectra = groups(path, spectra, &arguments.choose, None)?;
            records.extend(
                spectra
                    .into_iter()
                    .map(|(_, spectra)| (path.display().to_string(), spectra)),
            );
        }
        let past = records.len();
        let present = groups(path, spectra, &arguments.choose, by.filter(|_| past == 0))?;
        records.extend(present.into_iter().map(|(name, spectra)| {
            let name = if past > 0 {
                path.display().to_string()
            } else {
                name
            };
            (name, spectra)
        }));
        // Dates of the spectra, where each has one.
        let dated: Option<Vec<Date>> = records
            .iter()
            .map(|(_, spectra)| {
                let mut dates: Vec<&str> = spectra
                    .iter()
                    .map(|spectrum| spectrum.label("date"))
                    .collect::<Option<_>>()?;
                dates.sort_unstable();
                dates.dedup();
                dates[dates.len() / 2].parse().ok()
            })
            .collect();
        let dates = if arguments.dates.is_empty() {
            dated.unwrap_or_default()
        } else {
            arguments.dates.clone()
        };
        let (times, unit) = times(records.len(), &dates);
        let groups: Vec<(String, Vec<Spectrum>)> = records
            .into_iter()
            .map(|(name, spectra)| {
                let spectra = spectra.into_iter().map(|labelled| labelled.spectrum);
                (name, spectra.collect())
            })
            .collect();
        // A band counts where it stands out of one record or more; the record where it does most describes it.
        let mut peaks: Vec<DominantWavelength> = Vec::new();
        for (_, spectra) in &groups {
            for peak in dominant_levels(spectra) {
                match peaks
                    .iter_mut()
                    .find(|other| other.wavelength == peak.wavelength)
                {
                    Some(other) if other.prominence >= peak.prominence => {}
                    Some(other) => *other = peak,
                    None => peaks.push(peak),
                }
            }
        }
        peaks.sort_by(|a, b| b.prominence.total_cmp(&a.prominence));
        let measured = peaks.into_iter().map(|peak| {
            let band = ThirdOctave::containing(peak.wavelength);
            let mut energy = Vec::new();
            let points = groups
                .iter()
                .zip(&times)
                .filter_map(|((name, spectra), &time)| {
                    let band = band.clone().ok()?;
                    let levels: Vec<f64> = spectra
                        .iter()
                        .filter_map(|spectrum| spectrum.level(band))
                        .collect();
                    energy.push(Spectrum::energy_mean(spectra)?.level(band)?);
                    Some(CoursePoint {
                        label: name.clone(),
                        time,
                        level: Spectrum::arithmetic_mean(spectra)?.level(band)?,
                        scatter: standard_error(&levels),
                    })
                });
            let course = Course::new(points.collect(), unit).ok();
            Measured {
                energy_levels: course.is_some().then_some(energy),
                peak,
                course,
                rails: Vec::new(),
            }
        });
        let measured = measured.collect();
        let count: usize = groups.iter().map(|group| group.1.len()).sum();
        Ok(Self {
            measured,
            words: format!(
                "{}, {}",
                counted_irregular(
                    count,
                    "one-third-octave spectrum",
                    "one-third-octave spectra"
                ),
                counted(groups.len(), "record")
            ),
            curves: Curves::Levels(
                groups
                    .iter()
                    .filter_map(|(name, spectra)| {
                        Some((name.clone(), Spectrum::arithmetic_mean(spectra)?))
                    })
                    .collect(),
            ),
            warnings: Vec::new(),
        })
    }
}

/// The profile without spikes, and the same with the wheel rolled over it, as EN 15610 asks.
fn cleaned(mut stretches: Vec<Profile>) -> [Vec<Profile>; 2] {
    for stretch in &mut stretches {
        stretch.remove_spikes(SpikeCriterion::EN_15610);
    }
    let mut rolled = stretches.clone();
    for stretch in &mut rolled {
        stretch.roll_over(WHEEL_RADIUS, PIT_DEPTH);
    }
    [stretches, rolled]
}

/// Peaks of the rolled profile that are on the rail as well: edges of pits have waves of their own, which the
/// wheel bridges, and the wheel rounds the troughs of corrugation, which makes harmonics of its own.
fn on_rail_and_wheel(rail: &FineSpectrum, wheel: &FineSpectrum) -> Vec<DominantWavelength> {
    let on_rail = rail.dominant();
    let mut peaks = wheel.dominant();
    peaks.retain(|peak| {
        on_rail
            .iter()
            .any(|other| other.from <= peak.to && peak.from <= other.to)
    });
    peaks
}

/// Times of the records: years by their dates, or their places in the order.
fn times(records: usize, dates: &[Date]) -> (Vec<f64>, TimeUnit) {
    const DAYS_A_YEAR: f64 = 365.2425;
    let Some(first) = dates.first() else {
        let places = (0..records).map(|place| place as f64);
        return (places.collect(), TimeUnit::Record);
    };
    let days = |date: &Date| date.duration_since(*first).as_secs_f64() / 86_400.0;
    let years = dates.iter().map(|date| days(date) / DAYS_A_YEAR);
    (years.collect(), TimeUnit::Year)
}

/// Standard error of the mean of several levels; None for one.
fn standard_error(levels: &[f64]) -> Option<f64> {
    let count = levels.len() as f64;
    let mean = levels.iter().sum::<f64>() / count;
    let squares: f64 = levels.iter().map(|level| (level - mean).powi(2)).sum();
    (count > 1.0).then(|| (squares / (count - 1.0) / count).sqrt())
}

fn counted_irregular(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}
