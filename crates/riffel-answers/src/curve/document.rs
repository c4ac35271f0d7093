//! A vehicle in its curve as data.

use riffel::curving::{BodyState, FrameState, SecondContact, VehicleState, WheelState, WheelsetState};
use riffel_keys::Message;
use serde::Serialize;

use super::CurveAnswer;

/// What `riffel curve --json` prints.
#[derive(Serialize)]
pub struct CurveDocument {
    #[serde(flatten)]
    equilibrium: Equilibrium,
    continuation: Vec<Step>,
    other_equilibria: Vec<Other>,
    remarks: Vec<Message>,
    #[serde(skip_serializing_if = "Option::is_none")]
    over_radius: Option<Vec<AtRadius>>,
}

/// A vehicle in equilibrium: `frame` of a wheelset or a bogie, `frames` and `body` of a vehicle.
#[derive(Serialize)]
pub(super) struct Equilibrium {
    wheelsets: Vec<Wheelset>,
    wheels: Vec<Wheel>,
    #[serde(skip_serializing_if = "Option::is_none")]
    frame: Option<Frame>,
    #[serde(skip_serializing_if = "Option::is_none")]
    frames: Option<Vec<SecondaryFrame>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    body: Option<Body>,
    uncompensated_lateral_acceleration_m_s2: f64,
    normal_acceleration_m_s2: f64,
    frictional_power_w: f64,
    drive_power_w: f64,
    curving_resistance_n: f64,
    residual: f64,
}

/// The equilibrium at a radius; null where none is found.
#[derive(Serialize)]
pub(super) struct AtRadius {
    pub(super) radius_m: f64,
    pub(super) speed_m_per_s: f64,
    pub(super) equilibrium: Option<Equilibrium>,
}

#[derive(Serialize)]
struct Wheelset {
    wheelset: usize,
    lateral_shift_m: f64,
    yaw_rad: f64,
    angle_of_attack_rad: f64,
    rotation_ratio: f64,
    flange_force_n: f64,
    suspension_lateral_force_n: f64,
    suspension_yaw_moment_nm: f64,
    contact_yaw_moment_nm: f64,
    inertial_lateral_force_n: f64,
}

#[derive(Serialize)]
struct Wheel {
    wheelset: usize,
    rail: &'static str,
    longitudinal_creepage: f64,
    lateral_creepage: f64,
    spin_1_per_m: f64,
    contact_angle_rad: f64,
    rolling_radius_m: f64,
    on_two_points: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    second_contact: Option<Second>,
    vertical_load_n: f64,
    normal_force_n: f64,
    longitudinal_force_n: f64,
    lateral_force_n: f64,
    track_lateral_force_n: f64,
    tractive_ratio: f64,
    t_gamma_n: f64,
}

/// The contact of the larger angle of a wheel that stands on two points.
#[derive(Serialize)]
struct Second {
    longitudinal_creepage: f64,
    lateral_creepage: f64,
    spin_1_per_m: f64,
    contact_angle_rad: f64,
    rolling_radius_m: f64,
    normal_force_n: f64,
    longitudinal_force_n: f64,
    lateral_force_n: f64,
    track_lateral_force_n: f64,
    tractive_ratio: f64,
    t_gamma_n: f64,
}

#[derive(Serialize)]
struct Frame {
    lateral_shift_m: f64,
    yaw_rad: f64,
    inertial_lateral_force_n: f64,
}

/// A frame under a body.
#[derive(Serialize)]
struct SecondaryFrame {
    #[serde(flatten)]
    frame: Frame,
    secondary_lateral_force_n: f64,
    secondary_yaw_moment_nm: f64,
}

/// The body of a vehicle.
#[derive(Serialize)]
struct Body {
    lateral_shift_m: f64,
    yaw_rad: f64,
    inertial_lateral_force_n: f64,
}

/// A step of the way from straight track.
#[derive(Serialize)]
struct Step {
    fraction: f64,
    residual: f64,
    iterations: usize,
}

/// Where the wheelsets stand in another equilibrium.
#[derive(Serialize)]
struct Other {
    lateral_shift_m: Vec<f64>,
    yaw_rad: Vec<f64>,
    residual: f64,
}

