//! Free infinite beam under a load that moves and oscillates: the paper's Appendix.

use num_complex::Complex64;

use super::{EulerBernoulliBeam, Receptance};
use crate::Error;

/// Infinite Euler–Bernoulli beam under an oscillating load that travels at the speed V, equations
/// (27)–(33), without damping: the limit C → 0⁺.
///
/// In the frame of the load, u = U(x − Vt) e^{iωt} is a sum of e^{sξ}, ξ = (x − Vt)ω/V, with s = iσ
/// and the quartic (30), Kσ⁴ = (σ − 1)² + iĈ(σ − 1), K = EIω²/(mV⁴), Ĉ = C/(mω). Two roots decay
/// ahead of the load and two behind it; continuity of u, u', u'' and the jump of the shear force
/// (31), (32) fix their amplitudes, A_j = ±J/∏(s_j − s_i), J = F V³/(EI ω³).
///
/// Without damping two roots (all four above the critical speed) lie on the imaginary axis. They
/// are told apart by the limit C → 0⁺, not by a small C: the sign of d(Re s)/dĈ, the paper's g₃
/// and g₄. The sum (33) then closes. With p = V/(2√(ω√(EI/m))) and c = 1/(4(m³EI)^{1/4} ω^{3/2}),
/// H = −c \[(1 − 2p²)/√(1 − p²) + i(1 + 2p²)/√(1 + p²)\] for p < 1,
/// exact to rounding, and (23) for V = 0: a phase shift of 3p²/2 at leading order. Cost: three
/// square roots. With damping, shear or a foundation: [`MovingLoadTrack`](super::MovingLoadTrack).
///
/// Range of validity: p < 1, see [`critical_speed`](Self::critical_speed), and that of
/// [`EulerBernoulliBeam`]. Passive (Im H ≤ 0) for every p < 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MovingBeam {
    beam: EulerBernoulliBeam,
    /// 1/(4 (m³EI)^{1/4}).
    coefficient: f64,
    dispersion: f64,
}

/// The roots s of the quartic of a [`MovingBeam`], in the paper's numbering.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MovingLoadRoots {
    /// s₁ and s₄, the waves ahead of the load: Re s < 0, or = 0⁻.
    pub ahead: [Complex64; 2],
    /// s₂ and s₃, the waves behind the load: Re s > 0, or = 0⁺.
    pub behind: [Complex64; 2],
}

impl MovingBeam {
    /// The rail without support.
    pub fn new(beam: EulerBernoulliBeam) -> Self {
        Self { beam, coefficient: 0.25 / beam.fourth_root(), dispersion: beam.dispersion() }
    }

    /// Speed V = 2√(ω√(EI/m)) \[m/s\] at which the load keeps pace with its own wave energy and the
    /// undamped receptance is singular (K = 1/16).
    pub fn critical_speed(&self, angular_frequency: f64) -> f64 {
        2.0 * (angular_frequency * self.dispersion).sqrt()
    }

    /// `Ok` if a load at the speed \[m/s\] over the wavelength \[m\] stays below its critical speed.
    ///
    /// # Errors
    /// [`Error::Supercritical`]: with ω = 2πV/λ the limit is V = 8π√(EI/m)/λ.
    pub fn check_speed(&self, wavelength: f64, speed: f64) -> Result<(), Error> {
        let critical_speed = 8.0 * std::f64::consts::PI * self.dispersion / wavelength;
        if speed < critical_speed {
            return Ok(());
        }
        Err(Error::Supercritical { speed, wavelength, critical_speed })
    }

    /// The four roots s = iσ of equation (30) at ω > 0 \[rad/s\] and V > 0 \[m/s\].
    pub fn roots(&self, angular_frequency: f64, speed: f64) -> MovingLoadRoots {
        let i = Complex64::i();
        let k = self.dispersion * angular_frequency / (speed * speed);
        // kσ² = σ − 1 and kσ² = 1 − σ: the two quadratics into which (30) falls.
        // √(1 − 4k) = +i√(4k − 1) below the critical speed makes σ₁ decay ahead; above it, the
        // positive root has d(Re s₁)/dĈ = −1/(2√(1 − 4k)) < 0 and stays ahead.
        let first = Complex64::from(1.0 - 4.0 * k).sqrt();
        let second = (1.0 + 4.0 * k).sqrt();
        let [s1, s2, s3, s4] = [
            (1.0 + first) / (2.0 * k),
            (1.0 - first) / (2.0 * k),
            Complex64::from((second - 1.0) / (2.0 * k)),
            Complex64::from((-second - 1.0) / (2.0 * k)),
        ]
        .map(|sigma| i * sigma);
        MovingLoadRoots { ahead: [s1, s4], behind: [s2, s3] }
    }

