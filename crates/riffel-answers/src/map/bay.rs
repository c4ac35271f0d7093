//! Growth over a sleeper bay.

use std::io::{self, Write};

use riffel::LoopState;
use riffel::growth::{Bay, BayMaps};
use riffel::{Axis, GrowthMap, Ridge};
use riffel_case::Case;
use riffel_keys::say;
use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, MapFigure, Mark, Series};
use serde::Serialize;

use super::{Shown, panel};
use crate::AnswerError;
use crate::parameters::parameters;
use crate::ridge::{BranchDocument, best_fit_frequency, ridge_of};

/// Points of the curve from one support to the next.
const POINTS: usize = 121;

/// Growth over a sleeper bay.
pub struct BayGrowth {
    /// Branches of the ridge of the mean, the strongest first.
    branches: Vec<BranchDocument>,
    spacing: f64,
    maps: BayMaps,
    /// Ridges over a support, in mid-span and of the mean.
    ridges: [Ridge; 3],
    wavelength: f64,
    speed: f64,
    states: Vec<(f64, LoopState)>,
    mean: f64,
    /// At the speed of the curve: each wavelength with the growth rates over a support, in mid-span
    /// and of the mean.
    spectrum: Vec<(f64, [f64; 3])>,
}

/// The part of the document of a map on the bay.
#[derive(Serialize)]
pub struct BayDocument {
    wavelength_m: f64,
    speed_m_per_s: f64,
    growth_rate_over_support: f64,
    growth_rate_mid_span: f64,
    growth_rate_mean: f64,
    /// That of the strongest branch of the mean.
    mean_ridge_best_fit_frequency_hz: Option<f64>,
    /// The strongest first.
    mean_ridge_branches: Vec<BranchDocument>,
}

impl BayGrowth {
    /// The curve stands at the wavelength \[m\] and speed \[m/s\] given, or where the mean grows
    /// fastest.
    ///
    /// `progress` is told of rows done: [`map_count`](Self::map_count) for each speed.
    ///
    /// # Errors
    /// [`AnswerError::NoBay`] for a case without discrete supports.
    pub fn new(case: &Case, curve: Option<(f64, f64)>, progress: impl Fn(usize) + Sync) -> Result<Self, AnswerError> {
        let structure = case.track.structure.clone();
        let bay = structure
            .and_then(|track| Bay::new(&case.feedback, track))
            .ok_or_else(|| AnswerError::NoBay { model: case.file.track.model.name() })?;
        let maps = bay.maps(case.wavelength, case.speed, progress);
        let ridges = [
            ridge_of(case, &bay.at(0.0)),
            ridge_of(case, &bay.at(0.5 * bay.spacing())),
            case.growth_window().map_or_else(Ridge::nothing, |window| bay.ridge(&maps.mean, window)),
        ];
        let fastest = ridges[2].highest();
        let (wavelength, speed) = curve
            .or_else(|| fastest.map(|point| (point.wavelength, point.speed)))
            .unwrap_or((case.wavelength.min(), case.speed.min()));
        let rate = maps.mean.growth_rate_per_dissipation();
        Ok(Self {
            branches: BranchDocument::all(case, &ridges[2]),
            spacing: bay.spacing(),
            states: bay.states(wavelength, speed, POINTS),
            mean: rate * bay.mean_normalized_dissipation(wavelength, speed).re,
            spectrum: spectrum(&bay, case.wavelength, speed, rate),
            maps,
            ridges,
            wavelength,
            speed,
        })
    }

    /// Maps that are computed.
    pub fn map_count() -> usize {
        Bay::map_count()
    }

    /// Growth over the bay as data: a part of what `riffel map --bay --json` prints.
    pub fn summary(&self) -> BayDocument {
        let at = |index: usize| self.states[index].1.growth_rate;
        BayDocument {
            wavelength_m: self.wavelength,
            speed_m_per_s: self.speed,
            growth_rate_over_support: at(0),
            growth_rate_mid_span: at(POINTS / 2),
            growth_rate_mean: self.mean,
            mean_ridge_best_fit_frequency_hz: best_fit_frequency(&self.ridges[2]),
            mean_ridge_branches: self.branches.clone(),
        }
    }

    /// One sentence for the terminal.
    pub fn sentence(&self) -> String {
        let BayDocument { growth_rate_over_support, growth_rate_mid_span, growth_rate_mean, .. } = self.summary();
        // What is sharper than the passing of supports is blurred in truth.
        let passing = self.speed / self.spacing;
        format!(
            "over the bay at {:.1} mm and {:.0} km/h: growth rate {growth_rate_over_support:.2e} over a \
             support, {growth_rate_mid_span:.2e} in mid-span, {growth_rate_mean:.2e} in the mean (quasi-static in \
             position: lines sharper than {passing:.0} Hz, the passing of supports, are overstated)\n\
             in the mean over the bay, {}",
            1e3 * self.wavelength,
            3.6 * self.speed,
            BranchDocument::sentence(&self.branches)
        )
    }

    /// The map of the mean, and its ridge.
    pub fn mean(&self) -> (&GrowthMap, &Ridge) {
        (&self.maps.mean, &self.ridges[2])
    }

