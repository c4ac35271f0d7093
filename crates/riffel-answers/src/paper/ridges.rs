//! Figures 6–8: the highest growth over speed, tractive ratio and inertia.

use riffel::growth::RidgePoint;
use riffel::wheelset::{Motion, RigidInertia};
use riffel::{Axis, Ridge};
use riffel_case::Case;
use riffel_keys::quantity::Quantity;
use riffel_keys::{Language, say};
use riffel_plot::{LineFigure, LinePanel, LineStyle, Scale, Series};

use super::{Model, PaperFigure, lines};
use crate::parameters::parameters_in;
use crate::{AnswerError, Result};

/// Speed of Fig. 8 \[m/s\].
const SPEED: f64 = 30.0;

const MINIMUM_LABEL: &str = "min Re Ŵ₁ [-]";

/// How a wheel turns.
#[derive(Clone, Copy)]
enum Turning {
    /// With an inertia \[kg m²\].
    Inertia(f64),
    /// The limit of none.
    Freely,
    /// The limit of an infinite one.
    Evenly,
}

/// The two limits of the inertia and, between them, half, once and twice the nominal.
const INERTIAS: [(&str, Turning, LineStyle); 5] = [
    ("I_w → 0", Turning::Freely, LineStyle::Dashed),
    ("13.89 kg m²", Turning::Inertia(13.885), LineStyle::Solid),
    ("27.77 kg m²", Turning::Inertia(27.77), LineStyle::Solid),
    ("55.54 kg m²", Turning::Inertia(55.54), LineStyle::Solid),
    ("I_w → ∞", Turning::Evenly, LineStyle::Dotted),
];

/// The nominal case at a tractive ratio.
fn at_tractive_ratio(model: Model, ratio: f64) -> Result<Case> {
    model.nominal(|keys| keys.contact.tractive_ratio = Some(Quantity::new(ratio)))
}

/// The case with another rotation of the wheel; its contact stays as it is.
fn turning(case: &Case, turning: Turning) -> Result<Case> {
    let rotation = match turning {
        Turning::Inertia(inertia) => {
            let rigid = RigidInertia::new(inertia, case.hertz.rolling_radius());
            Motion::compliant(rigid?)
        }
        Turning::Freely => Motion::Free,
        Turning::Evenly => Motion::Held,
    };
    let mut case = case.clone();
    case.feedback = case.feedback.with_rotation(rotation)?;
    Ok(case)
}

/// The ridge of the nominal window over speeds of 5–40 m/s.
fn ridge(case: &Case) -> Result<Vec<RidgePoint>> {
    Ok(search(case, 5.0, 40.0, 141)?.points)
}

fn search(case: &Case, from: f64, to: f64, points: usize) -> Result<Ridge> {
    let speed = Axis::new(from, to, points)?;
    Ok(Ridge::search(&case.feedback, case.wavelength, speed))
}

/// The smallest Re Ŵ₁ at the speed of Fig. 8.
fn minimum(case: &Case) -> Result<f64> {
    Ok(search(case, SPEED, SPEED + 1.0, 2)?.points[0].normalized_dissipation)
}

fn curve(label: &str, style: LineStyle, points: &[RidgePoint], value: impl Fn(&RidgePoint) -> f64) -> Series {
    Series::new(label, points.iter().map(|point| point.speed).collect(), points.iter().map(value).collect())
        .styled(style)
}

fn over_speed(language: Language, subtitle: &str, y_label: &str, series: Vec<Series>) -> LinePanel {
    LinePanel::new(say!(speed_axis).text(language), y_label, series).titled(subtitle)
}

/// A value for each inertia over speed.
fn over_inertia(nominal: &Case, value: fn(&RidgePoint) -> f64) -> Result<Vec<Series>> {
    INERTIAS
        .iter()
        .map(|&(label, inertia, style)| {
            let points = ridge(&turning(nominal, inertia)?)?;
            Ok(curve(label, style, &points, value))
        })
        .collect()
}

