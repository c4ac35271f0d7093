//! Arguments of `network`.

use std::path::PathBuf;

use clap::{Args, Subcommand};
use riffel_keys::quantity::{Length, Quantity};

use super::number::{plain_number, sum_of_money};

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
    /// Add a survey of a line at a date; the store is made if need be.
    Ingest(Ingest),
    /// Lines, dates, kilometres and the RMS of the latest surveys.
    Status(Status),
    /// Sections of the latest surveys that are farthest over their limit.
    Worst(Worst),
    /// How sections grew over their surveys, or between two dates, and when they reach their limit.
    Growth(Growth),
    /// What to grind with a budget.
    Plan(Plan),
    /// Every survey of a line, kilometre by date, as a picture and a table.
    Chart(Chart),
    /// Read all of a store and name what is lost or damaged.
    Check(Check),
}

#[derive(Args)]
#[command(after_help = "Example: riffel network ingest railway blocks.csv --line \"Main line\" --date 2026-01-31\n\n\
        The same survey again changes nothing, and one that was stopped is done anew: surveys are there whole or not at all.")]
pub(crate) struct Ingest {
    /// Folder of the store.
    #[arg(value_name = "STORE")]
    pub(crate) store: PathBuf,

    /// Blocks along the rails, as `riffel axlebox` and `riffel roughness` write them: rail,from_m,to_m and
    /// rms_30_to_100_mm_m for each band.
    #[arg(value_name = "CSV")]
    pub(crate) path: PathBuf,

    /// The line.
    #[arg(long, value_name = "NAME")]
    pub(crate) line: String,

    /// Day of the survey, as in 2026-01-31.
    #[arg(long, value_name = "DATE")]
    pub(crate) date: String,

    /// Length of a cell of a new store [default: that of most blocks].
    #[arg(long, value_name = "LENGTH")]
    pub(crate) resolution: Option<Quantity<Length>>,

    /// Call a rail of the file by another name; may be repeated. Without it "Höhe links", "L", "1" or "gauche" is the rail that the
    /// line calls left.
    #[arg(long, value_name = "OLD=NEW", value_parser = renamed)]
    pub(crate) rename: Vec<(String, String)>,

    /// Put it in the place of another survey of the line on that day.
    #[arg(long)]
    pub(crate) replace: bool,

    /// Print one JSON document.
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Args)]
#[command(after_help = "Example: riffel network check railway")]
pub(crate) struct Check {
    /// Folder of the store.
    #[arg(value_name = "STORE")]
    pub(crate) store: PathBuf,
}

#[derive(Args)]
#[command(after_help = "Example: riffel network status railway")]
pub(crate) struct Status {
    /// Folder of the store.
    #[arg(value_name = "STORE")]
    pub(crate) store: PathBuf,

    /// Print one JSON document.
    #[arg(long)]
    pub(crate) json: bool,
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

/// What the traffic of a line is expected to make of it.
#[derive(Args)]
pub(crate) struct Expected {
    /// Case file of the track: growth that its traffic is expected to make stands beside that of the surveys, and in its place
    /// where a line has one survey or was ground.
    #[arg(long, value_name = "CASE")]
    pub(crate) case: Option<PathBuf>,

    /// Traffic file [default: the usual traffic of a line of this kind].
    #[arg(long, value_name = "TOML", requires = "case", conflicts_with = "posterior")]
    pub(crate) traffic: Option<PathBuf>,

    /// Folder of a finished calibration of the case: growth over its draws and under its traffic.
    #[arg(long, value_name = "DIR", requires = "case")]
    pub(crate) posterior: Option<PathBuf>,

    /// The line that the case is of [default: all].
    #[arg(long, value_name = "NAME", requires = "case")]
    pub(crate) line: Option<String>,
}

#[derive(Args)]
#[command(after_help = "Example: riffel network worst railway --section \"200 m\" --most 10")]
pub(crate) struct Worst {
    #[command(flatten)]
    pub(crate) judged: Judged,

    /// The state of this day [default: of the latest surveys].
    #[arg(long, value_name = "DATE")]
    pub(crate) until: Option<String>,

    /// Show so many sections.
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) most: u32,
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

#[derive(Args)]
#[command(after_help = "Examples:\n  riffel network growth railway --from 2025-01-31 --to 2026-01-31\n  \
        riffel network growth railway --line \"Main line\" --case case.toml --traffic traffic.toml")]
pub(crate) struct Growth {
    #[command(flatten)]
    pub(crate) judged: Judged,

    #[command(flatten)]
    pub(crate) expected: Expected,

    /// The earlier day: growth begins with the latest survey up to it [default: with the first survey].
    #[arg(long, value_name = "DATE", requires = "to")]
    pub(crate) from: Option<String>,

    /// The later day: growth ends with the latest survey up to it [default: with the last survey].
    #[arg(long, value_name = "DATE", requires = "from")]
    pub(crate) to: Option<String>,

    /// Show so many sections.
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) most: u32,
}

#[derive(Args)]
#[command(after_help = "Examples:\n  riffel network plan railway --months 12 --length \"20 km\"\n  \
        riffel network plan railway --months 12 --money 500000 --cost-per-metre 12 --cost-per-site 3000 --most-track")]
pub(crate) struct Plan {
    #[command(flatten)]
    pub(crate) judged: Judged,

    #[command(flatten)]
    pub(crate) expected: Expected,

    /// Plan for the state in so many months.
    #[arg(long, value_name = "M", allow_negative_numbers = true, value_parser = plain_number, default_value = "12")]
    pub(crate) months: f64,

    /// Length of track that can be ground.
    #[arg(long, value_name = "LENGTH", required_unless_present = "money", conflicts_with_all = ["money", "cost_per_metre", "cost_per_site"])]
    pub(crate) length: Option<Quantity<Length>>,

    /// Money that can be spent.
    #[arg(long, value_name = "MONEY", allow_negative_numbers = true, value_parser = sum_of_money, requires = "cost_per_metre")]
    pub(crate) money: Option<f64>,

    /// Cost of a metre of track.
    #[arg(long, value_name = "MONEY", allow_negative_numbers = true, value_parser = sum_of_money, requires = "money")]
    pub(crate) cost_per_metre: Option<f64>,

    /// Choose the sites that bring the most track below its limit, not the worst sections first.
    #[arg(long)]
    pub(crate) most_track: bool,

    /// Cost of each site, besides.
    #[arg(long, value_name = "MONEY", allow_negative_numbers = true, value_parser = sum_of_money, default_value = "0", requires = "money")]
    pub(crate) cost_per_site: f64,
}

/// The name of a rail and another one for it.
fn renamed(text: &str) -> Result<(String, String), String> {
    match text.split_once('=').map(|(old, new)| (old.trim(), new.trim())) {
        Some((old, new)) if !old.is_empty() && !new.is_empty() => Ok((old.to_owned(), new.to_owned())),
        _ => Err("must be OLD=NEW".to_owned()),
    }
}
