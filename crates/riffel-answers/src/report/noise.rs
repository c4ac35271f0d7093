//! Rolling noise in a report.

use riffel_case::Case;
use riffel_keys::{Language, Message, Value, fixed, number, say, shown_speed};
use riffel_noise::Part;
use riffel_plot::PlotError;

use super::outlook::{Outlook, drawing};
use super::page::{Section, bold, sentence, table_of};
use crate::noise::{NoiseAnswer, at_least, name_of};

/// Least saving that is told in brief \[dB(A)\]: less is hard to hear.
const WORTH_SAYING: f64 = 1.0;

/// What a train sounds like on the rail as it is, what would make it quieter, and what becomes of it.
pub(super) fn outlook(case: &Case, answer: &NoiseAnswer, language: Language) -> Result<Outlook, PlotError> {
    let decibels = |level: Option<f64>| match level {
        Some(level) => at_least(level, answer.lower_bound_up_to_hz),
        None => say!(no_level),
    };
    let total = decibels(answer.level.total_dba);
    let message = say!(
        train_is_heard,
        speed = shown_speed(answer.speed_m_per_s, 0),
        wheels = number(answer.wheels),
        length = fixed(answer.train_length_m, 1),
        level = total.clone(),
        distance = number(answer.distance_m)
    );
    let level = bold(&sentence(&message, language), &total.text(language));
    let parts = [Part::Rail, Part::Sleepers, Part::Wheel].map(|part| {
        let (_, level) = answer.level.of(part);
        say!(part_and_level, part = name_of(part), level = decibels(level))
    });
    let parts: Value = parts.into_iter().collect();
    let parts = sentence(&say!(level_is_of, parts), language);
    let mut html = format!("<p>{level} {parts}</p>\n");
    html += &table_of(&answer.measures_table(), language);
    let course = answer.course.as_ref();
    let course = course.map(|course| sentence(&course.in_words(answer.lower_bound_up_to_hz), language));
    if let Some(course) = &course {
        html += &format!("<p>{course}</p>\n");
    }
    html += &drawing(answer.figure_of(case, language), language)?;
    let savings = answer.measures.iter();
    let savings: Vec<Message> = savings
        .filter(|measure| measure.saved_db >= WORTH_SAYING)
        .map(|measure| {
            let saved = fixed(measure.saved_db, 1);
            say!(measure_saves, title = measure.title.clone(), saved)
        })
        .collect();
    let savings = match savings.is_empty() {
        true => String::new(),
        false => {
            let savings: Value = savings.into_iter().collect();
            format!(" {}", sentence(&say!(each_alone_would_save, savings), language))
        }
    };
    let over = answer.over_posterior_in_words();
    // In brief the level is enough.
    let over = over.iter().take(1).map(|it| sentence(it, language));
    Ok(Outlook {
        section: Section::There(say!(rolling_noise), html),
        brief: std::iter::once(level + &savings).chain(course).chain(over).collect(),
        warnings: answer.remarks.iter().map(|warning| warning.clone().about(say!(noise))).collect(),
    })
}
