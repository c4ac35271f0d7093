//! Where a network is roughest.

use std::collections::{HashMap, HashSet};

use jiff::civil::Date;
use rayon::prelude::*;
use serde::Serialize;

use crate::alignment::Alignment;
use crate::growth::growth_by_band;
use crate::judgement::DefectKind;
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
    /// RMS over limit: of the cells of the section, that which no more than the share allowed exceed.
    pub rms_over_limit: f64,
    /// What makes it rough, where it is over its limit; whether it was ground, where it is within.
    pub kind: Option<DefectKind>,
    /// By how much it grows in that band \[dB a year\], where surveys show it.
    pub growth_db_per_year: Option<f64>,
}

/// Sections of some length \[m\] of the latest surveys, up to a day; at most `most`. On all cores, a line on each.
///
/// First come those over their limit by what lasts along the rail, which grinding takes off, in the order of RMS over limit a year
/// ahead as they grow; then those over it by joints and other single places; then all others.
///
/// # Errors
/// Errors of the files; [`NetworkError::Value`] for a section shorter than a cell.
pub fn worst(
    store: &Store,
    judgement: &Judgement,
    length: f64,
    until: Option<Date>,
    most: usize,
) -> Result<Vec<WorstPlace>, NetworkError> {
    let latest = store.latest(until)?;
    let rails: Vec<_> = latest.iter().flat_map(|survey| survey.rails.iter().map(move |rail| (survey, rail))).collect();
    let grown = match growth_by_band(store, judgement, length, until.map(|day| [Date::MIN, day])) {
        Ok(grown) => grown,
        Err(NetworkError::Nothing(_)) => Vec::new(),
        Err(error) => return Err(error),
    };
    let at = |line: &str, rail: &str, from: f64| {
        let index = (from / length).round() as i64;
        (line.to_owned(), rail.to_owned(), index)
    };
    let (mut growing, mut ground) = (HashMap::new(), HashSet::new());
    for one in &grown {
        let at = at(&one.line, &one.rail, one.from_m);
        if one.kind == Some(DefectKind::Ground) {
            ground.insert(at.clone());
        }
        if let Some(growth) = one.certain() {
            growing.insert((at, one.band_m.map(f64::to_bits)), growth);
        }
    }
    let found: Result<Vec<Vec<WorstPlace>>, NetworkError> = rails
        .par_iter()
        .map(|(survey, rail)| {
            let (share, here) = (judgement.share, Alignment::default());
            let sections = Sections::placed(store, survey, rail, length, share, &here, None)?;
            let mut places: Vec<WorstPlace> = sections
                .sections
                .into_iter()
                .filter_map(|section| {
                    let found = judgement.worst(&section)?;
                    let band_m = judgement.ends(found.band);
                    let at = at(&survey.line, &rail.name, section.from);
                    let was_ground = ground.contains(&at).then_some(DefectKind::Ground);
                    let growth = growing.get(&(at, band_m.map(f64::to_bits)));
                    Some(WorstPlace {
                        line: survey.line.clone(),
                        date: survey.date.to_string(),
                        rail: rail.name.clone(),
                        from_m: section.from,
                        to_m: section.to,
                        band_m,
                        rms_m: section.rms[found.band],
                        rms_over_limit: found.ratio,
                        kind: found.kind().or(was_ground),
                        growth_db_per_year: growth.copied(),
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
    let class = |place: &WorstPlace| match place.kind {
        Some(DefectKind::Corrugation | DefectKind::Unknown) => 0,
        Some(DefectKind::Joint | DefectKind::Weld) => 1,
        Some(DefectKind::Ground) | None => 2,
    };
    let ahead = |place: &WorstPlace| place.rms_over_limit * 10f64.powf(place.growth_db_per_year.unwrap_or(0.0) / 20.0);
    places.sort_by(|a, b| class(a).cmp(&class(b)).then(ahead(b).total_cmp(&ahead(a))));
    places.truncate(most);
}
