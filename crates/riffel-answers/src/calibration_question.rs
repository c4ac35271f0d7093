//! What is asked of measurements on the uncertain values of a case.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::Deserialize;

use crate::question::{Client, Files, Question, Rule, Source};
use crate::{Answer, AnswerError, Result};

/// What measurements say of the uncertain values of a case.
#[derive(Debug, Deserialize, JsonSchema)]
pub struct CalibrateQuestion {
    /// Plan of the calibration; with --with the case.
    #[schemars(with = "Source<()>", extend("positional" = true))]
    pub plan: PathBuf,
    /// Table of measurements, whose columns say of what kind it is; may be repeated. PLAN is the case then, and all that these
    /// data tell of it is uncertain.
    #[serde(rename = "with")]
    #[schemars(with = "Vec<Source<()>>", extend("value_name" = "FILE"))]
    pub tables: Vec<PathBuf>,
    /// Traffic that made dated levels grow, beside --with.
    #[schemars(with = "Option<Source<()>>", extend("value_name" = "FILE"))]
    pub traffic: Option<PathBuf>,
    /// Folder for the results, made if need be [default: PLAN-posterior].
    #[schemars(with = "Option<String>", extend("value_name" = "DIR", "path" = true))]
    pub output: Option<PathBuf>,
    /// Keep the finished parts of chains that were stopped, and go on from there; put chains of this plan in the place of those of
    /// another, which are refused otherwise.
    pub restart: bool,
    /// Read and check everything, say what would be computed, and write nothing.
    pub dry_run: bool,
    /// Number of threads [default: one for each processor].
    #[schemars(range(min = 1), extend("value_name" = "N"))]
    pub threads: Option<u16>,
}

impl Question for CalibrateQuestion {
    const NAME: &'static str = "calibrate";
    const EXAMPLE: &'static str = "Examples:\n  \
        riffel calibrate plan.toml -o posterior\n  \
        riffel calibrate case.toml --with hammer.csv --with levels.csv --traffic traffic.toml -o posterior\n  \
        riffel calibrate check plan.toml --runs 100\n\n\
        The plan names the case, the uncertain keys with their priors, and the data: frequency responses, decay rates, dated \
        levels, runs of axle boxes. Of a case and tables of data, a plan with usual priors is written to the folder first. The same \
        seed gives the same draws on any number of threads.\n\n\
        Exit status: 0 done, 1 the chains allow no conclusion (results are written all the same), 2 bad input, 130 stopped by \
        Ctrl-C (--restart goes on).";
    const RULES: &'static [Rule] = &[Rule::Needs(&["traffic"], &["with"]), Rule::OneOf(&["dry_run", "restart"])];
    const FILES: Files = Files::OutputOnly;

    fn ask(&self, _: &dyn Client) -> Result<Box<dyn Answer>> {
        Err(AnswerError::InFolder { question: Self::NAME })
    }
}
