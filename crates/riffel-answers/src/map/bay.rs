//! Growth over a sleeper bay.

use riffel::growth::{Bay, BayMaps};
use riffel::{Axis, LoopState, Ridge};
use riffel_case::{Case, ask};
use riffel_keys::{Message, fixed, number, say};
use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, MapFigure, Mark, Series};
use serde::Serialize;

use super::{Shown, panel, table};
use crate::parameters::parameters;
use crate::ridge::{BranchDocument, best_fit_frequency, branches_table, ridge_of, ridge_table};
use crate::{AnswerError, Result, ResultFile, Rows, Table};

/// Points of the curve from one support to the next.
const POINTS: usize = 121;

/// A wavelength with growth rates over a support, in mid-span and of the mean.
type Rates = (f64, [f64; 3]);

/// Growth over a sleeper bay: serialised, a part of what `riffel map --bay --json` prints.
#[derive(Serialize)]
pub struct BayGrowth {
    wavelength_m: f64,
    speed_m_per_s: f64,
    growth_rate_over_support: f64,
    growth_rate_mid_span: f64,
    growth_rate_mean: f64,
    /// That of the strongest branch of the mean.
    mean_ridge_best_fit_frequency_hz: Option<f64>,
    /// The strongest first.
    mean_ridge_branches: Vec<BranchDocument>,
    #[serde(skip)]
    spacing: f64,
    #[serde(skip)]
    maps: BayMaps,
    /// Ridges over a support, in mid-span and of the mean.
    #[serde(skip)]
    ridges: [Ridge; 3],
    #[serde(skip)]
    states: Vec<(f64, LoopState)>,
    /// At the speed of the curve.
    #[serde(skip)]
    spectrum: Vec<Rates>,
}

impl BayGrowth {
    /// The curve stands at the wavelength \[m\] and speed \[m/s\] given, or where the mean grows
    /// fastest.
    ///
    /// `progress` is told of rows done: [`map_count`](Self::map_count) for each speed.
    ///
    /// # Errors
    /// [`AnswerError::NoBay`] for a case without discrete supports.
    pub fn new(case: &Case, curve: Option<(f64, f64)>, progress: impl Fn(usize) + Sync) -> Result<Self> {
        let structure = case.track.structure.clone();
        let bay = structure
            .and_then(|track| Bay::new(&case.feedback, track))
            .ok_or_else(|| AnswerError::NoBay { model: case.file.track.model.name() })?;
        let maps = bay.maps(case.wavelength, case.speed, progress);
        let ridges = [
            ridge_of(case, &bay.at(0.0)),
            ridge_of(case, &bay.at(0.5 * bay.spacing())),
            ask::growth_window(case).map_or_else(Ridge::nothing, |window| bay.ridge(&maps.mean, window)),
        ];
        let fastest = ridges[2].highest();
        let (wavelength, speed) = curve
            .or_else(|| fastest.map(|point| (point.wavelength, point.speed)))
            .unwrap_or((case.wavelength.min(), case.speed.min()));
        let rate = maps.mean.growth_rate_per_dissipation();
        let states = bay.states(wavelength, speed, POINTS);
        Ok(Self {
            wavelength_m: wavelength,
            speed_m_per_s: speed,
            growth_rate_over_support: states[0].1.growth_rate,
            growth_rate_mid_span: states[POINTS / 2].1.growth_rate,
            growth_rate_mean: rate * bay.mean_normalized_dissipation(wavelength, speed).re,
            mean_ridge_best_fit_frequency_hz: best_fit_frequency(&ridges[2]),
            mean_ridge_branches: BranchDocument::all(case, &ridges[2]),
            spacing: bay.spacing(),
            states,
            spectrum: spectrum(&bay, case.wavelength, speed, rate),
            maps,
            ridges,
        })
    }

    /// Maps that are computed.
    pub fn map_count() -> usize {
        Bay::map_count()
    }

    /// In words.
    pub(super) fn sentences(&self) -> [Message; 2] {
        let rate = |rate: f64| number(format_args!("{rate:.2e}"));
        [
            say!(
                growth_over_the_bay,
                wavelength = fixed(1e3 * self.wavelength_m, 1),
                speed = fixed(3.6 * self.speed_m_per_s, 0),
                support = rate(self.growth_rate_over_support),
                span = rate(self.growth_rate_mid_span),
                mean = rate(self.growth_rate_mean),
                // What is sharper than the passing of supports is blurred in truth.
                passing = fixed(self.speed_m_per_s / self.spacing, 0)
            ),
            say!(branches_over_the_bay, branches = BranchDocument::sentence(&self.mean_ridge_branches)),
        ]
    }

