//! What would help: a case and its variants under one traffic.

mod comparison;
mod documents;
mod figure;
mod over_posterior;
mod question;
mod tables;

use riffel::forecast::WearSpread;
use riffel::roughness::LevelLimit;
use riffel_case::traffic::{Traffic, bands_of};
use riffel_case::{Case, Hold, Variant};
use riffel_keys::{Language, Message, fixed, say};
use riffel_plot::LineFigure;
use riffel_rail::{GroundRail, LimitTable, Survey, rail_in_words};
use serde::{Serialize, Serializer};

pub use comparison::{Comparison, Effect, FastestLine, Outcome};
pub use over_posterior::compare_over;
pub use question::CompareQuestion;
pub(crate) use tables::outcomes;

use crate::answer::inputs;
use crate::forecast::{RailForecast, RailStart, not_forecast};
use crate::roughness::{Level, levels};
use crate::{Answer, AnswerError, OverPosterior, Result, Table, unlikely_wear, wear_spread};

/// What is asked of variants.
#[derive(Clone)]
pub struct CompareRequest {
    /// The variants, each with what it holds.
    pub variants: Vec<Variant>,
    /// The traffic.
    pub traffic: Traffic,
    /// Its speeds, or its title, in words.
    pub speeds: Message,
    /// What was asked to be held.
    pub hold: Option<Hold>,
    /// The records of what was measured, if anything was.
    pub survey: Option<Survey>,
    /// What the rail will be ground to, in place of what was measured.
    pub ground: Option<GroundRail>,
    /// The limit of levels, with the table it is from.
    pub limit: (LimitTable, LevelLimit),
    /// Comparison over the draws of a calibration, if one was given.
    pub over_posterior: Option<OverPosterior>,
}

/// A case and its variants under one traffic.
#[derive(Serialize)]
pub struct CompareAnswer {
    riffel_version: &'static str,
    /// Case without any variant.
    #[serde(serialize_with = "inputs")]
    case: Case,
    /// Speeds of the traffic, or its title, in words.
    pub speeds: Message,
    /// Of the rail that leads in the case as it is.
    spectrum_now: Option<Vec<Level>>,
    /// What the rail will be ground to, if that is where the spectrum comes from and the months to the limit begin.
    #[serde(serialize_with = "in_words")]
    pub ground: Option<GroundRail>,
    /// Its edition, where there is a rail.
    #[serde(rename = "limit")]
    edition: Option<String>,
    /// Where the model does not explain how the rail that leads grew, or is of the other one: how it grew, and what follows; else empty.
    pub(crate) unexplained: Vec<Message>,
    /// The outcomes, the case as it is first.
    #[serde(flatten)]
    pub comparison: Comparison,
    /// Comparison over the draws of a calibration, if one was given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub over_posterior: Option<OverPosterior>,
    /// How well the wear coefficient is known that growth goes by; `None` if other damage has a part.
    #[serde(skip)]
    pub wear_spread: Option<WearSpread>,
    /// What was asked to be held.
    #[serde(skip)]
    hold: Option<Hold>,
    /// That no rail is known to wear as the case as it is does.
    #[serde(skip)]
    unlikely_wear: Option<Message>,
    /// Why the records do not tell how the rails grow, where they might.
    #[serde(skip)]
    without_growth: Option<Message>,
    /// What is to be said of the records.
    #[serde(skip)]
    pub warnings: Vec<Message>,
    /// The table of the limit.
    #[serde(skip)]
    pub table: LimitTable,
    /// The limit.
    #[serde(skip)]
    pub limit: LevelLimit,
    #[serde(skip)]
    remarks: Vec<Message>,
}

fn in_words<S: Serializer>(ground: &Option<GroundRail>, serializer: S) -> Result<S::Ok, S::Error> {
    ground.as_ref().map(|ground| &ground.words).serialize(serializer)
}

