//! How sections change between two dates.

use jiff::civil::Date;
use rayon::prelude::*;
use serde::Serialize;

use crate::record::SurveyRecord;
use crate::{Judgement, NetworkError, Sections, Store};

/// Days of a year, in the mean of the calendar.
pub(crate) const DAYS_PER_YEAR: f64 = 365.2425;
/// Fall of a level that no wear makes between surveys: the rail was ground \[dB\].
const GROUND: f64 = -3.0;

/// A section at two dates.
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
    /// The days.
    pub dates: [String; 2],
    /// The band \[m\]: the one that reaches its limit first, or is farthest over it.
    pub band_m: [f64; 2],
    /// RMS at the two dates \[m\].
    pub rms_m: [f64; 2],
    /// Change of the level \[dB a year\].
    pub growth_db_per_year: f64,
    /// RMS over limit at the second date.
    pub rms_over_limit: f64,
    /// Months from the second date until the limit is reached as the level grew between them; 0 where it is reached, none
    /// where it does not grow.
    pub months_to_limit: Option<f64>,
    /// Whether the level fell by more than 3 dB: the rail was ground between the dates.
    pub ground: bool,
}

impl SectionGrowth {
    /// RMS over limit so many months behind the second date, if it grows on as between the two; a rail that was ground has no
    /// growth that is known.
    pub(crate) fn ratio_after(&self, months: f64) -> f64 {
        let growth = match self.ground {
            true => 0.0,
            false => self.growth_db_per_year.max(0.0),
        };
        self.rms_over_limit * 10f64.powf(growth * months / 12.0 / 20.0)
    }
}

/// Sections of some length \[m\] between the two latest surveys of each line up to a day, or between the latest up to each of
/// two days; those that reach their limit first come first. Lines with one survey are left out. On all cores.
///
/// A level that grows by a dB in a year is taken to go on so: RMS grows as an exponential of time. Sections of which one
/// date knows less than half in a band are left out.
///
/// # Errors
/// Those of the files; [`NetworkError::Nothing`] where no line has two surveys.
pub fn growth(
    store: &Store,
    judgement: &Judgement,
    length: f64,
    between: Option<[Date; 2]>,
) -> Result<Vec<SectionGrowth>, NetworkError> {
    let pairs = pairs(store, between)?;
    if pairs.is_empty() {
        return Err(NetworkError::Nothing(
            "no line has surveys of two dates, between which it could have grown".to_owned(),
        ));
    }
    let rails: Vec<_> = pairs
        .iter()
        .flat_map(|pair| pair[1].rails.iter().map(move |rail| (pair, rail)))
        .collect();
    let found: Result<Vec<Vec<SectionGrowth>>, NetworkError> = rails
        .par_iter()
        .map(|([before, after], rail)| {
            let Some(same) = before.rails.iter().find(|other| other.name == rail.name) else {
                return Ok(Vec::new());
            };
            let days = f64::from(
                before
                    .date
                    .until(after.date)
                    .map_or(0, |span| span.get_days()),
            );
            let first = Sections::of(store, before, same, length)?.sections;
            let second = Sections::of(store, after, rail, length)?.sections;
            let mut earlier = first.into_iter().peekable();
            let mut grown = Vec::new();
            for section in second {
                while earlier.next_if(|one| one.index < section.index).is_some() {}
                let Some(was) = earlier.peek().filter(|one| one.index == section.index) else {
                    continue;
                };
                let bands = judgement.ratios(&section.rms).enumerate();
                let bands = bands.filter_map(|(band, ratio)| {
                    let (ratio, was, rms) = (ratio?, was.rms[band], section.rms[band]);
                    if !(was > 0.0 && rms > 0.0) {
                        return None;
                    }
                    let change = 20.0 * (rms / was).log10();
                    let growth = change / days * DAYS_PER_YEAR;
                    let left = -20.0 * ratio.log10();
                    let months = if left <= 0.0 {
                        Some(0.0)
                    } else {
                        (growth > 0.0).then(|| 12.0 * left / growth)
                    };
                    Some(SectionGrowth {
                        line: after.line.clone(),
                        rail: rail.name.clone(),
                        from_m: section.from,
                        to_m: section.to,
                        dates: [before.date.to_string(), after.date.to_string()],
                        band_m: [judgement.bands[band].from(), judgement.bands[band].to()],
                        rms_m: [was, rms],
                        growth_db_per_year: growth,
                        rms_over_limit: ratio,
                        months_to_limit: months,
                        ground: change < GROUND,
                    })
                });
                grown.extend(bands.min_by(order));
            }
            Ok(grown)
        })
        .collect();
    let mut sections: Vec<SectionGrowth> = found?.into_iter().flatten().collect();
    sections.sort_by(order);
    Ok(sections)
}

/// Rails of which nothing can be said because the two surveys of their line do not name them alike, a sentence for each line.
///
/// # Errors
/// Those of the files.
pub fn rails_without_growth(
    store: &Store,
    between: Option<[Date; 2]>,
) -> Result<Vec<String>, NetworkError> {
    let names = |survey: &SurveyRecord| -> Vec<String> {
        survey.rails.iter().map(|rail| rail.name.clone()).collect()
    };
    let sentence = |[before, after]: &[SurveyRecord; 2]| {
        let (known, found) = (names(before), names(after));
        let alone: Vec<&str> = found
            .iter()
            .filter(|name| !known.contains(name))
            .map(String::as_str)
            .collect();
        (!alone.is_empty()).then(|| {
            format!(
                "{}: nothing is known of the growth of {}: the survey of {} has {}",
                after.line,
                alone.join(", "),
                before.date,
                known.join(", ")
            )
        })
    };
    Ok(pairs(store, between)?.iter().filter_map(sentence).collect())
}

/// Those over their limit first, the farthest before; then those that reach it first; then those that grow fastest.
fn order(a: &SectionGrowth, b: &SectionGrowth) -> std::cmp::Ordering {
    let months = |one: &SectionGrowth| one.months_to_limit.unwrap_or(f64::INFINITY);
    let over = |one: &SectionGrowth| one.rms_over_limit.max(1.0);
    months(a)
        .total_cmp(&months(b))
        .then(over(b).total_cmp(&over(a)))
        .then(b.growth_db_per_year.total_cmp(&a.growth_db_per_year))
}

/// Two surveys of each line that has them.
fn pairs(
    store: &Store,
    between: Option<[Date; 2]>,
) -> Result<Vec<[SurveyRecord; 2]>, NetworkError> {
    let surveys = store.surveys()?;
    let mut pairs = Vec::new();
    for line in surveys.chunk_by(|a, b| a.line == b.line) {
        let until = |day: Date| line.iter().rfind(|survey| survey.date <= day);
        let pair = match between {
            Some([from, to]) => until(from).zip(until(to)),
            None => match line {
                [.., before, after] => Some((before, after)),
                _ => None,
            },
        };
        if let Some((before, after)) = pair.filter(|(before, after)| before.date < after.date) {
            pairs.push([before.clone(), after.clone()]);
        }
    }
    Ok(pairs)
}
