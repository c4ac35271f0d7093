//! The future of a rail under traffic.

mod answer;
mod damage;
mod figure;
mod findings;
mod horizon;
mod measured_spectra;
mod over_posterior;
mod question;
mod rail_forecast;
mod reach;
mod wear_report;
mod words;

use jiff::ToSpan;
use jiff::civil::Date;
use riffel::forecast::{ForecastBand, Reach, TrafficGrowth, WearSpread};
use riffel::roughness::LevelLimit;
use riffel_case::file::CurveRail;
use riffel_case::traffic::{DAYS_PER_MONTH, SpreadEffect, Traffic, TrafficOnCase, bands_of};
use riffel_case::{Case, Variant};
use riffel_keys::{Language, Message, fixed, number as numeral, say};
use riffel_plot::LineFigure;
use riffel_rail::{GroundRail, LimitTable, Survey, name_in_words, rail_in_words};

use crate::{AnswerError, Result, Rows, Table, unlikely_wear, wear_spread};
use words::beyond;

pub use crate::number_alone;
pub use answer::ForecastAnswer;
pub use damage::{CrackedWave, HardenedWave};
pub(crate) use figure::{rate_panel, zero};
pub use horizon::ForecastHorizon;
pub use measured_spectra::MeasuredSpectra;
pub use over_posterior::PosteriorForecast;
pub use question::ForecastQuestion;
pub(crate) use rail_forecast::rates_without_time;
pub use rail_forecast::{RailForecast, RailStart};
pub(crate) use reach::ReachDocument;
pub use wear_report::WearReport;
pub(crate) use words::{number, reached, when};
pub use words::{per_million, three_digits};

/// What is asked of the future of a rail.
pub struct ForecastRequest {
    /// The traffic.
    pub traffic: Traffic,
    /// The records of what was measured; none for a rail that will be ground.
    pub survey: Option<Survey>,
    /// What the rail will be ground to, in place of what was measured.
    pub ground: Option<GroundRail>,
    /// How far to look ahead.
    pub horizon: ForecastHorizon,
    /// The limit of levels, with the table it is from.
    pub limit: (LimitTable, LevelLimit),
    /// Date of the spectrum.
    pub date: Option<Date>,
    /// Whether to find what each spread over the wheels does to growth, which takes growth without it as well.
    pub tells_spreads: bool,
}

/// The future of the rails of a track under one traffic.
pub struct TrackForecast {
    /// The traffic.
    pub traffic: Traffic,
    /// The traffic on the case.
    pub on: TrafficOnCase,
    /// What each spread over the wheels of a vehicle does to growth.
    pub spreads: Vec<SpreadEffect>,
    /// The records of what was measured; none for a rail that will be ground.
    pub survey: Option<Survey>,
    /// What the rail will be ground to.
    pub ground: Option<GroundRail>,
    /// The rails, the one that leads first; there is one in every report.
    pub rails: Vec<RailForecast>,
    /// Axle passages of the forecast.
    pub passages: f64,
    /// The table of the limit.
    pub table: LimitTable,
    /// The limit.
    pub limit: LevelLimit,
    /// Date of the spectrum.
    pub date: Option<Date>,
    /// The wear coefficient of two measurements, where there is an earlier one.
    pub wear: Option<WearReport>,
    /// How well the wear coefficient is known that growth goes by; `None` if growth goes by what was measured, or by other damage
    /// than wear.
    pub wear_spread: Option<WearSpread>,
    /// That no rail is known to wear as the case does; `None` if growth goes by what was measured.
    unlikely_wear: Option<Message>,
    /// Why the records do not tell how the rails grow, where they might.
    pub without_growth: Option<Message>,
    /// What is to be said of the records.
    pub warnings: Vec<Message>,
}

/// A band that reaches its limit.
struct Crossing<'a> {
    /// The band.
    band: &'a ForecastBand,
    /// Its limit \[dB re 1 µm\].
    limit: f64,
    /// Axle passages until then.
    passages: f64,
}

