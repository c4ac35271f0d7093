//! Tractions on the rail.

use super::{EllipseStress, StressTensor};

/// Shear of a contact on the rail: μp, in full slip or less that of the stick area of Vermeulen & Johnson.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Traction {
    friction: f64,
    direction: [f64; 2],
    /// a′/a of the area of stick, which touches the leading edge.
    stick: f64,
}

impl Traction {
    /// Full slip of a coefficient of friction; the direction is that of the force on the rail, forward in braking, of length one.
    pub fn full_slip(friction: f64, direction: [f64; 2]) -> Self {
        Self {
            friction,
            direction,
            stick: 0.0,
        }
    }

    /// Partial slip at a tractive ratio Q/μP (Vermeulen & Johnson 1964): less μp₀ a′/a over a similar ellipse, a′/a = (1 − τ)^(1/3),
    /// about x = a − a′.
    pub fn partial_slip(friction: f64, direction: [f64; 2], tractive_ratio: f64) -> Self {
        Self {
            friction,
            direction,
            stick: (1.0 - tractive_ratio.clamp(0.0, 1.0)).cbrt(),
        }
    }

    /// Stress over p₀ under pressure and traction, at x/a, y/b and z/a.
    pub fn stress(&self, ellipse: &EllipseStress, place: [f64; 3]) -> StressTensor {
        let unit = ellipse.at(place);
        let [along, across] = self.direction.map(|part| part * self.friction);
        let mut stress: StressTensor = std::array::from_fn(|i| {
            unit.normal[i] + along * unit.along[i] + across * unit.across[i]
        });
        if self.stick > 0.0 && self.friction > 0.0 {
            let [x, y, z] = place;
            let c = self.stick;
            let inner = ellipse.at([(x - (1.0 - c)) / c, y / c, z / c]);
            for (i, stress) in stress.iter_mut().enumerate() {
                *stress -= c * (along * inner.along[i] + across * inner.across[i]);
            }
        }
        stress
    }
}
