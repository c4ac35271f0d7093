//! Where the wheels of a shifted wheelset run: rolling radius and contact angle against lateral shift.

use riffel::Rail;

/// Where one wheel of a shifted wheelset touches its rail.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RollingPosition {
    /// Rolling radius less that of the datum circle, r − r₀ \[m\].
    pub radius_change: f64,
    /// Contact angle γ \[rad\], 0 or more on both rails: the normal force pushes the rail outward.
    pub contact_angle: f64,
    /// Curvature of wheel and rail together across the track \[1/m\], where it is known.
    pub lateral_curvature: Option<f64>,
}

/// A shift of a wheelset at which a wheel stands on two points, past which it stands on the other of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TwoPoints {
    /// The rail of the wheel.
    pub rail: Rail,
    /// The shift at the level of the rails \[m\].
    pub shift: f64,
    /// Where it stands below that shift and above it.
    pub positions: [RollingPosition; 2],
}

/// The running surfaces of a wheelset on its track, without yaw.
///
/// They are told over the shift η \[m\] of the wheelset at the level of the rails, positive to the right. As it rolls the axle
/// goes another way.
pub trait RunningSurfaces: Send + Sync {
    /// Where a wheel runs at a shift; `None` if the wheelset has left the track.
    fn position(&self, rail: Rail, shift: f64) -> Option<RollingPosition>;

    /// Lateral shift y of the axle \[m\] at a shift; `None` if the wheelset has left the track. Surfaces that leave roll out have
    /// y = η.
    fn axle_shift(&self, shift: f64) -> Option<f64> {
        Some(shift)
    }

    /// Shifts at which a wheel stands on two points, in their order; between them positions are continuous.
    fn two_points(&self) -> &[TwoPoints] {
        &[]
    }
}

/// Conical wheels on edges: r = r₀ ± λy, with one contact angle tan γ = λ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cone {
    /// Conicity λ \[-\].
    pub conicity: f64,
}

impl RunningSurfaces for Cone {
    fn position(&self, rail: Rail, shift: f64) -> Option<RollingPosition> {
        Some(RollingPosition {
            radius_change: self.conicity * rail.sign() * shift,
            contact_angle: self.conicity.atan(),
            lateral_curvature: None,
        })
    }
}

/// Conical wheels whose contact angle rises smoothly to that of a flange:
/// tan γ = λ + (t − λ)/2 · (1 + tanh((y − y_f)/w)) on the right, −y in the place of y on the left, and
/// r = r₀ + ∫₀ʸ tan γ dy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConeWithFlangePlane {
    /// Conicity of the tread λ \[-\].
    pub conicity: f64,
    /// Tangent t of the flange angle \[-\].
    pub slope: f64,
    /// Shift y_f \[m\] in the middle of the rise.
    pub shift: f64,
    /// Its width w \[m\].
    pub width: f64,
}

impl RunningSurfaces for ConeWithFlangePlane {
    fn position(&self, rail: Rail, shift: f64) -> Option<RollingPosition> {
        let y = rail.sign() * shift;
        let rise = 0.5 * (self.slope - self.conicity);
        let reduced = (y - self.shift) / self.width;
        let log_cosh = |u: f64| u.abs() + (-2.0 * u.abs()).exp().ln_1p() - std::f64::consts::LN_2;
        let climb = y + self.width * (log_cosh(reduced) - log_cosh(self.shift / self.width));
        Some(RollingPosition {
            radius_change: self.conicity * y + rise * climb,
            contact_angle: (self.conicity + rise * (1.0 + reduced.tanh())).atan(),
            lateral_curvature: None,
        })
    }
}
