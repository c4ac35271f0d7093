//! The records of a diagnosis: what stands out of them, and what it did in time.

use std::path::Path;

use jiff::civil::Date;
use riffel::diagnosis::{
    Course, CoursePoint, DominantWavelength, FineSpectrum, TimeUnit, dominant_levels,
};
use riffel::roughness::{PIT_DEPTH, Profile, Spectrum, SpikeCriterion, ThirdOctave, WHEEL_RADIUS};

use super::{DiagnosisSettings, RailRecord, RailRoughness};
use crate::CaseError;
use crate::roughness::{LabelledSpectrum, Rail, Survey};

/// A dominant wavelength with what goes with it.
pub struct Measured {
    /// Where it stands, and how far it stands out.
    pub peak: DominantWavelength,
    /// Its levels in time, where there are two records or more.
    pub course: Option<Course>,
    /// The same course on mean energies, where the levels are means of several spectra.
    pub energy_levels: Option<Vec<f64>>,
    /// Level by rail \[dB re 1 µm\].
    pub rails: Vec<(String, f64)>,
}

/// What a figure shows of the records.
pub enum Curves {
    /// Level and trend of a profile in narrow bands.
    Fine(FineSpectrum),
    /// Means of levels of one-third octaves, by group.
    Levels(Vec<(String, Spectrum)>),
}

/// All that was measured.
pub(super) struct Records {
    pub(super) measured: Vec<Measured>,
    pub(super) curves: Curves,
    /// What the records are, in words.
    pub(super) words: String,
    pub(super) warnings: Vec<String>,
}

