//! The records of a diagnosis: what stands out of them, and what it did in time.

use std::path::Path;

use jiff::civil::Date;
use riffel::diagnosis::{
    CleanRail, Course, CoursePoint, DominantWavelength, FineSpectrum, LocatedWavelength, Place,
    TimeUnit, WINDOW, dominant_levels,
};
use riffel::roughness::{Spectrum, ThirdOctave};

use super::{DiagnosisSettings, RailRecord, RailRoughness};
use crate::CaseError;
use crate::roughness::{LabelledSpectrum, Rail, Survey};

/// A dominant wavelength with what goes with it.
pub struct Measured {
    /// The rail it stands on, where rails are known one by one.
    pub rail: Option<String>,
    /// Where along the rail it stands, the highest level first; none for tables of levels.
    pub places: Vec<Place>,
    /// Whether it stands all along the rail.
    pub all_along: bool,
    /// Where it stands, and how far it stands out.
    pub peak: DominantWavelength,
    /// Its levels in time, where there are two records or more.
    pub course: Option<Course>,
    /// The same course on mean energies, where the levels are means of several spectra.
    pub energy_levels: Option<Vec<f64>>,
    /// Level of every rail at the first place, or in the record where the wavelength stands out most, where there are
    /// several rails \[dB re 1 µm\].
    pub rails: Vec<(String, f64)>,
}

