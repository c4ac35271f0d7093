//! The limit of levels that an answer goes by.

use riffel::roughness::LevelLimit;
use riffel_rail::{Limit, LimitTable};

use crate::{AnswerError, Result};

/// The limit of levels of a name or a file, with its table.
///
/// # Errors
/// [`AnswerError::Case`] for a name that is not known or a file at fault, [`AnswerError::Argument`] for a limit of the RMS along the
/// rail.
pub fn level_limit(name: &str) -> Result<(LimitTable, LevelLimit)> {
    let table = LimitTable::find(name)?;
    match &table.limit {
        Limit::Levels(limit) => {
            let limit = limit.clone();
            Ok((table, limit))
        }
        Limit::Rms(_) => Err(AnswerError::argument(
            "--limit",
            name,
            "a table of one-third-octave levels: an RMS along the rail does not follow from a spectrum",
        )),
    }
}
