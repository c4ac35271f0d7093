//! Steady rolling of a patch of any shape.

use super::influence::Influence;
use super::patch::Patch;
use super::{NormalState, REMEDY, steady};
use crate::contact::{CreepForces, Creepages};
use crate::{ElasticMaterial, Error};

/// Kalker's exact theory of steady rolling on a patch of any shape: two elastic half-spaces of one material, the pressure of
/// a [`NormalState`], Coulomb friction of a coefficient that may differ from place to place.
///
/// Method: that of [`HalfSpace`](super::HalfSpace) on the elements under pressure: semismooth Newton, 1e-6 of the
/// tractions. Errors are of first order in the size of an element; two grids, n and n/2, give 2·fine − coarse. Cost: grows
/// with the number of elements under pressure, most where little slips.
///
/// Source: Kalker (1990), *Three-dimensional elastic bodies in rolling contact*. Range of validity: one material, flat
/// patches, bodies much larger than these; x along the direction of rolling, y and the spin about the normal of
/// [`Creepages`], slip of the rigid bodies (ξ − φy, η + φx) with x, y of the grid.
pub struct PatchRolling {
    patch: Patch,
    influence: Influence,
    bound: Vec<f64>,
}

impl PatchRolling {
    /// A patch under its pressures; `friction` is the coefficient μ \[-\] at a place (x, y) of the grid \[m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if a coefficient is not positive, or nothing is under pressure.
    pub fn new(
        material: ElasticMaterial,
        state: &NormalState,
        friction: impl Fn(f64, f64) -> f64,
    ) -> Result<Self, Error> {
        let patch = Patch::under_pressure(state);
        Error::unless_positive("normal load", state.load(), "N")?;
        let pressures = state.pressures().iter().filter(|pressure| **pressure > 0.0);
        let bound = patch
            .centres
            .iter()
            .zip(pressures)
            .map(|(&(x, y), pressure)| {
                let friction = friction(x, y);
                Error::unless_positive("coefficient of friction", friction, "")?;
                Ok(friction * pressure)
            });
        Ok(Self {
            bound: bound.collect::<Result<_, Error>>()?,
            influence: Influence::new(material, &patch),
            patch,
        })
    }

    /// Steady rolling: creep forces \[N\], their moment about the normal in the middle of the grid \[Nm\], and the share of the
    /// area that slips \[-\].
    ///
    /// # Errors
    /// [`Error::NotConverged`].
    pub fn roll(&self, creepages: Creepages) -> Result<(CreepForces, f64, f64), Error> {
        let slip = steady::solve(&self.patch, &self.influence, creepages, &self.bound, None)
            .map_err(|residual| Error::NotConverged {
                problem: "steady rolling",
                residual,
                tolerance: steady::TOLERANCE,
                remedy: REMEDY,
            })?;
        let slipping = slip.slips.iter().filter(|slips| **slips).count();
        Ok((
            self.patch.forces(&slip.tractions),
            self.patch.moment(&slip.tractions),
            slipping as f64 / self.patch.len() as f64,
        ))
    }
}