/// Least rise of a level that a table shows \[dB\].
const RISE_SHOWN: f64 = 0.05;

impl TrackForecast {
    /// The forecast of the rail that will be ground, or else of what was measured; `progress` is told of each vehicle.
    ///
    /// # Errors
    /// [`AnswerError::Argument`] for a horizon that is not finite and positive, [`AnswerError::Case`] with the key of the
    /// traffic at fault, [`AnswerError::NoSpectrum`] without a spectrum,
    /// [`AnswerError::OutsideWindow`] where no rail has a band in the window of the case, and
    /// [`AnswerError::NoPassagesPerDay`] for months where the traffic does not say how much of it there is.
    pub fn new(case: &Case, request: ForecastRequest, progress: &(dyn Fn(usize) + Sync)) -> Result<Self> {
        let ForecastRequest { traffic, survey, ground, horizon, limit: (table, limit), date, tells_spreads } = request;
        horizon.check()?;
        let wear_spread = wear_spread(case);
        let (case, bands) = (&case.sharing_parts(), bands_of(case));
        let (on, spreads) = match tells_spreads {
            true => traffic.on_with_effects(case, &bands, progress)?,
            false => (traffic.on(case, &bands, &Variant::none(""), progress)?, Vec::new()),
        };
        let (survey, measured_on) = match survey.map(Survey::latest) {
            Some((survey, date)) => (Some(survey), date),
            None => (None, None),
        };
        let measured = RailStart::of(&case.rail_in_curve(), survey.as_ref(), ground.as_ref(), on.passages_per_day);
        if measured.is_empty() {
            return Err(AnswerError::NoSpectrum);
        }
        let rails = RailForecast::of_rails(&measured, &on, Some(&limit)).map_err(AnswerError::OutsideWindow)?;
        let mut warnings = survey.as_ref().map_or_else(Vec::new, |survey| survey.warnings.clone());
        warnings.extend(not_forecast(&measured, &rails, case));
        let without_growth = survey
            .as_ref()
            .and_then(|survey| RailStart::without_growth(&measured, survey, ground.is_some(), on.passages_per_day));
        let by_model = rails.iter().any(|rail| rail.start.growth.is_none());
        if let (Some(from), true) = (case.from_curve(), by_model && rails.len() > 1) {
            let of_rail = match from.rail {
                CurveRail::Low => say!(of_low),
                CurveRail::High => say!(of_high),
                CurveRail::Left => say!(of_left),
                CurveRail::Right => say!(of_right),
            };
            warnings.push(say!(all_rails_grow_alike, of_rail));
        }
        let unlikely_wear = unlikely_wear(case, on.growth.mean_wear());
        Ok(Self {
            passages: horizon.passages(&on)?,
            traffic,
            on,
            spreads,
            survey,
            ground,
            rails,
            table,
            limit,
            date: date.or(measured_on),
            wear: None,
            wear_spread,
            unlikely_wear,
            without_growth,
            warnings,
        })
    }

    /// The figure of the forecast.
    pub fn figure(&self, case: &Case, language: Language) -> LineFigure {
        figure::figure(self, case, language)
    }

    /// Contact fatigue beside wear along the waves of the leading rail, at the end of the forecast; empty without fatigue among the laws.
    pub fn cracks(&self) -> Vec<CrackedWave> {
        CrackedWave::all(&self.leading().forecast, &self.on, self.until())
    }

    /// Passages at the end of the forecast, or where it ends before.
    pub(crate) fn until(&self) -> f64 {
        self.passages.min(self.leading().forecast.valid_to())
    }

    /// Months that some passages take, if the traffic says how much of it there is.
    pub fn months(&self, passages: f64) -> Option<f64> {
        Some(passages / self.on.passages_per_day? / DAYS_PER_MONTH)
    }

