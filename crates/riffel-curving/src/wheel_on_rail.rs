//! One wheel of a yawed wheelset in a curve: its creepages, its forces, and what they do to the wheelset.

use riffel::contact::Creepages;
use riffel::{Error, Rail};

use super::creep::CreepOnRail;
use super::two_point_path::Place;
use super::{ContactPlane, Creep, Kinematics, RollingPosition, WheelState};

/// What moves a wheel.
#[derive(Debug, Clone, Copy)]
pub(super) struct WheelsetMotion {
    /// Curvature of the track 1/R \[1/m\].
    pub(super) curvature: f64,
    /// Half the spacing of the contacts s \[m\].
    pub(super) half_spacing: f64,
    /// Radius r₀ of the right wheel \[m\], to which the rotation refers.
    pub(super) reference_radius: f64,
    /// Yaw ψ \[rad\].
    pub(super) yaw: f64,
    /// Ω r₀/V − 1 \[-\].
    pub(super) rotation: f64,
}

/// A wheel on its rail under a normal force.
#[derive(Debug, Clone, Copy)]
pub(super) struct WheelOnRail {
    pub(super) state: WheelState,
    /// Vertical force that normal and tangential force carry \[N\].
    pub(super) carried: f64,
    /// Yaw moment on the wheelset \[N m\].
    pub(super) yaw_moment: f64,
    /// Torque on the wheelset about its axle \[N m\], positive where it drives.
    pub(super) torque: f64,
}

/// A point with less than this share of the normal force carries none: rounding, and below the tolerance of equilibrium.
const NO_SHARE: f64 = 1e-13;

/// A wheel of radius r₀ \[m\] under the sum of its normal forces \[N\]; none off the track.
pub(super) fn wheel_on_rail(
    rail: Rail,
    radius: f64,
    motion: &WheelsetMotion,
    place: &Place<'_>,
    normal_force: f64,
    kinematics: &Kinematics,
    creep: CreepOnRail<'_>,
) -> Result<Option<WheelOnRail>, Error> {
    match kinematics {
        Kinematics::Linear { conicity } => {
            linear(rail, radius, motion, place.shift, normal_force, *conicity, creep).map(Some)
        }
        Kinematics::Nonlinear { surfaces, contact_plane, .. } => {
            let at = |position: &RollingPosition, force: f64| match radius + position.radius_change {
                // The method tries states on its way at which cones without an end have no radius left.
                rolling_radius if rolling_radius <= 0.0 => Ok(None),
                _ => nonlinear(rail, radius, motion, force, position, *contact_plane, creep).map(Some),
            };
            let Some((points, share)) = place.two_points(rail) else {
                let position = surfaces.position(rail, place.shift);
                return position.map_or(Ok(None), |position| at(&position, normal_force));
            };
            let [below, above] = points.positions;
            if share <= NO_SHARE {
                at(&below, normal_force)
            } else if share >= 1.0 - NO_SHARE {
                at(&above, normal_force)
            } else {
                let one = at(&below, (1.0 - share) * normal_force)?;
                let other = at(&above, share * normal_force)?;
                Ok(one.zip(other).map(|(one, other)| WheelOnRail {
                    state: one.state.joined(other.state),
                    carried: one.carried + other.carried,
                    yaw_moment: one.yaw_moment + other.yaw_moment,
                    torque: one.torque + other.torque,
                }))
            }
        }
    }
}

