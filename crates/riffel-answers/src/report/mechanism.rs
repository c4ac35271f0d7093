//! Growth map and diagnosis in a report.

use std::fmt::Write as _;

use riffel::diagnosis::MechanismKind;
use riffel_case::Case;
use riffel_keys::{Language, Message, Value, fixed, say};
use riffel_plot::{MapFigure, MapWords, Observation, PlotError};

use super::outlook::{Outlook, drawing};
use super::page::{Section, escape, figure, list, said, sentence, table, texts};
use crate::diagnose::mechanism_words::{source, validity};
use crate::diagnose::{Diagnosis, Finding, tables};
use crate::map::{MapAnswer, Shown, growth_in_words, panel};
use crate::parameters::parameters_in;
use crate::ridge::{BranchDocument, mechanism_name};

/// Share from which a candidate's reasons are printed, and how many are at least.
const SHOWN: (f64, usize) = (0.02, 3);

/// The growth map of the case, with the measured wavelengths on it if there are any.
pub(super) fn growth_map(
    case: &Case,
    map: &MapAnswer,
    diagnosis: Option<&Diagnosis>,
    language: Language,
) -> Result<Outlook, PlotError> {
    let mut panel = panel(case, &map.on.map, &map.on.ridge, Shown::Normalized);
    let mut caption = vec![parameters_in(case, language)];
    if let Some(diagnosis) = diagnosis {
        let measured = observations(case, diagnosis, &mut panel.observations, language);
        caption.extend(measured.iter().map(|one| sentence(one, language)));
    }
    caption.push(say!(sign_of_growth).text(language));
    let map_drawn = MapFigure { panels: vec![panel], ..MapFigure::default() };
    let words = sentence(&BranchDocument::sentence(&map.on.branches), language);
    let map_of_growth = figure("half", map_drawn.picture_with(&map_words(language))?, &caption.join(" "), language);
    let remarks = map.under_traffic.iter().flat_map(|it| it.remarks.clone());
    let over = map.over_posterior.iter().flat_map(growth_in_words);
    let brief = remarks.chain(over);
    Ok(Outlook {
        section: Section::There(say!(growth_map), format!("<p>{words}</p>\n{map_of_growth}")),
        brief: brief.map(|remark| sentence(&remark, language)).collect(),
        warnings: Vec::new(),
    })
}

/// The words of the map itself.
fn map_words(language: Language) -> MapWords {
    MapWords {
        wavelength: say!(wavelength_axis).text(language),
        speed_km_per_h: say!(speed_axis_in_kilometres_per_hour).text(language),
        speed_m_per_s: say!(speed_axis).text(language),
        ridge: say!(strongest_growth_at_each_speed).text(language),
        ridge_at_edge: say!(strongest_at_edge).text(language),
        best_fit_ray: say!(frequency_of_strongest_branch).text(language),
        branches: say!(branches_of_growth).text(language),
        rays: say!(constant_frequency).text(language),
        zero: say!(neither_growth_nor_decay).text(language),
        not_computed: say!(not_computed).text(language),
    }
}

/// Put the measured wavelengths that lie in the map on it; what the caption says of all of them.
fn observations(case: &Case, diagnosis: &Diagnosis, marks: &mut Vec<Observation>, language: Language) -> Vec<Message> {
    let speeds = &diagnosis.speeds;
    let window = case.wavelength.min()..=case.wavelength.max();
    let (inside, outside): (Vec<f64>, Vec<f64>) = diagnosis
        .findings
        .iter()
        .map(|finding| finding.measured.peak.wavelength)
        .partition(|wavelength| window.contains(wavelength));
    let millimetres = |wavelength: f64| fixed(1e3 * wavelength, 1);
    for wavelength in inside {
        let mut at = vec![speeds.slowest(), speeds.mean(), speeds.fastest()];
        at.dedup();
        let label = say!(measured_wavelength, wavelength = millimetres(wavelength)).text(language);
        marks.extend(at.into_iter().map(|speed| Observation {
            wavelength_m: wavelength,
            speed_m_per_s: speed,
            label: label.clone(),
        }));
    }
    let mut said = vec![say!(where_measured_wavelengths_stand, speeds = speeds.words())];
    if !outside.is_empty() {
        let outside = outside.into_iter();
        let wavelengths: Value =
            outside.map(|wavelength| say!(one_wavelength, wavelength = millimetres(wavelength))).collect();
        said.push(say!(outside_the_map, wavelengths));
    }
    said
}

