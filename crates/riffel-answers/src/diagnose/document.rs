//! A diagnosis as data: what `riffel diagnose --json` prints.

use riffel::diagnosis::Candidate;
use riffel_keys::{Message, say};
use serde::Serialize;

use super::mechanism_words::{settled_by, source, validity};
use super::reason::course_in_words;
use super::{Diagnosis, Finding};
use crate::capital::as_sentence;
use crate::defect_document::DefectDocument;
use crate::ridge::mechanism_name;

/// A diagnosis with keys and units, to be serialised.
#[derive(Serialize)]
pub struct DiagnosisDocument {
    file: String,
    record: Message,
    speed_min_m_per_s: f64,
    speed_max_m_per_s: f64,
    /// What the shares mean.
    share: Message,
    dominant_wavelengths: Vec<Dominant>,
    /// Welds, joints and squats that the spectra leave out.
    defects: Vec<DefectDocument>,
    warnings: Vec<Message>,
}

#[derive(Serialize)]
struct Dominant {
    /// None for a table of levels that does not name its rails.
    rail: Option<String>,
    wavelength_m: f64,
    from_m: f64,
    to_m: f64,
    frequency_min_hz: f64,
    frequency_max_hz: f64,
    /// Where it stands along the rail, the highest level first.
    places: Vec<PlaceDocument>,
    all_along: bool,
    /// At the first place.
    level_db: f64,
    prominence_db: f64,
    scatter_db: Option<f64>,
    /// Peaks as high in a spectrum of pure noise, in the mean.
    false_peaks: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    harmonic_of_m: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    sideband_of_m: Option<f64>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    rails: Vec<Rail>,
    course: Option<CourseDocument>,
    summary: Message,
    candidates: Vec<CandidateDocument>,
    measurements: Vec<Message>,
}

#[derive(Serialize)]
struct PlaceDocument {
    from_m: f64,
    to_m: f64,
    level_db: f64,
}

#[derive(Serialize)]
struct Rail {
    name: String,
    level_db: f64,
}

#[derive(Serialize)]
struct CourseDocument {
    records: Vec<String>,
    levels_db: Vec<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    energy_mean_levels_db: Option<Vec<f64>>,
    /// The first record since the rail was ground, as it seems.
    #[serde(skip_serializing_if = "Option::is_none")]
    ground_before: Option<String>,
    slope_db: Option<f64>,
    slope_scatter_db: Option<f64>,
    per: &'static str,
    probability_of_rise: Option<f64>,
    sentence: Message,
}

#[derive(Serialize)]
struct CandidateDocument {
    mechanism: Message,
    /// Which of several: the wheel under which it grows.
    #[serde(skip_serializing_if = "Option::is_none")]
    of: Option<Message>,
    share: f64,
    frequency_hz: Option<f64>,
    wavelength_min_m: Option<f64>,
    wavelength_max_m: Option<f64>,
    reasons_for: Vec<Message>,
    reasons_against: Vec<Message>,
    source: Message,
    validity: Message,
    /// What would settle it.
    measurement: Message,
}

impl DiagnosisDocument {
    /// The diagnosis of a file, or of a record that is called so.
    pub(super) fn new(file: &str, diagnosis: &Diagnosis) -> Self {
        let speeds = &diagnosis.speeds;
        Self {
            file: file.to_owned(),
            record: diagnosis.words.clone(),
            speed_min_m_per_s: speeds.slowest(),
            speed_max_m_per_s: speeds.fastest(),
            share: say!(share_of_belief),
            dominant_wavelengths: diagnosis
                .findings
                .iter()
                .map(|finding| Dominant::new(finding, speeds.slowest(), speeds.fastest()))
                .collect(),
            defects: diagnosis.defects.iter().map(|(rail, defect)| DefectDocument::new(rail, defect)).collect(),
            warnings: diagnosis.warnings.clone(),
        }
    }
}

impl Dominant {
    fn new(finding: &Finding, slowest: f64, fastest: f64) -> Self {
        let peak = &finding.measured.peak;
        let rails = finding.measured.rails.iter();
        let course = finding.measured.course.as_ref();
        let places = finding.measured.places.iter();
        Self {
            rail: finding.measured.rail.clone(),
            places: places
                .map(|place| PlaceDocument { from_m: place.from, to_m: place.to, level_db: place.level })
                .collect(),
            all_along: finding.measured.all_along,
            wavelength_m: peak.wavelength,
            from_m: peak.from,
            to_m: peak.to,
            frequency_min_hz: slowest / peak.wavelength,
            frequency_max_hz: fastest / peak.wavelength,
            level_db: peak.level,
            prominence_db: peak.prominence,
            scatter_db: peak.scatter,
            false_peaks: peak.false_peaks,
            harmonic_of_m: peak.harmonic_of.map(|harmonic| harmonic.1),
            sideband_of_m: finding.sideband.map(|sideband| sideband.of),
            rails: rails.map(|(name, level)| Rail { name: name.clone(), level_db: *level }).collect(),
            course: course.map(|course| CourseDocument {
                records: course.points.iter().map(|point| point.label.clone()).collect(),
                levels_db: course.points.iter().map(|point| point.level).collect(),
                energy_mean_levels_db: finding.measured.energy_levels.clone(),
                ground_before: (course.since > 0).then(|| course.points[course.since].label.clone()),
                slope_db: course.slope.map(|slope| slope.mean),
                slope_scatter_db: course.slope.map(|slope| slope.scatter),
                per: course.unit.name(),
                probability_of_rise: course.probability_of_rise(),
                sentence: course_in_words(course),
            }),
            summary: finding.summary(),
            candidates: finding.candidates.iter().map(|candidate| CandidateDocument::new(finding, candidate)).collect(),
            measurements: finding.measurements().map(|one| as_sentence(&one)).collect(),
        }
    }
}

impl CandidateDocument {
    fn new(finding: &Finding, candidate: &Candidate) -> Self {
        Self {
            mechanism: mechanism_name(candidate.kind),
            of: (finding.wheel(candidate).cloned()).or_else(|| candidate.of.clone().map(Message::verbatim)),
            share: candidate.share,
            frequency_hz: candidate.frequency,
            wavelength_min_m: candidate.wavelengths.map(|range| range.0),
            wavelength_max_m: candidate.wavelengths.map(|range| range.1),
            reasons_for: finding.reasons(&candidate.reasons_for).collect(),
            reasons_against: finding.reasons(&candidate.reasons_against).collect(),
            source: source(candidate.kind),
            validity: validity(candidate.kind),
            measurement: as_sentence(&settled_by(candidate.kind)),
        }
    }
}
