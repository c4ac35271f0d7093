//! Argument of what has an answer over a calibration.

use std::path::PathBuf;

use clap::Args;

#[derive(Args, Clone, Default)]
pub(crate) struct Posterior {
    /// Folder of a finished calibration of the case: the answer over its draws and under its traffic as well, medians with bands of
    /// 50 and 90 %.
    #[arg(long, value_name = "DIR", group = "growth_under")]
    pub(crate) posterior: Option<PathBuf>,
}
