//! Wheel, track and contact of a march.

use std::sync::Arc;

use super::{HertzSpring, ImpulseResponse, LateContact, March};
use crate::Error;
use crate::contact::{ContactFilter, CreepLaw, Creepages, MeanRolling};

/// How the wheel turns under the creep force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Turning {
    /// As a rigid body under a constant torque of the drive, I dΩ/dt = (Q − Q₀)R, equation (15): the creep force keeps
    /// its mean, and the creepage finds its own.
    Inertia {
        /// I_w \[kg m²\].
        inertia: f64,
        /// R \[m\].
        rolling_radius: f64,
    },
    /// Evenly: the creepage is constant, and the creep force finds its mean.
    Held,
}

/// One wheel on a track, at one speed.
///
/// * Track: displacement u_r = ∫ g(t − τ) (P − P₀) dτ from its position under the load at rest; on discrete supports g is
///   that of the place where the wheel is at τ, and P₀ ΣĤ_n(0) e^{inΩt}, n ≠ 0, the sag between supports, is added.
/// * Wheel: a rigid mass under a dead load, m_w d²z_w/dt² = P₀ − P, with z_w downward.
/// * Contact: δ = δ₀ + z_w − u_r + r for a profile of height r, P = C_H δ^{3/2} or none.
/// * Creep: Q of a steady law at the P and ξ of the instant or what a contact that answers late feels of them, none without contact; dξ/dt = −(R²/I_wV)(Q − Q₀).
///
/// Both means follow of themselves: a wheel that goes on rolling has the mean normal force P₀, and one with inertia the
/// mean creep force Q₀. Range of validity: that of the steady law, waves much longer than the patch, unless the contact answers
/// [late](LateContact); the profile is averaged over the patch only by a contact filter; a wheel without a suspension of its own, so above some 10 Hz.
#[derive(Clone)]
pub struct PassageModel {
    /// The track.
    pub track: ImpulseResponse,
    /// Unsprung mass m_w \[kg\].
    pub wheel_mass: f64,
    /// The contact.
    pub spring: HertzSpring,
    /// The creep law.
    pub law: Arc<dyn CreepLaw>,
    /// What of load and creepage the law is asked about, where the contact answers late.
    pub late: Option<Arc<LateContact>>,
    /// The mean of the profile over the patch that the wheel feels in the place of its height, H = sin(ka)/(ka); none for a contact
    /// in a point.
    pub contact_filter: Option<ContactFilter>,
    /// The wheel's rotation.
    pub turning: Turning,
    /// The mean state, at which a march begins.
    pub mean: MeanRolling,
    /// Speed V \[m/s\].
    pub speed: f64,
}

impl PassageModel {
    /// A march from steady rolling on, in steps of the given length \[m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless step, speed, mass and inertia are positive.
    pub fn march(&self, step: f64) -> Result<March<'_>, Error> {
        self.march_before(step, 0.0)
    }

    /// The same march from a distance before one of the supports on \[m\], where they are discrete.
    ///
    /// # Errors
    /// Those of [`march`](Self::march).
    pub fn march_before(&self, step: f64, distance: f64) -> Result<March<'_>, Error> {
        Error::unless_positive("step", step, "m")?;
        Error::unless_positive("speed", self.speed, "m/s")?;
        Error::unless_positive("mass", self.wheel_mass, "kg")?;
        if let Turning::Inertia {
            inertia,
            rolling_radius,
        } = self.turning
        {
            Error::unless_positive("inertia", inertia, "kg m2")?;
            Error::unless_positive("rolling radius", rolling_radius, "m")?;
        }
        Ok(March::new(self, step, distance))
    }

    /// Q of the steady law \[N\]; none without a load.
    pub(super) fn steady_force(&self, normal_force: f64, creepage: f64) -> f64 {
        if normal_force <= 0.0 {
            return 0.0;
        }
        let creepages = Creepages::longitudinal(creepage);
        self.law.forces(normal_force, creepages).longitudinal
    }
}
