//! Candidates for a dominant wavelength, in the order of what speaks for them.

use super::{
    Course, DominantWavelength, Expectation, Mechanism, MechanismKind, Prediction, TrafficSpeeds,
};
use crate::contact::ContactFilter;

/// Wavelengths over which a mechanism that is not listed spreads \[m\].
const ANY: (f64, f64) = (0.005, 2.0);
/// What a wavelength that the prediction does not cover weighs at most: a little less than nothing.
const NOT_COVERED: f64 = 0.99;
/// Share of surprises: a mechanism at work may still stand anywhere, and a level move the other way.
const SURPRISE: f64 = 0.05;

/// What the roughness was measured from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Instrument {
    /// A trolley or a fixed edge, which sees the rail alone.
    Trolley,
    /// A vehicle, whose wheels are in its record.
    Vehicle,
}

/// What is held against the mechanisms.
pub struct Evidence<'a> {
    /// The wavelength.
    pub peak: &'a DominantWavelength,
    /// What it does from record to record, if there are several.
    pub course: Option<&'a Course>,
    /// The speeds of the traffic.
    pub speeds: &'a TrafficSpeeds,
    /// What the patch of the case leaves of a wave.
    pub filter: &'a ContactFilter,
    /// What the record was taken from.
    pub instrument: Instrument,
}

/// A mechanism as an explanation of a dominant wavelength.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct Candidate {
    /// What it is.
    pub kind: MechanismKind,
    /// Which of several of its kind.
    pub of: Option<String>,
    /// Share of the belief among the candidates \[-\]; see the [module](super).
    pub share: f64,
    /// Frequency that it fixes \[Hz\].
    pub frequency: Option<f64>,
    /// Wavelengths that it predicts at the speeds of the traffic \[m\].
    pub wavelengths: Option<(f64, f64)>,
    /// What speaks for it, in sentences.
    pub reasons_for: Vec<String>,
    /// What speaks against it, in sentences.
    pub reasons_against: Vec<String>,
}

impl Candidate {
    /// As in "growth ridge, wheelset 1, low rail".
    pub fn name(&self) -> String {
        let of = self.of.as_ref();
        let of = of.map_or_else(String::new, |of| format!(", {of}"));
        format!("{}{of}", self.kind.name())
    }
}

/// The mechanisms and one that is not among them, the likeliest first.
pub fn rank(evidence: &Evidence, mechanisms: &[Mechanism]) -> Vec<Candidate> {
    let mut weighed: Vec<(f64, Candidate)> = mechanisms
        .iter()
        .map(|mechanism| weigh(evidence, mechanism))
        .collect();
    weighed.push((
        1.0,
        Candidate {
            kind: MechanismKind::Unlisted,
            of: None,
            share: 0.0,
            frequency: None,
            wavelengths: Some(ANY),
            reasons_for: vec![
                "It explains any wavelength and any course, none of them well.".to_owned(),
            ],
            reasons_against: Vec::new(),
        },
    ));
    let sum: f64 = weighed.iter().map(|candidate| candidate.0).sum();
    weighed.sort_by(|a, b| b.0.total_cmp(&a.0));
    weighed
        .into_iter()
        .map(|(weight, candidate)| Candidate {
            share: weight / sum,
            ..candidate
        })
        .collect()
}

/// Reasons being collected, with the product of what they weigh.
struct Scales {
    weight: f64,
    reasons_for: Vec<String>,
    reasons_against: Vec<String>,
}

impl Scales {
    /// A reason that makes the mechanism `factor` times as likely.
    fn put(&mut self, factor: f64, reason: String) {
        self.weight *= factor;
        if factor >= 1.0 {
            self.reasons_for.push(reason);
        } else {
            self.reasons_against.push(reason);
        }
    }
}

