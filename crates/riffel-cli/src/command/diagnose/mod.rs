//! `riffel diagnose`

pub(crate) mod figure;
mod request;
mod words;

use std::io::{self, Write};

use riffel_case::diagnosis::{Diagnosis, DiagnosisDocument};

use super::roughness::read;
use crate::arguments::Diagnose;
use crate::messages::print_remarks;
use crate::output::{json, print};
use crate::staging::Staging;

pub(crate) use request::diagnosis;
pub(crate) use words::{capital, row};

pub(crate) fn run(arguments: &Diagnose) -> miette::Result<()> {
    let case = arguments.case.read()?;
    let record = read(&arguments.roughness, &arguments.record.layout)?;
    let diagnosis = diagnosis(&case, &arguments.roughness, &record, &arguments.record)?;
    let file = arguments.roughness.display().to_string();
    let document = json(&DiagnosisDocument::new(&file, &diagnosis));
    if arguments.json {
        print(&document)?;
        print_remarks(&diagnosis.warnings);
        if arguments.output.is_none() {
            return Ok(());
        }
    }
    let folder = arguments
        .case
        .folder(arguments.output.as_deref(), "diagnosis");
    let mut staging = Staging::new("diagnose", &folder)?;
    staging.write_figure("diagnosis", &figure::of(&file, &diagnosis))?;
    staging.write_with("candidates.csv", |file| candidates(&diagnosis, file))?;
    staging.write_with("places.csv", |file| places(&diagnosis, file))?;
    staging.write("diagnosis.json", document)?;
    let files = staging.publish()?;
    if !arguments.json {
        let place = format!("{}: {}\n", folder.display(), files.join(" "));
        print(&(words::readable(&diagnosis, &file, &case) + &place))?;
        print_remarks(&diagnosis.warnings);
    }
    Ok(())
}

/// The candidates of all findings as a table.
fn candidates(diagnosis: &Diagnosis, file: &mut impl Write) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(file);
    writer.write_record([
        "rail",
        "wavelength_m",
        "mechanism",
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
fn places(diagnosis: &Diagnosis, file: &mut impl Write) -> io::Result<()> {
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
