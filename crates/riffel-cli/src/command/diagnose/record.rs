//! The records of `diagnose`: what stands out of them, and what it did in time.

use std::path::Path;

use jiff::civil::Date;
use riffel::diagnosis::{
    Course, CoursePoint, DominantWavelength, FineSpectrum, TimeUnit, dominant_levels,
};
use riffel::roughness::{PIT_DEPTH, Profile, Spectrum, SpikeCriterion, ThirdOctave, WHEEL_RADIUS};
use riffel_case::CaseError;
use riffel_case::roughness::{LabelledSpectrum, Record, RoughnessFile, Survey};

use crate::arguments::DiagnosisArguments;
use crate::command::roughness::profile::counted;
use crate::command::roughness::{choose_nothing, read};
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
    /// The record that was read, with the earlier ones, which are read here.
    pub(crate) fn of(file: &RoughnessFile, arguments: &DiagnosisArguments) -> miette::Result<Self> {
        check_dates(arguments)?;
        let earlier: Vec<(&Path, RoughnessFile)> = arguments
            .earlier
            .iter()
            .map(|path| Ok((path.as_path(), read(path, &arguments.layout)?)))
            .collect::<miette::Result<_>>()?;
        match file {
            RoughnessFile::Profile(record) => Self::of_profiles(record, &earlier, arguments),
            RoughnessFile::Spectra(spectra) => Self::of_tables(spectra, earlier, arguments),
        }
    }

    fn of_profiles(
        record: &Record,
        earlier: &[(&Path, RoughnessFile)],
        arguments: &DiagnosisArguments,
    ) -> miette::Result<Self> {
        let path = &arguments.roughness;
        choose_nothing(path, &arguments.choose, arguments.by.as_deref())?;
        let mut warnings = record.warnings.clone();
        let fine = |path: &Path, stretches: &[Profile]| {
            FineSpectrum::of_record(stretches)
                .map_err(|error| CaseError::data(path, error.to_string()))
        };
        let mut past = Vec::new();
        for (path, file) in earlier {
            let RoughnessFile::Profile(record) = file else {
                Err(CaseError::data(
                    *path,
                    "is a table of levels, but --roughness is a profile; both must be the same",
                ))?
            };
            let remarks = record.warnings.iter();
            warnings.extend(remarks.map(|warning| format!("{}: {warning}", path.display())));
            let [_, rolled] = cleaned(record);
            past.push((*path, fine(path, &rolled)?));
        }
        let [unrolled, rolled] = cleaned(record);
        let spectrum = fine(path, &rolled)?;
        let peaks = on_rail_and_wheel(&fine(path, &unrolled)?, &spectrum);
        drop(unrolled);
        // Rails on their own say something where there are several, and something stands out.
        let by_rail: Vec<(String, FineSpectrum)> = if record.rails.len() > 1 && !peaks.is_empty() {
            let mut rest = &rolled[..];
            let rails = record.rails.iter().map(|rail| {
                let own = rest.split_off(..rail.stretches.len()).unwrap_or_default();
                Ok((rail.name.clone(), fine(path, own)?))
            });
            rails.collect::<Result<_, CaseError>>()?
        } else {
            Vec::new()
        };
        let labels: Vec<String> = if arguments.dates.is_empty() {
            let files = past.iter().map(|past| past.0).chain([path.as_path()]);
            files.map(|file| file.display().to_string()).collect()
        } else {
            arguments.dates.iter().map(Date::to_string).collect()
        };
        let (times, unit) = times(labels.len(), &arguments.dates);
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
            let rails = by_rail
                .iter()
                .map(|(name, rail)| (name.clone(), rail.level_between(peak.from, peak.to).0))
                .collect();
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
                counted(record.rails.len(), "rail"),
                record.length(),
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
        spectra: &[LabelledSpectrum],
        earlier: Vec<(&Path, RoughnessFile)>,
        arguments: &DiagnosisArguments,
    ) -> miette::Result<Self> {
        let path = &arguments.roughness;
        let chosen = |path: &Path, spectra: Vec<LabelledSpectrum>| {
            Survey::new(path, spectra, Vec::new())?.choose(&arguments.choose)
        };
        let mut records: Vec<(String, Survey)> = Vec::new();
        for (path, file) in earlier {
            let RoughnessFile::Spectra(spectra) = file else {
                Err(CaseError::data(
                    path,
                    "is a profile, but --roughness is a table of levels; both must be the same",
                ))?
            };
            records.push((path.display().to_string(), chosen(path, spectra)?));
        }
        let present = chosen(path, spectra.to_vec())?;
        if records.is_empty() {
            let has_dates = present.columns().any(|column| column == "date");
            let by = arguments.by.as_deref();
            records = present.groups(by.or_else(|| has_dates.then_some("date")))?;
        } else {
            records.push((path.display().to_string(), present));
        }
        // Dates of the spectra, where each has one.
        let dated: Option<Vec<Date>> = records
            .iter()
            .map(|(_, survey)| {
                let mut dates: Vec<&str> = survey
                    .records
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
            .map(|(name, survey)| (name, survey.spectra()))
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

/// A date for each record, or none at all.
fn check_dates(arguments: &DiagnosisArguments) -> Result<(), CliError> {
    let (dates, records) = (&arguments.dates, arguments.earlier.len() + 1);
    if dates.is_empty() || dates.len() == records {
        return Ok(());
    }
    let written: Vec<String> = dates.iter().map(Date::to_string).collect();
    Err(CliError::Argument {
        argument: "--dates",
        value: written.join(","),
        rule: format!("{records} dates, one for each --earlier and one for --roughness"),
    })
}

/// The stretches of all rails without spikes, and the same with the wheel rolled over them, as EN 15610 asks.
fn cleaned(record: &Record) -> [Vec<Profile>; 2] {
    let rails = record.rails.iter();
    let mut stretches: Vec<Profile> = rails.flat_map(|rail| rail.stretches.clone()).collect();
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
