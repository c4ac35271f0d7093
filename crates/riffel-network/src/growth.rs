//! How sections change over their surveys.

use std::collections::BTreeMap;

use jiff::civil::Date;
use rayon::prelude::*;
use serde::Serialize;

use crate::alignment::Alignment;
use crate::judgement::{DefectKind, ExpectedGrowth};
use crate::record::{RailRecord, SurveyRecord};
use crate::trend::{Trend, scatter};
use crate::{Judgement, NetworkError, Section, Sections, Store};

/// Scatters of a level above which its fall is no chance: three of a difference.
const CERTAIN_FALL: f64 = 3.0 * std::f64::consts::SQRT_2;
/// Days of a year, in the mean of the calendar.
const DAYS_PER_YEAR: f64 = 365.2425;

/// A section over its surveys.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SectionGrowth {
    /// The line.
    pub line: String,
    /// The rail.
    pub rail: String,
    /// First place \[m\].
    pub from_m: f64,
    /// Last place \[m\].
    pub to_m: f64,
    /// First and last of the days.
    pub dates: [String; 2],
    /// Surveys from the one to the other.
    pub surveys: usize,
    /// The band \[m\]: the one that reaches its limit first, or is farthest over it.
    pub band_m: [f64; 2],
    /// RMS at the two dates \[m\], without single places where cells are short enough to tell them.
    pub rms_m: [f64; 2],
    /// Change of the level \[dB a year\], by a line through all surveys since the rail was last ground; none of one survey.
    pub growth_db_per_year: Option<f64>,
    /// Half of its interval of 95 % \[dB a year\], by the scatter of the surveys of the line.
    pub growth_error_db_per_year: Option<f64>,
    /// What the traffic of the line is expected to make of it, if that is known.
    pub expected_growth_db_per_year: Option<ExpectedGrowth>,
    /// RMS over limit at the last date.
    pub rms_over_limit: f64,
    /// RMS over limit without single places, which grinding does not take off.
    pub lasting_over_limit: f64,
    /// What makes it rough, where it is over its limit; whether it was ground, where it is within.
    pub kind: Option<DefectKind>,
    /// Months from the last date until the limit is reached as the level grows; 0 where it is reached, `None` if it does not
    /// grow by more than the surveys scatter.
    pub months_to_limit: Option<f64>,
    /// Between what months by 80 %, by the scatter of the surveys or by what is expected; an end that may never come is infinite.
    pub months_to_limit_band_80: Option<[f64; 2]>,
    /// Whether the level fell by more than 3 dB to the last survey: the rail was ground, and no growth is known since.
    pub ground: bool,
}

impl SectionGrowth {
    /// The growth \[dB a year\] where it is more than the surveys scatter.
    pub(crate) fn certain(&self) -> Option<f64> {
        let (growth, error) = (self.growth_db_per_year?, self.growth_error_db_per_year?);
        (!self.ground && growth > error).then_some(growth)
    }

    /// The growth \[dB a year\] that is reckoned with: that of the surveys, or where they tell none, of one survey or of a rail that was
    /// ground, the median of what is expected, if it grows.
    fn reckoned(&self) -> Option<f64> {
        match self.growth_error_db_per_year.is_some() && !self.ground {
            true => self.certain(),
            false => {
                let expected = self.expected_growth_db_per_year?.median;
                (expected > 0.0).then_some(expected)
            }
        }
    }

    /// Between what years what is expected rises by some decibels, by 80 %.
    fn expected_years_80(&self, rise: f64) -> Option<[f64; 2]> {
        let [slow, fast] = self.expected_growth_db_per_year?.band_80;
        Some([fast, slow].map(|growth| match growth > 0.0 {
            true => rise / growth,
            false => f64::INFINITY,
        }))
    }

    /// What lasts over its limit, so many months behind the last date, if it grows on.
    pub(crate) fn lasting_after(&self, months: f64) -> f64 {
        let growth = self.reckoned().unwrap_or(0.0);
        self.lasting_over_limit * 10f64.powf(growth * months / 12.0 / 20.0)
    }
}

/// Sections of some length \[m\] over all surveys of each line, or over those from the latest up to one day to the latest up to
/// another; those that reach their limit first come first. Lines with one survey are left out unless their growth is expected. On
/// all cores.
///
/// Surveys are laid on one another first, window by window by the correlation of their levels, for odometers are off by metres. A level
/// that grows by a dB in a year is taken to go on so: RMS grows as an exponential of time. Growth within the scatter of the surveys
/// is no growth. Sections of which the last survey or all others know less than half in a band are left out, as are surveys by another
/// instrument than that of the last, where both are named: what two differ by is no growth, and no day has both.
///
/// # Errors
/// Errors of the files; [`NetworkError::Nothing`] where no line has two surveys.
pub fn growth(
    store: &Store,
    judgement: &Judgement,
    length: f64,
    between: Option<[Date; 2]>,
) -> Result<Vec<SectionGrowth>, NetworkError> {
    let mut sections: Vec<SectionGrowth> = Vec::new();
    for section in growth_by_band(store, judgement, length, between)? {
        // Of a section, the band that comes first; they stand one behind the other.
        let is_same = |other: &&mut SectionGrowth| {
            other.line == section.line && other.rail == section.rail && other.from_m == section.from_m
        };
        match sections.last_mut().filter(is_same) {
            Some(other) if order(&section, other).is_lt() => *other = section,
            Some(_) => {}
            None => sections.push(section),
        }
    }
    sections.sort_by(order);
    Ok(sections)
}

