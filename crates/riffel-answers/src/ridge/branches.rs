//! The branches of the ridge of a case: as a document, and in words.

use riffel_case::{Case, ask, traffic};
use std::collections::BTreeSet;

use riffel::diagnosis::MechanismKind;
use riffel::growth::RidgeBranch;
use riffel::wheelset::ModeName;
use riffel::{Axis, Loop, Ridge};
use riffel_keys::{Message, Value, fixed, number, range, say, shown_speeds};
use serde::Serialize;

/// A branch is named by a resonance of the case within this share of its frequency.
///
/// Growth is highest where phases have turned, some per cent beside the resonance that turns them; the resonances of one
/// track lie farther apart than this. The share is a choice: a branch beyond it has no name rather than a wrong one.
pub(crate) const NEAR: f64 = 0.10;
/// Share of the frequency for natural modes of the wheelset, which have little damping and lie closer together.
const NEAR_MODE: f64 = 0.05;
/// Branches whose frequencies are nearer to one another by ratio are pieces of one line: a map of coarse speeds parts it, and so
/// do lines that cross it.
const ONE: f64 = 1.02;
/// Branches named in a sentence after the strongest.
const NAMED: usize = 3;

/// Frequency \[Hz\] of the strongest branch; `None` if nothing grows, or where the window holds no crest of it but a
/// flank alone, whose frequency is that of the edge.
pub fn best_fit_frequency(ridge: &Ridge) -> Option<f64> {
    let strongest = ridge.branches.first()?;
    (!strongest.only_at_edge()).then(|| strongest.frequency())
}

/// The ridge of a loop of the case over the wavelengths of which growth is told; an empty one if the contact averages all out.
pub fn ridge_of(case: &Case, feedback: &Loop) -> Ridge {
    ridge_in(case, feedback, [case.wavelength, case.speed])
}

/// Ridge in a window of wavelengths and speeds.
pub fn ridge_in(case: &Case, feedback: &Loop, [wavelength, speed]: [Axis; 2]) -> Ridge {
    let told = ask::told_of(case, wavelength);
    told.map_or_else(Ridge::nothing, |told| Ridge::search(feedback, told, speed))
}

/// A branch of the ridge, as documents hold it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BranchDocument {
    /// Frequency of the ray that fits it best.
    pub frequency_hz: f64,
    /// Lowest and highest speed at which its crest lies in the window.
    pub speed_m_per_s: [f64; 2],
    /// Shortest and longest wavelength there.
    pub wavelength_m: [f64; 2],
    /// Its highest growth rate.
    pub highest_growth_rate_per_passage: f64,
    /// Only its flank lies in the window: its frequency is that of the edge.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub only_at_edge: bool,
    /// The resonance of the case that it follows, where one lies within 10 % of its frequency, or a natural mode of its
    /// wheelset within 5 %.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mechanism: Option<&'static str>,
    #[serde(skip)]
    kind: Option<MechanismKind>,
    /// The places of its pieces among the branches of the ridge.
    #[serde(skip)]
    pub pieces: Vec<usize>,
}

impl BranchDocument {
    /// The branches of a ridge of the case, in their order: the strongest first.
    pub fn all(case: &Case, ridge: &Ridge) -> Vec<Self> {
        let resonances = if ridge.branches.is_empty() { Vec::new() } else { resonances(case) };
        let mut documents: Vec<Self> = Vec::new();
        for (piece, branch) in ridge.branches.iter().enumerate() {
            let document = Self { pieces: vec![piece], ..Self::new(branch, &resonances) };
            match documents.iter_mut().find(|stronger| stronger.is_one_with(&document)) {
                Some(stronger) => stronger.take_in(&document),
                None => documents.push(document),
            }
        }
        documents
    }

    /// Whether both are pieces of one line: within 2 % in frequency, each seen at its crest.
    fn is_one_with(&self, other: &Self) -> bool {
        let apart = (other.frequency_hz / self.frequency_hz).ln().abs();
        apart < ONE.ln() && !self.only_at_edge && !other.only_at_edge
    }

