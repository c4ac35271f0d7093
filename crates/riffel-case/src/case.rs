//! A case, checked and complete.

use std::path::Path;

use riffel::{Axis, Carter3d, FeedbackLoop, HertzContact};

use crate::CaseError;
use crate::builder::Builder;
use crate::file::CaseFile;
use crate::source::Source;

/// A case ready to compute.
#[derive(Clone)]
pub struct Case {
    /// Every key with its value, presets and defaults filled in.
    pub file: CaseFile,
    /// The loop of the case.
    pub feedback: FeedbackLoop,
    /// The contact patch.
    pub hertz: HertzContact,
    /// The creep law at the mean state.
    pub creep_law: Carter3d,
    /// Wavelengths of the map \[m\].
    pub wavelength: Axis,
    /// Speeds of the map \[m/s\].
    pub speed: Axis,
    /// What the reader should know about the validity of the model in the window of the map.
    pub remarks: Vec<String>,
}

impl Case {
    /// Read a case file and apply overrides `key=value` in their order.
    ///
    /// # Errors
    /// [`CaseError`] with the key, the value and the rule.
    pub fn read(path: &Path, overrides: &[String]) -> Result<Self, CaseError> {
        let text = std::fs::read_to_string(path).map_err(|reason| CaseError::Read {
            path: path.to_owned(),
            reason,
        })?;
        Self::parse(&path.display().to_string(), &text, overrides)
    }

    /// Read a case from TOML; `name` is the one shown in errors.
    ///
    /// # Errors
    /// [`CaseError`] with the key, the value and the rule.
    pub fn parse(name: &str, text: &str, overrides: &[String]) -> Result<Self, CaseError> {
        let mut source = Source::parse(name, text)?;
        for assignment in overrides {
            source.set(assignment)?;
        }
        // An override of one of two exclusive keys replaces the other.
        source.replace("contact", "tractive_ratio", "creepage");
        source.replace("contact", "creepage", "tractive_ratio");
        let file = source.deserialize()?;
        Builder::new(source, file).build()
    }
}