impl CompareAnswer {
    /// The comparison; `progress` is told of each vehicle of the case and of every variant.
    ///
    /// # Errors
    /// [`AnswerError::Case`] with the key at fault, [`AnswerError::OutsideWindow`] where no rail has a band in the
    /// window of the case.
    pub fn new(case: &Case, request: CompareRequest, progress: &(dyn Fn(usize) + Sync)) -> Result<Self> {
        let CompareRequest { variants, traffic, speeds, hold, survey, ground, limit: (table, limit), over_posterior } =
            request;
        let mut warnings = Vec::new();
        let survey = survey.map(|survey| survey.latest().0);
        let of_survey = survey.iter().filter(|_| ground.is_none());
        warnings.extend(of_survey.flat_map(|survey| survey.warnings.clone()));
        let of_case = case.rail_in_curve();
        let starts = |per_day| RailStart::of(&of_case, survey.as_ref(), ground.as_ref(), per_day);
        let rails = starts(None);
        if !rails.is_empty() {
            let bands = bands_of(case);
            let known = |rail: &RailStart| {
                let mut bands = bands.iter();
                bands.any(|band| rail.levels.spectrum.level(*band).is_some())
            };
            if !rails.iter().any(known) {
                return Err(AnswerError::OutsideWindow(riffel::Error::Measurement {
                    index: 0,
                    rule: "no band of the spectrum lies there",
                }));
            }
        }
        let comparison = Comparison::compute(case, &variants, &traffic, &starts, Some(&limit), progress)?;
        let per_day = comparison.base().passages_per_day;
        let without_growth = survey
            .as_ref()
            .and_then(|survey| RailStart::without_growth(&starts(per_day), survey, ground.is_some(), per_day));
        let leading = comparison.base().leading();
        warnings.extend(not_forecast(&rails, &comparison.base().rails, case));
        let unexplained = leading.map_or_else(Vec::new, |rail| rail.unexplained(&comparison.model, per_day));
        let mut answer = Self {
            riffel_version: env!("CARGO_PKG_VERSION"),
            case: case.clone(),
            spectrum_now: leading.map(|rail| levels(&rail.start.levels.spectrum)),
            edition: leading.map(|_| table.edition.clone()),
            unexplained,
            wear_spread: wear_spread(case),
            without_growth,
            unlikely_wear: unlikely_wear(case, comparison.base().growth.mean_wear()),
            hold,
            speeds,
            comparison,
            ground,
            warnings,
            table,
            limit,
            over_posterior,
            remarks: Vec::new(),
        };
        let of_case = answer.comparison.base().remarks.clone();
        answer.remarks = answer.warnings.iter().cloned().chain(answer.effects()).chain(of_case).collect();
        Ok(answer)
    }

    /// What the draws of a calibration say of each variant; nothing without one.
    pub fn over_posterior_in_words(&self) -> Vec<Message> {
        let over = self.over_posterior.iter();
        over.flat_map(|over| over_posterior::in_words(self, over)).collect()
    }

    /// The figure of the comparison.
    pub(crate) fn figure_in(&self, language: Language) -> LineFigure {
        figure::figure(self, &self.case, language)
    }

    /// What the reader should know of variants: that a part or all has no effect, that less friction means less
    /// traction, and how well rates are known.
    pub fn effects(&self) -> Vec<Message> {
        let spread = self.wear_spread.filter(|_| self.over_posterior.is_none());
        // Rates and times of a rail that goes by its own growth hold no coefficient.
        let is_measured = |rail: &RailForecast| rail.start.growth.is_some();
        let spread = spread.filter(|_| !self.leading().is_some_and(is_measured));
        let known_to = spread.map(|spread| {
            let [_, either_way] = spread.band_80(1.0);
            say!(rates_hold_to, factor = fixed(either_way, 1))
        });
        let middle = (self.case.wavelength.min() * self.case.wavelength.max()).sqrt();
        let outcomes = self.comparison.outcomes.iter();
        let at_edge = outcomes.clone().filter_map(|outcome| {
            let FastestLine { wavelength, .. } = outcome.fastest;
            let is_told = outcome.fastest.at_edge && outcome.leading().is_some();
            is_told.then(|| {
                say!(
                    growth_is_cut_off,
                    title = &outcome.title,
                    wavelength = fixed(1e3 * wavelength, 0),
                    beyond = match wavelength < middle {
                        true => say!(shorter_waves),
                        false => say!(longer_waves),
                    }
                )
            })
        });
        let outcomes = outcomes
            .flat_map(|outcome| {
                let kept = (self.hold.is_none() && outcome.held.contains(&Hold::Ratio))
                    .then(|| say!(keeps_tractive_ratio, title = &outcome.title));
                outcome.effect.sentence().cloned().into_iter().chain(kept)
            })
            .chain(at_edge)
            .chain(known_to);
        outcomes.collect()
    }

