//! Roughness in a report: profile, spectrum, bands, what to grind.

use std::path::Path;

use riffel::roughness::Profile;
use riffel_keys::decimal;
use riffel_plot::{Arrangement, ChainageUnit, LineFigure, LinePanel, OKABE_ITO, PlotError, Series};
use riffel_rail::{Limit, LimitTable, Record};

use super::page::{Section, escape, figure, list, table};
use crate::roughness::{ProfileAnswer, SpectraAnswer, Verdict, band_row, counted, grind_row};

/// Columns of a profile strip: more than a printer resolves on A4.
const COLUMNS: usize = 900;
/// Sections to grind that are printed.
const GRIND_ROWS: usize = 40;

/// Profile of each rail, drawn as the lowest and highest of each of many short lengths.
pub(super) fn strips(record: &Record) -> Result<Section, PlotError> {
    let unit = ChainageUnit::suiting([record.from, record.to]);
    let panels = record.rails.iter().map(|rail| {
        let series = rail.stretches.iter().map(|stretch| {
            let (x, y) = extremes(stretch, record.to - record.from);
            Series {
                x: x.into_iter().map(|position| unit.of(position)).collect(),
                y,
                color: Some(OKABE_ITO[1]),
                ..Series::default()
            }
        });
        LinePanel {
            subtitle: rail.name.clone(),
            x_label: unit.axis_label().to_owned(),
            y_label: "height [µm]".to_owned(),
            x_range: Some((unit.of(record.from), unit.of(record.to))),
            series: series.collect(),
            ..LinePanel::default()
        }
    });
    let drawing = LineFigure {
        panels: panels.collect(),
        arrangement: Arrangement::Strips,
        ..LineFigure::default()
    };
    let caption = format!(
        "Heights as read, positive upward, {} m to {:.1} m. Lowest and highest of {COLUMNS} lengths each; gaps are gaps.",
        decimal(record.from, 1),
        record.to
    );
    Ok(Section::There(
        "Profile",
        figure("strip", &drawing.picture()?, &caption),
    ))
}

/// Position \[m\] and height \[µm\]: of each length the lowest and the highest, in their order.
fn extremes(stretch: &Profile, whole: f64) -> (Vec<f64>, Vec<f64>) {
    let heights = stretch.heights();
    let columns = COLUMNS as f64 * stretch.length() / whole.max(stretch.length());
    let step = (heights.len() as f64 / columns.max(1.0)).ceil() as usize;
    let mut points = Vec::new();
    for (column, part) in heights.chunks(step.max(1)).enumerate() {
        let by = |a: &(usize, &f64), b: &(usize, &f64)| a.1.total_cmp(b.1);
        let indexed = || part.iter().enumerate();
        if let (Some(low), Some(high)) = (indexed().min_by(by), indexed().max_by(by)) {
            let mut pair = [low, high];
            pair.sort_by_key(|place| place.0);
            for (index, height) in pair {
                points.push((stretch.position(column * step + index), 1e6 * height));
            }
        }
    }
    points.into_iter().unzip()
}

/// The moving RMS along each rail, with its limits.
pub(super) fn moving_rms(report: &ProfileAnswer) -> Result<Section, PlotError> {
    let drawing = LineFigure {
        panels: report
            .rails
            .iter()
            .map(|rail| report.moving_rms(rail))
            .collect(),
        arrangement: Arrangement::Strips,
        ..LineFigure::default()
    };
    let blocks = report.rails.iter().flat_map(|rail| &rail.analysis.blocks);
    let block = blocks
        .map(|block| block.to - block.from)
        .fold(0.0, f64::max);
    let caption = format!(
        "Highest moving RMS of each {block:.1} m, by band of wavelengths; dashed in the same colour: the limit of the \
         band. The worst rail is first."
    );
    Ok(Section::There(
        "Moving RMS along the line",
        figure("strip", &drawing.picture()?, &caption),
    ))
}

/// Length \[m\] of the blocks of which a strip shows one value each.
pub fn block_of_strip(record: &Record) -> f64 {
    ((record.to - record.from) / COLUMNS as f64).max(1.0)
}

/// Levels of a profile with their limit.
pub(super) fn spectrum_of_profile(
    path: &Path,
    report: &ProfileAnswer,
    limits: &[LimitTable],
) -> Result<Section, PlotError> {
    let mut drawing = report.figure(path, limits);
    drawing.panels.truncate(1);
    let removed = report.removed();
    let caption = format!(
        "One-third-octave levels after EN 15610:2009, method A, without {} and {}; base-ten bands. {}",
        counted(removed.spikes, "spike"),
        counted(removed.pits, "pit"),
        editions(limits)
    );
    spectrum(drawing, &caption, report.verdicts())
}

