//! The wear coefficient of two measurements of a rail, in words and as data.

use riffel::forecast::{FittedBand, LARGE_CHANGE, WearFit, WearSpread, WearVerdict};
use riffel::roughness::LevelLimit;
use riffel_case::Case;
use riffel_case::traffic::TrafficOnCase;
use riffel_keys::{CaseError, Message, Value, fixed, number, say};
use riffel_rail::{RailDates, Survey, rail_in_words};
use serde::{Serialize, Serializer};

use super::words::millions;
use super::{RailForecast, RailStart, number_alone};
use crate::{Rows, Table};

/// Days of a year.
const YEAR: f64 = 365.25;

/// A fit with what it was made of.
#[derive(Clone)]
pub struct WearReport {
    /// The fit.
    pub fit: WearFit,
    /// Axle passages between the measurements.
    pub passages: f64,
    /// Wear coefficient of the case that the fit began with \[kg/J\].
    coefficient: f64,
    /// Days between them, where the traffic says how much of it there is.
    days: Option<f64>,
    /// Records of the earlier measurement and of the later.
    pub records: [usize; 2],
    /// What was put right in the records, and what was left out of them.
    remarks: Vec<Message>,
}

/// What is told of a fit.
#[derive(Serialize)]
struct WearDocument {
    passages_between: f64,
    records_earlier: usize,
    records_later: usize,
    paired: bool,
    /// fitted | without-interval | indistinct | against | nothing-grows | unexplained
    verdict: &'static str,
    /// Null where no fit is claimed.
    coefficient_kg_per_j: Option<f64>,
    coefficient_interval_kg_per_j: Option<[f64; 2]>,
    best_factor: f64,
    best_factor_interval: Option<[f64; 2]>,
    residual_rms_db: Option<f64>,
    bands: Vec<WearBand>,
    sentences: Vec<Message>,
    /// What was put right in the records, and what was left out of them.
    remarks: Vec<Message>,
}

#[derive(Serialize)]
struct WearBand {
    wavelength_m: f64,
    measured_change_db: f64,
    measured_change_interval_db: Option<[f64; 2]>,
    predicted_change_db: f64,
    fitted_change_db: Option<f64>,
    residual_db: Option<f64>,
    grows_in_the_model: bool,
}

fn scientific(value: f64) -> Value {
    number(format_args!("{value:.2e}"))
}

/// The remarks on the records of a file, with its name.
fn remarks_of(survey: &Survey) -> impl Iterator<Item = Message> {
    let warnings = survey.warnings.iter().cloned();
    warnings.map(|warning| warning.about(survey.path().display()))
}

/// The rail that a fit is of, where several were measured and each grows differently: that of which the case is, else the one that leads.
fn rail_to_fit(case: &Case, now: &Survey, on: &TrafficOnCase, limit: Option<&LevelLimit>) -> Option<String> {
    let starts = RailStart::of(&case.rail_in_curve(), Some(now), None, on.passages_per_day);
    let rails = RailForecast::of_rails(&starts, on, limit).ok()?;
    let of_case = rails.iter().find(|rail| rail.start.is_of_case);
    of_case.or(rails.first())?.name().map(str::to_owned)
}

impl WearReport {
    /// The fit of how one rail has changed in so many passages since its oldest record, place by place where both are profiles: of
    /// several rails that of the case, or else the one that leads under a limit. It begins where that rail was last ground.
    ///
    /// # Errors
    /// Errors of [`new`](Self::new).
    pub fn since(
        oldest: &Survey,
        places: Option<&[Survey; 2]>,
        now: &Survey,
        (case, on): (&Case, &TrafficOnCase),
        limit: Option<&LevelLimit>,
        passages: f64,
    ) -> Result<Self, CaseError> {
        let rail = rail_to_fit(case, now, on, limit);
        let rail = rail.as_deref();
        let history = now.clone().of_rail(rail).and_then(|own| own.history);
        if let Some((share, earlier)) = history.as_ref().and_then(RailDates::since_ground) {
            return Self::new(on, rail, earlier, now, share * passages);
        }
        let [earlier, now] = places.map_or([oldest, now], |[oldest, now]| [oldest, now]);
        Self::new(on, rail, earlier, now, passages)
    }