/// Each section in each band, line by line, rail by rail and place by place.
///
/// # Errors
/// Errors of [`growth`].
pub(crate) fn growth_by_band(
    store: &Store,
    judgement: &Judgement,
    length: f64,
    between: Option<[Date; 2]>,
) -> Result<Vec<SectionGrowth>, NetworkError> {
    let mut lines = chosen(store, between)?;
    let left_out: Vec<String> = lines.iter().filter_map(|line| by_others(line)).collect();
    for line in &mut lines {
        let devices = line.last().map(|last| last.devices.clone());
        line.retain(|survey| !is_other(&survey.devices, devices.as_deref().unwrap_or_default()));
    }
    lines.retain(|line| line.len() > 1 || judgement.expects(&line[0].line));
    if lines.is_empty() {
        let nothing = "no line has surveys of two dates, between which it could have grown".to_owned();
        let sentences: Vec<String> = std::iter::once(nothing).chain(left_out).collect();
        return Err(NetworkError::Nothing(sentences.join("; ")));
    }
    let found: Result<Vec<Vec<SectionGrowth>>, NetworkError> =
        lines.par_iter().map(|surveys| of_line(store, judgement, length, surveys)).collect();
    Ok(found?.into_iter().flatten().collect())
}

/// Sections of a rail at every survey that has them, with the number of the survey.
type OverTime = BTreeMap<i64, Vec<(usize, Section)>>;

/// The sections of a rail at every survey of its line that has it. Where records begin or end within a section, what all of them have of
/// it tells how it grows: a joint that one of them has not does not grow.
fn over_time(
    store: &Store,
    share: f64,
    length: f64,
    surveys: &[SurveyRecord],
    alignments: &[Alignment],
    rail: &RailRecord,
) -> Result<OverTime, NetworkError> {
    let mut sections = OverTime::new();
    for (number, (survey, alignment)) in surveys.iter().zip(alignments).enumerate() {
        let same = |other: &&RailRecord| other.name == rail.name;
        let Some(same) = survey.rails.iter().find(same) else {
            continue;
        };
        let found = Sections::placed(store, survey, same, length, share, alignment, None)?;
        for section in found.sections {
            let of_place = sections.entry(section.index).or_default();
            of_place.push((number, section));
        }
    }
    let resolution = store.resolution()?;
    for of_place in sections.values_mut() {
        let known = of_place.iter().map(|(_, section)| section.known);
        let common =
            known.clone().fold([f64::MIN, f64::MAX], |[from, to], known| [from.max(known[0]), to.min(known[1])]);
        // Records that begin and end within a cell have the same rail.
        let mut off = known.flat_map(|known| [common[0] - known[0], known[1] - common[1]]);
        if !off.any(|off| off > (1.0 + 1e-9) * resolution) {
            continue;
        }
        for (number, section) in of_place {
            let (survey, alignment) = (&surveys[*number], &alignments[*number]);
            let Some(same) = survey.rails.iter().find(|other| other.name == rail.name) else {
                continue;
            };
            let within = Some(common);
            let found = Sections::placed(store, survey, same, length, share, alignment, within)?;
            let unknown = || vec![f64::NAN; section.growing.len()];
            let mut found = found.sections.into_iter();
            let shared = found.find(|other| other.index == section.index);
            (section.growing, section.growing_around) = match shared {
                Some(shared) => (shared.growing, shared.growing_around),
                None => (unknown(), Vec::new()),
            };
        }
    }
    Ok(sections)
}

