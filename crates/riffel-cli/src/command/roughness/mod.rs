//! `riffel roughness`

mod document;
mod figure;
mod profile;
mod spectra;
mod synthesise;
mod verdict;

use std::path::{Path, PathBuf};
use std::sync::Mutex;

use riffel_case::roughness::{LimitTable, ReaderFormat, RoughnessFile};
use riffel_plot::{DEFAULT_PNG_SCALE, LineFigure, png};

use crate::arguments::{Roughness, positive};
use crate::error::CliError;
use crate::output::Progress;
use crate::staging::Staging;

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
    let limits = limits(arguments)?;
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
fn limits(arguments: &Roughness) -> miette::Result<Vec<LimitTable>> {
    if arguments.limit.is_empty() {
        return Ok(LimitTable::all());
    }
    let tables = arguments.limit.iter().map(|name| LimitTable::find(name));
    Ok(tables.collect::<Result<_, _>>()?)
}

/// Work done by several threads that tell one bar how far they are.
fn with_progress<T>(
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

/// Picture, drawing and page of a figure.
fn write_figure(staging: &mut Staging, name: &str, figure: &LineFigure) -> Result<(), CliError> {
    let svg = figure.svg()?;
    let picture = png(&svg, DEFAULT_PNG_SCALE)?;
    staging.write(&format!("{name}.png"), picture)?;
    staging.write(&format!("{name}.svg"), svg)?;
    staging.write(&format!("{name}.html"), figure.html()?)
}
