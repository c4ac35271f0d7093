//! A remark on a case, as the page shows it.

use riffel_keys::{Language, Message};
use serde::Serialize;

/// A remark in every language of the page, which changes its language without asking anew.
#[derive(Serialize)]
pub struct Note {
    en: String,
    de: String,
}

impl From<&Message> for Note {
    fn from(remark: &Message) -> Self {
        let wording = |language| remark.text(language);
        Self {
            en: wording(Language::English),
            de: wording(Language::German),
        }
    }
}

impl Note {
    /// Several remarks.
    pub fn all<'a>(remarks: impl IntoIterator<Item = &'a Message>) -> Vec<Self> {
        remarks.into_iter().map(Self::from).collect()
    }
}
