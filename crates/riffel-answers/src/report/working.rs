//! The answers that a report is made of.

use std::path::Path;
use std::sync::Arc;

use riffel_calibrate::{Chains, Plan};
use riffel_case::traffic::Traffic;
use riffel_case::{Case, ask};
use riffel_keys::quantity::Quantity;
use riffel_keys::text_file::is_standard_input;
use riffel_keys::{CaseError, Message, question, say};
use riffel_rail::{Limit, LimitTable};

use super::measured::{Measured, Now};
use super::{Inputs, MeasuredRail, ReportQuestion, ReportRequest, Site, report};
use crate::compare::{CompareAnswer, CompareQuestion};
use crate::forecast::{ForecastQuestion, MeasuredSpectra, PosteriorForecast, TrackForecast, WearReport};
use crate::map::{MapAnswer, growth_over};
use crate::noise::{NoiseAnswer, NoiseQuestion};
use crate::question::{CaseSource, Client, PosteriorSource, finished_of, over};
use crate::{AnswerError, LineGrowth, PosteriorDraws, Result, fingerprint, level_limit};

/// Months for which the level of a train is told ahead where no other time is asked for.
const MONTHS_OF_NOISE: f64 = 12.0;

/// A section, or why it is left out.
type Section<T> = Result<T, Message>;

/// A question of a report with what all its answers go by.
pub(super) struct Working<'a> {
    pub(super) question: &'a ReportQuestion,
    pub(super) client: &'a dyn Client,
    pub(super) limits: Vec<LimitTable>,
    /// The limit of levels that forecast and what-if go by: the one asked for, or the first of all.
    pub(super) level_limit: Option<String>,
}

/// A case with the overrides that it was read with.
struct CaseWithOverrides {
    source: CaseSource,
    case: Arc<Case>,
}

impl<'a> Working<'a> {
    pub(super) fn new(question: &'a ReportQuestion, client: &'a dyn Client) -> Result<Self> {
        let limits = LimitTable::named(&question.limit)?;
        let is_of_levels = |table: &LimitTable| matches!(table.limit, Limit::Levels(_));
        let first = limits.iter().position(is_of_levels);
        // Tables that are named stand in the order of their names.
        let level_limit = first.map(|place| question.limit.get(place).unwrap_or(&limits[place].name).clone());
        match question.needs_levels().filter(|_| level_limit.is_none()) {
            Some(option) => Err(question.without_levels(option)),
            None => Ok(Self { question, client, limits, level_limit }),
        }
    }

    /// The page.
    pub(super) fn page(&self) -> Result<String> {
        let (question, client) = (self.question, self.client);
        let site = question.site.as_ref().map(|site| site.value(Site::read)).transpose()?.unwrap_or_default();
        let mut given = self.given(question.set.clone())?;
        let rail = self.measured(given.as_ref().map(|given| &*given.case))?;
        let mut now = rail.as_ref().and_then(|rail| self.now(rail));
        let before = self.before(rail.as_ref(), now.as_mut())?;
        let mut wear = None;
        if let (Some(given), Some(now), Some(before), Some(traffic)) = (&given, &now, &before, &question.rail.traffic) {
            wear = Some(self.fit(&given.case, &*traffic.value(Traffic::read)?, before, now)?);
        }
        // The case goes by the coefficient of this rail from here on, unless it is to keep its own.
        let fitted = wear.as_ref().and_then(|wear| wear.as_ref().ok()).filter(|_| !question.keep_coefficient);
        let (coefficient, spread) =
            (fitted.and_then(WearReport::fitted_coefficient), fitted.and_then(WearReport::spread));
        if let Some(coefficient) = coefficient {
            // To the four digits that a forecast tells.
            let set = question.set.iter().cloned().chain([format!("wear.coefficient={coefficient:.3e}")]);
            given = self.given(set.collect())?;
        }
        let posterior = given.as_ref().zip(question.posterior.as_deref());
        let posterior = posterior.map(|(given, folder)| finished_of(&|path| given.source.is_just(path), folder));
        let posterior = posterior.transpose()?;
        let draws = posterior.as_ref().map(|(plan, chains)| PosteriorDraws::new(plan, chains)).transpose()?;
        let case = given.as_ref().map(|given| &*given.case);
        let map = case.map(|case| self.growth_map(case, draws.as_ref())).transpose()?;
        let posterior_forecast = match &posterior {
            Some((plan, chains)) if plan.has_levels() => Some(self.forecast_over(plan, chains)?),
            _ => None,
        };
        let no_roughness = || say!(no_roughness_given);
        let (mut forecast, mut compare) = (Err(no_roughness()), Err(no_roughness()));
        let mut noise = Err(no_roughness());
        if let Some(given) = &given {
            if let Some(now) = &now {
                forecast = self.outlook(given, now, wear)?;
                noise = self.noise_section(given, now, draws.as_ref())?;
            }
            compare = self.what_if(given, now.as_ref())?;
            if let Ok(forecast) = &mut forecast {
                forecast.wear_spread = spread.or(forecast.wear_spread);
            }
            if let Ok(compare) = &mut compare {
                compare.wear_spread = spread.or(compare.wear_spread);
            }
        }
        let inputs = self.inputs(given.as_ref(), rail.as_ref())?;
        let (rail, of_rail) = rail.map(Measured::apart).unzip();
        let (warnings, diagnosis) = of_rail.unwrap_or_default();
        report(ReportRequest {
            language: client.language(),
            title: question.title.as_deref(),
            site: &site,
            limits: &self.limits,
            rail: rail.zip(question.roughness.as_ref()).map(|(roughness, file)| MeasuredRail {
                path: file.name(),
                roughness,
                warnings: &warnings,
                diagnosis: diagnosis.as_ref(),
            }),
            case: case.zip(map.as_ref()),
            forecast: forecast.as_ref().map_err(Message::clone),
            posterior_forecast: posterior_forecast.as_ref(),
            compare: compare.as_ref().map_err(Message::clone),
            noise: noise.as_ref().map_err(Message::clone),
            inputs: &inputs,
        })
    }

