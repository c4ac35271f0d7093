//! Candidates for a dominant wavelength, in the order of what speaks for them.

use super::{DominantWavelength, Expectation, LevelTrend, Mechanism, MechanismKind, Prediction, TrafficSpeeds};
use crate::contact::ContactFilter;
use crate::roughness::mean_square;

/// Wavelengths over which a mechanism that is not listed spreads \[m\].
const ANY: (f64, f64) = (0.005, 2.0);
/// What a wavelength that the prediction does not cover weighs at most: a little less than nothing.
const NOT_COVERED: f64 = 0.99;
/// Share of surprises: a mechanism at work may still stand anywhere, and a level move the other way.
const SURPRISE: f64 = 0.05;

/// RMS that accepted grinding leaves at most \[m\], to longest wavelengths \[m\]; Grassie, Saxon & Smith (1999), abstract.
const ACCEPTED: [(f64, f64); 2] = [(0.03, 3e-6), (0.1, 7e-6)];
/// A wave of so many times as much is no mark of accepted grinding. Riffel's choice.
const NEVER_ACCEPTED: f64 = 2.0;

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
    pub course: Option<&'a LevelTrend>,
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
    /// What speaks for it.
    pub reasons_for: Vec<Reason>,
    /// What speaks against it.
    pub reasons_against: Vec<Reason>,
}

/// What speaks for a mechanism or against it; lengths in metres, frequencies in hertz.
#[derive(Debug, Clone, PartialEq)]
pub enum Reason {
    /// What is not listed explains any wavelength and any course, none of them well.
    Unlisted,
    /// The contact patch averages over a wave of this length, of which it passes a part.
    AverageOverPatch {
        /// The wave.
        wavelength: f64,
        /// What is left of it \[-\].
        passes: f64,
    },
    /// A trolley measures the rail alone.
    WithoutWheels,
    /// No accepted grinding leaves so high a wave.
    HigherThanGround {
        /// RMS of the wave \[m\].
        rms: f64,
        /// The most that is accepted \[m\].
        accepted: f64,
    },
    /// A frequency makes wavelengths at the speeds of the traffic.
    Frequency {
        /// The frequency.
        frequency: f64,
        /// How well it is known, as a part of it.
        spread: f64,
        /// Of the resonance, where it is known.
        damping_ratio: Option<f64>,
        /// Shortest and longest that it makes.
        wavelengths: (f64, f64),
        /// What was measured.
        measured: f64,
    },
    /// The case grows fastest at one wavelength.
    Growth {
        /// Where, and its rate per passage.
        highest: (f64, f64),
        /// What was measured.
        measured: f64,
        /// Rate per passage there.
        rate: f64,
    },
    /// The case lets no wavelength grow.
    NothingGrows {
        /// What was measured.
        measured: f64,
    },
    /// What was measured is none of the wavelengths at which the case can grow.
    OutsideGrowth {
        /// What was measured.
        measured: f64,
    },
    /// Wavelengths from one to another, whatever the speed.
    Range {
        /// The wavelengths.
        wavelengths: (f64, f64),
        /// What was measured.
        measured: f64,
    },
    /// An order of a length, whatever the speed.
    Order {
        /// The length.
        length: f64,
        /// Which order.
        order: u32,
        /// The length over it.
        nearest: f64,
        /// What was measured.
        measured: f64,
    },
    /// What the level did from record to record, beside what the mechanism lets expect.
    LevelTrend(Expectation),
}

impl Candidate {
    /// Name of the candidate, "growth ridge, wheelset 1, low rail".
    pub fn name(&self) -> String {
        let of = self.of.as_ref();
        let of = of.map_or_else(String::new, |of| format!(", {of}"));
        format!("{}{of}", self.kind.name())
    }
}

