//! Arguments of `network`.

use std::path::PathBuf;

use clap::{Args, Subcommand};
use riffel_keys::quantity::{Length, Quantity};

#[derive(Args)]
#[command(
    after_help = "Example: riffel axlebox run.csv --case case.toml -o run && riffel network ingest railway run/blocks.csv \
        --line \"Main line\" --date 2026-01-31 && riffel network worst railway"
)]
pub(crate) struct Network {
    #[command(subcommand)]
    pub(crate) command: NetworkCommand,
}

/// What is done with the store.
#[derive(Subcommand)]
pub(crate) enum NetworkCommand {
    /// Every survey of a line, kilometre by date, as a picture and a table.
    Chart(Chart),
    /// Read all of a store and name what is lost or damaged.
    Check(Check),
}

#[derive(Args)]
#[command(after_help = "Example: riffel network check railway")]
pub(crate) struct Check {
    /// Folder of the store.
    #[arg(value_name = "STORE")]
    pub(crate) store: PathBuf,
}

/// What sections are judged by.
#[derive(Args)]
pub(crate) struct Judged {
    /// Folder of the store.
    #[arg(value_name = "STORE")]
    pub(crate) store: PathBuf,

    /// Limit of the RMS in bands of wavelength, by name or as a TOML file.
    #[arg(long, value_name = "LIMIT", default_value = "grassie-1999")]
    pub(crate) limit: String,

    /// Length of a section.
    #[arg(long, value_name = "LENGTH", default_value = "100 m")]
    pub(crate) section: Quantity<Length>,

    /// Print one JSON document.
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Args)]
#[command(after_help = "Example: riffel network chart railway --line \"Main line\" -o main-line")]
pub(crate) struct Chart {
    #[command(flatten)]
    pub(crate) judged: Judged,

    /// This line alone.
    #[arg(long, value_name = "NAME")]
    pub(crate) line: Option<String>,

    /// This rail alone [default: the worst of all at each place].
    #[arg(long, value_name = "NAME")]
    pub(crate) rail: Option<String>,

    /// Folder for the results, made if need be [default: STORE-chart].
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
}