fn weigh(evidence: &Evidence, mechanism: &Mechanism) -> (f64, Candidate) {
    let mut scales = Scales {
        weight: 1.0,
        reasons_for: Vec::new(),
        reasons_against: Vec::new(),
    };
    weigh_wavelength(evidence, mechanism, &mut scales);
    weigh_course(evidence, mechanism.kind, &mut scales);
    let wavelength = evidence.peak.wavelength;
    if mechanism.kind.expectation() == Expectation::Grows {
        let left = evidence
            .filter
            .amplitude(std::f64::consts::TAU / wavelength, 0.0)
            .abs();
        if left < 0.7 {
            scales.put(
                left,
                format!(
                    "The contact patch averages over waves this short: of {} it passes {:.0} %.",
                    millimetres(wavelength),
                    100.0 * left
                ),
            );
        }
    }
    if mechanism.kind == MechanismKind::WheelCircumference
        && evidence.instrument == Instrument::Trolley
    {
        scales.put(
            0.1,
            "A trolley measures the rail alone, and wheels of many diameters do not print one pattern on it."
                .to_owned(),
        );
    }
    let candidate = Candidate {
        kind: mechanism.kind,
        of: mechanism.of.clone(),
        share: 0.0,
        frequency: mechanism.frequency(),
        wavelengths: mechanism.wavelengths(evidence.speeds),
        reasons_for: scales.reasons_for,
        reasons_against: scales.reasons_against,
    };
    (scales.weight, candidate)
}

fn weigh_wavelength(evidence: &Evidence, mechanism: &Mechanism, scales: &mut Scales) {
    let (peak, speeds) = (evidence.peak, evidence.speeds);
    let even = (ANY.1 / ANY.0).ln().recip();
    let density = mechanism.density(peak.wavelength, peak.uncertainty(), speeds);
    let covered = mechanism.covers(peak.wavelength, peak.uncertainty(), speeds);
    let factor = (1.0 - SURPRISE) * density / even + SURPRISE;
    let measured = millimetres(peak.wavelength);
    let at = speeds.words();
    let range = |range: (f64, f64)| span(1e3 * range.0, 1e3 * range.1, "mm");
    let reason = match &mechanism.prediction {
        Prediction::Frequency {
            frequency,
            spread,
            damping_ratio,
        } => {
            let predicted = (speeds.slowest() / frequency, speeds.fastest() / frequency);
            let damping = damping_ratio.map_or_else(String::new, |ratio| {
                format!("damping {:.1} %, ", 100.0 * ratio)
            });
            format!(
                "{frequency:.0} Hz ({damping}±{:.0} %) makes {} at {at}; measured {measured}, which is {}.",
                100.0 * spread,
                range(predicted),
                frequencies(peak.wavelength, speeds)
            )
        }
        Prediction::Growth(density) => match (density.rate_at(peak.wavelength), density.peak()) {
            (Some(rate), Some((highest_at, highest))) => format!(
                "At {at} the case grows fastest at {} ({highest:.1e} per passage); at {measured} {}.",
                millimetres(highest_at),
                if rate > 0.0 {
                    format!(
                        "it grows by {rate:.1e}, {:.0} % of that",
                        100.0 * rate / highest
                    )
                } else {
                    format!("it decays by {:.1e}", -rate)
                }
            ),
            (Some(_), None) => {
                format!("At {at} the case lets no wavelength grow, {measured} included.")
            }
            (None, _) => format!(
                "{measured} lies outside the wavelengths at which the case can grow: those of its map, and not below 1.5 contact \
                 lengths."
            ),
        },
        Prediction::Range { from, to } => format!(
            "Its wavelengths are {}, whatever the speed of the traffic; measured {measured}.",
            range((*from, *to))
        ),
        Prediction::Orders { length, .. } => {
            let (order, nearest) = mechanism
                .nearest_order(peak.wavelength)
                .unwrap_or((1, *length));
            format!(
                "{} over {order} is {}, {:.2} times the measured {measured}, whatever the speed of the traffic.",
                millimetres(*length),
                millimetres(nearest),
                nearest / peak.wavelength
            )
        }
    };
    // What a prediction does not cover does not speak for it, however wide it is.
    match covered {
        true => scales.put(factor, reason),
        false => scales.put(factor.min(NOT_COVERED), reason),
    }
}

fn weigh_course(evidence: &Evidence, kind: MechanismKind, scales: &mut Scales) {
    let Some(course) = evidence.course else {
        return;
    };
    let rises = course.probability_of_rise();
    let (expected, words) = match kind.expectation() {
        Expectation::Grows => (rises, "Corrugation grows under traffic"),
        Expectation::Fades => (1.0 - rises, "A mark of machining fades under traffic"),
        Expectation::Either => return,
    };
    let factor = ((1.0 - 2.0 * SURPRISE) * expected + SURPRISE) / 0.5;
    scales.put(
        factor,
        format!("{words}; this level is {}.", course.words()),
    );
}

