//! `riffel calibrate`

use std::path::PathBuf;

use clap::Args;

#[derive(Args)]
#[command(after_help = "Example: riffel calibrate plan.toml -o posterior\n\n\
        The plan names the case, the uncertain keys with their priors, and the data: frequency responses, decay rates, dated \
        levels, runs of axle boxes. The same seed gives the same draws on any number of threads.\n\n\
        Exit status: 0 done, 1 the chains allow no conclusion (results are written all the same), 2 bad input, 130 stopped by \
        Ctrl-C (--restart goes on).")]
pub(crate) struct Calibrate {
    /// Plan of the calibration.
    #[arg(value_name = "PLAN")]
    pub(crate) plan: PathBuf,

    /// Folder for the results, made if need be [default: PLAN-posterior].
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,

    /// Keep the finished parts of chains that were stopped, and go on from there.
    #[arg(long)]
    pub(crate) restart: bool,

    /// Read and check everything, say what would be computed, and write nothing.
    #[arg(long, conflicts_with = "restart")]
    pub(crate) dry_run: bool,

    /// Number of threads [default: one for each processor].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub(crate) threads: Option<u16>,
}