/// What a figure shows of the records.
pub enum Curves {
    /// Levels of a profile in narrow bands, of each rail and of the places that tell most; the worst first.
    Fine(Vec<(String, FineSpectrum)>),
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
        if rails.is_empty() {
            return Err(CaseError::data(
                present.name,
                "there is no rail in the record",
            ));
        }
        let mut warnings = warnings.to_vec();
        let wrong = |error: riffel::Error| CaseError::data(present.name, error.to_string());
        let clean: Vec<CleanRail> = rails
            .iter()
            .map(|rail| CleanRail::new(rail.stretches.clone()))
            .collect();
        let mut found: Vec<(usize, Vec<LocatedWavelength>)> = Vec::new();
        for (index, rail) in clean.iter().enumerate() {
            found.push((index, rail.dominant().map_err(wrong)?));
        }
        // The rail with the highest of all levels leads.
        let highest = |peaks: &[LocatedWavelength]| {
            let levels = peaks.iter().map(|one| one.peak.level);
            levels.fold(f64::NEG_INFINITY, f64::max)
        };
        found.sort_by(|a, b| highest(&b.1).total_cmp(&highest(&a.1)));
        let mut curves = Vec::new();
        for (index, peaks) in &found {
            let name = &rails[*index].name;
            curves.push((name.clone(), clean[*index].spectrum().map_err(wrong)?));
            // The place of the peak that stands out most, if it has one.
            let local = peaks.iter().find(|one| !one.all_along);
            curves.extend(local.and_then(|one| {
                let place = one.places.first()?;
                let label = format!("{name}, {:.0}–{:.0} m", place.from, place.to);
                Some((label, clean[*index].spectrum_between(place.from, place.to)?))
            }));
        }
        let words = format!(
            "profile, {} of {:.1} m{}, {} segments of {:.2} m averaged{}",
            counted(rails.len(), "rail", "rails"),
            rails.iter().map(Rail::length).sum::<f64>() / rails.len().max(1) as f64,
            if clean.iter().any(|rail| rail.length() >= 2.0 * WINDOW) {
                format!(", whole and in windows of {WINDOW:.0} m")
            } else {
                String::new()
            },
            curves[0].1.segments(),
            curves[0].1.segment_length(),
            match earlier.len() {
                0 => String::new(),
                count => format!("; {}", counted(count, "earlier record", "earlier records")),
            }
        );
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
        let mut points: Vec<Vec<CoursePoint>> = Vec::new();
        points.resize_with(found.iter().map(|rail| rail.1.len()).sum(), Vec::new);
        let mut point =
            |finding: usize, record: usize, rail: &CleanRail, one: &LocatedWavelength| {
                let level = level_at(rail, one);
                points[finding].extend(level.map(|(level, scatter)| CoursePoint {
                    label: labels[record].clone(),
                    time: times[record],
                    level,
                    scatter: Some(scatter),
                }));
                level.is_some()
            };
        let all = || {
            let rails = found.iter();
            rails.flat_map(|(index, peaks)| peaks.iter().map(move |one| (*index, one)))
        };
        for (place, record) in earlier.iter().enumerate() {
            let RailRoughness::Profile {
                rails: past,
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
            for (index, rail) in rails.iter().enumerate() {
                let findings = || all().enumerate().filter(move |(_, (own, _))| *own == index);
                if findings().next().is_none() {
                    continue;
                }
                let Some(same) = same_rail(past, rails, index) else {
                    warnings.push(format!(
                        "{name}: has no rail {}, whose course is not known",
                        rail.name
                    ));
                    continue;
                };
                let same = CleanRail::new(same.stretches.clone());
                for (finding, (_, one)) in findings() {
                    if !point(finding, place, &same, one) {
                        let place = one.places[0];
                        warnings.push(format!(
                            "{name}: rail {} was not measured from {:.1} m to {:.1} m, so that its course there is not known",
                            rail.name, place.from, place.to
                        ));
                    }
                }
            }
        }
        for (finding, (index, one)) in all().enumerate() {
            point(finding, earlier.len(), &clean[index], one);
        }
        let measured = all().zip(points).map(|((index, one), points)| {
            let levels = clean
                .iter()
                .zip(rails)
                .filter_map(|(rail, named)| Some((named.name.clone(), level_at(rail, one)?.0)));
            Measured {
                rail: Some(rails[index].name.clone()),
                places: one.places.clone(),
                all_along: one.all_along,
                peak: one.peak.clone(),
                course: Course::new(points, unit).ok(),
                energy_levels: None,
                rails: if rails.len() > 1 {
                    levels.collect()
                } else {
                    Vec::new()
                },
            }
        });
        Ok(Self {
            measured: measured.collect(),
            words,
            curves: Curves::Fine(curves),
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
        // The rails, unless the records are told apart by just that.
        let rails: Vec<Option<String>> = match survey.rail_column() {
            Some(column) if settings.by != Some(column) => {
                let rails = survey.by_rail().into_iter();
                rails.map(|(name, _)| Some(name)).collect()
            }
            _ => vec![None],
        };
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
        let words = format!(
            "{}, {}{}",
            counted(
                records.iter().map(|record| record.1.records.len()).sum(),
                "one-third-octave spectrum",
                "one-third-octave spectra"
            ),
            counted(records.len(), "record", "records"),
            match rails.len() {
                1 => String::new(),
                several => format!(", {several} rails judged one by one"),
            }
        );
        let mut warnings = Vec::new();
        let mut tables: Vec<RailTable> = Vec::new();
        for rail in rails.iter().cloned() {
            let mut groups = Vec::new();
            for ((name, survey), &time) in records.iter().zip(&times) {
                let of_rail = match (&rail, survey.rail_column()) {
                    (Some(rail), Some(_)) => {
                        let mut rails = survey.by_rail().into_iter();
                        rails
                            .find(|(name, _)| name == rail)
                            .map(|(_, survey)| survey)
                    }
                    (Some(_), None) if rails.len() > 1 => None,
                    _ => Some(survey.clone()),
                };
                match (of_rail, &rail) {
                    (Some(survey), _) => groups.push(Group {
                        name: name.clone(),
                        time,
                        spectra: survey.spectra(),
                    }),
                    (None, Some(rail)) => warnings.push(format!(
                        "{name}: has no rail {rail}, whose course is not known there"
                    )),
                    (None, None) => {}
                }
            }
            tables.push(RailTable::new(rail, groups));
        }
        // The rail with the highest of all dominant levels leads.
        tables.sort_by(|a, b| b.highest().total_cmp(&a.highest()));
        let measured = tables
            .iter()
            .flat_map(|table| table.measured(&tables, unit))
            .collect();
        let several = tables.len() > 1;
        let curves = tables.iter().flat_map(|table| table.curves(several));
        let curves = curves.collect();
        Ok(Self {
            measured,
            words,
            curves: Curves::Levels(curves),
            warnings,
        })
    }
}

/// The spectra of a rail in one record.
struct Group {
    name: String,
    time: f64,
    spectra: Vec<Spectrum>,
}

impl Group {
    /// Arithmetic mean of the levels of a band.
    fn level(&self, band: ThirdOctave) -> Option<f64> {
        Spectrum::arithmetic_mean(&self.spectra)?.level(band)
    }

    /// The point of this record in the course of a band.
    fn point(&self, band: ThirdOctave) -> Option<CoursePoint> {
        let spectra = self.spectra.iter();
        let levels: Vec<f64> = spectra
            .filter_map(|spectrum| spectrum.level(band))
            .collect();
        Some(CoursePoint {
            label: self.name.clone(),
            time: self.time,
            level: self.level(band)?,
            scatter: standard_error(&levels),
        })
    }
}

/// A rail in the records of a table of levels.
struct RailTable {
    rail: Option<String>,
    groups: Vec<Group>,
    /// What stands out, the most prominent first, each with the record where it does most.
    peaks: Vec<(DominantWavelength, String)>,
}

impl RailTable {
    fn new(rail: Option<String>, groups: Vec<Group>) -> Self {
        // A band counts where it stands out of one record or more; the record where it does most describes it.
        let mut peaks: Vec<(DominantWavelength, String)> = Vec::new();
        for group in &groups {
            for peak in dominant_levels(&group.spectra) {
                let mut known = peaks.iter_mut();
                match known.find(|(other, _)| other.wavelength == peak.wavelength) {
                    Some((other, _)) if other.prominence >= peak.prominence => {}
                    Some(other) => *other = (peak, group.name.clone()),
                    None => peaks.push((peak, group.name.clone())),
                }
            }
        }
        peaks.sort_by(|a, b| b.0.prominence.total_cmp(&a.0.prominence));
        Self {
            rail,
            groups,
            peaks,
        }
    }

    /// The highest level of what stands out.
    fn highest(&self) -> f64 {
        let levels = self.peaks.iter().map(|peak| peak.0.level);
        levels.fold(f64::NEG_INFINITY, f64::max)
    }

    /// What stands out of this rail, with the levels of all rails in the record where it does most.
    fn measured<'a>(
        &'a self,
        all: &'a [Self],
        unit: TimeUnit,
    ) -> impl Iterator<Item = Measured> + 'a {
        self.peaks.iter().map(move |(peak, record)| {
            let band = ThirdOctave::containing(peak.wavelength).ok();
            let groups = || self.groups.iter();
            let points = groups().filter_map(|group| group.point(band?));
            let course = Course::new(points.collect(), unit).ok();
            let energy = groups()
                .filter_map(|group| Spectrum::energy_mean(&group.spectra)?.level(band?))
                .collect();
            let rails = all.iter().filter(|_| all.len() > 1);
            let rails = rails.filter_map(|table| {
                let mut groups = table.groups.iter();
                let level = groups.find(|group| group.name == *record)?.level(band?)?;
                Some((table.rail.clone()?, level))
            });
            Measured {
                rail: self.rail.clone(),
                places: Vec::new(),
                all_along: true,
                energy_levels: course.is_some().then_some(energy),
                peak: peak.clone(),
                course,
                rails: rails.collect(),
            }
        })
    }

