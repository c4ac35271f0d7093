//! Rolling contact as a spring and a dashpot in series.

use std::f64::consts::PI;

use num_complex::Complex64;

use super::{ContactResponse, HertzContact, MeanRolling, RollingContact};

/// A steady creep law that answers late: the creepage of the bodies stretches the patch (Mindlin's
/// spring) and slips (the dashpot, with the slope of the creep law).
///
/// With the relaxation length l = Q_ξ/k_t and the wavenumber k, the dashpot creeps by
/// ξ₁ − ikQ₁/k_t, so Q₁ = (Q_P P₁ + Q_ξ ξ₁)/(1 + ikl), and what it dissipates is
/// e₁ = ξ₀Q₁ + Q₀(ξ₁ − ikQ₁/k_t); the spring keeps what it takes. k_t = 4G√(ab)/(2 − ν).
///
/// Source: Bhaskar, Johnson, Wood & Woodhouse (1997), after Mindlin (1949) for the spring, whose circle of
/// the radius √(ab) stands for the ellipse. Range of validity: waves of some contact lengths and more;
/// the exact response overshoots, which one spring and one dashpot cannot. Dissipation is referred to
/// the wheel centre.
pub struct SpringDashpot<C> {
    law: C,
    /// k_t \[N/m\].
    stiffness: f64,
}

impl<C: RollingContact> SpringDashpot<C> {
    /// The law with the tangential stiffness of a contact.
    pub fn new(law: C, hertz: HertzContact) -> Self {
        let radius = (hertz.semi_axis_longitudinal() * hertz.semi_axis_lateral()).sqrt();
        let material = hertz.material();
        let stiffness = 4.0 * material.shear_modulus() * radius / (2.0 - material.poisson_ratio());
        Self { law, stiffness }
    }

    /// Tangential stiffness k_t \[N/m\].
    pub fn stiffness(&self) -> f64 {
        self.stiffness
    }
}

impl<C: RollingContact> RollingContact for SpringDashpot<C> {
    fn steady(&self) -> MeanRolling {
        self.law.steady()
    }

    fn response(&self, wavelength: f64) -> ContactResponse {
        let slow = self.law.response(wavelength);
        let steady = self.law.steady();
        // ik/k_t, and 1 + ikl.
        let stretch = Complex64::new(0.0, 2.0 * PI / wavelength / self.stiffness);
        let late = 1.0 + stretch * slow.dq_dxi;
        let (dq_dp, dq_dxi) = (slow.dq_dp / late, slow.dq_dxi / late);
        let dissipated = |force: Complex64, creepage: f64| {
            steady.creepage * force + steady.tangential_force * (creepage - stretch * force)
        };
        ContactResponse {
            dq_dp,
            dq_dxi,
            de_dp: dissipated(dq_dp, 0.0),
            de_dxi: dissipated(dq_dxi, 1.0),
            at_rail: None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Carter3d, ElasticMaterial};

    /// Long waves are quasi-static, short ones leave the creep force behind the creepage by a quarter
    /// of a wave. The relaxation length of small traction is some 1.8 a.
    #[test]
    fn answers_late() {
        let steel = ElasticMaterial::new(207e9, 0.3).unwrap();
        let hertz = HertzContact::new(steel, 0.46, 0.46, 50e3).unwrap();
        let law = Carter3d::from_tractive_ratio(hertz, 0.4, 0.01).unwrap();
        let contact = SpringDashpot::new(law, hertz);
        let (long, slow) = (contact.response(1e4), law.response(1e4));
        assert!((long.dq_dxi - slow.dq_dxi).norm() < 1e-4 * slow.dq_dxi.norm());
        assert!((long.de_dp - slow.de_dp).norm() < 1e-4 * slow.de_dp.norm());
        assert!((long.de_dxi - slow.de_dxi).norm() < 1e-4 * slow.de_dxi.norm());
        let short = contact.response(1e-5);
        assert!((short.dq_dxi.arg() + 0.5 * PI).abs() < 1e-2);
        let length = slow.dq_dxi.re / contact.stiffness() / hertz.semi_axis_longitudinal();
        assert!((1.6..2.0).contains(&length), "{length}");
    }
}
