//! Growth map and diagnosis in a report.

use std::fmt::Write as _;

use riffel::diagnosis::MechanismKind;
use riffel_case::Case;
use riffel_keys::say;
use riffel_plot::{LineFigure, MapFigure, Observation, PlotError};

use super::outlook::Outlook;
use super::page::{Section, escape, figure, list, table};
use crate::capital;
use crate::diagnose::{Diagnosis, SHARE, candidate_row};
use crate::map::{MapAnswer, Shown, growth_in_words, panel};
use crate::parameters::parameters;
use crate::ridge::BranchDocument;

/// Share from which a candidate's reasons are printed, and how many are at least.
const SHOWN: (f64, usize) = (0.02, 3);

/// The growth map of the case, with the measured wavelengths on it if there are any.
pub(super) fn growth_map(
    case: &Case,
    map: &MapAnswer,
    diagnosis: Option<&Diagnosis>,
) -> Result<Outlook, PlotError> {
    let ridge = &map.ridge;
    let mut panel = panel(case, &map.map, ridge, Shown::Normalized);
    let measured = match diagnosis {
        Some(diagnosis) => observations(case, diagnosis, &mut panel.observations),
        None => String::new(),
    };
    let drawing = MapFigure {
        panels: vec![panel],
        ..MapFigure::default()
    };
    let caption = format!("{}{measured} {}", parameters(case), say!(sign_of_growth));
    let branches = BranchDocument::sentence(&map.branches).to_string();
    let words = format!("{}.", escape(&capital(&branches)));
    let picture = drawing.picture()?;
    let remarks = map.under_traffic.iter().flat_map(|it| it.remarks.clone());
    let over = map.over_posterior.iter().flat_map(growth_in_words);
    let remarks = remarks.chain(over);
    let brief = remarks.map(|remark| format!("{}.", escape(&capital(&remark.to_string()))));
    Ok(Outlook {
        section: Section::There(
            "Growth map",
            format!("<p>{words}</p>\n{}", figure("half", &picture, &caption)),
        ),
        brief: brief.collect(),
        warnings: Vec::new(),
    })
}

/// Put the measured wavelengths that lie in the map on it; what the caption says of all of them.
fn observations(case: &Case, diagnosis: &Diagnosis, marks: &mut Vec<Observation>) -> String {
    let speeds = &diagnosis.speeds;
    let window = case.wavelength.min()..=case.wavelength.max();
    let (inside, outside): (Vec<f64>, Vec<f64>) = diagnosis
        .findings
        .iter()
        .map(|finding| finding.measured.peak.wavelength)
        .partition(|wavelength| window.contains(wavelength));
    for wavelength in inside {
        let mut at = vec![speeds.slowest(), speeds.mean(), speeds.fastest()];
        at.dedup();
        marks.extend(at.into_iter().map(|speed| Observation {
            wavelength_m: wavelength,
            speed_m_per_s: speed,
            label: format!("measured {:.1} mm", 1e3 * wavelength),
        }));
    }
    let outside = match &outside[..] {
        [] => String::new(),
        outside => {
            let words: Vec<String> = outside
                .iter()
                .map(|wavelength| format!("{:.1} mm", 1e3 * wavelength))
                .collect();
            format!(" Outside the map: {}.", words.join(", "))
        }
    };
    format!(
        " Measured wavelengths at the slowest, mean and fastest of {}.{outside}",
        speeds.words()
    )
}

/// Dominant wavelengths with their candidates.
pub(super) fn diagnosis(file: &str, diagnosis: &Diagnosis) -> Result<Section, PlotError> {
    const HEADING: &str = "Diagnosis";
    let drawing = diagnosis.figure(file);
    let caption = drawing.caption.clone();
    let drawing = LineFigure {
        title: String::new(),
        caption: String::new(),
        ..drawing
    };
    let mut html = figure("half", &drawing.picture()?, &caption);
    if diagnosis.findings.is_empty() {
        html += "<p>No dominant wavelength: nothing stands 3 dB over the trend of its neighbours beyond chance.</p>\n";
        return Ok(Section::There(HEADING, html));
    }
    let _ = writeln!(html, "<p class=\"small\">Share: {}.</p>", escape(SHARE));
    let mut shown: Vec<MechanismKind> = Vec::new();
    for finding in &diagnosis.findings {
        let _ = write!(
            html,
            "<h3>{}</h3>\n<p>{}.</p>\n",
            escape(&capital(&finding.headline(&diagnosis.speeds))),
            escape(&capital(&finding.sureness()))
        );
        if let Some(course) = finding.course() {
            let _ = writeln!(html, "<p>Course: {}.</p>", escape(&course));
        }
        let rows: Vec<Vec<String>> = finding
            .candidates
            .iter()
            .map(|candidate| {
                let [name, share, frequency, wavelengths] = candidate_row(candidate);
                let bar = format!(
                    "{share}<span class=\"bar\"><i style=\"width:{:.1}%\"></i></span>",
                    100.0 * candidate.share
                );
                vec![name, bar, frequency, wavelengths]
            })
            .collect();
        let header = ["candidate", "share", "frequency [Hz]", "predicts [mm]"];
        html += &table("", &header, &rows);
        let _ = writeln!(
            html,
            "<p><b>{}</b></p>",
            escape(&capital(&finding.summary()))
        );
        let candidates = finding.candidates.iter().enumerate();
        for (_, candidate) in
            candidates.filter(|(place, candidate)| *place < SHOWN.1 || candidate.share >= SHOWN.0)
        {
            let kind = candidate.kind;
            let _ = writeln!(
                html,
                "<h4>{}</h4>\n<ul class=\"reasons\">",
                capital(kind.name())
            );
            for (class, reasons) in [
                ("for", &candidate.reasons_for),
                ("against", &candidate.reasons_against),
            ] {
                for reason in reasons {
                    let _ = writeln!(html, "<li class=\"{class}\">{}</li>", escape(reason));
                }
            }
            html += "</ul>\n";
            if !shown.contains(&kind) {
                shown.push(kind);
            }
        }
        html += "<h4>To tell them apart</h4>\n";
        html += &list(finding.measurements.clone());
    }
    let rows: Vec<Vec<String>> = shown
        .iter()
        .map(|kind| {
            vec![
                capital(kind.name()),
                escape(kind.source()),
                escape(kind.validity()),
            ]
        })
        .collect();
    html += "<h3>Sources and validity</h3>\n";
    html += &table("words", &["mechanism", "source", "valid for"], &rows);
    Ok(Section::There(HEADING, html))
}
