//! The surveys of a store, and what of it is lost or is not as it was written.

use std::fs;
use std::path::Path;

use jiff::civil::Date;
use rayon::prelude::*;

use crate::NetworkError;
use crate::error::Damage;
use crate::name::{array_name, arrays_name, record_name};
use crate::record::SurveyRecord;
use crate::store::{ROWS, Store, StoreSettings};

impl Store {
    /// A store that is there. All of it is read, and surveys of which something is lost or damaged are left out: see
    /// [`damaged`](Self::damaged).
    ///
    /// # Errors
    /// [`NetworkError::NoNetwork`] where there is none; [`NetworkError::DamagedStore`].
    pub fn open(folder: &Path) -> Result<Self, NetworkError> {
        let mut store = Self { folder: folder.to_owned(), settings: StoreSettings::default(), damage: Damage::new() };
        match store.record()? {
            Some(_) => {
                store.damage = store.find_damage()?;
                Ok(store)
            }
            None => Err(NetworkError::NoNetwork { folder: folder.to_owned() }),
        }
    }

    /// The surveys that are there, by line and date.
    ///
    /// # Errors
    /// [`NetworkError::Read`].
    pub fn surveys(&self) -> Result<Vec<SurveyRecord>, NetworkError> {
        let (mut surveys, _) = self.records()?;
        surveys.retain(|survey| {
            let record = self.line_folder(&survey.line).join(record_name(survey.date));
            !self.damage.contains_key(&record)
        });
        Ok(surveys)
    }

    /// The latest survey of each line, or the latest up to a day.
    ///
    /// # Errors
    /// Errors of [`surveys`](Self::surveys).
    pub fn latest(&self, until: Option<Date>) -> Result<Vec<SurveyRecord>, NetworkError> {
        let mut latest: Vec<SurveyRecord> = Vec::new();
        let surveys = self.surveys()?.into_iter();
        for survey in surveys.filter(|survey| until.is_none_or(|day| survey.date <= day)) {
            match latest.last_mut().filter(|last| last.line == survey.line) {
                Some(last) => *last = survey,
                None => latest.push(survey),
            }
        }
        Ok(latest)
    }

    /// The surveys whose records can be believed, by line and date, and what is wrong with the others.
    pub(crate) fn records(&self) -> Result<(Vec<SurveyRecord>, Damage), NetworkError> {
        let (mut surveys, mut damage) = (Vec::new(), Damage::new());
        for line in self.line_folders()? {
            let files = Self::record_files(&line)?;
            for arrays in Self::arrays_without(&line, &files)? {
                let reason = "its record is lost".to_owned();
                let lost = NetworkError::Damaged { path: arrays.clone(), reason };
                damage.insert(arrays, lost);
            }
            for file in files {
                match self.record_of(&line, &file) {
                    Ok(survey) => surveys.push(survey),
                    Err(error) => _ = damage.insert(file, error),
                }
            }
        }
        surveys.sort_by(|a: &SurveyRecord, b| (&a.line, a.date).cmp(&(&b.line, b.date)));
        Ok((surveys, damage))
    }

    /// The record in a file of the folder of a line, if it is one of its own.
    fn record_of(&self, line: &Path, file: &Path) -> Result<SurveyRecord, NetworkError> {
        let bytes = fs::read(file).map_err(NetworkError::read(file))?;
        let survey: SurveyRecord = parsed(file, &bytes)?;
        let rails = survey.rails.iter().enumerate();
        let mut arrays = rails.map(|(index, rail)| array_name(&rail.name, index));
        let is_own = self.line_folder(&survey.line) == line
            && line.join(record_name(survey.date)) == file
            && survey.folder == arrays_name(survey.date, &survey.sha256)
            && survey.rails.iter().all(|rail| arrays.next().as_ref() == Some(&rail.array));
        let possible = match is_own {
            true => survey.check(self.resolution()?),
            false => Err("it is the record of another survey"),
        };
        let wrong = |reason: &str| NetworkError::Damaged { path: file.to_owned(), reason: reason.to_owned() };
        possible.map_err(wrong)?;
        Ok(survey)
    }

    /// `Ok` if the arrays of a survey are there as its record says; all of them are read.
    pub(crate) fn check_arrays(&self, survey: &SurveyRecord) -> Result<(), NetworkError> {
        let bands = self.bands()?.len();
        for rail in &survey.rails {
            let mut known = 0;
            for chunk in 0..survey.cells.div_ceil(ROWS) {
                let values = self.chunk(survey, rail, bands, chunk)?;
                let cells = values.iter().flat_map(|values| values.chunks(bands));
                let is_known = |cell: &&[f64]| cell.iter().any(|rms| rms.is_finite());
                known += cells.filter(is_known).count() as u64;
            }
            if known != rail.measured {
                return Err(NetworkError::Damaged {
                    path: self.line_folder(&survey.line).join(&survey.folder),
                    reason: format!(
                        "of rail {}, {} cells were measured, but {known} are there",
                        rail.name, rail.measured
                    ),
                });
            }
        }
        Ok(())
    }

    /// What is wrong with surveys; all of them are read, on all cores.
    pub(crate) fn find_damage(&self) -> Result<Damage, NetworkError> {
        let (surveys, mut damage) = self.records()?;
        damage.par_extend(surveys.par_iter().filter_map(|survey| {
            let record = self.line_folder(&survey.line).join(record_name(survey.date));
            Some((record, self.check_arrays(survey).err()?))
        }));
        Ok(damage)
    }

    /// The store, if nothing of it is lost or damaged.
    ///
    /// # Errors
    /// The first damage.
    pub fn whole(mut self) -> Result<Self, NetworkError> {
        match self.damage.pop_first() {
            Some((_, error)) => Err(error),
            None => Ok(self),
        }
    }

    /// What is lost or damaged of the store, as it was when it was [opened](Self::open): surveys that are left out everywhere.
    pub fn damaged(&self) -> impl Iterator<Item = &NetworkError> {
        self.damage.values()
    }
}

fn parsed<T: serde::de::DeserializeOwned>(path: &Path, bytes: &[u8]) -> Result<T, NetworkError> {
    serde_json::from_slice(bytes)
        .map_err(|error| NetworkError::Damaged { path: path.to_owned(), reason: error.to_string() })
}
