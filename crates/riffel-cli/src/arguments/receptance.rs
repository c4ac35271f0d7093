//! Arguments of `receptance`.

use clap::{Args, ValueEnum};
use riffel_keys::quantity::{Frequency, Length, Quantity, Speed};

use super::ResultsArguments;
use super::asked::Asked;
use super::case::CaseArguments;

#[derive(Args)]
#[command(after_help = "Example: riffel receptance case.toml --from \"50 Hz\" --to \"2 kHz\"")]
pub(crate) struct Receptance {
    #[command(flatten)]
    pub(crate) case: CaseArguments,

    /// Lowest frequency, in Hz or with its unit [default: 20 Hz, or the lowest measured].
    #[arg(long, value_name = "FREQUENCY")]
    pub(crate) from: Option<Asked<Frequency>>,

    /// Highest frequency, in Hz or with its unit [default: 5 kHz, or the highest measured].
    #[arg(long, value_name = "FREQUENCY")]
    pub(crate) to: Option<Asked<Frequency>>,

    /// Number of frequencies, equally spaced in their logarithm.
    #[arg(long, value_name = "N", default_value_t = 600, value_parser = clap::value_parser!(u32).range(2..=1_000_000))]
    pub(crate) points: u32,

    /// Speed of the load, in m/s or with its unit [default: the highest of the map].
    #[arg(long, value_name = "SPEED")]
    pub(crate) speed: Option<Asked<Speed>>,

    /// Place of the wheel on discrete supports, from one of them [default: that of the case].
    #[arg(long, value_name = "LENGTH")]
    pub(crate) position: Option<Quantity<Length>>,

    /// Direction of force and displacement; wheel and contact are vertical only.
    #[arg(long, value_enum, default_value_t = DirectionArgument::Vertical)]
    pub(crate) direction: DirectionArgument,

    /// Matrices of track and wheel along all axes x, y, z of the track, at the contact under study.
    #[arg(long, conflicts_with = "direction")]
    pub(crate) matrix: bool,

    /// Frequencies of --matrix, separated by commas, in Hz or with their unit, in place of --from, --to and --points.
    #[arg(long, value_name = "LIST", value_delimiter = ',', requires = "matrix", conflicts_with_all = ["from", "to", "points"])]
    pub(crate) frequencies: Vec<Asked<Frequency>>,

    #[command(flatten)]
    pub(crate) results: ResultsArguments,
}

/// Direction of force and displacement.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum DirectionArgument {
    /// Downward.
    Vertical,
    /// Across the track.
    Lateral,
    /// Along the rail.
    Longitudinal,
}
