//! Track, wheels and contacts of a march on all axes.

use std::sync::Arc;

use super::{GeneralMarch, StructuresInTime};
use crate::contact::{CreepLaw, MeanRolling};
use crate::passage::HertzSpring;
use crate::Error;

/// A contact of a wheel with a rail in time.
#[derive(Clone)]
pub struct ContactInTime {
    /// The spring along its normal.
    pub spring: HertzSpring,
    /// The creep law.
    pub law: Arc<dyn CreepLaw>,
    /// The mean state, at which a march begins.
    pub mean: MeanRolling,
    /// Distance along the rail \[m\], zero for the first wheel, negative behind it.
    pub along: f64,
    /// The profile under it over that of the rail under study.
    pub profile: f64,
    /// Along the rail and across it: true where the creepage is held.
    pub held: [bool; 2],
}

/// The loop of [`GeneralLoop`](crate::feedback::GeneralLoop) in time, at one speed.
///
/// * Displacements u = ∫ g(t − τ) (f − f₀) dτ of track and wheels together, f = (Q_x, Q_t, P) at all contacts, from
///   their position under the mean forces.
/// * Normal: δ = δ₀ − u_n + r for a profile of height r along the normal, P = C_H δ^{3/2} or none.
/// * Creep: (ξ, η) = (ξ₀, η₀) − (du_x/dt, du_t/dt)/V; forces of a steady law at the P and creepages of the instant; spin as in the mean
///   state.
///
/// Signs and axes are those of the linear loop. Mean forces follow of themselves where nothing holds a wheel: one that turns
/// freely keeps its mean longitudinal force, and its creepage finds its own.
/// Range of validity: that of the steady law, waves much longer than the patch; an even track; the contact angle stays.
#[derive(Clone)]
pub struct GeneralPassage {
    /// Track and wheels.
    pub structures: StructuresInTime,
    /// Contacts in the order of the loop, that of the first wheel on the rail under study first.
    pub contacts: Vec<ContactInTime>,
    /// Speed V \[m/s\].
    pub speed: f64,
}

impl GeneralPassage {
    /// A march from steady rolling on, in steps of the given length \[m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless step and speed are positive.
    pub fn march(&self, step: f64) -> Result<GeneralMarch<'_>, Error> {
        Error::unless_positive("step", step, "m")?;
        Error::unless_positive("speed", self.speed, "m/s")?;
        Ok(GeneralMarch::new(self, step))
    }
}