    /// The fit of the change of a rail from one measurement to a later one by the growth of a case under traffic; of all records without
    /// the name of a rail.
    ///
    /// # Errors
    /// [`CaseError::Data`] for a rail that was not measured before, passages not above zero, or measurements without a band that the case
    /// speaks of.
    pub fn new(
        on: &TrafficOnCase,
        rail: Option<&str>,
        earlier: &Survey,
        later: &Survey,
        passages: f64,
    ) -> Result<Self, CaseError> {
        let of_one = rail.filter(|_| later.rails().len() > 1);
        let chosen = |survey: &Survey| {
            let found = survey.clone().of_rail(rail);
            found.ok_or_else(|| {
                let rail = rail_in_words(rail.unwrap_or_default());
                CaseError::data(survey.path(), say!(rail_is_not_measured, rail))
            })
        };
        let (earlier, later) = (&chosen(earlier)?, &chosen(later)?);
        let wrong = |error: riffel::Error| CaseError::data(later.path(), error.to_string());
        let change = later.change_since(earlier, passages).map_err(wrong)?;
        Ok(Self {
            fit: WearFit::new(&change, &on.growth).map_err(wrong)?,
            passages,
            days: on.passages_per_day.map(|per_day| passages / per_day),
            coefficient: on.wear_coefficient,
            records: [earlier.records.len(), later.records.len()],
            remarks: (of_one.map(|rail| say!(fit_of_one_rail, rail = rail_in_words(rail))))
                .into_iter()
                .chain([earlier, later].into_iter().flat_map(remarks_of))
                .collect(),
        })
    }

    /// The wear coefficient of this rail \[kg/J\], where its interval lies above zero.
    pub fn fitted_coefficient(&self) -> Option<f64> {
        let is_sure = self.fit.verdict == WearVerdict::Fitted;
        is_sure.then_some(self.fit.factor * self.coefficient)
    }

    /// How well the coefficient of this rail is known, where its interval lies above zero.
    pub fn spread(&self) -> Option<WearSpread> {
        self.fitted_coefficient()?;
        WearSpread::of_interval(self.fit.interval?)
    }

    /// That the model does not explain the growth that was measured, where it does not.
    pub(super) fn unexplained(&self) -> Option<Message> {
        (self.fit.verdict == WearVerdict::Unexplained).then(|| self.unexplained_bands())
    }

    /// The sentences where a forecast goes by the coefficient that was fitted, if it is sure.
    pub fn sentences_of_forecast(&self, case: &Case) -> Vec<Message> {
        let mut sentences = self.sentences();
        // To the digits to which it was taken.
        let taken = |fitted: &f64| (case.file.wear.coefficient.si() / fitted - 1.0).abs() < 1e-3;
        let fitted = self.fitted_coefficient().filter(taken);
        if let (Some(coefficient), Some(bounds)) = (fitted, self.fit.interval) {
            sentences[0] = say!(
                growth_goes_by_this_rail,
                coefficient = scientific(coefficient),
                interval = self.interval(bounds),
                passages = millions(self.passages),
                given = scientific(self.coefficient)
            );
        }
        sentences
    }

    /// Bounds of a factor as words on the coefficient.
    fn interval(&self, (low, high): (f64, f64)) -> Message {
        let [low, high] = [low, high].map(|factor| scientific(factor * self.coefficient));
        say!(interval_of_coefficient, low, high)
    }

    /// Whether a band that should grow has changed by as much as levels are printed to.
    fn moves(&self) -> bool {
        let bands = self.fit.bands.iter();
        bands.filter(|band| band.grows).any(|band| band.measured.abs() >= 0.05)
    }