/// Dominant wavelengths with their candidates.
pub(super) fn diagnosis(diagnosis: &Diagnosis, language: Language) -> Result<Section, PlotError> {
    let mut html = drawing(diagnosis.figure_in(language), language)?;
    if diagnosis.findings.is_empty() {
        let nothing = sentence(&say!(nothing_stands_out), language);
        html += &format!("<p>{nothing}</p>\n");
        return Ok(Section::There(say!(diagnosis), html));
    }
    let share = say!(share_of_belief).about(say!(share_capital));
    let _ = writeln!(html, "<p class=\"small\">{}.</p>", said(&share, language));
    let mut shown: Vec<MechanismKind> = Vec::new();
    for finding in &diagnosis.findings {
        html += &of_finding(finding, &mut shown, language);
    }
    let rows = shown.into_iter().map(|kind| {
        let cells = [source(kind), validity(kind)].map(|cell| said(&cell, language));
        let name = escape(&mechanism_name(kind).capitalised(language));
        std::iter::once(name).chain(cells).collect()
    });
    let rows: Vec<Vec<String>> = rows.collect();
    let heads = [say!(mechanism_head), say!(source_head), say!(valid_for_head)];
    let heading = said(&say!(sources_and_validity), language);
    let _ = writeln!(html, "<h3>{heading}</h3>");
    html += &table("words", &texts(heads, language), &rows);
    Ok(Section::There(say!(diagnosis), html))
}

/// A dominant wavelength; the mechanisms whose reasons are told are among those shown from then on.
fn of_finding(finding: &Finding, shown: &mut Vec<MechanismKind>, language: Language) -> String {
    let headline = escape(&finding.headline().capitalised(language));
    let sureness = sentence(&finding.sureness(), language);
    let mut html = format!("<h3>{headline}</h3>\n<p>{sureness}</p>\n");
    if let Some(course) = finding.course() {
        let course = course.about(say!(course_capital));
        let _ = writeln!(html, "<p>{}.</p>", said(&course, language));
    }
    let summary = escape(&finding.summary().capitalised(language));
    if finding.candidates.is_empty() {
        return html + &format!("<p><b>{summary}</b></p>\n");
    }
    let (_, mut rows) = tables::of_finding(finding).shown(language);
    for (row, candidate) in rows.iter_mut().zip(&finding.candidates) {
        row[0] = escape(&row[0]);
        row[1] += &format!("<span class=\"bar\"><i style=\"width:{:.1}%\"></i></span>", 100.0 * candidate.share);
    }
    let heads = [say!(candidate_head), say!(share_head), say!(frequency_in_hertz_head), say!(predicts_in_millimetres)];
    html += &table("", &texts(heads, language), &rows);
    let _ = writeln!(html, "<p><b>{summary}</b></p>");
    let candidates = finding.candidates.iter().enumerate();
    let told = candidates
        .filter(|(place, candidate)| *place < SHOWN.1 || candidate.share >= SHOWN.0)
        .map(|(_, candidate)| candidate);
    for candidate in told {
        let name = escape(&mechanism_name(candidate.kind).capitalised(language));
        let _ = writeln!(html, "<h4>{name}</h4>\n<ul class=\"reasons\">");
        for (class, reasons) in [("for", &candidate.reasons_for), ("against", &candidate.reasons_against)] {
            for reason in finding.reasons(reasons) {
                let reason = said(&reason, language);
                let _ = writeln!(html, "<li class=\"{class}\">{reason}</li>");
            }
        }
        html += "</ul>\n";
        if !shown.contains(&candidate.kind) {
            shown.push(candidate.kind);
        }
    }
    let heading = said(&say!(to_tell_them_apart), language);
    let _ = writeln!(html, "<h4>{heading}</h4>");
    let measurements = finding.measurements();
    html + &list(measurements.map(|one| sentence(&one, language)))
}
