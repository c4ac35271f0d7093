//! A file of what is different: keys of a case in place of its own, and other speeds.

use riffel_keys::{CaseError, KeyFile, Message, say};
use std::path::Path;

use riffel::forecast::SpeedDistribution;
use riffel_keys::quantity::{Quantity, Ratio, Speed};
use riffel_keys::text_file::read_keys;
use serde::Deserialize;
use toml::Value;

use crate::case::hold::{Hold, MEAN_STATE, rolls_alike};
use crate::file::CaseFile;
use crate::file::setting::{Setting, settings};
use crate::text::case_text::case_keys;

/// A change of a case and of the speeds on it: "softer pads", "20 km/h less".
///
/// The file has the tables of a case file with the keys that change, a `title`, and a table `[speed]` with
/// `mean` or `factor` and `standard_deviation`.
#[derive(Clone)]
pub struct Variant {
    /// What it is, for tables and legends.
    pub title: String,
    /// What becomes of the speeds.
    pub speed: SpeedChange,
    /// What becomes of keys of the case.
    pub settings: Vec<Setting>,
    /// What is held where friction or load change; left out, the creepage where the case or the vehicle gives
    /// that, else the tractive ratio.
    pub hold: Option<Hold>,
    /// What is to be asked about speeds that are not usual.
    pub(crate) remarks: Vec<Message>,
    /// The file, where it was read from one.
    source: Option<KeyFile>,
}

/// What becomes of every distribution of speed.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SpeedChange {
    /// Mean in place of its own.
    pub mean: Option<Quantity<Speed>>,
    /// Factor of every speed.
    pub factor: Option<Quantity<Ratio>>,
    /// Standard deviation in place of its own: a normal distribution about the mean.
    pub standard_deviation: Option<Quantity<Speed>>,
    /// Factor of its own standard deviation, that of each vehicle: a normal distribution about the mean.
    pub standard_deviation_factor: Option<Quantity<Ratio>>,
}

/// The keys that are not of the case.
#[derive(Deserialize)]
struct Own {
    title: Option<String>,
    #[serde(default)]
    speed: SpeedChange,
}

impl Variant {
    /// The case as it is.
    pub fn none(title: &str) -> Self {
        Self {
            title: title.to_owned(),
            speed: SpeedChange::default(),
            settings: Vec::new(),
            hold: None,
            remarks: Vec::new(),
            source: None,
        }
    }

    /// Read a file; its name is the title where it has none.
    ///
    /// # Errors
    /// [`CaseError`] with the key, the value and the rule. Keys of the case are checked with the case.
    pub fn read(path: &Path) -> Result<Self, CaseError> {
        let text = read_keys(path, "file of changes")?;
        let mut variant = Self::parse(&path.display().to_string(), &text)?;
        if variant.title.is_empty() {
            let stem = path.file_stem().unwrap_or_default().to_string_lossy();
            variant.title = stem.into_owned();
        }
        Ok(variant)
    }

    /// Read changes from TOML; `name` is shown in errors.
    ///
    /// # Errors
    /// Errors of [`read`](Self::read).
    pub fn parse(name: &str, text: &str) -> Result<Self, CaseError> {
        let source = case_keys(name, text)?;
        if let Some(Value::Array(_)) = source.table().get("vehicle") {
            return Err(source.refuse("vehicle", say!(traffic_file_for_changes)));
        }
        let own: Own = source.deserialize()?;
        let change = own.speed;
        if change.mean.is_some() && change.factor.is_some() {
            return Err(source.invalid(
                "speed.factor",
                say!(and_exclude_each_other, other = "speed.mean"),
                say!(give_one_of_the_two),
            ));
        }
        if change.standard_deviation.is_some() && change.standard_deviation_factor.is_some() {
            return Err(source.invalid(
                "speed.standard_deviation_factor",
                say!(and_exclude_each_other, other = "speed.standard_deviation"),
                say!(give_one_of_the_two),
            ));
        }
        let mut remarks = Vec::new();
        for key in ["speed.mean", "speed.factor", "speed.standard_deviation"] {
            remarks.extend(source.judge(key)?);
        }
        let mut keys = source.table().clone();
        keys.remove("title");
        keys.remove("speed");
        let settings = settings(&keys);
        if settings.is_empty() && change == SpeedChange::default() {
            return Err(source.invalid("", say!(the_file_of_changes_changes_nothing), say!(write_keys_of_the_case_as)));
        }
        Ok(Self {
            title: own.title.unwrap_or_default(),
            speed: change,
            settings,
            hold: None,
            remarks,
            source: Some(source),
        })
    }

    /// The keys that it changes, dotted.
    pub fn keys(&self) -> impl Iterator<Item = &str> {
        self.settings.iter().map(|(key, _)| &**key)
    }

    /// What it holds of the mean state, from the keys of a vehicle before the change to those after it; `None` if
    /// friction and load stay, or the file gives the mean state itself.
    pub(crate) fn holds(&self, before: &CaseFile, after: &CaseFile) -> Option<Hold> {
        let given = self.keys().any(|key| MEAN_STATE.contains(&key));
        (!given && !rolls_alike(before, after)).then(|| self.hold.unwrap_or_else(|| Hold::usual(before)))
    }

    /// A sentence about the change of friction or load.
    pub(crate) fn refuse(&self, message: impl Into<Message>) -> CaseError {
        let key = self.keys().find(|key| key.starts_with("contact."));
        let source = self.source.clone();
        source.unwrap_or_else(|| KeyFile::empty(&self.title)).refuse(key.unwrap_or_default(), message)
    }

    /// An error of the case that one of the changes causes, as one of the file of changes.
    pub fn explain(&self, error: CaseError) -> CaseError {
        match (&self.source, error) {
            (Some(source), CaseError::Changed { key, message }) if self.keys().any(|own| own == key) => {
                source.refuse(&key, &message)
            }
            (_, error) => error,
        }
    }
}

impl SpeedChange {
    /// The speeds after the change.
    ///
    /// # Errors
    /// [`riffel::Error::OutOfRange`] where the spread does not leave every wheel moving.
    pub fn apply(&self, speeds: &SpeedDistribution) -> Result<SpeedDistribution, riffel::Error> {
        let scaled = match (self.factor, self.mean) {
            (Some(factor), _) => speeds.scaled(factor.si())?,
            (None, Some(mean)) => speeds.scaled(mean.si() / speeds.mean())?,
            (None, None) => speeds.clone(),
        };
        let own = self.standard_deviation.map(|deviation| deviation.si());
        let factor = self.standard_deviation_factor;
        match own.or(factor.map(|factor| factor.si() * scaled.deviation())) {
            Some(deviation) => SpeedDistribution::normal(scaled.mean(), deviation),
            None => Ok(scaled),
        }
    }
}
