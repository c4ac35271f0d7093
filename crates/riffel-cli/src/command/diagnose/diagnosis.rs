//! A diagnosis: all dominant wavelengths of a record, held against a case.

use std::io::{self, Write};

use riffel::ContactFilter;
use riffel::diagnosis::{
    Evidence, GrowthDensity, Instrument, Mechanism, MechanismKind, TrafficSpeeds, rank, tell_apart,
};
use riffel_case::Case;
use riffel_case::roughness::RoughnessFile;

use super::finding::Finding;
use super::record::{Curves, Records};
use super::speeds;
use crate::arguments::{DiagnosisArguments, covering, positive};

/// All findings of a record.
pub(crate) struct Diagnosis {
    pub(crate) findings: Vec<Finding>,
    pub(crate) speeds: TrafficSpeeds,
    pub(crate) curves: Curves,
    pub(crate) words: String,
    pub(crate) warnings: Vec<String>,
}

impl Diagnosis {
    pub(crate) fn of(
        case: &Case,
        file: &RoughnessFile,
        arguments: &DiagnosisArguments,
    ) -> miette::Result<Self> {
        let mut warnings = Vec::new();
        let speeds = speeds(case, arguments, &mut warnings)?;
        let (mut mechanisms, unknown) = case.mechanisms();
        for (argument, kind, frequencies) in [
            (
                "--torsion",
                MechanismKind::WheelsetTorsion,
                &arguments.torsion,
            ),
            (
                "--bending",
                MechanismKind::WheelsetBending,
                &arguments.bending,
            ),
        ] {
            for &frequency in frequencies {
                mechanisms.push(Mechanism::of_frequency(
                    kind,
                    positive(argument, frequency)?,
                ));
            }
        }
        let records = Records::of(file, arguments)?;
        warnings.extend(records.warnings);
        if !records.measured.is_empty() {
            warnings.extend(unknown);
        }
        let filter = ContactFilter::of(&case.hertz);
        let instrument = if arguments.from_vehicle {
            Instrument::Vehicle
        } else {
            Instrument::Trolley
        };
        let mut findings = Vec::new();
        for measured in records.measured {
            let mut mechanisms = mechanisms.clone();
            match growth(case, measured.peak.wavelength, &speeds) {
                Ok(density) => mechanisms.insert(0, Mechanism::growth_ridge(density)),
                Err(message) => warnings.push(format!(
                    "the growth ridge is not among the candidates: {message}"
                )),
            }
            let evidence = Evidence {
                peak: &measured.peak,
                course: measured.course.as_ref(),
                speeds: &speeds,
                filter: &filter,
                instrument,
            };
            let candidates = rank(&evidence, &mechanisms);
            let course = measured.course.as_ref();
            let measurements = tell_apart(&measured.peak, &candidates, course, &speeds);
            findings.push(Finding {
                measured,
                candidates,
                measurements,
            });
        }
        Ok(Self {
            findings,
            curves: records.curves,
            words: records.words,
            speeds,
            warnings,
        })
    }

    /// The candidates of all findings as a table.
    pub(crate) fn table(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        writer.write_record([
            "wavelength_m",
            "mechanism",
            "share",
            "frequency_hz",
            "shortest_wavelength_m",
            "longest_wavelength_m",
        ])?;
        for finding in &self.findings {
            for candidate in &finding.candidates {
                writer.serialize((
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

    pub(crate) fn readable(&self, file: &str, case: &Case) -> String {
        let title = case.file.title.as_deref().unwrap_or("the case");
        let mut text = format!(
            "{file}: {}\nheld against: {title}; traffic at {}\n",
            self.words,
            self.speeds.words()
        );
        if self.findings.is_empty() {
            text += "no dominant wavelength: nothing stands 3 dB over the trend of its neighbours beyond chance\n";
        }
        for finding in &self.findings {
            text += &format!("\n{}", finding.readable(&self.speeds));
        }
        text
    }
}

/// Growth of the case over the wavelengths of its map and the one measured, but for those that the patch does not
/// let through.
fn growth(case: &Case, measured: f64, speeds: &TrafficSpeeds) -> Result<GrowthDensity, String> {
    /// Shortest wavelength in semi-axes: 1.5 contact lengths (Frederick 1987, in Afferrante & Ciavarella
    /// 2009).
    const SHORTEST: f64 = 3.0;
    let shortest = SHORTEST * case.hertz.semi_axis_longitudinal();
    let from = measured.min(case.wavelength.min()).max(shortest);
    let to = measured.max(case.wavelength.max());
    if from >= to {
        return Err(format!(
            "the map of the case ends at {:.0} mm, and waves shorter than 1.5 contact lengths, {:.0} mm, pass unseen",
            1e3 * to,
            1e3 * shortest
        ));
    }
    case.check_frequencies(speeds.slowest() / to, speeds.fastest() / from)
        .map_err(|error| error.to_string())?;
    let covered = covering(case, from, to).map_err(|error| error.to_string())?;
    Ok(GrowthDensity::new(&covered.feedback, from, to, speeds))
}