/// Linear steering theory: ξ_x = 1 − ω ∓ (s/R + λy/r₀), ξ_y = −ψ, φ = ∓λ/r₀ + 1/R, forces in the plane of the track.
fn linear(
    rail: Rail,
    radius: f64,
    motion: &WheelsetMotion,
    lateral_shift: f64,
    normal_force: f64,
    conicity: f64,
    creep: CreepOnRail<'_>,
) -> Result<WheelOnRail, Error> {
    let side = rail.sign();
    let radius_change = side * conicity * lateral_shift;
    let curve = side * motion.half_spacing * motion.curvature;
    let creepages = Creepages {
        longitudinal: -motion.rotation - curve - radius_change / radius,
        lateral: -motion.yaw,
        spin: motion.curvature - side * conicity / radius,
    };
    let forces = match creep.creep {
        Creep::Linear { ellipse, .. } => ellipse.linear_forces(creepages),
        _ => creep.forces(normal_force, creepages, &RollingPosition::default())?,
    };
    let state = WheelState {
        wheelset: 0,
        rail,
        creepages,
        contact_angle: 0.0,
        rolling_radius: radius + radius_change,
        lateral_curvature: None,
        second_contact: None,
        vertical_load: 0.0,
        normal_force,
        creep_forces: forces,
        track_lateral_force: forces.lateral,
        tractive_ratio: forces.magnitude() / (creep.friction() * normal_force),
        t_gamma: power_per_speed(creepages, forces),
    };
    Ok(WheelOnRail {
        carried: normal_force,
        yaw_moment: side * motion.half_spacing * forces.longitudinal,
        torque: radius * forces.longitudinal,
        state,
    })
}

/// ξ_x = 1 ∓ s/R − ω (r/r₀) cos ψ, ξ_y = −ω (r/r₀) sin ψ / cos γ, φ = ∓(ω/r₀) sin γ cos ψ + cos γ/R. The 1/cos γ comes
/// from no velocity along the normal: a contact on the flange of a yawed wheel runs ahead of the axle.
fn nonlinear(
    rail: Rail,
    radius: f64,
    motion: &WheelsetMotion,
    normal_force: f64,
    position: &RollingPosition,
    plane: ContactPlane,
    creep: CreepOnRail<'_>,
) -> Result<WheelOnRail, Error> {
    let side = rail.sign();
    let (half_spacing, curvature) = (motion.half_spacing, motion.curvature);
    let (sine, cosine) = motion.yaw.sin_cos();
    let (gamma_sine, gamma_cosine) = position.contact_angle.sin_cos();
    // ω r/r₀ − 1 and ω (r/r₀) cos ψ − 1 without the difference of nearly equal numbers.
    let larger = (radius - motion.reference_radius) + position.radius_change;
    let own = larger / motion.reference_radius;
    let rolling = motion.rotation + own * (1.0 + motion.rotation);
    let half_sine = (0.5 * motion.yaw).sin();
    let forward = rolling - 2.0 * half_sine * half_sine * (1.0 + rolling);
    let tilt = match plane {
        ContactPlane::Horizontal => (0.0, 1.0),
        ContactPlane::Tilted { .. } => (gamma_sine, gamma_cosine),
    };
    let creepages = Creepages {
        longitudinal: -side * half_spacing * curvature - forward,
        lateral: -(1.0 + rolling) * sine / tilt.1,
        spin: gamma_cosine * curvature - side * (1.0 + motion.rotation) / motion.reference_radius * gamma_sine * cosine,
    };
    let forces = creep.forces(normal_force, creepages, position)?;
    let lateral = forces.lateral * tilt.1 + side * normal_force * tilt.0;
    let rolling_radius = radius + position.radius_change;
    let ahead = match plane {
        ContactPlane::Tilted { shift_moment: true } => {
            side * sine * (rolling_radius * gamma_sine / gamma_cosine - half_spacing)
        }
        _ => 0.0,
    };
    let state = WheelState {
        wheelset: 0,
        rail,
        creepages,
        contact_angle: position.contact_angle,
        rolling_radius,
        lateral_curvature: position.lateral_curvature,
        second_contact: None,
        vertical_load: 0.0,
        normal_force,
        creep_forces: forces,
        track_lateral_force: lateral,
        tractive_ratio: forces.magnitude() / (creep.friction() * normal_force),
        t_gamma: power_per_speed(creepages, forces),
    };
    Ok(WheelOnRail {
        carried: normal_force * tilt.1 - side * forces.lateral * tilt.0,
        yaw_moment: side * half_spacing * forces.longitudinal - ahead * lateral,
        torque: rolling_radius * (forces.longitudinal * cosine + forces.lateral * sine / tilt.1),
        state,
    })
}

fn power_per_speed(creepages: Creepages, forces: riffel::contact::CreepForces) -> f64 {
    forces.longitudinal * creepages.longitudinal + forces.lateral * creepages.lateral
}
