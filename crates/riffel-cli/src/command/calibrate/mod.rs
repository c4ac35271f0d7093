//! `riffel calibrate`

mod chains;
mod check;

use crate::arguments::{Calibrate, CalibrateCommand};

/// The limit of forecasts.
const LIMIT: &str = "iso-3095-2013";

pub(crate) fn run(arguments: &Calibrate) -> miette::Result<u8> {
    match &arguments.command {
        None => chains::run(&arguments.chains),
        Some(CalibrateCommand::Check(arguments)) => check::run(arguments),
    }
}
