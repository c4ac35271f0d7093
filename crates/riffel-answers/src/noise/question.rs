//! What is asked of rolling noise.

use riffel_case::traffic::Traffic;
use riffel_keys::quantity::{Area, Length, Speed};
use riffel_keys::say;
use riffel_noise::{FrequencyBand, Surroundings};
use riffel_rail::Survey;
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::json;

use super::NoiseAnswer;
use super::train::Train;
use crate::question::{
    AsWritten, CaseSource, Client, EarlierRecords, PosteriorSource, Question, RecordLayout, Rule, Source, of_keys, over,
};
use crate::{Answer, PosteriorDraws, Result};

/// How loud a train is on a rough rail, and what would make it quieter.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct NoiseQuestion {
    /// The case.
    #[serde(flatten)]
    pub case: CaseSource,
    /// Roughness of the rail: a table of one-third-octave levels or a longitudinal profile; the energy mean of its latest
    /// records is taken.
    #[schemars(extend("value_name" = "FILE", "alias" = "after"))]
    pub roughness: Source<Survey>,
    /// Roughness of the same rail before, as before grinding: a file like that of --roughness, which is compared with it.
    #[schemars(extend("value_name" = "FILE"))]
    pub before: Option<Source<Survey>>,
    /// Records before the roughness.
    #[serde(flatten)]
    pub earlier: EarlierRecords,
    /// How the records are read.
    #[serde(flatten)]
    pub layout: RecordLayout,
    /// Keep the spectra of a table whose column has this value; may be repeated.
    #[serde(rename = "where")]
    #[schemars(extend("value_name" = "COLUMN=VALUE"))]
    pub choose: Vec<String>,
    /// Speed of the train, in m/s or with its unit.
    pub speed: AsWritten<Speed>,
    /// Wheels of the train on one rail.
    #[schemars(range(min = 1, max = 10_000), extend("value_name" = "N", "default" = 4))]
    pub wheels: u32,
    /// Length of the train [default: 6.6 m for each wheel, as of a coach of 26.4 m on four wheelsets].
    pub train_length: Option<AsWritten<Length>>,
    /// Roughness of the wheels: a file of spectra, or cnossos-cast-iron-blocks, cnossos-composite-blocks or
    /// cnossos-disc-brakes [default: none, smooth wheels].
    #[schemars(with = "Option<Source<()>>", extend("value_name" = "FILE"))]
    pub wheel_roughness: Option<String>,
    /// Modes of the web and tyre of the wheels by name, straight-web-920, or as a TOML file [default: none, rigid wheels].
    #[schemars(extend("value_name" = "MODES"))]
    pub wheel_modes: Option<String>,
    /// Measured decay rates of the track, in place of those of the case: a table with the columns frequency_hz and
    /// decay_rate_db_per_m.
    #[schemars(extend("value_name" = "CSV"))]
    pub decay_rate: Option<Source<DecayRates>>,
    /// Transfer function of the track by name, such as cnossos-monobloc-medium-pads, or as a TOML file: the level by the
    /// source model of the European directive, beside that of the case.
    #[schemars(extend("value_name" = "TRANSFER"))]
    pub track_transfer: Option<String>,
    /// Transfer function of the vehicle, such as cnossos-wheel-920.
    #[schemars(extend("value_name" = "TRANSFER"))]
    pub vehicle_transfer: Option<String>,
    /// Distance of the receiver from the middle of the track.
    #[schemars(extend("default" = "7.5 m"))]
    pub distance: AsWritten<Length>,
    /// Height of the receiver above the rail.
    #[schemars(extend("default" = "1.2 m"))]
    pub height: AsWritten<Length>,
    /// Breadth of the rail foot.
    #[schemars(extend("default" = "150 mm"))]
    pub rail_foot: AsWritten<Length>,
    /// Face of a sleeper that belongs to one rail.
    #[schemars(extend("default" = "0.33 m2"))]
    pub sleeper_area: AsWritten<Area>,
    /// Limit of the levels of roughness to which the rail may be ground, by name or as a TOML file.
    #[schemars(extend("default" = "iso-3095-2013"))]
    pub limit: String,
    /// Traffic file: the level in months to come.
    #[schemars(extend("value_name" = "TOML"))]
    pub traffic: Option<Source<Traffic>>,
    /// A calibration of the case.
    #[serde(flatten)]
    pub posterior: PosteriorSource,
    /// Look so many months ahead.
    #[schemars(extend("value_name" = "M", "default" = 12))]
    pub months: f64,
    /// Highest level allowed, to say in how many months it is reached.
    #[schemars(extend("value_name" = "DECIBELS"))]
    pub limit_dba: Option<f64>,
    /// What is around track and receiver.
    #[serde(skip)]
    pub surroundings: Surroundings,
}

