//! Measurements of one rail or several, as one-third-octave spectra with what is known of each.

mod rail_dates;

use std::path::{Path, PathBuf};

use jiff::civil::Date;
use riffel::forecast::MeasuredChange;
use riffel::roughness::{AnalysisSettings, Profile, RailAnalysis, Spectrum};
use riffel_keys::{CaseError, Message, number, say};

use rail_dates::in_step;
pub use rail_dates::{Elapsed, RailDates};

use crate::date::{read_date, read_dates};
use crate::rail_name::{is_rail_column, name_alike};
use crate::rail_spectrum::RailSpectrum;
use crate::{LabelledSpectrum, Layout, RoughnessFile, date_column, find_rail};

/// The spectrum of stretches after EN 15610, levels alone; `place` is where they lie in words.
pub(crate) fn spectrum(path: &Path, place: &str, stretches: Vec<Profile>) -> Result<Spectrum, CaseError> {
    let settings = AnalysisSettings { bands: Vec::new(), ..AnalysisSettings::default() };
    let analysis = RailAnalysis::new(stretches, &settings, &|| {})
        .map_err(|error| CaseError::data(path, format!("{place}: {error}")))?;
    Ok(analysis.spectrum)
}

/// Spectra of a file: those of a table, or one for each rail of a profile.
#[derive(Debug, Clone, PartialEq)]
pub struct Survey {
    path: PathBuf,
    /// The spectra.
    pub records: Vec<LabelledSpectrum>,
    /// What was put right in a profile.
    pub warnings: Vec<Message>,
    /// The records of all dates, where these are the latest of several.
    pub history: Option<RailDates>,
}

impl Survey {
    /// Spectra of a file, with what was put right in it.
    ///
    /// # Errors
    /// [`CaseError::Data`] where there is none, or one has a date that is not read.
    pub fn new(path: &Path, mut records: Vec<LabelledSpectrum>, mut warnings: Vec<Message>) -> Result<Self, CaseError> {
        if records.is_empty() {
            return Err(CaseError::data(path, "there is no spectrum in the file"));
        }
        // Those of a file were read with their lines.
        let read = date_column::write_dates_alike(&mut records);
        warnings.extend(read.map_err(|no_date| CaseError::data(path, no_date.message))?);
        let mut survey = Self { path: path.to_owned(), records, warnings, history: None };
        if let (Some(rail), Some(date)) = (survey.rail_column(), survey.date_column()) {
            let (rail, date) = (rail.to_owned(), date.to_owned());
            let dated = survey.records.iter_mut().filter_map(|record| {
                let date = record.label(&date)?.parse().ok()?;
                let mut labels = record.labels.iter_mut();
                let name = labels.find(|(head, _)| *head == rail)?;
                Some((date, &mut name.1))
            });
            name_alike(dated.collect());
        }
        Ok(survey)
    }

    /// One spectrum that is in no file.
    pub fn of_spectrum(spectrum: Spectrum) -> Self {
        let record = LabelledSpectrum { labels: Vec::new(), spectrum };
        Self { path: PathBuf::from("spectrum"), records: vec![record], warnings: Vec::new(), history: None }
    }

    /// What was read of a file; profiles are processed after EN 15610, see [`RailAnalysis`].
    ///
    /// # Errors
    /// [`CaseError::Data`] where a profile has no spectrum.
    pub fn of(path: &Path, file: RoughnessFile) -> Result<Self, CaseError> {
        let record = match file {
            RoughnessFile::Spectra(records, warnings) => return Self::new(path, records, warnings),
            RoughnessFile::Profile(record) => record,
        };
        let mut records = Vec::new();
        let earlier = record.earlier.into_iter();
        let dated = earlier.map(|one| (Some(one.date), one.rails));
        for (date, rails) in dated.chain([(record.date, record.rails)]) {
            for rail in rails {
                let spectrum = spectrum(path, &rail.name, rail.stretches)?;
                let mut spectrum = LabelledSpectrum::of_rail(&rail.name, spectrum);
                let date = date.map(|date| ("date".to_owned(), date.to_string()));
                spectrum.labels.extend(date);
                records.push(spectrum);
            }
        }
        Self::new(path, records, record.warnings)
    }

    /// The file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The columns by which records can be chosen: those besides wavelength and level.
    pub fn columns(&self) -> impl Iterator<Item = &str> {
        let labels = self.records[0].labels.iter();
        labels.map(|(column, _)| column.as_str())
    }

