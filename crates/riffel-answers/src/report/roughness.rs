//! Roughness in a report: profile, spectrum, bands, what to grind.

use riffel::roughness::Profile;
use riffel_keys::{Language, Message, Value, fixed, number, say};
use riffel_plot::{Arrangement, ChainageUnit, LineFigure, LinePanel, OKABE_ITO, PlotError, Series};
use riffel_rail::{Limit, LimitTable, Record, name_in_words};

use super::page::{Section, cells, figure, list, said, sentence, table, texts};
use crate::roughness::figure::position_axis;
use crate::roughness::{ProfileAnswer, SpectraAnswer, Verdict, tables};

/// Columns of a profile strip: more than a printer resolves on A4.
const COLUMNS: usize = 900;
/// Sections to grind that are printed.
const GRIND_ROWS: usize = 40;

/// Profile of each rail, drawn as the lowest and highest of each of many short lengths.
pub(super) fn strips(record: &Record, language: Language) -> Result<Section, PlotError> {
    let unit = ChainageUnit::suiting([record.from, record.to]);
    let panels = record.rails.iter().map(|rail| {
        let series = rail.stretches.iter().map(|stretch| {
            let (x, y) = extremes(stretch, record.to - record.from);
            Series::new("", x.into_iter().map(|position| unit.of(position)).collect(), y).colored(OKABE_ITO[1])
        });
        LinePanel {
            x_range: Some((unit.of(record.from), unit.of(record.to))),
            ..LinePanel::new(position_axis(unit).text(language), say!(height_axis).text(language), series)
                .titled(name_in_words(&rail.name).text(language))
        }
    });
    let drawing = LineFigure { panels: panels.collect(), arrangement: Arrangement::Strips, ..LineFigure::default() };
    let caption =
        say!(caption_of_heights, from = fixed(record.from, 1), to = fixed(record.to, 1), columns = number(COLUMNS));
    let html = figure("strip", drawing.picture()?, &caption.text(language), language);
    Ok(Section::There(say!(profile), html))
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
pub(super) fn moving_rms(report: &ProfileAnswer, language: Language) -> Result<Section, PlotError> {
    let rails = report.rails.iter();
    let drawing = LineFigure {
        panels: rails.map(|rail| report.moving_rms(rail, language)).collect(),
        arrangement: Arrangement::Strips,
        ..LineFigure::default()
    };
    let blocks = report.rails.iter().flat_map(|rail| &rail.analysis.blocks);
    let block = blocks.map(|block| block.to - block.from).fold(0.0, f64::max);
    let caption = say!(caption_of_moving_rms, block = fixed(block, 1)).text(language);
    let html = figure("strip", drawing.picture()?, &caption, language);
    Ok(Section::There(say!(moving_rms_along_the_line), html))
}

/// Length \[m\] of the blocks of which a strip shows one value each.
pub(super) fn block_of_strip(record: &Record) -> f64 {
    ((record.to - record.from) / COLUMNS as f64).max(1.0)
}

/// Levels of a profile with their limit.
pub(super) fn spectrum_of_profile(
    report: &ProfileAnswer,
    limits: &[LimitTable],
    language: Language,
) -> Result<Section, PlotError> {
    let drawing = report.figure_in(language);
    let removed = report.removed;
    let caption =
        say!(caption_of_levels, spikes = say!(spikes, count = removed.spikes), pits = say!(pits, count = removed.pits));
    let html = spectrum(drawing, caption, limits, language)?;
    let html = html + &verdicts(report.verdicts.iter(), language);
    Ok(Section::There(say!(spectrum_and_limits), html))
}

/// Means of spectra with their limit.
pub(super) fn spectrum_of_means(
    means: &SpectraAnswer,
    limits: &[LimitTable],
    language: Language,
) -> Result<Section, PlotError> {
    let mut drawing = means.figure_in(language);
    drawing.panels[0].subtitle.clear();
    let groups = means.groups.iter();
    let groups: Value = groups
        .map(|group| {
            let name = Message::verbatim(&group.name);
            say!(group_of_spectra, name, count = number(group.count))
        })
        .collect();
    let caption = say!(caption_of_group_means, groups);
    let html = spectrum(drawing, caption, limits, language)?;
    let findings = means.findings.iter().map(|finding| said(finding, language));
    let html = html + &verdicts(means.verdicts.iter(), language) + &list(findings);
    Ok(Section::There(say!(spectrum_and_limits), html))
}

/// The first panel of a figure with its caption, and the limits by name.
fn spectrum(
    drawing: LineFigure,
    caption: Message,
    limits: &[LimitTable],
    language: Language,
) -> Result<String, PlotError> {
    let drawing = LineFigure {
        title: String::new(),
        caption: String::new(),
        panels: drawing.panels.into_iter().take(1).collect(),
        ..drawing
    };
    let levels = limits.iter().filter(|table| matches!(table.limit, Limit::Levels(_)));
    let editions = levels.map(|table| say!(dashed_limit, edition = &table.edition, source = &table.source));
    let sentences = std::iter::once(caption).chain(editions);
    let sentences: Vec<String> = sentences.map(|one| one.text(language) + ".").collect();
    let (picture, caption) = (drawing.picture()?, sentences.join(" "));
    Ok(figure("half", picture, &caption, language))
}

/// Verdicts as a list.
fn verdicts<'a>(verdicts: impl Iterator<Item = &'a Verdict>, language: Language) -> String {
    list(verdicts.map(|verdict| marked(verdict, language)))
}

