//! A diagnosis as tables.

use riffel_keys::{Message, range, say};

use super::{Diagnosis, Finding};
use crate::number_alone;
use crate::{Rows, Table};

/// What a reader sees of the candidates of a finding: name, share, frequency and wavelengths.
pub(crate) fn of_finding(finding: &Finding) -> Table {
    let candidates = &finding.candidates;
    let millimetres = |ends: (f64, f64)| {
        range(ends.into(), |value: f64| match 1e3 * value {
            value if value < 100.0 => format!("{value:.1}"),
            value => format!("{value:.0}"),
        })
    };
    let number = |number: Option<String>| number.map_or_else(|| Message::verbatim(""), number_alone);
    Table {
        name: "candidates",
        columns: vec![
            candidates.shown(say!(candidate_head), |candidate| finding.name(candidate)),
            candidates.digits(say!(share_head), 3, |candidate| candidate.share),
            candidates.digits(Message::verbatim("Hz"), 0, |candidate| candidate.frequency),
            candidates.shown(say!(predicts_column), |candidate| number(candidate.wavelengths.map(millimetres))),
        ],
    }
}

/// One row for each candidate of each finding.
pub(super) fn candidates(diagnosis: &Diagnosis) -> Table {
    let findings = diagnosis.findings.iter();
    let rows: Vec<_> = findings
        .flat_map(|finding| finding.candidates.iter().map(|candidate| (&finding.measured, candidate)))
        .collect();
    Table {
        name: "candidates",
        columns: vec![
            rows.names("rail", |(measured, _)| measured.rail.as_deref().unwrap_or_default()),
            rows.exact("wavelength_m", |(measured, _)| measured.peak.wavelength),
            rows.names("mechanism", |(_, candidate)| candidate.kind.name()),
            rows.names("of", |(_, candidate)| candidate.of.as_deref().unwrap_or_default()),
            rows.exact("share", |(_, candidate)| candidate.share),
            rows.exact("frequency_hz", |(_, candidate)| candidate.frequency),
            rows.exact("shortest_wavelength_m", |(_, candidate)| Some(candidate.wavelengths?.0)),
            rows.exact("longest_wavelength_m", |(_, candidate)| Some(candidate.wavelengths?.1)),
        ],
    }
}

/// Where the dominant wavelengths stand, one row for each place.
pub(super) fn places(diagnosis: &Diagnosis) -> Table {
    let findings = diagnosis.findings.iter();
    let rows: Vec<_> =
        findings.flat_map(|finding| finding.measured.places.iter().map(|place| (&finding.measured, place))).collect();
    Table {
        name: "places",
        columns: vec![
            rows.names("rail", |(measured, _)| measured.rail.as_deref().unwrap_or_default()),
            rows.exact("wavelength_m", |(measured, _)| measured.peak.wavelength),
            rows.exact("from_m", |(_, place)| place.from),
            rows.exact("to_m", |(_, place)| place.to),
            rows.exact("level_db", |(_, place)| place.level),
        ],
    }
}
