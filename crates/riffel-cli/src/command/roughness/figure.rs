//! Figures of roughness.

use std::path::Path;

use riffel::roughness::{Spectrum, WavelengthBand};
use riffel_case::roughness::{Limit, LimitTable};
use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, OKABE_ITO, Rgb, Scale, Series};

use super::profile::{Report, name};

/// Levels with their limit, and the bands along the rail.
pub(crate) fn of_profile(path: &Path, report: &Report, limits: &[LimitTable]) -> LineFigure {
    let rails = report.rails.len();
    let mut curves: Vec<Series> = report
        .rails
        .iter()
        .enumerate()
        .map(|(index, (name, rail))| {
            // Black is the mean's and the limit's.
            let color = OKABE_ITO[1 + index % (OKABE_ITO.len() - 1)];
            levels(name, &rail.spectrum, LineStyle::Solid, color)
        })
        .collect();
    if rails > 1 {
        curves.push(levels(
            "energy mean",
            &report.spectrum,
            LineStyle::Solid,
            Rgb::BLACK,
        ));
    }
    curves.extend(limit_curves(limits));
    let styles = [LineStyle::Solid, LineStyle::Dashed, LineStyle::Dotted];
    let mut strips = Vec::new();
    for (index, (_, rail)) in report.rails.iter().enumerate() {
        for (place, band) in WavelengthBand::GRINDING.iter().enumerate() {
            let blocks = || {
                rail.blocks
                    .iter()
                    .filter_map(|block| Some((block, block.rms[place]?)))
            };
            strips.push(Series {
                label: if index == 0 {
                    format!("{} mm", name(band))
                } else {
                    String::new()
                },
                x: blocks()
                    .map(|(block, _)| 0.5 * (block.from + block.to))
                    .collect(),
                y: blocks().map(|(_, rms)| 1e6 * rms).collect(),
                style: styles[index % styles.len()],
                color: Some(OKABE_ITO[place % OKABE_ITO.len()]),
            });
        }
    }
    let lines = if rails > 1 {
        let names: Vec<&str> = report.rails.iter().map(|(name, _)| name.as_str()).collect();
        format!(
            " Lines below: {} (solid, dashed, dotted).",
            names.join(", ")
        )
    } else {
        String::new()
    };
    let block = report
        .rails
        .first()
        .and_then(|(_, rail)| rail.blocks.first());
    let block = block.map_or(0.0, |block| block.to - block.from);
    LineFigure {
        title: "Rail roughness".to_owned(),
        caption: format!(
            "{}: one-third-octave levels after EN 15610:2009 (method A); RMS of blocks of {block:.1} m.{lines}",
            path.file_name().unwrap_or_default().to_string_lossy()
        ),
        panels: vec![
            level_panel(curves),
            LinePanel {
                x_label: "position along the rail [m]".to_owned(),
                y_label: "RMS [µm]".to_owned(),
                y_scale: Scale::Log,
                series: strips,
                ..LinePanel::default()
            },
        ],
        arrangement: Arrangement::Stacked,
    }
}

/// Energy means of groups of spectra with their limits.
pub(crate) fn of_spectra(
    path: &Path,
    groups: &[(String, Spectrum, Spectrum)],
    limits: &[LimitTable],
) -> LineFigure {
    let curves = |mean: fn(&(String, Spectrum, Spectrum)) -> &Spectrum| {
        let curves = groups.iter().enumerate().map(move |(index, group)| {
            let color = OKABE_ITO[index % OKABE_ITO.len()];
            levels(&group.0, mean(group), LineStyle::Solid, color)
        });
        curves.chain(limit_curves(limits)).collect()
    };
    let panel = |subtitle: &str, series| LinePanel {
        subtitle: subtitle.to_owned(),
        ..level_panel(series)
    };
    LineFigure {
        title: "Rail roughness".to_owned(),
        caption: format!(
            "{}: means over the spectra of each group.",
            path.file_name().unwrap_or_default().to_string_lossy()
        ),
        panels: vec![
            panel("mean of energies", curves(|group| &group.1)),
            panel("mean of levels", curves(|group| &group.2)),
        ],
        arrangement: Arrangement::Stacked,
    }
}

/// Levels over wavelength.
pub(crate) fn level_panel(series: Vec<Series>) -> LinePanel {
    LinePanel {
        x_label: "wavelength λ [mm]".to_owned(),
        y_label: "level [dB re 1 µm]".to_owned(),
        x_scale: Scale::Log,
        series,
        ..LinePanel::default()
    }
}

fn limit_curves(limits: &[LimitTable]) -> impl Iterator<Item = Series> {
    limits.iter().filter_map(|table| match &table.limit {
        Limit::Levels(limit) => Some(levels(
            &table.edition,
            limit.spectrum(),
            LineStyle::Dashed,
            Rgb::BLACK,
        )),
        Limit::Rms(_) => None,
    })
}

/// A spectrum as a curve.
pub(crate) fn levels(label: &str, spectrum: &Spectrum, style: LineStyle, color: Rgb) -> Series {
    let levels = || spectrum.levels().iter();
    Series {
        label: label.to_owned(),
        x: levels()
            .map(|level| 1e3 * level.band.wavelength())
            .collect(),
        y: levels().map(|level| level.level).collect(),
        style,
        color: Some(color),
    }
}
