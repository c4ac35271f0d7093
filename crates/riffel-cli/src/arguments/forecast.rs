//! Arguments of `report` on what comes and what helps.

use clap::{Args, ValueEnum};
use riffel_answers::question::GroundSource;
use riffel_case::Hold;

/// A rail that will be ground, in place of the rail as it was measured.
#[derive(Args, Clone, Default)]
#[group(id = "ground_rail", multiple = false)]
pub(crate) struct Ground {
    /// Begin with the spectrum that grinding leaves: a limit table of levels by name or as a TOML file, or a file
    /// of spectra measured after grinding.
    #[arg(long, value_name = "SPECTRUM")]
    pub(crate) ground: Option<String>,

    /// Begin so many decibels below the limit, as in "-6 dB".
    #[arg(long, value_name = "DECIBELS", allow_hyphen_values = true)]
    pub(crate) from_limit: Option<String>,
}

impl Ground {
    /// The same in a question.
    pub(crate) fn source(&self) -> GroundSource {
        GroundSource { ground: self.ground.clone(), from_limit: self.from_limit.clone() }
    }
}

/// What is held where a variant changes friction or load.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum HoldArgument {
    /// The traction force, which a train that pulls or brakes asks for.
    Force,
    /// The tractive ratio: less friction means less traction.
    Ratio,
    /// The creepage, which a curve imposes.
    Creepage,
}

impl From<HoldArgument> for Hold {
    fn from(argument: HoldArgument) -> Self {
        match argument {
            HoldArgument::Force => Self::Force,
            HoldArgument::Ratio => Self::Ratio,
            HoldArgument::Creepage => Self::Creepage,
        }
    }
}
