//! Steady rolling: tractions, stick and slip.

use super::friction::{Friction, Slip};
use super::influence::{Field, Influence};
use super::patch::{Patch, Step};
use crate::contact::Creepages;

/// Residual of the friction law, see [`Friction`].
pub(super) const TOLERANCE: f64 = 1e-6;

/// Steady rolling at these creepages under traction bounds \[Pa\], from the tractions `start`; the
/// residual reached if it does not converge.
///
/// Over the distance dx of one element a place of the patch passes on to the next part of the
/// material: S = c dx − (u(x) − u(x + dx)) with the rigid slip c = (ξ − φy, η + φx).
pub(super) fn solve(
    patch: &Patch,
    influence: &Influence,
    creepages: Creepages,
    bound: &[f64],
    start: Option<&Field<f64>>,
) -> Result<Slip, f64> {
    let forcing = rigid_slip(patch, creepages);
    let friction = Friction {
        patch,
        influence,
        operator: [1.0, -1.0],
        forcing: &forcing,
        bound,
        compliance: influence.own,
        tolerance: TOLERANCE,
    };
    let nothing = || [vec![0.0; patch.len()], vec![0.0; patch.len()]];
    friction.solve(&start.cloned().unwrap_or_else(nothing))
}

/// x and y part of the rigid slip of each step of the material \[m\].
pub(super) fn rigid_slip(patch: &Patch, creepages: Creepages) -> Field<f64> {
    let slip = |step: &Step| {
        let (x, y) = step.middle;
        [
            patch.dx * (creepages.longitudinal - creepages.spin * y),
            patch.dx * (creepages.lateral + creepages.spin * x),
        ]
    };
    [0, 1].map(|part| patch.steps.iter().map(|step| slip(step)[part]).collect())
}