impl CurveDocument {
    pub(super) fn new(answer: &CurveAnswer, over_radius: Option<Vec<AtRadius>>) -> Self {
        let steps = answer.state.continuation.iter();
        let others = answer.others.iter();
        Self {
            equilibrium: Equilibrium::new(&answer.state, answer.vehicle.curve.speed),
            continuation: steps
                .map(|step| Step { fraction: step.fraction, residual: step.residual, iterations: step.iterations })
                .collect(),
            other_equilibria: others
                .map(|other| {
                    let of = |value: fn(&WheelsetState) -> f64| other.wheelsets.iter().map(value).collect();
                    Other {
                        lateral_shift_m: of(|wheelset| wheelset.lateral_shift),
                        yaw_rad: of(|wheelset| wheelset.yaw),
                        residual: other.residual,
                    }
                })
                .collect(),
            remarks: answer.remarks.clone(),
            over_radius,
        }
    }
}

impl Equilibrium {
    pub(super) fn new(state: &VehicleState, speed: f64) -> Self {
        let wheelsets = state.wheelsets.iter().enumerate();
        Self {
            wheelsets: wheelsets.map(|(index, wheelset)| Wheelset::new(index + 1, wheelset)).collect(),
            wheels: state.wheels.iter().map(Wheel::new).collect(),
            frame: match &state.frames[..] {
                [lone] => Some(Frame::new(lone)),
                _ => None,
            },
            frames: state.body.map(|_| {
                let frames = state.frames.iter();
                frames.map(SecondaryFrame::new).collect()
            }),
            body: state.body.as_ref().map(Body::new),
            uncompensated_lateral_acceleration_m_s2: state.uncompensated_acceleration,
            normal_acceleration_m_s2: state.normal_acceleration,
            frictional_power_w: state.frictional_power,
            drive_power_w: state.drive_power,
            curving_resistance_n: state.curving_resistance(speed),
            residual: state.residual,
        }
    }
}

impl Frame {
    fn new(state: &FrameState) -> Self {
        Self {
            lateral_shift_m: state.lateral_shift,
            yaw_rad: state.yaw,
            inertial_lateral_force_n: state.inertial_lateral_force,
        }
    }
}

impl SecondaryFrame {
    fn new(state: &FrameState) -> Self {
        Self {
            frame: Frame::new(state),
            secondary_lateral_force_n: state.secondary_lateral_force,
            secondary_yaw_moment_nm: state.secondary_yaw_moment,
        }
    }
}

impl Body {
    fn new(state: &BodyState) -> Self {
        Self {
            lateral_shift_m: state.lateral_shift,
            yaw_rad: state.yaw,
            inertial_lateral_force_n: state.inertial_lateral_force,
        }
    }
}

impl Wheelset {
    fn new(wheelset: usize, state: &WheelsetState) -> Self {
        Self {
            wheelset,
            lateral_shift_m: state.lateral_shift,
            yaw_rad: state.yaw,
            angle_of_attack_rad: state.angle_of_attack,
            rotation_ratio: state.rotation_ratio,
            flange_force_n: state.flange_force,
            suspension_lateral_force_n: state.suspension_lateral_force,
            suspension_yaw_moment_nm: state.suspension_yaw_moment,
            contact_yaw_moment_nm: state.contact_yaw_moment,
            inertial_lateral_force_n: state.inertial_lateral_force,
        }
    }
}

impl Wheel {
    fn new(state: &WheelState) -> Self {
        Self {
            wheelset: state.wheelset,
            rail: state.rail.name(),
            longitudinal_creepage: state.creepages.longitudinal,
            lateral_creepage: state.creepages.lateral,
            spin_1_per_m: state.creepages.spin,
            contact_angle_rad: state.contact_angle,
            rolling_radius_m: state.rolling_radius,
            on_two_points: state.on_two_points(),
            second_contact: state.second_contact.as_ref().map(Second::new),
            vertical_load_n: state.vertical_load,
            normal_force_n: state.normal_force,
            longitudinal_force_n: state.creep_forces.longitudinal,
            lateral_force_n: state.creep_forces.lateral,
            track_lateral_force_n: state.track_lateral_force,
            tractive_ratio: state.tractive_ratio,
            t_gamma_n: state.t_gamma,
        }
    }
}

impl Second {
    fn new(state: &SecondContact) -> Self {
        Self {
            longitudinal_creepage: state.creepages.longitudinal,
            lateral_creepage: state.creepages.lateral,
            spin_1_per_m: state.creepages.spin,
            contact_angle_rad: state.contact_angle,
            rolling_radius_m: state.rolling_radius,
            normal_force_n: state.normal_force,
            longitudinal_force_n: state.creep_forces.longitudinal,
            lateral_force_n: state.creep_forces.lateral,
            track_lateral_force_n: state.track_lateral_force,
            tractive_ratio: state.tractive_ratio,
            t_gamma_n: state.t_gamma,
        }
    }
}
