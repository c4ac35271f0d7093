//! What a forecast finds, in sentences.

use riffel::forecast::{MeasuredBand, Reach};
use riffel_case::traffic::{SpreadEffect, vehicle_in_words};
use riffel_keys::{Message, fixed, number as numeral, say};

use super::damage::{CrackedWave, HardenedWave};
use super::rail_forecast::RailForecast;
use super::words::{millions, number};
use super::{Crossing, TrackForecast, WearReport};

/// What a spread does, where it is worth a word.
fn spread_in_words(spread: &SpreadEffect) -> Option<Message> {
    /// Less is no reduction to speak of.
    const WORTH_A_WORD: f64 = 1.05;
    let reduction = spread.reduction.filter(|reduction| *reduction >= WORTH_A_WORD)?;
    let what = match &*spread.what {
        "speed" => say!(spread_of_speed),
        "wheel_radius" => say!(spread_of_wheel_radius),
        "load" => say!(spread_of_load),
        "friction" => say!(spread_of_friction),
        "lateral_position" => say!(spread_of_position),
        key => say!(spread_of_key, key),
    };
    let factor = match reduction < 10.0 {
        true => fixed(reduction, 1),
        false => fixed(reduction, 0),
    };
    let vehicle = vehicle_in_words(&spread.vehicle);
    Some(say!(spread_takes_down, vehicle, what, factor))
}

impl TrackForecast {
    /// Between how many months the leading rail reaches its limit by 80 %; `None` if it is over it now or never reaches it.
    pub(crate) fn months_80(&self) -> Option<[f64; 2]> {
        let rail = self.leading();
        let crossings = self.crossings(rail);
        let Crossing { band, limit, passages } = crossings.first().filter(|it| it.passages > 0.0)?;
        let [early, late] = rail.passages_80(band, *limit, *passages, self.wear_spread)?;
        Some([self.months_of(rail, early)?, self.months_of(rail, late)?])
    }

    /// Sentence on the months between which the leading rail reaches its limit.
    pub(crate) fn months_within(&self) -> Option<Message> {
        let rail = self.leading();
        let crossings = self.crossings(rail);
        let is_measured = rail.own(crossings.first()?.band).is_some();
        let [early, late] = self.months_80()?;
        let early = number(early);
        Some(match (is_measured, late.is_finite()) {
            (true, true) => say!(measured_months_within, early, late = number(late)),
            (true, false) => say!(measured_months_from, early),
            (false, _) => say!(months_within, early, late = number(late)),
        })
    }

    /// The band that grows fastest on the leading rail as it was measured, and what part of that the model has there.
    pub(super) fn model_beside(&self) -> Option<(&MeasuredBand, f64)> {
        self.leading().model_beside(&self.on.growth)
    }

    /// What growth goes by: how the leading rail grew, or else that its dates do not tell it, and a mean wear that no rail has.
    pub(crate) fn first_said(&self) -> Vec<Message> {
        let by_model = [&self.without_growth, &self.unlikely_wear];
        match self.own_growth() {
            Some(own) => vec![own],
            None => by_model.into_iter().flatten().cloned().collect(),
        }
    }

    /// Where the model does not explain how the leading rail grew, the sentence that says so and what follows of it; else empty.
    pub(crate) fn unexplained(&self) -> Vec<Message> {
        // Where it has several dates they decide, else the fit of two.
        if self.own_growth().is_some() {
            let per_day = self.on.passages_per_day;
            return self.leading().unexplained(&self.on.growth, per_day);
        }
        let why = self.wear.iter().filter_map(WearReport::unexplained);
        why.flat_map(|why| [why, say!(model_does_not_explain_growth)]).collect()
    }

    /// How the leading rail grew, and what of it the model explains.
    fn own_growth(&self) -> Option<Message> {
        let own = self.leading();
        own.own_growth(&self.on.growth, self.on.passages_per_day)
    }

    /// What is said where another rail leads than that of the case: that it is another, how the case's own rail grew, and what of that
    /// growth the model explains.
    fn rail_of_case(&self) -> Vec<Message> {
        if self.leading().start.is_of_case || self.own_growth().is_none() {
            return Vec::new();
        }
        let rails = self.rails.iter().filter(|rail| rail.start.is_of_case);
        let own = rails.filter_map(|rail| {
            let grew = rail.own_growth(&self.on.growth, self.on.passages_per_day)?;
            Some(self.about(rail, grew))
        });
        [say!(model_is_of_the_other_rail)].into_iter().chain(own).collect()
    }

    /// Between what the fastest growth lies.
    fn fastest_within(&self) -> Option<Message> {
        let (band, _) = self.fastest().filter(|(_, rate)| *rate > 0.0)?;
        let rail = self.leading();
        let within = rail.growth_within(band, self.wear_spread)?;
        let wavelength = numeral(band.now.band.nominal_millimetres());
        let [low, high] = within.band_80.map(number);
        let by = match rail.own(band) {
            Some(_) => say!(as_this_rail_grew),
            None => say!(as_the_coefficient_may_be),
        };
        let per_month = self.on.passages_per_month();
        let per_month = per_month.filter(|_| rail.without_time(&self.on).is_none());
        let said = match per_month {
            None => say!(grows_within, wavelength, low, high, by),
            Some(passages) => {
                let a_month = within.times(1e-6 * passages).band_80;
                let [low_a_month, high_a_month] = a_month.map(number);
                say!(grows_within_a_month, wavelength, low, high, low_a_month, high_a_month, by)
            }
        };
        Some(said)
    }