    /// What growth goes by: how the rail that leads grew, or else that its dates do not tell it, a mean wear that no rail has, and why no
    /// months follow.
    pub fn first_said(&self) -> Vec<Message> {
        let measured = self.measured_first();
        if !measured.is_empty() {
            return measured;
        }
        let without_time = &self.comparison.base().without_time;
        let by_model = [&self.without_growth, &self.unlikely_wear, without_time];
        by_model.into_iter().flatten().cloned().collect()
    }

    /// How the rail that leads grew, which its forecast goes by, and whether the model explains it; else empty.
    fn measured_first(&self) -> Vec<Message> {
        if !self.unexplained.is_empty() {
            return self.unexplained.clone();
        }
        let per_day = self.comparison.base().passages_per_day;
        let own = |rail: &RailForecast| rail.own_growth(&self.comparison.model, per_day);
        self.leading().and_then(own).into_iter().collect()
    }

    /// The rail that leads in the case as it is; `None` if no spectrum was given.
    pub fn leading(&self) -> Option<&RailForecast> {
        self.comparison.base().leading()
    }

    /// Whether there are several rails, of which each outcome names the one that leads.
    pub fn names_rails(&self) -> bool {
        self.comparison.base().rails.len() > 1
    }

    /// What a rail is called in sentences on it, where there are several.
    pub fn rail(&self, rail: &RailForecast) -> Option<Message> {
        let name = rail.name().filter(|_| self.names_rails())?;
        Some(rail_in_words(name))
    }
}

impl Answer for CompareAnswer {
    fn name(&self) -> &'static str {
        "compare"
    }

    fn introduction(&self) -> Vec<Message> {
        let title = self.case.file.title.clone();
        let title = title.map_or_else(|| say!(comparison_of_variants), Message::verbatim);
        let ground = self.ground.iter();
        let ground = ground
            .map(|ground| say!(from_ground_to_limit, ground = ground.words.clone(), edition = &self.table.edition));
        [say!(under_title, title, passing = self.speeds.clone())]
            .into_iter()
            .chain(ground)
            .chain(self.first_said())
            .collect()
    }

    fn tables(&self) -> Vec<Table> {
        let over = self.over_posterior.iter().map(OverPosterior::table);
        let own = [tables::outcomes(self), tables::shown_bands(self), tables::bands(self), tables::lines(self)];
        own.into_iter().chain(over).collect()
    }

    fn above(&self, table: &str) -> Vec<Message> {
        let of_bands = table == tables::BANDS;
        let leads = (of_bands && self.names_rails()).then(|| say!(limit_is_of_the_rail_that_leads));
        leads.into_iter().chain(of_bands.then(|| say!(growth_of_the_bands))).collect()
    }

    fn sentences(&self) -> Vec<Message> {
        self.over_posterior_in_words()
    }

    fn figure(&self) -> LineFigure {
        self.figure_in(Language::English)
    }

    fn remarks(&self) -> &[Message] {
        &self.remarks
    }
}

/// What is held where a variant changes friction or load.
pub(crate) fn held_in_words(hold: Hold) -> Message {
    match hold {
        Hold::Force => say!(held_force),
        Hold::Ratio => say!(held_ratio),
        Hold::Creepage => say!(held_creepage),
    }
}

/// What a variant is called; the case as it is in each language.
pub(crate) fn title_of(outcome: &Outcome) -> Message {
    match outcome.effect {
        Effect::None => say!(as_it_is),
        _ => Message::verbatim(&outcome.title),
    }
}
