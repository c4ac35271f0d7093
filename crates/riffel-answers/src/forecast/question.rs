//! What is asked of the future of a rail.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use jiff::civil::Date;
use riffel::roughness::LevelLimit;
use riffel_case::traffic::{Traffic, bands_of};
use riffel_case::{Case, Variant};
use riffel_keys::say;
use riffel_rail::{GroundRail, LimitTable, Survey};
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer};

use super::measured_spectra::{Dated, MeasuredSpectra};
use super::{ForecastAnswer, ForecastHorizon, ForecastRequest, PosteriorForecast, TrackForecast, WearReport};
use crate::question::{
    CaseSource, Client, EarlierRecords, GroundSource, Question, RecordLayout, Rule, Source, date_of, finished_of,
};
use crate::{Answer, AnswerError, Result, level_limit};

/// What becomes of a measured spectrum under traffic: levels, grinding interval, wear coefficient.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ForecastQuestion {
    /// The case.
    #[serde(flatten)]
    pub case: CaseSource,
    /// What was measured.
    #[serde(flatten)]
    pub spectra: MeasuredSpectra,
    /// What the rail will be ground to.
    #[serde(flatten)]
    pub ground: GroundSource,
    /// Traffic file: vehicles with their shares, loads, speeds and traction; `riffel init --traffic` writes
    /// one.
    #[schemars(extend("value_name" = "TOML"))]
    pub traffic: Option<Source<Traffic>>,
    /// Folder of a finished calibration of the case: its levels, traffic and draws, with bands of 50 and 90 %.
    #[schemars(with = "Option<String>", extend("value_name" = "DIR", "path" = true))]
    pub posterior: Option<PathBuf>,
    /// Limit of the levels, by name or as a TOML file.
    #[schemars(extend("default" = "iso-3095-2013"))]
    pub limit: String,
    /// Look so many axle passages ahead.
    #[schemars(extend("value_name" = "N"))]
    pub passages: Option<f64>,
    /// Look so many million gross tonnes ahead.
    #[schemars(extend("value_name" = "X"))]
    pub mgt: Option<f64>,
    /// Look so many months ahead [default: 12].
    #[schemars(extend("value_name" = "M"))]
    pub months: Option<f64>,
    /// Date of the spectrum, from which dates are counted [default: that of --date-column].
    #[serde(default, deserialize_with = "date")]
    #[schemars(with = "Option<String>")]
    pub date: Option<Date>,
}

fn date<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<Date>, D::Error> {
    Option::<String>::deserialize(deserializer)?.map(|text| date_of(&text)).transpose()
}

impl ForecastQuestion {
    /// The forecast of the rail that will be ground, or else of what was measured, on a case that was read; `client` is told how far it is.
    ///
    /// # Errors
    /// [`AnswerError::Argument`] with the rule, [`AnswerError::Case`] with the file at fault.
    pub fn answer_on(&self, case: &Case, client: &dyn Client) -> Result<TrackForecast> {
        let (mut answer, dated) = self.dated_on(case, |limit| self.ground.read(limit, client), true, client)?;
        if let Some(dated) = &dated {
            answer.wear = self.wear(dated, case, &answer)?;
        }
        Ok(answer)
    }

    /// Forecast without a fit of the wear coefficient and without the effect of each spread; a rail may be ground to the limit itself.
    ///
    /// # Errors
    /// Errors of [`answer_on`](Self::answer_on).
    pub fn forecast_on(&self, case: &Case, client: &dyn Client) -> Result<TrackForecast> {
        Ok(self.dated_on(case, |limit| self.ground.at_most(limit, client), false, client)?.0)
    }

    /// The forecast with the records that it begins with.
    fn dated_on(
        &self,
        case: &Case,
        ground: impl FnOnce(&(LimitTable, LevelLimit)) -> Result<Option<GroundRail>>,
        tells_spreads: bool,
        client: &dyn Client,
    ) -> Result<(TrackForecast, Option<Dated>)> {
        let survey = self.spectra.read(client)?;
        let traffic = self.traffic()?;
        let limit = level_limit(&self.limit)?;
        let ground = ground(&limit)?;
        let dated = survey.as_ref().map(|survey| self.spectra.dated(survey, client)).transpose()?;
        let step = client.begin(say!(progress_traffic), traffic.file.vehicle.len());
        let request = ForecastRequest {
            traffic,
            survey: dated.as_ref().map(|dated| dated.now.clone()),
            ground,
            horizon: self.horizon(),
            limit,
            date: self.date.or(dated.as_ref().and_then(|dated| dated.date)),
            tells_spreads,
        };
        let answer = TrackForecast::new(case, request, &step);
        let answer = answer.map_err(|error| self.of_arguments(case, survey.as_deref(), error))?;
        Ok((answer, dated))
    }

    /// The fit of the wear coefficient to the latest of the spectrum and of the record before it, with the passages between them, or else
    /// those of so many days.
    ///
    /// # Errors
    /// [`AnswerError::Argument`] for days under a traffic of unknown amount, those of [`WearReport::new`].
    pub fn wear_on(&self, case: &Case, days: Option<f64>, client: &dyn Client) -> Result<WearReport> {
        let (_, limit) = level_limit(&self.limit)?;
        let on = self.traffic()?.on(case, &bands_of(case), &Variant::none(""), &|_| ())?;
        let passages = self.spectra.passages_between.or_else(|| on.passages_in(days?)).ok_or_else(|| {
            let days = days.map_or("left out".to_owned(), |days| days.to_string());
            let rule = "given with a traffic that says under [line] passages_per_day or mgt_per_year";
            AnswerError::argument("--days", days, rule)
        })?;
        let (earlier, places, now) = self.spectra.latest_of_both(passages, client)?;
        Ok(WearReport::since(&earlier, places.as_ref(), &now, (case, &on), Some(&limit), passages)?)
    }

