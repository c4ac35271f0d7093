//! Figures 6–8: the highest growth over speed, tractive ratio and inertia.

use riffel::{Axis, Ridge, RidgePoint};
use riffel_case::Case;
use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, Scale, Series};

use super::{PaperFigure, lines, nominal};
use crate::map_figure::parameters;

/// Speed of Fig. 8 \[m/s\].
const SPEED: f64 = 30.0;

const MINIMUM_LABEL: &str = "min Re Ŵ₁ [-]";

/// The two limits of the inertia and, between them, half, once and twice the nominal.
const INERTIAS: [(&str, &str, LineStyle); 5] = [
    (
        "I_w → 0",
        "wheel.rotation=constant-tangential-force",
        LineStyle::Dashed,
    ),
    ("13.89 kg m²", "wheel.inertia=13.885", LineStyle::Solid),
    ("27.77 kg m²", "wheel.inertia=27.77", LineStyle::Solid),
    ("55.54 kg m²", "wheel.inertia=55.54", LineStyle::Solid),
    (
        "I_w → ∞",
        "wheel.rotation=constant-creepage",
        LineStyle::Dotted,
    ),
];

/// The nominal case with one value changed.
fn with(assignment: String) -> miette::Result<Case> {
    nominal(&[assignment])
}

/// The ridge of the nominal window over speeds of 5–40 m/s.
fn ridge(case: &Case) -> miette::Result<Vec<RidgePoint>> {
    Ok(search(case, 5.0, 40.0, 141)?.points)
}

fn search(case: &Case, from: f64, to: f64, points: usize) -> miette::Result<Ridge> {
    let speed = Axis::new(from, to, points).map_err(|error| miette::miette!("{error}"))?;
    Ok(Ridge::search(&case.feedback, case.wavelength, speed))
}

/// The smallest Re Ŵ₁ at the speed of Fig. 8.
fn minimum(case: &Case) -> miette::Result<f64> {
    Ok(search(case, SPEED, SPEED + 1.0, 2)?.points[0].normalized_dissipation)
}

fn curve(
    label: &str,
    style: LineStyle,
    points: &[RidgePoint],
    value: impl Fn(&RidgePoint) -> f64,
) -> Series {
    Series {
        label: label.to_owned(),
        x: points.iter().map(|point| point.speed).collect(),
        y: points.iter().map(value).collect(),
        style,
        color: None,
    }
}

fn over_speed(subtitle: &str, y_label: &str, series: Vec<Series>) -> LinePanel {
    LinePanel {
        subtitle: subtitle.to_owned(),
        x_label: "speed V [m/s]".to_owned(),
        y_label: y_label.to_owned(),
        series,
        ..LinePanel::default()
    }
}

/// A value for each inertia over speed.
fn over_inertia(value: fn(&RidgePoint) -> f64) -> miette::Result<Vec<Series>> {
    INERTIAS
        .iter()
        .map(|&(label, assignment, style)| {
            Ok(curve(
                label,
                style,
                &ridge(&with(assignment.to_owned())?)?,
                value,
            ))
        })
        .collect()
}

pub(super) fn figure_6() -> miette::Result<PaperFigure> {
    let by_ratio = [0.1, 0.3, 0.5, 0.7, 0.95]
        .iter()
        .map(|ratio| {
            let points = ridge(&with(format!("contact.tractive_ratio={ratio}"))?)?;
            let label = format!("τ = {ratio}");
            Ok(curve(&label, LineStyle::Solid, &points, |point| {
                point.normalized_dissipation
            }))
        })
        .collect::<miette::Result<Vec<Series>>>()?;
    // A minimum at the edge of the window is no line of growth.
    let wavelengths = over_inertia(|point| match point.at_edge {
        true => f64::NAN,
        false => 1e3 * point.wavelength,
    })?;
    lines(&LineFigure {
        title: "Figure 6. Highest growth over speed".to_owned(),
        caption: format!(
            "Minima over wavelengths of 20–80 mm; (b) leaves out minima at the edge of the window. {}",
            parameters(&nominal(&[])?)
        ),
        panels: vec![
            over_speed("(a) tractive ratio", MINIMUM_LABEL, by_ratio),
            over_speed("(b) inertia, τ = 0.1", "wavelength λ [mm]", wavelengths),
        ],
        arrangement: Arrangement::SideBySide,
    })
}

pub(super) fn figure_7() -> miette::Result<PaperFigure> {
    lines(&LineFigure {
        title: "Figure 7. Highest growth over speed for different inertia".to_owned(),
        caption: format!(
            "Minima over wavelengths of 20–80 mm. {}",
            parameters(&nominal(&[])?)
        ),
        panels: vec![over_speed(
            "τ = 0.1",
            MINIMUM_LABEL,
            over_inertia(|point| point.normalized_dissipation)?,
        )],
        arrangement: Arrangement::SideBySide,
    })
}

pub(super) fn figure_8() -> miette::Result<PaperFigure> {
    let sweep = |key: &str, x: Vec<f64>| -> miette::Result<Series> {
        let y = x
            .iter()
            .map(|value| minimum(&with(format!("{key}={value}"))?))
            .collect::<miette::Result<_>>()?;
        Ok(Series {
            x,
            y,
            ..Series::default()
        })
    };
    let ratios = (1..100).map(|step| f64::from(step) / 100.0).collect();
    let inertias = (0..=80)
        .map(|step| 10f64.powf(f64::from(step) / 20.0 - 1.0))
        .collect();
    let panel = |subtitle: &str, x_label: &str, x_scale, series| LinePanel {
        subtitle: subtitle.to_owned(),
        x_label: x_label.to_owned(),
        y_label: MINIMUM_LABEL.to_owned(),
        x_scale,
        series: vec![series],
        ..LinePanel::default()
    };
    lines(&LineFigure {
        title: format!("Figure 8. Highest growth at {SPEED} m/s"),
        caption: format!(
            "Minima over wavelengths of 20–80 mm. (a) falls up to τ ≈ 0.9 only. {}",
            parameters(&nominal(&[])?)
        ),
        panels: vec![
            panel(
                "(a)",
                "tractive ratio τ [-]",
                Scale::Linear,
                sweep("contact.tractive_ratio", ratios)?,
            ),
            panel(
                "(b) τ = 0.1",
                "inertia I_w [kg m²]",
                Scale::Log,
                sweep("wheel.inertia", inertias)?,
            ),
        ],
        arrangement: Arrangement::SideBySide,
    })
}
