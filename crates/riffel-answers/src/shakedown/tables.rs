//! Limits and operating points as tables and in words.

use riffel_keys::{Message, fixed, say};

use super::{OperatingPoint, ShakedownAnswer};
use crate::{Rows, Table};

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
    let map = &answer.map;
    let limits = Table {
        name: "limits",
        columns: vec![
            map.fixed("utilised_friction", say!(utilised_friction), 3, |row| row.utilised_friction),
            map.fixed("elastic", say!(limit_elastic), 3, |row| row.elastic),
            map.fixed("line", say!(limit_line), 3, |row| row.line),
            map.fixed("surface", say!(limit_surface), 3, |row| row.surface),
            map.fixed("subsurface", say!(limit_subsurface), 3, |row| row.subsurface),
        ],
    };
    let along = answer.along_wave.as_deref().map(operating_points);
    std::iter::once(limits).chain(along).collect()
}

fn operating_points(points: &[OperatingPoint]) -> Table {
    Table {
        name: "operating-points",
        columns: vec![
            points.fixed("phase_deg", say!(phase_of_wave), 0, |it| it.phase_deg),
            points.plain("profile_m", |it| it.profile_m),
            points.plain("normal_force_n", |it| it.normal_force_n),
            points.plain("tangential_force_n", |it| it.tangential_force_n),
            points.fixed("p0_over_k", say!(pressure_over_yield), 3, |it| it.p0_over_k),
            points.fixed("utilised_friction", say!(utilised_friction), 3, |it| it.utilised_friction),
            points.fixed("fi_surf", say!(surface_fatigue_index), 3, |it| it.fi_surf),
            points.fixed("demand", say!(demand_of_flow), 3, |it| it.demand),
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
