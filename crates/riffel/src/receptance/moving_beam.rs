//! Free infinite beam under a load that moves and oscillates: the paper's Appendix.

use num_complex::Complex64;

use super::{EulerBernoulliBeam, Receptance};
use crate::Error;

/// Infinite Euler–Bernoulli beam under an oscillating load that travels at the speed V, equations
/// (27)–(33), with viscous damping C per metre.
///
/// In the frame of the load, u = U(x − Vt) e^{iωt} is a sum of e^{sξ}, ξ = (x − Vt)ω/V, with s = iσ
/// and the quartic (30), Kσ⁴ = (σ − 1)² + iĈ(σ − 1), K = EIω²/(mV⁴), Ĉ = C/(mω). Two roots decay
/// ahead of the load and two behind it; continuity of u, u', u'' and the jump of the shear force
/// (31), (32) fix their amplitudes, A_j = ±J/∏(s_j − s_i), J = F V³/(EI ω³).
///
/// * Without damping two roots (all four above the critical speed) lie on the imaginary axis. They
///   are told apart by the limit C → 0⁺, not by a small C: the sign of d(Re s)/dĈ, the paper's g₃
///   and g₄. The sum (33) then closes. With p = V/(2√(ω√(EI/m))) and c = 1/(4(m³EI)^{1/4} ω^{3/2}),
///   H = −c \[(1 − 2p²)/√(1 − p²) + i(1 + 2p²)/√(1 + p²)\] for p < 1,
///   exact to rounding, and (23) for V = 0: a phase shift of 3p²/2 at leading order. Cost: three
///   square roots.
/// * With damping the four roots come from Newton's iteration on all roots at once (Weierstrass
///   1891), to 1e-14 relative, some 10 iterations.
///
/// Range of validity: p < 1, see [`critical_speed`](Self::critical_speed), and that of
/// [`EulerBernoulliBeam`]. Passive (Im H ≤ 0) for every p < 1 without damping, and for p < 0.95 with
/// any; nearer to the critical speed a damped beam may push its load along (Im H > 0), with energy
/// from whatever drives the load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MovingBeam {
    beam: EulerBernoulliBeam,
    damping: f64,
    /// 1/(4 (m³EI)^{1/4}).
    coefficient: f64,
    dispersion: f64,
}

/// The roots s of the quartic of a [`MovingBeam`], in the paper's numbering.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MovingLoadRoots {
    /// s₁ and s₄, the waves ahead of the load: Re s < 0, or = 0⁻ without damping.
    pub ahead: [Complex64; 2],
    /// s₂ and s₃, the waves behind the load: Re s > 0, or = 0⁺ without damping.
    pub behind: [Complex64; 2],
}

impl MovingBeam {
    /// The rail with viscous damping C per metre \[N s/m²\]; zero for the undamped limit C → 0⁺.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the damping is negative.
    pub fn new(beam: EulerBernoulliBeam, damping: f64) -> Result<Self, Error> {
        Error::unless_not_negative("rail damping", damping, "N s/m2")?;
        Ok(Self {
            beam,
            damping,
            coefficient: 0.25 / beam.fourth_root(),
            dispersion: beam.dispersion(),
        })
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
        Err(Error::Supercritical {
            speed,
            wavelength,
            critical_speed,
        })
    }

