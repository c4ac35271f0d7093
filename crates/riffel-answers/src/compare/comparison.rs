//! What would help: one traffic on a case and on variants of it, side by side.

use riffel::forecast::{Reach, TrafficGrowth};
use riffel::roughness::{LevelLimit, ThirdOctave};
use riffel_case::traffic::{DAYS_PER_MONTH, Traffic, bands_of};
use riffel_case::{Case, Hold, SpeedChange, Variant, ask, idle_because};
use riffel_keys::{CaseError, Message, Value, say};
use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};

use super::documents::{BandRate, HighestOfRidge, RailReach};
use crate::WearLimitDocument;
use crate::forecast::{RailForecast, RailStart, ReachDocument, rates_without_time};
use crate::ridge::{best_fit_frequency, ridge_of};

/// Growth under one traffic, as it is and as each variant makes it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Comparison {
    /// The bands.
    #[serde(skip)]
    pub bands: Vec<ThirdOctave>,
    /// Growth of the case as it is by its model.
    #[serde(skip)]
    pub model: TrafficGrowth,
    /// The case as it is, then the variants in their order.
    pub outcomes: Vec<Outcome>,
}

/// What a variant does.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Outcome {
    /// Its title.
    pub title: String,
    /// What the variant holds of the mean state, by vehicle: each kind once; empty if friction and load stay, or the variant gives
    /// the mean state itself; told as [`held_name`](Self::held_name).
    #[serde(rename = "hold", serialize_with = "held_name")]
    pub held: Vec<Hold>,
    /// What it does to growth.
    #[serde(flatten)]
    pub effect: Effect,
    /// The line of highest growth.
    #[serde(flatten)]
    pub fastest: FastestLine,
    /// For that growth.
    #[serde(flatten)]
    wear_limit: WearLimitDocument,
    /// Relative to the case as it is; null where that does not grow, or the variant does not act.
    change_of_fastest_growth: Option<f64>,
    /// Frequency \[Hz\] that the strongest branch of the ridge follows, for the wheel of the case over the speeds of
    /// its map; `None` if nothing grows.
    #[serde(rename = "ridge_frequency_hz")]
    pub ridge_frequency: Option<f64>,
    ridge_highest: Option<HighestOfRidge>,
    growth_rate_per_passage: Vec<BandRate>,
    /// The rail that reaches the limit first; null where rails are not named.
    rail: Option<String>,
    /// When each rail reaches the limit, the one that leads first.
    #[serde(rename = "rails")]
    rail_reaches: Vec<RailReach>,
    /// Null without a spectrum.
    #[serde(flatten)]
    reach: ReachDocument,
    /// Passages to the limit over those of the case as it is; null where either never is there.
    change_of_time_to_limit: Option<f64>,
    linear_range_passages: Option<f64>,
    /// What the reader should know about the validity of the models.
    pub remarks: Vec<Message>,
    /// Growth by vehicle and line; in bands of the rail that leads whose growth was measured, as that changes.
    #[serde(skip)]
    pub growth: TrafficGrowth,
    /// Axle passages a day, if known.
    #[serde(skip)]
    pub passages_per_day: Option<f64>,
    /// Why no months follow from how the rail that leads grows.
    #[serde(skip)]
    pub without_time: Option<Message>,
    /// Whether nothing is told of what this variant does, for the model does not explain how the rail that leads grew: growth is that of the
    /// case as it is, and there are no rails.
    #[serde(skip)]
    pub untold: bool,
    /// The rails under this traffic, the one that leads first; empty if no spectrum was given.
    #[serde(skip)]
    pub rails: Vec<RailForecast>,
}

/// What a variant does to growth.
#[derive(Debug, Clone, PartialEq)]
pub enum Effect {
    /// It is the case as it is.
    None,
    /// It changes growth; the sentence is on keys that have no part in that, where there are any.
    Acts(Option<Message>),
    /// No key of it can change growth in this case, and none does: the sentence says why.
    CannotAct(Message),
    /// Growth is the same to the last digit, as where a file gives the values of the case.
    ChangesNothing(Message),
}

/// Whether it changes growth, null for the case as it is, and why it does not or which of its keys do not.
impl Serialize for Effect {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut effect = serializer.serialize_struct("Effect", 2)?;
        effect.serialize_field("acts", &(*self != Self::None).then(|| self.acts()))?;
        effect.serialize_field("no_effect", &self.sentence())?;
        effect.end()
    }
}

