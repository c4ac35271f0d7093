//! Diagnosis: the dominant wavelengths of a rail, held against a case.

mod candidate_row;
mod case_mechanisms;
mod document;
mod figure;
mod finding;
pub(crate) mod mechanism_words;
mod reason;
mod sideband;
mod tables;

use std::io::{self, Write};

use riffel::contact::ContactFilter;
use riffel::diagnosis::{Evidence, Instrument, Mechanism, MechanismKind, TrafficSpeeds, rank, tell_apart};

use case_mechanisms::{Wheels, near, wheelset_modes};

pub use candidate_row::candidate_row;
pub use document::DiagnosisDocument;
pub use finding::Finding;
pub(crate) use reason::course_in_words;
pub use sideband::Sideband;

use riffel::roughness::RailDefect;
use riffel_case::Case;
use riffel_case::traffic::UsualTraffic;
use riffel_keys::{CaseError, Language, Message, say};
use riffel_plot::LineFigure;
use riffel_rail::RailRecord;
use riffel_rail::history::{Curves, RailHistory, SpectraChoice};

/// What a diagnosis goes by besides case and records.
#[derive(Debug, Clone)]
pub struct DiagnosisSettings<'a> {
    /// Speeds of the traffic.
    pub speeds: TrafficSpeeds,
    /// Which spectra of a table are meant.
    pub spectra: SpectraChoice<'a>,
    /// Frequencies of torsional modes of the wheelset \[Hz\], in place of those of the case.
    pub torsion: Vec<f64>,
    /// Frequencies of bending modes of the wheelset \[Hz\], in place of those of the case.
    pub bending: Vec<f64>,
    /// What the records were taken with.
    pub instrument: Instrument,
}

/// All findings of a record.
pub struct Diagnosis {
    /// The dominant wavelengths with their candidates: rail by rail, the one with the highest level first, and of a
    /// rail the most prominent first; behind them those that are gone by grinding.
    pub findings: Vec<Finding>,
    /// Speeds of the traffic.
    pub speeds: TrafficSpeeds,
    /// What a figure shows of the records.
    pub curves: Curves,
    /// What the records are, in words.
    pub words: Message,
    /// Welds, joints and squats by rail, which the spectra leave out unless they were kept.
    pub defects: Vec<(String, RailDefect)>,
    /// What was put right in the records, and what the case knows nothing of.
    pub warnings: Vec<Message>,
}

impl Diagnosis {
    /// A rail held against a case. Earlier records are the oldest first.
    ///
    /// Cost: a transform of each record, and for each dominant wavelength the growth of the case at every speed and 200
    /// wavelengths a decade.
    ///
    /// # Errors
    /// [`CaseError::Data`] where a record has no spectrum, is of another kind than the present one, or a choice does
    /// not fit.
    pub fn new(
        case: &Case,
        present: &RailRecord<'_>,
        earlier: &[RailRecord<'_>],
        settings: &DiagnosisSettings<'_>,
    ) -> Result<Self, CaseError> {
        let speeds = &settings.speeds;
        let (mut mechanisms, unknown) = case.mechanisms();
        let mut own_modes = wheelset_modes(case);
        for (kind, frequencies) in
            [(MechanismKind::WheelsetTorsion, &settings.torsion), (MechanismKind::WheelsetBending, &settings.bending)]
        {
            let modes = frequencies.iter();
            mechanisms.extend(modes.map(|&frequency| Mechanism::of_frequency(kind, frequency)));
            // What was measured of the wheelset goes before what its model says.
            own_modes.retain(|mode| mode.0 != kind || frequencies.is_empty());
        }
        let wheels = Wheels::of(case);
        let records = RailHistory::new(present, earlier, settings.spectra)?;
        let mut warnings = records.warnings;
        if !records.measured.is_empty() {
            warnings.extend(unknown);
        }
        let filter = ContactFilter::of(&case.hertz);
        let mut findings = Vec::new();
        for measured in &records.measured {
            let mut mechanisms = mechanisms.clone();
            let wavelength = measured.peak.wavelength;
            let (growth, unknown) = wheels.growth(measured.rail.as_deref(), wavelength, speeds);
            mechanisms.splice(0..0, growth);
            mechanisms.extend(near(&own_modes, wavelength, speeds));
            warnings.extend(unknown);
            if measured.gone {
                // A mark is there after grinding.
                mechanisms.retain(|mechanism| mechanism.kind != MechanismKind::GrindingMark);
            }
            let evidence = Evidence {
                peak: &measured.peak,
                course: measured.course.as_ref(),
                speeds,
                filter: &filter,
                instrument: settings.instrument,
            };
            let sideband = Sideband::new(measured, &records.measured, &mechanisms);
            let (mut candidates, mut measurements) = (Vec::new(), Vec::new());
            // A sideband has the cause of its wave.
            if sideband.is_none() {
                candidates = rank(&evidence, &mechanisms);
                measurements = tell_apart(&candidates, evidence.course);
            }
            findings.push(Finding {
                sideband,
                measured: measured.clone(),
                candidates,
                measurements,
                wheels: wheels.names(),
                speeds: speeds.clone(),
            });
        }
        Ok(Self {
            findings,
            curves: records.curves,
            words: records.words,
            defects: records.defects,
            speeds: speeds.clone(),
            warnings,
        })
    }

    /// The diagnosis as data: what `riffel diagnose --json` prints; `file` is the name of the record.
    pub fn document(&self, file: &str) -> DiagnosisDocument {
        DiagnosisDocument::new(file, self)
    }

    /// Spectra with the dominant wavelengths marked.
    pub fn figure(&self, file: &str, language: Language) -> LineFigure {
        figure::of(file, self, language)
    }

    /// One row for each candidate of each finding.
    ///
    /// # Errors
    /// Those of the file.
    pub fn candidates_csv(&self, file: &mut impl Write) -> io::Result<()> {
        tables::candidates(self, file)
    }

    /// Where the dominant wavelengths stand, one row for each place.
    ///
    /// # Errors
    /// Those of the file.
    pub fn places_csv(&self, file: &mut impl Write) -> io::Result<()> {
        tables::places(self, file)
    }

    /// The speeds of the usual traffic of a line, where none are known, and a remark on them.
    ///
    /// # Errors
    /// [`riffel::Error::OutOfRange`] for speeds not above zero.
    pub fn usual_speeds(case: &Case) -> Result<(TrafficSpeeds, Message), riffel::Error> {
        let usual = UsualTraffic::of(case);
        let [slowest, fastest] = usual.speeds;
        let sentence = say!(speeds_of_the_usual_traffic, traffic = usual.in_words());
        let speeds = TrafficSpeeds::between(slowest, fastest)?;
        let growing = usual.traffic().ok().map(|it| it.passing_speeds());
        Ok(match growing.transpose()? {
            Some(growing) => (speeds.growing_under(growing), sentence),
            None => (speeds, sentence),
        })
    }
}