/// The mechanisms and one that is not among them, the likeliest first.
pub fn rank(evidence: &Evidence, mechanisms: &[Mechanism]) -> Vec<Candidate> {
    let mut weighed: Vec<(f64, Candidate)> = mechanisms.iter().map(|mechanism| weigh(evidence, mechanism)).collect();
    weighed.push((
        1.0,
        Candidate {
            kind: MechanismKind::Unlisted,
            of: None,
            share: 0.0,
            frequency: None,
            wavelengths: Some(ANY),
            reasons_for: vec![Reason::Unlisted],
            reasons_against: Vec::new(),
        },
    ));
    let sum: f64 = weighed.iter().map(|candidate| candidate.0).sum();
    weighed.sort_by(|a, b| b.0.total_cmp(&a.0));
    weighed.into_iter().map(|(weight, candidate)| Candidate { share: weight / sum, ..candidate }).collect()
}

/// Reasons being collected, with the product of what they weigh.
struct Scales {
    weight: f64,
    reasons_for: Vec<Reason>,
    reasons_against: Vec<Reason>,
}

impl Scales {
    /// A reason that makes the mechanism `factor` times as likely.
    fn put(&mut self, factor: f64, reason: Reason) {
        self.weight *= factor;
        if factor >= 1.0 {
            self.reasons_for.push(reason);
        } else {
            self.reasons_against.push(reason);
        }
    }
}

