//! A forecast as data and as tables.

use riffel::forecast::{Forecast, ForecastBand, Reach, TrafficGrowth};
use riffel_case::Case;
use riffel_case::traffic::{SpreadEffect, TrafficFile};
use riffel_keys::{Language, Message, say};
use riffel_plot::LineFigure;
use riffel_rail::LimitTable;
use serde::Serialize;

use super::{CrackedWave, HardenedWave, RailForecast, ReachDocument, TrackForecast, WearReport, per_million};
use crate::answer::inputs;
use crate::roughness::Level;
use crate::{Answer, Banded, Column, Rows, Table, WearLimitDocument, column};

/// The future of the rails of a track, told.
#[derive(Serialize)]
pub struct ForecastAnswer {
    riffel_version: &'static str,
    inputs: Inputs,
    horizon: Amount,
    /// The rail that reaches the limit first, of which all speaks down to `bands_left_out`; null where rails are not
    /// named.
    rail: Option<String>,
    /// Every rail, the one that leads first.
    rails: Vec<RailDocument>,
    spectrum_now: Vec<Level>,
    /// Levels are null where the forecast ends before.
    spectrum_then: Vec<Then>,
    /// Where the forecast ends, for the wheel leaves the rail; null where it never does.
    valid_to_passages: Option<f64>,
    valid_to_mgt: Option<f64>,
    valid_to_months: Option<f64>,
    valid_to_date: Option<String>,
    growth_rate_per_passage: Vec<Rate>,
    /// Change of the rates on halving the step in speed.
    growth_rate_error: f64,
    /// For the fastest line.
    #[serde(flatten)]
    wear_limit: WearLimitDocument,
    /// Change of level of the band that grows fastest, with what the wear coefficient leaves open; null where growth goes by what
    /// was measured.
    growth_db_per_million_axles: Option<Banded>,
    growth_db_per_month: Option<Banded>,
    /// The times to the limit that leave a tenth of what the wear coefficient may be on either side.
    months_to_limit_band_80: Option<[f64; 2]>,
    /// Growth by the model over that of the leading rail as it was measured, within a tenth of the wavelength that grows fastest on it;
    /// null where none was measured.
    model_over_measured: Option<f64>,
    limit: LimitDocument,
    /// Of the first band that reaches the limit: the grinding interval.
    #[serde(flatten)]
    reach: ReachDocument,
    date_of_limit: Option<String>,
    wavelength_of_limit_m: Option<f64>,
    linear_range: LinearDocument,
    bands: Vec<Band>,
    /// Where flow that hardens takes the bands of the leading rail.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    hardening: Vec<HardenedWave>,
    /// Contact fatigue beside wear at the phases of its waves.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    cracks: Vec<CrackedWave>,
    /// Bands that were measured, outside the wavelengths of the case.
    bands_left_out: Vec<Level>,
    traffic: TrafficDocument,
    wear_fit: Option<WearReport>,
    /// That the model does not explain how the leading rail grew, and what follows of it; left out where it does.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    unexplained: Vec<Message>,
    findings: Vec<Message>,
    remarks: Vec<Message>,
    #[serde(skip)]
    forecast: TrackForecast,
}

#[derive(Serialize)]
struct Inputs {
    #[serde(serialize_with = "inputs")]
    case: Case,
    traffic: TrafficFile,
    /// The file, if the rail was measured.
    spectrum: Option<String>,
    records: Option<usize>,
    /// What the rail will be ground to, if that is where the forecast begins.
    ground: Option<Message>,
    date: Option<String>,
}

#[derive(Serialize)]
struct Amount {
    passages: f64,
    mgt: f64,
    months: Option<f64>,
    date: Option<String>,
}

#[derive(Serialize)]
struct Rate {
    wavelength_m: f64,
    growth_rate_per_passage: f64,
}

#[derive(Serialize)]
struct Then {
    wavelength_m: f64,
    level_db: Option<f64>,
}

#[derive(Serialize)]
struct LimitDocument {
    name: String,
    edition: String,
    source: String,
}

#[derive(Serialize)]
struct LinearDocument {
    force_ratio_now: f64,
    passages: Option<f64>,
    mgt: Option<f64>,
    vehicle: String,
}

#[derive(Serialize)]
struct RailDocument {
    rail: Option<String>,
    #[serde(flatten)]
    reach: ReachDocument,
    date_of_limit: Option<String>,
    wavelength_of_limit_m: Option<f64>,
    valid_to_passages: Option<f64>,
    bands: Vec<Band>,
}