/// Over what the minima are taken.
fn minima(language: Language) -> String {
    say!(minima_over_wavelengths).text(language)
}

pub(super) fn figure_6(model: Model, language: Language) -> Result<PaperFigure> {
    let nominal = model.nominal(|_| ())?;
    let by_ratio = [0.1, 0.3, 0.5, 0.7, 0.95]
        .iter()
        .map(|ratio| {
            let points = ridge(&at_tractive_ratio(model, *ratio)?)?;
            let label = format!("τ = {ratio}");
            Ok(curve(&label, LineStyle::Solid, &points, |point| point.normalized_dissipation))
        })
        .collect::<Result<Vec<Series>>>()?;
    // A minimum at the edge of the window is no line of growth.
    let wavelengths = over_inertia(&nominal, |point| match point.at_edge {
        true => f64::NAN,
        false => 1e3 * point.wavelength,
    })?;
    let title = say!(figure_6).text(language);
    let minima = say!(minima_inside_window).text(language);
    Ok(lines(
        language,
        LineFigure::new(
            model.title(&title, language),
            format!("{minima} {}", parameters_in(&nominal, language)),
            [
                over_speed(language, &say!(panel_of_tractive_ratio).text(language), MINIMUM_LABEL, by_ratio),
                over_speed(
                    language,
                    &say!(panel_of_inertia).text(language),
                    &say!(wavelength_axis).text(language),
                    wavelengths,
                ),
            ],
        ),
    ))
}

pub(super) fn figure_7(model: Model, language: Language) -> Result<PaperFigure> {
    let nominal = model.nominal(|_| ())?;
    let title = say!(figure_7).text(language);
    Ok(lines(
        language,
        LineFigure::new(
            model.title(&title, language),
            format!("{} {}", minima(language), parameters_in(&nominal, language)),
            [over_speed(
                language,
                "τ = 0.1",
                MINIMUM_LABEL,
                over_inertia(&nominal, |point| point.normalized_dissipation)?,
            )],
        ),
    ))
}

pub(super) fn figure_8(model: Model, language: Language) -> Result<PaperFigure> {
    let nominal = model.nominal(|_| ())?;
    // A mean state that takes a table of its own is worth a coarser sweep.
    let steps = if model.is_tabulated() { 20 } else { 100 };
    let ratios: Vec<f64> = (1..steps).map(|step| f64::from(step) / f64::from(steps)).collect();
    let inertias: Vec<f64> = (0..=80).map(|step| 10f64.powf(f64::from(step) / 20.0 - 1.0)).collect();
    let sweep = |x: Vec<f64>, case: &dyn Fn(f64) -> Result<Case>| {
        let y = x.iter().map(|&value| minimum(&case(value)?));
        Ok::<_, AnswerError>(Series { y: y.collect::<Result<_>>()?, x, ..Series::default() })
    };
    let panel = |subtitle: &str, x_label: &str, x_scale, series| {
        LinePanel::new(x_label, MINIMUM_LABEL, [series]).titled(subtitle).scaled(x_scale, Scale::Linear)
    };
    let title = say!(figure_8, speed = SPEED).text(language);
    let falls = match model.is_the_papers() {
        true => say!(falls_in_part).text(language),
        false => String::new(),
    };
    let caption = format!("{} {falls}{}", minima(language), parameters_in(&nominal, language));
    Ok(lines(
        language,
        LineFigure::new(
            model.title(&title, language),
            caption,
            [
                panel(
                    "(a)",
                    &say!(tractive_ratio_axis).text(language),
                    Scale::Linear,
                    sweep(ratios, &|ratio| at_tractive_ratio(model, ratio))?,
                ),
                panel(
                    "(b) τ = 0.1",
                    &say!(inertia_axis).text(language),
                    Scale::Log,
                    sweep(inertias, &|inertia| turning(&nominal, Turning::Inertia(inertia)))?,
                ),
            ],
        ),
    ))
}
