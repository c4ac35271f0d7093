//! What the reader should know of a mean state from a curve.

use riffel::Rail;
use riffel::contact::Creepages;
use riffel_curving::Curve;
use riffel_keys::{Message, fixed, say, shown_speed};

use super::Placing;
use super::mean_contact::MeanContact;
use crate::file::{CurveRail, FromCurve};

/// A rail, as in "on the left rail".
pub(super) fn on_rail(rail: Rail) -> Message {
    match rail {
        Rail::Left => say!(on_left),
        Rail::Right => say!(on_right),
    }
}

impl Placing<'_> {
    /// That a wheel stands on another point as well, which the loop leaves out.
    pub(super) fn tell_of_second_point(&mut self, rail: Rail, share: f64) {
        if share == 0.0 {
            return;
        }
        let percent = 100.0 * share;
        self.remarks.push(say!(second_point_left_out, rail = on_rail(rail), percent = fixed(percent, 0)));
    }

    pub(super) fn tell_where_from(&mut self, from: &FromCurve, rail: Rail, curve: &Curve, contact: &MeanContact) {
        let Creepages { longitudinal, lateral, spin } = contact.creepages;
        let (radius, speed) = (curve.radius.abs(), curve.speed);
        let (along, across) = (100.0 * longitudinal, 100.0 * lateral);
        let angle = contact.contact_angle.to_degrees();
        let load = 1e-3 * contact.normal_force;
        let low = rail == CurveRail::Low.in_curve(curve.radius);
        let rail = match (low, rail) {
            (true, Rail::Left) => say!(on_low_left),
            (true, Rail::Right) => say!(on_low_right),
            (false, Rail::Left) => say!(on_high_left),
            (false, Rail::Right) => say!(on_high_right),
        };
        self.remarks.push(say!(
            mean_state_from_curve,
            radius = fixed(radius, 0),
            speed = shown_speed(speed, 0),
            wheelset = from.wheelset,
            rail,
            along = fixed(along, 3),
            across = fixed(across, 3),
            spin = fixed(spin, 3),
            load = fixed(load, 1),
            angle = fixed(angle, 1)
        ));
    }
}
