//! How fast the bands of a line are expected to grow under its traffic.

use rayon::prelude::*;
use riffel_case::traffic::{DAYS_PER_YEAR, Traffic, UsualTraffic, bands_of};
use riffel_case::{Case, Variant};
use riffel_keys::Message;

use crate::forecast::{per_million, rates_without_time};
use crate::{AnswerError, Banded, PosteriorDraws, Result, wear_spread};

/// Growth of the level that a traffic is expected to make.
#[derive(Debug, Clone, PartialEq)]
pub struct ExpectedRates {
    /// In each band \[dB a year\]; `None` if the case has no wave in it, or its rate means nothing.
    pub of_bands: Vec<Option<Banded>>,
    /// Why rates mean nothing, if some do.
    pub without_rate: Option<Message>,
}

impl ExpectedRates {
    /// Medians with bands over the draws of a calibration that have a rate in a band, under its traffic, or else the usual one.
    ///
    /// # Errors
    /// Errors of [`new`](Self::new).
    pub fn over(draws: &PosteriorDraws, bands: &[[f64; 2]], progress: &(dyn Fn(usize) + Sync)) -> Result<Self> {
        let growth = draws.drawn.par_iter().map(|drawn| {
            let growth = Self::new(&drawn.case, drawn.traffic.as_ref(), bands);
            progress(1);
            growth
        });
        let growth = growth.collect::<Result<Vec<_>>>()?;
        let of_band = |band: usize| {
            let samples = growth.iter().filter_map(|growth| Some(growth.of_bands[band]?.median));
            Banded::of_samples(samples.collect())
        };
        Ok(Self {
            of_bands: (0..bands.len()).map(of_band).collect(),
            without_rate: growth.iter().find_map(|growth| growth.without_rate.clone()),
        })
    }

    /// Growth in bands of wavelength \[m\] under a traffic, or else under the usual one of the line: in each band that of its fastest
    /// wave, which the band follows in the end.
    ///
    /// Its band is that of the wear coefficient, null if growth does not go by it; a rate holds while it needs less than the mean
    /// wear (`amplitude_limit_m` of a forecast).
    ///
    /// # Errors
    /// [`AnswerError::Case`] as of [`Traffic::on`]; [`AnswerError::NoPassagesPerDay`] for a traffic that does not say how much of it
    /// there is.
    pub fn new(case: &Case, traffic: Option<&Traffic>, bands: &[[f64; 2]]) -> Result<Self> {
        let traffic = match traffic {
            Some(traffic) => traffic,
            None => &UsualTraffic::of(case).traffic()?,
        };
        let case = &case.sharing_parts();
        let on = traffic.on(case, &bands_of(case), &Variant::none(""), &|_| ())?;
        let passages = on.passages_in(DAYS_PER_YEAR).ok_or(AnswerError::NoPassagesPerDay)?;
        let spread = wear_spread(case);
        let rate = |[from, to]: &[f64; 2]| {
            let lines = on.growth.wavelengths().into_iter().zip(on.growth.rates());
            let inside = lines.filter(|(wavelength, _)| (*from..=*to).contains(wavelength));
            inside.map(|(_, rate)| *rate).reduce(f64::max)
        };
        let banded = |rate: f64| {
            let median = 1e-6 * passages * per_million(rate);
            match spread {
                Some(spread) => Banded::by_wear(median, spread),
                None => Banded { median, band_50: [median; 2], band_80: [median; 2] },
            }
        };
        let told = |rate: &f64| rates_without_time(&on, [*rate].into_iter()).is_none();
        let rates: Vec<Option<f64>> = bands.iter().map(rate).collect();
        Ok(Self {
            of_bands: (rates.iter()).map(|rate| rate.filter(told).map(banded)).collect(),
            without_rate: rates_without_time(&on, rates.into_iter().flatten()),
        })
    }
}
