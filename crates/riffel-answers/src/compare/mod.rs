//! What would help: a case and its variants under one traffic.

mod comparison;
mod document;
mod figure;
mod over_posterior;

use std::io::{self, Write};

use riffel::forecast::WearSpread;
use riffel::roughness::LevelLimit;
use riffel_case::traffic::{Traffic, bands_of};
use riffel_case::{Case, Hold, Variant};
use riffel_keys::{Language, Message, fixed, say};
use riffel_plot::LineFigure;
use riffel_rail::{GroundRail, LimitTable, Survey, name_in_words, rail_in_words};

pub use comparison::{Comparison, Effect, FastestLine, Outcome};
pub use document::CompareDocument;
pub use over_posterior::compare_over;

use crate::forecast::{RailForecast, RailStart, not_forecast, number_alone, per_million, reached, three_digits};
use crate::{AnswerError, OverPosterior, unlikely_wear, wear_spread};

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
}

/// A case and its variants under one traffic.
pub struct CompareAnswer {
    /// What was asked to be held.
    hold: Option<Hold>,
    /// How well the wear coefficient is known that growth goes by; none where other damage has a part.
    pub wear_spread: Option<WearSpread>,
    /// That no rail is known to wear as the case as it is does.
    unlikely_wear: Option<Message>,
    /// Why the records do not tell how the rails grow, where they might.
    without_growth: Option<Message>,
    /// Speeds of the traffic, or its title, in words.
    pub speeds: Message,
    /// The outcomes.
    pub comparison: Comparison,
    /// What the rail will be ground to, if that is where the spectrum comes from.
    pub ground: Option<GroundRail>,
    /// What is to be said of the records.
    pub warnings: Vec<Message>,
    /// The table of the limit.
    pub table: LimitTable,
    /// The limit.
    pub limit: LevelLimit,
    /// The same over the draws of a calibration, where one was given.
    pub over_posterior: Option<OverPosterior>,
    /// Middle of the window of wavelengths, in their ln \[m\].
    middle: f64,
}

impl CompareAnswer {
    /// The comparison; `progress` is told of each vehicle of the case and of every variant.
    ///
    /// # Errors
    /// [`AnswerError::Case`] with the key at fault, [`AnswerError::OutsideWindow`] where no rail has a band in the
    /// window of the case.
    pub fn new(case: &Case, request: CompareRequest, progress: &(dyn Fn(usize) + Sync)) -> Result<Self, AnswerError> {
        let CompareRequest { variants, traffic, speeds, hold, survey, ground, limit: (table, limit) } = request;
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
        warnings.extend(not_forecast(&rails, &comparison.base().rails, case));
        Ok(Self {
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
            over_posterior: None,
            middle: (case.wavelength.min() * case.wavelength.max()).sqrt(),
        })
    }

    /// What the draws of a calibration say of each variant; nothing without one.
    pub fn over_posterior_in_words(&self) -> Vec<Message> {
        let over = self.over_posterior.iter();
        over.flat_map(|over| over_posterior::in_words(self, over)).collect()
    }

    /// The figure of the comparison.
    pub fn figure(&self, case: &Case, language: Language) -> LineFigure {
        figure::figure(self, case, language)
    }

    /// The comparison as data: what `riffel compare --json` prints.
    pub fn document<'a>(&'a self, case: &'a Case) -> CompareDocument<'a> {
        document::document(self, case)
    }

    /// One row for each band, a column for each outcome.
    ///
    /// # Errors
    /// Those of the file.
    pub fn bands_csv(&self, file: &mut impl Write) -> io::Result<()> {
        document::band_table(self, file)
    }