    /// What hardening and cracks make of the waves of the rail that leads.
    pub fn damage_in_words(&self) -> impl Iterator<Item = Message> {
        let hardened = HardenedWave::in_words(&self.leading().forecast, &self.on);
        let cracked = CrackedWave::in_words(&self.cracks(), &self.on, self.until());
        hardened.into_iter().chain(cracked)
    }

    /// A sentence with the name of its rail, where there are several.
    fn about(&self, rail: &RailForecast, sentence: Message) -> Message {
        match self.rail(rail) {
            Some(name) => sentence.about(name),
            None => sentence,
        }
    }

    /// What follows, in sentences; those on the rail that leads first.
    pub fn findings(&self) -> Vec<Message> {
        let mut findings: Vec<Message> = self
            .rails
            .iter()
            .enumerate()
            .map(|(place, rail)| match (self.rail(rail), place) {
                (Some(name), 0) => say!(rail_leads, rail = name, sentence = self.interval(rail)),
                _ => self.about(rail, self.interval(rail)),
            })
            .collect();
        // Of the rail that leads, which is the first.
        findings.splice(1..1, self.months_within());
        findings.splice(0..0, self.first_said());
        findings.extend(self.rail_of_case());
        let rails = self.rails.iter();
        findings.extend(rails.map(|rail| self.about(rail, self.linear_range(rail))));
        let decays = |rail: &RailForecast| {
            let mut bands = rail.forecast.bands().iter();
            bands.any(|band| rail.forecast.growth_rate(band) < 0.0)
        };
        if self.rails.iter().any(decays) {
            findings.push(say!(decaying_bands_stay));
        }
        findings.extend(self.fastest_within());
        findings.extend(self.damage_in_words());
        findings.extend(self.bend());
        // What a spread does to the model is nothing to a rail that goes by its own growth.
        let is_of_model = self.leading().start.growth.is_none();
        let spreads = self.spreads.iter().filter(|_| is_of_model);
        findings.extend(spreads.filter_map(spread_in_words));
        let left_out = self.left_out();
        if let (Some(first), Some(last)) = (left_out.first(), left_out.last()) {
            findings.push(say!(bands_not_forecast, count = numeral(left_out.len()), first = *first, last = *last));
        }
        findings
    }

    /// Which band of the leading rail bends over first, if one does before the end of the forecast.
    fn bend(&self) -> Option<Message> {
        let bands = self.leading().forecast.bands().iter();
        let bends = bands.filter_map(|band| Some((band, band.bends_after()?)));
        let (band, passages) = bends.min_by(|a, b| a.1.total_cmp(&b.1))?;
        let wear = self.growth().mean_wear();
        (passages <= self.passages).then(|| {
            say!(
                band_bends_over,
                wavelength = numeral(band.now.band.nominal_millimetres()),
                passages = millions(passages),
                wear = fixed(1e3 * wear.depth_per_100_mgt(), 2)
            )
        })
    }

    /// When a rail reaches the limit.
    fn interval(&self, rail: &RailForecast) -> Message {
        let edition = &self.table.edition;
        let interval = match &self.ground {
            Some(ground) => say!(grinding_interval_from, ground = ground.words.clone()),
            None => say!(grinding_interval),
        };
        match (self.crossings(rail).first(), rail.reach) {
            (Some(first), _) if first.passages == 0.0 => say!(
                over_the_limit_now,
                edition,
                wavelength = first.band.now.band.nominal_millimetres(),
                decibels = fixed(first.band.now.level - first.limit, 1)
            ),
            (Some(first), _) => {
                let wavelength = first.band.now.band.nominal_millimetres();
                match rail.without_time(&self.on) {
                    None => say!(limit_reached_after, edition, wavelength, amount = self.amount(first.passages)),
                    Some(reason) => {
                        say!(limit_reached_without_time, edition, wavelength, reason)
                    }
                }
                .about(interval)
            }
            (None, Some(Reach::Never)) => say!(no_band_reaches, edition),
            (None, _) => say!(limit_not_reached_before, edition).about(interval),
        }
    }

    /// How far the linear loop holds on a rail.
    pub(super) fn linear_range(&self, rail: &RailForecast) -> Message {
        let linear = rail.forecast.linear_range(rail.forecast.bands());
        let vehicle = vehicle_in_words(&self.growth().vehicles()[linear.vehicle].name);
        let ratio = fixed(linear.force_ratio, 2);
        match linear.passages {
            Some(0.0) => say!(beyond_linear_range_now, ratio, vehicle),
            Some(passages) => {
                say!(linear_range_ends, ratio, vehicle, amount = self.amount_of(rail, passages))
            }
            None => say!(linear_range_never_ends, ratio, vehicle),
        }
    }
}
