//! `riffel roughness`

pub(crate) mod choice;
pub(crate) mod document;
pub(crate) mod figure;
pub(crate) mod profile;
pub(crate) mod spectra;
mod synthesise;
pub(crate) mod verdict;

use std::path::{Path, PathBuf};
use std::sync::Mutex;

use riffel_case::roughness::{LimitTable, ReaderFormat, RoughnessFile};

use crate::arguments::{Roughness, positive};
use crate::output::Progress;

pub(crate) fn run(arguments: &Roughness) -> miette::Result<()> {
    if let Some(recipe) = &arguments.synthesise {
        return synthesise::run(recipe.as_deref(), arguments);
    }
    // The parser asks for a file unless a profile is made.
    let path = arguments.path.as_deref().unwrap_or_else(|| Path::new(""));
    for (argument, value) in [
        ("--longest", arguments.longest),
        ("--window", arguments.window),
        ("--block", Some(arguments.block)),
        ("--spacing", arguments.spacing),
    ] {
        value.map(|value| positive(argument, value)).transpose()?;
    }
    let limits = limits(&arguments.limit)?;
    let format = arguments.format.as_deref();
    let format = format.map(ReaderFormat::read).transpose()?;
    let size = std::fs::metadata(path).map_or(0, |file| file.len() as usize);
    let file = with_progress("reading", size, |advance| {
        RoughnessFile::read(path, format.as_ref(), arguments.spacing, advance)
    })?;
    match file {
        RoughnessFile::Profile(record) => profile::run(path, record, &limits, arguments),
        RoughnessFile::Spectra(spectra) => spectra::run(path, spectra, &limits, arguments),
    }
}

/// The limit tables asked for, or all that come with Riffel.
pub(crate) fn limits(names: &[String]) -> miette::Result<Vec<LimitTable>> {
    if names.is_empty() {
        return Ok(LimitTable::all());
    }
    let tables = names.iter().map(|name| LimitTable::find(name));
    Ok(tables.collect::<Result<_, _>>()?)
}

/// Work done by several threads that tell one bar how far they are.
pub(crate) fn with_progress<T>(
    what: &'static str,
    length: usize,
    work: impl FnOnce(&(dyn Fn(usize) + Sync)) -> T,
) -> T {
    let progress = Mutex::new(Progress::new(what, length));
    work(&|by| {
        if let Ok(progress) = progress.lock() {
            progress.advance(by);
        }
    })
}

/// The folder given for results, or one named after the file.
fn folder(path: &Path, given: Option<&Path>) -> PathBuf {
    given.map_or_else(
        || {
            let stem = path.file_stem().unwrap_or_default().to_string_lossy();
            PathBuf::from(format!("{stem}-roughness"))
        },
        Path::to_owned,
    )
}
