//! A case as it was written: what makes it again in another process.

use std::path::PathBuf;

use riffel_keys::{CaseError, KeyFile};

use crate::case::Case;
use crate::keys::substitutes::{SubstituteReceptance, Substitutes};
use crate::parts::window::Window;
use crate::text::case_text::CaseText;

/// The keys of a case before presets and defaults, with all that its errors show. Files that the case names stay where
/// they are, and receptances that were given go beside it.
#[derive(Debug, Clone, PartialEq)]
pub struct PortableCase {
    /// The name shown in errors.
    pub name: String,
    /// The text that was read, which errors show.
    pub text: String,
    /// The keys with their overrides, as TOML.
    pub keys: String,
    /// Each key that was overridden, with the override.
    pub overrides: Vec<(String, String)>,
    /// The folder to which files are relative, from the root where the present one is known; none for a case that may
    /// not name any.
    pub folder: Option<PathBuf>,
}

impl PortableCase {
    /// What makes a case again elsewhere.
    pub fn of(case: &Case) -> Self {
        let folder = case
            .keys
            .folder
            .as_ref()
            .map(|folder| std::env::current_dir().map_or_else(|_| folder.clone(), |here| here.join(folder)));
        let keys = &case.unfilled.keys;
        Self {
            name: keys.name().to_owned(),
            text: keys.text().to_owned(),
            keys: keys.table().to_string(),
            overrides: keys.overrides(),
            folder,
        }
    }

    /// The case that was written, with the receptances that were given with it: the same bits, if files that it names
    /// are the same.
    ///
    /// # Errors
    /// [`CaseError`] as of [`Case::parse`].
    pub fn restore(
        &self,
        track: Option<SubstituteReceptance>,
        wheel: Option<SubstituteReceptance>,
    ) -> Result<Case, CaseError> {
        let Self { name, text, keys, overrides, folder } = self;
        Case::of_text(
            CaseText::of(KeyFile::restore(name, text, keys, overrides)?),
            folder.as_deref(),
            Substitutes { track, wheel, ..Substitutes::default() },
            Window::Map,
        )
    }
}
