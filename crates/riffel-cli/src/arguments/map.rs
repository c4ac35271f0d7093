//! Arguments of `map`.

use std::path::PathBuf;

use clap::Args;
use riffel_keys::quantity::{Length, Quantity, Speed};

use super::ResultsArguments;
use super::asked::Asked;
use super::case::CaseArguments;
use super::posterior::Posterior;

#[derive(Args)]
#[command(after_help = "Example: riffel map case.toml -o results --set contact.friction=0.3")]
pub(crate) struct Map {
    #[command(flatten)]
    pub(crate) case: CaseArguments,

    /// Measured corrugation to draw on the map: a table with the columns wavelength, speed and label,
    /// values in SI, with their units, or with those in the head, as in wavelength_mm.
    #[arg(long, value_name = "CSV")]
    pub(crate) observations: Option<PathBuf>,

    /// Traffic file, for growth under the traffic [default: the usual traffic of a line of this kind].
    #[arg(long, value_name = "FILE", conflicts_with_all = ["wheels", "posterior"])]
    pub(crate) traffic: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) posterior: Posterior,

    /// Place of the wheel on discrete supports, from one of them [default: that of the case].
    #[arg(long, value_name = "LENGTH")]
    pub(crate) position: Option<Quantity<Length>>,

    /// Growth over the bay between two supports as well: maps over a support, in mid-span and of the
    /// mean, and the curve of growth against position.
    #[arg(long)]
    pub(crate) bay: bool,

    /// Every wheel of the vehicle in its curve instead, side by side: maps in one scale, growth under the usual traffic, and a
    /// table of mean states. Needs contact.from.
    #[arg(long, conflicts_with_all = ["bay", "observations"])]
    pub(crate) wheels: bool,

    /// Wavelength of the curve over the bay [default: where the mean grows fastest].
    #[arg(long, value_name = "LENGTH", requires = "bay", requires = "speed")]
    pub(crate) wavelength: Option<Asked<Length>>,

    /// Speed of the curve over the bay.
    #[arg(long, value_name = "SPEED", requires = "bay", requires = "wavelength")]
    pub(crate) speed: Option<Asked<Speed>>,

    #[command(flatten)]
    pub(crate) results: ResultsArguments,
}
