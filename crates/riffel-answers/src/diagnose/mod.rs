//! Diagnosis: the dominant wavelengths of a rail, held against a case.

mod case_mechanisms;
mod figure;
mod finding;
pub(crate) mod mechanism_words;
mod printed;
mod question;
mod reason;
mod sideband;
pub(crate) mod tables;

use riffel::contact::ContactFilter;
use riffel::diagnosis::{Evidence, Instrument, Mechanism, MechanismKind, TrafficSpeeds, rank, tell_apart};

use case_mechanisms::{Wheels, near, wheelset_modes};

pub use finding::Finding;
pub use question::{DiagnoseQuestion, DiagnosedRail};
pub(crate) use reason::course_in_words;
pub use sideband::Sideband;

use riffel::roughness::RailDefect;
use riffel_case::traffic::UsualTraffic;
use riffel_case::{Case, traffic};
use riffel_keys::{CaseError, Language, Message, number, say};
use riffel_plot::LineFigure;
use riffel_rail::RailRecord;
use riffel_rail::history::{Curves, RailHistory, SpectraChoice};
use serde::{Serialize, Serializer};

use crate::defect::Defect;
use crate::{Answer, Printed, Table};

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
#[derive(Serialize)]
pub struct Diagnosis {
    /// The record, or what it is called.
    file: String,
    /// What the records are, in words.
    #[serde(rename = "record")]
    pub words: Message,
    speed_min_m_per_s: f64,
    speed_max_m_per_s: f64,
    /// What the shares mean.
    share: Message,
    /// The dominant wavelengths with their candidates: rail by rail, the one with the highest level first, and of a
    /// rail the most prominent first; behind them those that are gone by grinding.
    #[serde(rename = "dominant_wavelengths")]
    pub findings: Vec<Finding>,
    /// Welds, joints and squats by rail, which the spectra leave out unless they were kept.
    #[serde(serialize_with = "as_documents")]
    pub defects: Vec<(String, RailDefect)>,
    /// What was put right in the records, and what the case knows nothing of.
    pub warnings: Vec<Message>,
    /// Speeds of the traffic.
    #[serde(skip)]
    pub speeds: TrafficSpeeds,
    /// What a figure shows of the records.
    #[serde(skip)]
    pub curves: Curves,
    /// That of the case.
    #[serde(skip)]
    title: Option<String>,
}

fn as_documents<S: Serializer>(defects: &[(String, RailDefect)], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(defects.iter().map(|(rail, defect)| Defect::new(rail, defect)))
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
        let (mut mechanisms, unknown) = traffic::mechanisms(case);
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
            file: present.name.display().to_string(),
            speed_min_m_per_s: speeds.slowest(),
            speed_max_m_per_s: speeds.fastest(),
            share: say!(share_of_belief),
            title: case.file.title.clone(),
            findings,
            curves: records.curves,
            words: records.words,
            defects: records.defects,
            speeds: speeds.clone(),
            warnings,
        })
    }

    /// Spectra with the dominant wavelengths marked.
    pub(crate) fn figure_in(&self, language: Language) -> LineFigure {
        figure::of(self, language)
    }

    /// The speeds of the usual traffic of a line, where none are known, and a remark on them.
    ///
    /// # Errors
    /// [`riffel::Error::OutOfRange`] for speeds not above zero.
    fn usual_speeds(case: &Case) -> Result<(TrafficSpeeds, Message), riffel::Error> {
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

impl Answer for Diagnosis {
    fn name(&self) -> &'static str {
        "diagnosis"
    }

    fn folder_name(&self) -> Option<&'static str> {
        Some("diagnosis")
    }

    fn document_name(&self) -> &'static str {
        "diagnosis.json"
    }

    fn introduction(&self) -> Vec<Message> {
        let title = self.title.as_deref().map_or_else(|| say!(the_case), Message::verbatim);
        let held = say!(held_against, title, speeds = number(self.speeds.words()));
        let nothing = self.findings.is_empty().then(|| say!(nothing_stands_out));
        [self.words.clone().about(self.file.as_str()), held].into_iter().chain(nothing).collect()
    }

    fn tables(&self) -> Vec<Table> {
        vec![tables::candidates(self), tables::places(self)]
    }

    fn sentences(&self) -> Vec<Message> {
        Vec::new()
    }

    fn printed(&self) -> Vec<Printed> {
        let introduction = self.introduction().into_iter().map(Printed::Line);
        introduction.chain(self.findings.iter().flat_map(printed::finding)).collect()
    }

    fn figure(&self) -> LineFigure {
        self.figure_in(Language::English)
    }

    fn remarks(&self) -> &[Message] {
        &self.warnings
    }
}
