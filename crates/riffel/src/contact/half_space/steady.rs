//! Steady rolling: tractions, stick and slip.

use super::friction::{Friction, Slip};
use super::influence::{Field, Influence};
use super::patch::Patch;

/// Residual of the friction law, see [`Friction`].
pub(super) const TOLERANCE: f64 = 1e-6;

/// Creepages \[-\] and spin \[rad/m\].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Rigid {
    pub(super) longitudinal: f64,
    pub(super) lateral: f64,
    pub(super) spin: f64,
}

/// Steady rolling at these creepages under traction bounds \[Pa\], from the tractions `start`; the
/// residual reached if it does not converge.
///
/// Over the distance dx of one element a place of the patch passes on to the next part of the
/// material: S = c dx − (u(x) − u(x + dx)) with the rigid slip c = (ξ − φy, η + φx).
pub(super) fn solve(
    patch: &Patch,
    influence: &Influence,
    rigid: Rigid,
    bound: &[f64],
    start: Option<&Field<f64>>,
) -> Result<Slip, f64> {
    let forcing = rigid.over_a_step(patch);
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

impl Rigid {
    /// x and y part of the rigid slip of each step of the material \[m\].
    pub(super) fn over_a_step(self, patch: &Patch) -> Field<f64> {
        let slip = |step: &super::patch::Step| {
            let (x, y) = step.middle;
            [
                patch.dx * (self.longitudinal - self.spin * y),
                patch.dx * (self.lateral + self.spin * x),
            ]
        };
        [0, 1].map(|part| patch.steps.iter().map(|step| slip(step)[part]).collect())
    }
}
