//! Figures 2 and 3: vertical receptance and normal force over frequency.

use riffel::{Complex64, LoopState};
use riffel_case::Case;
use riffel_case::file::{CaseFile, TrackModel};
use riffel_keys::{Language, say};
use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, Scale, Series};

use super::{Model, PaperFigure, lines};
use crate::Result;
use crate::parameters::parameters_in;
use crate::track_in_words::track;

/// Speed of both figures \[m/s\].
const SPEED: f64 = 27.8;

fn moving_beam(keys: &mut CaseFile) {
    keys.track.model = TrackModel::MovingBeam;
}

/// Frequencies from 20 Hz to 3 kHz \[Hz\], equally spaced in their logarithm.
fn frequencies() -> Vec<f64> {
    (0..=600).map(|step| 20.0 * 150f64.powf(f64::from(step) / 600.0)).collect()
}

fn series(case: &Case, label: &str, style: LineStyle, value: impl Fn(&LoopState) -> f64) -> Series {
    let x = frequencies();
    let state = |frequency: &f64| case.feedback.at(SPEED / frequency, SPEED);
    let y = x.iter().map(|frequency| value(&state(frequency))).collect();
    Series::new(label, x, y).styled(style)
}

fn panel(language: Language, subtitle: &str, y_label: &str, y_scale: Scale, series: Vec<Series>) -> LinePanel {
    LinePanel::new(say!(frequency_axis).text(language), y_label, series).titled(subtitle).scaled(Scale::Log, y_scale)
}

pub(super) fn figure_2(model: Model, language: Language) -> Result<PaperFigure> {
    let moving = model.nominal(moving_beam)?;
    let bhaskar = model.bhaskar_track(|_| ())?;
    let curves = |value: fn(Complex64) -> f64| {
        vec![
            series(&moving, &say!(beam_under_moving_load).text(language), LineStyle::Solid, |state| {
                value(state.normal_receptance())
            }),
            series(&bhaskar, &say!(track_of_bhaskar).text(language), LineStyle::Dashed, |state| {
                value(state.normal_receptance())
            }),
        ]
    };
    let (solid, dashed) = (track(&moving, language), track(&bhaskar, language));
    let title = say!(figure_2).text(language);
    Ok(lines(
        language,
        LineFigure::new(
            model.title(&title, language),
            say!(caption_of_figure_2, speed = SPEED, solid, dashed).text(language),
            [
                panel(language, &say!(modulus).text(language), "|H| [m/N]", Scale::Log, curves(|h| h.norm())),
                panel(
                    language,
                    &say!(phase).text(language),
                    "arg H [°]",
                    Scale::Linear,
                    curves(|h| h.arg().to_degrees()),
                ),
            ],
        )
        .arranged(Arrangement::Stacked),
    ))
}

pub(super) fn figure_3(model: Model, language: Language) -> Result<PaperFigure> {
    let case = model.nominal(moving_beam)?;
    let mean = case.hertz.normal_force();
    let per_mean = case.feedback.amplitude() / mean;
    let spring = per_mean * case.feedback.contacts()[0].stiffness;
    let title = say!(figure_3).text(language);
    let parameters = parameters_in(&case, language);
    Ok(lines(
        language,
        LineFigure::new(
            model.title(&title, language),
            say!(caption_of_figure_3, speed = SPEED, parameters).text(language),
            [
                LinePanel {
                    y_range: Some((1e-2, 1e1)),
                    ..panel(
                        language,
                        &say!(amplitude).text(language),
                        "|P₁/P₀| [-]",
                        Scale::Log,
                        vec![
                            series(&case, &say!(profile_over_rail).text(language), LineStyle::Dashed, |state| {
                                per_mean / state.normal_receptance().norm()
                            }),
                            series(&case, &say!(profile_over_wheel).text(language), LineStyle::Dashed, |state| {
                                let w = state.angular_frequency;
                                let [_, wheel] = case.feedback.normal_receptances(w, SPEED);
                                per_mean / wheel.norm()
                            }),
                            series(&case, "Δ k_H", LineStyle::Dashed, |_| spring),
                            series(&case, "P₁/P₀", LineStyle::Solid, |state| state.normal_force().norm() / mean),
                        ],
                    )
                },
                panel(
                    language,
                    &say!(phase).text(language),
                    "arg P₁ [°]",
                    Scale::Linear,
                    vec![series(&case, "", LineStyle::Solid, |state| state.normal_force().arg().to_degrees())],
                ),
            ],
        )
        .arranged(Arrangement::Stacked),
    ))
}