    /// One row for each line, a column for each outcome.
    ///
    /// # Errors
    /// Those of the file.
    pub fn growth_csv(&self, file: &mut impl Write) -> io::Result<()> {
        document::line_table(self, file)
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
        let outcomes = self.comparison.outcomes.iter();
        let at_edge = outcomes.clone().filter_map(|outcome| {
            let FastestLine { wavelength, .. } = outcome.fastest;
            let is_told = outcome.fastest.at_edge && outcome.leading().is_some();
            is_told.then(|| {
                say!(
                    growth_is_cut_off,
                    title = &outcome.title,
                    wavelength = fixed(1e3 * wavelength, 0),
                    beyond = match wavelength < self.middle {
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

    /// Where the model does not explain how the rail that leads grew, or is of the other one: how it grew, and what follows; else empty.
    pub(crate) fn unexplained(&self) -> Vec<Message> {
        let per_day = self.comparison.base().passages_per_day;
        let rail = self.leading();
        rail.map_or_else(Vec::new, |rail| rail.unexplained(&self.comparison.model, per_day))
    }

    /// How the rail that leads grew, which its forecast goes by, and whether the model explains it; else empty.
    fn measured_first(&self) -> Vec<Message> {
        let unexplained = self.unexplained();
        if !unexplained.is_empty() {
            return unexplained;
        }
        let per_day = self.comparison.base().passages_per_day;
        let own = |rail: &RailForecast| rail.own_growth(&self.comparison.model, per_day);
        self.leading().and_then(own).into_iter().collect()
    }

    /// Heads of the table without that of the titles: those of what is known of some outcome.
    pub fn header(&self) -> Vec<Message> {
        let mut header = vec![say!(fastest_in_millimetres), say!(decibels_per_million_passages), say!(change_head)];
        if self.holds() {
            header.push(say!(held_head));
        }
        header.push(say!(ridge_in_hertz));
        if self.names_rails() {
            header.push(say!(rail_word));
        }
        if self.leading().is_some() {
            header.extend([say!(passages_to_limit_head), say!(tonnes_to_limit_head)]);
        }
        if self.counts_months() {
            header.push(say!(months_to_limit_head));
        }
        header
    }

    /// The cells of an outcome under the [`header`](Self::header).
    pub fn row(&self, outcome: &Outcome) -> Vec<Message> {
        if outcome.untold {
            let mut row = vec![Message::verbatim(""); self.header().len()];
            row[2] = say!(cannot_be_told);
            return row;
        }
        let FastestLine { wavelength, rate, at_edge } = outcome.fastest;
        let nothing = || Message::verbatim("");
        let change = outcome.change_from(self.comparison.base());
        let wavelength = number_alone(format_args!("{:.1}", 1e3 * wavelength));
        let mut row = vec![
            match at_edge {
                true => say!(at_edge_of_lines, wavelength = wavelength),
                false => wavelength,
            },
            number_alone(format_args!("{:+.3}", per_million(rate))),
            match &outcome.effect {
                Effect::CannotAct(_) => say!(cannot_act),
                Effect::ChangesNothing(_) => say!(changes_nothing),
                _ => change.map_or_else(nothing, |change| number_alone(format_args!("{:+.0} %", 100.0 * change))),
            },
        ];
        if self.holds() {
            row.push(match outcome.held[..] {
                [] => nothing(),
                [hold] => held_in_words(hold),
                _ => say!(held_mixed),
            });
        }
        let ridge = outcome.ridge_frequency;
        row.push(ridge.map_or_else(nothing, |f| number_alone(format_args!("{f:.0}"))));
        if self.names_rails() {
            let rail = outcome.leading().and_then(RailForecast::name);
            row.push(name_in_words(rail.unwrap_or_default()));
        }
        if let Some(reach) = outcome.reach() {
            let mgt = reach.passages().map(|passages| outcome.growth.mgt(passages));
            row.push(reached(reach));
            row.push(mgt.map_or_else(nothing, |mgt| number_alone(three_digits(mgt))));
        }
        if self.counts_months() {
            let months = outcome.months_to_limit();
            row.push(months.map_or_else(nothing, |months| number_alone(three_digits(months))));
        }
        row
    }

    /// The rail that leads in the case as it is; none where no spectrum was given.
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

    /// Whether some variant holds a part of the mean state.
    fn holds(&self) -> bool {
        let mut outcomes = self.comparison.outcomes.iter();
        outcomes.any(|outcome| !outcome.held.is_empty())
    }

    /// Whether months to the limit are known.
    fn counts_months(&self) -> bool {
        self.leading().is_some() && self.comparison.base().passages_per_day.is_some()
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