    /// The records whose columns have the values of all choices `COLUMN=VALUE`.
    ///
    /// # Errors
    /// [`CaseError::Data`] for a choice without `=`, a column that is not there, or where nothing is left.
    pub fn choose(mut self, choices: &[String]) -> Result<Self, CaseError> {
        for choice in choices {
            let Some((column, value)) = choice.split_once('=') else {
                let message = format!("the choice is {choice}, but must be COLUMN=VALUE");
                return Err(self.refuse(message));
            };
            self.check_column(column)?;
            // A date may be written as in the file or in another way.
            let date = (self.date_column() == Some(column)).then(|| read_date(value).ok());
            let date = date.flatten().map(|date| date.to_string());
            let chosen = |record: &LabelledSpectrum| {
                let label = record.label(column);
                label == Some(value) || (date.is_some() && label == date.as_deref())
            };
            if !self.records.iter().any(chosen) {
                return Err(self.refuse(format!("no spectrum has {choice}")));
            }
            self.records.retain(chosen);
        }
        self.warnings.extend(self.change_of_device());
        Ok(self)
    }

    /// The column of the dates, by its head or its cells.
    pub fn date_column(&self) -> Option<&str> {
        let column = date_column::of_spectra(&self.records)?;
        self.columns().nth(column)
    }

    /// The records by the values of a column: by dates the earliest first, else in the order of the file; one group
    /// named "all" without a column.
    ///
    /// # Errors
    /// [`CaseError::Data`] for a column that is not there.
    pub fn groups(&self, by: Option<&str>) -> Result<Vec<(String, Self)>, CaseError> {
        match by {
            None => Ok(vec![("all".to_owned(), self.clone())]),
            Some(column) if self.date_column() == Some(column) => {
                let dates = self.by_date(column)?.into_iter();
                Ok(dates.map(|(date, survey)| (date.to_string(), survey)).collect())
            }
            Some(column) => self.groups_in_order(column),
        }
    }

    fn groups_in_order(&self, column: &str) -> Result<Vec<(String, Self)>, CaseError> {
        self.check_column(column)?;
        let mut groups: Vec<(String, Self)> = Vec::new();
        for record in &self.records {
            let name = record.label(column).unwrap_or_default();
            match groups.iter_mut().find(|group| group.0 == name) {
                Some((_, survey)) => survey.records.push(record.clone()),
                None => groups.push((
                    name.to_owned(),
                    Self {
                        path: self.path.clone(),
                        records: vec![record.clone()],
                        warnings: self.warnings.clone(),
                        history: None,
                    },
                )),
            }
        }
        Ok(groups)
    }

    /// The column that names the rail of each record, if there is one.
    pub fn rail_column(&self) -> Option<&str> {
        self.columns().find(|column| is_rail_column(column))
    }

    /// The records of each rail, in the order of the file; all under an empty name where rails are not named.
    pub fn by_rail(&self) -> Vec<(String, Self)> {
        self.rail_column()
            .and_then(|column| self.groups(Some(column)).ok())
            .unwrap_or_else(|| vec![(String::new(), self.clone())])
    }

    /// The names of the rails, in the order of the file; empty if they are not named.
    pub fn rails(&self) -> Vec<String> {
        let rails = self.by_rail().into_iter().map(|(name, _)| name);
        rails.filter(|name| !name.is_empty()).collect()
    }

    /// The records of one rail by any of its names, at all dates; all records without a name, or if rails are not named. `None` if
    /// the rail is not among them.
    pub fn of_rail(mut self, rail: Option<&str>) -> Option<Self> {
        let column = self.rail_column().map(str::to_owned);
        if let (Some(rail), Some(column)) = (rail, column) {
            self.records.retain(|record| {
                let name = record.label(&column).unwrap_or_default();
                find_rail([name].into_iter(), rail).is_some()
            });
            if let Some(history) = &mut self.history {
                let dates = std::mem::take(&mut history.dates).into_iter();
                let dates = dates.filter_map(|(time, survey)| Some((time, survey.of_rail(Some(rail))?)));
                history.dates = dates.collect();
            }
        }
        (!self.records.is_empty()).then_some(self)
    }

    /// The records by the dates in a column, the earliest first.
    ///
    /// # Errors
    /// [`CaseError::Data`] for a column that is not there or holds something else than dates.
    pub fn by_date(&self, column: &str) -> Result<Vec<(Date, Self)>, CaseError> {
        let groups = self.groups_in_order(column)?;
        let read = read_dates(groups.iter().map(|(written, _)| written.as_str()))
            .map_err(|no_date| self.refuse(no_date.of(column).message))?;
        let mut dates: Vec<(Date, Self)> = Vec::new();
        for (date, (_, mut survey)) in read.into_iter().zip(groups) {
            // One date may be written in several ways.
            match dates.iter_mut().find(|(other, _)| *other == date) {
                Some((_, same)) => same.records.append(&mut survey.records),
                None => dates.push((date, survey)),
            }
        }
        dates.sort_by_key(|(date, _)| *date);
        Ok(dates)
    }

    /// The column of dates, where the records are of more than one.
    pub fn column_of_several_dates(&self) -> Option<&str> {
        let column = self.date_column()?;
        let dates = self.by_date(column).ok()?;
        (dates.len() > 1).then_some(column)
    }

