//! Arguments of `stability`.

use clap::Args;
use riffel_keys::quantity::{Quantity, Ratio};

use super::{CaseArguments, ResultsArguments};

#[derive(Args)]
#[command(
    after_help = "Example: riffel stability case.toml --friction 0.1,0.2,0.3,0.4,0.5 --set 'map.speed={min=\"20 km/h\",max=\"80 km/h\"}'\n\n\
        Each friction has the mean state of its own; the speeds are those of map.speed."
)]
pub(crate) struct Stability {
    #[command(flatten)]
    pub(crate) case: CaseArguments,

    /// Friction coefficients, separated by commas [default: 23, from 0.05 to 0.6].
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    pub(crate) friction: Vec<Quantity<Ratio>>,

    #[command(flatten)]
    pub(crate) results: ResultsArguments,
}
