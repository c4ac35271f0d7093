//! Profile, force, creepage and dissipation along the rail.

use riffel::passage::ContactInstant;
use riffel_plot::{LinePanel, LineStyle, Series};
use serde::Serialize;

use crate::netcdf::{Grid, Variable};
use crate::{Rows, Table};

/// What a wheel does along a rail, place by place.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ContactHistory {
    /// Places of the wheel centre \[m\].
    pub position_m: Vec<f64>,
    /// Height of the rail there.
    pub height_m: Vec<f64>,
    /// Normal force.
    pub normal_force_n: Vec<f64>,
    /// Creep force.
    pub tangential_force_n: Vec<f64>,
    /// Creep force across the rail, of a loop on all axes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lateral_force_n: Option<Vec<f64>>,
    /// Creepage.
    pub creepage: Vec<f64>,
    /// Lateral creepage, of a loop on all axes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lateral_creepage: Option<Vec<f64>>,
    /// Energy dissipated per metre.
    pub dissipation_j_per_m: Vec<f64>,
    /// Approach of wheel and rail; below zero their distance.
    pub approach_m: Vec<f64>,
}

impl ContactHistory {
    /// Places \[m\], heights \[m\] and contacts in the same order; with what is across the rail where the loop is `on_all_axes`.
    pub(super) fn new(places: Vec<f64>, heights: Vec<f64>, contacts: &[ContactInstant], on_all_axes: bool) -> Self {
        let all = |of: fn(&ContactInstant) -> f64| contacts.iter().map(of).collect();
        let across = |of: fn(&ContactInstant) -> f64| on_all_axes.then(|| all(of));
        Self {
            lateral_force_n: across(|contact| contact.lateral_force),
            lateral_creepage: across(|contact| contact.lateral_creepage),
            position_m: places,
            height_m: heights,
            normal_force_n: all(|contact| contact.normal_force),
            tangential_force_n: all(|contact| contact.tangential_force),
            creepage: all(|contact| contact.creepage),
            dissipation_j_per_m: all(ContactInstant::energy_per_metre),
            approach_m: all(|contact| contact.approach),
        }
    }

    /// All over `position`, under the names that Python has.
    pub(super) fn grid(&self, title: String) -> Grid<'_> {
        let of = |name, unit, long_name, values: &'_ [f64]| {
            let values = values.to_vec();
            Variable::new(name, &["position"], unit, long_name, move || values.clone())
        };
        let mut variables = vec![
            of("position", "m", "place of the wheel centre", &self.position_m),
            of("height", "m", "height of the rail, positive upward", &self.height_m),
            of("normal_force", "N", "normal force", &self.normal_force_n),
            of("tangential_force", "N", "creep force", &self.tangential_force_n),
            of("creepage", "1", "creepage", &self.creepage),
            of("dissipation", "J/m", "energy dissipated in a metre, at the wheel centre", &self.dissipation_j_per_m),
            of("approach", "m", "approach of wheel and rail, below zero their distance", &self.approach_m),
        ];
        for (name, unit, long_name, values) in [
            ("lateral_force", "N", "creep force across the rail", &self.lateral_force_n),
            ("lateral_creepage", "1", "lateral creepage", &self.lateral_creepage),
        ] {
            variables.extend(values.as_ref().map(|values| of(name, unit, long_name, values)));
        }
        let axes = vec![("position", self.position_m.len())];
        Grid { title, axes, variables }
    }

    /// One row for each place.
    pub(super) fn table(&self, name: &'static str) -> Table {
        let column = |name: &str, values: &[f64]| values.exact(name, |&value| value);
        let across = [("lateral_force_n", &self.lateral_force_n), ("lateral_creepage", &self.lateral_creepage)];
        let across = across.into_iter().filter_map(|(name, values)| Some(column(name, values.as_deref()?)));
        let columns = [
            column("position_m", &self.position_m),
            column("height_m", &self.height_m),
            column("normal_force_n", &self.normal_force_n),
            column("tangential_force_n", &self.tangential_force_n),
            column("creepage", &self.creepage),
            column("dissipation_j_per_m", &self.dissipation_j_per_m),
            column("approach_m", &self.approach_m),
        ];
        Table { name, columns: columns.into_iter().chain(across).collect() }
    }

    /// Strips of all quantities; places without contact are marked at zero force.
    pub(super) fn panels(&self) -> Vec<LinePanel> {
        let strip = |y_label: &str, values: &[f64], scale: f64| {
            LinePanel::new(
                "place along the rail x [m]",
                y_label,
                [Series::new("", self.position_m.clone(), values.iter().map(|value| scale * value).collect())],
            )
        };
        let mut force = strip("normal force P [kN]", &self.normal_force_n, 1e-3);
        if self.normal_force_n.contains(&0.0) {
            let lost = self.normal_force_n.iter().map(|force| match *force {
                0.0 => 0.0,
                _ => f64::NAN,
            });
            force
                .series
                .push(Series::new("no contact", self.position_m.clone(), lost.collect()).styled(LineStyle::Markers));
        }
        let mut panels = vec![force];
        if self.height_m.iter().any(|height| *height != 0.0) {
            panels.insert(0, strip("profile [µm]", &self.height_m, 1e6));
        }
        panels.push(strip("creep force Q [kN]", &self.tangential_force_n, 1e-3));
        if let Some(lateral) = &self.lateral_force_n {
            panels.push(strip("lateral creep force [kN]", lateral, 1e-3));
        }
        panels.push(strip("creepage ξ [%]", &self.creepage, 100.0));
        if let Some(lateral) = &self.lateral_creepage {
            panels.push(strip("lateral creepage [%]", lateral, 100.0));
        }
        panels.push(strip("dissipation [J/m]", &self.dissipation_j_per_m, 1.0));
        panels
    }
}
