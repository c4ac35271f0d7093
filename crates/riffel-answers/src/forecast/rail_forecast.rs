//! The rails of a track under one traffic: each grows as it was measured to, or else all as the model says.

use riffel::forecast::{Forecast, ForecastBand, MeasuredBand, MeasuredGrowth, Reach, TrafficGrowth, WearSpread};
use riffel::roughness::{LevelLimit, ThirdOctave};
use riffel_case::traffic::{DAYS_PER_MONTH, TrafficOnCase, is_faster_than_known};
use riffel_keys::{Message, fixed, number, say, significant};
use riffel_rail::{GroundRail, RailSpectrum, Survey, are_opposite};

use super::{per_million, words};
use crate::Banded;

/// Growth by the model over that of a rail which it explains.
const EXPLAINS: std::ops::RangeInclusive<f64> = 0.5..=2.0;
/// Decibels of a growth by a factor of e.
const DECIBELS: f64 = 20.0 / std::f64::consts::LN_10;

/// Whether a growth rate of a model explains the slope of a level \[dB\] that was measured.
fn explains(rate: f64, slope: f64) -> bool {
    EXPLAINS.contains(&(DECIBELS * rate / slope))
}

/// What is known of a rail when a forecast begins.
#[derive(Debug, Clone, PartialEq)]
pub struct RailStart {
    /// Its levels now.
    pub levels: RailSpectrum,
    /// Whether these were measured; else they are what grinding leaves.
    pub is_measured: bool,
    /// Whether the case may be of this rail: not so of one in a curve whose case is of the other.
    pub is_of_case: bool,
    /// How it grew from date to date, in axle passages.
    pub growth: Option<MeasuredGrowth>,
}

impl RailStart {
    /// The rails of a survey, which begin as they are or as they will be ground; each with its own growth where it has several dates. The
    /// case is of the rail of these names, or of both without any.
    pub fn of(
        of_case: &[&str],
        survey: Option<&Survey>,
        ground: Option<&GroundRail>,
        passages_per_day: Option<f64>,
    ) -> Vec<Self> {
        let rails = survey.map(Survey::rail_means).unwrap_or_default();
        let history = survey.and_then(|survey| survey.history.as_ref());
        let starts = rails.into_iter().map(|levels| {
            let growth = history.and_then(|it| it.growth(levels.rail.as_deref(), passages_per_day));
            let name = levels.rail.as_deref();
            let is_other = |of: &&str| name.is_some_and(|name| are_opposite(name, of));
            Self { is_of_case: !of_case.iter().any(is_other), levels, is_measured: true, growth }
        });
        let starts: Vec<Self> = starts.collect();
        let Some(ground) = ground else {
            return starts;
        };
        let spectrum = &ground.spectrum;
        let mut of_ground: Vec<Self> = starts.into_iter().filter(|start| start.growth.is_some()).collect();
        for start in &mut of_ground {
            start.levels.spectrum = spectrum.clone();
            start.is_measured = false;
        }
        match of_ground.is_empty() {
            true => vec![spectrum.clone().into()],
            false => of_ground,
        }
    }

    /// Why no months follow from how the rail grows under a traffic: as the model says, that oscillates by itself or grows faster than
    /// any railway known. `None` if they do.
    pub(crate) fn without_time(&self, forecast: &Forecast, on: &TrafficOnCase) -> Option<Message> {
        if self.growth.is_some() {
            return None;
        }
        let rates = forecast.bands().iter();
        rates_without_time(on, rates.map(|band| forecast.growth_rate(band)))
    }
}

/// Why no months follow from some growth rates of a model under a traffic: its loop oscillates by itself, or one is faster than any
/// railway known. `None` if they do.
pub(crate) fn rates_without_time(on: &TrafficOnCase, mut rates: impl Iterator<Item = f64>) -> Option<Message> {
    if let Some(frequency) = on.unstable {
        return Some(say!(rates_of_unstable_loop, frequency = fixed(frequency, 0)));
    }
    let per_day = on.passages_per_day?;
    rates.any(|rate| is_faster_than_known(rate, per_day)).then(|| say!(rates_faster_than_known))
}

impl RailStart {
    /// Why the records of a survey tell of no rail how it grows, where they have dates or are of several instruments, or would tell nothing
    /// else, as of a rail that will be ground; axle passages a day where they are known.
    pub fn without_growth(
        starts: &[Self],
        survey: &Survey,
        is_ground: bool,
        passages_per_day: Option<f64>,
    ) -> Option<Message> {
        let has_dates = survey.history.is_some();
        Self::without_dates(starts, has_dates, is_ground, passages_per_day)
            .or_else(|| survey.without_common_instrument())
    }