/// A verdict, marked by what it says.
pub(super) fn marked(verdict: &Verdict, language: Language) -> String {
    let (class, words) = match verdict.within {
        true => ("good", say!(within_the_limit)),
        false => ("bad", say!(over_the_limit)),
    };
    let words = said(&words, language);
    let marked = format!("<span class=\"{class}\">{words}</span>");
    said(&verdict.sentence, language).replacen(&words, &marked, 1)
}

/// Statistics of the bands.
pub(super) fn bands(report: &ProfileAnswer, limits: &[LimitTable], language: Language) -> Section {
    let (_, rows) = cells(&tables::bands(report.rails.iter()), language);
    let heads = [
        say!(rail_word),
        say!(band_in_millimetres),
        say!(rms_in_micrometres),
        say!(highest_moving_rms),
        say!(highest_peak_to_peak),
        say!(window_in_metres),
        say!(limit_of_rms),
        say!(length_over_the_limit),
    ];
    let limits = limits
        .iter()
        .filter(|table| matches!(table.limit, Limit::Rms(_)))
        .map(|table| say!(limit_of_bands, edition = &table.edition, source = &table.source));
    let note: Vec<String> = limits.chain([say!(how_bands_are_filtered)]).map(|one| sentence(&one, language)).collect();
    let note = format!("<p class=\"small\">{}</p>\n", note.join(" "));
    let table = table("", &texts(heads, language), &rows);
    Section::There(say!(wavelength_bands), table + &note)
}

/// What to grind.
pub(super) fn grind(report: &ProfileAnswer, language: Language) -> Section {
    let heading = say!(what_to_grind);
    if !report.knows_what_to_grind() {
        return Section::LeftOut(heading, say!(needs_a_limit_of_rms));
    }
    let sections = report.sections();
    if sections.is_empty() {
        let nothing = sentence(&report.nothing_to_grind(), language);
        return Section::There(heading, format!("<p>{nothing}</p>\n"));
    }
    let (_, rows) = cells(&tables::shown_grind(report.rails.iter(), GRIND_ROWS), language);
    let heads = [
        say!(section_head),
        say!(rail_word),
        say!(from_in_metres),
        say!(to_in_metres),
        say!(length_in_metres),
        say!(worst_band_in_millimetres),
        say!(rms_over_limit),
    ];
    let more = sections.len().saturating_sub(GRIND_ROWS);
    let more = (more > 0).then(|| say!(further_sections, count = number(more)));
    let how = say!(
        how_sections_are_ground,
        merge = fixed(report.grinding.merge, 0),
        shortest = fixed(report.grinding.shortest, 0)
    );
    let words = total(report).into_iter().chain(more).chain([how]);
    let words: Vec<String> = words.map(|one| sentence(&one, language)).collect();
    let table = table("", &texts(heads, language), &rows);
    Section::There(heading, table + &format!("<p>{}</p>\n", words.join(" ")))
}

/// The total to grind, in a sentence or two.
pub(super) fn total(report: &ProfileAnswer) -> Vec<Message> {
    let sections = report.sections().len();
    if sections == 0 {
        return vec![say!(no_length_over_rms_limits)];
    }
    let at_defects = report.sections().into_iter().filter(|(rail, section)| {
        let mut defects = rail.analysis.defects.iter();
        defects.any(|defect| section.from < defect.to && defect.from < section.to)
    });
    let at_defects = at_defects.count();
    let mut sentences = vec![say!(sections_to_grind, count = sections, sums = report.total())];
    if at_defects > 0 {
        sentences.push(say!(sections_at_defects, count = number(at_defects)));
    }
    sentences
}
