//! A diagnosis in words.

use riffel_answers::diagnose::{Diagnosis, Finding, candidate_row};
use riffel_answers::sentence;
use riffel_case::Case;
use riffel_keys::Language;

use crate::messages::language;
use crate::output::table;

/// Share from which a candidate's reasons are printed.
const SHOWN: f64 = 0.02;

/// A diagnosis of a file, for a terminal.
pub(super) fn readable(diagnosis: &Diagnosis, file: &str, case: &Case) -> String {
    let title = case.file.title.as_deref().unwrap_or("the case");
    let mut text = format!(
        "{file}: {}\nheld against: {title}; traffic at {}\n",
        diagnosis.words,
        diagnosis.speeds.words()
    );
    if diagnosis.findings.is_empty() {
        text += "no dominant wavelength: nothing stands 3 dB over the trend of its neighbours beyond chance\n";
    }
    for finding in &diagnosis.findings {
        text += &format!("\n{}", of_finding(finding));
    }
    text
}

fn of_finding(finding: &Finding) -> String {
    let mut text = format!("{}\n  {}\n", finding.headline(), finding.sureness());
    if let Some(course) = finding.course() {
        text += &format!("  course: {course}\n");
    }
    let mut rows = table(&["candidate", "share", "Hz", "predicts mm"]);
    for candidate in &finding.candidates {
        rows.add_row(candidate_row(finding, candidate, language()));
    }
    text += &format!(
        "{rows}\n{}\n",
        finding.summary().capitalised(Language::English)
    );
    let shown = finding.candidates.iter().enumerate();
    let shown = shown.filter(|(place, candidate)| *place < 3 || candidate.share >= SHOWN);
    for (_, candidate) in shown {
        text += &format!("{}\n", finding.name(candidate));
        for reason in finding.reasons(&candidate.reasons_for) {
            text += &format!("  for:     {reason}\n");
        }
        for reason in finding.reasons(&candidate.reasons_against) {
            text += &format!("  against: {reason}\n");
        }
    }
    text += "to tell them apart\n";
    for measurement in finding.measurements() {
        let measurement = sentence(&measurement, Language::English);
        text += &format!("  {measurement}\n");
    }
    text
}