    /// The case with some overrides, if there is one.
    fn given(&self, set: Vec<String>) -> Result<Option<CaseWithOverrides>> {
        let Some(case) = &self.question.case else {
            return Ok(None);
        };
        let source = CaseSource::new(case.clone(), set);
        Ok(Some(CaseWithOverrides { case: source.read(self.client)?, source }))
    }

    /// The growth map of a case.
    fn growth_map(&self, case: &Case, draws: Option<&PosteriorDraws>) -> Result<MapAnswer> {
        case.check_window()?;
        let traffic = self.question.rail.traffic.as_ref().map(|traffic| traffic.value(Traffic::read)).transpose()?;
        let step = self.client.begin(say!(progress_growth_map), case.speed.points());
        let mut map = MapAnswer::new(case, &step);
        drop(step);
        map.over_posterior = over(draws, self.client, growth_over)?;
        if draws.is_none() {
            map.under_traffic = Some(LineGrowth::new(case, traffic.as_deref())?);
        }
        Ok(map)
    }

    /// What becomes of the rail over the draws of a calibration.
    fn forecast_over(&self, plan: &Plan, chains: &Chains) -> Result<PosteriorForecast> {
        let limit = self.level_limit.as_ref().ok_or_else(|| self.question.without_levels("--posterior"))?;
        let months = self.question.months.unwrap_or(MONTHS_OF_NOISE);
        Ok(PosteriorForecast::new(plan, chains, &level_limit(limit)?, months)?)
    }

    /// The limit of levels, or why what needs one is left out.
    fn limit_of_levels(&self) -> Section<&str> {
        self.level_limit.as_deref().ok_or_else(|| say!(needs_a_limit_of_levels))
    }

    /// What becomes of the rail; `wear` is the fit that the case goes by, or why there is none.
    fn outlook(
        &self,
        given: &CaseWithOverrides,
        now: &Now,
        wear: Option<Section<WearReport>>,
    ) -> Result<Section<TrackForecast>> {
        let limit = match self.limit_of_levels() {
            Ok(limit) => limit.to_owned(),
            Err(why) => return Ok(Err(why)),
        };
        if self.question.rail.traffic.is_none() {
            return Ok(Err(say!(no_traffic_given)));
        }
        let asked = ForecastQuestion {
            case: given.source.clone(),
            spectra: MeasuredSpectra { spectrum: Some(now.survey.clone().into()), ..MeasuredSpectra::default() },
            ground: self.question.ground.clone(),
            traffic: self.question.rail.traffic.clone(),
            posterior: None,
            limit,
            passages: None,
            mgt: None,
            months: self.question.months,
            date: now.date,
        };
        let mut answer = asked.answer_on(&given.case, self.client)?;
        match wear {
            Some(Ok(fit)) => answer.wear = Some(fit),
            Some(Err(why)) => answer.warnings.push(why),
            None => (),
        }
        Ok(Ok(answer))
    }

