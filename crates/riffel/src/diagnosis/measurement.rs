//! Which measurement would tell candidates apart.

use super::candidate::frequencies;
use super::{Candidate, Course, DominantWavelength, MechanismKind, TimeUnit, TrafficSpeeds};

/// Share of the belief below which a candidate is not worth a measurement.
const WORTH: f64 = 0.05;

/// Measurements that would decide between the likeliest candidates, the most telling first.
pub fn tell_apart(
    peak: &DominantWavelength,
    candidates: &[Candidate],
    course: Option<&Course>,
    speeds: &TrafficSpeeds,
) -> Vec<String> {
    let worth: Vec<&Candidate> = candidates
        .iter()
        .enumerate()
        .filter(|(place, candidate)| *place < 2 || candidate.share >= WORTH)
        .map(|(_, candidate)| candidate)
        .collect();
    let mut measurements = Vec::new();
    let wavelength = 1e3 * peak.wavelength;
    let fixed = worth.iter().any(|candidate| candidate.frequency.is_none());
    // What is not listed may be either.
    let moves = worth.iter().any(|candidate| {
        candidate.frequency.is_some() || candidate.kind == MechanismKind::Unlisted
    });
    if fixed && moves {
        measurements.push(format!(
            "Speed: measure where the same trains run a fifth slower. A constant frequency ({}) would stand at \
             {:.1} mm there, a mark or an order of length at {wavelength:.1} mm as here.",
            frequencies(peak.wavelength, speeds),
            0.8 * wavelength
        ));
    }
    let when = match course.map(|course| (course.unit, course.until_visible())) {
        Some((TimeUnit::Year, Some(years))) => {
            format!(
                "in {:.0} weeks the present course moves the level by three times its scatter",
                (52.0 * years).ceil()
            )
        }
        Some((TimeUnit::Record, Some(records))) => format!(
            "{:.1} of the intervals between these records move the level by three times its scatter",
            records
        ),
        _ => "after three months, and again after six, at the same chainage".to_owned(),
    };
    let kinds = |kind: MechanismKind| worth.iter().any(|candidate| candidate.kind == kind);
    if kinds(MechanismKind::GrindingMark) || course.is_none() {
        measurements.push(format!(
            "Time: repeat this record ({when}). Corrugation rises, a grinding mark falls."
        ));
    }
    measurements.extend(worth.iter().map(|candidate| candidate.kind.settled_by()));
    measurements
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn speed_tells_a_frequency_from_a_length() {
        let peak = DominantWavelength {
            wavelength: 0.05,
            from: 0.048,
            to: 0.052,
            level: 0.0,
            prominence: 6.0,
            scatter: None,
            false_peaks: None,
            harmonic_of: None,
        };
        let candidate = |kind, frequency| Candidate {
            of: None,
            kind,
            share: 0.5,
            frequency,
            wavelengths: None,
            reasons_for: Vec::new(),
            reasons_against: Vec::new(),
        };
        let speeds = TrafficSpeeds::new([(25.0, 1.0)]).unwrap();
        let told = |first, second| tell_apart(&peak, &[first, second], None, &speeds).join("\n");
        let pads = || candidate(MechanismKind::RailOnPad, Some(500.0));
        let mark = told(candidate(MechanismKind::GrindingMark, None), pads());
        // 25/0.05 Hz; four fifths of 50 mm.
        assert!(mark.contains("(500 Hz) would stand at 40.0 mm"), "{mark}");
        assert!(
            mark.contains("at 50.0 mm as here") && mark.contains("Rail on pad: track decay rate")
        );
        let modes = told(candidate(MechanismKind::P2, Some(60.0)), pads());
        assert!(
            !modes.contains("Speed:") && modes.contains("P2 resonance: vertical axle-box"),
            "{modes}"
        );
    }
}
