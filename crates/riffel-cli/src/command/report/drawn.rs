//! The forecast of a report over the draws of a calibration.

use riffel_answers::forecast::PosteriorForecast;
use riffel_calibrate::{Chains, Plan};
use riffel_rail::LimitTable;

use super::{MONTHS_OF_NOISE, level_limit};
use crate::arguments::Report;
use crate::error::CliError;

pub(super) fn forecast(
    arguments: &Report,
    limits: &[LimitTable],
    plan: &Plan,
    chains: &Chains,
) -> miette::Result<PosteriorForecast> {
    let limit = level_limit(arguments, limits).ok_or_else(|| CliError::Argument {
        argument: "--limit",
        value: arguments.limit.join(", "),
        rule: "a limit of levels where there is a --posterior".to_owned(),
    })?;
    let limit = riffel_answers::level_limit(&limit)?;
    let months = arguments.months.unwrap_or(MONTHS_OF_NOISE);
    Ok(PosteriorForecast::new(plan, chains, &limit, months)?)
}
