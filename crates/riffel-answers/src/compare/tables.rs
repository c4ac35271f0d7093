//! A comparison as tables.

use riffel::roughness::ThirdOctave;
use riffel_keys::{Message, say};
use riffel_rail::name_in_words;

use super::{CompareAnswer, Effect, Outcome, held_in_words, title_of};
use crate::forecast::{RailForecast, number_alone, per_million, reached, three_digits};
use crate::{Column, Rows, Table, column};

/// Growth of the bands.
pub(super) const BANDS: &str = "bands";

/// One row for each outcome, with what is known of some.
pub(crate) fn outcomes(answer: &CompareAnswer) -> Table {
    let nothing = || Message::verbatim("");
    let cell = |cell: Option<Message>| cell.unwrap_or_else(nothing);
    let outcomes = &answer.comparison.outcomes;
    let told = |head: Message, of: &dyn Fn(&Outcome) -> Message| {
        outcomes.shown(head, |outcome| if outcome.untold { nothing() } else { of(outcome) })
    };
    let number = |text: String| number_alone(text);
    let mut columns = vec![
        outcomes.shown(nothing(), title_of),
        told(say!(fastest_in_millimetres), &fastest),
        told(say!(decibels_per_million_passages), &|outcome| {
            number(format!("{:+.3}", per_million(outcome.fastest.rate)))
        }),
        outcomes.shown(say!(change_head), |outcome| change(outcome, answer)),
    ];
    if outcomes.iter().any(|outcome| !outcome.held.is_empty()) {
        columns.push(told(say!(held_head), &|outcome| match outcome.held[..] {
            [] => nothing(),
            [hold] => held_in_words(hold),
            _ => say!(held_mixed),
        }));
    }
    columns.push(told(say!(ridge_in_hertz), &|outcome| {
        cell(outcome.ridge_frequency.map(|frequency| number(format!("{frequency:.0}"))))
    }));
    if answer.names_rails() {
        columns.push(told(say!(rail_word), &|outcome| {
            let rail = outcome.leading().and_then(RailForecast::name);
            name_in_words(rail.unwrap_or_default())
        }));
    }
    if answer.leading().is_some() {
        columns.push(told(say!(passages_to_limit_head), &|outcome| cell(outcome.reach().map(reached))));
        columns.push(told(say!(tonnes_to_limit_head), &|outcome| {
            let passages = outcome.passages_to_limit();
            cell(passages.map(|passages| number_alone(three_digits(outcome.growth.mgt(passages)))))
        }));
        if answer.comparison.base().passages_per_day.is_some() {
            columns.push(told(say!(months_to_limit_head), &|outcome| {
                cell(outcome.months_to_limit().map(|months| number_alone(three_digits(months))))
            }));
        }
    }
    Table { name: "outcomes", columns }
}

fn fastest(outcome: &Outcome) -> Message {
    let wavelength = number_alone(format_args!("{:.1}", 1e3 * outcome.fastest.wavelength));
    match outcome.fastest.at_edge {
        true => say!(at_edge_of_lines, wavelength),
        false => wavelength,
    }
}

fn change(outcome: &Outcome, answer: &CompareAnswer) -> Message {
    let change = outcome.change_from(answer.comparison.base());
    match (&outcome.effect, change) {
        _ if outcome.untold => say!(cannot_be_told),
        (Effect::CannotAct(_), _) => say!(cannot_act),
        (Effect::ChangesNothing(_), _) => say!(changes_nothing),
        (_, Some(change)) => number_alone(format_args!("{:+.0} %", 100.0 * change)),
        (_, None) => Message::verbatim(""),
    }
}

/// What a reader sees of the bands, the longest first.
pub(super) fn shown_bands(answer: &CompareAnswer) -> Table {
    let bands: Vec<(usize, &ThirdOctave)> = answer.comparison.bands.iter().enumerate().rev().collect();
    let rates = answer.comparison.outcomes.iter().map(|outcome| {
        bands.numbers(title_of(outcome), |(place, _)| format!("{:+.3}", per_million(outcome.growth.band_rate(*place))))
    });
    let wavelengths = bands.numbers(say!(wavelength_of_band), |(_, band)| band.nominal_millimetres());
    Table { name: BANDS, columns: [wavelengths].into_iter().chain(rates).collect() }
}

/// Rates of bands.
pub(super) fn bands(answer: &CompareAnswer) -> Table {
    let wavelengths: Vec<f64> = answer.comparison.bands.iter().map(|band| band.wavelength()).collect();
    rates(answer, BANDS, &wavelengths, |outcome, place| outcome.growth.band_rate(place))
}

/// Rates of lines.
pub(super) fn lines(answer: &CompareAnswer) -> Table {
    let wavelengths = answer.comparison.base().growth.wavelengths();
    rates(answer, "growth", &wavelengths, |outcome, place| outcome.growth.rates()[place])
}

/// One row for each wavelength \[m\], a column for each outcome.
fn rates(
    answer: &CompareAnswer,
    name: &'static str,
    wavelengths: &[f64],
    rate: impl Fn(&Outcome, usize) -> f64,
) -> Table {
    let outcomes = &answer.comparison.outcomes;
    let names = column::names(outcomes.iter().map(|outcome| &*outcome.title), "growth_rate_per_passage");
    let rates = names
        .iter()
        .zip(outcomes)
        .map(|(name, outcome)| Column::exact(name, (0..wavelengths.len()).map(|place| rate(outcome, place))));
    let wavelengths = wavelengths.exact("wavelength_m", |&value| value);
    Table { name, columns: [wavelengths].into_iter().chain(rates).collect() }
}
