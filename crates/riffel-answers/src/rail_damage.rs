//! What rolling contact makes of a rail beside wear: where it stands between the limits of shakedown, and cracks along its waves.

use riffel_case::Case;
use riffel_case::traffic::{Traffic, UsualTraffic};
use riffel_keys::Message;
use riffel_rail::GroundRail;
use serde::Serialize;

use crate::forecast::{CrackedWave, ForecastHorizon, ForecastRequest, TrackForecast};
use crate::shakedown::{ShakedownAnswer, ShakedownLimits};
use crate::{AnswerError, Result, level_limit};

/// The limit that the rail is ground to, by some decibels below.
const LIMIT: &str = "iso-3095-2013";
const BELOW_LIMIT: &str = "-6 dB";
/// Months after which cracks are told of, at most.
const MONTHS: f64 = 12.0;

/// Damage of a rail under a traffic.
#[derive(Serialize)]
pub struct RailDamage {
    /// The limits of shakedown, with the operating point over a wave.
    pub shakedown: ShakedownAnswer,
    /// Months after which a rail that was ground has the cracks: a year, or where the forecast ends before; `None` if wear is alone.
    pub months: Option<f64>,
    /// Along the waves of every band; empty where fatigue is not among the laws of the case.
    pub cracks: Vec<CrackedWave>,
    /// What hardening and cracks make of the waves.
    #[serde(skip)]
    pub findings: Vec<Message>,
}

impl RailDamage {
    /// Of a case over a wave of a wavelength \[m\] at a speed \[m/s\], under a traffic or else the usual one of the line.
    ///
    /// # Errors
    /// [`AnswerError`] for a wave that the case does not know, and as of [`TrackForecast::new`].
    pub fn new(case: &Case, traffic: Option<&Traffic>, wave: [f64; 2]) -> Result<Self> {
        let question = ShakedownLimits { wave: Some(wave), ..ShakedownLimits::default() };
        let mut damage =
            Self { shakedown: question.answer(case)?, months: None, cracks: Vec::new(), findings: Vec::new() };
        if case.has_other_damage() {
            let forecast = after_grinding(case, traffic)?;
            damage.cracks = forecast.cracks();
            damage.months = forecast.months(forecast.until());
            damage.findings = forecast.damage_in_words().collect();
        }
        Ok(damage)
    }
}

/// The forecast of a rail that was just ground.
fn after_grinding(case: &Case, traffic: Option<&Traffic>) -> Result<TrackForecast> {
    let traffic = match traffic {
        Some(traffic) => traffic.clone(),
        None => UsualTraffic::of(case).traffic()?,
    };
    let (table, limit) = level_limit(LIMIT)?;
    let ground = GroundRail::below(&table.edition, &limit, BELOW_LIMIT);
    let ground = ground.map_err(|rule| AnswerError::argument("--ground", BELOW_LIMIT, rule))?;
    let request = ForecastRequest {
        traffic,
        survey: None,
        ground: Some(ground),
        horizon: ForecastHorizon::Months(MONTHS),
        limit: (table, limit),
        date: None,
        tells_spreads: false,
    };
    TrackForecast::new(case, request, &|_| ())
}