    /// The four roots s = iσ of equation (30) at ω > 0 \[rad/s\] and V > 0 \[m/s\].
    pub fn roots(&self, angular_frequency: f64, speed: f64) -> MovingLoadRoots {
        let i = Complex64::i();
        let k = self.dispersion * angular_frequency / (speed * speed);
        // kσ² = σ − 1 and kσ² = 1 − σ: the two quadratics into which (30) falls without damping.
        // √(1 − 4k) = +i√(4k − 1) below the critical speed makes σ₁ decay ahead; above it, the
        // positive root has d(Re s₁)/dĈ = −1/(2√(1 − 4k)) < 0 and stays ahead.
        let first = Complex64::from(1.0 - 4.0 * k).sqrt();
        let second = (1.0 + 4.0 * k).sqrt();
        let undamped = [
            (1.0 + first) / (2.0 * k),
            (1.0 - first) / (2.0 * k),
            Complex64::from((second - 1.0) / (2.0 * k)),
            Complex64::from((-second - 1.0) / (2.0 * k)),
        ];
        if self.damping == 0.0 {
            let [s1, s2, s3, s4] = undamped.map(|sigma| i * sigma);
            return MovingLoadRoots {
                ahead: [s1, s4],
                behind: [s2, s3],
            };
        }
        let damping = self.damping / (self.beam.mass_per_length() * angular_frequency);
        let mut s = damped_roots(undamped, k * k, damping).map(|sigma| i * sigma);
        s.sort_by(|a, b| a.re.total_cmp(&b.re));
        MovingLoadRoots {
            ahead: [s[0], s[1]],
            behind: [s[2], s[3]],
        }
    }

    /// Receptance \[m/N\] as the sum (33) over the waves ahead of the load; V > 0.
    ///
    /// The reference for the closed form; used directly only with damping.
    pub fn receptance_from_roots(&self, angular_frequency: f64, speed: f64) -> Complex64 {
        let MovingLoadRoots { ahead, behind } = self.roots(angular_frequency, speed);
        let amplitude = |s: Complex64, other: Complex64| {
            ((s - other) * (s - behind[0]) * (s - behind[1])).inv()
        };
        let scale = (speed / angular_frequency).powi(3) / self.beam.bending_stiffness();
        scale * (amplitude(ahead[0], ahead[1]) + amplitude(ahead[1], ahead[0]))
    }
}

/// All roots of Kσ⁴ = (σ − 1)² + iĈ(σ − 1) by the simultaneous Newton iteration of Weierstrass,
/// from the undamped ones.
fn damped_roots(start: [Complex64; 4], stiffness: f64, damping: f64) -> [Complex64; 4] {
    const TOLERANCE: f64 = 1e-14; // some 50 roundings: beyond it the iteration only stirs noise
    const MOST_ITERATIONS: usize = 60;
    let polynomial = |x: Complex64| {
        let y = x - 1.0;
        x * x * x * x - y * (y + Complex64::new(0.0, damping)) / stiffness
    };
    let mut roots = start;
    for _ in 0..MOST_ITERATIONS {
        let mut largest_step: f64 = 0.0;
        for j in 0..4 {
            let x = roots[j];
            let product: Complex64 = (0..4).filter(|&i| i != j).map(|i| x - roots[i]).product();
            let step = polynomial(x) / product;
            roots[j] = x - step;
            largest_step = largest_step.max(step.norm() / x.norm());
        }
        if largest_step < TOLERANCE {
            break;
        }
    }
    roots
}

