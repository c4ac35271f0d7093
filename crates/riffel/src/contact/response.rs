//! Linear response of a rolling contact.

use num_complex::Complex64;

/// Linear response of a rolling contact at one wavelength.
///
/// Complex, because a non-steady contact answers late; a quasi-static one has no imaginary part.
/// Dissipation is the energy e = W/V left on a metre of rail \[J/m\]: unlike the power W it does not
/// depend on speed, so neither does any of the four derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactResponse {
    /// ∂Q/∂P at constant creepage \[-\].
    pub dq_dp: Complex64,
    /// ∂Q/∂ξ at constant normal force \[N\].
    pub dq_dxi: Complex64,
    /// ∂e/∂P at constant creepage \[m/m\].
    pub de_dp: Complex64,
    /// ∂e/∂ξ at constant normal force \[J/m\].
    pub de_dxi: Complex64,
    /// The energy that a point of the rail receives, where the contact resolves its patch; none where
    /// the place of wear is a joint of its own.
    pub at_rail: Option<RailDissipation>,
}

/// Energy left at a point of the rail over the whole passage of the patch, relative to the input at the
/// instant at which the wheel centre passes the point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RailDissipation {
    /// ∂e/∂P at constant creepage \[m/m\].
    pub de_dp: Complex64,
    /// ∂e/∂ξ at constant normal force \[J/m\].
    pub de_dxi: Complex64,
}

impl ContactResponse {
    /// The energy that a point of the rail receives: as the contact resolves it, or that at the wheel
    /// centre later by an angle \[rad\].
    pub fn at_rail(&self, lag: f64) -> RailDissipation {
        self.at_rail.unwrap_or_else(|| {
            let phase = Complex64::cis(-lag);
            RailDissipation {
                de_dp: self.de_dp * phase,
                de_dxi: self.de_dxi * phase,
            }
        })
    }
}
