//! The moving-load beam of the Appendix.

use crate::Row;
use crate::ground::{extent, nominal};

/// Speed of Figs. 2 and 3 \[m/s\].
const SPEED: f64 = 27.8;

/// Ratio of the receptance under the moving load to (23), modulus and phase \[°\], 50–1600 Hz.
fn against_stationary() -> Vec<(f64, f64)> {
    let moving = nominal(&["track.model=moving-beam"]).track.receptance;
    let free = nominal(&[]).track.receptance;
    (50..=1600)
        .map(|frequency| {
            let w = std::f64::consts::TAU * f64::from(frequency);
            let ratio = moving.receptance(w, SPEED) / free.receptance(w, SPEED);
            (ratio.norm(), ratio.arg().to_degrees())
        })
        .collect()
}

pub(crate) fn moving_load_modulus() -> Row {
    let (low, high) = extent(against_stationary().into_iter().map(|(modulus, _)| modulus));
    let worst = (high - 1.0).max(1.0 - low);
    Row {
        statement: "At 27.8 m/s the moving load (27)–(33) has the modulus of (23), 50–1600 Hz",
        source: "Appendix, large-K limit",
        expected: "ratio 1".to_owned(),
        got: format!("off by {worst:.1e} at most"),
        tolerance: "1e-5: the remainder is of second order in p² = V²/(4ω√(EI/m)) ≤ 2.1e-3",
        holds: worst < 1e-5,
    }
}

pub(crate) fn moving_load_phase() -> Row {
    let (low, high) = extent(against_stationary().into_iter().map(|(_, phase)| phase));
    let worst = high.max(-low);
    Row {
        statement: "… and its phase",
        source: "Appendix, large-K limit",
        expected: "difference 0°".to_owned(),
        got: format!("off by {worst:.2}° at most"),
        tolerance: "0.2°: the remainder is of first order in p² ≤ 2.1e-3 rad",
        holds: worst < 0.2,
    }
}

pub(crate) fn stationary_lag() -> Row {
    let free = nominal(&[]).track.receptance;
    let phase = free.receptance(3e3, 0.0).arg().to_degrees();
    Row {
        statement: "The displacement of the free beam lags the force by 135°",
        source: "Appendix, last formula",
        expected: "−135°".to_owned(),
        got: format!("{phase:.3}°"),
        tolerance: "1e-9°: rounding",
        holds: (phase + 135.0).abs() < 1e-9,
    }
}