    /// Mean levels of each record, with the name of the rail where there are `several`.
    fn curves(&self, several: bool) -> impl Iterator<Item = (String, Spectrum)> + '_ {
        let rail = self.rail.as_deref().filter(|_| several);
        self.groups.iter().filter_map(move |group| {
            let name = match (rail, self.groups.len()) {
                (None, _) => group.name.clone(),
                (Some(rail), 1) => rail.to_owned(),
                (Some(rail), _) => format!("{rail}, {}", group.name),
            };
            Some((name, Spectrum::arithmetic_mean(&group.spectra)?))
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

/// The rail of an earlier record that is this one: that of the same name, or where no name agrees the one at the
/// same place in the file.
fn same_rail<'a>(past: &'a [Rail], rails: &[Rail], index: usize) -> Option<&'a Rail> {
    let named = |name: &str| past.iter().find(|rail| rail.name == name);
    if let Some(same) = named(&rails[index].name) {
        return Some(same);
    }
    let strange = past.len() == rails.len() && rails.iter().all(|rail| named(&rail.name).is_none());
    strange.then(|| past.get(index)).flatten()
}

/// Level of a wavelength at its first place \[dB re 1 µm\], and its standard deviation by chance; None where the
/// rail was not measured there.
fn level_at(rail: &CleanRail, one: &LocatedWavelength) -> Option<(f64, f64)> {
    let spectrum = if one.all_along {
        rail.spectrum().ok()?
    } else {
        let place = one.places.first()?;
        rail.spectrum_between(place.from, place.to)?
    };
    Some(spectrum.level_between(one.peak.from, one.peak.to))
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
