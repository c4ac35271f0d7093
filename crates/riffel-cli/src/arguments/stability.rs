//! Arguments of `stability`.

use std::path::PathBuf;

use clap::Args;
use riffel_keys::quantity::{Quantity, Ratio};

use super::CaseArguments;

#[derive(Args)]
#[command(
    after_help = "Example: riffel stability case.toml --friction 0.1,0.2,0.3,0.4,0.5 --set 'map.speed={min=\"20 km/h\",max=\"80 km/h\"}'\n\n\
        Each friction has the mean state of its own; the speeds are those of map.speed."
)]
pub(crate) struct Stability {
    #[command(flatten)]
    pub(crate) case: CaseArguments,

    /// Friction coefficients, separated by commas [default: 23, from 0.05 to 0.6].
    #[arg(
        long,
        value_name = "LIST",
        value_delimiter = ',',
        allow_hyphen_values = true
    )]
    pub(crate) friction: Vec<Quantity<Ratio>>,

    /// Folder for the results, made if need be [default: CASE-stability].
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,

    /// Print one JSON document; files are written only with --output.
    #[arg(long)]
    pub(crate) json: bool,
}
