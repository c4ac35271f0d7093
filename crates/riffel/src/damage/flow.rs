//! Plastic flow to the sides of the rail.

use num_complex::Complex64;

use super::{ClippedPower, Demand};

/// h = H E⟨X⟩^m per passage, X = u − 1: material leaves sideways where the demand is above shakedown, and troughs deepen
/// if it peaks in them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flow {
    /// H \[m\].
    pub depth: f64,
    /// ⟨X⟩^m over the spread of loads.
    pub law: ClippedPower,
    /// D_h \[m\]: outflow by which hardening uses up a demand of one; `None` if flow goes on.
    pub hardening_depth: Option<f64>,
}

impl Flow {
    /// h₁ \[m\] of the demand u₁ of a wave, which is multiplied by a rate.
    pub(super) fn depth_1(&self, oscillation: Complex64, rate: f64) -> Complex64 {
        oscillation * (self.depth * rate)
    }

    /// Mean depth \[m\] per passage.
    pub fn mean_depth(&self, demand: &Demand, oscillation: Complex64) -> f64 {
        self.depth * self.law.depth(demand.excess(), oscillation.norm())
    }

    /// The runaway number −D_h Re(u₁/Δ): above one the wave outgrows hardening; below, it ends at r₀ over the complex number
    /// 1 + D_h u₁/Δ, exact while no point falls below the limit. `gain` is u₁/Δ \[1/m\].
    pub fn hardened(&self, gain: Complex64) -> Option<(f64, Complex64)> {
        let depth = self.hardening_depth?;
        Some((-depth * gain.re, (1.0 + depth * gain).inv()))
    }
}
