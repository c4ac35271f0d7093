//! A calibration in the place of the values of a case.

use std::path::{Path, PathBuf};

use riffel_calibrate::{Chains, Plan, finished};
use riffel_keys::say;
use schemars::JsonSchema;
use serde::Deserialize;

use super::{CaseSource, Client};
use crate::{AnswerError, OverPosterior, PosteriorDraws, Result};

/// The folder of a finished calibration.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
pub struct PosteriorSource {
    /// Folder of a finished calibration of the case: the answer over its draws and under its traffic as well, medians with bands of
    /// 50 and 90 %.
    #[schemars(with = "Option<String>", extend("value_name" = "DIR", "path" = true))]
    pub posterior: Option<PathBuf>,
}

impl PosteriorSource {
    /// The draws of a calibration of the case, if a folder is given.
    ///
    /// # Errors
    /// [`AnswerError::Argument`] for a calibration of another case, [`AnswerError::Case`] for one that is not finished.
    pub fn draws(&self, case: &CaseSource, client: &dyn Client) -> Result<Option<PosteriorDraws>> {
        let Some(folder) = &self.posterior else {
            return Ok(None);
        };
        let (plan, chains) = finished_of(&|path| case.is_just(path), folder)?;
        let draws = PosteriorDraws::new(&plan, &chains)?;
        client.remark(&draws.remarks);
        Ok(Some(draws))
    }
}

/// The plan and the chains of a folder, which are of the case that is named and of no other.
///
/// # Errors
/// [`AnswerError::Argument`] for a calibration of another case, [`AnswerError::Case`] for one that is not finished.
pub fn finished_of(is_case: &dyn Fn(&Path) -> bool, folder: &Path) -> Result<(Plan, Chains)> {
    let (plan, chains) = finished(folder, None)?;
    if !is_case(&plan.inputs[1]) {
        let rule =
            format!("a calibration of the case that is named, without --set; it is of {}", plan.inputs[1].display());
        return Err(AnswerError::argument("--posterior", folder.display(), rule));
    }
    Ok((plan, chains))
}

/// An answer over the draws, if there are any.
///
/// # Errors
/// Errors of `answer`.
pub fn over(
    draws: Option<&PosteriorDraws>,
    client: &dyn Client,
    answer: impl FnOnce(&PosteriorDraws, &(dyn Fn(usize) + Sync)) -> Result<OverPosterior>,
) -> Result<Option<OverPosterior>> {
    let Some(draws) = draws else {
        return Ok(None);
    };
    let step = client.begin(say!(progress_draws_of_calibration), draws.count());
    answer(draws, &step).map(Some)
}
