//! `riffel calibrate`

mod chains;
mod check;

use crate::arguments::{Calibrate, CalibrateCommand};

pub(crate) fn run(arguments: &Calibrate) -> miette::Result<u8> {
    match &arguments.command {
        None => chains::run(&arguments.chains),
        Some(CalibrateCommand::Check(arguments)) => check::run(arguments),
    }
}
