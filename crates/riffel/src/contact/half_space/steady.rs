//! Steady rolling: tractions, stick and slip.

use super::friction::{Friction, Slip};
use super::influence::Influence;
use super::patch::{Field, Patch};

/// Residual of the friction law, see [`Friction`].
pub(super) const TOLERANCE: f64 = 1e-6;

/// Steady rolling under a slip of the rigid bodies over each step of the material \[m\], [`rigid_slip`], and traction bounds
/// \[Pa\], from the tractions `start`; the residual reached if it does not converge.
///
/// Over the distance dx of one element a place of the patch passes on to the next part of the
/// material: S = c dx − (u(x) − u(x + dx)) with the rigid slip c.
pub(super) fn solve(
    patch: &Patch,
    influence: &Influence,
    rigid_slip: &Field<f64>,
    bound: &[f64],
    start: Option<&Field<f64>>,
) -> Result<Slip, f64> {
    let friction = Friction {
        patch,
        influence,
        operator: [1.0, -1.0],
        forcing: rigid_slip,
        bound,
        compliance: influence.own,
        tolerance: TOLERANCE,
    };
    let nothing = || [vec![0.0; patch.len()], vec![0.0; patch.len()]];
    friction.solve(&start.cloned().unwrap_or_else(nothing))
}

/// x and y part of the slip of the rigid bodies over each step of the material \[m\], of a slip c per distance rolled \[-\] at a
/// place \[m\].
pub(super) fn rigid_slip(patch: &Patch, slip: impl Fn(f64, f64) -> [f64; 2]) -> Field<f64> {
    let slips = patch.steps.iter().map(|step| {
        let (x, y) = step.middle;
        slip(x, y)
    });
    let slips: Vec<[f64; 2]> = slips.collect();
    [0, 1].map(|part| slips.iter().map(|slip| patch.dx * slip[part]).collect())
}
