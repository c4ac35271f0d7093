//! A finding: one dominant wavelength with its candidates, in words.

use riffel::diagnosis::{Candidate, LevelTrend, Measurement, MechanismKind, Reason, TrafficSpeeds};
use riffel_keys::{Language, Message, Value, fixed, number, range, say};
use riffel_rail::history::Measured;
use riffel_rail::{name_in_words, rail_in_words};
use serde::{Serialize, Serializer};

use super::Sideband;
use super::mechanism_words::{settled_by, source, validity};
use super::reason::{self, course_in_words};
use crate::capital::as_sentence;
use crate::ridge::mechanism_name;

/// Probability below which a level is not said to rise, or to fall.
pub(super) const UNLIKELY: f64 = 0.05;

/// A dominant wavelength with what may have made it.
pub struct Finding {
    /// What stands out, and what it did in time.
    pub measured: Measured,
    /// Whether it only comes with a higher wave.
    pub sideband: Option<Sideband>,
    /// What may have made it, the likeliest first; none of a sideband.
    pub candidates: Vec<Candidate>,
    /// What would tell the candidates apart.
    pub(super) measurements: Vec<Measurement>,
    /// The wheels after which growth ridges are called.
    pub(super) wheels: Vec<Message>,
    /// The speeds of the traffic.
    pub(super) speeds: TrafficSpeeds,
}

impl Finding {
    /// Wavelength and frequencies.
    pub fn headline(&self) -> Message {
        let peak = &self.measured.peak;
        let millimetres = |length: f64| format!("{:.1}", 1e3 * length);
        let (wavelength, band) =
            (number(millimetres(peak.wavelength)), number(range([peak.from, peak.to], millimetres)));
        let speeds = &self.speeds;
        let frequencies = [speeds.slowest(), speeds.fastest()].map(|speed| speed / peak.wavelength);
        let frequency = number(range(frequencies, |hertz| format!("{hertz:.0}")));
        let speeds = speeds.words();
        match self.place() {
            Some(place) => say!(dominant_wavelength_at, wavelength, band, place, frequency, speeds),
            None => {
                say!(dominant_wavelength, wavelength, band, frequency, speeds)
            }
        }
    }

    /// Rail and place: "rail low, 1200–1240 m and 2 more places".
    pub fn place(&self) -> Option<Message> {
        let Measured { rail, places, all_along, .. } = &self.measured;
        let rail = rail_in_words(rail.as_deref()?);
        let place = match (places.first(), all_along) {
            // A table of levels has no places.
            (None, _) => rail,
            (Some(_), true) => say!(rail_all_along, rail),
            (Some(first), false) => {
                say!(rail_from_to, rail, from = fixed(first.from, 1), to = fixed(first.to, 1))
            }
        };
        Some(match places.len() {
            0 | 1 => place,
            count => say!(more_places, place, count = count - 1),
        })
    }

    /// Level, prominence and how sure.
    pub fn sureness(&self) -> Message {
        let Measured { peak, rails, record, .. } = &self.measured;
        let (level, prominence) = (fixed(peak.level, 1), fixed(peak.prominence, 1));
        let scatter = match peak.scatter {
            Some(scatter) => say!(scatter_of, scatter = fixed(scatter, 1)),
            None => say!(scatter_unknown),
        };
        let level = match record {
            Some(record) => say!(level_of_record, level, record),
            None => say!(level_of_peak, level),
        };
        let level = match rails.is_empty() {
            true => level,
            false => {
                let rails: Value = rails
                    .iter()
                    .map(|(name, level)| say!(level_of_rail, name = name_in_words(name), level = fixed(*level, 1)))
                    .collect();
                say!(with_levels_of_rails, level, rails)
            }
        };
        let mut words = say!(stands_over_its_trend, level, prominence, scatter);
        let chance = peak.false_peaks.map(|peaks| match peaks < 1e-6 {
            true => say!(by_chance_in_a_million),
            false => say!(by_chance, spectra = fixed(1.0 / peaks, 0)),
        });
        let harmonic = peak.harmonic_of.map(|(order, longer)| {
            let longer = fixed(1e3 * longer, 1);
            say!(harmonic_of, order = number(order), wavelength = longer)
        });
        for more in chance.into_iter().chain(harmonic) {
            words = say!(one_after_other, one = words, other = more);
        }
        words
    }

    /// What the course says, with the means of energies beside those of levels.
    pub fn course(&self) -> Option<Message> {
        let course = course_in_words(self.measured.course.as_ref()?);
        Some(match &self.measured.energy_levels {
            Some(levels) => {
                let levels: Value = levels.iter().map(|level| fixed(*level, 1)).collect();
                let energies = say!(means_of_energies, levels);
                say!(one_after_other, one = course, other = energies)
            }
            None => course,
        })
    }