/// The sections of a line, band by band.
fn of_line(
    store: &Store,
    judgement: &Judgement,
    length: f64,
    surveys: &[SurveyRecord],
) -> Result<Vec<SectionGrowth>, NetworkError> {
    let Some((last, earlier)) = surveys.split_last() else {
        return Ok(Vec::new());
    };
    let alignments: Result<Vec<Alignment>, NetworkError> =
        earlier.par_iter().map(|survey| Alignment::of(store, survey, last)).chain([Ok(Alignment::default())]).collect();
    let alignments = alignments?;
    let rails: Result<Vec<OverTime>, NetworkError> = last
        .rails
        .par_iter()
        .map(|rail| over_time(store, judgement.share, length, surveys, &alignments, rail))
        .collect();
    let years = |survey: &SurveyRecord| {
        let days = surveys[0].date.until(survey.date);
        f64::from(days.map_or(0, |span| span.get_days())) / DAYS_PER_YEAR
    };
    let years: Vec<f64> = surveys.iter().map(years).collect();
    let mut grown = Vec::new();
    for (rail, sections) in last.rails.iter().zip(rails?) {
        for of_place in sections.into_values() {
            let Some((_, latest)) = of_place.last().filter(|(number, _)| *number + 1 == surveys.len()) else {
                continue;
            };
            for band in judgement.bands_of(latest) {
                let known = steadier(&of_place, band.band);
                let points = known.iter().map(|(number, rms)| (years[*number], 20.0 * rms.log10()));
                let points: Vec<(f64, f64)> = points.collect();
                let trend = Trend::new(&points).filter(|_| points.len() > 1);
                let expected = judgement.expected(&last.line, band.band);
                if trend.is_none() && expected.is_none() || known.is_empty() {
                    continue;
                }
                let fall = trend.as_ref().and_then(Trend::fall);
                // Of a rail that was ground to the last survey, the two of which that is known.
                let only_ground = trend.as_ref().is_some_and(Trend::only_ground);
                let before = trend.as_ref().map_or(0, |trend| trend.before);
                let first = before - usize::from(only_ground);
                let (from, to) = (known[first], known[known.len() - 1]);
                let [one, other] = [points[first], points[points.len() - 1]];
                let change = (other.1 - one.1) / (other.0 - one.0);
                let growth = trend.as_ref().map(|trend| trend.growth().unwrap_or(change));
                grown.push((
                    trend,
                    fall,
                    SectionGrowth {
                        line: last.line.clone(),
                        rail: rail.name.clone(),
                        from_m: latest.from,
                        to_m: latest.to,
                        dates: [from.0, to.0].map(|number| surveys[number].date.to_string()),
                        surveys: known.len() - first,
                        band_m: judgement.ends(band.band),
                        rms_m: [from.1, to.1],
                        growth_db_per_year: growth,
                        growth_error_db_per_year: None,
                        expected_growth_db_per_year: expected,
                        rms_over_limit: band.ratio,
                        lasting_over_limit: band.lasting,
                        kind: band.kind(),
                        months_to_limit: None,
                        months_to_limit_band_80: None,
                        ground: only_ground,
                    },
                ));
            }
        }
    }
    let trends = grown.iter().filter_map(|(trend, ..)| trend.clone());
    let trends: Vec<Trend> = trends.collect();
    let scatter = scatter(&trends);
    let sections = grown.into_iter().map(|(trend, fall, mut section)| {
        let is_ground = fall.is_some_and(|fall| fall > CERTAIN_FALL * scatter);
        section.kind = section.kind.or(is_ground.then_some(DefectKind::Ground));
        let trend = trend.filter(|trend| trend.growth().is_some());
        let error = trend.as_ref().map(|trend| trend.growth_error(scatter));
        section.growth_error_db_per_year = error;
        let left = -20.0 * section.rms_over_limit.log10();
        section.months_to_limit = match left <= 0.0 {
            true => Some(0.0),
            false => section.reckoned().map(|growth| 12.0 * left / growth),
        };
        let years_80 = match (section.months_to_limit, trend.filter(|_| !section.ground)) {
            (Some(months), Some(trend)) if months > 0.0 => trend.time_80(left, scatter),
            (Some(months), None) if months > 0.0 => section.expected_years_80(left),
            _ => None,
        };
        section.months_to_limit_band_80 = years_80.map(|years| years.map(|year| 12.0 * year));
        section
    });
    Ok(sections.collect())
}

/// The number of each survey that knows a section in a band, and its RMS \[m\]. Of a section that changes twice as much from survey to
/// survey as it does with a cell more at an end the latter counts: a weld near that end is in it or out of it by half a cell.
fn steadier(of_place: &[(usize, Section)], band: usize) -> Vec<(usize, f64)> {
    let known = |rms: &dyn Fn(&Section) -> f64| -> Vec<(usize, f64)> {
        let all = of_place.iter().filter(|(_, section)| section.growing[band] > 0.0);
        all.map(|(number, section)| (*number, rms(section))).collect()
    };
    let changes = |of: &[(usize, f64)]| -> f64 {
        let pairs = of.windows(2);
        pairs.map(|pair| (pair[1].1 / pair[0].1).ln().abs()).sum()
    };
    let own = known(&|section| section.growing[band]);
    let around = (0..3).map(|ends| known(&|section| section.growing_around[band][ends]));
    let steadiest = around.min_by(|one, other| changes(one).total_cmp(&changes(other)));
    match steadiest {
        Some(around) if changes(&around) < 0.5 * changes(&own) => around,
        _ => own,
    }
}

