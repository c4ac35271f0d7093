//! Growth maps as figures.

use riffel::{GrowthMap, Ridge};
use riffel_case::Case;
use riffel_keys::say;
use riffel_plot::{BranchLine, MapFigure, MapPanel, Observation, RidgeMark, constant_frequency_rays};

use crate::parameters::parameters;
use crate::ridge::best_fit_frequency;
use crate::track_in_words::place;

/// What a map shows.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Shown {
    /// Re Ŵ₁, equation (20).
    Normalized,
    /// Re W₁ in watts, as in Figs. 4 and 5 of the paper.
    Power,
    /// The rate of decay per passage, below zero where corrugation grows: Ŵ₁ is over the friction power of each case, and
    /// this compares cases of different ones.
    Decay,
}

impl Shown {
    /// Factor from Re Ŵ₁ to the value shown, at a speed \[m/s\]; the growth rate that belongs to Ŵ₁ = 1 is below zero.
    fn factor(self, case: &Case, speed: f64, rate: f64) -> f64 {
        match self {
            Self::Normalized => 1.0,
            Self::Power => case.steady.full_slip_energy_per_metre() * speed,
            Self::Decay => -1e6 * rate,
        }
    }

    fn label(self) -> &'static str {
        match self {
            Self::Normalized => "Re Ŵ₁ [-]",
            Self::Power => "Re W₁ [W]",
            Self::Decay => "decay rate [10⁻⁶ per passage]",
        }
    }
}

/// A panel with the map, its ridge and branches, the best-fit ray and rays of constant frequency.
pub fn panel(case: &Case, map: &GrowthMap, ridge: &Ridge, shown: Shown) -> MapPanel {
    let rate = map.growth_rate_per_dissipation();
    let columns = drawn(map.wavelength().points());
    let rows = drawn(map.speed().points());
    let at = |row: usize, column: usize| map.row(row)[column].re;
    let grid = |factor: &dyn Fn(usize) -> f64| -> Vec<f64> {
        rows.iter()
            .flat_map(|&row| {
                let factor = factor(row);
                columns.iter().map(move |&column| factor * at(row, column))
            })
            .collect()
    };
    MapPanel {
        wavelength_m: columns.iter().map(|&column| map.wavelength().value(column)).collect(),
        speed_m_per_s: rows.iter().map(|&row| map.speed().value(row)).collect(),
        values: grid(&|row| shown.factor(case, map.speed().value(row), rate)),
        hover_values: Some(grid(&|_| rate)),
        value_label: shown.label().to_owned(),
        ridge: ridge
            .points
            .iter()
            .filter(|point| point.normalized_dissipation < 0.0)
            .map(|point| RidgeMark {
                wavelength_m: point.wavelength,
                speed_m_per_s: point.speed,
                at_edge: point.at_edge,
            })
            .collect(),
        branches: ridge
            .branches
            .iter()
            .map(|branch| BranchLine {
                frequency_hz: branch.frequency(),
                points: branch.crest().map(|point| (point.wavelength, point.speed)).collect(),
            })
            .collect(),
        best_fit_frequency_hz: best_fit_frequency(ridge),
        rays_hz: constant_frequency_rays(
            (map.wavelength().min(), map.wavelength().max()),
            (map.speed().min(), map.speed().max()),
        ),
        ..MapPanel::default()
    }
}

/// Indices along an axis that a figure needs: all, or enough of a long axis, both ends included.
fn drawn(points: usize) -> Vec<usize> {
    const ENOUGH: usize = 400;
    let count = points.min(ENOUGH);
    (0..count).map(|index| index * (points - 1) / (count - 1)).collect()
}

/// The map of a case as a figure, with its ridge, its parameters below and what was observed.
pub fn map_figure(case: &Case, map: &GrowthMap, ridge: &Ridge, observations: Vec<Observation>) -> MapFigure {
    let mut panel = panel(case, map, ridge, Shown::Normalized);
    panel.observations = observations;
    MapFigure {
        title: map_title(case).to_owned(),
        caption: format!("{}{} {}", parameters(case), place(case), say!(sign_of_growth)),
        panels: vec![panel],
    }
}

/// The title of a map: that of its case.
fn map_title(case: &Case) -> &str {
    case.file.title.as_deref().unwrap_or("Growth map")
}
