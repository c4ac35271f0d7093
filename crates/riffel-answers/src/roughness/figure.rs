//! Figures of roughness.

use std::path::Path;

use riffel::roughness::{Spectrum, WavelengthBand};
use riffel_keys::{Language, Message, fixed, say};
use riffel_plot::{Arrangement, ChainageUnit, LineFigure, LinePanel, LineStyle, OKABE_ITO, Rgb, Scale, Series};
use riffel_rail::{Limit, LimitTable, name_in_words};

use super::words::name;
use super::{MeanSpectra, ProfileAnswer, RailAnswer, SpectraAnswer};

/// Levels with their limit, and the moving RMS along each rail.
pub(crate) fn of_profile(profile: &ProfileAnswer, language: Language) -> LineFigure {
    let mut curves: Vec<Series> = profile
        .rails
        .iter()
        .enumerate()
        .map(|(index, rail)| {
            // Black is the mean's and the limit's.
            let color = OKABE_ITO[1 + index % (OKABE_ITO.len() - 1)];
            let name = name_in_words(&rail.name).text(language);
            levels(&name, &rail.analysis.spectrum, LineStyle::Solid, color)
        })
        .collect();
    if profile.rails.len() > 1 {
        curves.push(levels(&say!(energy_mean).text(language), &profile.spectrum, LineStyle::Dotted, Rgb::BLACK));
    }
    curves.extend(limit_curves(&profile.limits));
    let mut panels = vec![level_panel(curves, language)];
    let ends = [profile.record.from, profile.record.to];
    let strips = profile.rails.iter();
    panels.extend(strips.map(|rail| moving_rms(rail, ends, language)));
    let blocks = profile.rails.iter().flat_map(|rail| &rail.analysis.blocks);
    let block = blocks.map(|block| block.to - block.from).fold(0.0, f64::max);
    LineFigure::new(
        say!(rail_roughness).text(language),
        say!(caption_of_profile, file = file_name(Path::new(&profile.file)), block = fixed(block, 1)).text(language),
        panels,
    )
    .arranged(Arrangement::Stacked)
}

/// The name of a file without its folder.
pub(crate) fn file_name(path: &Path) -> String {
    let name = path.file_name().unwrap_or_default();
    name.to_string_lossy().into_owned()
}

/// The axis of positions along a rail.
pub(crate) fn position_axis(unit: ChainageUnit) -> Message {
    match unit {
        ChainageUnit::Metre => say!(position_axis_in_metres),
        ChainageUnit::Kilometre => say!(position_axis_in_kilometres),
    }
}

/// The moving RMS of each band along a rail from one place to another \[m\], each with its limit.
pub(crate) fn moving_rms(rail: &RailAnswer, [from, to]: [f64; 2], language: Language) -> LinePanel {
    let unit = ChainageUnit::suiting([from, to]);
    let ends = (unit.of(from), unit.of(to));
    let mut series = Vec::new();
    for (place, band) in WavelengthBand::GRINDING.iter().enumerate() {
        let color = Some(OKABE_ITO[place % OKABE_ITO.len()]);
        let found = rail.analysis.bands.iter().find(|found| found.band == *band);
        let Some(found) = found else { continue };
        // A line for each stretch: gaps are gaps.
        for (from, to) in &rail.analysis.stretches {
            let blocks = rail.analysis.blocks.iter();
            let own = blocks.filter(|block| (*from..*to).contains(&block.from));
            let points = own.filter_map(|block| {
                let rms = 1e6 * block.moving_rms_max[place]?;
                Some((unit.of(0.5 * (block.from + block.to)), rms))
            });
            let (x, y): (Vec<f64>, Vec<f64>) = points.unzip();
            // One entry of the legend for all stretches.
            let first = rail.analysis.stretches.first().is_some_and(|one| one.0 == *from);
            series.push(Series {
                color,
                ..Series::new(if first { format!("{} mm", name(band)) } else { String::new() }, x, y)
            });
        }
        series.extend(found.limit.map(|limit| Series {
            color,
            ..Series::new("", vec![ends.0, ends.1], vec![1e6 * limit; 2]).styled(LineStyle::Dashed)
        }));
    }
    LinePanel {
        x_range: Some(ends),
        ..LinePanel::new(position_axis(unit).text(language), say!(moving_rms_axis).text(language), series)
            .titled(name_in_words(&rail.name).text(language))
            .scaled(Scale::Linear, Scale::Log)
    }
}

/// Energy means of groups of spectra with their limits.
pub(crate) fn of_spectra(answer: &SpectraAnswer, language: Language) -> LineFigure {
    let groups = &answer.groups;
    let curves = |mean: fn(&MeanSpectra) -> &Spectrum| {
        let curves = groups.iter().enumerate().map(move |(index, group)| {
            let color = OKABE_ITO[index % OKABE_ITO.len()];
            levels(&group.name, mean(group), LineStyle::Solid, color)
        });
        curves.chain(limit_curves(&answer.limits)).collect()
    };
    let panel =
        |subtitle: Message, series| LinePanel { subtitle: subtitle.text(language), ..level_panel(series, language) };
    LineFigure::new(
        say!(rail_roughness).text(language),
        say!(caption_of_means, file = file_name(Path::new(&answer.file))).text(language),
        [
            panel(say!(mean_of_energies), curves(|group| &group.energy)),
            panel(say!(mean_of_levels), curves(|group| &group.arithmetic)),
        ],
    )
    .arranged(Arrangement::Stacked)
}

/// Levels over wavelength.
pub(crate) fn level_panel(series: Vec<Series>, language: Language) -> LinePanel {
    LinePanel::new(say!(wavelength_axis).text(language), say!(level_axis).text(language), series)
        .scaled(Scale::Log, Scale::Linear)
}

pub(crate) fn limit_curves(limits: &[LimitTable]) -> impl Iterator<Item = Series> {
    limits.iter().filter_map(|table| match &table.limit {
        Limit::Levels(limit) => Some(levels(&table.edition, limit.spectrum(), LineStyle::Dashed, Rgb::BLACK)),
        Limit::Rms(_) => None,
    })
}

/// A spectrum as a curve.
pub(crate) fn levels(label: &str, spectrum: &Spectrum, style: LineStyle, color: Rgb) -> Series {
    let levels = || spectrum.levels().iter();
    Series::new(
        label,
        levels().map(|level| 1e3 * level.band.wavelength()).collect(),
        levels().map(|level| level.level).collect(),
    )
    .styled(style)
    .colored(color)
}
