//! Steady rolling of a patch of any shape.

use super::influence::Influence;
use super::patch::{Field, Patch};
use super::{NormalState, REMEDY, steady};
use crate::{ElasticMaterial, Error};

/// Kalker's exact theory of steady rolling on a patch of any shape: two elastic half-spaces of one material, the pressure of
/// a [`NormalState`], Coulomb friction of a coefficient that may differ from place to place.
///
/// Method: that of [`HalfSpace`](super::HalfSpace) on the elements under pressure: semismooth Newton, 1e-6 of the
/// tractions. Errors are of first order in the size of an element; two grids, n and n/2, give 2·fine − coarse. Cost: grows
/// with the number of elements under pressure, most where little slips.
///
/// Source: Kalker (1990), *Three-dimensional elastic bodies in rolling contact*. Range of validity: one material, flat
/// patches, bodies much larger than these; x along the direction of rolling, y across, to the right.
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
        let bound = patch.centres.iter().zip(pressures).map(|(&(x, y), pressure)| {
            let friction = friction(x, y);
            Error::unless_positive("coefficient of friction", friction, "")?;
            Ok(friction * pressure)
        });
        Ok(Self { bound: bound.collect::<Result<_, Error>>()?, influence: Influence::new(material, &patch), patch })
    }

    /// Steady rolling under a slip of the rigid bodies along and across per metre rolled \[-\] at a place of the grid \[m\]:
    /// [`Creepages::rigid_slip`](crate::contact::Creepages::rigid_slip) on a flat patch.
    ///
    /// # Errors
    /// [`Error::NotConverged`].
    pub fn roll(&self, slip: impl Fn(f64, f64) -> [f64; 2]) -> Result<PatchTractions<'_>, Error> {
        let rigid_slip = steady::rigid_slip(&self.patch, slip);
        let slip = steady::solve(&self.patch, &self.influence, &rigid_slip, &self.bound, None).map_err(|residual| {
            Error::NotConverged { problem: "steady rolling", residual, tolerance: steady::TOLERANCE, remedy: REMEDY }
        })?;
        Ok(PatchTractions { patch: &self.patch, tractions: slip.tractions })
    }
}

/// Tractions of a [`PatchRolling`].
pub struct PatchTractions<'a> {
    patch: &'a Patch,
    tractions: Field<f64>,
}

impl PatchTractions<'_> {
    /// Centres (x, y) \[m\] of the elements and the forces on them along and across \[N\].
    pub fn forces(&self) -> impl Iterator<Item = ((f64, f64), [f64; 2])> {
        let centres = self.patch.centres.iter().enumerate();
        centres.map(|(index, &centre)| {
            let force = |part: usize| self.patch.area() * self.tractions[part][index];
            (centre, [force(0), force(1)])
        })
    }
}