    /// The candidates in sentences: who leads, who is next, and what the course rules out.
    pub fn summary(&self) -> Message {
        if let Some(Sideband { order, of, spacing }) = self.sideband {
            return say!(
                comes_with_wave,
                wavelength = fixed(1e3 * of, 1),
                order = number(order),
                spacing = fixed(spacing, 2)
            );
        }
        let [first, second, ..] = &self.candidates[..] else {
            return Message::verbatim("");
        };
        let leads = say!(
            candidate_leads,
            first = self.name(first),
            share = fixed(first.share, 2),
            second = self.name(second),
            other = fixed(second.share, 2)
        );
        let course = self.measured.course.as_ref();
        if self.measured.gone
            && let Some(course) = course
        {
            let gone = say!(
                gone_by_grinding,
                fall = fixed(course.fall().unwrap_or(0.0), 1),
                record = course.on_line()[0].label.as_str()
            );
            return say!(two_sentences, one = gone, other = leads);
        }
        let is_mark = first.kind == MechanismKind::GrindingMark;
        let says = match course.map(LevelTrend::probability_of_rise) {
            Some(None) => say!(one_record_since_ground),
            Some(Some(rises)) if rises < UNLIKELY && is_mark => {
                say!(level_falls_as_grinding_mark, percent = percent(1.0 - rises))
            }
            Some(Some(rises)) if rises < UNLIKELY => {
                say!(level_falls, percent = percent(1.0 - rises))
            }
            Some(Some(rises)) if rises > 1.0 - UNLIKELY => {
                say!(level_rises, percent = percent(rises))
            }
            Some(Some(rises)) => say!(rise_is_open, percent = fixed(100.0 * rises, 0)),
            None => say!(one_record_only),
        };
        say!(two_sentences, one = leads, other = says)
    }

    /// What a candidate is called, as in "growth ridge, wheelset 1, low rail".
    pub fn name(&self, candidate: &Candidate) -> Message {
        let mechanism = mechanism_name(candidate.kind);
        match self.wheel(candidate) {
            Some(wheel) => say!(mechanism_of, mechanism, wheel = wheel.clone()),
            None => mechanism,
        }
    }

    /// Under which of several wheels a candidate grows.
    pub(super) fn wheel(&self, candidate: &Candidate) -> Option<&Message> {
        let mut wheels = self.wheels.iter();
        wheels.find(|wheel| candidate.of == Some(wheel.text(Language::English)))
    }

    /// Reasons in sentences.
    pub fn reasons<'a>(&'a self, reasons: &'a [Reason]) -> impl Iterator<Item = Message> + 'a {
        let course = self.measured.course.as_ref();
        reasons.iter().map(move |reason| reason::in_words(reason, &self.speeds, course))
    }

    /// What would tell the candidates apart, a sentence each.
    pub fn measurements(&self) -> impl Iterator<Item = Message> {
        let wavelength = self.measured.peak.wavelength;
        let measurements = self.measurements.iter();
        measurements.map(move |one| reason::measurement(*one, wavelength, &self.speeds))
    }
}

fn percent(probability: f64) -> Message {
    match probability > 0.9995 {
        true => say!(more_than_999_per_mille),
        false => say!(percent_of, percent = fixed(100.0 * probability, 1)),
    }
}

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
    places: Vec<RailPlace>,
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
    rails: Vec<RailLevel>,
    course: Option<MeasuredTrend>,
    summary: Message,
    candidates: Vec<RankedCandidate>,
    measurements: Vec<Message>,
}

#[derive(Serialize)]
struct RailPlace {
    from_m: f64,
    to_m: f64,
    level_db: f64,
}

#[derive(Serialize)]
struct RailLevel {
    name: String,
    level_db: f64,
}

#[derive(Serialize)]
struct MeasuredTrend {
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
struct RankedCandidate {
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
        let places = places.map(|place| RailPlace { from_m: place.from, to_m: place.to, level_db: place.level });
        let rails = measured.rails.iter().map(|(name, level)| RailLevel { name: name.clone(), level_db: *level });
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
            course: measured.course.as_ref().map(|course| MeasuredTrend::new(course, energies)),
            summary: self.summary(),
            candidates: candidates.map(|candidate| RankedCandidate::new(self, candidate)).collect(),
            measurements: self.measurements().map(|one| as_sentence(&one)).collect(),
        };
        dominant.serialize(serializer)
    }
}

impl MeasuredTrend {
    fn new(course: &LevelTrend, energies: Option<&[f64]>) -> Self {
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

impl RankedCandidate {
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
