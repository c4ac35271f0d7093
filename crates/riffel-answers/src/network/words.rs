//! Numbers and places of a network in words.

use riffel_keys::{Message, range, say};
use riffel_network::DefectKind;

use crate::number_alone;

/// Kilometres of metres.
pub(super) fn kilometres(metres: f64) -> Message {
    number_alone(format!("{:.3}", 1e-3 * metres))
}

/// A band in millimetres.
pub(super) fn millimetres(band: [f64; 2]) -> Message {
    Message::verbatim(range(band, |end| format!("{:.0}", 1e3 * end)))
}

/// With its sign, which nought does not have.
pub(super) fn tenths(value: f64) -> String {
    match format!("{value:+.1}").as_str() {
        "-0.0" | "+0.0" => "0.0".to_owned(),
        text => text.to_owned(),
    }
}

/// A ratio or a length to two digits.
pub(super) fn hundredths(value: f64) -> Message {
    number_alone(format!("{value:.2}"))
}

pub(super) fn nothing() -> Message {
    Message::verbatim("")
}

/// What makes a section rough, where that is known.
pub(super) fn kind_in_words(kind: Option<DefectKind>) -> Message {
    match kind {
        None => nothing(),
        Some(DefectKind::Corrugation) => say!(kind_corrugation),
        Some(DefectKind::Joint) => say!(kind_joints),
        Some(DefectKind::Weld) => say!(kind_welds),
        Some(DefectKind::Ground) => say!(kind_ground),
        Some(DefectKind::Unknown) => say!(kind_unknown),
    }
}
