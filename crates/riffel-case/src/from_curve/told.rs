//! What the reader should know of a mean state from a curve.

use riffel::Rail;
use riffel::contact::Creepages;
use riffel::curving::Curve;
use riffel_keys::Remark;

use super::mean_contact::MeanContact;
use crate::case_text::CaseText;
use crate::file::{CurveRail, FromCurve};

impl CaseText {
    /// That a wheel stands on another point as well, which the loop leaves out.
    pub(super) fn tell_of_second_point(&mut self, rail: Rail, share: f64) {
        if share == 0.0 {
            return;
        }
        let percent = 100.0 * share;
        let german = match rail {
            Rail::Left => "linken",
            Rail::Right => "rechten",
        };
        self.curve_remarks.push(Remark::new(
            format!(
                "on the {} rail the wheel stands on two points; the other one, with {percent:.0} % of its normal forces, is left out of the loop",
                rail.name()
            ),
            format!(
                "auf der {german} Schiene steht das Rad auf zwei Punkten; der andere, mit {percent:.0} % seiner Normalkräfte, fehlt im Kreis"
            ),
        ));
    }

    pub(super) fn tell_where_from(
        &mut self,
        from: &FromCurve,
        rail: Rail,
        curve: &Curve,
        contact: &MeanContact,
    ) {
        let Creepages {
            longitudinal,
            lateral,
            spin,
        } = contact.creepages;
        let (radius, speed) = (curve.radius.abs(), 3.6 * curve.speed);
        let (along, across) = (100.0 * longitudinal, 100.0 * lateral);
        let angle = contact.contact_angle.to_degrees();
        let load = 1e-3 * contact.normal_force;
        let low = rail == CurveRail::Low.in_curve(curve.radius);
        let (name, german) = match (low, rail) {
            (true, Rail::Left) => ("low, left", "inneren, linken"),
            (true, Rail::Right) => ("low, right", "inneren, rechten"),
            (false, Rail::Left) => ("high, left", "äußeren, linken"),
            (false, Rail::Right) => ("high, right", "äußeren, rechten"),
        };
        let wheelset = from.wheelset;
        self.curve_remarks.push(Remark::new(
            format!(
                "mean state from the curve of {radius:.0} m at {speed:.0} km/h: wheelset {wheelset} on the {name} rail creeps {along:.3} % along, \
                 {across:.3} % across, spin {spin:.3} 1/m, under {load:.1} kN at {angle:.1}°"
            ),
            format!(
                "mittlerer Zustand aus dem Bogen von {radius:.0} m bei {speed:.0} km/h: Radsatz {wheelset} auf der {german} Schiene schlüpft \
                 {along:.3} % längs, {across:.3} % quer, Bohrschlupf {spin:.3} 1/m, unter {load:.1} kN bei {angle:.1}°"
            ),
        ));
    }
}
