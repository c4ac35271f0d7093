//! The mechanisms that a case knows, with their frequencies.

use std::f64::consts::TAU;

use riffel::Direction;
use riffel::diagnosis::{Mechanism, MechanismKind, TrafficSpeeds};
use riffel::receptance::ResonanceKind;
use riffel_keys::{Message, say};

use crate::Case;
use crate::ask;
use crate::parts::track::Origin;
use crate::traffic::Traffic;

/// The mechanisms besides growth that fix a wavelength on this track, and sentences on those the case
/// says nothing of.
///
/// Resonances are peaks of the receptance of the rail; where damping leaves no peak, they are the
/// undamped frequencies of the layers. A receptance without a model has its peaks and dips. The pinned-pinned frequency of an evenly supported track is that of the
/// same supports at their distance.
pub fn mechanisms(case: &Case) -> (Vec<Mechanism>, Vec<Message>) {
    let (mut mechanisms, mut unknown) = match case.track.origin {
        Origin::Model => modes_of_model(case),
        Origin::Measured(_) | Origin::Given => modes_of_receptance(case),
    };
    add_pinned_pinned(case, &mut mechanisms, &mut unknown);
    mechanisms.push(Mechanism::grinding_mark());
    let spacing = case.file.track.support_spacing.map(|spacing| spacing.si());
    if let Some(spacing) = spacing.filter(|_| may_have_supports(case)) {
        mechanisms.push(Mechanism::support_spacing(spacing));
    }
    mechanisms.push(Mechanism::wheel_circumference(case.hertz.rolling_radius()));
    (mechanisms, unknown)
}

/// A support spacing in the file means supports: unless the model has none.
fn may_have_supports(case: &Case) -> bool {
    case.track.support.is_some() || !matches!(case.track.origin, Origin::Model)
}

/// Pinned-pinned modes of the rail on the supports of the case, where they are not there already.
fn add_pinned_pinned(case: &Case, mechanisms: &mut Vec<Mechanism>, unknown: &mut Vec<Message>) {
    let directions =
        [(Direction::Vertical, MechanismKind::PinnedPinned), (Direction::Lateral, MechanismKind::LateralPinnedPinned)];
    for (direction, kind) in directions {
        if mechanisms.iter().any(|known| known.kind == kind) {
            continue;
        }
        let frequency = case.keys.pinned_pinned(direction);
        match frequency.filter(|_| may_have_supports(case)) {
            Some(frequency) => mechanisms.push(Mechanism::of_frequency(kind, frequency)),
            None => unknown.push(match direction {
                Direction::Lateral => say!(lateral_pinned_pinned_is_no_candidate),
                _ => say!(vertical_pinned_pinned_is_no_candidate),
            }),
        }
    }
}

/// Peaks and dips of a receptance without a model, and P2.
fn modes_of_receptance(case: &Case) -> (Vec<Mechanism>, Vec<Message>) {
    let mut unknown = Vec::new();
    let resonances = ask::resonances(case);
    let word = match case.track.origin {
        Origin::Given => say!(given_word),
        _ => say!(measured_word),
    };
    if !resonances.iter().any(|found| found.kind == ResonanceKind::P2) {
        let reason = say!(no_least_sum_of_receptances, origin = word.clone());
        unknown.push(say!(p2_is_no_candidate, reason));
    }
    if resonances.iter().all(|found| found.kind == ResonanceKind::P2) {
        unknown.push(say!(no_modes_of_receptance, origin = word));
    }
    let mechanisms = resonances.iter().filter_map(|found| {
        let frequency = found.angular_frequency / TAU;
        let kind = match found.kind {
            ResonanceKind::P2 => {
                return Some(Mechanism::of_frequency(MechanismKind::P2, frequency));
            }
            ResonanceKind::PinnedPinned => MechanismKind::PinnedPinned,
            ResonanceKind::MeasuredPeak => MechanismKind::MeasuredPeak,
            ResonanceKind::MeasuredDip => MechanismKind::MeasuredDip,
            ResonanceKind::FunctionPeak => MechanismKind::FunctionPeak,
            ResonanceKind::FunctionDip => MechanismKind::FunctionDip,
            ResonanceKind::FullTrack
            | ResonanceKind::RailOnPad
            | ResonanceKind::LateralCutOn
            | ResonanceKind::RollCutOn
            | ResonanceKind::LateralPinnedPinned => return None,
        };
        let resolution = found.resolution.map(|resolution| resolution / TAU);
        Some(Mechanism::of_receptance(kind, frequency, found.damping_ratio, resolution))
    });
    (mechanisms.collect(), unknown)
}

/// Modes of the layers of a model, and P2.
fn modes_of_model(case: &Case) -> (Vec<Mechanism>, Vec<Message>) {
    let mut mechanisms = Vec::new();
    let mut unknown = Vec::new();
    let mut add = |kind, frequency: f64| {
        mechanisms.push(Mechanism::of_frequency(kind, frequency));
    };
    match ask::p2(case) {
        Some(p2) => add(MechanismKind::P2, p2.angular_frequency / TAU),
        None => {
            let reason = match case.track.support {
                None => say!(rail_has_no_support),
                Some(_) => say!(no_resonance_of_unsprung_mass),
            };
            unknown.push(say!(p2_is_no_candidate, reason));
        }
    }
    if let (Some(support), Some(rail_mass)) = (case.track.support, case.track.rail_mass) {
        let found = case.track.resonances();
        let kinds = [
            (ResonanceKind::FullTrack, MechanismKind::FullTrack),
            (ResonanceKind::RailOnPad, MechanismKind::RailOnPad),
        ];
        // One layer has the rail on its pads only.
        let cut_on = support.cut_on_frequencies(rail_mass);
        for ((resonance, kind), undamped) in kinds.iter().rev().zip(cut_on.iter().rev()) {
            let peak = found.iter().find(|peak| peak.kind == *resonance);
            add(*kind, peak.map_or(*undamped, |peak| peak.angular_frequency) / TAU);
        }
        if let Some(sleeper) = support.sleeper_antiresonance() {
            add(MechanismKind::SleeperAntiresonance, sleeper / TAU);
        }
    } else {
        unknown.push(say!(track_has_no_layers));
    }
    (mechanisms, unknown)
}

impl Traffic {
    /// The speeds of all vehicles, each with its share of the passages; a normal distribution as 21 speeds up to
    /// two and a half standard deviations from its mean.
    ///
    /// # Errors
    /// [`riffel::Error::OutOfRange`] where no vehicle says its speed.
    pub fn passing_speeds(&self) -> Result<TrafficSpeeds, riffel::Error> {
        let mut shares = Vec::new();
        for vehicle in &self.file.vehicle {
            let share = vehicle.share.si();
            if let Some(speed) = &vehicle.speed {
                let deviation = speed.standard_deviation.map_or(0.0, |speed| speed.si());
                let steps = (-10..=10).map(|step| 0.25 * f64::from(step));
                let weights: Vec<(f64, f64)> = steps.map(|z| (z, (-0.5 * z * z).exp())).collect();
                let sum: f64 = weights.iter().map(|weight| weight.1).sum();
                shares
                    .extend(weights.iter().map(|(z, weight)| (speed.mean.si() + z * deviation, share * weight / sum)));
            }
            let speeds = vehicle.speeds.iter().flatten();
            shares.extend(speeds.map(|speed| (speed.speed.si(), share * speed.share.si())));
        }
        TrafficSpeeds::new(shares)
    }
}
