//! The rail right after grinding.

use std::path::Path;

use riffel::roughness::LevelLimit;
use riffel_case::Case;
use riffel_keys::Message;
use riffel_rail::{GroundRail, LimitTable, Survey};
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer};
use serde_json::Value;

use super::as_written::written;
use super::{Client, RecordLayout};
use crate::{AnswerError, Result};

/// A rail that will be ground, in place of the rail as it was measured.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
pub struct GroundSource {
    /// Begin with the spectrum that grinding leaves: a limit table of levels by name or as a TOML file, or a file
    /// of spectra measured after grinding.
    #[schemars(extend("value_name" = "SPECTRUM"))]
    pub ground: Option<String>,
    /// Begin so many decibels below the limit, as in "-6 dB".
    #[serde(default, deserialize_with = "as_written")]
    #[schemars(extend("value_name" = "DECIBELS", "type" = ["string", "number"]))]
    pub from_limit: Option<String>,
}

fn as_written<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<String>, D::Error> {
    Ok(Option::<Value>::deserialize(deserializer)?.map(written))
}

impl GroundSource {
    /// The rail that will be ground, if one is asked for, under a limit that is its table's or another's.
    ///
    /// # Errors
    /// [`AnswerError::Argument`] for a rail that is not below the limit, [`AnswerError::Case`] with the file at fault.
    pub fn read(&self, limit: &(LimitTable, LevelLimit), client: &dyn Client) -> Result<Option<GroundRail>> {
        let ground = self.at_most(limit, client)?;
        match (&self.ground, &ground) {
            (Some(name), Some(rail)) if GroundRail::is_table(name) && rail.spectrum == *limit.1.spectrum() => {
                let rule = "smoother than --limit, which is the same table: choose another limit, or --from-limit \"-6 dB\" to begin \
                            below it";
                Err(AnswerError::argument("--ground", name, rule))
            }
            _ => Ok(ground),
        }
    }

    /// Ground rail of the question, which may lie at the limit itself.
    ///
    /// # Errors
    /// Errors of [`read`](Self::read) but for its rule.
    pub(crate) fn at_most(
        &self,
        (table, limit): &(LimitTable, LevelLimit),
        client: &dyn Client,
    ) -> Result<Option<GroundRail>> {
        if let Some(decibels) = &self.from_limit {
            let below = GroundRail::below(&table.edition, limit, decibels);
            return below.map(Some).map_err(|rule| AnswerError::argument("--from-limit", decibels, rule));
        }
        let Some(name) = &self.ground else {
            return Ok(None);
        };
        if !GroundRail::is_table(name) {
            let survey = RecordLayout::default().survey(Path::new(name), client)?;
            let (latest, _) = survey.latest();
            return Ok(Some(GroundRail { spectrum: latest.mean(), words: Message::verbatim(name) }));
        }
        Ok(Some(GroundRail::of_table(name)?))
    }

    /// An error of an answer, of the argument that gave a spectrum without a band in the window of the case.
    pub fn outside(&self, spectrum: Option<&Survey>, case: &Case, error: AnswerError) -> AnswerError {
        let AnswerError::OutsideWindow(error) = error else {
            return error;
        };
        let (argument, value) = match (&self.ground, &self.from_limit) {
            (Some(name), _) => ("--ground", name.clone()),
            (_, Some(decibels)) => ("--from-limit", decibels.clone()),
            _ => ("--spectrum", spectrum.map_or_else(String::new, |survey| survey.path().display().to_string())),
        };
        let rule = format!(
            "of bands between {:.0} and {:.0} mm, map.wavelength of the case: {error}",
            1e3 * case.wavelength.min(),
            1e3 * case.wavelength.max()
        );
        AnswerError::argument(argument, value, rule)
    }
}
