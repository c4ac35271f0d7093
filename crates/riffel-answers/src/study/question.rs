//! What is asked of studies.

use std::path::{Path, PathBuf};

use riffel_keys::quantity::{Quantity, Ratio};
use riffel_keys::{number, say};
use riffel_study::{ResultFolder, Shard};
use schemars::JsonSchema;
use serde::Deserialize;

use super::{MergeAnswer, SensitivityAnswer, SensitivityRequest};
use crate::question::{Client, Files, Question, Source};
use crate::{Answer, AnswerError, Result};

/// Many cases of one kind: grids, samples of distributions, what matters and how sure it is.
#[derive(Debug, Deserialize, JsonSchema)]
pub struct StudyQuestion {
    /// Plan of the study, or - for standard input.
    #[schemars(with = "Source<()>", extend("positional" = true))]
    pub plan: PathBuf,
    /// Folder for the results, made if need be, or begun before [default: PLAN-results].
    #[schemars(with = "Option<String>", extend("value_name" = "DIR", "path" = true))]
    pub output: Option<PathBuf>,
    /// Part of the work, as 3/8: every eighth chunk from the third on. Parts may share a folder, or have one
    /// each and be merged.
    #[schemars(with = "Option<String>", extend("value_name" = "I/N"))]
    pub shard: Option<Part>,
    /// Number of threads [default: one for each processor].
    #[schemars(range(min = 1), extend("value_name" = "N"))]
    pub threads: Option<u16>,
}

/// A part of the work as it is written.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(try_from = "String")]
pub struct Part(pub Shard);

impl TryFrom<String> for Part {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        text.parse().map(Self)
    }
}

impl Question for StudyQuestion {
    const NAME: &'static str = "study";
    const EXAMPLE: &'static str = "Examples:\n  \
        riffel init --study && riffel init nominal.toml && riffel study study.toml\n  \
        riffel study study.toml -o results --shard $SLURM_ARRAY_TASK_ID/100\n  \
        riffel study merge whole part-1 part-2 part-3\n  \
        riffel study sensitivity study-results\n\n\
        A study that was stopped goes on with the same command: finished chunks are kept.";
    const FILES: Files = Files::OutputOnly;

    fn ask(&self, _: &dyn Client) -> Result<Box<dyn Answer>> {
        Err(AnswerError::InFolder { question: Self::NAME })
    }
}

/// Copy the finished chunks of shards into one folder.
#[derive(Debug, Deserialize, JsonSchema)]
pub struct MergeQuestion {
    /// Folder that takes them, made if need be.
    #[schemars(with = "String", extend("positional" = true, "path" = true))]
    into: PathBuf,
    /// Folders of results of the same plan.
    #[schemars(with = "Vec<String>", length(min = 1), extend("positional" = true, "path" = true))]
    from: Vec<PathBuf>,
}

impl Question for MergeQuestion {
    const NAME: &'static str = "study merge";
    const EXAMPLE: &'static str = "Example: riffel study merge whole part-1 part-2 part-3";
    const FILES: Files = Files::None;

    fn ask(&self, _: &dyn Client) -> Result<Box<dyn Answer>> {
        let from: Vec<&Path> = self.from.iter().map(AsRef::as_ref).collect();
        let report = ResultFolder::merge(&self.into, &from)?;
        Ok(Box::new(MergeAnswer { report, into: self.into.clone() }))
    }
}

/// Which parameters matter: Sobol indices, tornado, Monte-Carlo bands.
#[derive(Debug, Deserialize, JsonSchema)]
pub struct SensitivityQuestion {
    /// Folder with the results of a finished study.
    #[schemars(with = "String", extend("positional" = true, "path" = true))]
    dir: PathBuf,
    /// Result to look at; may be repeated [default: all that are one number for each sample].
    #[serde(rename = "result")]
    #[schemars(extend("value_name" = "NAME"))]
    results: Vec<String>,
    /// Confidence of the intervals.
    #[schemars(extend("value_name" = "RATIO", "default" = "95 %"))]
    confidence: Quantity<Ratio>,
    /// Folder for table and figures, made if need be [default: that of the study].
    #[schemars(with = "Option<String>", extend("value_name" = "DIR", "path" = true))]
    pub output: Option<PathBuf>,
}

impl Question for SensitivityQuestion {
    const NAME: &'static str = "study sensitivity";
    const EXAMPLE: &'static str = "Example: riffel study sensitivity study-results --result highest_growth_rate";
    const FILES: Files = Files::There;

    fn ask(&self, _: &dyn Client) -> Result<Box<dyn Answer>> {
        let (study, folder) = ResultFolder::open(&self.dir)?;
        let summary = folder.summary()?;
        if summary.chunks_finished < summary.chunks {
            return Err(AnswerError::Unfinished(say!(
                study_not_finished,
                folder = self.dir.display().to_string(),
                missing = number(summary.chunks - summary.chunks_finished),
                chunks = number(summary.chunks)
            )));
        }
        let request = SensitivityRequest { results: self.results.clone(), confidence: self.confidence.si() };
        Ok(Box::new(SensitivityAnswer::new(study, &folder, &request)?))
    }
}