#[derive(Serialize)]
struct Band {
    rail: Option<String>,
    wavelength_m: f64,
    level_now_db: f64,
    level_then_db: Option<f64>,
    limit_db: Option<f64>,
    growth_rate_per_passage: f64,
    growth_db_per_million_axles: f64,
    /// Band of 80 %: of the growth that was measured, or else by what the wear coefficient may be; null where it does not go by that.
    growth_db_per_million_axles_low: Option<f64>,
    growth_db_per_million_axles_high: Option<f64>,
    /// Whether growth is that of the rail from date to date, and not that of the model.
    growth_is_measured: bool,
    /// Band of 80 % of the level then; null where growth was not measured.
    level_then_low_db: Option<f64>,
    level_then_high_db: Option<f64>,
    /// Until the rate no longer lasts, for it would need more than the mean wear of the rail; null where it lasts on.
    passages_to_bend: Option<f64>,
    /// after | beyond-linear-range | never; null without a limit.
    limit_reached: Option<&'static str>,
    passages_to_limit: Option<f64>,
    mgt_to_limit: Option<f64>,
    force_ratio_now: f64,
    passages_to_loss_of_contact: Option<f64>,
    /// Whether wheel and rail part before the end of the forecast by this band alone.
    beyond_linear_range: bool,
}

#[derive(Serialize)]
struct TrafficDocument {
    passages_per_day: Option<f64>,
    axle_mass_kg: f64,
    vehicles: Vec<VehicleDocument>,
}

#[derive(Serialize)]
struct VehicleDocument {
    name: String,
    share: f64,
    wheel_load_n: f64,
    mean_speed_m_per_s: f64,
    speed_deviation_m_per_s: f64,
    growth_rate_per_passage: Vec<Rate>,
    /// What each spread over its wheels does to growth.
    spreads: Vec<SpreadDocument>,
}

#[derive(Serialize)]
struct SpreadDocument {
    /// speed | wheel_radius | load | friction | lateral_position, or a key of the case.
    what: String,
    /// The fastest growth with every wheel at the mean of this spread, over that with all of them; null where nothing grows.
    reduction: Option<f64>,
}

impl ForecastAnswer {
    /// What is told of a forecast of the rails of a case; `spectrum` is the name of the record.
    pub fn new(case: &Case, forecast: TrackForecast, spectrum: Option<String>) -> Self {
        let answer = &forecast;
        let rail = answer.leading();
        let of_rail = &rail.forecast;
        let traffic = answer.growth();
        let crossings = answer.crossings(rail);
        let first = crossings.first();
        let now = |band: &ForecastBand| Level { wavelength_m: band.now.band.wavelength(), level_db: band.now.level };
        let then = |band: &ForecastBand| Then {
            wavelength_m: band.now.band.wavelength(),
            level_db: of_rail.level(band, answer.passages),
        };
        let valid_to = of_rail.linear_range(of_rail.bands()).passages;
        let fastest = answer.fastest().and_then(|(band, _)| rail.growth_within(band, answer.wear_spread));
        let banded = |per: f64| fastest.map(|within| within.times(per));
        let millions_a_month = answer.on.passages_per_month().map(|it| 1e-6 * it);
        let millions_a_month = millions_a_month.filter(|_| rail.without_time(&answer.on).is_none());
        let warnings = answer.warnings.iter();
        let mut remarks: Vec<Message> = warnings.cloned().collect();
        remarks.extend(answer.on.remarks.iter().cloned());
        Self {
            riffel_version: env!("CARGO_PKG_VERSION"),
            inputs: Inputs::of(answer, case, spectrum),
            horizon: Amount::of(answer),
            rail: rail.name().map(str::to_owned),
            rails: (answer.rails.iter()).map(|rail| RailDocument::of(answer, rail)).collect(),
            spectrum_now: of_rail.bands().iter().map(now).collect(),
            spectrum_then: of_rail.bands().iter().map(then).collect(),
            valid_to_passages: valid_to,
            valid_to_mgt: valid_to.map(|passages| traffic.mgt(passages)),
            valid_to_months: valid_to.and_then(|passages| answer.months_of(rail, passages)),
            valid_to_date: valid_to.and_then(|passages| answer.date_of(rail, passages)),
            growth_rate_per_passage: rates(of_rail, &|band| of_rail.growth_rate(band)),
            growth_rate_error: traffic.rate_error(),
            wear_limit: WearLimitDocument::under(
                case,
                traffic.mean_wear(),
                answer.on.wear_coefficient,
                traffic.rates().iter().copied().max_by(f64::total_cmp),
            ),
            growth_db_per_million_axles: banded(1.0),
            growth_db_per_month: millions_a_month.and_then(banded),
            months_to_limit_band_80: answer.months_80(),
            model_over_measured: answer.model_beside().map(|(_, ratio)| ratio),
            limit: LimitDocument::of(&answer.table),
            reach: ReachDocument::new(
                Some(of_rail.grinding_interval(&answer.limit).name()),
                first.map(|first| first.passages),
                traffic,
                |passages| answer.months_of(rail, passages),
            ),
            date_of_limit: first.and_then(|first| answer.date_of(rail, first.passages)),
            wavelength_of_limit_m: first.map(|first| first.band.now.band.wavelength()),
            linear_range: LinearDocument::of(of_rail),
            bands: bands(answer, rail),
            hardening: HardenedWave::all(of_rail),
            cracks: answer.cracks(),
            bands_left_out: bands_left_out(rail),
            traffic: TrafficDocument::of(answer, of_rail),
            wear_fit: answer.wear.clone(),
            unexplained: answer.unexplained(),
            findings: answer.findings(),
            remarks,
            forecast,
        }
    }
}

