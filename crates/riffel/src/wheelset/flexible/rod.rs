//! An axle that twists or stretches.

use num_complex::Complex64;
use riffel_numerics::square::Square;

use super::axle::{Axle, Segment};
use super::span::{Section, Transfer, hyperbolic};

/// Torsion of a segment, θ' = T/2GI and T' = −2ρIω²θ, or its stretch, u' = N/EA and N' = −ρAω²u.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct RodSection {
    /// 1/2GI \[1/(N m²)\] or 1/EA \[1/N\].
    compliance: f64,
    /// 2ρI \[kg m\] or ρA \[kg/m\].
    inertia: f64,
}

impl RodSection {
    pub(super) fn torsion(axle: &Axle, segment: Segment) -> Self {
        let polar = 2.0 * segment.second_moment();
        Self { compliance: (axle.material.shear_modulus() * polar).recip(), inertia: axle.density * polar }
    }

    pub(super) fn stretch(axle: &Axle, segment: Segment) -> Self {
        let area = segment.area();
        Self { compliance: (axle.material.youngs_modulus() * area).recip(), inertia: axle.density * area }
    }
}

impl Section<1> for RodSection {
    #[inline]
    fn transfer(&self, length: f64, w2: f64, elasticity: Complex64) -> Transfer<1> {
        let compliance = self.compliance / elasticity;
        let force = -w2 * self.inertia;
        let [cosh, sinh] = hyperbolic(compliance * (force * length * length));
        Transfer {
            displacement: [Square([[cosh]]), Square([[length * compliance * sinh]])],
            load: [Square([[length * force * sinh]]), Square([[cosh]])],
        }
    }

    fn wavenumber(&self, w2: f64) -> f64 {
        (w2 * self.inertia * self.compliance).sqrt()
    }

    fn inertia(&self) -> [f64; 1] {
        [self.inertia]
    }
}