    /// Maps over a support, in mid-span and of the mean on one scale.
    pub fn map_figure(&self, case: &Case) -> MapFigure {
        let maps = [&self.maps.over_support, &self.maps.mid_span, &self.maps.mean];
        let names = ["over a support", "in mid-span", "mean over the bay"];
        let panels = maps.into_iter().zip(&self.ridges).zip(names);
        MapFigure {
            title: "Growth over a sleeper bay".to_owned(),
            caption: format!("{} {}", parameters(case), say!(sign_of_growth)),
            panels: panels
                .map(|((map, ridge), name)| {
                    let mut panel = panel(case, map, ridge, Shown::Normalized);
                    panel.subtitle = name.to_owned();
                    panel
                })
                .collect(),
        }
        // The places are there to be compared.
        .with_one_scale()
    }

    /// Growth over the places of the bay, and over wavelength.
    pub fn curve_figure(&self, case: &Case) -> LineFigure {
        let series =
            |label: &str, style, x: Vec<f64>, y: Vec<f64>| Series { label: label.to_owned(), x, y, style, color: None };
        let positions: Vec<f64> = self.states.iter().map(|(position, _)| *position).collect();
        let ends = vec![0.0, self.spacing];
        let along = LinePanel {
            subtitle: format!("at {:.1} mm", 1e3 * self.wavelength),
            x_label: "distance from a support [m]".to_owned(),
            y_label: "growth rate per passage [-]".to_owned(),
            series: vec![
                series(
                    "wheel at this place",
                    LineStyle::Solid,
                    positions,
                    self.states.iter().map(|(_, state)| state.growth_rate).collect(),
                ),
                series("mean over the bay", LineStyle::Dashed, ends, vec![self.mean; 2]),
            ],
            marks: vec![Mark { x: 0.5 * self.spacing, label: "mid-span".to_owned() }],
            ..LinePanel::default()
        };
        let wavelengths: Vec<f64> = self.spectrum.iter().map(|(wavelength, _)| 1e3 * wavelength).collect();
        let rates = |place: usize| self.spectrum.iter().map(|(_, rates)| rates[place]).collect();
        let over = LinePanel {
            subtitle: format!("over wavelength at {:.0} km/h", 3.6 * self.speed),
            x_label: "wavelength λ [mm]".to_owned(),
            y_label: "growth rate per passage [-]".to_owned(),
            series: vec![
                series("over a support", LineStyle::Solid, wavelengths.clone(), rates(0)),
                series("in mid-span", LineStyle::Dotted, wavelengths.clone(), rates(1)),
                series("mean over the bay", LineStyle::Dashed, wavelengths, rates(2)),
            ],
            marks: vec![Mark { x: 1e3 * self.wavelength, label: String::new() }],
            ..LinePanel::default()
        };
        LineFigure {
            title: "Growth over a sleeper bay".to_owned(),
            caption: format!(
                "Quasi-static in position: at each place as if the wheel stayed there. Positive where \
                 corrugation grows. {}",
                parameters(case)
            ),
            panels: vec![along, over],
            arrangement: Arrangement::Stacked,
        }
    }

    /// One row for each place of the bay.
    ///
    /// # Errors
    /// Those of the file.
    pub fn position_csv(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        writer.write_record([
            "position_m",
            "wavelength_m",
            "speed_m_per_s",
            "normalized_dissipation_re",
            "normalized_dissipation_im",
            "growth_rate_per_passage",
        ])?;
        for (position, state) in &self.states {
            let normalized = state.normalized_dissipation;
            writer.serialize((
                position,
                self.wavelength,
                self.speed,
                normalized.re,
                normalized.im,
                state.growth_rate,
            ))?;
        }
        writer.flush()
    }

    /// One row for each wavelength at the speed of the curve.
    ///
    /// # Errors
    /// Those of the file.
    pub fn wavelength_csv(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        writer.write_record([
            "wavelength_m",
            "speed_m_per_s",
            "growth_rate_over_support",
            "growth_rate_mid_span",
            "growth_rate_mean",
        ])?;
        for (wavelength, [over_support, mid_span, mean]) in &self.spectrum {
            writer.serialize((wavelength, self.speed, over_support, mid_span, mean))?;
        }
        writer.flush()
    }
}

/// Growth rates over the wavelengths at one speed.
fn spectrum(bay: &Bay, wavelength: Axis, speed: f64, rate: f64) -> Vec<(f64, [f64; 3])> {
    /// Enough for a smooth curve.
    const WAVELENGTHS: usize = 401;
    let (over_support, mid_span) = (bay.at(0.0), bay.at(0.5 * bay.spacing()));
    (0..WAVELENGTHS)
        .map(|index| {
            let share = index as f64 / (WAVELENGTHS - 1) as f64;
            let wavelength = wavelength.min() + (wavelength.max() - wavelength.min()) * share;
            let rates = [
                over_support.at(wavelength, speed).growth_rate,
                mid_span.at(wavelength, speed).growth_rate,
                rate * bay.mean_normalized_dissipation(wavelength, speed).re,
            ];
            (wavelength, rates)
        })
        .collect()
}