impl Effect {
    /// Of a variant on the case that it makes, by growth before and after.
    fn of(variant: &Variant, changed: &Case, before: &TrafficGrowth, after: &TrafficGrowth) -> Self {
        let idle: Vec<(&str, Message)> =
            variant.keys().filter_map(|key| Some((key, idle_because(changed, key)?))).collect();
        let all = idle.len() == variant.settings.len() && variant.speed == SpeedChange::default();
        let mut reasons: Vec<(Vec<Message>, &Message)> = Vec::new();
        for (key, reason) in &idle {
            let key = Message::verbatim(format!("`{key}`"));
            match reasons.iter_mut().find(|known| known.1 == reason) {
                Some(known) => known.0.push(key),
                None => reasons.push((vec![key], reason)),
            }
        }
        let title = &variant.title;
        let reasons = reasons.into_iter().map(|(keys, reason)| {
            let (count, keys) = (keys.len(), keys.into_iter().collect::<Value>());
            say!(keys_have_no_effect, keys, count, reason = reason.clone())
        });
        let reasons = reasons.reduce(Message::followed_by);
        let same = before.vehicles().len() == after.vehicles().len()
            && before.vehicles().iter().zip(after.vehicles()).all(|(before, after)| before.growth == after.growth);
        match (same, all, reasons) {
            (true, true, Some(reasons)) => Self::CannotAct(say!(variant_cannot_act, title, reasons)),
            (true, ..) => Self::ChangesNothing(say!(variant_changes_nothing, title)),
            (false, _, reasons) => Self::Acts(reasons.map(|reasons| say!(variant_acts_in_part, title, reasons))),
        }
    }

    /// Whether growth can be compared with that of the case.
    pub fn acts(&self) -> bool {
        matches!(self, Self::Acts(_))
    }

    /// What the reader should know of it.
    pub fn sentence(&self) -> Option<&Message> {
        match self {
            Self::None => None,
            Self::Acts(sentence) => sentence.as_ref(),
            Self::CannotAct(sentence) | Self::ChangesNothing(sentence) => Some(sentence),
        }
    }
}

/// The wavelength that grows fastest under the traffic.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FastestLine {
    /// Its wavelength \[m\]; under a distribution of speeds one of the lines, to 1.5 %.
    #[serde(rename = "fastest_wavelength_m")]
    pub wavelength: f64,
    /// Its growth rate per axle passage \[-\]; below zero where nothing grows.
    #[serde(rename = "fastest_growth_rate_per_passage")]
    pub rate: f64,
    /// It is the first or the last line: a shorter or longer wavelength may grow faster.
    #[serde(rename = "fastest_at_edge")]
    pub at_edge: bool,
}

impl Comparison {
    /// Compute the case and its variants under the traffic, with the levels of rails and a limit if there are
    /// any. `progress` is told of each vehicle of each outcome.
    ///
    /// # Errors
    /// [`CaseError`] with the key of the file that is at fault.
    pub fn compute(
        case: &Case,
        variants: &[Variant],
        traffic: &Traffic,
        starts: &dyn Fn(Option<f64>) -> Vec<RailStart>,
        limit: Option<&LevelLimit>,
        progress: &(dyn Fn(usize) + Sync),
    ) -> Result<Self, CaseError> {
        let bands = bands_of(case);
        let as_it_is = Variant::none("as it is");
        let mut outcomes: Vec<Outcome> = Vec::new();
        let first = traffic.on(case, &bands, &as_it_is, progress)?;
        let model = first.growth.clone();
        let mut first = Some(first);
        for variant in std::iter::once(&as_it_is).chain(variants) {
            let on = match first.take() {
                Some(on) => on,
                None => traffic.on(case, &bands, variant, progress)?,
            };
            let changed = variant.applied_to(case)?;
            let ridge = ridge_of(&changed, &changed.feedback);
            let mut rails = starts(on.passages_per_day);
            let base = outcomes.first();
            let is_base = base.is_none();
            let untold = base.is_some_and(|base| {
                let unexplained = |rail: &RailForecast| rail.unexplained(&model, None);
                base.leading().is_some_and(|rail| !unexplained(rail).is_empty())
            });
            if untold {
                rails.clear();
            } else if !is_base {
                for start in &mut rails {
                    *start = start.clone().changed(&model, &on.growth);
                }
            }
            let rails = RailForecast::of_rails(&rails, &on, limit)
                .map_err(|error| CaseError::data("spectrum", error.to_string()))?;
            let effect = match is_base {
                true => Effect::None,
                false => Effect::of(variant, &changed, &model, &on.growth),
            };
            let leading = rails.first();
            let own = leading.and_then(|rail| rail.start.growth.as_ref());
            let growth = match (own, base.filter(|_| untold)) {
                (_, Some(base)) => base.growth.clone(),
                (Some(own), None) => on.growth.clone().as_measured(own),
                (None, None) => on.growth.clone(),
            };
            let fastest = match untold {
                true => FastestLine::UNTOLD,
                false => FastestLine::of(&growth, case, leading),
            };
            let without_time = match leading {
                Some(rail) => rail.without_time(&on),
                None => rates_without_time(&on, [fastest.rate].into_iter()),
            };
            let told_rate = Some(fastest.rate).filter(|rate| !rate.is_nan());
            let mut outcome = Outcome {
                title: variant.title.clone(),
                wear_limit: WearLimitDocument::under(case, growth.mean_wear(), on.wear_coefficient, told_rate),
                without_time,
                fastest,
                untold,
                ridge_frequency: best_fit_frequency(&ridge),
                ridge_highest: ridge.highest().map(HighestOfRidge::of),
                passages_per_day: on.passages_per_day,
                growth,
                rails,
                held: on.held,
                effect,
                remarks: on.remarks,
                change_of_fastest_growth: None,
                growth_rate_per_passage: Vec::new(),
                rail: None,
                rail_reaches: Vec::new(),
                reach: ReachDocument::default(),
                change_of_time_to_limit: None,
                linear_range_passages: None,
            };
            outcome.tell(&bands, base);
            outcomes.push(outcome);
        }
        Ok(Self { bands, model, outcomes })
    }

