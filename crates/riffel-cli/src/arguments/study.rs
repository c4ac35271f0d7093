//! `riffel study`

use std::path::PathBuf;

use clap::{Args, Subcommand};
use riffel_keys::quantity::{Quantity, Ratio};
use riffel_study::Shard;

#[derive(Args)]
#[command(
    args_conflicts_with_subcommands = true,
    subcommand_negates_reqs = true,
    after_help = "Examples:\n  \
        riffel init --study && riffel init nominal.toml && riffel study study.toml\n  \
        riffel study study.toml -o results --shard $SLURM_ARRAY_TASK_ID/100\n  \
        riffel study merge whole part-1 part-2 part-3\n  \
        riffel study sensitivity study-results\n\n\
        A study that was stopped goes on with the same command: finished chunks are kept."
)]
pub(crate) struct Study {
    #[command(subcommand)]
    pub(crate) command: Option<StudyCommand>,

    #[command(flatten)]
    pub(crate) run: Run,
}

/// What is done with results.
#[derive(Subcommand)]
pub(crate) enum StudyCommand {
    /// Copy the finished chunks of shards into one folder.
    Merge(Merge),
    /// Which parameters matter: Sobol indices, tornado, Monte-Carlo bands.
    Sensitivity(Sensitivity),
}

#[derive(Args)]
pub(crate) struct Run {
    /// Plan of the study, or - for standard input.
    #[arg(value_name = "PLAN", required = true)]
    pub(crate) plan: Option<PathBuf>,

    /// Folder for the results, made if need be, or begun before [default: PLAN-results].
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,

    /// Part of the work, as 3/8: every eighth chunk from the third on. Parts may share a folder, or have one
    /// each and be merged.
    #[arg(long, value_name = "I/N")]
    pub(crate) shard: Option<Shard>,

    /// Number of threads [default: one for each processor].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub(crate) threads: Option<u16>,

    /// Print one JSON document.
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Args)]
#[command(after_help = "Example: riffel study merge whole part-1 part-2 part-3")]
pub(crate) struct Merge {
    /// Folder that takes them, made if need be.
    #[arg(value_name = "INTO")]
    pub(crate) into: PathBuf,

    /// Folders of results of the same plan.
    #[arg(value_name = "FROM", required = true)]
    pub(crate) from: Vec<PathBuf>,

    /// Print one JSON document.
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Args)]
#[command(after_help = "Example: riffel study sensitivity study-results --result highest_growth_rate")]
pub(crate) struct Sensitivity {
    /// Folder with the results of a finished study.
    #[arg(value_name = "DIR")]
    pub(crate) folder: PathBuf,

    /// Result to look at; may be repeated [default: all that are one number for each sample].
    #[arg(long = "result", value_name = "NAME")]
    pub(crate) results: Vec<String>,

    /// Confidence of the intervals.
    #[arg(long, value_name = "RATIO", default_value = "95 %")]
    pub(crate) confidence: Quantity<Ratio>,

    /// Folder for table and figures, made if need be [default: that of the study].
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,

    /// Print one JSON document; files are written only with --output.
    #[arg(long)]
    pub(crate) json: bool,
}