/// Whether the instruments of a survey are named and are others than those of another.
fn is_other(devices: &[String], others: &[String]) -> bool {
    !devices.is_empty() && !others.is_empty() && devices != others
}

/// A sentence for the surveys of a line that another instrument measured than the last; none without such.
fn by_others(surveys: &[SurveyRecord]) -> Option<String> {
    let last = surveys.last()?;
    let others = surveys.iter();
    let others = others.filter(|survey| is_other(&survey.devices, &last.devices));
    let others = others.map(|survey| format!("{} ({})", survey.date, survey.devices.join(", ")));
    let others: Vec<String> = others.collect();
    (!others.is_empty()).then(|| {
        format!(
            "{}: {} measured on {}, another instrument on {}: what instruments differ by is no growth, and these surveys are left \
             out of it",
            last.line,
            last.devices.join(", "),
            last.date,
            others.join(", ")
        )
    })
}

/// Surveys of which nothing can be said, because another instrument measured the last of their line, and rails, because that has
/// rails of other names than those before; a sentence for each line.
///
/// # Errors
/// Errors of the files.
pub fn left_out_of_growth(store: &Store, between: Option<[Date; 2]>) -> Result<Vec<String>, NetworkError> {
    let names = |survey: &SurveyRecord| -> Vec<String> { survey.rails.iter().map(|rail| rail.name.clone()).collect() };
    // Names of one survey that none of the others has, with its date.
    let lacking = |survey: &SurveyRecord, others: &[&SurveyRecord]| -> Option<String> {
        let known: Vec<String> = others.iter().flat_map(|other| names(other)).collect();
        let alone: Vec<String> = names(survey).into_iter().filter(|name| !known.contains(name)).collect();
        (!alone.is_empty()).then(|| format!("{} of {}", alone.join(", "), survey.date))
    };
    let sentence = |surveys: &Vec<SurveyRecord>| {
        let (last, earlier) = surveys.split_last()?;
        if earlier.is_empty() {
            return None;
        }
        let all: Vec<&SurveyRecord> = earlier.iter().collect();
        let before = earlier.iter().filter_map(|survey| lacking(survey, &[last]));
        let alone: Vec<String> = before.chain(lacking(last, &all)).collect();
        (!alone.is_empty()).then(|| {
            format!(
                "{}: nothing is known of the growth of {}, for these names are not in both the last survey and one before; if a rail \
                 has two names, ingest its survey again with --rename OLD=NEW --replace",
                last.line,
                alone.join("; ")
            )
        })
    };
    let lines = chosen(store, between)?;
    let by_others = lines.iter().filter_map(|line| by_others(line));
    Ok(by_others.chain(lines.iter().filter_map(sentence)).collect())
}

/// Those over their limit by what grinding takes off first, the farthest before; then those that reach it first; then those over it by
/// single places; then those that grow fastest.
fn order(a: &SectionGrowth, b: &SectionGrowth) -> std::cmp::Ordering {
    let class = |one: &SectionGrowth| match (one.kind, one.months_to_limit) {
        (Some(DefectKind::Corrugation | DefectKind::Unknown), _) => 0,
        (Some(DefectKind::Joint | DefectKind::Weld), _) => 2,
        (Some(DefectKind::Ground) | None, Some(_)) => 1,
        (Some(DefectKind::Ground), None) => 3,
        (None, None) => 4,
    };
    let months = |one: &SectionGrowth| one.months_to_limit.unwrap_or(f64::INFINITY);
    let over = |one: &SectionGrowth| one.rms_over_limit.max(1.0);
    let growth = |one: &SectionGrowth| one.growth_db_per_year.unwrap_or(f64::NEG_INFINITY);
    class(a)
        .cmp(&class(b))
        .then(months(a).total_cmp(&months(b)))
        .then(over(b).total_cmp(&over(a)))
        .then(growth(b).total_cmp(&growth(a)))
}

/// The surveys of each line by date; from the first where none is up to the first day.
fn chosen(store: &Store, between: Option<[Date; 2]>) -> Result<Vec<Vec<SurveyRecord>>, NetworkError> {
    let surveys = store.surveys()?;
    let lines = surveys.chunk_by(|a, b| a.line == b.line).map(|line| {
        let until = |day: Date| line.iter().rposition(|survey| survey.date <= day);
        match between {
            None => line.to_vec(),
            Some([from, to]) => match (until(from), until(to)) {
                (first, Some(last)) if first.unwrap_or(0) <= last => line[first.unwrap_or(0)..=last].to_vec(),
                _ => Vec::new(),
            },
        }
    });
    Ok(lines.filter(|line| !line.is_empty()).collect())
}
