//! Models of the field as pictures.

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

fn title(answer: &ModelsAnswer) -> String {
    let title = answer.case.file.title.clone();
    title.unwrap_or_else(|| "Models of the field".to_owned())
}

pub(super) fn growth(answer: &ModelsAnswer) -> LineFigure {
    let others = answer.on_case().filter(|of| of.model.name != "riffel");
    let ours = answer.on_case().filter(|of| of.model.name == "riffel");
    let looks = (0..).map(look);
    let lines = others.zip(looks).chain(ours.zip(std::iter::once((Rgb::BLACK, LineStyle::Solid)))).map(
        |(of, (color, style))| GrowthLine {
            label: &of.model.title,
            rates: of.growth_rate_per_passage.as_deref().unwrap_or_default(),
            highest: of.highest,
            color,
            style,
        },
    );
    LineFigure::new(
        title(answer),
        format!(
            "Growth {} by the models of the field, positive where corrugation grows; marks: fastest \
             wavelengths. The case: {}",
            answer.passing,
            parameters(&answer.case)
        ),
        growth_lines::panels(&answer.wavelength_m, lines, "model"),
    )
    .arranged(Arrangement::Stacked)
}

pub(super) fn complex_plane(answer: &ModelsAnswer) -> Option<LineFigure> {
    let (model, plane) = answer.on_case().find_map(|of| Some((of.model, of.complex_plane.as_ref()?)))?;
    let mega = 1e-6;
    let places = [
        ("wheel over a support", &plane.over_support_j_per_m2, OKABE_ITO[1]),
        ("wheel in mid-span", &plane.mid_span_j_per_m2, OKABE_ITO[2]),
    ];
    let all = || places.iter().flat_map(|(_, values, _)| values.iter());
    let largest = |part: usize| {
        let parts = all().map(|value| value[part].abs());
        1.1 * mega * parts.fold(0.0, f64::max)
    };
    let (re, im) = (largest(0), largest(1));
    let mut series = Vec::new();
    for (label, values, color) in places {
        let line = |values: &[[f64; 2]], label: &str, style| {
            Series::new(
                label,
                values.iter().map(|value| mega * value[0]).collect(),
                values.iter().map(|value| mega * value[1]).collect(),
            )
            .styled(style)
            .colored(color)
        };
        series.push(line(values, label, LineStyle::Solid));
        // Where the curve begins, at the lowest frequency.
        series.push(line(&values[..1], "", LineStyle::Markers));
    }
    let (lowest, highest) = (plane.frequency_hz.first()?, plane.frequency_hz.last()?);
    Some(
        LineFigure::new(
            title(answer),
            format!(
                "Wear in the complex plane as {} draws it, at {:.1} km/h from {lowest:.0} Hz (marks) to \
             {highest:.0} Hz: a wave grows in the left half-plane, shaded, and travels by the \
              imaginary part. The case: {}",
                model.title,
                3.6 * answer.speed_m_per_s,
                parameters(&answer.case)
            ),
            [LinePanel {
                x_range: Some((-re, re)),
                y_range: Some((-im, im)),
                areas: vec![Area {
                    label: "growth".to_owned(),
                    x: vec![-re, 0.0],
                    low: vec![-im; 2],
                    high: vec![im; 2],
                    color: GROWTH,
                }],
                ..LinePanel::new("Re e₁/Δ [J/m per µm]", "Im e₁/Δ [J/m per µm]", series)
            }],
        )
        .arranged(Arrangement::Stacked),
    )
}
