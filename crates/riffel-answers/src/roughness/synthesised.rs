//! A profile that is made to a recipe.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use riffel_keys::{CaseError, say};
use riffel_rail::{DEFAULT_RECIPE, RecipeFile};
use serde::Serialize;

use crate::{Answer, Existing, OwnText};

/// A profile in columns of text.
#[derive(Serialize)]
pub(super) struct Synthesised {
    text: String,
    #[serde(skip)]
    path: Option<PathBuf>,
    #[serde(skip)]
    force: bool,
}

impl Synthesised {
    /// Of a recipe, or of the one that is built in; for a file, which is replaced by `force`, or for standard output.
    pub(super) fn new(recipe: Option<&Path>, path: Option<PathBuf>, force: bool) -> Result<Self, CaseError> {
        const BUILT_IN: &str = "the built-in recipe";
        let file = match recipe {
            Some(path) => RecipeFile::read(path)?,
            None => RecipeFile::parse(BUILT_IN, DEFAULT_RECIPE)?,
        };
        let name = recipe.unwrap_or_else(|| Path::new(BUILT_IN));
        let heights = file.rails.iter().map(|(_, recipe)| recipe.heights());
        let columns = heights.collect::<Result<Vec<_>, _>>();
        let columns = columns.map_err(|error| CaseError::data(name, error.to_string()))?;
        let spacing = file.rails.first().map_or(0.0, |rail| rail.1.spacing);
        let mut text = String::with_capacity(columns.iter().map(|column| 10 * column.len() + 12).sum());
        let names: Vec<String> = file.rails.iter().map(|rail| format!("{}_um", rail.0)).collect();
        // Writing to memory does not fail.
        let _ = writeln!(text, "position_m,{}", names.join(","));
        for row in 0..columns.first().map_or(0, Vec::len) {
            let _ = write!(text, "{}", (row as f64 * spacing * 1e6).round() / 1e6);
            for column in &columns {
                let _ = match column[row] {
                    height if height.is_nan() => write!(text, ","),
                    height => write!(text, ",{:.3}", 1e6 * height),
                };
            }
            text.push('\n');
        }
        Ok(Self { text, path, force })
    }
}

impl Answer for Synthesised {
    fn name(&self) -> &'static str {
        "profile"
    }

    fn own_text(&self) -> Option<OwnText<'_>> {
        let path = self.path.as_deref();
        Some(OwnText {
            path,
            text: (&*self.text).into(),
            // One recipe makes one record: made a second time it is what it was.
            existing: if self.force { Existing::Replaced } else { Existing::ReplacedIfKnown(None) },
            written: path.map(|path| say!(profile_is_written, file = path.display().to_string())),
        })
    }
}