/// Bands with their decay rates \[dB/m\].
pub type DecayRates = Vec<(FrequencyBand, f64)>;

impl NoiseQuestion {
    /// A coach at a speed \[m/s\] on a rail in memory, all else by default.
    ///
    /// # Errors
    /// None but those of a default that does not fit its key.
    pub fn of_a_coach(case: impl Into<CaseSource>, survey: Survey, speed: f64, limit: &str) -> Result<Self> {
        let question: Self = of_keys(json!({ "case": "", "roughness": "", "speed": speed, "limit": limit }))?;
        Ok(Self { case: case.into(), roughness: survey.into(), ..question })
    }

    /// The answer; `client` is told how far it is and what is unusual.
    ///
    /// # Errors
    /// [`AnswerError::Argument`](crate::AnswerError::Argument) where a number is outside its range, no band is known, or the track has no decay;
    /// [`AnswerError::Case`](crate::AnswerError::Case) with the key or the file at fault.
    pub fn answer(&self, client: &dyn Client) -> Result<NoiseAnswer> {
        let draws = self.posterior.draws(&self.case, client)?;
        self.answer_over(draws.as_ref(), client)
    }

    /// The answer on the case and over draws in memory, under the traffic of the calibration where the question has none.
    ///
    /// # Errors
    /// Errors of [`answer`](Self::answer).
    pub fn answer_over(&self, draws: Option<&PosteriorDraws>, client: &dyn Client) -> Result<NoiseAnswer> {
        let train = Train::new(self, client)?;
        let case = self.case.read(client)?;
        let own = self.traffic.as_ref().map(|traffic| traffic.value(Traffic::read)).transpose()?;
        let traffic = own.as_deref().or(draws.and_then(|draws| draws.traffic.as_ref()));
        let step = client.begin(say!(progress_traffic), traffic.map_or(0, |traffic| traffic.file.vehicle.len()));
        let mut answer = train.answer(&case, traffic, &step)?;
        drop(step);
        answer.over_posterior = over(draws, client, |draws, progress| {
            draws.over(progress, |drawn| train.answer(&drawn.case, drawn.traffic.as_ref().or(traffic), &|_| ()))
        })?;
        Ok(answer)
    }
}

impl Question for NoiseQuestion {
    const NAME: &'static str = "noise";
    const EXAMPLE: &'static str = "\
        Example: riffel noise case.toml --roughness spectra.csv --speed \"140 km/h\" --wheel-roughness cnossos-disc-brakes\n\n\
        Months until a level is reached: riffel noise case.toml --roughness spectra.csv --speed \"140 km/h\" --traffic \
        traffic.toml --months 24 --limit-dba 88";
    const RULES: &'static [Rule] = &[
        EarlierRecords::RULE,
        Rule::Needs(&["track_transfer"], &["vehicle_transfer"]),
        Rule::Needs(&["vehicle_transfer"], &["track_transfer"]),
        Rule::OneOf(&["traffic", "posterior"]),
        Rule::Needs(&["months", "limit_dba"], &["traffic", "posterior"]),
    ];

    fn ask(&self, client: &dyn Client) -> Result<Box<dyn Answer>> {
        Ok(Box::new(self.answer(client)?))
    }
}
