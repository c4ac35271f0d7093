//! Dynamic stiffness of a rail against waves.

use num_complex::Complex64;

/// Dynamic stiffness per metre of one motion of a rail against a wave e^{−αx}, as a function of z = α²:
/// lΠ(z − z_j)/(n₀ + n₁z).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct WaveStiffness {
    /// l.
    pub(super) leading: Complex64,
    /// z_j: those of waves that run or decay by themselves.
    pub(super) roots: [Complex64; 2],
    /// How many of them there are.
    pub(super) count: usize,
    /// n₀ and n₁.
    pub(super) denominator: [Complex64; 2],
}

impl WaveStiffness {
    /// z_j.
    pub(super) fn roots(&self) -> &[Complex64] {
        &self.roots[..self.count]
    }

    /// Π(z − z_j).
    pub(super) fn monic(&self, z: Complex64) -> Complex64 {
        self.roots().iter().map(|root| z - root).product()
    }

    /// n₀ + n₁z.
    pub(super) fn denominator(&self, z: Complex64) -> Complex64 {
        let [constant, linear] = self.denominator;
        constant + linear * z
    }
}
