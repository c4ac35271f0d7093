//! Rolling contact as a spring and a dashpot in series.

use std::f64::consts::PI;

use num_complex::Complex64;

use super::{ContactDerivative, ContactResponse, HertzContact, MeanRolling, RollingContact};

/// A steady creep law that answers late: the creepage of the bodies stretches the patch (Mindlin's
/// spring) and slips (the dashpot, with the slope of the creep law).
///
/// With the relaxation length l = Q_ξ/k_t and the wavenumber k, the dashpot creeps by
/// ξ₁ − ikQ₁/k_t, so Q₁ = (Q_P P₁ + Q_ξ ξ₁)/(1 + ikl), and what it dissipates is
/// e₁ = ξ₀Q₁ + Q₀(ξ₁ − ikQ₁/k_t); the spring keeps what it takes. k_t = 4G√(ab)/(2 − ν). With lateral creepage the
/// same holds of vectors, Q_ξ a matrix and the spring alike in both directions.
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
        // ik/k_t, and 1 + ik/k_t F_ξ with the columns of both creepages.
        let stretch = Complex64::new(0.0, 2.0 * PI / wavelength / self.stiffness);
        let across = slow.by_lateral.map_or([Complex64::ZERO; 2], |by| by.force);
        let columns = [slow.by_longitudinal.force, across];
        let late = |row: usize, column: usize| {
            let identity = if row == column { 1.0 } else { 0.0 };
            identity + stretch * columns[column][row]
        };
        let delayed = |by: ContactDerivative, creepage: [f64; 2]| {
            // Elimination of the longitudinal force.
            let [along, across] = by.force;
            let factor = late(1, 0) / late(0, 0);
            let lateral = (across - factor * along) / (late(1, 1) - factor * late(0, 1));
            let force = [(along - late(0, 1) * lateral) / late(0, 0), lateral];
            let mean = [
                (steady.creepages.longitudinal, steady.forces.longitudinal),
                (steady.creepages.lateral, steady.forces.lateral),
            ];
            let energies = (0..2).map(|axis| {
                let (mean_creepage, mean_force) = mean[axis];
                mean_creepage * force[axis] + mean_force * (creepage[axis] - stretch * force[axis])
            });
            ContactDerivative { force, energy: energies.sum(), energy_at_rail: None, error: None }
        };
        ContactResponse {
            by_load: delayed(slow.by_load, [0.0, 0.0]),
            by_longitudinal: delayed(slow.by_longitudinal, [1.0, 0.0]),
            by_lateral: slow.by_lateral.map(|by| delayed(by, [0.0, 1.0])),
            by_spin: slow.by_spin.map(|by| delayed(by, [0.0, 0.0])),
            by_curvature: slow.by_curvature.map(|by| {
                let mean = steady.creepages;
                delayed(by, [mean.longitudinal, mean.lateral])
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::{Carter3d, Creepages, MeanState, QuasiStatic};
    use crate::fixtures::steel;

    /// Long waves are quasi-static, short ones leave the creep force behind the creepage by a quarter
    /// of a wave. The relaxation length of small traction is some 1.8 a.
    #[test]
    fn answers_late() {
        let steel = steel();
        let hertz = HertzContact::new(steel, 0.46, 0.46, 50e3).unwrap();
        let law = Carter3d::new(hertz, 0.4).unwrap();
        let law = QuasiStatic::new(law, 50e3, MeanState::TractiveRatio(0.01)).unwrap();
        let contact = SpringDashpot::new(law, hertz);
        let long = contact.response(1e4);
        let slow = law.response(1e4);
        let close = |late: ContactDerivative, slow: ContactDerivative| {
            assert!((late.force[0] - slow.force[0]).norm() < 1e-4 * slow.force[0].norm());
            assert!((late.energy - slow.energy).norm() < 1e-4 * slow.energy.norm());
        };
        close(long.by_load, slow.by_load);
        close(long.by_longitudinal, slow.by_longitudinal);
        let short = contact.response(1e-5).by_longitudinal.force[0];
        assert!((short.arg() + 0.5 * PI).abs() < 1e-2);
        let slope = slow.by_longitudinal.force[0].re;
        let length = slope / contact.stiffness() / hertz.semi_axis_longitudinal();
        assert!((1.6..2.0).contains(&length), "{length}");
    }

    /// The law along a creepage at 45° is that of the law along the rail, turned.
    #[test]
    fn answers_alike_in_every_direction() {
        let steel = steel();
        let hertz = HertzContact::new(steel, 0.46, 0.46, 50e3).unwrap();
        let law = Carter3d::new(hertz, 0.4).unwrap();
        let about = |longitudinal: f64, lateral: f64| {
            let mean = MeanState::Creepages(Creepages { longitudinal, lateral, spin: 0.0 });
            let law = QuasiStatic::new(law, 50e3, mean).unwrap();
            SpringDashpot::new(law, hertz).response(0.03)
        };
        let (along, oblique) = (about(1e-3, 0.0), about(0.5f64.sqrt() * 1e-3, 0.5f64.sqrt() * 1e-3));
        let lateral = oblique.by_lateral.unwrap();
        // By a creepage along the mean one: the sum of both columns over √2, seen along the mean one.
        let turned = (0..2).map(|row| oblique.by_longitudinal.force[row] + lateral.force[row]);
        let turned = 0.5 * turned.sum::<Complex64>();
        let exact = along.by_longitudinal.force[0];
        assert!((turned - exact).norm() < 1e-12 * exact.norm());
        let energy = 0.5f64.sqrt() * (oblique.by_longitudinal.energy + lateral.energy);
        let exact = along.by_longitudinal.energy;
        assert!((energy - exact).norm() < 1e-12 * exact.norm());
        let exact = along.by_load.energy;
        assert!((oblique.by_load.energy - exact).norm() < 1e-12 * exact.norm());
    }
}
