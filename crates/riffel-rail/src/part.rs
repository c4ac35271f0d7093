//! Part of a record: one rail of it, or what lies between two positions.

use std::path::Path;

use riffel::roughness::Profile;
use riffel_keys::quantity::{Length, Quantity};
use riffel_keys::{CaseError, say};

use crate::{EarlierRails, LabelledSpectrum, Rail, Record, RoughnessFile, Survey, find_rail};

/// Shortest part of a stretch that is kept \[m\]: the shortest segment of EN 15610.
const SHORTEST: f64 = 1.0;

/// What is taken of a record; by default all of it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct RecordPart {
    /// Name of the only rail.
    pub rail: Option<String>,
    /// First position.
    pub from: Option<Quantity<Length>>,
    /// Last position.
    pub to: Option<Quantity<Length>>,
}

impl RecordPart {
    /// Rails of a record with what lies in this part of them.
    ///
    /// # Errors
    /// [`CaseError::Data`] for a rail that is not there, with the names of those that are; for positions that
    /// do not rise, or with less than 1 m of a rail between them.
    pub fn of_rails(&self, path: &Path, mut rails: Vec<Rail>) -> Result<Vec<Rail>, CaseError> {
        if let Some(name) = &self.rail {
            let names: Vec<String> = rails.iter().map(|rail| rail.name.clone()).collect();
            let Some(name) = named(&names, name) else {
                return Err(no_rail(path, name, &names));
            };
            rails.retain(|rail| rail.name == *name);
        }
        if self.from.is_none() && self.to.is_none() {
            return Ok(rails);
        }
        let from = self.from.map_or(f64::NEG_INFINITY, |from| from.si());
        let to = self.to.map_or(f64::INFINITY, |to| to.si());
        if from >= to {
            let message = say!(positions_do_not_rise, from, to);
            return Err(CaseError::data(path, message));
        }
        let all = || rails.iter().flat_map(|rail| &rail.stretches);
        let first = all().map(Profile::start).fold(f64::INFINITY, f64::min);
        let end = |stretch: &Profile| stretch.start() + stretch.length();
        let last = all().map(end).fold(f64::NEG_INFINITY, f64::max);
        for rail in &mut rails {
            let parts = rail.stretches.iter();
            rail.stretches = parts
                .filter_map(|stretch| stretch.between(from, to))
                // The samples of a metre stand for less by one step.
                .filter(|part| part.length() >= SHORTEST * (1.0 - 2e-3))
                .collect();
            if rail.stretches.is_empty() {
                let message = format!(
                    "rail {} has no stretch of {SHORTEST} m {}; the record reaches from {first:.3} m to {last:.3} m",
                    rail.name,
                    self.place()
                );
                return Err(CaseError::data(path, message));
            }
        }
        Ok(rails)
    }

    /// The place in words.
    fn place(&self) -> String {
        match (self.from, self.to) {
            (Some(from), Some(to)) => format!("between {} m and {} m", from.si(), to.si()),
            (Some(from), None) => format!("beyond {} m", from.si()),
            (None, Some(to)) => format!("before {} m", to.si()),
            (None, None) => "at all".to_owned(),
        }
    }
}

/// The name that the file has for a rail.
fn named<'a>(names: &'a [String], name: &str) -> Option<&'a String> {
    let place = find_rail(names.iter().map(String::as_str), name)?;
    names.get(place)
}

fn no_rail(path: &Path, name: &str, names: &[String]) -> CaseError {
    let names = names.join(", ");
    let message = format!("there is no rail \"{name}\" in the file; there are {names}");
    CaseError::data(path, message)
}

impl Record {
    /// This part of the record.
    ///
    /// # Errors
    /// Errors of [`RecordPart::of_rails`].
    pub fn part(mut self, path: &Path, part: &RecordPart) -> Result<Self, CaseError> {
        if let Some(name) = &part.rail {
            // Columns are in the order of the rails, again for each record.
            let names: Vec<String> = self.rails.iter().map(|rail| rail.name.clone()).collect();
            let own = named(&names, name);
            let kept: Vec<bool> = names.iter().map(|name| Some(name) == own).collect();
            if kept.contains(&true) {
                let columns = self.format.rails.len();
                let mut column = 0..;
                self.format.rails.retain(|_| {
                    let column = column.next().unwrap_or(0);
                    kept.iter().skip(column).step_by(columns).any(|&kept| kept)
                });
            }
        }
        self.rails = part.of_rails(path, self.rails)?;
        // Of an earlier date there may be less.
        self.earlier = std::mem::take(&mut self.earlier)
            .into_iter()
            .filter_map(|EarlierRails { date, rails }| {
                let rails = part.of_rails(path, rails).ok()?;
                Some(EarlierRails { date, rails })
            })
            .collect();
        [self.from, self.to] = Rail::ends(&self.rails);
        Ok(self)
    }
}

