//! `riffel forecast --posterior`

use std::path::Path;

use riffel_answers::forecast::{ForecastHorizon, PosteriorForecast};
use riffel_answers::level_limit;

use crate::arguments::Forecast;
use crate::posterior::finished_of;
use crate::results::Results;

pub(super) fn run(arguments: &Forecast, folder: &Path) -> miette::Result<()> {
    let (plan, chains) = finished_of(&arguments.case, folder)?;
    let months = arguments.horizon.months.unwrap_or(12.0);
    ForecastHorizon::Months(months).check()?;
    let limit = level_limit(&arguments.limit)?;
    let answer = PosteriorForecast::new(&plan, &chains, &limit, months)?;
    let results = Results::of("forecast", &arguments.case, &arguments.results);
    Ok(results.answer(&answer)?)
}