impl Inputs {
    fn of(answer: &TrackForecast, case: &Case, spectrum: Option<String>) -> Self {
        Self {
            case: case.clone(),
            traffic: answer.traffic.file.clone(),
            spectrum: spectrum.filter(|_| answer.ground.is_none()),
            records: answer.survey.as_ref().map(|survey| survey.records.len()),
            ground: answer.ground.as_ref().map(|ground| ground.words.clone()),
            date: answer.date.map(|date| date.to_string()),
        }
    }
}

impl Amount {
    /// Of the whole forecast.
    fn of(answer: &TrackForecast) -> Self {
        let end = answer.date_after(answer.passages);
        Self {
            passages: answer.passages,
            mgt: answer.growth().mgt(answer.passages),
            months: answer.months(answer.passages),
            date: end.map(|date| date.to_string()),
        }
    }
}

impl LimitDocument {
    fn of(table: &LimitTable) -> Self {
        Self { name: table.name.clone(), edition: table.edition.clone(), source: table.source.clone() }
    }
}

impl LinearDocument {
    fn of(forecast: &Forecast) -> Self {
        let linear = forecast.linear_range(forecast.bands());
        let traffic = forecast.traffic();
        Self {
            force_ratio_now: linear.force_ratio,
            passages: linear.passages,
            mgt: linear.passages.map(|passages| traffic.mgt(passages)),
            vehicle: traffic.vehicles()[linear.vehicle].name.clone(),
        }
    }
}

impl TrafficDocument {
    fn of(answer: &TrackForecast, forecast: &Forecast) -> Self {
        let traffic = answer.growth();
        let vehicles = traffic.vehicles().iter().enumerate();
        let vehicles = vehicles.map(|(index, vehicle)| {
            let own = |spread: &&SpreadEffect| spread.vehicle == vehicle.name;
            let spreads = answer.spreads.iter().filter(own);
            VehicleDocument {
                name: vehicle.name.clone(),
                share: vehicle.share,
                wheel_load_n: vehicle.wheel_load,
                mean_speed_m_per_s: vehicle.speeds.mean(),
                speed_deviation_m_per_s: vehicle.speeds.deviation(),
                growth_rate_per_passage: rates(forecast, &|band| forecast.vehicle_rate(band, index)),
                spreads: spreads
                    .map(|spread| SpreadDocument { what: spread.what.clone(), reduction: spread.reduction })
                    .collect(),
            }
        });
        Self {
            passages_per_day: answer.on.passages_per_day,
            axle_mass_kg: traffic.axle_mass(),
            vehicles: vehicles.collect(),
        }
    }
}

impl RailDocument {
    fn of(answer: &TrackForecast, rail: &RailForecast) -> Self {
        let crossings = answer.crossings(rail);
        let first = crossings.first();
        let passages_to_limit = first.map(|first| first.passages);
        Self {
            rail: rail.name().map(str::to_owned),
            reach: ReachDocument::new(rail.reach.map(Reach::name), passages_to_limit, answer.growth(), |passages| {
                answer.months_of(rail, passages)
            }),
            date_of_limit: passages_to_limit.and_then(|it| answer.date_of(rail, it)),
            wavelength_of_limit_m: first.map(|first| first.band.now.band.wavelength()),
            valid_to_passages: rail.forecast.linear_range(rail.forecast.bands()).passages,
            bands: bands(answer, rail),
        }
    }
}

/// A rate of each band.
fn rates(forecast: &Forecast, rate: &dyn Fn(&ForecastBand) -> f64) -> Vec<Rate> {
    let bands = forecast.bands().iter();
    let rates =
        bands.map(|band| Rate { wavelength_m: band.now.band.wavelength(), growth_rate_per_passage: rate(band) });
    rates.collect()
}

