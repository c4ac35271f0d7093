//! What the fastest wavelength follows.

use riffel_answers::{Cause, LineGrowth};
use riffel_case::Case;

const BOOTED: &str = include_str!("../../../../cases/class-booted-sleeper.toml");
const SOFT_SLAB: &str = include_str!("../../../../cases/class-soft-slab.toml");
const RUTTING: &str = include_str!("../../../../cases/class-rutting.toml");

fn cause(text: &str, overrides: &[&str]) -> Cause {
    let window = ["map.wavelength.points=21", "map.speed.points=5"];
    let overrides = window.iter().chain(overrides).map(|&it| it.to_owned());
    let case = Case::parse("case", text, &overrides.collect::<Vec<_>>()).unwrap();
    LineGrowth::new(&case, None).unwrap().cause.unwrap()
}

fn in_words(reasons: &[riffel_keys::Message]) -> String {
    let words: Vec<String> = reasons.iter().map(ToString::to_string).collect();
    words.join("\n")
}

/// A block between pad and boot holds the rail still at √((k_p + k_b)/m_s)/2π: with another mass the frequency and the cause move.
#[test]
fn a_booted_sleeper_is_followed_wherever_it_resonates() {
    for (mass, hertz) in [("115 kg", 193.8), ("100 kg", 207.9)] {
        let found = cause(BOOTED, &[&format!("track.sleeper.mass={mass}")]);
        let resonance = found.resonance_hz.unwrap();
        assert_eq!(found.mechanism, "sleeper antiresonance", "{mass}");
        assert!((resonance / hertz - 1.0).abs() < 0.01, "{mass}: {resonance}");
        assert!((found.frequency_hz / resonance - 1.0).abs() <= 0.10);
        assert!((found.speed_m_per_s / found.wavelength_m / found.frequency_hz - 1.0).abs() < 1e-12);
        let reasons = in_words(&found.evidence_for);
        assert!(reasons.contains("(sleeper antiresonance)") && reasons.contains("a frequency is fixed"), "{reasons}");
        assert!(found.measurement.to_string().starts_with("Sleeper antiresonance: impact hammer on sleeper"));
    }
}

/// The gear and the wheels of a motored axle turn against each other at 62 Hz; on soft fastenings no resonance is near.
#[test]
fn torsion_is_named_and_no_resonance_is_none() {
    let rutting = cause(RUTTING, &[]);
    assert_eq!(rutting.mechanism, "wheelset torsion");
    assert!((rutting.resonance_hz.unwrap() / 62.0 - 1.0).abs() < 0.02);
    let slab = cause(SOFT_SLAB, &[]);
    assert_eq!((slab.mechanism, slab.resonance_hz), ("growth ridge", None));
    let words = in_words(&slab.evidence_for);
    assert!(words.contains("no resonance of track or wheelset lies within 10 %"), "{words}");
    // That it keeps one frequency speaks against there being none.
    let against = in_words(&slab.evidence_against);
    assert!(against.contains("a frequency is fixed, not a length"), "{against}");
}
