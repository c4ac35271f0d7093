//! The case of a question.

use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use riffel_case::file::CaseFile;
use riffel_case::{Case, CaseContact, CurvingCase};
use riffel_keys::quantity::{Length, Quantity};
use riffel_keys::{CaseError, question, say};
use schemars::JsonSchema;
use serde::Deserialize;

use super::{Client, Source};
use crate::{AnswerError, Result};

/// A case file with overrides, of which a question takes the whole or a part.
#[derive(Deserialize, JsonSchema)]
#[serde(bound = "")]
#[schemars(bound = "")]
pub struct CaseSource<T = Case> {
    /// Case file, or - for standard input.
    #[schemars(extend("positional" = true, "value_name" = "CASE"))]
    case: Source<T>,
    /// Override a value of the case, as in --set contact.friction=0.3; may be repeated.
    #[schemars(extend("value_name" = "KEY=VALUE"))]
    set: Vec<String>,
}

/// What is read of a case file.
pub trait OfCase: Sized + Send + Sync + 'static {
    /// Read it with overrides.
    ///
    /// # Errors
    /// [`CaseError`] with the key, the value and the rule.
    fn read(path: &Path, overrides: &[String]) -> Result<Self, CaseError>;

    /// Take it of a case in memory, with overrides.
    ///
    /// # Errors
    /// [`CaseError`] with the key, the value and the rule.
    fn of(case: Arc<Case>, overrides: &[String]) -> Result<Arc<Self>, CaseError>;

    /// The keys, where they may name a file of a measured track.
    fn file(&self) -> Option<&CaseFile>;
}

impl OfCase for Case {
    fn read(path: &Path, overrides: &[String]) -> Result<Self, CaseError> {
        Self::read(path, overrides)
    }

    fn of(case: Arc<Case>, overrides: &[String]) -> Result<Arc<Self>, CaseError> {
        match overrides {
            [] => Ok(case),
            overrides => case.with(overrides).map(Arc::new),
        }
    }

    fn file(&self) -> Option<&CaseFile> {
        Some(&self.file)
    }
}

impl OfCase for CaseContact {
    fn read(path: &Path, overrides: &[String]) -> Result<Self, CaseError> {
        Self::read(path, overrides)
    }

    fn of(case: Arc<Case>, overrides: &[String]) -> Result<Arc<Self>, CaseError> {
        Self::of(&*<Case as OfCase>::of(case, overrides)?).map(Arc::new)
    }

    fn file(&self) -> Option<&CaseFile> {
        Some(&self.file)
    }
}

impl OfCase for CurvingCase {
    fn read(path: &Path, overrides: &[String]) -> Result<Self, CaseError> {
        Self::read(path, overrides)
    }

    fn of(case: Arc<Case>, overrides: &[String]) -> Result<Arc<Self>, CaseError> {
        case.curving(overrides).map(Arc::new)
    }

    fn file(&self) -> Option<&CaseFile> {
        None
    }
}

impl<T> Clone for CaseSource<T> {
    fn clone(&self) -> Self {
        Self { case: self.case.clone(), set: self.set.clone() }
    }
}

impl<T> fmt::Debug for CaseSource<T> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("CaseSource").field("case", &self.case).field("set", &self.set).finish()
    }
}

impl<T> CaseSource<T> {
    /// The case of a file or in memory, with overrides.
    pub fn new(case: Source<T>, set: Vec<String>) -> Self {
        Self { case, set }
    }

    /// The path of its file, or an empty one for what is in memory.
    pub fn name(&self) -> &Path {
        self.case.name()
    }

    /// What is set in place of what it says.
    pub fn overrides(&self) -> &[String] {
        &self.set
    }
}

impl<T: OfCase> CaseSource<T> {
    /// Whether it is the case of a file without any override.
    pub fn is_just(&self, path: &Path) -> bool {
        let real = |path: &Path| std::fs::canonicalize(path).ok();
        self.set.is_empty() && real(path).is_some() && self.case.path().and_then(real) == real(path)
    }

    /// The case; `client` is told which file of a measured track it reads.
    ///
    /// # Errors
    /// [`AnswerError::Case`] with the key, the value and the rule.
    pub fn read(&self, client: &dyn Client) -> Result<Arc<T>> {
        let case = match question::value(self.name()) {
            Some(case) => T::of(case, &self.set)?,
            None => self.case.value(|path| T::read(path, &self.set))?,
        };
        if let Some(file) = self.measurement(&case) {
            client.reads(&file);
        }
        Ok(case)
    }

    /// The file of a measured track that the case reads, if it does.
    pub(crate) fn measurement(&self, case: &T) -> Option<PathBuf> {
        let measurement = case.file()?.track.measurement.as_ref()?;
        let path = self.case.path().filter(|path| question::value::<Case>(path).is_none());
        Some(path?.parent().unwrap_or_else(|| Path::new("")).join(&measurement.file))
    }
}

impl CaseSource {
    /// The case with the wheel at another place of the bay.
    ///
    /// # Errors
    /// [`AnswerError::Option`] for a place that the bay does not have, and on a track that has no bay.
    pub fn read_at(&self, position: Option<Quantity<Length>>, client: &dyn Client) -> Result<Arc<Case>> {
        let case = self.read(client)?;
        let Some(position) = position else {
            return Ok(case);
        };
        let option = "--position";
        match case.edit(|keys| keys.track.position = Some(position)) {
            Err(CaseError::Changed { message, .. }) => Err(AnswerError::Option { option, message }),
            Ok(case) if case.track.support_spacing().is_none() => {
                let model = case.file.track.model.name();
                Err(AnswerError::Option { option, message: say!(track_is_the_same_everywhere, model) })
            }
            case => Ok(Arc::new(case?)),
        }
    }
}

impl From<Case> for CaseSource {
    fn from(case: Case) -> Self {
        Arc::new(case).into()
    }
}

impl<T> From<Arc<T>> for CaseSource<T> {
    fn from(case: Arc<T>) -> Self {
        Self::new(Source::InMemory(case), Vec::new())
    }
}

/// The case with a contact that answers from one wavelength \[m\] to another.
///
/// # Errors
/// [`AnswerError::Option`] where the contact does not answer there.
pub fn covering(case: &Case, from: f64, to: f64) -> Result<Case> {
    // The window was not written by the user.
    case.covering(from, to)
        .map_err(|error| AnswerError::Option { option: "--wavelength", message: error.without_key() })
}
