//! What stands out of a receptance without a model, against the model it was made from.

use riffel_case::{Case, ask, traffic};
use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use riffel::diagnosis::{MechanismKind, Prediction};
use riffel::receptance::ResonanceKind;
use tempfile::TempDir;

/// The case of the book on discrete supports, with the place of the load.
fn model(position: &str) -> Case {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/discrete-supports.toml");
    Case::read(&path, &[format!("track.position={position}")]).unwrap()
}

/// Case on its own receptance, at even lines `step` \[Hz\] apart, with scatter of a part of the modulus.
fn measured(model: &Case, step: f64, scatter: f64) -> Case {
    let mut table = "frequency_hz,re,im\n".to_owned();
    let mut state = 7u64;
    for line in 1.. {
        let frequency = 20.0 + step * f64::from(line);
        if frequency > 3000.0 {
            break;
        }
        let mut even = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        };
        let noise = 1.0 + scatter * 12f64.sqrt() * even();
        let h = noise * model.track.receptance.receptance(TAU * frequency, 0.0);
        writeln!(table, "{frequency},{:e},{:e}", h.re, h.im).unwrap();
    }
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("rail.csv"), table).unwrap();
    let text = include_str!("../../cases/discrete-supports.toml")
        .replace("\"two-layer-periodic\"", "\"measured\"")
        .replace("preset = ", "support_spacing = \"0.6 m\" #")
        .replace("position = ", "#")
        + "\n[track.measurement]\nfile = \"rail.csv\"\nreal = \"re\"\nimaginary = \"im\"\n";
    let path = folder.path().join("case.toml");
    fs::write(&path, text).unwrap();
    Case::read(&path, &[]).unwrap()
}

fn frequency(case: &Case, kind: ResonanceKind) -> Vec<f64> {
    let found = ask::resonances(case).into_iter();
    found.filter(|resonance| resonance.kind == kind).map(|resonance| resonance.angular_frequency / TAU).collect()
}

/// Over a support the peaks are full-track and rail on pad, which the table does not name, and P2 is that of the model.
/// Lines 2 Hz apart move none by more than a line.
#[test]
fn peaks_of_a_table_are_those_of_its_model() {
    let model = model("0");
    let case = measured(&model, 2.0, 0.0);
    let peaks = frequency(&case, ResonanceKind::MeasuredPeak);
    for kind in [ResonanceKind::FullTrack, ResonanceKind::RailOnPad] {
        let expected = frequency(&model, kind)[0];
        assert!(peaks.iter().any(|peak| (peak - expected).abs() < 2.0), "{kind} {expected}: {peaks:?}");
    }
    let (p2, expected) = (frequency(&case, ResonanceKind::P2), frequency(&model, ResonanceKind::P2));
    assert_eq!(p2.len(), expected.len(), "{p2:?} {expected:?}");
    for (p2, expected) in p2.iter().zip(&expected) {
        assert!((p2 - expected).abs() < 2.0, "{p2} {expected}");
    }
    // The dip where the sleepers hold the rail; without loss 234 Hz.
    let dips = frequency(&case, ResonanceKind::MeasuredDip);
    assert!(dips.iter().any(|dip| (200.0..260.0).contains(dip)), "{dips:?}");
    // A dip over a support is not the pinned-pinned peak.
    assert!(frequency(&case, ResonanceKind::PinnedPinned).is_empty());
    let rail_on_pad = ask::resonances(&case)
        .into_iter()
        .find(|peak| (peak.angular_frequency / TAU / 492.0 - 1.0).abs() < 0.02)
        .unwrap();
    assert!(rail_on_pad.damping_ratio.is_some_and(|ratio| (0.02..0.3).contains(&ratio)));
    assert!((rail_on_pad.resolution.unwrap() / TAU - 2.0).abs() < 1e-6);
}

/// In mid-span the rail on the support spacing of the case predicts the highest peak, which then has its name.
#[test]
fn a_peak_has_the_name_that_the_case_predicts() {
    let model = model("0.3 m");
    let case = measured(&model, 2.0, 0.0);
    let (found, expected) =
        (frequency(&case, ResonanceKind::PinnedPinned), frequency(&model, ResonanceKind::PinnedPinned));
    assert_eq!(found.len(), 1);
    assert!((found[0] - expected[0]).abs() < 2.0, "{found:?} {expected:?}");
}

/// Scatter of 3 % in each line, as of a hammer test, adds no peak and hides none.
#[test]
fn scatter_is_no_resonance() {
    let model = model("0");
    let clean = frequency(&measured(&model, 2.0, 0.0), ResonanceKind::MeasuredPeak);
    let noisy = frequency(&measured(&model, 2.0, 0.03), ResonanceKind::MeasuredPeak);
    assert!(noisy.len() <= clean.len(), "{noisy:?} {clean:?}");
    assert!(noisy.iter().any(|peak| (peak / 492.0 - 1.0).abs() < 0.05), "{noisy:?}");
}

/// Every peak and dip is a candidate, wide as its damping, and nothing says that the rail has no support.
#[test]
fn peaks_are_candidates() {
    let case = measured(&model("0"), 2.0, 0.0);
    let (mechanisms, unknown) = traffic::mechanisms(&case);
    let peak = mechanisms
        .iter()
        .find(|mechanism| {
            mechanism.kind == MechanismKind::MeasuredPeak
                && mechanism.frequency().is_some_and(|f| (f / 492.0 - 1.0).abs() < 0.02)
        })
        .unwrap();
    let Prediction::Frequency { spread, damping_ratio, .. } = peak.prediction else {
        panic!("{peak:?}");
    };
    assert!(damping_ratio.is_some_and(|ratio| ratio < spread && spread < 0.2), "{peak:?}");
    for kind in [MechanismKind::MeasuredDip, MechanismKind::PinnedPinned, MechanismKind::SupportSpacing] {
        assert!(mechanisms.iter().any(|mechanism| mechanism.kind == kind), "{kind:?}");
    }
    assert!(unknown.iter().all(|sentence| !sentence.to_string().contains("no support")), "{unknown:?}");
}
