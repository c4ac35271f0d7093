//! A diagnosis as tables.

use std::io::{self, Write};

use super::Diagnosis;

/// The candidates of all findings as a table.
pub(super) fn candidates(diagnosis: &Diagnosis, file: &mut impl Write) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(file);
    writer.write_record([
        "rail",
        "wavelength_m",
        "mechanism",
        "of",
        "share",
        "frequency_hz",
        "shortest_wavelength_m",
        "longest_wavelength_m",
    ])?;
    for finding in &diagnosis.findings {
        for candidate in &finding.candidates {
            writer.serialize((
                finding.measured.rail.as_deref(),
                finding.measured.peak.wavelength,
                candidate.kind.name(),
                candidate.of.as_deref(),
                candidate.share,
                candidate.frequency,
                candidate.wavelengths.map(|range| range.0),
                candidate.wavelengths.map(|range| range.1),
            ))?;
        }
    }
    writer.flush()
}

/// Where the dominant wavelengths stand, as a table.
pub(super) fn places(diagnosis: &Diagnosis, file: &mut impl Write) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(file);
    writer.write_record(["rail", "wavelength_m", "from_m", "to_m", "level_db"])?;
    for finding in &diagnosis.findings {
        let measured = &finding.measured;
        for place in &measured.places {
            let rail = measured.rail.as_deref();
            let wavelength = measured.peak.wavelength;
            writer.serialize((rail, wavelength, place.from, place.to, place.level))?;
        }
    }
    writer.flush()
}
