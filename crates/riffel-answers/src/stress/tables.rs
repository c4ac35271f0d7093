//! Largest stresses as a table and in words.

use riffel_keys::{Message, fixed, say};

use super::{StressAnswer, StressMaximumDocument};
use crate::{Rows, Table};

pub(super) fn introduction(answer: &StressAnswer) -> Vec<Message> {
    let title = answer.title.clone().map(Message::verbatim);
    let ratio = answer.semi_axis_longitudinal_m / answer.semi_axis_lateral_m;
    title
        .into_iter()
        .chain([say!(
            stress_under_contact,
            pressure = fixed(1e-6 * answer.peak_pressure_pa, 0),
            ratio = fixed(ratio, 2),
            friction = fixed(answer.friction, 2),
            tractive = fixed(answer.tractive_ratio, 2)
        )])
        .collect()
}

pub(super) fn tables(answer: &StressAnswer) -> Vec<Table> {
    let maxima = &answer.stress.maxima;
    let words = |name: &str, head, of: fn(&StressMaximumDocument) -> &'static str| {
        maxima.words(name, head, |row| match of(row) {
            "subsurface" if row.at_search_floor => say!(limit_subsurface_at_floor),
            "full-slip" => say!(in_full_slip),
            "partial-slip" => say!(in_partial_slip),
            "half-space" => say!(by_half_space),
            "surface" => say!(limit_surface),
            "subsurface" => say!(limit_subsurface),
            name => Message::verbatim(name),
        })
    };
    let of_maxima = Table {
        name: "maxima",
        columns: vec![
            words("traction", say!(traction_of_contact), |row| row.traction),
            words("measure", say!(measure_of_stress), |row| row.measure),
            words("where", say!(depth_of_stress), |row| row.depth),
            maxima.fixed("value_over_p0", say!(stress_over_pressure), 3, |row| row.value_over_p0),
            maxima.fixed("x_over_a", Message::verbatim("x/a"), 3, |row| row.x_over_a),
            maxima.fixed("y_over_b", Message::verbatim("y/b"), 3, |row| row.y_over_b),
            maxima.fixed("z_over_a", Message::verbatim("z/a"), 3, |row| row.z_over_a),
        ],
    };
    let rows = &answer.stress.over_friction;
    let over_friction = Table {
        name: "over-friction",
        columns: vec![
            rows.plain("friction", |row| row.friction),
            rows.plain("surface_over_p0", |row| row.surface_over_p0),
            rows.plain("subsurface_over_p0", |row| row.subsurface_over_p0),
            rows.plain("at_search_floor", |row| f64::from(row.at_search_floor)),
        ],
    };
    vec![of_maxima, over_friction]
}
