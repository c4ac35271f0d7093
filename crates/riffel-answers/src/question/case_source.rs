//! The case of a question.

use std::path::Path;
use std::sync::Arc;

use riffel_case::Case;
use schemars::JsonSchema;
use serde::Deserialize;

use super::{Asker, Source};
use crate::AnswerError;

/// A case file with overrides.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct CaseSource {
    /// Case file, or - for standard input.
    #[schemars(extend("positional" = true, "value_name" = "CASE"))]
    case: Source<Case>,
    /// Override a value of the case, as in --set contact.friction=0.3; may be repeated.
    #[schemars(extend("value_name" = "KEY=VALUE"))]
    set: Vec<String>,
}

impl CaseSource {
    /// Whether it is the case of a file without any override.
    pub fn is_just(&self, path: &Path) -> bool {
        let real = |path: &Path| std::fs::canonicalize(path).ok();
        self.set.is_empty() && real(path).is_some() && self.case.path().and_then(real) == real(path)
    }

    /// The case; `asker` is told which file of a measured track it reads.
    ///
    /// # Errors
    /// [`AnswerError::Case`] with the key, the value and the rule.
    pub fn read(&self, asker: &dyn Asker) -> Result<Arc<Case>, AnswerError> {
        let case = self.case.value(|path| Case::read(path, &self.set))?;
        if let (Some(path), Some(measurement)) = (self.case.path(), &case.file.track.measurement) {
            let folder = path.parent().unwrap_or_else(|| Path::new(""));
            asker.reads(&folder.join(&measurement.file));
        }
        Ok(case)
    }
}

impl From<Case> for CaseSource {
    fn from(case: Case) -> Self {
        Arc::new(case).into()
    }
}

impl From<Arc<Case>> for CaseSource {
    fn from(case: Arc<Case>) -> Self {
        Self { case: Source::Given(case), set: Vec::new() }
    }
}

/// The case with a contact that answers from one wavelength \[m\] to another.
///
/// # Errors
/// [`AnswerError::Option`] where the contact does not answer there.
pub fn covering(case: &Case, from: f64, to: f64) -> Result<Case, AnswerError> {
    // The window was not written by the user.
    case.covering(from, to)
        .map_err(|error| AnswerError::Option { option: "--wavelength", message: error.without_key() })
}
