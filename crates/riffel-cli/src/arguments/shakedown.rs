//! Arguments of `shakedown`.

use clap::Args;
use riffel_keys::quantity::{Length, Quantity, Ratio, Speed};

use super::{Asked, CaseArguments, ResultsArguments};

#[derive(Args)]
#[command(
    after_help = "Example: riffel shakedown case.toml --wavelength \"300 mm\" --speed \"50 km/h\" --amplitude \"50 um\""
)]
pub(crate) struct Shakedown {
    #[command(flatten)]
    pub(crate) case: CaseArguments,

    /// Values of the utilised friction |Q|/P at which limits are told, separated by commas [default: 31, from 0 to 0.6].
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    pub(crate) utilised_friction: Vec<Quantity<Ratio>>,

    /// Wavelength of a wave along which the contact is followed.
    #[arg(long, value_name = "LENGTH", requires = "speed")]
    pub(crate) wavelength: Option<Asked<Length>>,

    /// Speed over it.
    #[arg(long, value_name = "SPEED", requires = "wavelength")]
    pub(crate) speed: Option<Asked<Speed>>,

    /// Amplitude of the wave [default: that of the case].
    #[arg(long, value_name = "LENGTH", requires = "wavelength")]
    pub(crate) amplitude: Option<Asked<Length>>,

    #[command(flatten)]
    pub(crate) results: ResultsArguments,
}
