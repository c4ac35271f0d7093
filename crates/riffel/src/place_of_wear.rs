//! Where the dissipation falls: from the wheel centre to a point of the rail.

use std::f64::consts::PI;

/// How the phase of the dissipation at a point of the rail is read, below equation (22).
///
/// The contact dissipates behind its centre: by about its semi-axis a₀ at small tractive ratio, by
/// half of it near full slip. The angle is θ = (2πa₀/λ)(1 − τ/2); the paper does not fix its sign.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum DissipationPhase {
    /// W₁ e^{−iθ}: the reading behind the paper's figures, and the better stand-in for a rolling
    /// contact that answers late.
    #[default]
    Lag,
    /// W₁ e^{+iθ}: the reading of geometry alone: a point of the rail dissipates when the wheel is
    /// already a₀ further on.
    Lead,
    /// Dissipation taken at the wheel centre.
    None,
}

/// The paper's rule for the phase between W₁ at the wheel centre and the wear of a rail point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlaceOfWear {
    phase: DissipationPhase,
    semi_axis: f64,
    tractive_ratio: f64,
}

impl PlaceOfWear {
    /// The rule for a contact of semi-axis a₀ along the rail \[m\] and tractive ratio τ \[-\].
    pub fn new(phase: DissipationPhase, semi_axis: f64, tractive_ratio: f64) -> Self {
        Self { phase, semi_axis, tractive_ratio }
    }

    /// Angle \[rad\] by which the dissipation at a point of the rail lags W₁, at the wavelength
    /// λ \[m\]: θ, −θ or 0. The dissipation there is W₁ e^{−i·angle}.
    pub fn lag(&self, wavelength: f64) -> f64 {
        let angle = 2.0 * PI * self.semi_axis / wavelength * (1.0 - self.tractive_ratio / 2.0);
        match self.phase {
            DissipationPhase::Lag => angle,
            DissipationPhase::Lead => -angle,
            DissipationPhase::None => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The two ends the paper states: 2πa₀/λ at full stick, πa₀/λ at full slip.
    #[test]
    fn falls_from_the_semi_axis_to_half_of_it() {
        let lag = |phase, ratio| PlaceOfWear::new(phase, 0.006, ratio).lag(0.06);
        let full_stick = 2.0 * PI * 0.1;
        assert_eq!(lag(DissipationPhase::Lag, 0.0), full_stick);
        assert_eq!(lag(DissipationPhase::Lag, 1.0), full_stick / 2.0);
        assert_eq!(lag(DissipationPhase::Lead, 0.0), -full_stick);
        assert_eq!(lag(DissipationPhase::None, 0.0), 0.0);
    }
}