    /// Months from now until something befalls a rail, where its growth tells them.
    pub(crate) fn months_of(&self, rail: &RailForecast, passages: f64) -> Option<f64> {
        match rail.without_time(&self.on) {
            None => self.months(passages),
            Some(_) => None,
        }
    }

    /// Months from grinding until the limit is reached, where the forecast begins with a ground rail.
    pub fn months_between_grindings(&self) -> Option<f64> {
        self.ground.as_ref()?;
        let rail = self.leading();
        match rail.reach? {
            Reach::After(passages) => self.months_of(rail, passages),
            Reach::BeyondLinearRange | Reach::Never => None,
        }
    }

    /// The date after some passages, if it is within a hundred years: no rail lies longer.
    fn date_after(&self, passages: f64) -> Option<Date> {
        const LIFE: f64 = 36_525.0;
        let days = (passages / self.on.passages_per_day?).round();
        (days < LIFE).then(|| self.date?.checked_add((days as i64).days()).ok()).flatten()
    }

    /// The date at which something befalls a rail, where its growth tells it.
    fn date_of(&self, rail: &RailForecast, passages: f64) -> Option<String> {
        self.months_of(rail, passages)?;
        Some(self.date_after(passages)?.to_string())
    }

    /// The rail that leads: its limit is reached first.
    pub fn leading(&self) -> &RailForecast {
        &self.rails[0]
    }

    /// What a rail is called in sentences on it, where there are several.
    pub fn rail(&self, rail: &RailForecast) -> Option<Message> {
        let name = rail.name().filter(|_| self.names_rails())?;
        Some(rail_in_words(name))
    }

    /// Growth under the traffic, the same for every rail.
    pub fn growth(&self) -> &TrafficGrowth {
        &self.on.growth
    }

