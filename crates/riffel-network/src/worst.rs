//! Where a network is roughest.

use jiff::civil::Date;
use rayon::prelude::*;
use serde::Serialize;

use crate::{Judgement, NetworkError, Sections, Store};

/// A section that is rough.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WorstPlace {
    /// The line.
    pub line: String,
    /// Day of the survey.
    pub date: String,
    /// The rail.
    pub rail: String,
    /// First place \[m\].
    pub from_m: f64,
    /// Last place \[m\].
    pub to_m: f64,
    /// The band that is farthest over its limit \[m\].
    pub band_m: [f64; 2],
    /// RMS in it \[m\].
    pub rms_m: f64,
    /// RMS over limit.
    pub rms_over_limit: f64,
}

/// Sections of some length \[m\] of the latest surveys, up to a day, the farthest over their limit first; at most `most`. On
/// all cores, a line on each.
///
/// # Errors
/// Those of the files; [`NetworkError::Value`] for a section shorter than a cell.
pub fn worst(
    store: &Store,
    judgement: &Judgement,
    length: f64,
    until: Option<Date>,
    most: usize,
) -> Result<Vec<WorstPlace>, NetworkError> {
    let latest = store.latest(until)?;
    let rails: Vec<_> = latest
        .iter()
        .flat_map(|survey| survey.rails.iter().map(move |rail| (survey, rail)))
        .collect();
    let found: Result<Vec<Vec<WorstPlace>>, NetworkError> = rails
        .par_iter()
        .map(|(survey, rail)| {
            let sections = Sections::of(store, survey, rail, length)?;
            let mut places: Vec<WorstPlace> = sections
                .sections
                .into_iter()
                .filter_map(|section| {
                    let (band, ratio) = judgement.worst(&section.rms)?;
                    Some(WorstPlace {
                        line: survey.line.clone(),
                        date: survey.date.to_string(),
                        rail: rail.name.clone(),
                        from_m: section.from,
                        to_m: section.to,
                        band_m: [judgement.bands[band].from(), judgement.bands[band].to()],
                        rms_m: section.rms[band],
                        rms_over_limit: ratio,
                    })
                })
                .collect();
            first(&mut places, most);
            Ok(places)
        })
        .collect();
    let mut places: Vec<WorstPlace> = found?.into_iter().flatten().collect();
    first(&mut places, most);
    Ok(places)
}

/// Keep the worst; equal ones stay in the order of lines and places.
fn first(places: &mut Vec<WorstPlace>, most: usize) {
    places.sort_by(|a, b| b.rms_over_limit.total_cmp(&a.rms_over_limit));
    places.truncate(most);
}
