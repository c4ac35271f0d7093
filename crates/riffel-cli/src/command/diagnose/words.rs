//! A diagnosis in words.

use riffel_answers::diagnose::{Diagnosis, Finding, candidate_row};
use riffel_answers::sentence;
use riffel_case::Case;
use riffel_keys::{Message, say};

use crate::messages::language;
use crate::output::table;

/// Share from which a candidate's reasons are printed.
const SHOWN: f64 = 0.02;

/// A diagnosis of a file, for a terminal.
pub(super) fn readable(diagnosis: &Diagnosis, file: &str, case: &Case) -> String {
    let title = case.file.title.as_deref().unwrap_or("the case");
    let mut text =
        format!("{file}: {}\nheld against: {title}; traffic at {}\n", diagnosis.words, diagnosis.speeds.words());
    if diagnosis.findings.is_empty() {
        text += &format!("{}\n", say!(nothing_stands_out).text(language()));
    }
    for finding in &diagnosis.findings {
        text += &format!("\n{}", of_finding(finding));
    }
    text
}

fn of_finding(finding: &Finding) -> String {
    let words = |message: Message| message.text(language());
    let (headline, sureness) = (words(finding.headline()), words(finding.sureness()));
    let mut text = format!("{headline}\n  {sureness}\n");
    if let Some(course) = finding.course() {
        text += &format!("  course: {}\n", words(course));
    }
    if finding.candidates.is_empty() {
        return text + &format!("{}\n", finding.summary().capitalised(language()));
    }
    let mut rows = table(&["candidate", "share", "Hz", "predicts mm"]);
    for candidate in &finding.candidates {
        rows.add_row(candidate_row(finding, candidate, language()));
    }
    text += &format!("{rows}\n{}\n", finding.summary().capitalised(language()));
    let shown = finding.candidates.iter().enumerate();
    let shown = shown.filter(|(place, candidate)| *place < 3 || candidate.share >= SHOWN);
    for (_, candidate) in shown {
        text += &format!("{}\n", words(finding.name(candidate)));
        for reason in finding.reasons(&candidate.reasons_for) {
            text += &format!("  for:     {}\n", words(reason));
        }
        for reason in finding.reasons(&candidate.reasons_against) {
            text += &format!("  against: {}\n", words(reason));
        }
    }
    text += "to tell them apart\n";
    for measurement in finding.measurements() {
        text += &format!("  {}\n", sentence(&measurement, language()));
    }
    text
}