    /// A weaker piece of the same line.
    fn take_in(&mut self, other: &Self) {
        let both = |[from, to]: [f64; 2], other: [f64; 2]| [from.min(other[0]), to.max(other[1])];
        self.pieces.extend(&other.pieces);
        self.speed_m_per_s = both(self.speed_m_per_s, other.speed_m_per_s);
        self.wavelength_m = both(self.wavelength_m, other.wavelength_m);
    }

    fn new(branch: &RidgeBranch, resonances: &[(MechanismKind, f64)]) -> Self {
        let frequency_hz = branch.frequency();
        let only_at_edge = branch.only_at_edge();
        let kind = nearest(resonances, frequency_hz).filter(|_| !only_at_edge);
        let kind = kind.map(|(kind, _)| kind);
        Self {
            frequency_hz,
            speed_m_per_s: branch.speeds().into(),
            wavelength_m: branch.wavelengths().into(),
            highest_growth_rate_per_passage: branch.highest().growth_rate,
            only_at_edge,
            mechanism: kind.map(MechanismKind::name),
            kind,
            pieces: Vec::new(),
        }
    }

    /// Frequency, mechanism if known, speeds and wavelengths, as in "225 Hz (20–87 km/h, 25–109 mm)".
    fn in_words(&self) -> Message {
        let wavelengths = range(self.wavelength_m, |it| format!("{:.0}", 1e3 * it));
        let or_nothing = |message: Option<Message>| message.map_or("".into(), Value::from);
        let mechanism = self.kind.map(|kind| say!(before_comma, words = mechanism_name(kind)));
        let edge = self.only_at_edge.then(|| say!(at_edge_of_window));
        say!(
            branch,
            frequency = fixed(self.frequency_hz, 0),
            mechanism = or_nothing(mechanism),
            speeds = shown_speeds(self.speed_m_per_s),
            wavelengths,
            edge = or_nothing(edge)
        )
    }

    /// The branches of a ridge in one sentence, the strongest first.
    pub fn sentence(branches: &[Self]) -> Message {
        let Some((strongest, weaker)) = branches.split_first() else {
            return say!(nothing_grows);
        };
        if branches.iter().all(|branch| branch.only_at_edge) {
            let ends: BTreeSet<String> = branches
                .iter()
                .flat_map(|branch| branch.wavelength_m)
                .map(|wavelength| format!("{:.0}", 1e3 * wavelength))
                .collect();
            let ends = ends.into_iter().map(Value::from);
            let ends = ends.reduce(|one, other| say!(both, one, other).into());
            return say!(no_crest, ends = ends.unwrap_or("".into()));
        }
        let words = strongest.in_words();
        if weaker.is_empty() {
            return say!(one_branch, words);
        }
        let highest = strongest.highest_growth_rate_per_passage;
        let named = weaker.iter().take(NAMED).map(|branch| {
            let share = share(branch.highest_growth_rate_per_passage / highest);
            say!(branch_with_share, words = branch.in_words(), share)
        });
        let more = weaker.len().checked_sub(NAMED + 1);
        let more = more.map(|more| say!(more_branches, count = more + 1));
        let named = named.chain(more);
        let named = named.reduce(Message::followed_by);
        say!(
            strongest_branch,
            words,
            noun = say!(weaker_branches, count = weaker.len()),
            named = named.map_or("".into(), Value::from)
        )
    }
}

/// A ratio in per cent, with one significant digit below one.
fn share(ratio: f64) -> Value {
    let percent = 100.0 * ratio;
    match percent {
        percent if percent >= 0.95 => number(format_args!("{percent:.0} %")),
        _ => number(format_args!("{percent:.1} %")),
    }
}

/// The resonance that a frequency \[Hz\] is named by; `None` if none is near.
pub(crate) fn nearest(resonances: &[(MechanismKind, f64)], frequency: f64) -> Option<(MechanismKind, f64)> {
    let distance = |resonance: &(MechanismKind, f64)| (resonance.1 / frequency - 1.0).abs();
    let named = resonances.iter().copied();
    named
        .filter(|resonance| distance(resonance) <= near(resonance.0))
        .min_by(|a, b| distance(a).total_cmp(&distance(b)))
}

