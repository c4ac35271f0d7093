//! Roughness felt by axle boxes as a picture.

use riffel_keys::Language;
use riffel_plot::{Area, Arrangement, LineFigure, LinePanel, LineStyle, OKABE_ITO, Rgb, Series};

use super::{AxleBoxAnswer, AxleBoxRail};
use crate::roughness::figure::{level_panel, levels, limit_curves, moving_rms};

pub(super) fn figure(answer: &AxleBoxAnswer) -> LineFigure {
    let mut panels = vec![spectra(answer)];
    let ends = answer.ends();
    let along = answer.rails.iter();
    panels.extend(along.map(|rail| moving_rms(&rail.rail, ends, Language::English)));
    LineFigure::new(
        "Roughness felt by axle boxes",
        format!(
            "One-third-octave levels, grey with pads of half to twice the stiffness; highest moving RMS \
             in blocks along the rail, its limit dashed. {}",
            answer.parameters
        ),
        panels,
    )
    .arranged(Arrangement::Stacked)
}

/// Levels with their limit, and what unknown pads leave open of the first.
fn spectra(answer: &AxleBoxAnswer) -> LinePanel {
    let rails = answer.rails.iter().enumerate();
    let mut series: Vec<Series> = rails
        .map(|(index, rail)| {
            // Black is the limit's.
            let color = OKABE_ITO[1 + index % (OKABE_ITO.len() - 1)];
            levels(&rail.rail.name, &rail.rail.analysis.spectrum, LineStyle::Solid, color)
        })
        .collect();
    series.extend(limit_curves(&answer.limits));
    LinePanel { areas: answer.rails.first().map(pads).into_iter().collect(), ..level_panel(series, Language::English) }
}

fn pads(rail: &AxleBoxRail) -> Area {
    let levels = || rail.levels.iter();
    Area {
        label: format!("{}, pads unknown", rail.rail.name),
        x: levels().map(|level| 1e3 * level.band.wavelength()).collect(),
        low: levels().map(|level| level.range[0]).collect(),
        high: levels().map(|level| level.range[1]).collect(),
        color: Rgb(220, 220, 220),
    }
}
