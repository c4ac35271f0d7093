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
use riffel_keys::{Message, fixed, say};
use riffel_plot::LineFigure;
use riffel_rail::{GroundRail, LimitTable, RailSpectrum, Survey};

pub use comparison::{Comparison, Effect, FastestLine, Outcome};
pub use document::CompareDocument;
pub use over_posterior::compare_over;

use crate::forecast::{RailForecast, not_forecast, number, per_million, reached};
use crate::roughness::rail_in_words;
use crate::{AnswerError, OverPosterior, wear_spread};

/// What is asked of variants.
#[derive(Clone)]
pub struct CompareRequest {
    /// The variants, each with what it holds.
    pub variants: Vec<Variant>,
    /// The traffic.
    pub traffic: Traffic,
    /// Its speeds, or its title, in words.
    pub speeds: String,
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
    wear_spread: Option<WearSpread>,
    /// Speeds of the traffic, or its title, in words.
    pub speeds: String,
    /// The outcomes.
    pub comparison: Comparison,
    /// What the rail will be ground to, if that is where the spectrum comes from.
    pub ground: Option<GroundRail>,
    /// What is to be said of the records.
    pub warnings: Vec<String>,
    /// The table of the limit.
    pub table: LimitTable,
    /// The limit.
    pub limit: LevelLimit,
    /// The same over the draws of a calibration, where one was given.
    pub over_posterior: Option<OverPosterior>,
}

impl CompareAnswer {
    /// The comparison; `progress` is told of each vehicle of the case and of every variant.
    ///
    /// # Errors
    /// [`AnswerError::Case`] with the key at fault, [`AnswerError::OutsideWindow`] where no rail has a band in the
    /// window of the case.
    pub fn new(
        case: &Case,
        request: CompareRequest,
        progress: &(dyn Fn(usize) + Sync),
    ) -> Result<Self, AnswerError> {
        let CompareRequest {
            variants,
            traffic,
            speeds,
            hold,
            survey,
            ground,
            limit: (table, limit),
        } = request;
        let mut warnings = Vec::new();
        let rails: Vec<RailSpectrum> = match (&ground, survey) {
            (Some(ground), _) => vec![ground.spectrum.clone().into()],
            (None, Some(survey)) => {
                let (survey, _) = survey.latest();
                warnings.extend(survey.warnings.iter().cloned());
                survey.rail_means()
            }
            (None, None) => Vec::new(),
        };
        if !rails.is_empty() {
            let bands = bands_of(case);
            let known = |rail: &RailSpectrum| {
                let mut bands = bands.iter();
                bands.any(|band| rail.spectrum.level(*band).is_some())
            };
            if !rails.iter().any(known) {
                return Err(AnswerError::OutsideWindow(riffel::Error::Measurement {
                    index: 0,
                    rule: "no band of the spectrum lies there",
                }));
            }
        }
        let comparison =
            Comparison::compute(case, &variants, &traffic, &rails, Some(&limit), progress)?;
        warnings.extend(not_forecast(&rails, &comparison.base().rails, case));
        Ok(Self {
            wear_spread: wear_spread(case),
            hold,
            speeds,
            comparison,
            ground,
            warnings,
            table,
            limit,
            over_posterior: None,
        })
    }

    /// What the draws of a calibration say of each variant; nothing without one.
    pub fn over_posterior_in_words(&self) -> Vec<Message> {
        let over = self.over_posterior.iter();
        over.flat_map(|over| over_posterior::in_words(self, over))
            .collect()
    }

    /// The figure of the comparison.
    pub fn figure(&self, case: &Case) -> LineFigure {
        figure::figure(self, case)
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
    pub fn effects(&self) -> Vec<String> {
        let spread = self.wear_spread.filter(|_| self.over_posterior.is_none());
        let known_to = spread.map(|spread| {
            let [_, either_way] = spread.band_80(1.0);
            say!(rates_hold_to, factor = fixed(either_way, 1))
        });
        let outcomes = self.comparison.outcomes.iter();
        outcomes
            .flat_map(|outcome| {
                let kept = (self.hold.is_none() && outcome.held.contains(&Hold::Ratio)).then(|| {
                    format!(
                        "\"{}\" keeps the tractive ratio: the traction force changes with friction and load; \
                         --hold force keeps the force",
                        outcome.title
                    )
                });
                outcome.effect.sentence().map(str::to_owned).into_iter().chain(kept)
            })
            .chain(known_to.map(|known| known.to_string()))
            .collect()
    }

    /// Heads of the table without that of the titles: those of what is known of some outcome.
    pub fn header(&self) -> Vec<&'static str> {
        let mut header = vec!["fastest mm", "dB per 10⁶ passages", "change"];
        if self.holds() {
            header.push("held");
        }
        header.push("ridge Hz");
        if self.names_rails() {
            header.push("rail");
        }
        if self.leading().is_some() {
            header.extend(["passages to limit", "MGT to limit"]);
        }
        if self.counts_months() {
            header.push("months to limit");
        }
        header
    }

    /// The cells of an outcome under the [`header`](Self::header).
    pub fn row(&self, outcome: &Outcome) -> Vec<String> {
        let FastestLine {
            wavelength,
            rate,
            at_edge,
        } = outcome.fastest;
        let edge = if at_edge { " (edge)" } else { "" };
        let change = outcome.change_from(self.comparison.base());
        let mut row = vec![
            format!("{:.1}{edge}", 1e3 * wavelength),
            format!("{:+.3}", per_million(rate)),
            match &outcome.effect {
                Effect::CannotAct(_) => "cannot act".to_owned(),
                Effect::ChangesNothing(_) => "changes nothing".to_owned(),
                _ => change.map_or_else(String::new, |change| format!("{:+.0} %", 100.0 * change)),
            },
        ];
        if self.holds() {
            row.push(outcome.held_name().unwrap_or_default().to_owned());
        }
        let ridge = outcome.ridge_frequency;
        row.push(ridge.map_or_else(String::new, |f| format!("{f:.0}")));
        if self.names_rails() {
            let rail = outcome.leading().and_then(RailForecast::name);
            row.push(rail.unwrap_or_default().to_owned());
        }
        if let Some(reach) = outcome.reach() {
            let mgt = reach
                .passages()
                .map(|passages| outcome.growth.mgt(passages));
            row.push(reached(reach));
            row.push(mgt.map_or_else(String::new, number));
        }
        if self.counts_months() {
            let months = outcome.months_to_limit();
            row.push(months.map_or_else(String::new, number));
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

    /// A rail in front of words on it, where there are several.
    pub fn prefix(&self, rail: &RailForecast) -> String {
        match rail.name() {
            Some(name) if self.names_rails() => format!("{} ", rail_in_words(name)),
            _ => String::new(),
        }
    }

    /// " on rail low", where there are several.
    pub fn on(&self, rail: &RailForecast) -> String {
        match self.prefix(rail).trim_end() {
            "" => String::new(),
            name => format!(" on {name}"),
        }
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
