//! A table of spectra on the command line.

use riffel_answers::roughness::SpectraAnswer;
use riffel_rail::{LimitTable, Survey};

use super::results;
use crate::arguments::Roughness;
use crate::error::CliError;

pub(super) fn run(survey: Survey, limits: &[LimitTable], arguments: &Roughness) -> miette::Result<()> {
    let along = arguments.along.as_ref();
    let of_profiles = [
        ("--longest", arguments.statistics.longest.map(|value| value.to_string())),
        ("--window", arguments.statistics.window.map(|value| value.to_string())),
        ("--along", along.map(|path| path.display().to_string())),
    ];
    for (argument, value) in of_profiles {
        if let Some(value) = value {
            Err(CliError::Argument {
                argument,
                value,
                rule: format!("left out: it is for profiles, and {} is a table of spectra", survey.path().display()),
            })?;
        }
    }
    let survey = survey.choose(&arguments.choose)?;
    let answer = SpectraAnswer::new(&survey, limits, arguments.by.as_deref())?;
    Ok(results(survey.path(), arguments).answer(&answer)?)
}
