//! P2 of wheels and wheelsets, whatever else makes the sum of receptances least.

use std::f64::consts::TAU;

use riffel::receptance::ResonanceKind;
use riffel_case::ask;

/// P2 found and in closed form \[Hz\].
fn p2(text: &str, overrides: &[&str]) -> (f64, f64) {
    let case = crate::parsed(text, overrides).unwrap();
    let found: Vec<f64> = ask::resonances(&case)
        .iter()
        .filter(|resonance| resonance.kind == ResonanceKind::P2)
        .map(|resonance| resonance.angular_frequency / TAU)
        .collect();
    assert_eq!(found.len(), 1, "{overrides:?}");
    let closed = ask::p2_closed_form(&case).unwrap();
    (found[0], closed.angular_frequency() / TAU)
}

/// A wheelset in a curve stands on a suspension, below whose resonances its wheel is held still: the sum of receptances is
/// least there, too. P2 is the unsprung mass on the track: within a tenth of its closed form (an axle, whose bending is near 67 Hz,
/// bends some per cent of it away, and a rail that shears is some per cent softer), and hardly moved by the suspension.
#[test]
fn a_suspension_is_no_p2() {
    let curve = include_str!("../../cases/metro-curve.toml");
    let suspension = |stiffness: &str| format!("wheelset.suspension.vertical_stiffness={stiffness}");
    let mut found = Vec::new();
    for stiffness in ["0.6 MN/m", "1.2 MN/m", "2.4 MN/m"] {
        for track in ["track.pad.stiffness=30 MN/m", "track.pad.stiffness=60 MN/m"] {
            let (p2, closed) = p2(curve, &[&suspension(stiffness), track]);
            assert!((p2 / closed - 1.0).abs() < 0.1, "{stiffness} {track}: {p2} {closed}");
            found.push(p2);
        }
    }
    for track in 0..2 {
        // √(1 + k/(k_t + k_b)): 2.4 of some 60 MN/m or more is two per cent of the frequency.
        assert!((found[track] / found[4 + track] - 1.0).abs() < 0.03, "{found:?}");
    }
}

/// A lone wheel, where nothing else makes the sum least.
#[test]
fn a_lone_wheel_has_the_closed_form() {
    let (p2, closed) = p2(include_str!("../../cases/metro.toml"), &[]);
    assert!((p2 / closed - 1.0).abs() < 0.1, "{p2} {closed}");
}
