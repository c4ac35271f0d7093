//! The loop at one wavelength and speed in engineers' units.

use std::f64::consts::LN_2;

use riffel::Complex64;
use riffel_case::{CaseKey, DamagePoint, Sensitivity};
use riffel_keys::quantity::{Kind, Length, Speed};
use riffel_keys::{Message, fixed, number, say};

use super::{IrregularSupports, Neighbours, PointAnswer, Spread};
use crate::number_alone;
use crate::side::side;
use crate::{Rows, Table, for_whom};

const AMPLITUDES: &str = "amplitudes";
const CONTACTS: &str = "contacts";
const LAWS: &str = "laws";
const NEIGHBOURS: &str = "neighbours";
const SUPPORTS: &str = "supports";

fn nothing() -> Message {
    Message::verbatim("")
}

/// Three digits behind the first, and the power of ten.
fn power(value: f64) -> Message {
    number_alone(format_args!("{value:.3e}"))
}

pub(super) fn tables(answer: &PointAnswer) -> Vec<Table> {
    let damage = answer.quantities.damage.as_ref().map(laws);
    let of_loop = [amplitudes(answer)].into_iter().chain(contacts(answer)).chain(damage);
    let neighbours = answer.with_neighbours.as_ref().map(neighbours);
    let supports = answer.irregular_supports.as_ref().map(supports);
    let sensitivities = answer.sensitivity.as_deref().map(sensitivities);
    of_loop.chain(neighbours).chain(supports).chain(sensitivities).collect()
}

pub(super) fn above(answer: &PointAnswer, table: &str) -> Vec<Message> {
    let line = match table {
        NEIGHBOURS => answer.with_neighbours.as_ref().map(|growth| {
            say!(
                growth_with_neighbours,
                alone = power(growth.growth_rate_alone),
                pattern = power(growth.growth_rate_of_pattern)
            )
        }),
        SUPPORTS => answer.irregular_supports.as_ref().map(|growth| {
            say!(
                supports_that_scatter,
                supports = number(growth.support_position_m.len()),
                deviation = fixed(1e3 * growth.spacing_deviation_m, 1),
                seed = number(growth.seed)
            )
        }),
        _ => None,
    };
    line.into_iter().flat_map(|line| [nothing(), line]).collect()
}

pub(super) fn below(answer: &PointAnswer, table: &str) -> Vec<Message> {
    let last_of_loop = match (&answer.quantities.damage, contacts(answer)) {
        (Some(_), _) => LAWS,
        (None, Some(_)) => CONTACTS,
        (None, None) => AMPLITUDES,
    };
    match table {
        NEIGHBOURS => answer.with_neighbours.iter().map(highest).collect(),
        table if table == last_of_loop => {
            let rate = answer.state.growth_rate;
            let growth = say!(
                growth_at_point,
                dissipation = fixed(answer.state.normalized_dissipation.re, 5),
                rate = number(format_args!("{rate:.3e}")),
                verdict = verdict(answer)
            );
            let demand = answer.quantities.damage.as_ref().map(demand);
            demand.into_iter().chain([growth, for_whom(&answer.case)]).collect()
        }
        _ => Vec::new(),
    }
}

