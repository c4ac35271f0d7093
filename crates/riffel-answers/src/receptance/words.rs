//! Resonances and decay rates in tables and words.

use riffel::receptance::{DecayRate, ResonanceKind};
use riffel_case::Origin;
use riffel_keys::{Message, decimal, fixed, number, say};

use super::{NamedResonance, ReceptanceAnswer};
use crate::answer::titled;
use crate::{Rows, Table};

fn has_model(answer: &ReceptanceAnswer) -> bool {
    matches!(answer.track.origin, Origin::Model)
}

pub(super) fn introduction(answer: &ReceptanceAnswer) -> Vec<Message> {
    let title = titled(answer.case.file.title.as_ref(), say!(receptance_title));
    let nothing = answer.resonances.is_empty().then(|| match has_model(answer) {
        true => say!(no_resonance_to_name),
        false => say!(no_peak_or_dip),
    });
    [title].into_iter().chain(nothing).collect()
}

/// One row for each resonance.
pub(super) fn resonances(answer: &ReceptanceAnswer) -> Table {
    let rows = &answer.resonances;
    let mut columns = vec![
        rows.names("resonance", |it| it.kind),
        rows.exact("frequency_hz", |it| it.frequency_hz),
        rows.exact("receptance_modulus_m_per_n", NamedResonance::modulus),
        rows.exact("damping_ratio", |it| it.damping_ratio),
        rows.exact("resolution_hz", |it| it.resolution_hz),
    ];
    if !answer.resonances.is_empty() {
        columns.extend([
            rows.shown(say!(resonance_column), |it| Message::verbatim(it.kind.to_string())),
            rows.digits(say!(frequency_in_hertz), 1, |it| Some(it.frequency_hz)),
            rows.digits(Message::verbatim("|H| nm/N"), 3, |it| 1e9 * it.modulus()),
            rows.shown(say!(resonance_of), |it| of(answer, it.kind)),
        ]);
        if !has_model(answer) {
            columns.push(rows.digits(say!(damping_column), 1, |it| Some(100.0 * it.damping_ratio?)));
            columns.push(rows.digits(say!(lines_column), 1, |it| it.resolution_hz));
        }
    }
    Table { name: "resonances", columns }
}

/// What resonates.
fn of(answer: &ReceptanceAnswer, kind: ResonanceKind) -> Message {
    match kind {
        ResonanceKind::P2 => say!(least_of_rail_wheel_and_contact),
        ResonanceKind::PinnedPinned if has_model(answer) => say!(rail_in_mid_span),
        _ if answer.track.support_spacing().is_some() => say!(rail_over_support),
        _ => say!(rail_word),
    }
}

/// One row for each one-third octave.
pub(super) fn decay(rates: &[DecayRate]) -> Table {
    Table {
        name: "decay-rate",
        columns: vec![
            rates.exact("frequency_hz", |rate| rate.nominal_frequency),
            rates.exact("decay_rate_db_per_m", |rate| rate.decay_rate),
            rates.names("upper_bound", |rate| rate.upper_bound),
        ],
    }
}

pub(super) fn sentences(answer: &ReceptanceAnswer) -> Vec<Message> {
    let closed = answer.p2_closed_form.as_ref().map(|closed| {
        say!(
            p2_in_closed_form,
            frequency = fixed(closed.frequency_hz, 1),
            wheel = fixed(closed.unsprung_mass_kg, 0),
            track = fixed(closed.track_mass_kg, 0),
            stiffness = fixed(1e-6 * closed.stiffness_n_per_m, 1)
        )
    });
    let lateral = answer
        .lateral_resonances
        .iter()
        .map(|it| say!(kind_and_frequency, kind = it.kind.to_string(), frequency = fixed(it.frequency_hz, 1)));
    let lateral = (!answer.lateral_resonances.is_empty())
        .then(|| say!(across_the_track, named = lateral.collect::<riffel_keys::Value>()));
    let decay = answer.decay().map(|rates| {
        let rates = rates.iter().map(|rate| {
            let rate_in_words = decimal(rate.decay_rate, 2);
            let bound = if rate.upper_bound { "<" } else { "" };
            say!(decay_at, frequency = rate.nominal_frequency, rate = number(format_args!("{bound}{rate_in_words}")))
        });
        say!(decay_rates, rates = rates.collect::<riffel_keys::Value>())
    });
    closed.into_iter().chain(lateral).chain(decay).collect()
}