    /// The bands whose growth the model does not explain.
    fn unexplained_bands(&self) -> Message {
        let bands = || self.fit.bands.iter().filter(|band| band.is_unexplained());
        let wavelengths = bands().map(|band| band.band.nominal_millimetres().to_string());
        let wavelengths: Vec<String> = wavelengths.collect();
        let most = bands().max_by(|a, b| a.residual().total_cmp(&b.residual()));
        let (measured, fitted) = most.map_or((0.0, 0.0), |band| (band.measured, band.fitted));
        say!(
            growth_unexplained,
            wavelengths = wavelengths.join(", "),
            measured = fixed(measured, 1),
            fitted = fixed(fitted, 1),
        )
    }

    /// How fast each band that has grown does so.
    fn measured_rates(&self) -> impl Iterator<Item = Message> {
        let bands = self.fit.bands.iter().filter(|band| band.has_grown());
        let per_million = 1e6 / self.passages;
        bands.map(move |band: &FittedBand| {
            let wavelength = number(band.band.nominal_millimetres());
            let yearly = self.days.map(|days| YEAR / days);
            let rate = yearly.unwrap_or(per_million);
            let value = |change: f64| fixed(rate * change, 1);
            let measured = value(band.measured);
            match (yearly.is_some(), band.interval) {
                (true, Some((low, high))) => {
                    say!(grew_in_a_year_within, wavelength, rate = measured, low = value(low), high = value(high))
                }
                (true, None) => {
                    say!(grew_in_a_year, wavelength, rate = measured)
                }
                (false, Some((low, high))) => {
                    say!(grew_in_a_million_within, wavelength, rate = measured, low = value(low), high = value(high))
                }
                (false, None) => {
                    say!(grew_in_a_million, wavelength, rate = measured)
                }
            }
        })
    }

    /// What the fit says, and what it says of single bands.
    pub fn sentences(&self) -> Vec<Message> {
        let fit = &self.fit;
        let coefficient = fit.factor * self.coefficient;
        let mut sentences = vec![match (fit.verdict, fit.interval) {
            (WearVerdict::Fitted, Some(bounds)) => {
                say!(coefficient_is_fitted, coefficient = scientific(coefficient), interval = self.interval(bounds))
            }
            (WearVerdict::Unexplained, _) => self.unexplained_bands(),
            (WearVerdict::NothingGrows, _) => say!(no_coefficient_nothing_grows),
            (WearVerdict::Against, _) => say!(no_coefficient_bands_fell),
            (WearVerdict::Indistinct, _) if !self.moves() => say!(no_coefficient_nothing_moved),
            (WearVerdict::Indistinct, Some(bounds)) => {
                say!(no_coefficient_indistinct, interval = self.interval(bounds))
            }
            (WearVerdict::Indistinct, None) => say!(no_coefficient_not_grown),
            _ => say!(no_coefficient_claimed, coefficient = scientific(coefficient)),
        }];
        if fit.verdict == WearVerdict::Unexplained {
            sentences.extend(self.measured_rates());
        }
        for band in &fit.bands {
            let signed = |change: f64| number(format_args!("{change:+.1}"));
            let wavelength = band.band.nominal_millimetres();
            let (measured, predicted) = (signed(band.measured), signed(band.predicted));
            if band.grows && band.has_fallen() {
                sentences.push(say!(band_fades_against_model, wavelength, measured, predicted));
            } else if !band.grows && band.predicted < 0.0 && band.has_grown() {
                sentences.push(say!(band_grows_against_model, wavelength, measured, predicted));
            } else if !band.grows && band.predicted < 0.0 && band.measured < -LARGE_CHANGE && band.has_fallen() {
                sentences.push(say!(band_fades_as_in_model, wavelength, measured, predicted));
            } else if band.grows && fit.verdict.is_fit() && band.residual().abs() > LARGE_CHANGE {
                sentences.push(say!(band_grows_unlike_fit, wavelength, measured, fitted = signed(band.fitted)));
            }
        }
        sentences
    }

