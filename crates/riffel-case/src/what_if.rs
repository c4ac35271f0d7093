//! What would help: one traffic on a case and on variants of it, side by side.

use riffel::forecast::{Forecast, TrafficGrowth};
use riffel::roughness::{LevelLimit, Spectrum, ThirdOctave};
use riffel::{Ridge, RidgePoint};

use crate::traffic::{Traffic, bands_of};
use crate::{Case, CaseError, Variant};

/// Growth under one traffic, as it is and as each variant makes it.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// The bands.
    pub bands: Vec<ThirdOctave>,
    /// The case as it is, then the variants in their order.
    pub outcomes: Vec<Outcome>,
}

/// What a variant does.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// Its title.
    pub title: String,
    /// Growth by vehicle and line.
    pub growth: TrafficGrowth,
    /// Axle passages a day, if known.
    pub passages_per_day: Option<f64>,
    /// The line of highest growth.
    pub fastest: FastestLine,
    /// Frequency \[Hz\] that the strongest branch of the ridge follows, for the wheel of the case over the speeds of
    /// its map; none where nothing grows.
    pub ridge_frequency: Option<f64>,
    /// Where that ridge is highest.
    pub ridge_highest: Option<RidgePoint>,
    /// The spectrum under this traffic, if one was given.
    pub forecast: Option<Forecast>,
    /// Axle passages to the limit; none where it is never reached, or nothing was given.
    pub passages_to_limit: Option<f64>,
    /// What the reader should know about the validity of the models.
    pub remarks: Vec<String>,
}

/// The wavelength that grows fastest under the traffic.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FastestLine {
    /// Its wavelength \[m\], one of the lines: to 1.5 %.
    pub wavelength: f64,
    /// Its growth rate per axle passage \[-\]; below zero where nothing grows.
    pub rate: f64,
    /// It is the first or the last line: a shorter or longer wavelength may grow faster.
    pub at_edge: bool,
}

impl Comparison {
    /// Compute the case and its variants under the traffic, with the levels of a spectrum and a limit if
    /// there are any. `progress` is told of each vehicle of each outcome.
    ///
    /// # Errors
    /// [`CaseError`] with the key of the file that is at fault.
    pub fn compute(
        case: &Case,
        variants: &[Variant],
        traffic: &Traffic,
        spectrum: Option<&Spectrum>,
        limit: Option<&LevelLimit>,
        progress: &(dyn Fn(usize) + Sync),
    ) -> Result<Self, CaseError> {
        let bands = bands_of(case);
        let as_it_is = Variant::none("as it is");
        let mut outcomes = Vec::new();
        for variant in std::iter::once(&as_it_is).chain(variants) {
            let on = traffic.on(case, &bands, variant, progress)?;
            let changed = case
                .with(&[&variant.overrides])
                .map_err(|error| variant.explain(error))?;
            let ridge = Ridge::search(&changed.feedback, changed.wavelength, changed.speed);
            let forecast = spectrum
                .map(|spectrum| Forecast::new(spectrum, on.growth.clone()))
                .transpose()
                .map_err(|error| CaseError::data("spectrum", error.to_string()))?;
            let passages_to_limit = forecast
                .as_ref()
                .zip(limit)
                .and_then(|(forecast, limit)| forecast.grinding_interval(limit));
            outcomes.push(Outcome {
                title: variant.title.clone(),
                fastest: FastestLine::of(&on.growth),
                ridge_frequency: ridge.best_fit_frequency(),
                ridge_highest: ridge.highest().copied(),
                passages_per_day: on.passages_per_day,
                growth: on.growth,
                forecast,
                passages_to_limit,
                remarks: on.remarks,
            });
        }
        Ok(Self { bands, outcomes })
    }

    /// The case as it is.
    pub fn base(&self) -> &Outcome {
        &self.outcomes[0]
    }
}

impl FastestLine {
    fn of(growth: &TrafficGrowth) -> Self {
        let (wavelengths, rates) = (growth.wavelengths(), growth.rates());
        // Every traffic has a line.
        let place = (0..rates.len())
            .max_by(|&a, &b| rates[a].total_cmp(&rates[b]))
            .unwrap_or(0);
        Self {
            wavelength: wavelengths[place],
            rate: rates[place],
            at_edge: place == 0 || place + 1 == rates.len(),
        }
    }
}
