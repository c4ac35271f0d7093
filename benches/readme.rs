//! The report on disk: `benches/README.md`, one section written at a time.

use std::fs;
use std::path::{Path, PathBuf};

use crate::contestant::Failure;
use crate::section::Section;

const HEAD: &str = "# Benchmarks\n\nWritten by `cargo xtask bench`, each section as it is done. Contestants work in turn in one run, each task \
                    after a warm-up of its own; times are medians and include the memory of the result.\n";

/// The file of the report.
pub(crate) struct Readme(PathBuf);

impl Readme {
    pub(crate) fn of(folder: &Path) -> Self {
        Self(folder.join("README.md"))
    }

    /// Write a section in its place among `titles`; of the others what there is stays, and nothing else.
    pub(crate) fn write(&self, section: &Section, titles: &[&str]) -> Result<(), Failure> {
        let old = fs::read_to_string(&self.0).unwrap_or_default();
        let mut text = HEAD.to_owned();
        for title in titles {
            let body = match *title == section.title {
                true => Some(section.to_string()),
                false => body(&old, title),
            };
            if let Some(body) = body {
                text += &format!("\n## {title}\n\n{}\n", body.trim());
            }
        }
        // Whole at every moment.
        let new = self.0.with_extension("new");
        fs::write(&new, text)?;
        Ok(fs::rename(new, &self.0)?)
    }
}

/// What stands below a title.
fn body(text: &str, title: &str) -> Option<String> {
    let (_, after) = text.split_once(&format!("\n## {title}\n"))?;
    Some(after.split("\n## ").next().unwrap_or(after).to_owned())
}
