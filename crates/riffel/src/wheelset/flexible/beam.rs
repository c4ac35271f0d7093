//! An axle that bends and shears.

use num_complex::Complex64;
use riffel_numerics::square::Square;

use super::axle::{Axle, Segment};
use super::span::{Section, Transfer, matrix_hyperbolic};

/// Bending of a segment in one plane (Timoshenko 1921), with deflection w, rotation ψ, shear force S and moment M:
///
/// ```text
/// w' = ψ + S/κGA     ψ' = M/EI     M' = −S − ρIω²ψ     S' = −ρAω² w
/// ```
///
/// With d = (w, ψ) and p = (S, M).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct BeamSection {
    /// 1/κGA \[1/N\].
    shear_compliance: f64,
    /// 1/EI \[1/(N m²)\].
    bending_compliance: f64,
    /// ρA \[kg/m\].
    mass: f64,
    /// ρI \[kg m\].
    rotary_inertia: f64,
}

impl BeamSection {
    pub(super) fn new(axle: &Axle, segment: Segment) -> Self {
        let (area, second_moment) = (segment.area(), segment.second_moment());
        let shear_modulus = axle.material.shear_modulus();
        Self {
            shear_compliance: (axle.shear_coefficient * shear_modulus * area).recip(),
            bending_compliance: (axle.material.youngs_modulus() * second_moment).recip(),
            mass: axle.density * area,
            rotary_inertia: axle.density * second_moment,
        }
    }
}

impl Section<2> for BeamSection {
    /// (w, M)' = P (ψ, S) and (ψ, S)' = Q (w, M): the even functions of the state matrix are cosh √X of X = L²PQ, the odd
    /// ones sinh √X/√X times LP or LQ.
    #[inline]
    fn transfer(&self, length: f64, w2: f64, elasticity: Complex64) -> Transfer<2> {
        let loss = elasticity.inv();
        let shear = self.shear_compliance * loss;
        let bending = self.bending_compliance * loss;
        let (force, turning) = (-w2 * self.mass, w2 * self.rotary_inertia);
        let squared = length * length;
        // X = [[ww, wm], [mw, mm]]; XL of the other order, L²QP, has the same entries in other places.
        let ww = shear * (force * squared);
        let wm = bending * squared;
        let mw = -force * squared;
        let mm = bending * (-turning * squared);
        let determinant = wm * (-mw) * (1.0 - turning * shear);
        let [[c0, c1], [s0, s1]] = matrix_hyperbolic(ww + mm, determinant);

        let (cosh_ww, cosh_wm, cosh_mw, cosh_mm) = (c0 + c1 * ww, c1 * wm, c1 * mw, c0 + c1 * mm);
        let (sinh_ww, sinh_wm, sinh_mw, sinh_mm) = (s0 + s1 * ww, s1 * wm, s1 * mw, s0 + s1 * mm);
        // Rows: w by ψ and by S, M by ψ and by S.
        let w_by_rotation = length * (sinh_ww - turning * sinh_wm);
        let w_by_shear = length * (shear * sinh_ww - sinh_wm);
        let m_by_rotation = length * (sinh_mw - turning * sinh_mm);
        let m_by_shear = length * (shear * sinh_mw - sinh_mm);
        // ψ by w and by M, S by w and by M.
        let rotation_by_w = bending * sinh_mw * length;
        let rotation_by_m = bending * sinh_mm * length;
        let shear_by_w = length * force * sinh_ww;
        let shear_by_m = length * force * sinh_wm;
        // Even functions of L²QP: ψ by ψ as M by M, S by S as w by w.
        let rotation_by_shear = -cosh_wm;
        let shear_by_rotation = -cosh_mw;
        Transfer {
            displacement: [
                Square([[cosh_ww, w_by_rotation], [rotation_by_w, cosh_mm]]),
                Square([[w_by_shear, cosh_wm], [rotation_by_shear, rotation_by_m]]),
            ],
            load: [
                Square([[shear_by_w, shear_by_rotation], [cosh_mw, m_by_rotation]]),
                Square([[cosh_ww, shear_by_m], [m_by_shear, cosh_mm]]),
            ],
        }
    }

    /// The larger root of k⁴ − (ρA/κGA + ρI/EI)ω²k² − (ρA/EI)ω² = 0, an upper bound below the cut-on of the second wave
    /// and above it too.
    fn wavenumber(&self, w2: f64) -> f64 {
        let linear = w2 * (self.mass * self.shear_compliance + self.rotary_inertia * self.bending_compliance);
        let constant = w2 * self.mass * self.bending_compliance;
        (0.5 * (linear + (linear * linear + 4.0 * constant).sqrt())).sqrt()
    }

    fn inertia(&self) -> [f64; 2] {
        [self.mass, self.rotary_inertia]
    }
}
