//! How fast the bands of a line are expected to grow under its traffic.

use rayon::prelude::*;
use riffel_case::traffic::{DAYS_PER_YEAR, Traffic, UsualTraffic, bands_of};
use riffel_case::{Case, Variant};

use crate::forecast::per_million;
use crate::{AnswerError, Banded, PosteriorDraws, wear_spread};

/// The same over the draws of a calibration, under its traffic, or else the usual one: in each band medians with bands, none where
/// no draw has a wave there.
///
/// # Errors
/// Those of [`expected_growth`].
pub fn expected_growth_over(
    draws: &PosteriorDraws,
    bands: &[[f64; 2]],
    progress: &(dyn Fn(usize) + Sync),
) -> Result<Vec<Option<Banded>>, AnswerError> {
    let growth = draws.drawn.par_iter().map(|drawn| {
        let growth = expected_growth(&drawn.case, drawn.traffic.as_ref(), bands);
        progress(1);
        growth
    });
    let growth = growth.collect::<Result<Vec<_>, AnswerError>>()?;
    let of_band = |band: usize| {
        let samples = growth
            .iter()
            .filter_map(|growth| Some(growth[band]?.median));
        Banded::of_samples(samples.collect())
    };
    Ok((0..bands.len()).map(of_band).collect())
}

/// Growth of the level \[dB a year\] in bands of wavelength \[m\] under a traffic, or else under the usual one of the line: in each
/// band that of its fastest wave, which the band follows in the end. None where the case has no wave in a band.
///
/// Its band is that of the wear coefficient, none where growth does not go by it; a rate holds while it needs less than the mean
/// wear (`amplitude_limit_m` of a forecast).
///
/// # Errors
/// [`AnswerError::Case`] as of [`Traffic::on`]; [`AnswerError::NoPassagesPerDay`] for a traffic that does not say how much of it
/// there is.
pub fn expected_growth(
    case: &Case,
    traffic: Option<&Traffic>,
    bands: &[[f64; 2]],
) -> Result<Vec<Option<Banded>>, AnswerError> {
    let traffic = match traffic {
        Some(traffic) => traffic,
        None => &UsualTraffic::of(case).traffic()?,
    };
    let case = &case.sharing_parts();
    let on = traffic.on(case, &bands_of(case), &Variant::none(""), &|_| ())?;
    let passages = on
        .passages_in(DAYS_PER_YEAR)
        .ok_or(AnswerError::NoPassagesPerDay)?;
    let spread = wear_spread(case);
    let of_band = |[from, to]: &[f64; 2]| {
        let lines = on.growth.wavelengths().into_iter().zip(on.growth.rates());
        let inside = lines.filter(|(wavelength, _)| (*from..=*to).contains(wavelength));
        let fastest = inside.map(|(_, rate)| *rate).reduce(f64::max)?;
        let median = 1e-6 * passages * per_million(fastest);
        Some(match spread {
            Some(spread) => Banded::by_wear(median, spread),
            None => Banded {
                median,
                band_50: [median; 2],
                band_80: [median; 2],
            },
        })
    };
    Ok(bands.iter().map(of_band).collect())
}
