//! Stress in the section and at the surface as a picture.

use riffel::damage::stress::{StressMeasure, Traction};
use riffel_plot::{LineFigure, LinePanel, LineStyle, OKABE_ITO, Rgb, Series};

use super::StressAnswer;
use super::contour::contour;

/// Levels of von Mises stress over p₀.
const LEVELS: [f64; 7] = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7];

pub(super) fn figure(answer: &StressAnswer) -> LineFigure {
    let named = answer.tractions.iter().map(|(name, traction)| {
        let name = match *name {
            "half-space" => "half-space",
            "full-slip" => "full slip",
            _ => "partial slip",
        };
        (name, traction)
    });
    let named: Vec<(&str, &Traction)> = named.collect();
    let sections = named.iter().map(|(name, traction)| section(answer, name, traction));
    let surfaces = named.iter().map(|(name, traction)| surface(answer, name, traction));
    let panels = sections.chain(surfaces).chain([along(answer, &named), over_friction(answer)]);
    LineFigure::new(
        "Stress under the contact",
        format!(
            "Von Mises stress over the peak pressure of {:.0} MPa, rolling to the right, friction \
             {:.2}, a/b = {:.2}. Sections through the middle and the surface of the patch with \
              lines of equal stress, partial slip by Vermeulen and Johnson at a tractive ratio of {:.2}.{}",
            1e-6 * answer.peak_pressure_pa,
            answer.friction,
            answer.semi_axis_longitudinal_m / answer.semi_axis_lateral_m,
            answer.tractive_ratio,
            match named.len() > 2 {
                true => " Half-space by the tractions of its elements.",
                false => "",
            },
        ),
        panels,
    )
}

fn steps(from: f64, to: f64, count: usize) -> Vec<f64> {
    (0..=count).map(|step| from + (to - from) * step as f64 / count as f64).collect()
}

fn mises(answer: &StressAnswer, traction: &Traction, axes: [&[f64]; 3]) -> Vec<f64> {
    let stresses = traction.field(&answer.ellipse, axes);
    let values = stresses.iter().map(|stress| StressMeasure::VonMises.of(stress));
    values.collect()
}

fn contours(x: &[f64], y: &[f64], values: &[f64]) -> Vec<Series> {
    let lines = LEVELS.iter().enumerate().map(|(index, &level)| {
        let (x, y) = contour(x, y, values, level);
        Series::new(format!("{level:.1}"), x, y).colored(OKABE_ITO[index % OKABE_ITO.len()])
    });
    lines.filter(|line| !line.x.is_empty()).collect()
}

fn section(answer: &StressAnswer, name: &str, traction: &Traction) -> LinePanel {
    let (x, depth) = (steps(-2.0, 2.0, 80), steps(0.0, 2.0, 40));
    let values = mises(answer, traction, [&x, &[0.0], &depth]);
    let down: Vec<f64> = depth.iter().map(|z| -z).collect();
    LinePanel {
        x_range: Some((-2.0, 2.0)),
        y_range: Some((-2.0, 0.0)),
        ..LinePanel::new("x/a", "−z/a", contours(&x, &down, &values)).titled(format!("section, {name}"))
    }
}

fn surface(answer: &StressAnswer, name: &str, traction: &Traction) -> LinePanel {
    let (x, y) = (steps(-1.5, 1.5, 60), steps(-1.5, 1.5, 60));
    let values = mises(answer, traction, [&x, &y, &[0.0]]);
    let mut series = contours(&x, &y, &values);
    let turn: Vec<f64> = steps(0.0, std::f64::consts::TAU, 72);
    series.push(
        Series::new(
            "edge",
            turn.iter().map(|angle| angle.cos()).collect(),
            turn.iter().map(|angle| angle.sin()).collect(),
        )
        .styled(LineStyle::Dotted)
        .colored(Rgb::BLACK),
    );
    LinePanel {
        x_range: Some((-1.5, 1.5)),
        y_range: Some((-1.5, 1.5)),
        ..LinePanel::new("x/a", "y/b", series).titled(format!("surface, {name}"))
    }
}

/// Along the middle of the surface.
fn along(answer: &StressAnswer, tractions: &[(&str, &Traction)]) -> LinePanel {
    // Close to the edges, where the stress has a root.
    let x: Vec<f64> = steps(-1.4, 1.4, 560);
    let series = tractions.iter().enumerate().map(|(index, (label, traction))| {
        Series::new(*label, x.clone(), mises(answer, traction, [&x, &[0.0], &[0.0]])).colored(OKABE_ITO[1 + index])
    });
    LinePanel::new("x/a", "von Mises stress/p₀", series).titled("middle of the surface")
}

fn over_friction(answer: &StressAnswer) -> LinePanel {
    let rows = &answer.stress.over_friction;
    let x: Vec<f64> = rows.iter().map(|row| row.friction).collect();
    let surface = rows.iter().map(|row| row.surface_over_p0).collect();
    let below = rows.iter().map(|row| row.subsurface_over_p0).collect();
    let series = [("surface", surface), ("below", below)];
    let series = series
        .into_iter()
        .enumerate()
        .map(|(index, (label, y))| Series::new(label, x.clone(), y).colored(OKABE_ITO[1 + index]));
    LinePanel::new("friction", "von Mises stress/p₀", series).titled("largest, full slip")
}