    /// Crossings of the limit by a rail, the earliest first.
    fn crossings<'a>(&self, rail: &'a RailForecast) -> Vec<Crossing<'a>> {
        let mut crossings: Vec<Crossing<'a>> = rail
            .forecast
            .reaches(&self.limit)
            .into_iter()
            .filter_map(|(band, limit, reach)| Some(Crossing { band, limit, passages: reach.passages()? }))
            .collect();
        crossings.sort_by(|a, b| {
            let excess = |crossing: &Crossing<'_>| crossing.band.now.level - crossing.limit;
            a.passages.total_cmp(&b.passages).then(excess(b).total_cmp(&excess(a)))
        });
        crossings
    }

    /// Passages until something befalls a rail, in every unit that is known.
    fn amount_of(&self, rail: &RailForecast, passages: f64) -> Message {
        match rail.without_time(&self.on) {
            None => self.amount(passages),
            Some(_) => say!(
                amount_of_traffic,
                passages = words::millions(passages),
                tonnes = number(self.growth().mgt(passages))
            ),
        }
    }

    /// Passages in every unit that is known.
    pub fn amount(&self, passages: f64) -> Message {
        let tonnes = number(self.growth().mgt(passages));
        let months = self.months(passages).map(number);
        let date = self.date_after(passages).map(|date| date.to_string());
        let passages = words::millions(passages);
        match (months, date) {
            (Some(months), Some(date)) => {
                say!(amount_with_date, passages, tonnes, months, date)
            }
            (Some(months), None) => say!(amount_with_months, passages, tonnes, months),
            (None, _) => say!(amount_of_traffic, passages, tonnes),
        }
    }

    /// What a reader sees by band: the rail that leads first and of each the longest wavelength; the name of the rail first, where there
    /// are several.
    pub(crate) fn table(&self) -> Table {
        let rows: Vec<Vec<Message>> = self.rails.iter().flat_map(|rail| self.rows_of(rail)).collect();
        let columns = self.heads().into_iter().enumerate();
        let columns = columns.map(|(place, head)| rows.shown(head, |row| row[place].clone()));
        Table { name: "bands", columns: columns.collect() }
    }

    fn heads(&self) -> Vec<Message> {
        let mut heads = vec![
            say!(wavelength_of_band),
            say!(now_in_decibels),
            say!(then_in_decibels),
            say!(limit_in_decibels),
            say!(decibels_per_million_passages),
            say!(passages_to_limit_head),
            say!(wheel_leaves_the_rail),
        ];
        if self.names_rails() {
            heads.insert(0, say!(rail_word));
        }
        heads
    }

    /// Whether the table by band has a column of rails.
    pub fn names_rails(&self) -> bool {
        self.rails.len() > 1
    }

    fn rows_of(&self, rail: &RailForecast) -> Vec<Vec<Message>> {
        let forecast = &rail.forecast;
        let limits = forecast.reaches(&self.limit);
        let name = rail.name().filter(|_| self.names_rails());
        let row = |band: &ForecastBand| {
            let limit = limits.iter().find(|limit| limit.0 == band);
            let then = forecast.level(band, self.passages);
            let level = |level: f64| number_alone(format_args!("{level:.1}"));
            let nothing = || Message::verbatim("");
            let cells = [
                number_alone(band.now.band.nominal_millimetres()),
                level(band.now.level),
                then.map_or_else(beyond, level),
                limit.map_or_else(nothing, |limit| level(limit.1)),
                self.rate_in_words(rail, band),
                limit.map_or_else(nothing, |limit| reached(limit.2)),
                when(forecast.linear_range([band]).passages),
            ];
            name.map(name_in_words).into_iter().chain(cells).collect()
        };
        forecast.bands().iter().rev().map(row).collect()
    }

    /// Growth of the level of a band \[dB\] with its band of 80 %, or now and then where it falls and then rises.
    fn rate_in_words(&self, rail: &RailForecast, band: &ForecastBand) -> Message {
        let signed = |growth: f64| match growth > 0.0 {
            true => format!("+{}", three_digits(growth)),
            false => three_digits(growth),
        };
        let growth = signed(per_million(rail.forecast.growth_rate(band)));
        // Lines of a band that decays may outgrow it.
        let rises = band.level(self.passages) - band.now.level > RISE_SHOWN;
        if rail.forecast.growth_rate(band) < 0.0 && rises {
            let then = signed(per_million(band.sum.rate(self.passages)));
            return say!(rate_now_and_then, now = numeral(growth), then = numeral(then));
        }
        number_alone(match rail.growth_within(band, self.wear_spread) {
            Some(within) => {
                let [low, high] = within.band_80.map(three_digits);
                format!("{growth} ({low} … {high})")
            }
            None => growth,
        })
    }

    /// The band of the leading rail that grows fastest, with the growth of its level \[dB per million axles\].
    fn fastest(&self) -> Option<(&ForecastBand, f64)> {
        let forecast = &self.leading().forecast;
        let bands = forecast.bands().iter();
        let rates = bands.map(|band| (band, per_million(forecast.growth_rate(band))));
        rates.max_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// Nominal wavelengths of bands of the leading rail that were measured and are not forecast \[mm\], the shortest first.
    pub fn left_out(&self) -> Vec<f64> {
        let rail = self.leading();
        let levels = rail.start.levels.spectrum.levels().iter();
        levels
            .map(|level| level.band)
            .filter(|band| !rail.forecast.bands().iter().any(|own| own.now.band == *band))
            .map(|band| band.nominal_millimetres())
            .collect()
    }
}

/// A sentence on each rail that has no band in the window of the case, beside others that have.
pub(crate) fn not_forecast<'a>(
    measured: &'a [RailStart],
    rails: &'a [RailForecast],
    case: &'a Case,
) -> impl Iterator<Item = Message> + 'a {
    let names = measured.iter().filter_map(|rail| rail.levels.rail.as_deref());
    names.filter(|name| rails.iter().all(|rail| rail.name() != Some(name))).map(|name| {
        say!(
            rail_not_forecast,
            rail = rail_in_words(name),
            from = fixed(1e3 * case.wavelength.min(), 0),
            to = fixed(1e3 * case.wavelength.max(), 0)
        )
    })
}