    /// How to forecast with the coefficient on a command line, where there is one.
    pub fn advice(&self) -> Option<Message> {
        let coefficient = self.fitted_coefficient()?;
        Some(say!(forecast_with_coefficient, value = format!("{coefficient:.3e}")))
    }

    /// Its table.
    pub(super) const TABLE: &'static str = "wear";

    /// Between which records it is, before its table.
    pub(super) fn change(&self) -> Message {
        let [earlier, later] = self.records;
        let passages = scientific(self.passages);
        match self.fit.paired {
            true => say!(change_between_paired_records, passages, earlier, later),
            false => say!(change_between_records, passages, earlier, later),
        }
    }

    /// What a reader sees by band, the longest first.
    pub(super) fn table(&self) -> Table {
        let bands: Vec<&FittedBand> = self.fit.bands.iter().rev().collect();
        let decibels = |value: f64| number_alone(format_args!("{value:+.1}"));
        let fitted = |value: f64| match self.fit.verdict.is_fit() {
            true => decibels(value),
            false => Message::verbatim(""),
        };
        Table {
            name: Self::TABLE,
            columns: vec![
                bands.numbers(say!(wavelength_of_band), |band| band.band.nominal_millimetres()),
                bands.shown(say!(measured_in_decibels), |band| decibels(band.measured)),
                bands.shown(say!(model_in_decibels), |band| decibels(band.predicted)),
                bands.shown(say!(fitted_in_decibels), |band| fitted(band.fitted)),
                bands.shown(say!(residual_in_decibels), |band| fitted(band.residual())),
                bands.shown(Message::verbatim(""), |band| match (band.grows, band.predicted > 0.0) {
                    (true, _) => Message::verbatim(""),
                    (false, false) => say!(decays_in_the_model),
                    (false, true) => say!(decays_at_first_in_the_model),
                }),
            ],
        }
    }
}

impl Serialize for WearReport {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let fit = &self.fit;
        let claimed = fit.verdict.is_fit();
        let scaled = |(low, high): (f64, f64), by: f64| [low * by, high * by];
        let told = WearDocument {
            passages_between: self.passages,
            records_earlier: self.records[0],
            records_later: self.records[1],
            paired: fit.paired,
            verdict: match fit.verdict {
                WearVerdict::NothingGrows => "nothing-grows",
                WearVerdict::Against => "against",
                WearVerdict::Indistinct => "indistinct",
                WearVerdict::WithoutInterval => "without-interval",
                WearVerdict::Fitted => "fitted",
                WearVerdict::Unexplained => "unexplained",
            },
            coefficient_kg_per_j: claimed.then_some(fit.factor * self.coefficient),
            coefficient_interval_kg_per_j: fit
                .interval
                .filter(|_| claimed)
                .map(|interval| scaled(interval, self.coefficient)),
            best_factor: fit.factor,
            best_factor_interval: fit.interval.map(|interval| scaled(interval, 1.0)),
            residual_rms_db: fit.residual_rms().filter(|_| claimed),
            bands: fit
                .bands
                .iter()
                .map(|band| WearBand {
                    wavelength_m: band.band.wavelength(),
                    measured_change_db: band.measured,
                    measured_change_interval_db: band.interval.map(|interval| scaled(interval, 1.0)),
                    predicted_change_db: band.predicted,
                    fitted_change_db: claimed.then_some(band.fitted),
                    residual_db: claimed.then(|| band.residual()),
                    grows_in_the_model: band.grows,
                })
                .collect(),
            sentences: self.sentences(),
            remarks: self.remarks.clone(),
        };
        told.serialize(serializer)
    }
}
