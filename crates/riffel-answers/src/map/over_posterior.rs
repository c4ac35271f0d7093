//! Growth under the traffic of a line over the draws of a calibration.

use riffel_keys::{Message, fixed, say, significant};
use serde::Serialize;

use crate::line_growth::time_between;
use crate::{LineGrowth, OverPosterior, PosteriorDraws, Result};

#[derive(Serialize)]
struct Document {
    under_traffic: LineGrowth,
}

/// What grows fastest in each draw, under the traffic of the calibration, or else the usual one of the line.
///
/// # Errors
/// [`AnswerError::Case`](crate::AnswerError::Case) as of [`LineGrowth::new`].
pub fn growth_over(draws: &PosteriorDraws, progress: &(dyn Fn(usize) + Sync)) -> Result<OverPosterior> {
    draws.over(progress, |drawn| {
        let under_traffic = LineGrowth::new(&drawn.case, drawn.traffic.as_ref())?;
        Ok(Document { under_traffic })
    })
}

/// Sentences on the growth over the draws.
pub fn growth_in_words(growth: &OverPosterior) -> Vec<Message> {
    let number = |name: &str| growth.number(&format!("under_traffic.fastest.{name}"));
    let rate = number("growth_rate_per_passage");
    let grows = rate.map_or(0.0, |rate| rate.draws as f64 / growth.draws as f64);
    let mut sentences = Vec::new();
    if let (Some(wavelength), Some(passages)) = (number("wavelength_m"), number("doubling_passages")) {
        let millimetres = |metres: f64| significant(1e3 * metres, 2);
        let [shortest, longest] = wavelength.band_90.map(millimetres);
        // Draws that grow faster than any railway known have no months: then axles are told.
        let all = rate.map(|rate| rate.draws);
        let months = number("doubling_months").filter(|months| Some(months.draws) == all);
        let time = match months {
            Some(months) => time_between(months.band_90),
            None => {
                let [early, late] = passages.band_90.map(|it| significant(1e-6 * it, 2));
                say!(million_axles_between, early, late)
            }
        };
        sentences.push(say!(
            growth_over_posterior,
            draws = growth.draws,
            wavelength = millimetres(wavelength.median),
            shortest,
            longest,
            time
        ));
    }
    if grows < 1.0 {
        sentences.push(say!(no_growth_in_draws, share = fixed(100.0 * (1.0 - grows), 0)));
    }
    sentences
}