impl Records {
    pub(super) fn of(
        present: &RailRecord<'_>,
        earlier: &[RailRecord<'_>],
        settings: &DiagnosisSettings<'_>,
    ) -> Result<Self, CaseError> {
        let given = dates(earlier.iter().chain([present])).unwrap_or_default();
        if let Some(pair) = given.windows(2).find(|pair| pair[1] <= pair[0]) {
            let message = format!(
                "the dates of the records do not rise: {} comes after {}; give the oldest first",
                pair[1], pair[0]
            );
            return Err(CaseError::data(present.name, message));
        }
        match present.roughness {
            RailRoughness::Profile { rails, warnings } => {
                Self::of_profiles(present, rails, warnings, earlier, settings)
            }
            RailRoughness::Spectra(spectra) => Self::of_tables(present, spectra, earlier, settings),
        }
    }

    fn of_profiles(
        present: &RailRecord<'_>,
        rails: &[Rail],
        warnings: &[String],
        earlier: &[RailRecord<'_>],
        settings: &DiagnosisSettings<'_>,
    ) -> Result<Self, CaseError> {
        if !settings.choose.is_empty() || settings.by.is_some() {
            return Err(CaseError::data(
                present.name,
                "is a profile; a choice among spectra is for tables of them",
            ));
        }
        let mut warnings = warnings.to_vec();
        let fine = |name: &Path, stretches: &[Profile]| {
            FineSpectrum::of_record(stretches)
                .map_err(|error| CaseError::data(name, error.to_string()))
        };
        let mut past = Vec::new();
        for record in earlier {
            let RailRoughness::Profile {
                rails,
                warnings: remarks,
            } = record.roughness
            else {
                return Err(CaseError::data(
                    record.name,
                    format!(
                        "is a table of levels, but {} is a profile; both must be the same",
                        present.name.display()
                    ),
                ));
            };
            let name = record.name.display();
            warnings.extend(remarks.iter().map(|remark| format!("{name}: {remark}")));
            let [_, rolled] = cleaned(rails);
            past.push(fine(record.name, &rolled)?);
        }
        let [unrolled, rolled] = cleaned(rails);
        let spectrum = fine(present.name, &rolled)?;
        let peaks = on_rail_and_wheel(&fine(present.name, &unrolled)?, &spectrum);
        drop(unrolled);
        // Rails on their own say something where there are several, and something stands out.
        let by_rail: Vec<(String, FineSpectrum)> = if rails.len() > 1 && !peaks.is_empty() {
            let mut rest = &rolled[..];
            let rails = rails.iter().map(|rail| {
                let own = rest.split_off(..rail.stretches.len()).unwrap_or_default();
                Ok((rail.name.clone(), fine(present.name, own)?))
            });
            rails.collect::<Result<_, CaseError>>()?
        } else {
            Vec::new()
        };
        let records = || earlier.iter().chain([present]);
        let dates = dates(records()).unwrap_or_default();
        let labels: Vec<String> = if dates.is_empty() {
            records()
                .map(|record| record.name.display().to_string())
                .collect()
        } else {
            dates.iter().map(Date::to_string).collect()
        };
        let (times, unit) = times(labels.len(), &dates);
        let measured = peaks.into_iter().map(|peak| {
            let records = past.iter().chain([&spectrum]);
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
            let levels = by_rail
                .iter()
                .map(|(name, rail)| (name.clone(), rail.level_between(peak.from, peak.to).0))
                .collect();
            Measured {
                peak,
                course,
                energy_levels: None,
                rails: levels,
            }
        });
        Ok(Self {
            measured: measured.collect(),
            words: format!(
                "profile, {} of {:.1} m, {} segments of {:.2} m averaged{}",
                counted(rails.len(), "rail", "rails"),
                rails.iter().map(Rail::length).sum::<f64>() / rails.len().max(1) as f64,
                spectrum.segments(),
                spectrum.segment_length(),
                match past.len() {
                    0 => String::new(),
                    count => format!("; {}", counted(count, "earlier record", "earlier records")),
                }
            ),
            curves: Curves::Fine(spectrum),
            warnings,
        })
    }

    fn of_tables(
        present: &RailRecord<'_>,
        spectra: &[LabelledSpectrum],
        earlier: &[RailRecord<'_>],
        settings: &DiagnosisSettings<'_>,
    ) -> Result<Self, CaseError> {
        let chosen = |name: &Path, spectra: &[LabelledSpectrum]| {
            Survey::new(name, spectra.to_vec(), Vec::new())?.choose(settings.choose)
        };
        let mut records: Vec<(String, Survey)> = Vec::new();
        for record in earlier {
            let RailRoughness::Spectra(spectra) = record.roughness else {
                return Err(CaseError::data(
                    record.name,
                    format!(
                        "is a profile, but {} is a table of levels; both must be the same",
                        present.name.display()
                    ),
                ));
            };
            let survey = chosen(record.name, spectra)?;
            records.push((record.name.display().to_string(), survey));
        }
        let survey = chosen(present.name, spectra)?;
        if records.is_empty() {
            records = survey.groups(settings.by.or_else(|| survey.date_column()))?;
        } else {
            records.push((present.name.display().to_string(), survey));
        }
        // Dates of the spectra, where each has one.
        let given = dates(earlier.iter().chain([present])).filter(|_| !earlier.is_empty());
        let dates = match given {
            Some(dates) => dates,
            None => sorted_by_date(&mut records)?.unwrap_or_default(),
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
                counted(
                    count,
                    "one-third-octave spectrum",
                    "one-third-octave spectra"
                ),
                counted(groups.len(), "record", "records")
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

/// Put records in the order of the dates in their columns, of which each takes the one in the middle; None unless
/// every record has a column of dates.
fn sorted_by_date(records: &mut Vec<(String, Survey)>) -> Result<Option<Vec<Date>>, CaseError> {
    let mut dated = Vec::new();
    for (_, survey) in records.iter() {
        let Some(column) = survey.date_column() else {
            return Ok(None);
        };
        let dates = survey.by_date(column)?;
        dated.push(dates[dates.len() / 2].0);
    }
    let mut pairs: Vec<(Date, (String, Survey))> =
        dated.into_iter().zip(records.drain(..)).collect();
    pairs.sort_by_key(|(date, _)| *date);
    let (dates, sorted) = pairs.into_iter().unzip();
    *records = sorted;
    Ok(Some(dates))
}

/// The dates of all records, unless one has none.
fn dates<'a>(records: impl Iterator<Item = &'a RailRecord<'a>>) -> Option<Vec<Date>> {
    records.map(|record| record.date).collect()
}

/// The stretches of all rails without spikes, and the same with the wheel rolled over them, as EN 15610 asks.
fn cleaned(rails: &[Rail]) -> [Vec<Profile>; 2] {
    let mut stretches: Vec<Profile> = rails
        .iter()
        .flat_map(|rail| rail.stretches.clone())
        .collect();
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

fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}
