//! Rolling noise in a report.

use riffel::noise::Part;
use riffel_keys::Language;
use riffel_plot::PlotError;

use super::outlook::{Outlook, drawing};
use super::page::{Section, escape, table};
use crate::noise::{NoiseAnswer, name_of};
use crate::{Answer, capital};

/// Least saving that is told in brief \[dB(A)\]: less is hard to hear.
const WORTH_SAYING: f64 = 1.0;

/// What a train sounds like on the rail as it is, what would make it quieter, and what becomes of it.
pub(super) fn heard(answer: &NoiseAnswer) -> Result<Outlook, PlotError> {
    let decibels = |level: Option<f64>| {
        level.map_or_else(|| "none".to_owned(), |level| format!("{level:.1} dB(A)"))
    };
    let level = format!(
        "At {:.0} km/h a train of {} wheels on each rail, {:.1} m long, is heard at <b>{}</b>, {} m from the middle of the \
         track.",
        3.6 * answer.speed_m_per_s,
        answer.wheels,
        answer.train_length_m,
        decibels(answer.level.total_dba),
        answer.distance_m
    );
    let parts = [Part::Rail, Part::Sleepers, Part::Wheel].map(|part| {
        let (_, level) = answer.level.of(part);
        format!("{} {}", name_of(part), decibels(level))
    });
    let mut html = format!("<p>{level} Of it: {}.</p>\n", parts.join(", "));
    let (heads, rows) = answer.measures_table().shown(Language::English);
    let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
    let rows: Vec<Vec<String>> = rows
        .into_iter()
        .map(|row| row.iter().map(|cell| escape(cell)).collect())
        .collect();
    html += &table("", &heads, &rows);
    let course = answer
        .course
        .as_ref()
        .map(|course| capital(&course.in_words().to_string()) + ".");
    if let Some(course) = &course {
        html += &format!("<p>{}</p>\n", escape(course));
    }
    html += &drawing(answer.figure())?;
    let savings: Vec<String> = answer
        .measures
        .iter()
        .filter(|measure| measure.saved_db >= WORTH_SAYING)
        .map(|measure| {
            format!(
                "{} {:.1} dB",
                escape(&measure.title.to_string()),
                measure.saved_db
            )
        })
        .collect();
    let savings = match &savings[..] {
        [] => String::new(),
        savings => format!(" Each alone would save: {}.", savings.join(", ")),
    };
    let over = answer.over_posterior_in_words();
    // In brief the level is enough.
    let over = over.iter().take(1);
    let over = over.map(|it| format!("{}.", escape(&capital(&it.to_string()))));
    Ok(Outlook {
        section: Section::There("Rolling noise", html),
        brief: vec![level + &savings]
            .into_iter()
            .chain(course.map(|course| escape(&course)))
            .chain(over)
            .collect(),
        warnings: answer
            .remarks
            .iter()
            .map(|warning| format!("noise: {warning}"))
            .collect(),
    })
}
