//! Records of one-third-octave levels.

use std::path::Path;

use jiff::civil::Date;
use riffel::diagnosis::{DominantWavelength, LevelTrend, TimeUnit, TrendPoint, dominant_levels};
use riffel::roughness::{Spectrum, ThirdOctave};
use riffel_keys::{CaseError, Message, number, say};

use super::{Curves, Measured, RailHistory, SpectraChoice, dates, times};
use crate::{LabelledSpectrum, RailRecord, RailRoughness, Survey, find_rail, name_in_words};

/// The history of rails whose levels were measured.
pub(super) fn history(
    present: &RailRecord<'_>,
    spectra: &[LabelledSpectrum],
    earlier: &[RailRecord<'_>],
    choice: SpectraChoice<'_>,
) -> Result<RailHistory, CaseError> {
    let chosen = |name: &Path, spectra: &[LabelledSpectrum]| {
        let survey = Survey::new(name, spectra.to_vec(), Vec::new())?.choose(choice.choose)?;
        Ok::<_, CaseError>(survey.on_one_device())
    };
    let mut records: Vec<(String, Survey)> = Vec::new();
    for record in earlier {
        let RailRoughness::Spectra(spectra) = record.roughness else {
            return Err(CaseError::data(
                record.name,
                format!("is a profile, but {} is a table of levels; both must be the same", present.name.display()),
            ));
        };
        let survey = chosen(record.name, spectra)?;
        records.push((record.name.display().to_string(), survey));
    }
    let survey = chosen(present.name, spectra)?;
    let remarks = survey.warnings.clone();
    // The rails, unless the records are told apart by just that.
    let rails: Vec<Option<String>> = match survey.rail_column() {
        Some(column) if choice.by != Some(column) => {
            let rails = survey.by_rail().into_iter();
            rails.map(|(name, _)| Some(name)).collect()
        }
        _ => vec![None],
    };
    if records.is_empty() {
        records = survey.groups(choice.by.or_else(|| survey.date_column()))?;
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
    let spectra: usize = records.iter().map(|record| record.1.records.len()).sum();
    let (spectra, count) = (say!(one_third_octave_spectra, count = spectra), records.len());
    let words = match rails.len() {
        1 => say!(spectra_of_records, spectra, count),
        rails => say!(spectra_of_records_by_rail, spectra, count, rails = number(rails)),
    };
    let mut warnings = remarks;
    let records: Vec<(&str, f64, &Survey)> =
        (records.iter().zip(&times)).map(|((name, survey), &time)| (name.as_str(), time, survey)).collect();
    let are_several = rails.len() > 1;
    let tables = rails.into_iter().map(|rail| {
        let groups = groups(&rail, are_several, &records, &mut warnings);
        RailTable::new(rail, groups, unit)
    });
    let mut tables: Vec<RailTable> = tables.collect();
    // The rail with the highest of all dominant levels leads.
    tables.sort_by(|a, b| b.highest().total_cmp(&a.highest()));
    let measured = tables.iter().flat_map(|table| table.measured(&tables));
    let mut measured: Vec<Measured> = measured.collect();
    measured.sort_by_key(|one| one.gone);
    let several = tables.len() > 1;
    let curves = tables.iter().flat_map(|table| table.curves(several));
    let curves = curves.collect();
    Ok(RailHistory { measured, words, curves: Curves::Levels(curves), defects: Vec::new(), warnings })
}

/// The spectra of a rail in each record that has it, with a warning for those that have not.
fn groups(
    rail: &Option<String>,
    are_several: bool,
    records: &[(&str, f64, &Survey)],
    warnings: &mut Vec<Message>,
) -> Vec<Group> {
    let mut groups = Vec::new();
    for &(name, time, survey) in records {
        let of_rail = match (rail, survey.rail_column()) {
            (Some(rail), Some(_)) => {
                let mut rails = survey.by_rail();
                let place = find_rail(rails.iter().map(|(name, _)| name.as_str()), rail);
                place.map(|place| rails.swap_remove(place).1)
            }
            (Some(_), None) if are_several => None,
            _ => Some(survey.clone()),
        };
        match (of_rail, rail) {
            (Some(survey), _) => groups.push(Group { name: name.to_owned(), time, spectra: survey.spectra() }),
            (None, Some(rail)) => {
                let said = say!(record_lacks_rail_there, rail = name_in_words(rail));
                warnings.push(said.about(Message::verbatim(name)));
            }
            (None, None) => {}
        }
    }
    groups
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
    fn point(&self, band: ThirdOctave) -> Option<TrendPoint> {
        let spectra = self.spectra.iter();
        let levels: Vec<f64> = spectra.filter_map(|spectrum| spectrum.level(band)).collect();
        Some(TrendPoint {
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
    /// What stands out, the most prominent first.
    peaks: Vec<Peak>,
}

/// A wavelength that stands out of one record or more.
struct Peak {
    /// In the record where it stands out most: of those since it was ground, if it stands out of any.
    wave: DominantWavelength,
    record: String,
    course: Option<LevelTrend>,
    /// Whether it stands out of none since it was ground.
    gone: bool,
}

impl RailTable {
    fn new(rail: Option<String>, groups: Vec<Group>, unit: TimeUnit) -> Self {
        let mut found: Vec<(DominantWavelength, &Group)> = Vec::new();
        for group in &groups {
            let peaks = dominant_levels(&group.spectra).into_iter();
            found.extend(peaks.map(|peak| (peak, group)));
        }
        found.sort_by(|a, b| b.0.prominence.total_cmp(&a.0.prominence));
        let mut peaks: Vec<Peak> = Vec::new();
        for (first, _) in &found {
            if (peaks.iter()).any(|peak| peak.wave.wavelength == first.wavelength) {
                continue;
            }
            let band = ThirdOctave::containing(first.wavelength).ok();
            let points = groups.iter().filter_map(|group| group.point(band?));
            let course = LevelTrend::new(points.collect(), unit).ok();
            let since = course.as_ref().map(|course| course.on_line()[0].time);
            let mut own = (found.iter()).filter(|(peak, _)| peak.wavelength == first.wavelength);
            let most = own.clone().find(|(_, group)| since.is_none_or(|since| group.time >= since));
            peaks.extend(most.or(own.next()).map(|(wave, group)| Peak {
                wave: wave.clone(),
                record: group.name.clone(),
                gone: most.is_none(),
                course,
            }));
        }
        peaks.sort_by(|a, b| b.wave.prominence.total_cmp(&a.wave.prominence));
        Self { rail, groups, peaks }
    }

    /// The highest level of what stands out.
    fn highest(&self) -> f64 {
        let peaks = self.peaks.iter().filter(|peak| !peak.gone);
        let levels = peaks.map(|peak| peak.wave.level);
        levels.fold(f64::NEG_INFINITY, f64::max)
    }

    /// What stands out of this rail, with the levels of all rails in the record where it does most.
    fn measured<'a>(&'a self, all: &'a [Self]) -> impl Iterator<Item = Measured> + 'a {
        self.peaks.iter().map(move |peak| {
            let band = ThirdOctave::containing(peak.wave.wavelength).ok();
            let groups = self.groups.iter();
            let energy = groups.filter_map(|group| Spectrum::energy_mean(&group.spectra)?.level(band?)).collect();
            let rails = all.iter().filter(|_| all.len() > 1);
            let rails = rails.filter_map(|table| {
                let mut groups = table.groups.iter();
                let group = groups.find(|group| group.name == peak.record)?;
                Some((table.rail.clone()?, group.level(band?)?))
            });
            Measured {
                rail: self.rail.clone(),
                places: Vec::new(),
                all_along: true,
                gone: peak.gone,
                energy_levels: peak.course.is_some().then_some(energy),
                peak: peak.wave.clone(),
                record: (self.groups.len() > 1).then(|| peak.record.clone()),
                course: peak.course.clone(),
                rails: rails.collect(),
            }
        })
    }

    /// Mean levels of each record, with the name of the rail where there are `several`.
    fn curves(&self, several: bool) -> impl Iterator<Item = (Message, Spectrum)> + '_ {
        let rail = self.rail.as_deref().filter(|_| several);
        self.groups.iter().filter_map(move |group| {
            let name = match (rail, self.groups.len()) {
                (None, _) => Message::verbatim(&group.name),
                (Some(rail), 1) => name_in_words(rail),
                (Some(rail), _) => {
                    let rail = name_in_words(rail);
                    say!(rail_and_group, rail, group = &group.name)
                }
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
    let mut pairs: Vec<(Date, (String, Survey))> = dated.into_iter().zip(records.drain(..)).collect();
    pairs.sort_by_key(|(date, _)| *date);
    let (dates, sorted) = pairs.into_iter().unzip();
    *records = sorted;
    Ok(Some(dates))
}

/// Standard error of the mean of several levels; None for one.
fn standard_error(levels: &[f64]) -> Option<f64> {
    let count = levels.len() as f64;
    let mean = levels.iter().sum::<f64>() / count;
    let squares: f64 = levels.iter().map(|level| (level - mean).powi(2)).sum();
    (count > 1.0).then(|| (squares / (count - 1.0) / count).sqrt())
}
