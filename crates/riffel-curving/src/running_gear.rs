//! What holds the wheelsets of a vehicle: one frame, one bogie, or two bogies under a body.

use riffel::Error;

use super::Axle;

/// What holds the wheelsets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RunningGear {
    /// A lone wheelset in a frame that follows the track.
    Wheelset(FollowingFrame),
    /// A bogie of two wheelsets in a rigid frame.
    Bogie(BogieFrame),
    /// Two such bogies under one body.
    Vehicle {
        /// The frame of each bogie.
        bogies: BogieFrame,
        /// The body on both.
        body: Body,
    },
}

/// The frame over a lone wheelset: something else, such as a long vehicle, holds its yaw to the track.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FollowingFrame {
    /// Yaw from the tangent at the wheelset \[rad\].
    pub yaw: f64,
    /// Lateral shift at which it is held \[m\], so that what holds it takes its inertial force; none for a frame that is
    /// free across the track and leaves this force to the wheelset.
    pub held_at: Option<f64>,
}

/// A rigid frame that holds the axle boxes of two wheelsets by springs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BogieFrame {
    /// Distance of the axles 2a \[m\].
    pub wheelbase: f64,
    /// Moment on the frame about the vertical \[N m\], positive where it turns the nose to the right.
    pub yaw_moment: f64,
}

/// A rigid body on two bogies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body {
    /// Distance of the middles of the bogies 2l \[m\].
    pub bogie_spacing: f64,
    /// Mass m_c \[kg\], a part of what the four axles carry.
    pub mass: f64,
    /// Stiffness of the secondary suspension of a bogie across the track k_s \[N/m\].
    pub secondary_lateral_stiffness: f64,
    /// Stiffness of the secondary suspension of a bogie against yaw K_s \[N m/rad\].
    pub secondary_yaw_stiffness: f64,
}

/// What the body does to the frame of one bogie.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Secondary {
    /// Lateral force on the frame \[N\].
    pub(super) lateral_force: f64,
    /// Yaw moment on the frame \[N m\].
    pub(super) yaw_moment: f64,
}

impl RunningGear {
    /// Frames with unknowns of their own.
    pub(super) fn frames(&self) -> usize {
        match self {
            Self::Wheelset(_) => 0,
            Self::Bogie(_) => 1,
            Self::Vehicle { .. } => 2,
        }
    }

    /// Wheelsets, the first leads.
    pub fn wheelsets(&self) -> usize {
        match self {
            Self::Wheelset(_) => 1,
            Self::Bogie(_) => 2,
            Self::Vehicle { .. } => 4,
        }
    }

    pub(super) fn bogie(&self) -> Option<&BogieFrame> {
        match self {
            Self::Wheelset(_) => None,
            Self::Bogie(frame) | Self::Vehicle { bogies: frame, .. } => Some(frame),
        }
    }

    pub(super) fn body(&self) -> Option<&Body> {
        match self {
            Self::Vehicle { body, .. } => Some(body),
            _ => None,
        }
    }

    pub(super) fn check(&self, axle: &Axle) -> Result<(), Error> {
        if let Some(frame) = self.bogie() {
            Error::unless_positive("wheelbase", frame.wheelbase, "m")?;
        }
        let Some(body) = self.body() else {
            return Ok(());
        };
        Error::unless_positive("spacing of the bogies", body.bogie_spacing, "m")?;
        Error::unless_not_negative("mass of the body", body.mass, "kg")?;
        Error::unless_positive(
            "lateral stiffness of the secondary suspension",
            body.secondary_lateral_stiffness,
            "N/m",
        )?;
        Error::unless_not_negative(
            "yaw stiffness of the secondary suspension",
            body.secondary_yaw_stiffness,
            "N m/rad",
        )?;
        if body.mass > 4.0 * (axle.mass_per_axle - axle.wheelset_mass) {
            return Err(Error::OutOfRange {
                quantity: "mass of the body",
                value: body.mass,
                unit: "kg",
                rule: "must be at most four times the mass per axle less that of the wheelset, which include it",
            });
        }
        Ok(())
    }
}

impl Body {
    /// Shift \[m\] and yaw \[rad\] of a body under its inertial force F \[N\] on frames shifted by y₁, y₂ and yawed by ψ₁, ψ₂, and
    /// what it does to either frame in a curvature 1/R \[1/m\].
    ///
    /// The body is measured as a frame is: from the middle of the chord between the middles of the bogies, and from the
    /// tangent in the middle of the vehicle. With ± for the leading and the trailing bogie and l half their distance, forces
    /// k_s(y_c ± lψ_c − y) and moments K_s(ψ_c − ψ ∓ l/R) on the frames leave two linear equations of the body,
    /// F = Σk_s(y_c ± lψ_c − y) and Σ K_s(ψ_c − ψ) ± l k_s(y_c ± lψ_c − y) = 0, solved here: a force is F/2 and what
    /// turns the body, so that a soft suspension costs no digits.
    pub(super) fn on_frames(
        &self,
        inertial_force: f64,
        frames: [(f64, f64); 2],
        curvature: f64,
    ) -> (f64, f64, [Secondary; 2]) {
        let half = 0.5 * self.bogie_spacing;
        let (lateral, turning) = (self.secondary_lateral_stiffness, self.secondary_yaw_stiffness);
        let [(shift_1, yaw_1), (shift_2, yaw_2)] = frames;
        let yaw = (turning * (yaw_1 + yaw_2) + half * lateral * (shift_1 - shift_2))
            / (2.0 * turning + 2.0 * half * half * lateral);
        let shift = 0.5 * (shift_1 + shift_2) + 0.5 * inertial_force / lateral;
        // Half the difference of the forces that turn the body.
        let couple = 0.5 * lateral * (2.0 * half * yaw - (shift_1 - shift_2));
        let on = |sign: f64, frame_yaw: f64| Secondary {
            lateral_force: 0.5 * inertial_force + sign * couple,
            yaw_moment: turning * (yaw - frame_yaw - sign * half * curvature),
        };
        (shift, yaw, [on(1.0, yaw_1), on(-1.0, yaw_2)])
    }
}
