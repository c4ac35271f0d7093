//! Plastic flow along the rail.

use num_complex::Complex64;

use super::{ClippedPower, Demand};

/// J = J_r E⟨X⟩^m per passage in the direction of the force on the rail, forward in braking; the rail loses ∂J/∂x, which
/// keeps its volume.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlowAlong {
    /// J_r \[m²\].
    pub area: f64,
    /// ⟨X⟩^m over the spread of loads.
    pub law: ClippedPower,
}

impl FlowAlong {
    /// ik J₁ \[m\] of the demand u₁ of a wave of the wavenumber k \[rad/m\], which is multiplied by a rate: growth is k Im J₁/Δ.
    pub(super) fn depth_1(&self, demand: &Demand, oscillation: Complex64, wavenumber: f64, rate: f64) -> Complex64 {
        Complex64::I * oscillation * (wavenumber * self.area * rate * demand.along())
    }
}
