//! `riffel calibrate`

use std::path::PathBuf;

use clap::{Args, Subcommand};

#[derive(Args)]
#[command(
    args_conflicts_with_subcommands = true,
    subcommand_negates_reqs = true,
    after_help = "Examples:\n  \
        riffel calibrate plan.toml -o posterior\n  \
        riffel calibrate case.toml --with hammer.csv --with levels.csv --traffic traffic.toml -o posterior\n  \
        riffel calibrate check plan.toml --runs 100\n\n\
        The plan names the case, the uncertain keys with their priors, and the data: frequency responses, decay rates, dated \
        levels, runs of axle boxes. Of a case and tables of data, a plan with usual priors is written to the folder first. The same \
        seed gives the same draws on any number of threads.\n\n\
        Exit status: 0 done, 1 the chains allow no conclusion (results are written all the same), 2 bad input, 130 stopped by \
        Ctrl-C (--restart goes on)."
)]
pub(crate) struct Calibrate {
    #[command(subcommand)]
    pub(crate) command: Option<CalibrateCommand>,

    #[command(flatten)]
    pub(crate) chains: CalibrateChains,
}

/// What is done with a plan beside drawing its chains.
#[derive(Subcommand)]
pub(crate) enum CalibrateCommand {
    /// Whether intervals of a plan hold the truth as often as they say, by simulated data.
    Check(CheckCalibration),
}

#[derive(Args)]
pub(crate) struct CalibrateChains {
    /// Plan of the calibration; with --with the case.
    #[arg(value_name = "PLAN", required = true)]
    pub(crate) plan: Option<PathBuf>,

    /// Table of measurements, whose columns say of what kind it is; may be repeated. PLAN is the case then, and all that these
    /// data tell of it is uncertain.
    #[arg(long = "with", value_name = "FILE")]
    pub(crate) tables: Vec<PathBuf>,

    /// Traffic that made dated levels grow, beside --with.
    #[arg(long, value_name = "FILE", requires = "tables")]
    pub(crate) traffic: Option<PathBuf>,

    /// Folder for the results, made if need be [default: PLAN-posterior].
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,

    /// Keep the finished parts of chains that were stopped, and go on from there; put chains of this plan in the place of those of
    /// another, which are refused otherwise.
    #[arg(long)]
    pub(crate) restart: bool,

    /// Read and check everything, say what would be computed, and write nothing.
    #[arg(long, conflicts_with = "restart")]
    pub(crate) dry_run: bool,

    /// Print one JSON document: what the chains say, with --dry-run the plan.
    #[arg(long)]
    pub(crate) json: bool,

    /// Number of threads [default: one for each processor].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub(crate) threads: Option<u16>,
}

#[derive(Args)]
#[command(after_help = "Example: riffel calibrate check plan.toml --runs 100 -o check\n\n\
        Values are drawn from the priors of the plan, data from its likelihood with these values, and a chain of the plan on these \
        data; the truth is ranked among its draws. It takes N times as long as one chain.\n\n\
        Exit status: 0 the ranks are even, 1 they are not, 2 bad input, 130 stopped by Ctrl-C.")]
pub(crate) struct CheckCalibration {
    /// Plan of the calibration.
    #[arg(value_name = "PLAN")]
    pub(crate) plan: PathBuf,

    /// Number of simulations, 20 at least.
    #[arg(long, value_name = "N", default_value_t = 200)]
    pub(crate) runs: u64,

    /// Folder for the table and the picture of the ranks; left out, none are written.
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,

    /// Print one JSON document.
    #[arg(long)]
    pub(crate) json: bool,

    /// Number of threads [default: one for each processor].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub(crate) threads: Option<u16>,
}
