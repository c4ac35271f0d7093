//! A vehicle in equilibrium.

use riffel::Rail;
use riffel::contact::{CreepForces, Creepages};

/// A wheelset in equilibrium; forces and moments are those on the wheelset.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct WheelsetState {
    /// Lateral shift y \[m\].
    pub lateral_shift: f64,
    /// Yaw ψ \[rad\].
    pub yaw: f64,
    /// Angle of attack \[rad\], positive with the nose to the outside of the curve.
    pub angle_of_attack: f64,
    /// Ω r₀/V \[-\], with the radius of the right wheel.
    pub rotation_ratio: f64,
    /// Lateral force of a flange that is a spring \[N\].
    pub flange_force: f64,
    /// Lateral force of the suspension \[N\].
    pub suspension_lateral_force: f64,
    /// Yaw moment of the suspension \[N m\].
    pub suspension_yaw_moment: f64,
    /// Yaw moment of the contacts \[N m\].
    pub contact_yaw_moment: f64,
    /// Lateral inertial force of its mass under the uncompensated acceleration \[N\].
    pub inertial_lateral_force: f64,
}

/// The contact of one wheel; forces are those on the rail. Where the wheel stands on two points this is the one of the
/// smaller contact angle.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct WheelState {
    /// Wheelset, 1 leads.
    pub wheelset: usize,
    /// Rail.
    pub rail: Rail,
    /// Creepages, lateral and spin in the plane of contact.
    pub creepages: Creepages,
    /// Contact angle γ \[rad\].
    pub contact_angle: f64,
    /// Rolling radius r \[m\].
    pub rolling_radius: f64,
    /// Curvature of wheel and rail together across the track \[1/m\], where the running surfaces tell it.
    pub lateral_curvature: Option<f64>,
    /// The other contact of a wheel that stands on two points.
    pub second_contact: Option<SecondContact>,
    /// Vertical load W \[N\].
    pub vertical_load: f64,
    /// Normal force P \[N\].
    pub normal_force: f64,
    /// Tangential force in the axes of the contact \[N\].
    pub creep_forces: CreepForces,
    /// Lateral force on the rail in the plane of the track \[N\], of normal and tangential force.
    pub track_lateral_force: f64,
    /// |Q|/μP \[-\].
    pub tractive_ratio: f64,
    /// Dissipated energy per metre Tγ = Q_x ξ_x + Q_y ξ_y \[N\].
    pub t_gamma: f64,
}

/// The other contact of a wheel that stands on two points, that of the larger angle, as in [`WheelState`].
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct SecondContact {
    /// Creepages, lateral and spin in the plane of contact.
    pub creepages: Creepages,
    /// Contact angle γ \[rad\].
    pub contact_angle: f64,
    /// Rolling radius r \[m\].
    pub rolling_radius: f64,
    /// Curvature of wheel and rail together across the track \[1/m\], where the running surfaces tell it.
    pub lateral_curvature: Option<f64>,
    /// Normal force P \[N\].
    pub normal_force: f64,
    /// Tangential force in the axes of the contact \[N\].
    pub creep_forces: CreepForces,
    /// Lateral force on the rail in the plane of the track \[N\], of normal and tangential force.
    pub track_lateral_force: f64,
    /// |Q|/μP \[-\].
    pub tractive_ratio: f64,
    /// Dissipated energy per metre Tγ \[N\].
    pub t_gamma: f64,
}

impl WheelState {
    /// Whether the wheel stands on two points.
    pub fn on_two_points(&self) -> bool {
        self.second_contact.is_some()
    }

    /// Tγ of all contacts of the wheel \[N\].
    pub fn whole_t_gamma(&self) -> f64 {
        self.t_gamma + self.second_contact.map_or(0.0, |second| second.t_gamma)
    }

    /// Which part of the normal forces of the wheel its second contact carries \[-\]; zero where it stands on one.
    pub fn share_of_second_contact(&self) -> f64 {
        self.second_contact.map_or(0.0, |second| second.normal_force / (self.normal_force + second.normal_force))
    }

    /// Lateral force of all contacts of the wheel on the rail, in the plane of the track \[N\].
    pub fn whole_track_lateral_force(&self) -> f64 {
        self.track_lateral_force + self.second_contact.map_or(0.0, |second| second.track_lateral_force)
    }

