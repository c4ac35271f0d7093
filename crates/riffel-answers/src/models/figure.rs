//! Models of the field as pictures.

use riffel_case::Case;
use riffel_plot::{Area, Arrangement, LineFigure, LinePanel, LineStyle, OKABE_ITO, Rgb, Series};

use super::ModelsAnswer;
use crate::growth_lines::{self, GrowthLine};
use crate::parameters::parameters;

/// The half-plane where waves grow.
const GROWTH: Rgb = Rgb(222, 235, 247);

/// Colours once around with unbroken lines, then with dashes. The last of Okabe and Ito, yellow, is too light for a line.
fn look(index: usize) -> (Rgb, LineStyle) {
    let colors = &OKABE_ITO[1..OKABE_ITO.len() - 1];
    let style = match index / colors.len() {
        0 => LineStyle::Solid,
        _ => LineStyle::Dashed,
    };
    (colors[index % colors.len()], style)
}

fn title(case: &Case) -> String {
    let title = case.file.title.clone();
    title.unwrap_or_else(|| "Models of the field".to_owned())
}

pub(super) fn growth(answer: &ModelsAnswer, case: &Case) -> LineFigure {
    let others = answer.on_case().filter(|(model, _)| model.name != "riffel");
    let ours = answer.on_case().filter(|(model, _)| model.name == "riffel");
    let looks = (0..).map(look);
    let lines = others
        .zip(looks)
        .chain(ours.zip(std::iter::once((Rgb::BLACK, LineStyle::Solid))))
        .map(|((model, growth), (color, style))| GrowthLine {
            label: model.title,
            rates: &growth.rates,
            highest: growth.highest,
            color,
            style,
        });
    LineFigure {
        title: title(case),
        caption: format!(
            "Growth {} by the models of the field, positive where corrugation grows; marks: fastest wavelengths. \
             The case: {}",
            answer.passing(),
            parameters(case)
        ),
        panels: growth_lines::panels(&answer.wavelengths, lines, "model"),
        arrangement: Arrangement::Stacked,
    }
}

pub(super) fn complex_plane(answer: &ModelsAnswer, case: &Case) -> Option<LineFigure> {
    let (model, plane) = answer
        .on_case()
        .find_map(|(model, growth)| Some((model, growth.complex_plane.as_ref()?)))?;
    let mega = 1e-6;
    let places = [
        ("wheel over a support", &plane.over_support, OKABE_ITO[1]),
        ("wheel in mid-span", &plane.mid_span, OKABE_ITO[2]),
    ];
    let all = || places.iter().flat_map(|(_, values, _)| values.iter());
    let largest = |part: fn(&riffel::Complex64) -> f64| {
        let parts = all().map(|value| part(value).abs());
        1.1 * mega * parts.fold(0.0, f64::max)
    };
    let (re, im) = (largest(|value| value.re), largest(|value| value.im));
    let mut series = Vec::new();
    for (label, values, color) in places {
        let line = |values: &[riffel::Complex64], label: &str, style| Series {
            label: label.to_owned(),
            x: values.iter().map(|value| mega * value.re).collect(),
            y: values.iter().map(|value| mega * value.im).collect(),
            style,
            color: Some(color),
        };
        series.push(line(values, label, LineStyle::Solid));
        // Where the curve begins, at the lowest frequency.
        series.push(line(&values[..1], "", LineStyle::Markers));
    }
    let (lowest, highest) = (plane.frequencies.first()?, plane.frequencies.last()?);
    Some(LineFigure {
        title: title(case),
        caption: format!(
            "Wear in the complex plane as {} draws it, at {:.1} km/h from {lowest:.0} Hz (marks) to {highest:.0} Hz: a wave \
             grows in the left half-plane, shaded, and travels by the imaginary part. The case: {}",
            model.title,
            3.6 * answer.speed,
            parameters(case)
        ),
        panels: vec![LinePanel {
            x_label: "Re e₁/Δ [J/m per µm]".to_owned(),
            y_label: "Im e₁/Δ [J/m per µm]".to_owned(),
            x_range: Some((-re, re)),
            y_range: Some((-im, im)),
            series,
            areas: vec![Area {
                label: "growth".to_owned(),
                x: vec![-re, 0.0],
                low: vec![-im; 2],
                high: vec![im; 2],
                color: GROWTH,
            }],
            ..LinePanel::default()
        }],
        arrangement: Arrangement::Stacked,
    })
}
