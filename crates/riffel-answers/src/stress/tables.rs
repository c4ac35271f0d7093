//! Largest stresses as a table and in words.

use riffel_keys::{Message, fixed, say};

use super::StressAnswer;
use crate::{Column, Table};

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
    let words = |of: fn(&super::StressMaximumDocument) -> &'static str| {
        let words = maxima.iter().map(|row| match of(row) {
            "subsurface" if row.at_search_floor => say!(limit_subsurface_at_floor),
            "full-slip" => say!(in_full_slip),
            "partial-slip" => say!(in_partial_slip),
            "half-space" => say!(by_half_space),
            "surface" => say!(limit_surface),
            "subsurface" => say!(limit_subsurface),
            name => Message::verbatim(name),
        });
        words.collect::<Vec<Message>>()
    };
    let column = |name: &str, head: Message, of: fn(&super::StressMaximumDocument) -> f64| {
        Column::fixed(name, head, maxima.iter().map(|row| Some(of(row))), 3)
    };
    let of_maxima = Table {
        name: "maxima",
        columns: vec![
            Column::words("traction", say!(traction_of_contact), words(|row| row.traction)),
            Column::words("measure", say!(measure_of_stress), words(|row| row.measure)),
            Column::words("where", say!(depth_of_stress), words(|row| row.depth)),
            column("value_over_p0", say!(stress_over_pressure), |row| row.value_over_p0),
            column("x_over_a", Message::verbatim("x/a"), |row| row.x_over_a),
            column("y_over_b", Message::verbatim("y/b"), |row| row.y_over_b),
            column("z_over_a", Message::verbatim("z/a"), |row| row.z_over_a),
        ],
    };
    let rows = || answer.stress.over_friction.iter();
    let over_friction = Table {
        name: "over-friction",
        columns: vec![
            Column::in_file("friction", rows().map(|row| row.friction)),
            Column::in_file("surface_over_p0", rows().map(|row| row.surface_over_p0)),
            Column::in_file("subsurface_over_p0", rows().map(|row| row.subsurface_over_p0)),
            Column::in_file("at_search_floor", rows().map(|row| f64::from(row.at_search_floor))),
        ],
    };
    vec![of_maxima, over_friction]
}