    /// Receptance \[m/N\] as the sum (33) over the waves ahead of the load; V > 0.
    ///
    /// The reference for the closed form.
    pub fn receptance_from_roots(&self, angular_frequency: f64, speed: f64) -> Complex64 {
        let MovingLoadRoots { ahead, behind } = self.roots(angular_frequency, speed);
        let amplitude = |s: Complex64, other: Complex64| ((s - other) * (s - behind[0]) * (s - behind[1])).inv();
        let scale = (speed / angular_frequency).powi(3) / self.beam.bending_stiffness();
        scale * (amplitude(ahead[0], ahead[1]) + amplitude(ahead[1], ahead[0]))
    }
}

impl Receptance for MovingBeam {
    fn receptance(&self, angular_frequency: f64, speed: f64) -> Complex64 {
        let p = speed / self.critical_speed(angular_frequency);
        let (p2, scale) = (p * p, self.coefficient / (angular_frequency * angular_frequency.sqrt()));
        let behind = (1.0 + 2.0 * p2) / (1.0 + p2).sqrt();
        if p < 1.0 {
            return Complex64::new(-(1.0 - 2.0 * p2) / (1.0 - p2).sqrt(), -behind) * scale;
        }
        Complex64::new(0.0, ((2.0 * p2 - 1.0) / (p2 - 1.0).sqrt() - behind) * scale)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::rail;
    use crate::receptance::FreeBeam;
    use proptest::prelude::*;

    #[test]
    fn speed_zero_is_the_stationary_load() {
        let (moving, free) = (MovingBeam::new(rail()), FreeBeam::new(rail()));
        for w in [100.0, 1e3, 1e4] {
            let (h, limit) = (moving.receptance(w, 0.0), free.receptance(w, 0.0));
            assert!((h - limit).norm() < 1e-15 * limit.norm() * 4.0);
        }
    }

    #[test]
    fn supercritical_speed_is_refused() {
        let beam = MovingBeam::new(rail());
        assert!(beam.check_speed(0.08, 60.0).is_ok());
        assert!(beam.check_speed(200.0, 60.0).is_err());
    }

    proptest! {
        /// Every root satisfies (30). The residual of a root that is good to rounding is some
        /// roundings of the largest term; 1e-12 leaves room for the condition of close roots near
        /// the critical speed.
        #[test]
        fn roots_satisfy_the_quartic(w in 50.0..30e3, v in 0.5..120.0f64) {
            let beam = MovingBeam::new(rail());
            let k = rail().bending_stiffness() * w * w / (rail().mass_per_length() * v.powi(4));
            let roots = beam.roots(w, v);
            for s in roots.ahead.into_iter().chain(roots.behind) {
                let sigma = s / Complex64::i();
                let y = sigma - 1.0;
                let residual = k * sigma.powi(4) - y * y;
                prop_assert!(residual.norm() < 1e-12 * (y * y).norm().max(1.0), "{s}: {residual}");
            }
        }

        /// The closed form is the sum over the roots. Summing roots loses digits as p → 0, where
        /// the four nearly form a square and the terms stay of one size: 1e-11.
        #[test]
        fn closed_form_is_the_sum_over_roots(w in 50.0..30e3, v in 0.5..120.0) {
            let beam = MovingBeam::new(rail());
            let (h, sum) = (beam.receptance(w, v), beam.receptance_from_roots(w, v));
            prop_assert!((h - sum).norm() < 1e-11 * h.norm(), "{h} {sum}");
        }

        #[test]
        fn passive_below_the_critical_speed(w in 50.0..30e3, share in 0.0..0.999) {
            let beam = MovingBeam::new(rail());
            let v = share * beam.critical_speed(w);
            prop_assert!(beam.receptance(w, v).im <= 0.0);
        }
    }
}
