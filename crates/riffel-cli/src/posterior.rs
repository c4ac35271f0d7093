//! `--posterior`: the folder of a finished calibration in the place of the values of a case.

use std::path::Path;

use riffel_answers::question;
use riffel_answers::{AnswerError, OverPosterior, PosteriorDraws};
use riffel_calibrate::{Chains, Plan};

use crate::arguments::CaseArguments;
use crate::terminal::Terminal;

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
