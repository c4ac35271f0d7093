//! Limits and operating points as tables and in words.

use riffel_keys::{Message, fixed, say};

use super::{OperatingPoint, ShakedownAnswer};
use crate::{Column, Table, Values};

pub(super) fn introduction(answer: &ShakedownAnswer) -> Vec<Message> {
    let mean = &answer.mean;
    let title = answer.title.clone().map(Message::verbatim);
    title
        .into_iter()
        .chain([say!(
            shakedown_of_mean,
            pressure = fixed(mean.p0_over_k, 3),
            shear = fixed(1e-6 * answer.shear_yield_pa, 0),
            friction = fixed(mean.utilised_friction, 3),
            demand = fixed(mean.demand, 3),
            index = fixed(mean.fi_surf, 3)
        )])
        .collect()
}

pub(super) fn tables(answer: &ShakedownAnswer) -> Vec<Table> {
    let map = &answer.map;
    let mut columns = vec![
        column(
            "utilised_friction",
            say!(utilised_friction),
            map.iter().map(|row| row.utilised_friction),
            3,
        ),
        column(
            "elastic",
            say!(limit_elastic),
            map.iter().map(|row| row.elastic),
            3,
        ),
        column("line", say!(limit_line), map.iter().map(|row| row.line), 3),
    ];
    columns.push(Column {
        name: "surface".to_owned(),
        head: Some(say!(limit_surface)),
        values: Values::Fixed {
            values: map.iter().map(|row| row.surface).collect(),
            file: 6,
            shown: 3,
            signed: false,
        },
    });
    columns.push(column(
        "subsurface",
        say!(limit_subsurface),
        map.iter().map(|row| row.subsurface),
        3,
    ));
    let limits = Table {
        name: "limits",
        columns,
    };
    let along = answer.along_wave.as_deref().map(operating_points);
    std::iter::once(limits).chain(along).collect()
}

fn operating_points(points: &[OperatingPoint]) -> Table {
    let of = |name: &str, head: Message, value: fn(&OperatingPoint) -> f64, digits: usize| {
        column(name, head, points.iter().map(value), digits)
    };
    let in_file = |name: &str, value: fn(&OperatingPoint) -> f64| Column {
        name: name.to_owned(),
        head: None,
        values: Values::Plain(points.iter().map(value).collect()),
    };
    Table {
        name: "operating-points",
        columns: vec![
            of("phase_deg", say!(phase_of_wave), |point| point.phase_deg, 0),
            in_file("profile_m", |point| point.profile_m),
            in_file("normal_force_n", |point| point.normal_force_n),
            in_file("tangential_force_n", |point| point.tangential_force_n),
            of(
                "p0_over_k",
                say!(pressure_over_yield),
                |point| point.p0_over_k,
                3,
            ),
            of(
                "utilised_friction",
                say!(utilised_friction),
                |point| point.utilised_friction,
                3,
            ),
            of(
                "fi_surf",
                say!(surface_fatigue_index),
                |point| point.fi_surf,
                3,
            ),
            of("demand", say!(demand_of_flow), |point| point.demand, 3),
        ],
    }
}

fn column(name: &str, head: Message, values: impl Iterator<Item = f64>, shown: usize) -> Column {
    Column {
        name: name.to_owned(),
        head: Some(head),
        values: Values::Fixed {
            values: values.map(Some).collect(),
            file: 6,
            shown,
            signed: false,
        },
    }
}

pub(super) fn sentences(answer: &ShakedownAnswer) -> Vec<Message> {
    let Some(points) = &answer.along_wave else {
        return Vec::new();
    };
    let most = points
        .iter()
        .max_by(|one, other| one.demand.total_cmp(&other.demand));
    let above = points.iter().filter(|point| point.demand > 1.0).count();
    let most = most.map(|most| {
        say!(
            demand_is_largest_at,
            demand = fixed(most.demand, 3),
            phase = fixed(most.phase_deg, 0),
            share = fixed(100.0 * above as f64 / points.len() as f64, 0)
        )
    });
    most.into_iter().collect()
}