    /// Reason why records tell of no rail how it grows, if it is only known whether they have dates.
    pub(crate) fn without_dates(
        starts: &[Self],
        has_dates: bool,
        is_ground: bool,
        passages_per_day: Option<f64>,
    ) -> Option<Message> {
        if starts.iter().any(|start| start.growth.is_some()) {
            return None;
        }
        match (has_dates, passages_per_day) {
            (true, None) => Some(say!(growth_without_traffic)),
            (true, Some(_)) => Some(say!(dates_since_grinding)),
            (false, _) => is_ground.then(|| say!(levels_beside_ground)),
        }
    }

    /// The forecast of the rail: by its own growth, or else by that of the model.
    ///
    /// # Errors
    /// [`riffel::Error::Measurement`] where the rail has no band in common with the traffic.
    pub fn forecast(&self, on: &TrafficOnCase) -> Result<Forecast, riffel::Error> {
        let growth = on.growth.clone();
        let growth = match &self.growth {
            Some(own) => growth.as_measured(own),
            None => growth,
        };
        Forecast::new(&self.levels.spectrum, growth)
    }

    /// The start under something that changes: its own growth changes as that of the model within a tenth of each wavelength, where the
    /// model explains it.
    pub(crate) fn changed(mut self, base: &TrafficGrowth, variant: &TrafficGrowth) -> Self {
        let own = self.growth.clone();
        let factor = |band: ThirdOctave| {
            let near = |growth: &TrafficGrowth| growth.fastest_near(band.wavelength());
            let slope = own.as_ref().and_then(|own| Some(own.band(band)?.slope));
            match (near(base), near(variant), slope) {
                (Some(base), Some(variant), Some(slope)) if explains(base, slope) => variant / base,
                _ => 1.0,
            }
        };
        self.growth = self.growth.map(|growth| growth.scaled(factor));
        self
    }
}

impl<T: Into<RailSpectrum>> From<T> for RailStart {
    /// A rail that will be ground, of which no growth was measured.
    fn from(levels: T) -> Self {
        Self { levels: levels.into(), is_measured: false, is_of_case: true, growth: None }
    }
}

/// The forecast of a rail.
#[derive(Debug, Clone, PartialEq)]
pub struct RailForecast {
    /// The rail with all its levels now, bands that are not forecast included, and its own growth.
    pub start: RailStart,
    /// Its forecast.
    pub forecast: Forecast,
    /// When its first band reaches the limit; `None` if no limit was given.
    pub reach: Option<Reach>,
}

impl RailForecast {
    /// The forecasts of all rails that have a band in common with the traffic. The rail that leads is first: the one
    /// that reaches the limit first; where none does, the one whose wheel leaves the rail first before that; else
    /// and where both do so now, the one that is highest over the limit.
    ///
    /// # Errors
    /// [`riffel::Error::Measurement`] where no rail has a band in common with the traffic.
    pub fn of_rails(
        rails: &[RailStart],
        on: &TrafficOnCase,
        limit: Option<&LevelLimit>,
    ) -> Result<Vec<Self>, riffel::Error> {
        let mut found = Vec::new();
        let mut refused = None;
        for start in rails {
            match start.forecast(on) {
                Ok(forecast) => found.push(Self {
                    reach: limit.map(|limit| forecast.grinding_interval(limit)),
                    start: start.clone(),
                    forecast,
                }),
                Err(error) => refused = Some(error),
            }
        }
        if let (true, Some(error)) = (found.is_empty(), refused) {
            return Err(error);
        }
        let order = |one: &Self| {
            let (passages, end) = match one.reach {
                Some(Reach::After(passages)) => (passages, f64::INFINITY),
                Some(Reach::BeyondLinearRange) => (f64::INFINITY, one.forecast.valid_to()),
                Some(Reach::Never) | None => (f64::INFINITY, f64::INFINITY),
            };
            [passages, end, -one.excess(limit)]
        };
        found.sort_by(|a, b| {
            let pairs = order(a).into_iter().zip(order(b));
            pairs.fold(std::cmp::Ordering::Equal, |so_far, (a, b)| so_far.then(a.total_cmp(&b)))
        });
        Ok(found)
    }

    /// Why no months follow from how the rail grows under a traffic; `None` if they do.
    pub fn without_time(&self, on: &TrafficOnCase) -> Option<Message> {
        self.start.without_time(&self.forecast, on)
    }

    /// Name of the rail.
    pub fn name(&self) -> Option<&str> {
        self.start.levels.rail.as_deref()
    }

    /// The growth of a band as it was measured, times in axle passages.
    pub fn own(&self, band: &ForecastBand) -> Option<&MeasuredBand> {
        self.start.growth.as_ref()?.band(band.now.band)
    }

