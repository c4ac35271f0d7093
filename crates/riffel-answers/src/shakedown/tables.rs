//! Limits and operating points as tables and in words.

use riffel_keys::{Message, fixed, say};

use super::{LimitRow, OperatingPoint, ShakedownAnswer};
use crate::{Column, Table};

pub(super) fn introduction(answer: &ShakedownAnswer) -> Vec<Message> {
    let title = answer.title.clone().map(Message::verbatim);
    title.into_iter().chain([of_mean(answer)]).collect()
}

pub(super) fn of_mean(answer: &ShakedownAnswer) -> Message {
    let mean = &answer.mean;
    say!(
        shakedown_of_mean,
        pressure = fixed(mean.p0_over_k, 3),
        shear = fixed(1e-6 * answer.shear_yield_pa, 0),
        friction = fixed(mean.utilised_friction, 3),
        demand = fixed(mean.demand, 3),
        index = fixed(mean.fi_surf, 3)
    )
}

pub(super) fn tables(answer: &ShakedownAnswer) -> Vec<Table> {
    let column = |name: &str, head: Message, of: fn(&LimitRow) -> Option<f64>| {
        Column::fixed(name, head, answer.map.iter().map(of), 3)
    };
    let limits = Table {
        name: "limits",
        columns: vec![
            column("utilised_friction", say!(utilised_friction), |row| Some(row.utilised_friction)),
            column("elastic", say!(limit_elastic), |row| Some(row.elastic)),
            column("line", say!(limit_line), |row| Some(row.line)),
            column("surface", say!(limit_surface), |row| row.surface),
            column("subsurface", say!(limit_subsurface), |row| Some(row.subsurface)),
        ],
    };
    let along = answer.along_wave.as_deref().map(operating_points);
    std::iter::once(limits).chain(along).collect()
}

fn operating_points(points: &[OperatingPoint]) -> Table {
    type Of = fn(&OperatingPoint) -> f64;
    let column = |name: &str, head: Message, of: Of, shown: usize| {
        Column::fixed(name, head, points.iter().map(|point| Some(of(point))), shown)
    };
    let in_file = |name: &str, of: Of| Column::in_file(name, points.iter().map(of));
    Table {
        name: "operating-points",
        columns: vec![
            column("phase_deg", say!(phase_of_wave), |it| it.phase_deg, 0),
            in_file("profile_m", |it| it.profile_m),
            in_file("normal_force_n", |it| it.normal_force_n),
            in_file("tangential_force_n", |it| it.tangential_force_n),
            column("p0_over_k", say!(pressure_over_yield), |it| it.p0_over_k, 3),
            column("utilised_friction", say!(utilised_friction), |it| it.utilised_friction, 3),
            column("fi_surf", say!(surface_fatigue_index), |it| it.fi_surf, 3),
            column("demand", say!(demand_of_flow), |it| it.demand, 3),
        ],
    }
}

pub(super) fn sentences(answer: &ShakedownAnswer) -> Vec<Message> {
    let Some(points) = &answer.along_wave else {
        return Vec::new();
    };
    let most = points.iter().max_by(|one, other| one.demand.total_cmp(&other.demand));
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
