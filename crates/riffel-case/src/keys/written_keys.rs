//! The keys of a case as they are written, read once, before anything is made of them.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use riffel_keys::{CaseError, seal};

use crate::file::{CaseFile, FromCurve};
use crate::keys::from_curve::stand_ins;
use crate::text::case_text::CaseText;

/// The keys of a text with presets and defaults filled in; where they take their mean state from a wheel of a vehicle in its curve,
/// without it.
#[derive(Clone)]
pub(crate) struct WrittenKeys {
    pub(crate) text: Arc<CaseText>,
    /// The keys without presets.
    pub(crate) unfilled: CaseText,
    /// Folder to which file names in the case are relative; without one the case may not name any.
    pub(crate) folder: Option<PathBuf>,
    pub(crate) file: CaseFile,
    /// The wheel that the mean state is taken from, if it is.
    pub(crate) from: Option<FromCurve>,
}

#[cfg(test)]
thread_local! {
    /// Texts that this thread has read.
    pub(crate) static READ: std::cell::Cell<usize> = const { std::cell::Cell::new(0) };
}

impl WrittenKeys {
    /// The keys of a text. `folder` is the one to which files are relative; without it the case may not name any.
    pub(crate) fn read(unfilled: CaseText, folder: Option<&Path>) -> Result<Self, CaseError> {
        #[cfg(test)]
        READ.set(READ.get() + 1);
        // What a page has sent is read as a case that names no file, whichever way it comes to be one.
        let folder = folder.filter(|_| !seal::is_sealed());
        let mut text = unfilled.clone();
        text.fill_in()?;
        let mut file = text.deserialize_with(&stand_ins(&text))?;
        text.judge()?;
        let from = file.contact.from.clone();
        // What it says is filled in, and a case that is sent elsewhere has no files.
        file.contact.from.take_if(|from| from.curve.is_some());
        let file_keys = ["track.measurement.file", "wheelset.file"];
        let named = file_keys.into_iter().find(|key| text.keys.has(key));
        if let (None, Some(key)) = (folder, named) {
            return Err(text.names_a_file(key));
        }
        Ok(Self { text: Arc::new(text), unfilled, folder: folder.map(Path::to_owned), file, from })
    }
}