impl RoughnessFile {
    /// This part of what the file holds.
    ///
    /// # Errors
    /// Errors of [`RecordPart::of_rails`]; also for a rail of a table that does not name its rails, or a place in a
    /// table.
    pub fn part(self, path: &Path, part: &RecordPart) -> Result<Self, CaseError> {
        match self {
            Self::Profile(record) => record.part(path, part).map(Self::Profile),
            Self::Spectra(spectra, remarks) => {
                let spectra = part.of_spectra(path, spectra)?;
                Ok(Self::Spectra(spectra, remarks))
            }
        }
    }
}

impl RecordPart {
    /// The spectra of the rail.
    ///
    /// # Errors
    /// Errors of [`RoughnessFile::part`].
    pub fn of_spectra(&self, path: &Path, spectra: Vec<LabelledSpectrum>) -> Result<Vec<LabelledSpectrum>, CaseError> {
        if let Some((name, position)) =
            [("--from", self.from), ("--to", self.to)].into_iter().find_map(|(name, position)| Some((name, position?)))
        {
            let message = say!(spectra_have_no_positions, key = name, position);
            return Err(CaseError::data(path, message));
        }
        let Some(name) = &self.rail else {
            return Ok(spectra);
        };
        let survey = Survey::new(path, spectra, Vec::new())?;
        let rails = survey.by_rail();
        if survey.rail_column().is_none() {
            let message = say!(no_column_of_rails, rail = name);
            return Err(CaseError::data(path, message));
        }
        let names: Vec<String> = rails.iter().map(|(rail, _)| rail.clone()).collect();
        let own = named(&names, name);
        let chosen = rails.into_iter().find(|(rail, _)| Some(rail) == own);
        chosen.map(|(_, survey)| survey.records).ok_or_else(|| no_rail(path, name, &names))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rails() -> Vec<Rail> {
        ["left", "right"]
            .map(|name| Rail {
                name: name.to_owned(),
                stretches: vec![
                    Profile::new(100.0, 0.01, vec![0.0; 5000]).unwrap(),
                    Profile::new(200.0, 0.01, vec![0.0; 5000]).unwrap(),
                ],
            })
            .to_vec()
    }

    fn refusal(part: &RecordPart) -> String {
        part.of_rails(Path::new("file"), rails()).unwrap_err().to_string()
    }

    #[test]
    fn one_rail_between_two_positions_is_taken() {
        let part = RecordPart {
            rail: Some("right".to_owned()),
            from: Some(Quantity::new(140.0)),
            to: Some(Quantity::new(220.0)),
        };
        let taken = part.of_rails(Path::new("file"), rails()).unwrap();
        assert_eq!(taken.len(), 1);
        let ends: Vec<(f64, usize)> =
            taken[0].stretches.iter().map(|stretch| (stretch.start(), stretch.heights().len())).collect();
        assert_eq!(ends, [(140.0, 1000), (200.0, 2000)]);
        let all = RecordPart::default();
        assert_eq!(all.of_rails(Path::new("file"), rails()).unwrap(), rails());
    }

    #[test]
    fn what_is_not_there_is_refused_with_what_is() {
        let low = RecordPart { rail: Some("low".to_owned()), ..RecordPart::default() };
        assert!(refusal(&low).contains("no rail \"low\" in the file; there are left, right"));
        let gap =
            RecordPart { from: Some(Quantity::new(160.0)), to: Some(Quantity::new(190.0)), ..RecordPart::default() };
        let message = refusal(&gap);
        assert!(message.contains("between 160 m and 190 m") && message.contains("100.000 m to 250.000 m"), "{message}");
        let turned =
            RecordPart { from: Some(Quantity::new(190.0)), to: Some(Quantity::new(160.0)), ..RecordPart::default() };
        assert!(refusal(&turned).contains("must rise"));
    }
}
