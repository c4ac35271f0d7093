//! Loss of contact and forces of a march.

use riffel_keys::{Message, Value, fixed, say};
use serde::{Deserialize, Serialize};

/// Loss of contact and forces of a march.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Extremes {
    /// Share of the time without contact.
    pub contact_loss_fraction: f64,
    /// Least normal force.
    pub minimum_normal_force_n: f64,
    /// Largest normal force.
    pub maximum_normal_force_n: f64,
}

impl Extremes {
    /// Least and largest normal force \[N\], and the share of the time without contact.
    pub(super) fn new([minimum_normal_force_n, maximum_normal_force_n]: [f64; 2], contact_loss_fraction: f64) -> Self {
        Self { contact_loss_fraction, minimum_normal_force_n, maximum_normal_force_n }
    }

    /// Least and largest normal force \[kN\], and the share of the time without contact.
    pub(super) fn words(self) -> (Value, Value, Message) {
        let contact = match self.contact_loss_fraction {
            0.0 => say!(always_in_contact),
            share => say!(no_contact_for, share = fixed(100.0 * share, 1)),
        };
        (fixed(1e-3 * self.minimum_normal_force_n, 2), fixed(1e-3 * self.maximum_normal_force_n, 2), contact)
    }

    /// Extremes of the normal force as a sentence.
    pub(super) fn sentence(self) -> Message {
        let (least, largest, contact) = self.words();
        say!(normal_force_between, least, largest, contact)
    }
}
