//! What a stress is measured by.

/// Stresses xx, yy, zz, xy, yz, zx, tension positive.
pub type StressTensor = [f64; 6];

/// A measure of how near a stress is to yield.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StressMeasure {
    /// √(3 J₂): √3 k at yield.
    VonMises,
    /// The largest shear stress: k at yield.
    Tresca,
}

impl StressMeasure {
    /// Both.
    pub const ALL: [Self; 2] = [Self::VonMises, Self::Tresca];

    /// Name in documents.
    pub fn name(self) -> &'static str {
        match self {
            Self::VonMises => "von-mises",
            Self::Tresca => "tresca",
        }
    }

    /// That of a stress, in its unit.
    pub fn of(self, stress: &StressTensor) -> f64 {
        match self {
            Self::VonMises => (3.0 * second_invariant(stress)).sqrt(),
            Self::Tresca => {
                // Principal stresses of the deviator: 2√(J₂/3) cos(θ − 2πi/3), cos 3θ = (3√3/2) J₃/J₂^(3/2).
                let j2 = second_invariant(stress);
                if j2 <= 0.0 {
                    return 0.0;
                }
                let mean = (stress[0] + stress[1] + stress[2]) / 3.0;
                let [x, y, z] = [stress[0] - mean, stress[1] - mean, stress[2] - mean];
                let [xy, yz, zx] = [stress[3], stress[4], stress[5]];
                let j3 = x * (y * z - yz * yz) - xy * (xy * z - yz * zx) + zx * (xy * yz - y * zx);
                let cosine = 1.5 * 3f64.sqrt() * j3 / j2.powf(1.5);
                let angle = cosine.clamp(-1.0, 1.0).acos() / 3.0;
                let third = std::f64::consts::FRAC_PI_3;
                // Largest less smallest: cos θ − cos(θ + 2π/3) = √3 sin(θ + π/3).
                j2.sqrt() * (angle + third).sin()
            }
        }
    }

    /// How that of von Mises follows a change of the stress.
    pub(crate) fn slope(self, stress: &StressTensor, change: &StressTensor) -> f64 {
        let mean = (stress[0] + stress[1] + stress[2]) / 3.0;
        let normal: f64 = (0..3).map(|i| (stress[i] - mean) * change[i]).sum();
        let shear: f64 = (3..6).map(|i| 2.0 * stress[i] * change[i]).sum();
        1.5 * (normal + shear) / self.of(stress)
    }
}

/// J₂ of the deviator.
fn second_invariant(stress: &StressTensor) -> f64 {
    let [x, y, z, xy, yz, zx] = *stress;
    ((x - y).powi(2) + (y - z).powi(2) + (z - x).powi(2)) / 6.0 + xy * xy + yz * yz + zx * zx
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Tension has σ and σ/2, pure shear √3 τ and τ, pressure from all sides nothing.
    #[test]
    fn of_simple_stresses() {
        for (stress, mises, tresca) in [
            ([2.0, 0.0, 0.0, 0.0, 0.0, 0.0], 2.0, 1.0),
            ([0.0, 0.0, 0.0, 0.0, 0.0, 1.5], 1.5 * 3f64.sqrt(), 1.5),
            ([-1.0, -1.0, -1.0, 0.0, 0.0, 0.0], 0.0, 0.0),
            ([1.0, 3.0, 0.0, 0.0, 0.0, 0.0], 7f64.sqrt(), 1.5),
        ] {
            assert!((StressMeasure::VonMises.of(&stress) - mises).abs() < 1e-14);
            assert!((StressMeasure::Tresca.of(&stress) - tresca).abs() < 1e-14);
        }
    }
}
