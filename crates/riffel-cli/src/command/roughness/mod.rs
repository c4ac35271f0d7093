//! `riffel roughness`

pub(crate) mod profile;
mod spectra;
mod synthesise;

use std::path::Path;

use riffel_answers::question::choose_nothing;
use riffel_keys::Message;
use riffel_rail::{LimitTable, RoughnessFile, Survey};

use crate::arguments::{Layout, Roughness, positive, stem};
use crate::error::CliError;
use crate::progress::Progress;
use crate::results::Results;
use crate::terminal::Terminal;

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
    let limits = LimitTable::named(&arguments.limit)?;
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
    Ok(layout.records().read(path, &Terminal)?)
}

/// The spectra of a file, those of a profile computed.
pub(crate) fn survey(path: &Path, layout: &Layout) -> miette::Result<Survey> {
    Ok(layout.records().survey(path, &Terminal)?)
}

/// Work done by several threads that tell one bar how far they are.
pub(crate) fn with_progress<T>(what: Message, length: usize, work: impl FnOnce(&(dyn Fn(usize) + Sync)) -> T) -> T {
    let progress = Progress::new(what, length);
    work(&|by| progress.advance(by))
}

/// The results of `riffel roughness` on a file.
fn results(path: &Path, arguments: &Roughness) -> Results {
    let folder = format!("{}-roughness", stem(path));
    Results::in_folder("roughness", Path::new(&folder), arguments.output.as_deref(), arguments.json)
}
