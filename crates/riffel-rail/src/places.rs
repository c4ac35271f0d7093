//! A profile place by place: as many records as tell how sure a change is.

use std::collections::BTreeSet;
use std::path::Path;

use riffel::roughness::Profile;
use riffel_keys::CaseError;

use crate::survey::spectrum;
use crate::{LabelledSpectrum, Rail, Record, RoughnessFile, Survey, find_rail};

/// Length of a place \[m\]: long enough for third octaves up to 0.25 m, and that of which the page shows a spectrum.
const PLACE: f64 = 10.0;
/// Fewest places of both dates from which the scatter of a change is told.
const FEWEST: usize = 3;

impl Survey {
    /// Two profiles of one rail as records of the places that are in both, the earlier first; `None` where one is a table
    /// or fewer than three places are in both.
    ///
    /// A place is a whole 10 m of a rail from a multiple of 10 m on, so that positions must be those of the line on both
    /// dates, to a small part of 10 m.
    ///
    /// # Errors
    /// [`CaseError::Data`] where a place has no spectrum.
    pub fn at_same_places(
        earlier: (&Path, &RoughnessFile),
        later: (&Path, &RoughnessFile),
    ) -> Result<Option<[Self; 2]>, CaseError> {
        let (RoughnessFile::Profile(before), RoughnessFile::Profile(now)) = (earlier.1, later.1) else {
            return Ok(None);
        };
        // One rail may have a name of its own in each file.
        let now = &now.with_names_of(before);
        let both = &places(before) & &places(now);
        if both.len() < FEWEST {
            return Ok(None);
        }
        let at_both = |path, record: &Record| {
            let rails = record.rails.iter();
            let records: Vec<Vec<LabelledSpectrum>> =
                rails.map(|rail| at_places(path, rail, &both)).collect::<Result<_, _>>()?;
            Self::new(path, records.concat(), record.warnings.clone())
        };
        Ok(Some([at_both(earlier.0, before)?, at_both(later.0, now)?]))
    }
}

impl Record {
    /// The record with the names that another one has for its rails.
    fn with_names_of(&self, other: &Self) -> Self {
        let mut named = self.clone();
        for rail in &mut named.rails {
            let names = other.rails.iter().map(|rail| rail.name.as_str());
            if let Some(place) = find_rail(names, &rail.name) {
                rail.name.clone_from(&other.rails[place].name);
            }
        }
        named
    }
}

/// Names of the rails with the numbers of their places.
fn places(record: &Record) -> BTreeSet<(&str, i64)> {
    let rails = record.rails.iter();
    rails
        .flat_map(|rail| {
            let numbers = rail.stretches.iter().flat_map(numbers);
            numbers.map(|number| (rail.name.as_str(), number))
        })
        .collect()
}

/// The whole places of a stretch.
fn numbers(stretch: &Profile) -> std::ops::Range<i64> {
    // Rounding must not take the first place or the last.
    let tolerance = 1e-3 * stretch.spacing();
    let end = stretch.start() + stretch.length();
    let first = ((stretch.start() - tolerance) / PLACE).ceil();
    let last = ((end + tolerance) / PLACE).floor();
    first as i64..last as i64
}

/// The spectra of the places of a rail.
fn at_places(path: &Path, rail: &Rail, wanted: &BTreeSet<(&str, i64)>) -> Result<Vec<LabelledSpectrum>, CaseError> {
    let mut records = Vec::new();
    for stretch in &rail.stretches {
        let places = numbers(stretch).filter(|&number| wanted.contains(&(rail.name.as_str(), number)));
        for number in places {
            let from = number as f64 * PLACE;
            let part = stretch.between(from, from + PLACE).into_iter().collect();
            let spectrum = spectrum(path, &format!("{} at {from} m", rail.name), part)?;
            let mut record = LabelledSpectrum::of_rail(&rail.name, spectrum);
            record.labels.push(("place_m".to_owned(), from.to_string()));
            records.push(record);
        }
    }
    Ok(records)
}
