//! `riffel roughness`

mod bands;
mod grind;
pub(crate) mod profile;
mod spectra;
mod synthesise;

use std::path::{Path, PathBuf};

use riffel_keys::Message;
use riffel_keys::text_file::is_standard_input;
use riffel_rail::{LimitTable, ReaderFormat, RoughnessFile, Survey};

use crate::arguments::{Layout, Roughness, positive, stem};
use crate::error::CliError;
use crate::progress::Progress;

pub(crate) use bands::bands_table;
pub(crate) use grind::grind_table;

pub(crate) fn run(arguments: &Roughness) -> miette::Result<()> {
    if let Some(recipe) = &arguments.synthesise {
        return synthesise::run(recipe.as_deref(), arguments);
    }
    // The parser asks for a file unless a profile is made.
    let path = arguments.path.as_deref().unwrap_or_else(|| Path::new(""));
    for (argument, value) in [
        ("--longest", arguments.statistics.longest),
        ("--window", arguments.statistics.window),
        ("--block", Some(arguments.statistics.block)),
    ] {
        value.map(|value| positive(argument, value)).transpose()?;
    }
    for (argument, value) in
        [("--merge", arguments.statistics.merge), ("--grinding-length", arguments.statistics.grinding_length)]
    {
        if value.si() < 0.0 {
            Err(CliError::Argument { argument, value: value.to_string(), rule: "zero or greater".to_owned() })?;
        }
    }
    let limits = limits(&arguments.limit)?;
    match read(path, &arguments.layout)? {
        RoughnessFile::Profile(record) => {
            choose_nothing(path, &arguments.choose, arguments.by.as_deref())?;
            profile::run(path, record, &limits, arguments)
        }
        RoughnessFile::Spectra(spectra, warnings) => {
            let survey = Survey::new(path, spectra, warnings)?;
            spectra::run(survey, &limits, arguments)
        }
    }
}

/// Read what is asked for of a file, with a bar of how far it is.
pub(crate) fn read(path: &Path, layout: &Layout) -> miette::Result<RoughnessFile> {
    if let Some(spacing) = layout.spacing {
        positive("--spacing", spacing)?;
    }
    let part = layout.part.of_record();
    let format = layout.format.as_deref();
    let layout = riffel_rail::Layout {
        format: format.map(ReaderFormat::read).transpose()?,
        spacing: layout.spacing,
        height_unit: layout.height_unit.clone(),
        position_unit: layout.position_unit.clone(),
    };
    let size = std::fs::metadata(path).map_or(0, |file| file.len() as usize);
    let file =
        with_progress(riffel_keys::say!(progress_reading), size, |advance| RoughnessFile::read(path, &layout, advance));
    Ok(file?.part(path, &part)?)
}

/// A choice among spectra means nothing for a profile.
pub(crate) fn choose_nothing(path: &Path, choose: &[String], by: Option<&str>) -> Result<(), CliError> {
    let choice = choose.first().map(|choice| ("--where", choice.as_str()));
    match choice.or(by.map(|by| ("--by", by))) {
        None => Ok(()),
        Some((argument, value)) => Err(CliError::Argument {
            argument,
            value: value.to_owned(),
            rule: format!("left out: it is for tables of spectra, and {} is a profile", path.display()),
        }),
    }
}

/// What grows of a rail: a file without single defects, unless they are kept.
fn read_growing(path: &Path, layout: &Layout) -> miette::Result<RoughnessFile> {
    let file = read(path, layout)?;
    Ok(match layout.keep_defects {
        true => file,
        false => file.without_defects(),
    })
}

/// The spectra of a file, those of a profile computed.
pub(crate) fn survey(path: &Path, layout: &Layout) -> miette::Result<Survey> {
    Ok(Survey::of(path, read_growing(path, layout)?)?)
}

/// The records of a rail whose profile was measured twice, place by place; `None` for tables, and for what came over
/// standard input and is gone.
pub(crate) fn places_of_both(earlier: &Path, later: &Path, layout: &Layout) -> miette::Result<Option<[Survey; 2]>> {
    if is_standard_input(earlier) || is_standard_input(later) {
        return Ok(None);
    }
    let before = read_growing(earlier, layout)?;
    if !matches!(before, RoughnessFile::Profile(_)) {
        return Ok(None);
    }
    let now = read_growing(later, layout)?;
    Ok(Survey::at_same_places((earlier, &before), (later, &now))?)
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
pub(crate) fn with_progress<T>(what: Message, length: usize, work: impl FnOnce(&(dyn Fn(usize) + Sync)) -> T) -> T {
    let progress = Progress::new(what, length);
    work(&|by| progress.advance(by))
}

/// The folder given for results, or one named after the file.
fn folder(path: &Path, given: Option<&Path>) -> PathBuf {
    given.map_or_else(|| PathBuf::from(format!("{}-roughness", stem(path))), Path::to_owned)
}
