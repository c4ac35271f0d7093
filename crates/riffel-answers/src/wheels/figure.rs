//! The wheels of a curve as pictures.

use riffel_case::file::CurveRail;
use riffel_plot::{Arrangement, LineFigure, LineStyle, MapFigure, OKABE_ITO};

use super::WheelsAnswer;
use crate::growth_lines::{self, GrowthLine};
use crate::map::{Shown, panel};
use crate::track_in_words::place;

fn title(answer: &WheelsAnswer) -> String {
    format!("Growth under the wheels of a vehicle in a curve of {:.0} m", answer.radius_m.abs())
}

/// Which wheels are not drawn.
fn missing(answer: &WheelsAnswer) -> String {
    let missing: Vec<&str> =
        (answer.wheels.iter()).filter(|wheel| wheel.in_loop.is_none()).map(|wheel| wheel.name.as_str()).collect();
    match missing.is_empty() {
        true => String::new(),
        false => format!(" Without a mean state in the loop: {}.", missing.join("; ")),
    }
}

pub(super) fn maps(answer: &WheelsAnswer) -> Option<MapFigure> {
    let panels = answer.carrying().map(|(wheel, in_loop)| {
        let map = &in_loop.map;
        let mut panel = panel(&in_loop.case, &map.map, &map.ridge, Shown::Decay);
        panel.subtitle = wheel.name.clone();
        panel
    });
    let figure = MapFigure {
        title: title(answer),
        caption: format!(
            "Rate of decay per passage of a wheel, below zero (coloured) where corrugation grows, in \
             one scale of colours; each wheel with the mean state that it has at {:.0} km/h, on the \
              contact that carries most of it.{}{}",
            3.6 * answer.speed_m_per_s,
            missing(answer),
            place(&answer.case)
        ),
        panels: panels.collect(),
    };
    (!figure.panels.is_empty()).then(|| figure.with_one_scale())
}

pub(super) fn curves(answer: &WheelsAnswer) -> LineFigure {
    let lines = answer.carrying().map(|(wheel, _)| {
        // A colour for each rail, a line for each wheelset.
        let color = match wheel.rail {
            CurveRail::Low => OKABE_ITO[1],
            _ => OKABE_ITO[2],
        };
        let color = match wheel.wheelset {
            1 | 2 => color,
            _ if wheel.rail == CurveRail::Low => OKABE_ITO[3],
            _ => OKABE_ITO[5],
        };
        GrowthLine {
            label: &wheel.name,
            rates: wheel.growth_rate_per_passage.as_deref().unwrap_or_default(),
            highest: wheel.highest,
            color,
            style: match wheel.wheelset % 2 {
                1 => LineStyle::Solid,
                _ => LineStyle::Dashed,
            },
        }
    });
    LineFigure::new(
        title(answer),
        format!(
            "Growth {} under each wheel, on the contact that carries most of it, positive where \
             corrugation grows; marks: fastest wavelengths.{}{}",
            answer.under,
            missing(answer),
            place(&answer.case)
        ),
        growth_lines::panels(&answer.wavelength_m, lines, "wheel"),
    )
    .arranged(Arrangement::Stacked)
}
