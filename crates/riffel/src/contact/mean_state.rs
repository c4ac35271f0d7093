//! The steady state about which corrugation is a small perturbation.

/// The steady rolling state about which corrugation is a small perturbation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeanRolling {
    /// Normal force P₀ \[N\].
    pub normal_force: f64,
    /// Coefficient of friction μ \[-\].
    pub friction: f64,
    /// Creepage ξ₀ = 1 − Ω₀R/V \[-\], positive in braking.
    pub creepage: f64,
    /// Tangential force Q₀ \[N\], positive with positive creepage.
    pub tangential_force: f64,
}

impl MeanRolling {
    /// Tractive ratio τ = Q₀/μP₀ \[-\].
    pub fn tractive_ratio(&self) -> f64 {
        self.tangential_force / (self.friction * self.normal_force)
    }

    /// Energy dissipated per metre of rail, e₀ = ξ₀Q₀ \[J/m\]; the power is W₀ = V e₀, equation (8).
    pub fn energy_per_metre(&self) -> f64 {
        self.creepage * self.tangential_force
    }

    /// The energy per metre μP₀ξ₀ \[J/m\] that makes Ŵ₁ of equation (20) dimensionless.
    ///
    /// This is the dissipation of full slip at the same creepage, 1/τ times
    /// [`energy_per_metre`](Self::energy_per_metre).
    pub fn full_slip_energy_per_metre(&self) -> f64 {
        self.friction * self.normal_force * self.creepage
    }
}
