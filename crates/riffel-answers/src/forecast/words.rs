//! Numbers of a forecast in words.

use riffel::forecast::Reach;
use riffel_keys::significant_digits;

/// What stands in the place of a number that the linear loop cannot give.
pub(super) const BEYOND: &str = "beyond the linear range";

/// Change of level in a million passages \[dB\].
pub fn per_million(rate: f64) -> f64 {
    20.0 / std::f64::consts::LN_10 * 1e6 * rate
}

/// Passages to an event.
pub fn when(passages: Option<f64>) -> String {
    match passages {
        Some(0.0) => "now".to_owned(),
        Some(passages) => format!("{passages:.2e}"),
        None => "never".to_owned(),
    }
}

/// When a limit is reached.
pub fn reached(reach: Reach) -> String {
    match reach {
        Reach::BeyondLinearRange => BEYOND.to_owned(),
        reach => when(reach.passages()),
    }
}

/// Three digits, as one writes them.
pub fn number(value: f64) -> String {
    match value.abs() {
        size if size >= 1e5 => format!("{value:.2e}"),
        size if size >= 100.0 => significant_digits(value, 3),
        size if size >= 10.0 => format!("{value:.1}"),
        _ => format!("{value:.2}"),
    }
}