/// A wavelength \[m\] in millimetres.
fn millimetres(wavelength: f64) -> String {
    let value = 1e3 * wavelength;
    if value < 100.0 {
        format!("{value:.1} mm")
    } else {
        format!("{value:.0} mm")
    }
}

/// Two numbers with a unit: "31–39 mm", or one where they are the same.
fn span(from: f64, to: f64, unit: &str) -> String {
    let decimals = usize::from(to < 100.0 && unit == "mm");
    let (from, to) = (format!("{from:.decimals$}"), format!("{to:.decimals$}"));
    if from == to {
        format!("{from} {unit}")
    } else {
        format!("{from}–{to} {unit}")
    }
}

/// Frequencies of a wavelength \[m\] at the speeds of the traffic: "1375–1958 Hz".
pub(super) fn frequencies(wavelength: f64, speeds: &TrafficSpeeds) -> String {
    span(
        speeds.slowest() / wavelength,
        speeds.fastest() / wavelength,
        "Hz",
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn peak(wavelength: f64) -> DominantWavelength {
        DominantWavelength {
            wavelength,
            from: wavelength / 1.04,
            to: wavelength * 1.04,
            level: 10.0,
            prominence: 12.0,
            scatter: Some(0.5),
            false_peaks: Some(1e-9),
            harmonic_of: None,
        }
    }

    fn course(levels: &[f64]) -> Course {
        crate::diagnosis::course::tests::course(levels, Some(0.5))
    }

    fn ranked(wavelength: f64, course: Option<&Course>) -> Vec<Candidate> {
        let speeds = TrafficSpeeds::new([(30.0, 1.0)]).unwrap();
        let filter = ContactFilter::new(5e-3, 5e-3).unwrap();
        let peak = peak(wavelength);
        let evidence = Evidence {
            peak: &peak,
            course,
            speeds: &speeds,
            filter: &filter,
            instrument: Instrument::Trolley,
        };
        let mechanisms = [
            Mechanism::of_frequency(MechanismKind::PinnedPinned, 1000.0),
            Mechanism::of_frequency(MechanismKind::P2, 60.0),
            Mechanism::grinding_mark(),
            Mechanism::wheel_circumference(0.46),
        ];
        rank(&evidence, &mechanisms)
    }

    #[test]
    fn shares_add_up_and_follow_the_evidence() {
        let growing = course(&[0.0, 3.0, 5.0]);
        let fading = course(&[5.0, 3.0, 0.0]);
        let at = |candidates: &[Candidate], kind| {
            candidates
                .iter()
                .find(|candidate| candidate.kind == kind)
                .unwrap()
                .share
        };
        for course in [None, Some(&growing), Some(&fading)] {
            let candidates = ranked(0.030, course);
            let sum: f64 = candidates.iter().map(|candidate| candidate.share).sum();
            assert!((sum - 1.0).abs() < 1e-12);
            assert!(
                candidates
                    .windows(2)
                    .all(|pair| pair[0].share >= pair[1].share)
            );
        }
        // 1000 Hz at 30 m/s is 30 mm; without a course the narrow prediction leads, with a growing one more so.
        assert_eq!(ranked(0.030, None)[0].kind, MechanismKind::PinnedPinned);
        assert_eq!(
            ranked(0.030, Some(&growing))[0].kind,
            MechanismKind::PinnedPinned
        );
        assert_eq!(
            ranked(0.030, Some(&fading))[0].kind,
            MechanismKind::GrindingMark
        );
        assert_eq!(ranked(0.5, None)[0].kind, MechanismKind::P2);
        // Nothing in the list makes 8 mm.
        assert_eq!(ranked(0.008, None)[0].kind, MechanismKind::Unlisted);
        let grinding = |course| at(&ranked(0.030, course), MechanismKind::GrindingMark);
        assert!(
            grinding(Some(&fading)) > grinding(None) && grinding(None) > grinding(Some(&growing))
        );
    }

    #[test]
    fn reasons_have_numbers() {
        let fading = course(&[5.0, 3.0, 0.0]);
        let candidates = ranked(0.030, Some(&fading));
        let pinned = candidates
            .iter()
            .find(|candidate| candidate.kind == MechanismKind::PinnedPinned)
            .unwrap();
        assert!(pinned.reasons_for[0].contains("1000 Hz (±5 %) makes 30.0 mm at 108 km/h"));
        assert!(pinned.reasons_against[0].contains("5.0, 3.0, 0.0 dB re 1 µm: falls every time"));
    }
}
