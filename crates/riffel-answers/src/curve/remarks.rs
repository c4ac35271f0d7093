//! What the reader of an equilibrium should know.

use riffel::Rail;
use riffel::contact::EllipticContact;
use riffel_case::CurvingCase;
use riffel_curving::{Creep, VehicleInCurve, VehicleState, WheelState};
use riffel_keys::{Message, fixed, say};

use crate::side::side;

/// Lateral shift \[m\] beyond the play that wheelsets have to their flanges.
const PLAY: f64 = 0.01;

/// A flange that yaw lets meet its rail earlier by this is told of \[m\]: gauges are kept to some tenths of a millimetre.
const EARLIER: f64 = 1e-4;

/// Remarks on an equilibrium.
pub(super) fn of(case: &CurvingCase, vehicle: &VehicleInCurve, state: &VehicleState) -> Vec<Message> {
    let mut remarks = Vec::new();
    let profiles = case.file.profiles.as_ref();
    let without_flange = profiles.is_some_and(|profiles| profiles.wheel == "cone" && profiles.flange.is_none());
    let farthest = state
        .wheelsets
        .iter()
        .map(|wheelset| wheelset.lateral_shift)
        .fold(0.0_f64, |most, shift| if shift.abs() > most.abs() { shift } else { most });
    if without_flange && farthest.abs() > PLAY {
        let shift = 1e3 * farthest;
        remarks.push(say!(wheelset_beyond_flange, shift = fixed(shift, 1)));
    }
    let linear = vehicle.creep.iter().any(|creep| matches!(creep, Creep::Linear { .. }));
    let most = state
        .wheels
        .iter()
        .flat_map(|wheel| {
            let second = wheel.second_contact.map(|second| second.tractive_ratio);
            [Some(wheel.tractive_ratio), second]
        })
        .flatten()
        .fold(0.0, f64::max);
    if linear && most > 1.0 {
        remarks.push(say!(linear_creep_beyond_friction, most = fixed(most, 2)));
    }
    let wear_of = |wheel: &WheelState| {
        let second = wheel.second_contact.map_or(0.0, |second| second.t_gamma);
        wheel.t_gamma.min(second)
    };
    let least = state.wheels.iter().min_by(|one, other| wear_of(one).total_cmp(&wear_of(other)));
    if let Some(wheel) = least.filter(|wheel| wear_of(wheel) < 0.0) {
        remarks.push(say!(
            t_gamma_below_zero,
            wheelset = wheel.wheelset,
            rail = side(wheel.rail.name()),
            wear = fixed(wear_of(wheel), 3)
        ));
    }
    remarks.extend(wide_ellipse(case, state));
    remarks.extend(flange_under_yaw(case, state));
    remarks
}

/// The widest ellipse, where it is wider than a profile keeps its curvature.
fn wide_ellipse(case: &CurvingCase, state: &VehicleState) -> Option<Message> {
    let material = case.steel().ok()?;
    let width = |wheel: &WheelState| -> Option<f64> {
        let along = wheel.contact_angle.cos() / wheel.rolling_radius;
        let curvatures = [along, wheel.lateral_curvature?];
        let hertz = EllipticContact::of_wheel_on_rail(material, curvatures, wheel.normal_force);
        let hertz = hertz.ok()?;
        Some(2.0 * hertz.semi_axis_lateral())
    };
    let widths = state.wheels.iter().filter_map(|wheel| Some((wheel, width(wheel)?)));
    let (wheel, width) = widths.max_by(|one, other| one.1.total_cmp(&other.1))?;
    (width > EllipticContact::WIDEST).then(|| {
        say!(
            ellipse_of_wheel_too_wide,
            wheelset = wheel.wheelset,
            rail = side(wheel.rail.name()),
            width = fixed(1e3 * width, 0)
        )
    })
}

/// The geometry of the contacts is that without yaw: what yaw does to the play of the most yawed wheelset.
fn flange_under_yaw(case: &CurvingCase, state: &VehicleState) -> Option<Message> {
    let wheelset_on_track = case.wheelset_on_track().ok()?;
    let (index, wheelset) =
        state.wheelsets.iter().enumerate().max_by(|one, other| one.1.yaw.abs().total_cmp(&other.1.yaw.abs()))?;
    let rail = match wheelset.lateral_shift > 0.0 {
        true => Rail::Right,
        false => Rail::Left,
    };
    let straight = wheelset_on_track.flange_shift(rail, 0.0)?;
    let yawed = wheelset_on_track.flange_shift(rail, wheelset.yaw)?;
    (straight - yawed > EARLIER).then(|| {
        let (number, yaw) = (index + 1, 1e3 * wheelset.yaw.abs());
        let (straight, yawed) = (1e3 * straight, 1e3 * yawed);
        say!(yaw_takes_play, yaw = fixed(yaw, 0), number, yawed = fixed(yawed, 1), straight = fixed(straight, 1))
    })
}
