//! A candidate in the table of a reader.

use riffel::diagnosis::Candidate;
use riffel_keys::{Language, range};

use super::Finding;

/// Name, share, frequency and wavelengths of a candidate.
pub fn candidate_row(finding: &Finding, candidate: &Candidate, language: Language) -> [String; 4] {
    let millimetres = |ends: (f64, f64)| {
        range(ends.into(), |value: f64| match 1e3 * value {
            value if value < 100.0 => format!("{value:.1}"),
            value => format!("{value:.0}"),
        })
    };
    [
        finding.name(candidate).text(language),
        language.numbers(&format!("{:.3}", candidate.share)),
        candidate.frequency.map_or_else(String::new, |frequency| format!("{frequency:.0}")),
        candidate.wavelengths.map_or_else(String::new, |range| language.numbers(&millimetres(range))),
    ]
}
