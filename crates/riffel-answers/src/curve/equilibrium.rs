//! A vehicle in equilibrium as data.

use riffel::contact::{CreepForces, Creepages};
use riffel_curving::{FrameState, SecondContact, VehicleState, WheelState, WheelsetState};
use serde::Serialize;

/// A vehicle in equilibrium: `frame` of a wheelset or a bogie, `frames` and `body` of a vehicle.
#[derive(Serialize)]
pub(super) struct Equilibrium {
    pub(super) wheelsets: Vec<Wheelset>,
    pub(super) wheels: Vec<Wheel>,
    #[serde(skip_serializing_if = "Option::is_none")]
    frame: Option<Frame>,
    #[serde(skip_serializing_if = "Option::is_none")]
    frames: Option<Vec<SecondaryFrame>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    body: Option<Frame>,
    pub(super) uncompensated_lateral_acceleration_m_s2: f64,
    normal_acceleration_m_s2: f64,
    pub(super) frictional_power_w: f64,
    drive_power_w: f64,
    curving_resistance_n: f64,
    pub(super) residual: f64,
}

#[derive(Serialize)]
pub(super) struct Wheelset {
    wheelset: usize,
    pub(super) lateral_shift_m: f64,
    pub(super) yaw_rad: f64,
    pub(super) angle_of_attack_rad: f64,
    rotation_ratio: f64,
    flange_force_n: f64,
    suspension_lateral_force_n: f64,
    suspension_yaw_moment_nm: f64,
    contact_yaw_moment_nm: f64,
    inertial_lateral_force_n: f64,
}

#[derive(Serialize)]
pub(super) struct Wheel {
    pub(super) wheelset: usize,
    pub(super) rail: &'static str,
    #[serde(flatten)]
    pub(super) creep: Creep,
    on_two_points: bool,
    /// That of the larger angle, of a wheel that stands on two points.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) second_contact: Option<Contact>,
    vertical_load_n: f64,
    #[serde(flatten)]
    pub(super) forces: Forces,
}

/// One of the contacts of a wheel.
#[derive(Serialize)]
pub(super) struct Contact {
    #[serde(flatten)]
    pub(super) creep: Creep,
    #[serde(flatten)]
    pub(super) forces: Forces,
}

/// Creepages at a contact, and where it lies.
#[derive(Serialize)]
pub(super) struct Creep {
    pub(super) longitudinal_creepage: f64,
    pub(super) lateral_creepage: f64,
    pub(super) spin_1_per_m: f64,
    pub(super) contact_angle_rad: f64,
    pub(super) rolling_radius_m: f64,
}

#[derive(Serialize)]
pub(super) struct Forces {
    pub(super) normal_force_n: f64,
    pub(super) longitudinal_force_n: f64,
    pub(super) lateral_force_n: f64,
    pub(super) track_lateral_force_n: f64,
    pub(super) tractive_ratio: f64,
    pub(super) t_gamma_n: f64,
}

/// A frame or the body of a vehicle.
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

impl Equilibrium {
    pub(super) fn new(state: &VehicleState, speed: f64) -> Self {
        let wheelsets = state.wheelsets.iter().enumerate();
        let frame = |state: &FrameState| Frame {
            lateral_shift_m: state.lateral_shift,
            yaw_rad: state.yaw,
            inertial_lateral_force_n: state.inertial_lateral_force,
        };
        Self {
            wheelsets: wheelsets.map(|(index, wheelset)| Wheelset::new(index + 1, wheelset)).collect(),
            wheels: state.wheels.iter().map(Wheel::new).collect(),
            frame: match &state.frames[..] {
                [lone] => Some(frame(lone)),
                _ => None,
            },
            frames: state.body.map(|_| {
                let frames = state.frames.iter().map(|state| SecondaryFrame {
                    frame: frame(state),
                    secondary_lateral_force_n: state.secondary_lateral_force,
                    secondary_yaw_moment_nm: state.secondary_yaw_moment,
                });
                frames.collect()
            }),
            body: state.body.map(|body| Frame {
                lateral_shift_m: body.lateral_shift,
                yaw_rad: body.yaw,
                inertial_lateral_force_n: body.inertial_lateral_force,
            }),
            uncompensated_lateral_acceleration_m_s2: state.uncompensated_acceleration,
            normal_acceleration_m_s2: state.normal_acceleration,
            frictional_power_w: state.frictional_power,
            drive_power_w: state.drive_power,
            curving_resistance_n: state.curving_resistance(speed),
            residual: state.residual,
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
            creep: Creep::new(state.creepages, state.contact_angle, state.rolling_radius),
            on_two_points: state.on_two_points(),
            second_contact: state.second_contact.as_ref().map(Contact::new),
            vertical_load_n: state.vertical_load,
            forces: Forces::new(
                state.normal_force,
                state.creep_forces,
                state.track_lateral_force,
                state.tractive_ratio,
                state.t_gamma,
            ),
        }
    }

    /// Its first contact and its second.
    pub(super) fn contacts(&self) -> impl Iterator<Item = (&Creep, &Forces)> {
        let second = self.second_contact.iter().map(|second| (&second.creep, &second.forces));
        [(&self.creep, &self.forces)].into_iter().chain(second)
    }

    /// Tγ of all contacts of the wheel \[N\].
    pub(super) fn whole_t_gamma(&self) -> f64 {
        self.forces.t_gamma_n + self.second_contact.as_ref().map_or(0.0, |second| second.forces.t_gamma_n)
    }
}

impl Contact {
    fn new(state: &SecondContact) -> Self {
        Self {
            creep: Creep::new(state.creepages, state.contact_angle, state.rolling_radius),
            forces: Forces::new(
                state.normal_force,
                state.creep_forces,
                state.track_lateral_force,
                state.tractive_ratio,
                state.t_gamma,
            ),
        }
    }
}

impl Creep {
    fn new(creepages: Creepages, contact_angle_rad: f64, rolling_radius_m: f64) -> Self {
        Self {
            longitudinal_creepage: creepages.longitudinal,
            lateral_creepage: creepages.lateral,
            spin_1_per_m: creepages.spin,
            contact_angle_rad,
            rolling_radius_m,
        }
    }
}

impl Forces {
    fn new(
        normal_force_n: f64,
        creep: CreepForces,
        track_lateral_force_n: f64,
        tractive_ratio: f64,
        t_gamma_n: f64,
    ) -> Self {
        Self {
            normal_force_n,
            longitudinal_force_n: creep.longitudinal,
            lateral_force_n: creep.lateral,
            track_lateral_force_n,
            tractive_ratio,
            t_gamma_n,
        }
    }
}
