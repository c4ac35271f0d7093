//! `riffel decide`

use std::path::PathBuf;

use clap::Args;

#[derive(Args)]
#[command(after_help = "Example: riffel decide posterior\n\n\
        The plan of the calibration has [[action]], [cost] and, if wished, [[measurement]]; they may be written after the chains \
        are drawn.")]
pub(crate) struct Decide {
    /// Folder of a finished calibration; the results are written there.
    #[arg(value_name = "DIR")]
    pub(crate) folder: PathBuf,

    /// The plan [default: the one that the chains were drawn for].
    #[arg(long, value_name = "PLAN")]
    pub(crate) plan: Option<PathBuf>,

    /// Print one JSON document and write no files.
    #[arg(long)]
    pub(crate) json: bool,
}