    /// This wheel described from its second contact point, with the first as its second; `None` if it touches at one point.
    pub fn from_second_contact(self) -> Option<Self> {
        let other = self.second_contact?;
        Some(Self {
            creepages: other.creepages,
            contact_angle: other.contact_angle,
            rolling_radius: other.rolling_radius,
            lateral_curvature: other.lateral_curvature,
            normal_force: other.normal_force,
            creep_forces: other.creep_forces,
            track_lateral_force: other.track_lateral_force,
            tractive_ratio: other.tractive_ratio,
            t_gamma: other.t_gamma,
            second_contact: Some(self.contact()),
            ..self
        })
    }

    /// What a second contact has, of the first one.
    fn contact(&self) -> SecondContact {
        SecondContact {
            creepages: self.creepages,
            contact_angle: self.contact_angle,
            rolling_radius: self.rolling_radius,
            lateral_curvature: self.lateral_curvature,
            normal_force: self.normal_force,
            creep_forces: self.creep_forces,
            track_lateral_force: self.track_lateral_force,
            tractive_ratio: self.tractive_ratio,
            t_gamma: self.t_gamma,
        }
    }

    /// The state of two contacts, that of the smaller angle first.
    pub(super) fn joined(self, other: Self) -> Self {
        let (first, second) = match self.contact_angle <= other.contact_angle {
            true => (self, other),
            false => (other, self),
        };
        Self { second_contact: Some(second.contact()), ..first }
    }
}

/// A frame in equilibrium; forces and moments are those on the frame.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct FrameState {
    /// Lateral shift \[m\] from the middle of the chord between the axles; of a lone wheelset from the centre line.
    pub lateral_shift: f64,
    /// Yaw \[rad\] from the tangent in the middle.
    pub yaw: f64,
    /// Lateral inertial force \[N\] of the frame and all it carries but a body.
    pub inertial_lateral_force: f64,
    /// Lateral force of the secondary suspension \[N\], zero without a body.
    pub secondary_lateral_force: f64,
    /// Yaw moment of the secondary suspension \[N m\], zero without a body.
    pub secondary_yaw_moment: f64,
}

/// The body of a vehicle in equilibrium.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct BodyState {
    /// Lateral shift \[m\] from the middle of the chord between the bogies.
    pub lateral_shift: f64,
    /// Yaw \[rad\] from the tangent in the middle of the vehicle.
    pub yaw: f64,
    /// Lateral inertial force of the body \[N\].
    pub inertial_lateral_force: f64,
}

/// One step of the way from straight track to the curve.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct ContinuationStep {
    /// Share of curvature, uncompensated acceleration, torques and yaw moment \[-\].
    pub fraction: f64,
    /// Largest residual over the load of a wheel \[-\].
    pub residual: f64,
    /// Newton steps.
    pub iterations: usize,
}

/// A vehicle in equilibrium.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct VehicleState {
    /// The wheelsets; the first leads.
    pub wheelsets: Vec<WheelsetState>,
    /// The wheels: 1 left, 1 right, 2 left, 2 right and so on.
    pub wheels: Vec<WheelState>,
    /// The frames; the first leads.
    pub frames: Vec<FrameState>,
    /// The body on two bogies.
    pub body: Option<BodyState>,
    /// Lateral acceleration that the cant leaves \[m/s²\], positive outward.
    pub uncompensated_acceleration: f64,
    /// Acceleration into the plane of the track \[m/s²\].
    pub normal_acceleration: f64,
    /// Power of friction in the contacts, V Σ Tγ \[W\].
    pub frictional_power: f64,
    /// Power of the torques Σ Ω T \[W\].
    pub drive_power: f64,
    /// Largest residual of force, or of moment over its arm, over the static load of a wheel \[-\].
    pub residual: f64,
    /// The way from straight track; empty for a state found from another start.
    pub continuation: Vec<ContinuationStep>,
}

impl VehicleState {
    /// Resistance of the curve \[N\]: frictional less drive power, over the speed \[m/s\].
    pub fn curving_resistance(&self, speed: f64) -> f64 {
        (self.frictional_power - self.drive_power) / speed
    }
}