impl Receptance for MovingBeam {
    fn receptance(&self, angular_frequency: f64, speed: f64) -> Complex64 {
        if self.damping > 0.0 {
            if speed > 0.0 {
                return self.receptance_from_roots(angular_frequency, speed);
            }
            let inertia = -self.beam.mass_per_length() * angular_frequency * angular_frequency;
            let kappa = Complex64::new(inertia, angular_frequency * self.damping);
            return self.beam.receptance_on(kappa);
        }
        let p = speed / self.critical_speed(angular_frequency);
        let (p2, scale) = (
            p * p,
            self.coefficient / (angular_frequency * angular_frequency.sqrt()),
        );
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
    use crate::{ElasticMaterial, FreeBeam};
    use proptest::prelude::*;

    fn rail() -> EulerBernoulliBeam {
        let steel = ElasticMaterial::new(207e9, 0.3).unwrap();
        EulerBernoulliBeam::new(steel, 2.35e-5, 56.0).unwrap()
    }

    #[test]
    fn speed_zero_is_the_stationary_load() {
        let (moving, free) = (MovingBeam::new(rail(), 0.0).unwrap(), FreeBeam::new(rail()));
        for w in [100.0, 1e3, 1e4] {
            let (h, limit) = (moving.receptance(w, 0.0), free.receptance(w, 0.0));
            assert!((h - limit).norm() < 1e-15 * limit.norm() * 4.0);
        }
    }

    /// A slow load tends to the stationary one, damped or not: at 0.1 m/s, p² = 3e-9.
    #[test]
    fn damped_beam_is_continuous_at_speed_zero() {
        let beam = MovingBeam::new(rail(), 2e4).unwrap();
        let (slow, still) = (beam.receptance(3e3, 0.1), beam.receptance(3e3, 0.0));
        assert!(
            (slow - still).norm() < 1e-7 * still.norm(),
            "{slow} {still}"
        );
    }

    #[test]
    fn supercritical_speed_is_refused() {
        let beam = MovingBeam::new(rail(), 0.0).unwrap();
        assert!(beam.check_speed(0.08, 60.0).is_ok());
        assert!(beam.check_speed(200.0, 60.0).is_err());
    }

    proptest! {
        /// Every root satisfies (30), without damping and with it. The residual of a root that is
        /// good to rounding is some roundings of the largest term; 1e-12 leaves room for the
        /// condition of close roots near the critical speed.
        #[test]
        fn roots_satisfy_the_quartic(w in 50.0..30e3, v in 0.5..120.0f64, c in prop_oneof![Just(0.0), 1.0..1e5]) {
            let beam = MovingBeam::new(rail(), c).unwrap();
            let k = rail().bending_stiffness() * w * w / (rail().mass_per_length() * v.powi(4));
            let damping = Complex64::new(0.0, c / (rail().mass_per_length() * w));
            let roots = beam.roots(w, v);
            for s in roots.ahead.into_iter().chain(roots.behind) {
                let sigma = s / Complex64::i();
                let y = sigma - 1.0;
                let residual = k * sigma.powi(4) - y * (y + damping);
                prop_assert!(residual.norm() < 1e-12 * (y * y).norm().max(1.0), "{s}: {residual}");
            }
        }

        /// The closed form is the sum over the roots. Summing roots loses digits as p → 0, where
        /// the four nearly form a square and the terms stay of one size: 1e-11.
        #[test]
        fn closed_form_is_the_sum_over_roots(w in 50.0..30e3, v in 0.5..120.0) {
            let beam = MovingBeam::new(rail(), 0.0).unwrap();
            let (h, sum) = (beam.receptance(w, v), beam.receptance_from_roots(w, v));
            prop_assert!((h - sum).norm() < 1e-11 * h.norm(), "{h} {sum}");
        }

        /// The choice of roots is the limit of vanishing damping: the difference falls in
        /// proportion to it, here ¾ Ĉ of the value at leading order.
        #[test]
        fn undamped_is_the_limit_of_damped(w in 300.0..30e3, v in 1.0..60.0) {
            let undamped = MovingBeam::new(rail(), 0.0).unwrap().receptance(w, v);
            for loss in [1e-3, 1e-6] {
                let damping = loss * rail().mass_per_length() * w;
                let h = MovingBeam::new(rail(), damping).unwrap().receptance(w, v);
                prop_assert!((h - undamped).norm() < loss * undamped.norm(), "{h} {undamped}");
            }
        }

        /// Up to 95 % of the critical speed, see the range of validity.
        #[test]
        fn passive_below_the_critical_speed(w in 50.0..30e3, share in 0.0..0.95, c in prop_oneof![Just(0.0), 1.0..1e5]) {
            let beam = MovingBeam::new(rail(), c).unwrap();
            let v = share * beam.critical_speed(w);
            prop_assert!(beam.receptance(w, v).im <= 0.0);
        }
    }
}
