//! Which measurement would tell candidates apart.

use super::{Candidate, LevelTrend, MechanismKind, TimeUnit};

/// Share of the belief below which a candidate is not worth a measurement.
const WORTH: f64 = 0.05;

/// What may be measured to tell candidates apart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Measurement {
    /// Measurement of the rail where trains run slower: a constant frequency moves there, a length stays.
    OtherSpeed,
    /// Measurement of the rail again: after so much time the present course moves the level by three times its scatter, where that is known.
    Again(Option<(TimeUnit, f64)>),
    /// That which settles a mechanism.
    Of(MechanismKind),
}

/// Measurements that would decide between the likeliest candidates, the most telling first.
pub fn tell_apart(candidates: &[Candidate], course: Option<&LevelTrend>) -> Vec<Measurement> {
    let worth: Vec<&Candidate> = candidates
        .iter()
        .enumerate()
        .filter(|(place, candidate)| *place < 2 || candidate.share >= WORTH)
        .map(|(_, candidate)| candidate)
        .collect();
    let mut measurements = Vec::new();
    let fixed = worth.iter().any(|candidate| candidate.frequency.is_none());
    // What is not listed may be either.
    let moves =
        worth.iter().any(|candidate| candidate.frequency.is_some() || candidate.kind == MechanismKind::Unlisted);
    if fixed && moves {
        measurements.push(Measurement::OtherSpeed);
    }
    let kinds = |kind: MechanismKind| worth.iter().any(|candidate| candidate.kind == kind);
    if kinds(MechanismKind::GrindingMark) || course.is_none() {
        let visible = course.and_then(|course| Some((course.unit, course.until_visible()?)));
        measurements.push(Measurement::Again(visible));
    }
    measurements.extend(worth.iter().map(|candidate| Measurement::Of(candidate.kind)));
    measurements
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn speed_tells_a_frequency_from_a_length() {
        let candidate = |kind, frequency| Candidate {
            of: None,
            kind,
            share: 0.5,
            frequency,
            wavelengths: None,
            reasons_for: Vec::new(),
            reasons_against: Vec::new(),
        };
        let told = |first, second| tell_apart(&[first, second], None);
        let pads = || candidate(MechanismKind::RailOnPad, Some(500.0));
        let mark = told(candidate(MechanismKind::GrindingMark, None), pads());
        let expected = [
            Measurement::OtherSpeed,
            Measurement::Again(None),
            Measurement::Of(MechanismKind::GrindingMark),
            Measurement::Of(MechanismKind::RailOnPad),
        ];
        assert_eq!(mark, expected);
        let modes = told(candidate(MechanismKind::P2, Some(60.0)), pads());
        assert!(!modes.contains(&Measurement::OtherSpeed), "{modes:?}");
        assert!(modes.contains(&Measurement::Of(MechanismKind::P2)));
    }
}
