//! Figures 2 and 3: vertical receptance and normal force over frequency.

use riffel::{Complex64, LoopState};
use riffel_case::Case;
use riffel_keys::Language;
use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, Scale, Series};

use super::{Model, PaperFigure, lines};
use crate::AnswerError;
use crate::parameters::parameters_in;
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

fn panel(
    language: Language,
    subtitle: &str,
    y_label: &str,
    y_scale: Scale,
    series: Vec<Series>,
) -> LinePanel {
    LinePanel {
        subtitle: subtitle.to_owned(),
        x_label: language
            .pick("frequency f [Hz]", "Frequenz f [Hz]")
            .to_owned(),
        y_label: y_label.to_owned(),
        x_scale: Scale::Log,
        y_scale,
        series,
        ..LinePanel::default()
    }
}

pub(super) fn figure_2(model: Model, language: Language) -> Result<PaperFigure, AnswerError> {
    let moving = model.nominal(&[MOVING_BEAM.to_owned()])?;
    let bhaskar = model.bhaskar_track(&[])?;
    let curves = |value: fn(Complex64) -> f64| {
        vec![
            series(
                &moving,
                language.pick("beam under a moving load", "Balken unter wandernder Last"),
                LineStyle::Solid,
                |state| value(state.track_receptance),
            ),
            series(
                &bhaskar,
                language.pick(
                    "track of Bhaskar et al. (inferred)",
                    "Gleis von Bhaskar et al. (erschlossen)",
                ),
                LineStyle::Dashed,
                |state| value(state.track_receptance),
            ),
        ]
    };
    let (solid, dashed) = (track(&moving, language), track(&bhaskar, language));
    let title = language.pick(
        "Figure 2. Vertical direct receptance",
        "Bild 2. Vertikale Eingangsrezeptanz",
    );
    lines(language, LineFigure {
        title: model.title(title, language),
        caption: language.pick(
            format!("Load at {SPEED} m/s, exp(+iωt), displacement and force downward. Solid: {solid}. Dashed: {dashed}."),
            format!("Last mit {SPEED} m/s, exp(+iωt), Weg und Kraft nach unten. Durchgezogen: {solid}. Gestrichelt: {dashed}."),
        ),
        panels: vec![
            panel(language, language.pick("modulus", "Betrag"), "|H| [m/N]", Scale::Log, curves(|h| h.norm())),
            panel(
                language,
                language.pick("phase", "Phase"),
                "arg H [°]",
                Scale::Linear,
                curves(|h| h.arg().to_degrees()),
            ),
        ],
        arrangement: Arrangement::Stacked,
    })
}

pub(super) fn figure_3(model: Model, language: Language) -> Result<PaperFigure, AnswerError> {
    let case = model.nominal(&[MOVING_BEAM.to_owned()])?;
    let mean = case.hertz.normal_force();
    let per_mean = case.feedback.amplitude / mean;
    let spring = per_mean * case.feedback.contact_stiffness;
    let title = language.pick("Figure 3. Normal force", "Bild 3. Normalkraft");
    let parameters = parameters_in(&case, language);
    lines(
        language,
        LineFigure {
            title: model.title(title, language),
            caption: language.pick(
                format!("V = {SPEED} m/s, equation (24). {parameters}"),
                format!("V = {SPEED} m/s, Gleichung (24). {parameters}"),
            ),
            panels: vec![
                LinePanel {
                    y_range: Some((1e-2, 1e1)),
                    ..panel(
                        language,
                        language.pick("amplitude", "Amplitude"),
                        "|P₁/P₀| [-]",
                        Scale::Log,
                        vec![
                            series(
                                &case,
                                language.pick("Δ/H rail", "Δ/H Schiene"),
                                LineStyle::Dashed,
                                |state| per_mean / state.track_receptance.norm(),
                            ),
                            series(
                                &case,
                                language.pick("Δ/H wheel", "Δ/H Rad"),
                                LineStyle::Dashed,
                                |state| per_mean / state.wheel_receptance.norm(),
                            ),
                            series(&case, "Δ k_H", LineStyle::Dashed, |_| spring),
                            series(&case, "P₁/P₀", LineStyle::Solid, |state| {
                                state.normal_force.norm() / mean
                            }),
                        ],
                    )
                },
                panel(
                    language,
                    language.pick("phase", "Phase"),
                    "arg P₁ [°]",
                    Scale::Linear,
                    vec![series(&case, "", LineStyle::Solid, |state| {
                        state.normal_force.arg().to_degrees()
                    })],
                ),
            ],
            arrangement: Arrangement::Stacked,
        },
    )
}
