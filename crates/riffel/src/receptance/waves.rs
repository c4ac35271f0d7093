//! Waves of an endless rail, and the displacement they carry away from a force.

use num_complex::Complex64;

use riffel_numerics::square_root::square_root;

/// A wave of unit amplitude leaving x = 0 like e^{−αx}, and how strongly a force excites it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct Wave {
    /// α \[1/m\]: Re α > 0, or Re α = 0 for a wave without loss, which then carries energy away.
    pub propagation: Complex64,
    /// Displacement per force at the force \[m/N\].
    pub amplitude: Complex64,
}

/// The waves that a force sends out both ways along an endless rail on an even foundation:
/// displacement per force at the distance x is Σ A_j e^{−α_j x}.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Waves {
    /// A bar, in its own direction.
    Bar(Wave),
    /// A beam, across its direction: two waves.
    Beam {
        /// The waves.
        waves: [Wave; 2],
        /// q₀ \[1/(N m²)\] and q₁ \[1/N\] of A_jα_j(α_j² − α_i²) = q₀ + q₁α_j², i the other wave. Without a
        /// foundation the amplitudes tend to infinity as ω → 0, and these do not.
        transfer: [Complex64; 2],
    },
}

impl Waves {
    /// The waves.
    pub fn as_slice(&self) -> &[Wave] {
        match self {
            Self::Bar(wave) => std::slice::from_ref(wave),
            Self::Beam { waves, .. } => waves,
        }
    }
}

/// A rail that carries waves along itself: a beam, or a bar.
pub trait Waveguide: Send + Sync {
    /// Mass per length \[kg/m\].
    fn mass_per_length(&self) -> f64;

    /// Waves at the angular frequency ω > 0 \[rad/s\] on an even foundation of the dynamic stiffness
    /// κ \[N/m²\] per metre; zero where there is none. The sum over the waves loses digits where two
    /// of them coincide, which only an undamped foundation can bring about.
    fn waves(&self, angular_frequency: f64, foundation: Complex64) -> Waves;

    /// Displacement at the force, per force \[m/N\], without the loss of digits of the sum.
    fn point_receptance(&self, angular_frequency: f64, foundation: Complex64) -> Complex64;
}

/// The root α = √z that decays away from its force, or, without loss, the limit of vanishing damping:
/// `damped` is dz/dκ, the direction in which z moves with Im κ, asked for only there.
#[inline]
pub(super) fn outgoing(z: Complex64, damped: impl Fn() -> Complex64) -> Complex64 {
    /// A thousand roundings: an imaginary part below is noise beside the real part.
    const NOISE: f64 = 1e-13;
    if z.re < 0.0 && z.im.abs() <= NOISE * -z.re {
        // z = −k² ± i0: α = ±ik.
        let travelling = Complex64::new(0.0, (-z.re).sqrt());
        // dz = i·damped·d(Im κ), so the sign of Im dz is that of Re dz/dκ.
        return if damped().re >= 0.0 { travelling } else { -travelling };
    }
    square_root(z)
}
