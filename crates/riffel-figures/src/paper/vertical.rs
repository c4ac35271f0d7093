//! Figures 2 and 3: vertical receptance and normal force over frequency.

use riffel::{Complex64, LoopState};
use riffel_case::Case;
use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, Scale, Series};

use super::{Model, PaperFigure, lines};
use crate::FigureError;
use crate::map::parameters;
use crate::track_in_words::track;

/// Speed of both figures \[m/s\].
const SPEED: f64 = 27.8;
const MOVING_BEAM: &str = "track.model=moving-beam";

/// Frequencies from 20 Hz to 3 kHz \[Hz\], equally spaced in their logarithm.
fn frequencies() -> Vec<f64> {
    (0..=600)
        .map(|step| 20.0 * 150f64.powf(f64::from(step) / 600.0))
        .collect()
}

fn series(case: &Case, label: &str, style: LineStyle, value: impl Fn(&LoopState) -> f64) -> Series {
    let x = frequencies();
    let state = |frequency: &f64| case.feedback.at(SPEED / frequency, SPEED);
    Series {
        label: label.to_owned(),
        y: x.iter().map(|frequency| value(&state(frequency))).collect(),
        x,
        style,
        color: None,
    }
}

fn panel(subtitle: &str, y_label: &str, y_scale: Scale, series: Vec<Series>) -> LinePanel {
    LinePanel {
        subtitle: subtitle.to_owned(),
        x_label: "frequency f [Hz]".to_owned(),
        y_label: y_label.to_owned(),
        x_scale: Scale::Log,
        y_scale,
        series,
        ..LinePanel::default()
    }
}

pub(super) fn figure_2(model: Model) -> Result<PaperFigure, FigureError> {
    let moving = model.nominal(&[MOVING_BEAM.to_owned()])?;
    let bhaskar = model.bhaskar_track(&[])?;
    let curves = |value: fn(Complex64) -> f64| {
        vec![
            series(
                &moving,
                "beam under a moving load",
                LineStyle::Solid,
                |state| value(state.track_receptance),
            ),
            series(
                &bhaskar,
                "track of Bhaskar et al. (inferred)",
                LineStyle::Dashed,
                |state| value(state.track_receptance),
            ),
        ]
    };
    lines(LineFigure {
        title: model.title("Figure 2. Vertical direct receptance"),
        caption: format!(
            "Load at {SPEED} m/s, exp(+iωt), displacement and force downward. Solid: {}. Dashed: {}.",
            track(&moving),
            track(&bhaskar)
        ),
        panels: vec![
            panel("modulus", "|H| [m/N]", Scale::Log, curves(|h| h.norm())),
            panel(
                "phase",
                "arg H [°]",
                Scale::Linear,
                curves(|h| h.arg().to_degrees()),
            ),
        ],
        arrangement: Arrangement::Stacked,
    })
}

pub(super) fn figure_3(model: Model) -> Result<PaperFigure, FigureError> {
    let case = model.nominal(&[MOVING_BEAM.to_owned()])?;
    let mean = case.hertz.normal_force();
    let per_mean = case.feedback.amplitude / mean;
    let spring = per_mean * case.feedback.contact_stiffness;
    lines(LineFigure {
        title: model.title("Figure 3. Normal force"),
        caption: format!("V = {SPEED} m/s, equation (24). {}", parameters(&case)),
        panels: vec![
            LinePanel {
                y_range: Some((1e-2, 1e1)),
                ..panel(
                    "amplitude",
                    "|P₁/P₀| [-]",
                    Scale::Log,
                    vec![
                        series(&case, "Δ/H rail", LineStyle::Dashed, |state| {
                            per_mean / state.track_receptance.norm()
                        }),
                        series(&case, "Δ/H wheel", LineStyle::Dashed, |state| {
                            per_mean / state.wheel_receptance.norm()
                        }),
                        series(&case, "Δ k_H", LineStyle::Dashed, |_| spring),
                        series(&case, "P₁/P₀", LineStyle::Solid, |state| {
                            state.normal_force.norm() / mean
                        }),
                    ],
                )
            },
            panel(
                "phase",
                "arg P₁ [°]",
                Scale::Linear,
                vec![series(&case, "", LineStyle::Solid, |state| {
                    state.normal_force.arg().to_degrees()
                })],
            ),
        ],
        arrangement: Arrangement::Stacked,
    })
}
