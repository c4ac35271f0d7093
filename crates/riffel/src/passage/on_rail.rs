//! What every march has along a rail.

use super::{ContactInstant, GeneralMarch, March};

/// Wheels under way along a rail.
pub(super) trait OnRail {
    /// One step on; `height` tells that of the rail \[m\] at a distance ahead of the first wheel \[m\].
    fn advance_over(&mut self, height: impl Fn(f64) -> f64);

    /// The contacts where the march stands, that of the first wheel first.
    fn contacts(&self) -> &[ContactInstant];
}

impl OnRail for March<'_> {
    fn advance_over(&mut self, height: impl Fn(f64) -> f64) {
        self.advance(height(0.0));
    }

    fn contacts(&self) -> &[ContactInstant] {
        std::slice::from_ref(self.at_contact())
    }
}

impl OnRail for GeneralMarch<'_> {
    fn advance_over(&mut self, height: impl Fn(f64) -> f64) {
        self.advance_along(height);
    }

    fn contacts(&self) -> &[ContactInstant] {
        self.now()
    }
}