    /// Its pictures and tables.
    pub(super) fn files(&self, case: &Case) -> impl Iterator<Item = ResultFile<'_>> {
        let (mean, ridge) = (&self.maps.mean, &self.ridges[2]);
        let tables = [self.over_places(), self.over_wavelengths()].map(ResultFile::Table);
        [ResultFile::Maps("bay-map", self.map_figure(case)), ResultFile::Lines("bay", self.curve_figure(case))]
            .into_iter()
            .chain(tables)
            .chain([
                ResultFile::Map("bay-mean", mean),
                ResultFile::Grid("bay-mean", table::grid(mean, "Mean over the bay".to_owned())),
                ResultFile::Table(ridge_table("bay-mean-ridge", ridge)),
                ResultFile::Table(branches_table("bay-mean-branches", ridge)),
            ])
    }

    /// Maps over a support, in mid-span and of the mean on one scale.
    fn map_figure(&self, case: &Case) -> MapFigure {
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
    fn curve_figure(&self, case: &Case) -> LineFigure {
        let series = |label: &str, style, x: Vec<f64>, y: Vec<f64>| Series::new(label, x, y).styled(style);
        let positions: Vec<f64> = self.states.iter().map(|(position, _)| *position).collect();
        let ends = vec![0.0, self.spacing];
        let along = LinePanel {
            marks: vec![Mark { x: 0.5 * self.spacing, label: "mid-span".to_owned() }],
            ..LinePanel::new(
                "distance from a support [m]",
                "growth rate per passage [-]",
                [
                    series(
                        "wheel at this place",
                        LineStyle::Solid,
                        positions,
                        self.states.iter().map(|(_, state)| state.growth_rate).collect(),
                    ),
                    series("mean over the bay", LineStyle::Dashed, ends, vec![self.growth_rate_mean; 2]),
                ],
            )
            .titled(format!("at {:.1} mm", 1e3 * self.wavelength_m))
        };
        let wavelengths: Vec<f64> = self.spectrum.iter().map(|(wavelength, _)| 1e3 * wavelength).collect();
        let rates = |place: usize| self.spectrum.iter().map(|(_, rates)| rates[place]).collect();
        let over = LinePanel {
            marks: vec![Mark { x: 1e3 * self.wavelength_m, label: String::new() }],
            ..LinePanel::new(
                "wavelength λ [mm]",
                "growth rate per passage [-]",
                [
                    series("over a support", LineStyle::Solid, wavelengths.clone(), rates(0)),
                    series("in mid-span", LineStyle::Dotted, wavelengths.clone(), rates(1)),
                    series("mean over the bay", LineStyle::Dashed, wavelengths, rates(2)),
                ],
            )
            .titled(format!("over wavelength at {:.0} km/h", 3.6 * self.speed_m_per_s))
        };
        LineFigure::new(
            "Growth over a sleeper bay",
            format!(
                "Quasi-static in position: at each place as if the wheel stayed there. Positive where \
                 corrugation grows. {}",
                parameters(case)
            ),
            [along, over],
        )
        .arranged(Arrangement::Stacked)
    }

    /// One row for each place of the bay.
    fn over_places(&self) -> Table {
        let states = &self.states;
        Table {
            name: "bay",
            columns: vec![
                states.exact("position_m", |(position, _)| *position),
                states.exact("wavelength_m", |_| self.wavelength_m),
                states.exact("speed_m_per_s", |_| self.speed_m_per_s),
                states.exact("normalized_dissipation_re", |(_, state)| state.normalized_dissipation.re),
                states.exact("normalized_dissipation_im", |(_, state)| state.normalized_dissipation.im),
                states.exact("growth_rate_per_passage", |(_, state)| state.growth_rate),
            ],
        }
    }

    /// One row for each wavelength at the speed of the curve.
    fn over_wavelengths(&self) -> Table {
        let spectrum = &self.spectrum;
        Table {
            name: "bay-wavelength",
            columns: vec![
                spectrum.exact("wavelength_m", |(wavelength, _)| *wavelength),
                spectrum.exact("speed_m_per_s", |_| self.speed_m_per_s),
                spectrum.exact("growth_rate_over_support", |(_, rates)| rates[0]),
                spectrum.exact("growth_rate_mid_span", |(_, rates)| rates[1]),
                spectrum.exact("growth_rate_mean", |(_, rates)| rates[2]),
            ],
        }
    }
}

/// Growth rates over the wavelengths at one speed.
fn spectrum(bay: &Bay, wavelength: Axis, speed: f64, rate: f64) -> Vec<Rates> {
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
