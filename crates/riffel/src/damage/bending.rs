//! Rails that keep a part of their bending.

use num_complex::Complex64;

use super::ClippedPower;

/// A rail under a wheel bends by M = P/4β(ω); where that exceeds a limit it keeps the curvature κ_p = B E⟨M/M_lim − 1⟩^m of each
/// passage, as far as it does not lie on its springs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bending {
    /// M_lim \[N m\]: the plastic moment, for residual stress does not change what collapses by increments.
    pub limit: f64,
    /// B \[1/m\].
    pub curvature: f64,
    /// ⟨·⟩^m over the spread of loads.
    pub law: ClippedPower,
    /// E I \[N m²\].
    pub bending_stiffness: f64,
    /// K₀ \[N/m²\], static stiffness of what carries the rail, per length.
    pub foundation: f64,
    /// M₀ \[N m\] under the mean load.
    pub mean_moment: f64,
}

impl Bending {
    /// M₀ \[N m\] under a load \[N\] on a rail of the stiffness EI \[N m²\] on even springs K₀ \[N/m²\].
    pub fn moment_at_rest(load: f64, bending_stiffness: f64, foundation: f64) -> f64 {
        let root = (foundation / (4.0 * bending_stiffness)).powf(0.25);
        load / (4.0 * root)
    }

    /// M₀/M_lim − 1.
    pub fn excess(&self) -> f64 {
        self.mean_moment / self.limit - 1.0
    }

    /// Moment per force \[m\] of a rail of the receptance H \[m/N\] = 1/8EIβ³: 1/4β on the branch that decays to both sides.
    pub fn moment_per_force(&self, receptance: Complex64) -> Complex64 {
        // β⁴ has a phase between 0 and π, H one between −3π/4 and 0: the principal root.
        0.25 * (8.0 * self.bending_stiffness * receptance).powf(1.0 / 3.0)
    }

    /// Share of the kept curvature of a wave that an unloaded rail keeps on its springs: EIk⁴/(EIk⁴ + K₀).
    pub fn freedom(&self, wavenumber: f64) -> f64 {
        let rail = self.bending_stiffness * wavenumber.powi(4);
        rail / (rail + self.foundation)
    }

    /// Whether a load \[N\] over a receptance \[m/N\] bends the rail beyond the limit anywhere along its wave, or by the spread.
    pub(crate) fn may_yield(&self, load: Complex64, receptance: Complex64) -> bool {
        if self.law.is_spread() || self.excess() > 0.0 {
            return true;
        }
        // |M₁|³ = |P₁|³ 8EI|H|/64.
        let cube = load.norm_sqr().powi(3) * receptance.norm_sqr();
        let missing = -self.excess() * self.limit;
        cube * self.bending_stiffness.powi(2) >= 64.0 * missing.powi(6)
    }

    /// h₁ \[m\] of M₁/M_lim, which is multiplied by a rate.
    pub(super) fn depth_1(&self, oscillation: Complex64, wavenumber: f64, rate: f64) -> Complex64 {
        let curvature = oscillation * (self.curvature * rate);
        curvature * (self.freedom(wavenumber) / (wavenumber * wavenumber))
    }
}