/// The point and its contact.
pub(super) fn introduction(answer: &PointAnswer) -> Vec<Message> {
    let PointAnswer { case, state, .. } = answer;
    let slope = case.law.as_ref().and_then(|law| law.own_slope());
    let full_slip = slope
        .map_or_else(nothing, |slope| say!(full_slip_from, creepage = fixed(100.0 * slope.saturation_creepage, 4)));
    let creepages = case.steady.creepages;
    let longitudinal = fixed(100.0 * creepages.longitudinal, 4);
    let creepage = match case.feedback.is_along_one_axis() {
        true => say!(creepage_along_rail, creepage = longitudinal),
        false => say!(
            creepage_on_axes,
            along = longitudinal,
            across = fixed(100.0 * creepages.lateral, 4),
            spin = fixed(creepages.spin, 3)
        ),
    };
    let unlikely = answer.wear_limit.unlikely_wear.clone();
    let title = case.file.title.clone().map(Message::verbatim);
    let point = [
        say!(
            point_of_loop,
            wavelength = fixed(1e3 * state.wavelength, 1),
            speed = fixed(3.6 * state.speed, 1),
            frequency = fixed(state.speed / state.wavelength, 1)
        ),
        say!(
            contact_at_point,
            ratio = fixed(case.steady.tractive_ratio(), 3),
            creepage,
            full_slip,
            length = fixed(2e3 * case.hertz.semi_axis_longitudinal(), 2),
            width = fixed(2e3 * case.hertz.semi_axis_lateral(), 2)
        ),
    ];
    unlikely.into_iter().chain(title).chain(point).collect()
}

/// What oscillates, with its phase.
fn amplitudes(answer: &PointAnswer) -> Table {
    let PointAnswer { case, state, .. } = answer;
    let [_, wheel] = case.feedback.normal_receptances(state.angular_frequency, state.speed);
    let across = match case.feedback.is_along_one_axis() {
        true => {
            let angular_velocity = -state.slip() * state.speed / case.hertz.rolling_radius();
            (say!(oscillating_angular_velocity), angular_velocity * 1e3, "mrad/s")
        }
        false => (say!(oscillating_lateral_force), state.contacts[0].force[1], "N"),
    };
    let rows: [(Message, Complex64, &str); 8] = [
        (say!(receptance_of_rail), state.normal_receptance() * 1e9, "nm/N"),
        (say!(receptance_of_wheel), wheel * 1e9, "nm/N"),
        (say!(oscillating_normal_force), state.normal_force() * 1e-3, "kN"),
        (say!(oscillating_tangential_force), state.tangential_force(), "N"),
        across,
        (say!(dissipation_at_wheel), state.dissipation, "W"),
        (say!(dissipation_at_rail), state.dissipation_at_rail, "W"),
        (say!(dissipation_normalised), state.normalized_dissipation, "-"),
    ];
    Table {
        name: AMPLITUDES,
        columns: vec![
            rows.shown(say!(oscillation_column), |row| row.0.clone()),
            rows.digits(say!(amplitude_column), 4, |row| row.1.norm()),
            rows.shown(say!(unit_column), |row| Message::verbatim(row.2)),
            rows.numbers(say!(phase_column), |row| format!("{:.1}°", row.1.arg().to_degrees())),
        ],
    }
}

/// Every contact of a loop that has several.
fn contacts(answer: &PointAnswer) -> Option<Table> {
    let points = &answer.quantities.all_axes.as_ref()?.contacts;
    let rows: Vec<_> = points.iter().zip(&answer.state.contacts).collect();
    (points.len() > 1).then(|| Table {
        name: CONTACTS,
        columns: vec![
            rows.numbers(say!(wheel_column), |(point, _)| point.name.wheel),
            rows.shown(say!(rail_column), |(point, _)| side(point.name.rail)),
            rows.digits(say!(normal_force_in_kilonewton), 4, |(_, at)| 1e-3 * at.force[2].norm()),
            rows.shown(say!(growth_per_passage_column), |(_, at)| {
                at.growth_rate.map_or_else(|| say!(smooth_rail), power)
            }),
        ],
    })
}

/// What each law of damage does.
fn laws(damage: &DamagePoint) -> Table {
    let laws = &damage.growth_by_law.0;
    let depth = |law: &str| {
        let mut depths = damage.depth_by_law_m.0.iter();
        depths.find(|(name, _)| *name == law).map_or_else(nothing, |(_, depth)| power(1e9 * depth))
    };
    Table {
        name: LAWS,
        columns: vec![
            laws.shown(say!(law_column), |(law, _)| Message::verbatim(*law)),
            laws.shown(say!(growth_per_passage_column), |(_, growth)| power(*growth)),
            laws.shown(say!(depth_per_passage_column), |(law, _)| depth(law)),
        ],
    }
}