    /// The latest records of each rail, with the last of their dates: what the rail is like now. Records without dates
    /// are all of now; those of other instruments are laid on that of the last date. A warning says what was left out.
    pub fn latest(self) -> (Self, Option<Date>) {
        let Some(column) = self.date_column().map(str::to_owned) else {
            return (self, None);
        };
        let Ok(dates) = self.by_date(&column) else {
            return (self, None);
        };
        let Some((last, _)) = dates.last() else {
            return (self, None);
        };
        let last = *last;
        if dates.len() == 1 || self.history.is_some() {
            return (self, Some(last));
        }
        let survey = self.on_one_device();
        let dates = survey.by_date(&column).unwrap_or_default();
        let rails = survey.by_rail();
        let records = rails.iter().filter_map(|(_, rail)| {
            let (_, survey) = rail.by_date(&column).ok()?.pop()?;
            Some(survey.records)
        });
        let records: Vec<LabelledSpectrum> = records.flatten().collect();
        let mut warnings = survey.warnings;
        if records.len() < survey.records.len() {
            warnings.push(say!(
                now_is_latest_of_each_rail,
                column,
                count = number(dates.len()),
                last = last.to_string()
            ));
        }
        // Of other instruments there may be no date left.
        let has_dates = dates.len() > 1;
        let days = |date: Date| date.since(last).map_or(0, |span| span.get_days());
        let dates = dates.into_iter();
        let dates = dates.map(|(date, survey)| (f64::from(days(date)), survey));
        let latest = Self {
            path: survey.path,
            records,
            warnings,
            history: has_dates.then(|| RailDates { dates: dates.collect(), elapsed: Elapsed::Days }),
        };
        (latest, Some(last))
    }

    /// The energy mean of the latest that a file has, its layout told from itself.
    ///
    /// # Errors
    /// Errors of [`RoughnessFile::read`] and [`of`](Self::of).
    pub fn mean_of(path: &Path) -> Result<Spectrum, CaseError> {
        let file = RoughnessFile::read(path, &Layout::default(), &|_| ())?;
        Ok(Self::of(path, file)?.latest().0.mean())
    }

    /// Energy mean of the records.
    pub fn mean(&self) -> Spectrum {
        let spectra = self.spectra();
        // There is a record in every survey, and a band in every record.
        Spectrum::energy_mean(&spectra).unwrap_or_else(|| spectra[0].clone())
    }

    /// The energy mean of each rail, in the order of the file; of all records where rails are not named.
    pub fn rail_means(&self) -> Vec<RailSpectrum> {
        let named = self.rail_column().is_some();
        let rails = self.by_rail().into_iter();
        rails.map(|(name, survey)| RailSpectrum { rail: named.then_some(name), spectrum: survey.mean() }).collect()
    }

    /// The spectra.
    pub fn spectra(&self) -> Vec<Spectrum> {
        let records = self.records.iter();
        records.map(|record| record.spectrum.clone()).collect()
    }

    /// The change from an earlier survey to this one, with the axle passages between.
    ///
    /// Records are paired by the columns that hold the same values in both surveys, if these tell the
    /// records of each apart.
    ///
    /// # Errors
    /// [`riffel::Error::OutOfRange`] for passages not above zero.
    pub fn change_since(&self, earlier: &Self, passages: f64) -> Result<MeasuredChange, riffel::Error> {
        let (mut records, paired) = in_step(&[&earlier.with_names_of(self), self]);
        let (later, earlier) = (records.pop().unwrap_or_default(), records.pop().unwrap_or_default());
        match paired {
            true => MeasuredChange::paired(earlier, later, passages),
            false => MeasuredChange::groups(earlier, later, passages),
        }
    }

    /// The survey with the names that another one has for its rails and the column of them.
    pub(crate) fn with_names_of(&self, other: &Self) -> Self {
        let mut named = self.clone();
        let (Some(own), Some(column)) = (self.rail_column(), other.rail_column()) else {
            return named;
        };
        let names = other.rails();
        let labels = named.records.iter_mut().flat_map(|one| &mut one.labels);
        for (head, rail) in labels.filter(|(head, _)| head == own) {
            column.clone_into(head);
            if let Some(place) = find_rail(names.iter().map(String::as_str), rail) {
                rail.clone_from(&names[place]);
            }
        }
        named
    }

    fn check_column(&self, column: &str) -> Result<(), CaseError> {
        if self.columns().any(|known| known == column) {
            return Ok(());
        }
        let there: Vec<&str> = self.columns().collect();
        Err(self.refuse(match &there[..] {
            [] => format!("no column \"{column}\" to choose by; there are wavelengths and levels alone"),
            there => format!("no column \"{column}\" to choose by; there are {}", there.join(", ")),
        }))
    }

    fn refuse(&self, message: impl Into<Message>) -> CaseError {
        CaseError::data(&self.path, message)
    }
}