/// How near a branch must be to a resonance that it is named by, as a share of its frequency.
fn near(kind: MechanismKind) -> f64 {
    match kind {
        MechanismKind::WheelsetTorsion | MechanismKind::WheelsetBending => NEAR_MODE,
        _ => NEAR,
    }
}

/// The frequencies of the case that its loop can follow \[Hz\]: those of the track vertically, and those at which its
/// wheelset twists or bends.
pub(crate) fn resonances(case: &Case) -> Vec<(MechanismKind, f64)> {
    let vertical = |kind: MechanismKind| kind != MechanismKind::LateralPinnedPinned;
    let (mechanisms, _) = traffic::mechanisms(case);
    let of_track = mechanisms
        .iter()
        .filter(|mechanism| vertical(mechanism.kind))
        .filter_map(|mechanism| Some((mechanism.kind, mechanism.frequency()?)));
    let highest = case.speed.max() / case.wavelength.min();
    of_track.chain(modes_of_axle(case, highest)).collect()
}

/// Natural frequencies up to one \[Hz\] at which the axle of a wheelset twists or bends; empty if modes cannot be told apart so high.
pub(crate) fn modes_of_axle(case: &Case, highest: f64) -> Vec<(MechanismKind, f64)> {
    let modes = case.wheelset.as_deref().and_then(|wheelset| ask::wheelset_modes(case, wheelset, highest).ok());
    let named = modes.iter().flatten().filter_map(|mode| {
        let kind = match mode.name {
            ModeName::Torsion { .. } => MechanismKind::WheelsetTorsion,
            ModeName::Bending { .. } => MechanismKind::WheelsetBending,
            _ => return None,
        };
        Some((kind, mode.frequency))
    });
    named.collect()
}

/// The name of a mechanism.
pub(crate) fn mechanism_name(kind: MechanismKind) -> Message {
    match kind {
        MechanismKind::P2 => say!(mechanism_p2),
        MechanismKind::WheelsetTorsion => say!(mechanism_wheelset_torsion),
        MechanismKind::WheelsetBending => say!(mechanism_wheelset_bending),
        MechanismKind::FullTrack => say!(mechanism_full_track),
        MechanismKind::SleeperAntiresonance => say!(mechanism_sleeper_antiresonance),
        MechanismKind::RailOnPad => say!(mechanism_rail_on_pad),
        MechanismKind::PinnedPinned => say!(mechanism_pinned_pinned),
        MechanismKind::MeasuredPeak => say!(mechanism_measured_peak),
        MechanismKind::MeasuredDip => say!(mechanism_measured_dip),
        MechanismKind::FunctionPeak => say!(mechanism_given_peak),
        MechanismKind::FunctionDip => say!(mechanism_given_dip),
        MechanismKind::GrowthRidge => say!(mechanism_growth_ridge),
        MechanismKind::LateralPinnedPinned => say!(mechanism_lateral_pinned_pinned),
        MechanismKind::GrindingMark => say!(mechanism_grinding_mark),
        MechanismKind::SupportSpacing => say!(mechanism_support_spacing),
        MechanismKind::WheelCircumference => say!(mechanism_wheel_circumference),
        MechanismKind::Unlisted => say!(mechanism_unlisted),
    }
}

#[cfg(test)]
mod tests {
    use riffel_keys::Language;

    use super::*;

    /// The catalogue names mechanisms in English as the diagnosis does.
    #[test]
    fn mechanisms_have_one_english_name() {
        for kind in [
            MechanismKind::P2,
            MechanismKind::WheelsetTorsion,
            MechanismKind::WheelsetBending,
            MechanismKind::FullTrack,
            MechanismKind::SleeperAntiresonance,
            MechanismKind::RailOnPad,
            MechanismKind::PinnedPinned,
            MechanismKind::MeasuredPeak,
            MechanismKind::MeasuredDip,
            MechanismKind::FunctionPeak,
            MechanismKind::FunctionDip,
        ] {
            assert_eq!(mechanism_name(kind).text(Language::English), kind.name());
            assert_ne!(mechanism_name(kind).text(Language::German), kind.name());
        }
    }
}
