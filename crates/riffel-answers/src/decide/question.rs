//! What is asked of actions.

use std::path::PathBuf;

use riffel_calibrate::finished;
use schemars::JsonSchema;
use serde::Deserialize;

use super::DecideAnswer;
use crate::question::{Client, Files, Question, Source};
use crate::{Answer, Result};

/// Which action pays, over the posterior of a calibration, and what to measure first.
#[derive(Debug, Deserialize, JsonSchema)]
pub struct DecideQuestion {
    /// Folder of a finished calibration; the results are written there.
    #[schemars(with = "String", extend("positional" = true, "path" = true))]
    dir: PathBuf,
    /// The plan [default: the one that the chains were drawn for].
    #[schemars(with = "Option<Source<()>>")]
    plan: Option<PathBuf>,
}

impl Question for DecideQuestion {
    const NAME: &'static str = "decide";
    const EXAMPLE: &'static str = "Example: riffel decide posterior\n\n\
        The plan of the calibration has [[action]], [cost] and, if wished, [[measurement]]; they may be written after the chains \
        are drawn.";
    const FILES: Files = Files::There;

    fn ask(&self, _: &dyn Client) -> Result<Box<dyn Answer>> {
        let (plan, chains) = finished(&self.dir, self.plan.as_deref())?;
        Ok(Box::new(DecideAnswer::new(&plan, &chains)?))
    }
}
