//! Numbers of a forecast in words.

use riffel::forecast::Reach;
use riffel_keys::{Message, Value, say, significant_digits};

use crate::number_alone;

/// What stands in the place of a number that the linear loop cannot give.
pub(super) fn beyond() -> Message {
    say!(beyond_linear_range)
}

/// Change of level in a million passages \[dB\].
pub fn per_million(rate: f64) -> f64 {
    20.0 / std::f64::consts::LN_10 * 1e6 * rate
}

/// Passages to an event.
pub(crate) fn when(passages: Option<f64>) -> Message {
    match passages {
        Some(0.0) => say!(now),
        Some(passages) => number_alone(format_args!("{passages:.2e}")),
        None => say!(never),
    }
}

/// When a limit is reached.
pub(crate) fn reached(reach: Reach) -> Message {
    match reach {
        Reach::BeyondLinearRange => beyond(),
        reach => when(reach.passages()),
    }
}

/// A number to three digits in a sentence.
pub(crate) fn number(value: f64) -> Value {
    riffel_keys::number(three_digits(value))
}

/// A count of passages in a sentence, to three digits: "24.1 million".
pub(crate) fn millions(passages: f64) -> Value {
    /// Fewer stand as they are.
    const FEW: f64 = 1e5;
    match passages < FEW {
        true => riffel_keys::number(format!("{passages:.0}")),
        false => say!(so_many_million, count = number(1e-6 * passages)).into(),
    }
}

/// Three digits, as one writes them.
pub fn three_digits(value: f64) -> String {
    match value.abs() {
        size if size >= 1e5 => format!("{value:.2e}"),
        size if size >= 100.0 => significant_digits(value, 3),
        size if size >= 10.0 => format!("{value:.1}"),
        _ => format!("{value:.2}"),
    }
}
