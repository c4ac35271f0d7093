//! Ridges as tables.

use riffel::Ridge;
use riffel::growth::RidgePoint;

use crate::{Column, Table};

/// The columns of points of a ridge.
fn columns<'a>(points: impl Iterator<Item = &'a RidgePoint> + Clone) -> [Column; 6] {
    let column = |name: &str, of: fn(&RidgePoint) -> f64| Column::exact(name, points.clone().map(of));
    [
        column("speed_m_per_s", |point| point.speed),
        column("wavelength_m", |point| point.wavelength),
        column("frequency_hz", |point| point.frequency),
        column("normalized_dissipation_re", |point| point.normalized_dissipation),
        column("growth_rate_per_passage", |point| point.growth_rate),
        Column::names("at_edge", points.map(|point| point.at_edge)),
    ]
}

/// One row for each speed.
pub(crate) fn ridge_table(name: &'static str, ridge: &Ridge) -> Table {
    Table { name, columns: columns(ridge.points.iter()).into() }
}

/// One row for each point of each branch, counted from zero, the strongest.
pub(crate) fn branches_table(name: &'static str, ridge: &Ridge) -> Table {
    let branches = ridge.branches.iter().enumerate();
    let numbers = branches.flat_map(|(index, branch)| branch.points().iter().map(move |_| index));
    let number = Column::names("branch", numbers);
    let columns = columns(ridge.branches.iter().flat_map(|branch| branch.points()));
    Table { name, columns: [number].into_iter().chain(columns).collect() }
}
