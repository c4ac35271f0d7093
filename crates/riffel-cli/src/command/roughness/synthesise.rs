//! `riffel roughness --synthesise`

use std::fs;
use std::io::Write;
use std::path::Path;

use riffel_keys::{CaseError, say};
use riffel_rail::{DEFAULT_RECIPE, RecipeFile};

use crate::arguments::Roughness;
use crate::messages::language;
use crate::output::print;
use crate::staging::{Existing, write_file};

pub(super) fn run(recipe: Option<&Path>, arguments: &Roughness) -> miette::Result<()> {
    let file = match recipe {
        Some(path) => RecipeFile::read(path)?,
        None => RecipeFile::parse("the built-in recipe", DEFAULT_RECIPE)?,
    };
    let mut columns = Vec::new();
    for (_, recipe) in &file.rails {
        let heights = recipe.heights().map_err(|error| CaseError::data(recipe_name(arguments), error.to_string()))?;
        columns.push(heights);
    }
    let spacing = file.rails.first().map_or(0.0, |rail| rail.1.spacing);
    let mut text = Vec::with_capacity(columns.iter().map(|column| 10 * column.len() + 12).sum());
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
        text.push(b'\n');
    }
    let text = String::from_utf8(text).unwrap_or_default();
    match &arguments.output {
        Some(path) => {
            // One recipe makes one record: made a second time it is what it was.
            let is_same = || path.is_file() && fs::read(path).is_ok_and(|there| there == text.as_bytes());
            let existing = match arguments.force || is_same() {
                true => Existing::Replace,
                false => Existing::Keep("--force to replace it"),
            };
            write_file(path, &text, existing)?;
            let wrote = say!(profile_is_written, file = path.display().to_string());
            print(&(wrote.text(language()) + "\n"))?;
        }
        None => print(&text)?,
    }
    Ok(())
}

fn recipe_name(arguments: &Roughness) -> std::path::PathBuf {
    let given = arguments.synthesise.clone().flatten();
    given.unwrap_or_else(|| "the built-in recipe".into())
}