    /// The case as it is.
    pub fn base(&self) -> &Outcome {
        &self.outcomes[0]
    }
}

/// What is held, by its name.
fn held_name<S: Serializer>(held: &[Hold], serializer: S) -> Result<S::Ok, S::Error> {
    name_of(held).serialize(serializer)
}

fn name_of(held: &[Hold]) -> Option<&'static str> {
    match held {
        [] => None,
        [hold] => Some(hold.name()),
        _ => Some("mixed"),
    }
}

impl Outcome {
    /// Tell what follows in bands, on the rails and beside the case as it is; without that, it is that case.
    fn tell(&mut self, bands: &[ThirdOctave], base: Option<&Self>) {
        let base = base.unwrap_or(self);
        let rates = bands.iter().enumerate().map(|(place, band)| {
            let rate = self.growth.band_rate(place);
            BandRate {
                wavelength_m: band.wavelength(),
                growth_rate_per_passage: rate,
                change: rate - base.growth.band_rate(place),
            }
        });
        let rates = rates.collect();
        let change_of_fastest_growth = match self.effect {
            Effect::None => (self.fastest.rate > 0.0).then_some(0.0),
            _ => self.change_from(base),
        };
        let before = base.passages_to_limit().filter(|passages| *passages > 0.0);
        let change_of_time_to_limit = self.passages_to_limit().zip(before).map(|(own, base)| own / base - 1.0);
        self.growth_rate_per_passage = rates;
        self.change_of_fastest_growth = change_of_fastest_growth;
        self.change_of_time_to_limit = change_of_time_to_limit;
        self.rail_reaches = self.rails.iter().map(|rail| RailReach::of(rail, self)).collect();
        if let Some(leading) = self.rail_reaches.first().cloned() {
            RailReach { rail: self.rail, reach: self.reach, linear_range_passages: self.linear_range_passages } =
                leading;
        }
    }

    /// The rail that leads, see [`RailForecast::of_rails`]; `None` if no spectrum was given.
    pub fn leading(&self) -> Option<&RailForecast> {
        self.rails.first()
    }

    /// When the rail that leads reaches the limit; `None` if no spectrum or no limit was given.
    pub fn reach(&self) -> Option<Reach> {
        self.leading()?.reach
    }

    /// Axle passages until the rail that leads reaches the limit, if they are known.
    pub fn passages_to_limit(&self) -> Option<f64> {
        self.reach()?.passages()
    }

    /// Months until the rail that leads reaches the limit, if they are known.
    pub fn months_to_limit(&self) -> Option<f64> {
        self.months(self.passages_to_limit()?)
    }

    /// Months that some axle passages take, if the axles a day are known.
    pub fn months(&self, passages: f64) -> Option<f64> {
        let per_day = self.passages_per_day.filter(|_| self.without_time.is_none())?;
        Some(passages / per_day / DAYS_PER_MONTH)
    }

    /// The name of what is held where friction or load change: force, ratio, creepage, or mixed where that differs
    /// from vehicle to vehicle.
    pub fn held_name(&self) -> Option<&'static str> {
        name_of(&self.held)
    }

    /// Change of the fastest growth from that of the case as it is, as a part of it; `None` if that does not grow
    /// or this does not act, or is not told.
    pub fn change_from(&self, base: &Self) -> Option<f64> {
        (base.fastest.rate > 0.0 && self.effect.acts() && !self.untold)
            .then(|| self.fastest.rate / base.fastest.rate - 1.0)
    }
}

impl FastestLine {
    /// That of a variant of which nothing is told.
    const UNTOLD: Self = Self { wavelength: f64::NAN, rate: f64::NAN, at_edge: false };

    /// Of the bands of the case; of a rail whose growth was measured, the wavelength that grows fastest on it.
    fn of(growth: &TrafficGrowth, case: &Case, rail: Option<&RailForecast>) -> Self {
        let own = rail.and_then(|rail| rail.start.growth.as_ref()?.fastest());
        let near = own.and_then(|own| growth.fastest_near(own.band.wavelength()));
        if let (Some(own), Some(rate)) = (own, near) {
            return Self { wavelength: own.band.wavelength(), rate, at_edge: false };
        }
        // Every traffic has a line.
        let (wavelength, rate, at_edge) = ask::fastest_under(case, growth).unwrap_or_default();
        Self { wavelength, rate, at_edge }
    }
}
