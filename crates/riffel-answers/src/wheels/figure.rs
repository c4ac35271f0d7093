//! The wheels of a curve as pictures.

use riffel_case::Case;
use riffel_case::file::CurveRail;
use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, MapFigure, OKABE_ITO, Series};

use super::WheelsAnswer;
use crate::forecast::zero;
use crate::map::{Shown, panel};
use crate::track_in_words::place;

fn title(answer: &WheelsAnswer) -> String {
    format!(
        "Growth under the wheels of a vehicle in a curve of {:.0} m",
        answer.curve.radius.abs()
    )
}

/// Which wheels are not drawn.
fn missing(answer: &WheelsAnswer) -> String {
    let missing: Vec<&str> = (answer.wheels.iter())
        .filter(|wheel| wheel.growth.is_err())
        .map(|wheel| wheel.name.as_str())
        .collect();
    match missing.is_empty() {
        true => String::new(),
        false => format!(" Without a mean state in the loop: {}.", missing.join("; ")),
    }
}

pub(super) fn maps(answer: &WheelsAnswer, case: &Case) -> Option<MapFigure> {
    let panels = answer.in_loop().map(|(wheel, growth)| {
        let map = &growth.map;
        let mut panel = panel(&growth.case, &map.map, &map.ridge, Shown::Decay);
        panel.subtitle = wheel.name.clone();
        panel
    });
    let figure = MapFigure {
        title: title(answer),
        caption: format!(
            "Rate of decay per passage of a wheel, below zero (coloured) where corrugation grows, in one scale of colours; \
             each wheel with the mean state that it has at {:.0} km/h.{}{}",
            3.6 * answer.curve.speed,
            missing(answer),
            place(case)
        ),
        panels: panels.collect(),
    };
    (!figure.panels.is_empty()).then(|| figure.with_one_scale())
}

pub(super) fn curves(answer: &WheelsAnswer, case: &Case) -> LineFigure {
    let millimetres: Vec<f64> = answer.wavelengths.iter().map(|w| 1e3 * w).collect();
    let mut absolute = Vec::new();
    let mut relative = Vec::new();
    for (wheel, growth) in answer.in_loop() {
        // A colour for each rail, a line for each wheelset.
        let color = match wheel.rail {
            CurveRail::Low => OKABE_ITO[1],
            _ => OKABE_ITO[2],
        };
        let color = match wheel.state.wheelset {
            1 | 2 => color,
            _ if wheel.rail == CurveRail::Low => OKABE_ITO[3],
            _ => OKABE_ITO[5],
        };
        let style = match wheel.state.wheelset % 2 {
            1 => LineStyle::Solid,
            _ => LineStyle::Dashed,
        };
        let rates = growth.rates.iter();
        let largest = rates.fold(0.0, |largest: f64, rate| largest.max(rate.abs()));
        for (series, label, scale) in [
            (&mut absolute, wheel.name.as_str(), 1e6),
            (&mut relative, "", largest.recip()),
        ] {
            series.push(Series {
                label: label.to_owned(),
                x: millimetres.clone(),
                y: growth.rates.iter().map(|rate| scale * rate).collect(),
                style,
                color: Some(color),
            });
            if let Some(highest) = growth.highest {
                series.push(Series {
                    x: vec![1e3 * highest.wavelength],
                    y: vec![scale * highest.rate],
                    style: LineStyle::Markers,
                    color: Some(color),
                    ..Series::default()
                });
            }
        }
    }
    absolute.push(zero(&millimetres));
    relative.push(zero(&millimetres));
    let x_label = "wavelength λ [mm]".to_owned();
    LineFigure {
        title: title(answer),
        caption: format!(
            "Growth at {:.0} km/h under each wheel, positive where corrugation grows; marks: fastest wavelengths.{}{}",
            3.6 * answer.curve.speed,
            missing(answer),
            place(case)
        ),
        panels: vec![
            LinePanel {
                subtitle: "growth rate".to_owned(),
                x_label: x_label.clone(),
                y_label: "growth rate [10⁻⁶ per passage]".to_owned(),
                series: absolute,
                ..LinePanel::default()
            },
            LinePanel {
                subtitle: "over the largest of each wheel".to_owned(),
                x_label,
                y_label: "growth rate / largest [-]".to_owned(),
                y_range: Some((-1.05, 1.05)),
                series: relative,
                ..LinePanel::default()
            },
        ],
        arrangement: Arrangement::Stacked,
    }
}