    /// What a coach sounds like on the rail at the mean speed of the traffic.
    fn noise_section(
        &self,
        given: &CaseWithOverrides,
        now: &Now,
        draws: Option<&PosteriorDraws>,
    ) -> Result<Section<NoiseAnswer>> {
        let limit = match self.limit_of_levels() {
            Ok(limit) => limit,
            Err(why) => return Ok(Err(why)),
        };
        let question = NoiseQuestion {
            traffic: self.question.rail.traffic.clone(),
            months: self.question.months.unwrap_or(MONTHS_OF_NOISE),
            limit_dba: self.question.limit_dba,
            wheel_roughness: self.question.wheel_roughness.clone(),
            wheel_modes: self.question.wheel_modes.clone(),
            ..NoiseQuestion::of_a_coach(given.case.clone(), now.survey.clone(), now.speed, limit)?
        };
        let asked = self.question.of_noise();
        if let (Some((option, value)), Some(why)) = (&asked, ask::without_decay(&given.case)) {
            return Err(AnswerError::argument(option, value, format!("left out: {why}")));
        }
        match question.answer_over(draws, self.client) {
            Err(error) if asked.is_some() => Err(error),
            // A case whose track does not radiate, and bands that do not meet, leave the rest of the report as it is.
            answer => Ok(answer.map_err(|error| error.message())),
        }
    }

    /// What would help, with what is measured now if anything is.
    fn what_if(&self, given: &CaseWithOverrides, now: Option<&Now>) -> Result<Section<CompareAnswer>> {
        let limit = match self.limit_of_levels() {
            Ok(limit) => limit,
            Err(why) => return Ok(Err(why)),
        };
        if self.question.variants.is_empty() {
            return Ok(Err(say!(no_variant_given)));
        }
        let traffic = self.question.rail.traffic.clone();
        let mut question = CompareQuestion::of_variants(given.source.clone(), limit)?;
        question.variants = self.question.variants.clone();
        question.speed = now.filter(|_| traffic.is_none()).map(|now| Quantity::new(now.speed).into());
        question.traffic = traffic;
        question.posterior = PosteriorSource { posterior: self.question.posterior.clone() };
        question.hold = self.question.hold;
        question.spectrum = now.map(|now| now.survey.clone().into());
        question.ground = self.question.ground.clone();
        Ok(Ok(question.answer_on(&given.case, self.client)?))
    }

    /// The files that the report is made of, with their fingerprints.
    fn inputs(&self, given: Option<&CaseWithOverrides>, rail: Option<&Measured>) -> Result<Inputs> {
        let mut inputs = Inputs::default();
        let (question, asked) = (self.question, &self.question.rail);
        let mut add = |role: Message, path: &Path, origin: Message| {
            let hash = match is_standard_input(path) || question::is_value(path) {
                true => say!(standard_input),
                false => Message::verbatim(
                    fingerprint(path)
                        .map_err(|reason| CaseError::data(path, format!("cannot read the file: {reason}")))?,
                ),
            };
            inputs.add(role, question::key_of(path).unwrap_or(path), origin, hash);
            Ok::<_, AnswerError>(())
        };
        if let (Some(file), Some(rail)) = (&question.roughness, rail) {
            add(say!(input_roughness), file.name(), rail.understood.clone())?;
            for earlier in &asked.earlier.earlier {
                add(say!(input_earlier_record), earlier.name(), say!(input_of_the_same_rail))?;
            }
        }
        if let Some(CaseWithOverrides { source, case }) = given {
            let title = case.file.title.as_deref().map_or_else(|| say!(a_case), Message::verbatim);
            let words = match source.overrides() {
                [] => title,
                overrides => say!(input_with, title, values = overrides.join(", ")),
            };
            add(say!(input_case), source.name(), words)?;
            if let Some(file) = source.measurement(case) {
                add(say!(input_track_receptance), &file, say!(measured_word))?;
            }
        }
        if let Some(traffic) = &asked.traffic {
            add(say!(input_traffic), traffic.name(), say!(input_vehicles))?;
        }
        for variant in &question.variants {
            add(say!(variant_head), variant.name(), say!(input_changes))?;
        }
        if let Some(format) = &asked.layout.format {
            add(say!(input_reader_profile), format.name(), say!(input_layout))?;
        }
        for name in question.limit.iter().filter(|name| name.ends_with(".toml")) {
            add(say!(input_limit_table), name.as_ref(), say!(input_of_your_own))?;
        }
        if let Some(site) = &question.site {
            add(say!(input_site), site.name(), say!(input_words_at_the_top))?;
        }
        Ok(inputs)
    }
}
