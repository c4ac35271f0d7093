//! How near a contact is to flow, and how that follows the forces and the curvature of a wave.

use num_complex::Complex64;

use super::ShakedownLimit;
use crate::contact::{MeanRolling, WaveGeometry};
use crate::{Error, HertzContact};

/// The demand u = p₀/(k S(f)) of a mean state, f = |Q|/P, and its slopes: the pressure follows P^(1/3). What is above one flows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Demand {
    /// p₀ \[Pa\].
    pub contact_pressure: f64,
    /// k \[Pa\].
    pub shear_yield: f64,
    /// What the pressure is measured against.
    pub limit: ShakedownLimit,
    /// P \[N\].
    pub load: f64,
    /// f \[-\].
    pub utilised_friction: f64,
    /// u \[-\].
    pub value: f64,
    /// ∂u/∂P \[1/N\].
    pub by_load: f64,
    /// ∂u/∂Q \[1/N\], along and across the rail.
    pub by_force: [f64; 2],
    /// ∂u/∂κ \[-\] of the curvature of a wave; zero where its own geometry has no part.
    pub by_curvature: f64,
    /// FI_surf = f − k/p₀ (Ekberg, Kabo & Andersson 2002, recalled).
    pub fatigue_index: f64,
    /// Its slope over P \[1/N\].
    pub fatigue_index_by_load: f64,
    /// Its slopes over Q \[1/N\].
    pub fatigue_index_by_force: [f64; 2],
    /// Its slope over κ \[-\].
    pub fatigue_index_by_curvature: f64,
    /// Direction of the force along and across the rail.
    direction: [f64; 2],
}

impl Demand {
    /// That of a mean state under a largest pressure p₀ \[Pa\], of a rail that yields under the shear k \[Pa\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless pressure and yield are above zero, and for the surface as limit without tangential force.
    pub fn new(
        steady: &MeanRolling,
        contact_pressure: f64,
        shear_yield: f64,
        limit: ShakedownLimit,
    ) -> Result<Self, Error> {
        Error::unless_positive("contact pressure", contact_pressure, "Pa")?;
        Error::unless_positive("shear yield", shear_yield, "Pa")?;
        let forces = [steady.forces.longitudinal, steady.forces.lateral];
        let (load, force) = (steady.normal_force, forces[0].hypot(forces[1]));
        let friction = force / load;
        if limit == ShakedownLimit::Surface {
            Error::unless_positive("utilised friction", friction, "")?;
        }
        let direction = match force > 0.0 {
            true => forces.map(|part| part / force),
            false => [1.0, 0.0],
        };
        let [allowed, slope] = limit.at(friction);
        let value = contact_pressure / (shear_yield * allowed);
        let index = shear_yield / contact_pressure;
        Ok(Self {
            contact_pressure,
            shear_yield,
            limit,
            load,
            utilised_friction: friction,
            value,
            by_load: value * (1.0 / 3.0 + slope * friction) / load,
            by_force: direction.map(|part| -value * slope * part / load),
            by_curvature: 0.0,
            fatigue_index: friction - index,
            fatigue_index_by_load: (index / 3.0 - friction) / load,
            fatigue_index_by_force: direction.map(|part| part / load),
            fatigue_index_by_curvature: 0.0,
            direction,
        })
    }

    /// Demand under waves whose geometry has a part: over a crest the patch is that of the smaller radius R/(1 + κ), p₀ rises by c κ and
    /// with a/b what the ellipse may carry changes. `limit` is that of a contact.
    ///
    /// # Errors
    /// Errors of [`HertzContact::curved`].
    pub fn on_waves(self, hertz: HertzContact, limit: impl Fn(HertzContact) -> ShakedownLimit) -> Result<Self, Error> {
        /// A search for the largest stress leaves 10⁻⁹ of it.
        const STEP: f64 = 1e-2;
        let by_pressure = hertz.pressure_by_curvature()?;
        let by_limit = match self.limit {
            ShakedownLimit::Line | ShakedownLimit::Surface => 0.0,
            ShakedownLimit::Elastic { .. } | ShakedownLimit::Subsurface { .. } => {
                let ln = |curvature| {
                    let limit = limit(hertz.curved(curvature)?);
                    Ok::<_, Error>([limit.at(self.utilised_friction)[0].ln()])
                };
                WaveGeometry::derivative(STEP, ln)?[0]
            }
        };
        Ok(Self {
            by_curvature: self.value * (by_pressure - by_limit),
            fatigue_index_by_curvature: by_pressure * self.shear_yield / self.contact_pressure,
            ..self
        })
    }

    /// X₀ = u − 1.
    pub fn excess(&self) -> f64 {
        self.value - 1.0
    }

    /// Share of the force along the rail, with its sign: one where it pushes the rail forward, as in braking.
    pub fn along(&self) -> f64 {
        self.direction[0]
    }

    /// u₁ of oscillating forces Q along, Q across and P \[N\]; waves add [`by_curvature`](Self::by_curvature).
    pub fn oscillation(&self, force: [Complex64; 3]) -> Complex64 {
        force[2] * self.by_load + force[0] * self.by_force[0] + force[1] * self.by_force[1]
    }

    /// FI₁ of these forces and of a curvature κ.
    pub fn fatigue_index_oscillation(&self, force: [Complex64; 3], curvature: Complex64) -> Complex64 {
        curvature * self.fatigue_index_by_curvature
            + force[2] * self.fatigue_index_by_load
            + force[0] * self.fatigue_index_by_force[0]
            + force[1] * self.fatigue_index_by_force[1]
    }
}
