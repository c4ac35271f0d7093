//! Rolling noise in a report.

use riffel_case::Case;
use riffel_plot::PlotError;

use super::outlook::{Outlook, drawing};
use super::page::{Section, escape, table};
use crate::capital;
use crate::noise::{NoiseAnswer, Part};

/// Least saving that is told in brief \[dB(A)\]: less is hard to hear.
const WORTH_SAYING: f64 = 1.0;

/// What a train sounds like on the rail as it is, what would make it quieter, and what becomes of it.
pub(super) fn heard(case: &Case, answer: &NoiseAnswer) -> Result<Outlook, PlotError> {
    let train = &answer.request.train;
    let now = answer.levels.a_weighted(Part::Total);
    let speed = 3.6 * answer.request.speed;
    let level = format!(
        "At {speed:.0} km/h a train of {} wheels on each rail, {:.1} m long, is heard at <b>{now:.1} dB(A)</b>, {} m from the middle of the \
         track.",
        train.wheels, train.length, train.distance
    );
    let parts: Vec<String> = [Part::Rail, Part::Sleepers, Part::Wheel]
        .map(|part| {
            let level = answer.levels.a_weighted(part);
            let level = match level.is_finite() {
                true => format!("{level:.1} dB(A)"),
                false => "none".to_owned(),
            };
            format!("{} {level}", part.name())
        })
        .to_vec();
    let rows: Vec<Vec<String>> = answer
        .measures
        .iter()
        .map(|measure| {
            // Not −0.0.
            let saved = (10.0 * measure.saved).round() / 10.0 + 0.0;
            vec![
                escape(&measure.title),
                format!("{:.1}", now - measure.saved),
                format!("{saved:+.1}"),
            ]
        })
        .collect();
    let mut html = format!("<p>{level} Of it: {}.</p>\n", parts.join(", "));
    html += &table("", &["each alone", "dB(A)", "saves dB"], &rows);
    let course = answer
        .course
        .as_ref()
        .map(|course| capital(&course.in_words()) + ".");
    if let Some(course) = &course {
        html += &format!("<p>{}</p>\n", escape(course));
    }
    html += &drawing(answer.figure(case))?;
    let savings: Vec<String> = answer
        .measures
        .iter()
        .filter(|measure| measure.saved >= WORTH_SAYING)
        .map(|measure| format!("{} {:.1} dB", escape(&measure.title), measure.saved))
        .collect();
    let savings = match &savings[..] {
        [] => String::new(),
        savings => format!(" Each alone would save: {}.", savings.join(", ")),
    };
    let mut warnings = answer.remarks.clone();
    warnings.extend(
        answer
            .course
            .iter()
            .flat_map(|course| course.remarks.clone()),
    );
    Ok(Outlook {
        section: Section::There("Rolling noise", html),
        brief: vec![level + &savings]
            .into_iter()
            .chain(course.map(|course| escape(&course)))
            .collect(),
        warnings: warnings
            .into_iter()
            .map(|warning| format!("noise: {warning}"))
            .collect(),
    })
}