/// Means of spectra with their limit.
pub(super) fn spectrum_of_means(
    path: &Path,
    means: &SpectraAnswer,
    limits: &[LimitTable],
) -> Result<Section, PlotError> {
    let mut drawing = means.figure(path, limits);
    drawing.panels.truncate(1);
    drawing.panels[0].subtitle.clear();
    let counts: Vec<String> = means
        .groups
        .iter()
        .map(|group| format!("{} ({})", group.name, group.count))
        .collect();
    let caption = format!(
        "Means of energies over the spectra of each group: {}. {}",
        counts.join(", "),
        editions(limits)
    );
    let Section::There(heading, html) = spectrum(drawing, &caption, means.verdicts.iter())? else {
        return Ok(Section::left_out("Spectrum", "there is none."));
    };
    Ok(Section::There(
        heading,
        html + &list(means.findings.clone()),
    ))
}

fn spectrum<'a>(
    drawing: LineFigure,
    caption: &str,
    verdicts: impl Iterator<Item = &'a Verdict>,
) -> Result<Section, PlotError> {
    let drawing = LineFigure {
        title: String::new(),
        caption: String::new(),
        ..drawing
    };
    let mut html = figure("half", &drawing.picture()?, caption);
    html += "<ul>\n";
    for verdict in verdicts {
        html += &format!("<li>{}</li>\n", sentence(verdict));
    }
    html += "</ul>\n";
    Ok(Section::There("Spectrum and limits", html))
}

/// A verdict, marked by what it says.
pub(super) fn sentence(verdict: &Verdict) -> String {
    let class = if verdict.within { "good" } else { "bad" };
    let words = escape(&verdict.sentence);
    let marked = if verdict.within {
        "within the limit"
    } else {
        "over the limit"
    };
    words.replacen(
        marked,
        &format!("<span class=\"{class}\">{marked}</span>"),
        1,
    )
}

fn editions(limits: &[LimitTable]) -> String {
    let levels = limits
        .iter()
        .filter(|table| matches!(table.limit, Limit::Levels(_)));
    let names: Vec<String> = levels
        .map(|table| format!("Dashed: {} ({}).", table.edition, table.source))
        .collect();
    names.join(" ")
}

/// Statistics of the bands.
pub(super) fn bands(report: &ProfileAnswer, limits: &[LimitTable]) -> Section {
    let rails = report.rails.iter();
    let rows: Vec<Vec<String>> = rails
        .flat_map(|rail| {
            let bands = rail.analysis.bands.iter();
            bands.map(|band| band_row(&escape(&rail.name), band).to_vec())
        })
        .collect();
    let header = [
        "rail",
        "band [mm]",
        "RMS [µm]",
        "highest moving RMS [µm]",
        "highest peak-to-peak [µm]",
        "window [m]",
        "limit of the RMS [µm]",
        "length over the limit",
    ];
    let rms = limits
        .iter()
        .filter(|table| matches!(table.limit, Limit::Rms(_)))
        .map(|table| format!("Limit: {} ({}).", table.edition, table.source));
    let rms: Vec<String> = rms.collect();
    let note = format!(
        "<p class=\"small\">{} Profile without spikes, zero-phase band-pass, each rail on its own, the worst first.</p>\n",
        escape(&rms.join(" "))
    );
    Section::There("Wavelength bands", table("", &header, &rows) + &note)
}

/// What to grind.
pub(super) fn grind(report: &ProfileAnswer) -> Section {
    const HEADING: &str = "What to grind";
    if !report.knows_what_to_grind() {
        return Section::left_out(HEADING, "it needs a table of RMS limits (--limit).");
    }
    let sections = report.sections();
    if sections.is_empty() {
        return Section::There(
            HEADING,
            "<p>Nothing: no band is over its limit anywhere.</p>\n".to_owned(),
        );
    }
    let rows: Vec<Vec<String>> = sections
        .iter()
        .take(GRIND_ROWS)
        .enumerate()
        .map(|(index, (rail, section))| grind_row(index, &escape(&rail.name), section).to_vec())
        .collect();
    let header = [
        "section",
        "rail",
        "from [m]",
        "to [m]",
        "length [m]",
        "worst band [mm]",
        "RMS over limit [-]",
    ];
    let more = match sections.len().saturating_sub(GRIND_ROWS) {
        0 => String::new(),
        more => format!(" {more} further sections are in grind.csv of riffel roughness."),
    };
    let how = format!(
        "Sections no further apart than {:.0} m are ground as one, and none shorter than {:.0} m.",
        report.grinding.merge, report.grinding.shortest
    );
    let html =
        table("", &header, &rows) + &format!("<p>{}{more} {how}</p>\n", escape(&total(report)));
    Section::There(HEADING, html)
}

/// The total to grind in a sentence.
pub(super) fn total(report: &ProfileAnswer) -> String {
    let sections = report.sections().len();
    if sections == 0 {
        return "No length is over the RMS limits: nothing to grind.".to_owned();
    }
    let at_defects = report.sections().into_iter().filter(|(rail, section)| {
        let mut defects = rail.analysis.defects.iter();
        defects.any(|defect| section.from < defect.to && defect.from < section.to)
    });
    let at_defects = match at_defects.count() {
        0 => String::new(),
        count => format!(" Sections with a weld, joint or squat among them: {count}."),
    };
    format!(
        "{} to grind, {}.{at_defects}",
        counted(sections, "section"),
        report.total()
    )
}