/// Levels that were measured on a rail outside the wavelengths of the case.
fn bands_left_out(rail: &RailForecast) -> Vec<Level> {
    let computed = rail.forecast.bands().iter().map(|band| band.now.band);
    let levels = rail.start.levels.spectrum.levels().iter();
    let left_out = levels.filter(|level| !computed.clone().any(|band| band == level.band));
    let left_out = left_out.map(|level| Level { wavelength_m: level.band.wavelength(), level_db: level.level });
    left_out.collect()
}

fn bands(answer: &TrackForecast, rail: &RailForecast) -> Vec<Band> {
    let forecast = &rail.forecast;
    let limits = forecast.reaches(&answer.limit);
    let bands = forecast.bands().iter();
    bands
        .map(|band| {
            let limit = limits.iter().find(|limit| limit.0 == band);
            let passages_to_limit = limit.and_then(|limit| limit.2.passages());
            let linear = forecast.linear_range([band]);
            let growth = per_million(forecast.growth_rate(band));
            let within = rail.growth_within(band, answer.wear_spread);
            let [low, high] = [0, 1].map(|end| within.map(|it| it.band_80[end]));
            let then = rail.level_80(band, answer.passages);
            Band {
                rail: rail.name().map(str::to_owned),
                wavelength_m: band.now.band.wavelength(),
                level_now_db: band.now.level,
                level_then_db: forecast.level(band, answer.passages),
                limit_db: limit.map(|limit| limit.1),
                growth_rate_per_passage: forecast.growth_rate(band),
                growth_db_per_million_axles: growth,
                growth_db_per_million_axles_low: low,
                growth_db_per_million_axles_high: high,
                growth_is_measured: rail.own(band).is_some(),
                level_then_low_db: then.map(|it| it[0]),
                level_then_high_db: then.map(|it| it[1]),
                passages_to_bend: band.bends_after(),
                limit_reached: limit.map(|limit| limit.2.name()),
                passages_to_limit,
                mgt_to_limit: passages_to_limit.map(|passages| forecast.traffic().mgt(passages)),
                force_ratio_now: linear.force_ratio,
                passages_to_loss_of_contact: linear.passages,
                beyond_linear_range: linear.passages.is_some_and(|passages| passages <= answer.passages),
            }
        })
        .collect()
}

/// Growth rate of every line under the mix and under each vehicle.
fn lines(traffic: &TrafficGrowth) -> Table {
    let names = column::names(traffic.vehicles().iter().map(|vehicle| &*vehicle.name), "growth_rate_per_passage");
    let vehicles = names.iter().zip(traffic.vehicles());
    let vehicles = vehicles.map(|(name, vehicle)| vehicle.growth.rates.exact(name, |&value| value));
    let mix = [
        Column::exact("wavelength_m", traffic.wavelengths().iter().copied()),
        Column::exact("growth_rate_per_passage", traffic.rates().iter().copied()),
    ];
    Table { name: "growth", columns: mix.into_iter().chain(vehicles).collect() }
}

impl Answer for ForecastAnswer {
    fn name(&self) -> &'static str {
        "forecast"
    }

    fn introduction(&self) -> Vec<Message> {
        let titled = |title: &Option<String>, otherwise| title.as_deref().map_or(otherwise, Message::verbatim);
        let title = titled(&self.inputs.case.file.title, say!(growth_forecast));
        let traffic = titled(&self.inputs.traffic.title, say!(the_traffic));
        let amount = self.forecast.amount(self.forecast.passages);
        vec![say!(under_title, title, passing = traffic), say!(after_amount, amount)]
    }

    /// One row for each band of every rail, the rail that leads first; then lines, cracks and the fit.
    fn tables(&self) -> Vec<Table> {
        let bands: Vec<&Band> = self.rails.iter().flat_map(|rail| &rail.bands).collect();
        let wear = self.wear_fit.as_ref().map(WearReport::table);
        let files =
            [Table::of_rows("bands", &bands), lines(self.forecast.growth()), Table::of_rows("cracks", &self.cracks)];
        [self.forecast.table()].into_iter().chain(files).chain(wear).collect()
    }

    fn above(&self, table: &str) -> Vec<Message> {
        let wear = self.wear_fit.iter().filter(|_| table == WearReport::TABLE);
        wear.flat_map(|wear| self.findings.iter().cloned().chain([wear.change()])).collect()
    }

    fn sentences(&self) -> Vec<Message> {
        match &self.wear_fit {
            Some(wear) => wear.sentences().into_iter().chain(wear.advice()).collect(),
            None => self.findings.clone(),
        }
    }

    fn figure(&self) -> LineFigure {
        self.forecast.figure(&self.inputs.case, Language::English)
    }

    fn remarks(&self) -> &[Message] {
        &self.remarks
    }
}
