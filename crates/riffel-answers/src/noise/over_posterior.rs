//! What draws of a calibration say of rolling noise.

use riffel_keys::{Message, say};

use super::NoiseAnswer;

/// The level and what each measure saves, with bands.
pub(super) fn in_words(answer: &NoiseAnswer) -> Vec<Message> {
    let Some(over) = &answer.over_posterior else {
        return Vec::new();
    };
    let level = over.number("level.total_dba");
    let level = level.map(|level| say!(level_over_posterior, draws = over.draws, level = level.times(1.0, 1)));
    let measures = answer.measures.iter().enumerate();
    let measures = measures.filter_map(|(place, measure)| {
        let title = measure.title.to_string();
        let saved = over.number_of("measures", &title, place, "saved_db")?;
        if !saved.varies() {
            return None;
        }
        Some(say!(measure_over_posterior, measure = measure.title.clone(), saved = saved.times(1.0, 1)))
    });
    level.into_iter().chain(measures).collect()
}