fn weigh(evidence: &Evidence, mechanism: &Mechanism) -> (f64, Candidate) {
    let mut scales = Scales { weight: 1.0, reasons_for: Vec::new(), reasons_against: Vec::new() };
    weigh_wavelength(evidence, mechanism, &mut scales);
    weigh_course(evidence, mechanism.kind, &mut scales);
    let wavelength = evidence.peak.wavelength;
    if mechanism.kind.expectation() == Expectation::Grows {
        let left = evidence.filter.amplitude(std::f64::consts::TAU / wavelength, 0.0).abs();
        if left < 0.7 {
            scales.put(left, Reason::AverageOverPatch { wavelength, passes: left });
        }
    }
    if mechanism.kind == MechanismKind::WheelCircumference && evidence.instrument == Instrument::Trolley {
        scales.put(0.1, Reason::WithoutWheels);
    }
    if mechanism.kind == MechanismKind::GrindingMark {
        let rms = mean_square(evidence.peak.level).sqrt();
        let accepted = ACCEPTED.iter().find(|(longest, _)| wavelength <= *longest);
        if let Some(&(_, accepted)) = accepted.filter(|(_, accepted)| rms > NEVER_ACCEPTED * accepted) {
            scales.put(0.1, Reason::HigherThanGround { rms, accepted });
        }
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
    let measured = peak.wavelength;
    let reason = match &mechanism.prediction {
        Prediction::Frequency { frequency, spread, damping_ratio } => Reason::Frequency {
            frequency: *frequency,
            spread: *spread,
            damping_ratio: *damping_ratio,
            wavelengths: (speeds.slowest() / frequency, speeds.fastest() / frequency),
            measured,
        },
        Prediction::Growth(density) => match (density.rate_at(measured), density.peak()) {
            (Some(rate), Some(highest)) => Reason::Growth { highest, measured, rate },
            (Some(_), None) => Reason::NothingGrows { measured },
            (None, _) => Reason::OutsideGrowth { measured },
        },
        Prediction::Range { from, to } => Reason::Range { wavelengths: (*from, *to), measured },
        Prediction::Orders { length, .. } => {
            let nearest = mechanism.nearest_order(measured);
            let (order, nearest) = nearest.unwrap_or((1, *length));
            Reason::Order { length: *length, order, nearest, measured }
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
    let Some(rises) = course.probability_of_rise() else {
        return;
    };
    let expectation = kind.expectation();
    let expected = match expectation {
        Expectation::Grows => rises,
        Expectation::Fades => 1.0 - rises,
        Expectation::Either => return,
    };
    let factor = ((1.0 - 2.0 * SURPRISE) * expected + SURPRISE) / 0.5;
    scales.put(factor, Reason::LevelTrend(expectation));
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

    fn course(levels: &[f64]) -> LevelTrend {
        crate::diagnosis::level_trend::tests::course(levels, Some(0.5))
    }

    fn ranked(wavelength: f64, course: Option<&LevelTrend>) -> Vec<Candidate> {
        let speeds = TrafficSpeeds::new([(30.0, 1.0)]).unwrap();
        let filter = ContactFilter::new(5e-3, 5e-3).unwrap();
        let peak = peak(wavelength);
        let evidence =
            Evidence { peak: &peak, course, speeds: &speeds, filter: &filter, instrument: Instrument::Trolley };
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
        let at =
            |candidates: &[Candidate], kind| candidates.iter().find(|candidate| candidate.kind == kind).unwrap().share;
        for course in [None, Some(&growing), Some(&fading)] {
            let candidates = ranked(0.030, course);
            let sum: f64 = candidates.iter().map(|candidate| candidate.share).sum();
            assert!((sum - 1.0).abs() < 1e-12);
            assert!(candidates.windows(2).all(|pair| pair[0].share >= pair[1].share));
        }
        // 1000 Hz at 30 m/s is 30 mm; without a course the narrow prediction leads, with a growing one more so.
        assert_eq!(ranked(0.030, None)[0].kind, MechanismKind::PinnedPinned);
        assert_eq!(ranked(0.030, Some(&growing))[0].kind, MechanismKind::PinnedPinned);
        assert_eq!(ranked(0.030, Some(&fading))[0].kind, MechanismKind::GrindingMark);
        assert_eq!(ranked(0.5, None)[0].kind, MechanismKind::P2);
        // Nothing in the list makes 8 mm.
        assert_eq!(ranked(0.008, None)[0].kind, MechanismKind::Unlisted);
        let grinding = |course| at(&ranked(0.030, course), MechanismKind::GrindingMark);
        assert!(grinding(Some(&fading)) > grinding(None) && grinding(None) > grinding(Some(&growing)));
    }

    /// A wave at 5 µm RMS and at 50 µm: no accepted grinding leaves ten times as much.
    #[test]
    fn a_high_wave_is_no_mark_of_grinding() {
        let speeds = TrafficSpeeds::new([(30.0, 1.0)]).unwrap();
        let filter = ContactFilter::new(5e-3, 5e-3).unwrap();
        let share = |rms_um: f64| {
            let peak = DominantWavelength { level: 20.0 * rms_um.log10(), ..peak(0.06) };
            let evidence = Evidence {
                peak: &peak,
                course: None,
                speeds: &speeds,
                filter: &filter,
                instrument: Instrument::Trolley,
            };
            let ranked = rank(&evidence, &[Mechanism::grinding_mark()]);
            let mark = ranked.into_iter().find(|it| it.kind == MechanismKind::GrindingMark);
            let mark = mark.unwrap();
            (mark.share, mark.reasons_against)
        };
        let ((low, none), (high, against)) = (share(5.0), share(50.0));
        assert!(low > 0.5 && high < 0.5 && none.is_empty(), "{low} {high}");
        let odds = |share: f64| share / (1.0 - share);
        assert!((odds(low) / odds(high) - 10.0).abs() < 1e-9);
        let [Reason::HigherThanGround { rms, accepted }] = against[..] else {
            panic!("{against:?}");
        };
        assert!((rms - 50e-6).abs() < 1e-12 && accepted == 7e-6);
    }

    #[test]
    fn reasons_have_numbers() {
        let fading = course(&[5.0, 3.0, 0.0]);
        let candidates = ranked(0.030, Some(&fading));
        let pinned = candidates.iter().find(|candidate| candidate.kind == MechanismKind::PinnedPinned).unwrap();
        let expected = Reason::Frequency {
            frequency: 1000.0,
            spread: 0.05,
            damping_ratio: None,
            wavelengths: (0.030, 0.030),
            measured: 0.030,
        };
        assert_eq!(pinned.reasons_for, [expected]);
        assert_eq!(pinned.reasons_against, [Reason::LevelTrend(Expectation::Grows)]);
    }
}