    fn traffic(&self) -> Result<Traffic> {
        let traffic = self.traffic.as_ref().ok_or_else(|| left_out("--traffic", "given"))?;
        Ok(Arc::unwrap_or_clone(traffic.value(Traffic::read)?))
    }

    /// Answer for the case that is still to be read.
    ///
    /// # Errors
    /// Errors of [`answer_on`](Self::answer_on).
    pub(crate) fn told(&self, client: &dyn Client) -> Result<ForecastAnswer> {
        let case = self.case.read(client)?;
        let spectrum = self.spectra.spectrum.as_ref().map(|spectrum| spectrum.name().display().to_string());
        Ok(ForecastAnswer::new(&case, self.answer_on(&case, client)?, spectrum))
    }

    /// How far to look ahead: as asked for, or a year.
    fn horizon(&self) -> ForecastHorizon {
        match (self.passages, self.mgt) {
            (Some(passages), _) => ForecastHorizon::Passages(passages),
            (None, Some(mgt)) => ForecastHorizon::MillionGrossTonnes(mgt),
            (None, None) => ForecastHorizon::Months(self.months.unwrap_or(12.0)),
        }
    }

    /// What there is no forecast for, under the names of the arguments.
    fn of_arguments(&self, case: &Case, survey: Option<&Survey>, error: AnswerError) -> AnswerError {
        match error {
            AnswerError::NoSpectrum => left_out("--spectrum", "given, or else --ground or --from-limit"),
            AnswerError::NoPassagesPerDay => AnswerError::argument(
                "--months",
                self.months.map_or("left out".to_owned(), |months| months.to_string()),
                "replaced by --passages or --mgt, for the traffic file says under [line] neither \
                       passages_per_day nor mgt_per_year",
            ),
            error => self.ground.outside(survey, case, error),
        }
    }

    /// The wear coefficient of two dated measurements, where there is an earlier one.
    fn wear(&self, dated: &Dated, case: &Case, answer: &TrackForecast) -> Result<Option<WearReport>> {
        let between = self.spectra.passages_between;
        let Some(earlier) = &dated.earlier else {
            return match between {
                Some(_) => Err(AnswerError::argument(
                    "--passages-between",
                    "given",
                    "left out, for there is no earlier measurement; give --earlier, --earlier-where or \
                           --date-column",
                )),
                None => Ok(None),
            };
        };
        let by_date = || answer.on.passages_in(dated.days?);
        let is_asked = self.spectra.asks_for_fit();
        let Some(passages) = between.or_else(by_date) else {
            let rule =
                "given, or else --dates or --date-column, and a traffic file that says how much traffic there is";
            return if is_asked { Err(left_out("--passages-between", rule)) } else { Ok(None) };
        };
        let places = dated.places.as_ref();
        let fit = WearReport::since(earlier, places, &dated.now, (case, &answer.on), Some(&answer.limit), passages);
        match is_asked {
            true => Ok(Some(fit?)),
            false => Ok(fit.ok()),
        }
    }

    /// The forecast of the rail of a calibration.
    fn over_posterior(&self, folder: &Path) -> Result<PosteriorForecast> {
        let (plan, chains) = finished_of(&|path| self.case.is_just(path), folder)?;
        let months = self.months.unwrap_or(12.0);
        ForecastHorizon::Months(months).check()?;
        Ok(PosteriorForecast::new(&plan, &chains, &level_limit(&self.limit)?, months)?)
    }
}

fn left_out(argument: &'static str, rule: &str) -> AnswerError {
    AnswerError::argument(argument, "left out", rule)
}

impl Question for ForecastQuestion {
    const NAME: &'static str = "forecast";
    const EXAMPLE: &'static str = "\
        Example: riffel forecast case.toml --spectrum spectra.csv --traffic traffic.toml --months 24\n\n\
        The interval of a rail that will be ground: riffel forecast case.toml --traffic traffic.toml --from-limit \"-6 dB\"";
    const RULES: &'static [Rule] = &[
        Rule::Needs(&["where", "date_column", "earlier"], &["spectrum"]),
        Rule::Needs(RecordLayout::KEYS, &["spectrum"]),
        EarlierRecords::RULE,
        Rule::Needs(&["earlier_where", "passages_between"], &["spectrum"]),
        Rule::OneOf(&["ground", "from_limit"]),
        Rule::OneOf(&["passages", "mgt", "months"]),
        Rule::AnyOf(&["traffic", "posterior"]),
        Rule::Excludes(
            "posterior",
            &[
                "traffic",
                "spectrum",
                "ground",
                "from_limit",
                "passages",
                "mgt",
                "date",
                "earlier",
                "dates",
                "date_column",
                "where",
                "earlier_where",
                "passages_between",
            ],
        ),
    ];

    fn ask(&self, client: &dyn Client) -> Result<Box<dyn Answer>> {
        Ok(match &self.posterior {
            Some(folder) => Box::new(self.over_posterior(folder)?),
            None => Box::new(self.told(client)?),
        })
    }
}
