//! Maps of growth over wavelength and speed: the data of the figure.

use crate::error::PlotError;
use crate::grid::{Grid, check_axis};
use crate::rays::Window;
use crate::steps::Steps;

/// Branches that are named by their frequency, the strongest among them: more labels than these hide the map.
const NAMED_BRANCHES: usize = 4;

/// A point of the ridge: the wavelength of strongest growth at a speed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RidgeMark {
    /// Wavelength of strongest growth, m.
    pub wavelength_m: f64,
    /// Speed, m/s.
    pub speed_m_per_s: f64,
    /// The strongest growth lies at the edge of the window, so that the true maximum may lie
    /// outside.
    pub at_edge: bool,
}

/// A line of growth that continues from speed to speed.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BranchLine {
    /// Constant frequency that describes it best, Hz.
    pub frequency_hz: f64,
    /// Its points in order of speed: wavelength in m and speed in m/s.
    pub points: Vec<(f64, f64)>,
}

/// A corrugation measured in track.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Observation {
    /// Wavelength, m.
    pub wavelength_m: f64,
    /// Speed of the traffic, m/s.
    pub speed_m_per_s: f64,
    /// Source; all observations of one source share a mark.
    pub label: String,
}

/// A map with the marks drawn upon it.
#[derive(Debug, Clone, PartialEq)]
pub struct MapPanel {
    /// Words above the panel, such as "(a) τ = 0.1".
    pub subtitle: String,
    /// Wavelengths of the grid, m: positive and increasing, at least two.
    pub wavelength_m: Vec<f64>,
    /// Speeds of the grid, m/s: positive and increasing, at least two.
    pub speed_m_per_s: Vec<f64>,
    /// Values on the grid, row-major `[speed][wavelength]`; negative where corrugation grows. A
    /// value that is not finite is drawn as "not computed".
    pub values: Vec<f64>,
    /// Quantity and unit of the values, such as "Re Ŵ₁ [-]".
    pub value_label: String,
    /// Number of equal steps from 0 to the smallest value; 0 counts as 1.
    pub level_count: usize,
    /// End of the colour scale in place of the smallest value, so that panels can share one scale; negative.
    pub scale_end: Option<f64>,
    /// Strongest growth at each speed; at most fifty marks are drawn.
    pub ridge: Vec<RidgeMark>,
    /// Lines of growth, the strongest first; the first few are named by their frequency.
    pub branches: Vec<BranchLine>,
    /// Constant frequency that describes the strongest branch best, Hz.
    pub best_fit_frequency_hz: Option<f64>,
    /// Frequencies of the other rays V = fλ, Hz; see
    /// [`constant_frequency_rays`](crate::constant_frequency_rays).
    pub rays_hz: Vec<f64>,
    /// Corrugation found in track.
    pub observations: Vec<Observation>,
    /// Second grid like `values`, shown under the pointer in HTML.
    pub hover_values: Option<Vec<f64>>,
    /// Quantity and unit of `hover_values`.
    pub hover_label: String,
}

impl Default for MapPanel {
    /// An empty panel of ten steps whose second grid is the growth rate per passage.
    fn default() -> Self {
        MapPanel {
            subtitle: String::new(),
            wavelength_m: Vec::new(),
            speed_m_per_s: Vec::new(),
            values: Vec::new(),
            value_label: String::new(),
            level_count: 10,
            scale_end: None,
            ridge: Vec::new(),
            branches: Vec::new(),
            best_fit_frequency_hz: None,
            rays_hz: Vec::new(),
            observations: Vec::new(),
            hover_values: None,
            hover_label: "growth rate per passage".to_owned(),
        }
    }
}

/// One or more maps of growth over wavelength and speed, two of them side by side.
///
/// Filled contours run in equal steps from 0 down to the smallest value of each panel, or to the end of a scale
/// that panels share: only growth is coloured, darker where it is stronger, and a corrugation that decays leaves the paper white.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MapFigure {
    /// Title above the figure.
    pub title: String,
    /// Words below the figure: the parameters and the sign convention.
    pub caption: String,
    /// The maps.
    pub panels: Vec<MapPanel>,
}

impl MapFigure {
    /// Give all panels one scale of colours, which ends at the smallest value of any.
    #[must_use]
    pub fn with_one_scale(mut self) -> Self {
        let strongest = self.panels.iter().filter_map(MapPanel::strongest_growth);
        let end = strongest.reduce(f64::min);
        for panel in &mut self.panels {
            panel.scale_end = end;
        }
        self
    }

    /// Labels of all observations in the order of their first appearance: each keeps its mark in
    /// all panels.
    pub(crate) fn observation_labels(&self) -> Vec<&str> {
        let mut labels: Vec<&str> = Vec::new();
        for observation in self.panels.iter().flat_map(|panel| &panel.observations) {
            if !labels.contains(&observation.label.as_str()) {
                labels.push(&observation.label);
            }
        }
        labels
    }

    pub(crate) fn check(&self) -> Result<(), PlotError> {
        if self.panels.is_empty() {
            return Err(PlotError::NoPanel);
        }
        self.panels.iter().enumerate().try_for_each(|(index, panel)| panel.check(index))
    }
}

impl MapPanel {
    fn check(&self, panel: usize) -> Result<(), PlotError> {
        check_axis(panel, "wavelength_m", &self.wavelength_m)?;
        check_axis(panel, "speed_m_per_s", &self.speed_m_per_s)?;
        let (rows, columns) = (self.speed_m_per_s.len(), self.wavelength_m.len());
        let grids = [("values", Some(&self.values)), ("hover_values", self.hover_values.as_ref())];
        for (what, values) in grids {
            let found = values.map_or(rows * columns, Vec::len);
            if found != rows * columns {
                return Err(PlotError::GridShape { panel, what, found, rows, columns });
            }
        }
        Ok(())
    }

    /// The values as a grid.
    pub(crate) fn grid(&self) -> Grid {
        Grid { x: self.wavelength_m.clone(), y: self.speed_m_per_s.clone(), values: self.values.clone() }
    }

    /// The steps of the colours, `None` if nothing grows.
    pub(crate) fn steps(&self) -> Option<Steps> {
        let least = self.scale_end.or_else(|| self.strongest_growth());
        Steps::new(least, self.level_count)
    }

    /// The smallest value, where one is negative.
    pub fn strongest_growth(&self) -> Option<f64> {
        self.grid().strongest_growth()
    }

    /// Range of the axes.
    pub(crate) fn window(&self) -> Window {
        let range = |points: &[f64]| (points[0], points[points.len() - 1]);
        Window { wavelength_m: range(&self.wavelength_m), speed_m_per_s: range(&self.speed_m_per_s) }
    }

    /// Branches besides the strongest that are named by their frequency.
    pub(crate) fn weaker_branches(&self) -> impl Iterator<Item = &BranchLine> {
        self.branches.iter().take(NAMED_BRANCHES).skip(1)
    }

    /// Rays other than the best fit; one that would run together with it is left out.
    pub(crate) fn other_rays(&self) -> impl Iterator<Item = f64> {
        let best = self.best_fit_frequency_hz;
        self.rays_hz.iter().copied().filter(move |ray| best.is_none_or(|best| (ray / best - 1.0).abs() > 0.02))
    }
}
