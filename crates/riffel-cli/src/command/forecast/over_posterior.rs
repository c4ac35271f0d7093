//! `riffel forecast --posterior`

use std::path::Path;

use riffel_answers::forecast::{ForecastHorizon, PosteriorForecast};
use riffel_answers::level_limit;
use riffel_calibrate::finished;

use crate::arguments::Forecast;
use crate::error::CliError;
use crate::results::Results;

pub(super) fn run(arguments: &Forecast, folder: &Path) -> miette::Result<()> {
    let (plan, chains) = finished(folder, None)?;
    if !arguments.case.is_just(&plan.inputs[1]) {
        return Err(CliError::Argument {
            argument: "--posterior",
            value: folder.display().to_string(),
            rule: format!(
                "a calibration of the case that is named, without --set; it is of {}",
                plan.inputs[1].display()
            ),
        }
        .into());
    }
    let months = arguments.horizon.months.unwrap_or(12.0);
    ForecastHorizon::Months(months).check()?;
    let limit = level_limit(&arguments.limit)?;
    let answer = PosteriorForecast::new(&plan, &chains, &limit, months)?;
    let results = Results {
        command: "forecast",
        case: &arguments.case,
        to: &arguments.results,
    };
    Ok(results.answer(&answer)?)
}
