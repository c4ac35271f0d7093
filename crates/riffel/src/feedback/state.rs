//! The loop at one wavelength and speed.

use num_complex::Complex64;

use super::contact::WaveState;
use crate::contact::ContactResponse;
use crate::damage::DamageState;

/// State of the loop at one wavelength and speed; complex amplitudes for exp(+iωt), relative to a profile
/// of real amplitude Δ under the first wheel.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct LoopState {
    /// Wavelength λ \[m\].
    pub wavelength: f64,
    /// Speed V \[m/s\].
    pub speed: f64,
    /// Angular frequency ω = 2πV/λ \[rad/s\].
    pub angular_frequency: f64,
    /// Receptance of the track at the first contact \[m/N\], in its axes x, t, n.
    pub track_receptance: [[Complex64; 3]; 3],
    /// Receptance of the wheel at the first contact \[m/N\], in its axes x, t, n.
    pub wheel_receptance: [[Complex64; 3]; 3],
    /// What the first contact answers.
    pub response: ContactResponse,
    /// Dissipated power W₁ at the first wheel \[W\].
    pub dissipation: Complex64,
    /// Angle by which the dissipation at a rail point lags W₁ \[rad\].
    pub dissipation_lag_angle: f64,
    /// Dissipated power at a rail point \[W\], first wheel.
    pub dissipation_at_rail: Complex64,
    /// Ŵ₁ = W₁/(μP₀V|ξ₀|) at a rail point \[-\], first wheel. Growth where its real part is negative.
    pub normalized_dissipation: Complex64,
    /// Mean dissipated power W₀ of the first wheel \[W\].
    pub mean_dissipation: f64,
    /// Growth rate of |Δ| per passage \[-\] in the mean over the wheels on the rail under study.
    pub growth_rate: f64,
    /// All contacts, in their order.
    pub contacts: Vec<ContactState>,
}

/// State of one contact of the loop.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
#[must_use]
pub struct ContactState {
    /// Forces Q_x, Q_t and P of the wheel on the rail \[N\].
    pub force: [Complex64; 3],
    /// Longitudinal and lateral creepage \[-\], with that of the wave's own geometry.
    pub creepage: [Complex64; 2],
    /// Spin of a contact that moves across the profiles \[1/m\].
    pub spin: Complex64,
    /// Its shift on the rail \[m\], to the right.
    pub shift: Complex64,
    /// Energy left on a metre of rail at the wheel \[J/m\].
    pub energy: Complex64,
    /// Energy left at a point of the rail \[J/m\], relative to the profile under this wheel, or to that of the rail
    /// under study where its own rail is smooth.
    pub energy_at_rail: Complex64,
    /// Growth rate of the profile of its rail per passage of this wheel \[-\], positive where corrugation grows; none
    /// on a smooth rail.
    pub growth_rate: Option<f64>,
    /// What the wave's own geometry does; `None` if it has no part.
    pub wave: Option<WaveState>,
    /// Slip speed over V along the rail that the direction of the normal forces makes by itself \[-\], see [`NormalDirection`](super::NormalDirection); `None` if they stay.
    pub slip_by_direction: Option<Complex64>,
    /// What laws of damage say; `None` if wear is alone.
    pub damage: Option<DamageState>,
}

impl LoopState {
    /// Receptance of the track along the normal of the first contact \[m/N\].
    pub fn normal_receptance(&self) -> Complex64 {
        self.track_receptance[2][2]
    }

    /// Normal force P₁ of the first contact \[N\].
    pub fn normal_force(&self) -> Complex64 {
        self.contacts[0].force[2]
    }

    /// Longitudinal creep force Q₁ of the first contact \[N\].
    pub fn tangential_force(&self) -> Complex64 {
        self.contacts[0].force[0]
    }

    /// Longitudinal creepage ξ₁ of the first contact \[-\].
    pub fn creepage(&self) -> Complex64 {
        self.contacts[0].creepage[0]
    }

    /// Longitudinal slip speed over V of the first contact \[-\]: the creepage but for that of the wave's own geometry.
    pub fn slip(&self) -> Complex64 {
        let of_wave = self.contacts[0].wave.map(|wave| wave.creepage[0]);
        of_wave.map_or(self.creepage(), |of_wave| self.creepage() - of_wave)
    }
}
