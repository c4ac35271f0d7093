//! A diagnosis as tables.

use riffel_keys::{Message, range, say};

use super::{Diagnosis, Finding};
use crate::number_alone;
use crate::{Column, Table};

/// What a reader sees of the candidates of a finding: name, share, frequency and wavelengths.
pub(crate) fn of_finding(finding: &Finding) -> Table {
    let candidates = || finding.candidates.iter();
    let millimetres = |ends: (f64, f64)| {
        range(ends.into(), |value: f64| match 1e3 * value {
            value if value < 100.0 => format!("{value:.1}"),
            value => format!("{value:.0}"),
        })
    };
    let number = |number: Option<String>| number.map_or_else(|| Message::verbatim(""), number_alone);
    let shares = candidates().map(|candidate| number_alone(format!("{:.3}", candidate.share)));
    let frequencies = candidates().map(|candidate| number(candidate.frequency.map(|hertz| format!("{hertz:.0}"))));
    Table {
        name: "candidates",
        columns: vec![
            Column::shown(say!(candidate_head), candidates().map(|candidate| finding.name(candidate)).collect()),
            Column::shown(say!(share_head), shares.collect()),
            Column::shown(Message::verbatim("Hz"), frequencies.collect()),
            Column::shown(
                say!(predicts_column),
                candidates().map(|candidate| number(candidate.wavelengths.map(millimetres))).collect(),
            ),
        ],
    }
}

/// One row for each candidate of each finding.
pub(super) fn candidates(diagnosis: &Diagnosis) -> Table {
    let findings = diagnosis.findings.iter();
    let rows: Vec<_> = findings
        .flat_map(|finding| finding.candidates.iter().map(|candidate| (&finding.measured, candidate)))
        .collect();
    let rows = || rows.iter();
    Table {
        name: "candidates",
        columns: vec![
            Column::names("rail", rows().map(|(measured, _)| measured.rail.as_deref().unwrap_or_default())),
            Column::exact("wavelength_m", rows().map(|(measured, _)| measured.peak.wavelength)),
            Column::names("mechanism", rows().map(|(_, candidate)| candidate.kind.name())),
            Column::names("of", rows().map(|(_, candidate)| candidate.of.as_deref().unwrap_or_default())),
            Column::exact("share", rows().map(|(_, candidate)| candidate.share)),
            Column::exact("frequency_hz", rows().map(|(_, candidate)| candidate.frequency)),
            Column::exact("shortest_wavelength_m", rows().map(|(_, candidate)| Some(candidate.wavelengths?.0))),
            Column::exact("longest_wavelength_m", rows().map(|(_, candidate)| Some(candidate.wavelengths?.1))),
        ],
    }
}

/// Where the dominant wavelengths stand, one row for each place.
pub(super) fn places(diagnosis: &Diagnosis) -> Table {
    let findings = diagnosis.findings.iter();
    let rows: Vec<_> =
        findings.flat_map(|finding| finding.measured.places.iter().map(|place| (&finding.measured, place))).collect();
    let rows = || rows.iter();
    Table {
        name: "places",
        columns: vec![
            Column::names("rail", rows().map(|(measured, _)| measured.rail.as_deref().unwrap_or_default())),
            Column::exact("wavelength_m", rows().map(|(measured, _)| measured.peak.wavelength)),
            Column::exact("from_m", rows().map(|(_, place)| place.from)),
            Column::exact("to_m", rows().map(|(_, place)| place.to)),
            Column::exact("level_db", rows().map(|(_, place)| place.level)),
        ],
    }
}
