//! Variants over the draws of a calibration.

use riffel_case::traffic::Traffic;
use riffel_keys::{Message, fixed, say};

use super::{CompareAnswer, CompareRequest};
use crate::{OverPosterior, PosteriorDraws, Result};

/// Every variant in every draw, under the traffic of the calibration, or else that of the request.
///
/// # Errors
/// Errors of [`CompareAnswer::new`].
pub fn compare_over(
    draws: &PosteriorDraws,
    request: &CompareRequest,
    progress: &(dyn Fn(usize) + Sync),
) -> Result<OverPosterior> {
    draws.over(progress, |drawn| {
        let request = CompareRequest {
            traffic: drawn.traffic.as_ref().map_or_else(|| request.traffic.clone(), Traffic::clone),
            ..request.clone()
        };
        CompareAnswer::new(&drawn.case, request, &|_| ())
    })
}

/// Sentences on each variant over the draws.
pub(super) fn in_words(answer: &CompareAnswer, over: &OverPosterior) -> Vec<Message> {
    let mut sentences = Vec::new();
    for (place, outcome) in answer.comparison.outcomes.iter().enumerate() {
        let number = |name: &str| over.number_of("outcomes", &outcome.title, place, name);
        if let (1.., Some(change)) = (place, number("change_of_fastest_growth")) {
            sentences.push(say!(
                variant_over_posterior,
                title = &outcome.title,
                draws = over.draws,
                change = change.times(100.0, 0),
                share = fixed(100.0 * change.share_below(0.0), 0)
            ));
        }
        if let Some(months) = number("months_to_limit") {
            sentences.push(say!(variant_months_over_posterior, title = &outcome.title, months = months.times(1.0, 1)));
        }
    }
    sentences
}
