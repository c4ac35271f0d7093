//! The rail right after grinding, as the command line asks for it.

use std::path::Path;

use riffel::roughness::LevelLimit;
use riffel_keys::Message;
use riffel_rail::{GroundRail, LimitTable};

use crate::arguments::{Ground, Layout};
use crate::command::roughness::survey;
use crate::error::CliError;

/// The rail that will be ground, if one is asked for.
pub(crate) fn ground_rail(
    ground: &Ground,
    table: &LimitTable,
    limit: &LevelLimit,
) -> miette::Result<Option<GroundRail>> {
    let refuse = |argument, value: &str, rule: String| CliError::Argument { argument, value: value.to_owned(), rule };
    if let Some(decibels) = &ground.from_limit {
        let below = GroundRail::below(&table.edition, limit, decibels);
        let below = below.map_err(|rule| refuse("--from-limit", decibels, rule))?;
        return Ok(Some(below));
    }
    let Some(name) = &ground.ground else {
        return Ok(None);
    };
    if !GroundRail::is_table(name) {
        return Ok(Some(GroundRail {
            spectrum: survey(Path::new(name), &Layout::default())?.latest().0.mean(),
            words: Message::verbatim(name),
        }));
    }
    let ground = GroundRail::of_table(name)?;
    if ground.spectrum == *limit.spectrum() {
        Err(refuse(
            "--ground",
            name,
            "smoother than --limit, which is the same table: choose another limit, or --from-limit \"-6 dB\" to begin \
             below it"
                .to_owned(),
        ))?;
    }
    Ok(Some(ground))
}
