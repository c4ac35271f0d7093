//! The outline of a wheel that is turned about the track, as the rail meets it.

use riffel::Rail;

use crate::profile::ProfilePoint;

/// Largest sine of the angle by which a contact runs ahead about the axle; steeper parts of a yawed wheel are not seen.
const FARTHEST_AHEAD: f64 = 0.99;

/// How one wheel stands, seen as a right one.
#[derive(Clone, Copy)]
pub(super) struct Attitude {
    pub(super) lateral_shift: f64,
    pub(super) yaw: (f64, f64),
    pub(super) roll: (f64, f64),
}

/// A point of a wheel's outline as seen along the track, from the axle's middle.
pub(in crate::profile) struct Outline {
    pub(in crate::profile) ahead: f64,
    pub(in crate::profile) across: f64,
    pub(in crate::profile) down: f64,
    /// dz/dy of the outline.
    pub(in crate::profile) slope: f64,
}

/// A left wheel is the right one of the mirrored wheelset.
pub(super) fn attitude(rail: Rail, lateral_shift: f64, yaw: f64, roll: f64) -> Attitude {
    let side = rail.sign();
    Attitude { lateral_shift: side * lateral_shift, yaw: (side * yaw).sin_cos(), roll: (side * roll).sin_cos() }
}

/// R = Rx(roll) Rz(yaw) on the point of the wheel whose normal has no component along the track: with r the radius over
/// the lateral coordinate it lies ahead of the lowest one by θ, sin θ = −tan ψ dr/dy.
pub(super) fn outline_of(
    point: &ProfilePoint,
    rolling_radius: f64,
    half_spacing: f64,
    attitude: &Attitude,
) -> Option<Outline> {
    let (yaw_sine, yaw_cosine) = attitude.yaw;
    let (roll_sine, roll_cosine) = attitude.roll;
    let (radius, radius_slope) = (rolling_radius - point.height, -point.slope);
    let ahead_sine = -yaw_sine / yaw_cosine * radius_slope;
    if ahead_sine.abs() > FARTHEST_AHEAD {
        return None;
    }
    let ahead_cosine = (1.0 - ahead_sine * ahead_sine).sqrt();
    let lateral = half_spacing + point.x;
    let forward = radius * ahead_sine;
    let (ahead, across) = (forward * yaw_cosine - lateral * yaw_sine, forward * yaw_sine + lateral * yaw_cosine);
    let down = radius * ahead_cosine;
    // The normal (0, −r'/cos ψ, cos θ), rolled.
    let (normal_across, normal_down) = (-radius_slope / yaw_cosine, ahead_cosine);
    let rolled_across = normal_across * roll_cosine - normal_down * roll_sine;
    let rolled_down = normal_across * roll_sine + normal_down * roll_cosine;
    Some(Outline {
        ahead,
        across: across * roll_cosine - down * roll_sine,
        down: across * roll_sine + down * roll_cosine,
        slope: -rolled_across / rolled_down,
    })
}
