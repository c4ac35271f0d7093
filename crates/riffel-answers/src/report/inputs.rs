//! The input files of a report, each with its fingerprint.

use std::path::Path;

use riffel_keys::{Language, Message, say};

use super::page::{said, table, texts};

/// Input files in the order in which they were named.
#[derive(Debug, Clone, Default)]
pub struct Inputs {
    rows: Vec<[Message; 4]>,
}

impl Inputs {
    /// A file with what it is for and what it was understood as; `fingerprint` is its SHA-256, or the words in its
    /// place.
    pub fn add(&mut self, role: Message, path: &Path, origin: Message, fingerprint: Message) {
        let file = Message::verbatim(path.display().to_string());
        self.rows.push([role, file, origin, fingerprint]);
    }

    pub(super) fn html(&self, language: Language) -> String {
        let rows = self.rows.iter().map(|row| {
            let mut cells = row.each_ref().map(|cell| said(cell, language));
            cells[3] = format!("<code>{}</code>", cells[3]);
            cells.to_vec()
        });
        let heads = [say!(input_head), say!(file_head), say!(what_it_is_head), Message::verbatim("SHA-256")];
        table("words", &texts(heads, language), &rows.collect::<Vec<_>>())
    }
}
