//! A finding as data.

use riffel::diagnosis::{Candidate, Course};
use riffel_keys::Message;
use serde::{Serialize, Serializer};

use super::Finding;
use super::mechanism_words::{settled_by, source, validity};
use super::reason::course_in_words;
use crate::capital::as_sentence;
use crate::ridge::mechanism_name;

#[derive(Serialize)]
struct Dominant<'a> {
    /// None for a table of levels that does not name its rails.
    rail: Option<&'a str>,
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

/// What is told of a finding.
impl Serialize for Finding {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let measured = &self.measured;
        let (peak, speeds) = (&measured.peak, &self.speeds);
        let places = measured.places.iter();
        let places = places.map(|place| PlaceDocument { from_m: place.from, to_m: place.to, level_db: place.level });
        let rails = measured.rails.iter().map(|(name, level)| Rail { name: name.clone(), level_db: *level });
        let energies = measured.energy_levels.as_deref();
        let candidates = self.candidates.iter();
        let dominant = Dominant {
            rail: measured.rail.as_deref(),
            places: places.collect(),
            all_along: measured.all_along,
            wavelength_m: peak.wavelength,
            from_m: peak.from,
            to_m: peak.to,
            frequency_min_hz: speeds.slowest() / peak.wavelength,
            frequency_max_hz: speeds.fastest() / peak.wavelength,
            level_db: peak.level,
            prominence_db: peak.prominence,
            scatter_db: peak.scatter,
            false_peaks: peak.false_peaks,
            harmonic_of_m: peak.harmonic_of.map(|harmonic| harmonic.1),
            sideband_of_m: self.sideband.map(|sideband| sideband.of),
            rails: rails.collect(),
            course: measured.course.as_ref().map(|course| CourseDocument::new(course, energies)),
            summary: self.summary(),
            candidates: candidates.map(|candidate| CandidateDocument::new(self, candidate)).collect(),
            measurements: self.measurements().map(|one| as_sentence(&one)).collect(),
        };
        dominant.serialize(serializer)
    }
}

impl CourseDocument {
    fn new(course: &Course, energies: Option<&[f64]>) -> Self {
        Self {
            records: course.points.iter().map(|point| point.label.clone()).collect(),
            levels_db: course.points.iter().map(|point| point.level).collect(),
            energy_mean_levels_db: energies.map(<[f64]>::to_vec),
            ground_before: (course.since > 0).then(|| course.points[course.since].label.clone()),
            slope_db: course.slope.map(|slope| slope.mean),
            slope_scatter_db: course.slope.map(|slope| slope.scatter),
            per: course.unit.name(),
            probability_of_rise: course.probability_of_rise(),
            sentence: course_in_words(course),
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
