//! The strip map of a report: where along the line each rail is bad, at one look.

use std::fmt::Write as _;

use riffel_keys::{Language, say};
use riffel_plot::ChainageUnit;
use riffel_rail::name_in_words;

use super::page::said;
use crate::diagnose::Diagnosis;
use crate::roughness::{ProfileAnswer, RailAnswer};

/// Width of the map and of the names before it, height of a rail, all in its own units.
const WIDTH: f64 = 720.0;
const NAMES: f64 = 84.0;
const RAIL: f64 = 40.0;
/// Least width of a mark, which a printer still shows.
const NARROWEST: f64 = 2.0;
/// Parts of the axis.
const PARTS: usize = 5;

/// The rails in the order of the record, each with what is to be ground, its dominant wavelengths and its defects.
pub(super) fn strip_map(answer: &ProfileAnswer, diagnosis: Option<&Diagnosis>, language: Language) -> String {
    let (from, to) = (answer.record.from, answer.record.to);
    let across = |position: f64| NAMES + (WIDTH - NAMES - 8.0) * (position - from) / (to - from);
    let bar = |svg: &mut String, top: f64, height: f64, part: (f64, f64), look: &str| {
        let (left, right) = (across(part.0.max(from)), across(part.1.min(to)));
        let width = (right - left).max(NARROWEST);
        let _ = write!(svg, "<rect x=\"{left:.1}\" y=\"{top:.1}\" width=\"{width:.1}\" height=\"{height}\" {look}/>");
    };
    let names = answer.record.rails.iter().map(|rail| &rail.name);
    let rails: Vec<&RailAnswer> =
        names.filter_map(|name| answer.rails.iter().find(|rail| rail.name == *name)).collect();
    let height = RAIL * rails.len() as f64 + 24.0;
    let mut svg = format!("<svg viewBox=\"0 0 {WIDTH} {height}\" font-size=\"11\" role=\"img\">");
    for (index, rail) in rails.iter().enumerate() {
        let top = RAIL * index as f64;
        let _ = write!(svg, "<text x=\"0\" y=\"{}\">{}</text>", top + 25.0, said(&name_in_words(&rail.name), language));
        for stretch in &rail.analysis.stretches {
            bar(&mut svg, top + 16.0, 12.0, *stretch, "fill=\"#cfd6dd\"");
        }
        for (_, from, to) in rail.analysis.measured_within(&rail.sections) {
            bar(&mut svg, top + 16.0, 12.0, (from, to), "fill=\"#c8442c\"");
        }
        for defect in &rail.analysis.defects {
            let part = (defect.from, defect.to);
            bar(&mut svg, top + 12.0, 20.0, part, "fill=\"#1c2733\"");
        }
        let findings = diagnosis.into_iter().flat_map(|diagnosis| &diagnosis.findings);
        let own = findings.filter(|one| one.measured.rail.as_deref() == Some(&*rail.name));
        for (place, finding) in own.flat_map(|one| one.measured.places.iter().map(move |place| (place, one))) {
            bar(&mut svg, top + 30.0, 4.0, (place.from, place.to), "fill=\"#0072b2\"");
            let middle = across(0.5 * (place.from.max(from) + place.to.min(to)));
            let _ = write!(
                svg,
                "<text x=\"{middle:.1}\" y=\"{}\" text-anchor=\"middle\" fill=\"#0072b2\">{:.0} mm</text>",
                top + 10.0,
                1e3 * finding.measured.peak.wavelength
            );
        }
    }
    let unit = ChainageUnit::suiting([from, to]);
    let name = if unit == ChainageUnit::Metre { "m" } else { "km" };
    let _ = write!(svg, "<text x=\"0\" y=\"{}\">{name}</text>", height - 4.0);
    for part in 0..=PARTS {
        let position = from + (to - from) * part as f64 / PARTS as f64;
        let (x, y) = (across(position), height - 20.0);
        let anchor = if part == PARTS { "end" } else { "middle" };
        let digits = if unit == ChainageUnit::Metre { 0 } else { 3 };
        let shown = language.numbers(&format!("{:.digits$}", unit.of(position)));
        let _ = write!(
            svg,
            "<path d=\"M{x:.1} {y}v5\" stroke=\"#5a6775\"/><text x=\"{x:.1}\" y=\"{}\" text-anchor=\"{anchor}\">{shown}</text>",
            height - 4.0
        );
    }
    let caption = said(&say!(caption_of_strip_map), language);
    format!("<figure class=\"strip\">\n{svg}</svg>\n<figcaption>{caption}</figcaption>\n</figure>\n")
}