fn demand(damage: &DamagePoint) -> Message {
    say!(
        demand_at_point,
        demand = fixed(damage.demand, 3),
        // Later in time is a lag.
        phase = fixed((-damage.place_deg).rem_euclid(360.0), 0),
        amplitude = fixed(1e6 * damage.amplitude_at_limit_m, 1)
    )
}

/// What becomes of the wave.
fn verdict(answer: &PointAnswer) -> Message {
    let rate = answer.state.growth_rate;
    let passages = number(format_args!("{:.2e}", LN_2 / rate.abs()));
    if answer.oscillates() {
        say!(loop_oscillates_by_itself)
    } else if rate > 0.0 {
        say!(doubles_in_passages, passages)
    } else if rate == 0.0 {
        say!(neither_grows_nor_decays)
    } else {
        say!(halves_in_passages, passages)
    }
}

/// Growth of the wave with its neighbours.
fn neighbours(growth: &Neighbours) -> Table {
    let pattern = &growth.pattern;
    Table {
        name: NEIGHBOURS,
        columns: vec![
            growth.wavelengths_m.digits(say!(wavelength_of_band), 2, |wavelength| 1e3 * wavelength),
            pattern.digits(say!(share_of_pattern), 3, |[re, im]| re.hypot(*im)),
            pattern.numbers(say!(phase_column), |[re, im]| format!("{:.0}°", im.atan2(*re).to_degrees())),
        ],
    }
}

/// Where the pattern is highest.
fn highest(growth: &Neighbours) -> Message {
    say!(pattern_is_highest, place = fixed(1e3 * growth.highest_at_m, 0), modulation = fixed(growth.modulation, 2))
}

/// Growth along drawn supports beside equal ones.
fn supports(growth: &IrregularSupports) -> Table {
    let spreads = [(say!(equal_distances), &growth.even), (say!(drawn_distances), &growth.along)];
    let column = |head, of: fn(&Spread) -> f64| spreads.shown(head, |(_, spread)| power(of(spread)));
    Table {
        name: SUPPORTS,
        columns: vec![
            spreads.shown(say!(growth_rate_per_passage_column), |(distances, _)| distances.clone()),
            column(say!(mean_column), |spread| spread.mean),
            column(say!(least_column), |spread| spread.least),
            column(say!(tenth_column), |spread| spread.tenth),
            column(say!(nine_tenths_column), |spread| spread.nine_tenths),
            column(say!(largest_column), |spread| spread.largest),
        ],
    }
}

/// What the growth rate answers to, the strongest first.
fn sensitivities(all: &[Sensitivity]) -> Table {
    let in_units = |of: &Sensitivity| {
        let kind = match of.key.as_str() {
            "wavelength" => Some(Kind::of::<Length>()),
            "speed" => Some(Kind::of::<Speed>()),
            key => CaseKey::find(key).and_then(|key| key.quantity),
        };
        kind.map_or((of.value, of.unit), |kind| kind.in_engineers_unit(of.value))
    };
    Table {
        name: "sensitivity",
        columns: vec![
            all.shown(say!(parameter_column), |of| Message::verbatim(of.key.clone())),
            all.numbers(say!(value_column), |of| short(in_units(of).0)),
            all.shown(say!(unit_column), |of| Message::verbatim(in_units(of).1)),
            all.numbers(say!(growth_for_one_percent), |of| format!("{:+.3} %", of.elasticity)),
        ],
    }
}

/// A number to five digits, with an exponent where it is far from one.
fn short(value: f64) -> String {
    let scientific = format!("{value:.4e}");
    let rounded: f64 = scientific.parse().unwrap_or(value);
    if (1e-4..1e6).contains(&rounded.abs()) { rounded.to_string() } else { format!("{rounded:e}") }
}