    /// The band that grows fastest on it as it was measured, and what part of that a model has there, within a tenth of the wavelength;
    /// `None` if no growth was measured, or the case is of the other rail.
    pub(super) fn model_beside(&self, model: &TrafficGrowth) -> Option<(&MeasuredBand, f64)> {
        let own = self.grown().filter(|_| self.start.is_of_case)?;
        let near = model.fastest_near(own.band.wavelength())?;
        Some((own, DECIBELS * near / own.slope))
    }

    /// The band that grows fastest on it as it was measured; `None` if none grows, or no growth was measured.
    fn grown(&self) -> Option<&MeasuredBand> {
        let fastest = self.start.growth.as_ref()?.fastest();
        fastest.filter(|own| own.slope > 0.0)
    }

    /// Where a model does not explain how it grew under so many axles a day, or is of the other rail: how it grew, and that no variant of the
    /// model tells what would lower that; else empty.
    pub(crate) fn unexplained(&self, model: &TrafficGrowth, passages_per_day: Option<f64>) -> Vec<Message> {
        let beside = self.model_beside(model);
        if self.grown().is_none() || beside.is_some_and(|(_, ratio)| EXPLAINS.contains(&ratio)) {
            return Vec::new();
        }
        let own = self.own_growth(model, passages_per_day).into_iter();
        own.flat_map(|own| match self.start.is_of_case {
            true => [own, say!(model_does_not_explain_growth)],
            false => [own, say!(model_is_of_the_other_rail)],
        })
        .collect()
    }

    /// How it grew, and what of it a model explains, under so many axles a day.
    pub(crate) fn own_growth(&self, model: &TrafficGrowth, passages_per_day: Option<f64>) -> Option<Message> {
        let Some(own) = self.grown() else {
            let is_measured = self.start.growth.is_some();
            return is_measured.then(|| say!(no_band_has_grown));
        };
        let wavelength = number(own.band.nominal_millimetres());
        let decibels = fixed(own.slope * own.span(), 1);
        let amount = match passages_per_day {
            Some(per_day) => {
                let months = own.span() / per_day / DAYS_PER_MONTH;
                say!(months_of, months = words::number(months))
            }
            None => say!(so_many_passages, passages = words::millions(own.span())),
        };
        let Some((_, ratio)) = self.model_beside(model) else {
            return Some(say!(grew_by_its_own, wavelength, decibels, amount));
        };
        let ratio_in_words = significant(ratio, 2);
        Some(if ratio <= 0.0 {
            say!(grew_where_model_decays, wavelength, decibels, amount)
        } else if EXPLAINS.contains(&ratio) {
            say!(grew_as_model_explains, wavelength, decibels, amount, ratio = ratio_in_words)
        } else {
            say!(grew_unlike_model, wavelength, decibels, amount, ratio = ratio_in_words)
        })
    }

    /// Growth of the level of a band \[dB per million axles\] with its bands: as measured, or by what the wear coefficient may be.
    pub fn growth_within(&self, band: &ForecastBand, spread: Option<WearSpread>) -> Option<Banded> {
        let median = per_million(self.forecast.growth_rate(band));
        match self.own(band) {
            Some(own) => {
                let [band_50, band_80] = own.slope_within().map(|it| it.map(|slope| 1e6 * slope));
                Some(Banded { median, band_50, band_80 })
            }
            None => Some(Banded::by_wear(median, spread?)),
        }
    }

    /// Between what its level is \[dB re 1 µm\] after some axle passages by 80 %, where its growth was measured.
    pub fn level_80(&self, band: &ForecastBand, passages: f64) -> Option<[f64; 2]> {
        let change = self.own(band)?.change_80(passages, self.start.is_measured);
        Some(change.map(|change| band.now.level + change))
    }

    /// Between what axle passages a band reaches a limit \[dB re 1 µm\] by 80 %, when it does after `passages`; infinite where it may
    /// never do so.
    pub fn passages_80(
        &self,
        band: &ForecastBand,
        limit: f64,
        passages: f64,
        spread: Option<WearSpread>,
    ) -> Option<[f64; 2]> {
        match self.own(band) {
            Some(own) => {
                let times = own.time_80(limit - band.now.level, self.start.is_measured);
                Some(times.map(|time| time.unwrap_or(f64::INFINITY)))
            }
            None => Some(spread?.band_80(passages)),
        }
    }

    /// The highest level now over the limit \[dB\], or over 1 µm where there is no limit.
    fn excess(&self, limit: Option<&LevelLimit>) -> f64 {
        let bands = self.forecast.bands().iter();
        let over = bands.filter_map(|band| {
            let limit = match limit {
                Some(limit) => limit.spectrum().level(band.now.band)?,
                None => 0.0,
            };
            Some(band.now.level - limit)
        });
        over.fold(f64::NEG_INFINITY, f64::max)
    }
}
