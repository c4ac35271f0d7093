//! `--posterior`: the folder of a finished calibration in the place of the values of a case.

use std::path::Path;

use riffel_answers::question::{self, PosteriorSource};
use riffel_answers::{AnswerError, OverPosterior, PosteriorDraws};
use riffel_calibrate::{Chains, Plan};

use crate::arguments::{CaseArguments, Posterior};
use crate::terminal::Terminal;

impl Posterior {
    /// The draws of a calibration of the case, if a folder is given.
    pub(crate) fn draws(&self, case: &CaseArguments) -> miette::Result<Option<PosteriorDraws>> {
        let source = PosteriorSource { posterior: self.posterior.clone() };
        Ok(source.draws(&case.source(), &Terminal)?)
    }
}

/// An answer over the draws, if there are any.
pub(crate) fn over(
    draws: Option<&PosteriorDraws>,
    answer: impl FnOnce(&PosteriorDraws, &(dyn Fn(usize) + Sync)) -> Result<OverPosterior, AnswerError>,
) -> Result<Option<OverPosterior>, AnswerError> {
    question::over(draws, &Terminal, answer)
}

/// The plan and the chains of a folder, which are of the case that is named and of no other.
pub(crate) fn finished_of(case: &CaseArguments, folder: &Path) -> miette::Result<(Plan, Chains)> {
    Ok(question::finished_of(&|path| case.source().is_just(path), folder)?)
}
