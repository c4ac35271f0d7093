//! The paper as a page of code: equations (1) to (33) in its symbols and its order.
//!
//! L. Afferrante and M. Ciavarella, *Corrugation models and the roaring rails enigma: a simple analytical contact mechanics model based on
//! a perturbation of Carter's solution*, Journal of Mechanics of Materials and Structures (2009).
//!
//! Each equation is one method of [`Paper`], which holds the quantities of its Fig. 1 in SI. Nothing is checked and nothing is fast here:
//! this page is for reading, and what [`Loop`](crate::Loop) computes is tested to be equal to it. Amplitudes are complex, for exp(+iωt).
//! Displacements are positive downward, braking is positive.
//!
//! Two equations are not as printed. (17) lacks the i of (16) and (18). (26) has (1 − ν)² in the place of (1 − ν²): Hertz for two equal
//! bodies has E\* = G/(1 − ν), and with it max |P₁/P₀| of Fig. 3 is 1.03 in the place of 0.84. The phase of the place of wear, below (22),
//! can be read two ways: see [`DissipationPhase`].
//!
//! ```
//! use riffel::paper::Paper;
//!
//! // Fig. 4, left: 30 m/s over waves of 55 mm, growth where Re W₁ < 0.
//! let paper = Paper { V: 30.0, lambda: 0.055, ..Paper::NOMINAL };
//! assert!(paper.W_1_at_rail(riffel::DissipationPhase::Lag).re < 0.0);
//! ```
#![expect(non_snake_case, non_upper_case_globals, reason = "symbols of the paper")]

use std::f64::consts::PI;

use num_complex::Complex64;

use crate::DissipationPhase;

const i: Complex64 = Complex64::I;

/// The model of Fig. 1 at one speed and wavelength.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Paper {
    /// Young's modulus E of wheel and rail \[Pa\].
    pub E: f64,
    /// Poisson's ratio ν \[-\].
    pub nu: f64,
    /// Mass of the rail m_rail \[kg/m\].
    pub m_rail: f64,
    /// Second moment of area of the rail I_rail \[m⁴\].
    pub I_rail: f64,
    /// Mass of the wheel m_w \[kg\].
    pub m_w: f64,
    /// Inertia of the wheel I_w \[kg m²\].
    pub I_w: f64,
    /// Rolling radius R \[m\].
    pub R: f64,
    /// The other relative radius of curvature R_r \[m\].
    pub R_r: f64,
    /// Coefficient of friction μ \[-\].
    pub mu: f64,
    /// Mean normal force P₀ \[N\].
    pub P_0: f64,
    /// Tractive ratio τ = Q₀/μP₀ \[-\].
    pub tau: f64,
    /// Amplitude of the corrugation Δ \[m\].
    pub Delta: f64,
    /// Speed V \[m/s\].
    pub V: f64,
    /// Wavelength λ \[m\].
    pub lambda: f64,
}

/// Section 2: rolling contact and rotation of the wheel.
impl Paper {
    /// The parameters of Figs. 3 to 8, at 27.8 m/s over waves of 50 mm.
    pub const NOMINAL: Self = Self {
        E: 207e9,
        nu: 0.3,
        m_rail: 56.0,
        I_rail: 2.35e-5,
        m_w: 350.0,
        I_w: 0.75 * 350.0 * 0.46 * 0.46 / 2.0,
        R: 0.46,
        R_r: 0.23,
        mu: 0.4,
        P_0: 50e3,
        tau: 0.1,
        Delta: 3.15e-5,
        V: 27.8,
        lambda: 0.05,
    };

    /// ω = 2πV/λ \[rad/s\].
    pub fn omega(&self) -> f64 {
        2.0 * PI * self.V / self.lambda
    }

    /// Shear modulus G = E/2(1 + ν) \[Pa\].
    pub fn G(&self) -> f64 {
        self.E / (2.0 * (1.0 + self.nu))
    }

    /// (1) P = P₀ + P₁ exp(iωt) \[N\], real part.
    pub fn P(&self, t: f64) -> f64 {
        self.P_0 + (self.P_1() * (i * self.omega() * t).exp()).re
    }

    /// (2) ξ₀ = 1 − Ω₀R/V \[-\], by the inverse of (5).
    pub fn xi_0(&self) -> f64 {
        self.xi_of(self.P_0, self.tau * self.mu * self.P_0)
    }

    /// (2) solved for the mean rotation Ω₀ = (1 − ξ₀)V/R \[rad/s\].
    pub fn Omega_0(&self) -> f64 {
        (1.0 - self.xi_0()) * self.V / self.R
    }

    /// (3) ξ = 1 − ΩR/V \[-\].
    pub fn xi(&self, Omega: f64) -> f64 {
        1.0 - Omega * self.R / self.V
    }

    /// (4) ξ − ξ₀ = −(Ω − Ω₀)R/V, its amplitude \[-\].
    pub fn xi_1(&self) -> Complex64 {
        -self.Omega_1() * self.R / self.V
    }

    /// (5) ξ = ξ_max \[1 − (1 − Q/μP)^{1/3}\] \[-\].
    pub fn xi_of(&self, P: f64, Q: f64) -> f64 {
        self.xi_max(P) * (1.0 - (1.0 - Q / (self.mu * P)).cbrt())
    }

    /// (5) solved for Q = μP \[1 − (ξ_max − ξ)³/ξ_max³\] \[N\], 0 ≤ ξ ≤ ξ_max.
    pub fn Q(&self, P: f64, xi: f64) -> f64 {
        let xi_max = self.xi_max(P);
        self.mu * P * (1.0 - (xi_max - xi).powi(3) / xi_max.powi(3))
    }

    /// (6) ξ_max = (3μ/C₀₀) \[16P / (9(1 − ν)²R_e²G)\]^{1/3} \[-\].
    pub fn xi_max(&self, P: f64) -> f64 {
        let R_e = self.R_e();
        3.0 * self.mu / self.C_00() * (16.0 * P / (9.0 * (1.0 - self.nu).powi(2) * R_e * R_e * self.G())).cbrt()
    }

    /// (7) C₀₀ = 2.84 + 1.2 a/b ≈ 2.84 + 1.2 (R/R_r)^{2/3} \[-\].
    pub fn C_00(&self) -> f64 {
        2.84 + 1.2 * (self.R / self.R_r).powf(2.0 / 3.0)
    }

    /// (8) W₀ = Vξ₀Q₀ \[W\].
    pub fn W_0(&self) -> f64 {
        self.V * self.xi_0() * self.Q(self.P_0, self.xi_0())
    }

    /// ξ₀/ξ_max \[-\].
    fn x(&self) -> f64 {
        self.xi_0() / self.xi_max(self.P_0)
    }

    /// (9) Q_P = ∂Q/∂P = (2μξ₀/ξ_max)(1 − ξ₀/2ξ_max) \[-\]; it holds ξ_max ∝ P^{1/3}.
    pub fn Q_P(&self) -> f64 {
        2.0 * self.mu * self.x() * (1.0 - self.x() / 2.0)
    }

    /// (10) Q_Ω = ∂Q/∂Ω = −(3μRP₀/Vξ_max)(1 − ξ₀/ξ_max)² \[N s\].
    pub fn Q_Omega(&self) -> f64 {
        -3.0 * self.mu * self.R * self.P_0 / (self.V * self.xi_max(self.P_0)) * (1.0 - self.x()).powi(2)
    }

    /// (11) W_P = ∂W/∂P = Vξ₀Q_P \[W/N\].
    pub fn W_P(&self) -> f64 {
        self.V * self.xi_0() * self.Q_P()
    }

    /// (12) W_Ω = ∂W/∂Ω = −6μP₀R(ξ₀/ξ_max) \[1 − (3ξ₀/2ξ_max)(1 − 4ξ₀/9ξ_max)\] \[W s\].
    pub fn W_Omega(&self) -> f64 {
        let x = self.x();
        -6.0 * self.mu * self.P_0 * self.R * x * (1.0 - 1.5 * x * (1.0 - 4.0 / 9.0 * x))
    }

    /// (13) Q₁ = Q_P P₁ + Q_Ω Ω₁ \[N\].
    pub fn Q_1_of(&self, P_1: Complex64, Omega_1: Complex64) -> Complex64 {
        self.Q_P() * P_1 + self.Q_Omega() * Omega_1
    }

    /// (14) W₁ = W_P P₁ + W_Ω Ω₁ \[W\].
    pub fn W_1_of(&self, P_1: Complex64, Omega_1: Complex64) -> Complex64 {
        self.W_P() * P_1 + self.W_Omega() * Omega_1
    }

    /// (15) I_w dΩ/dt = (Q − Q₀)R, solved for dΩ/dt \[rad/s²\].
    pub fn dOmega_dt(&self, Q: f64) -> f64 {
        (Q - self.tau * self.mu * self.P_0) * self.R / self.I_w
    }

    /// (16) iωI_wΩ₁ = Q₁R, solved for Ω₁ \[rad/s\].
    pub fn Omega_1(&self) -> Complex64 {
        self.Q_1() * self.R / (i * self.omega() * self.I_w)
    }

    /// (17) Q₁ = Q_P P₁ + Q_Ω Q₁R/(iωI_w) \[N\], right-hand side. Printed without the i.
    pub fn Q_1_by_itself(&self, Q_1: Complex64) -> Complex64 {
        self.Q_P() * self.P_1() + self.Q_Omega() * Q_1 * self.R / (i * self.omega() * self.I_w)
    }

    /// (18) Q₁ = Q_P P₁ / \[1 − Q_ΩR/(iωI_w)\] \[N\].
    pub fn Q_1(&self) -> Complex64 {
        self.Q_P() / (1.0 - self.Q_Omega() * self.R / (i * self.omega() * self.I_w)) * self.P_1()
    }

    /// (19) W₁ = Q_P \[Vξ₀ + W_Ω/(iωI_w/R − Q_Ω)\] P₁ \[W\].
    pub fn W_1(&self) -> Complex64 {
        self.Q_P()
            * (self.V * self.xi_0() + self.W_Omega() / (i * self.omega() * self.I_w / self.R - self.Q_Omega()))
            * self.P_1()
    }

    /// (20) Ŵ₁ = W₁/(μP₀Vξ₀) \[-\].
    pub fn W_1_hat(&self) -> Complex64 {
        let (x, xi_max) = (self.x(), self.xi_max(self.P_0));
        let by_rotation = 6.0 / xi_max * (1.0 - 1.5 * x * (1.0 - 4.0 / 9.0 * x))
            / (i * self.I_w_hat() * self.zeta() + 3.0 / xi_max * (1.0 - x).powi(2));
        2.0 * x * (1.0 - x / 2.0) * (1.0 - by_rotation) * self.P_1() / self.P_0
    }

    /// (21) Î_w = I_wV²/(2μP₀a₀R²) \[-\].
    pub fn I_w_hat(&self) -> f64 {
        self.I_w * self.V.powi(2) / (2.0 * self.mu * self.P_0 * self.a_0() * self.R.powi(2))
    }

    /// (21) ζ = 2ωa₀/V = 4πa₀/λ \[-\].
    pub fn zeta(&self) -> f64 {
        2.0 * self.omega() * self.a_0() / self.V
    }

    /// (22) a₀ = \[3(1 − ν)RR_eP₀/(4GR_r)\]^{1/3} \[m\].
    pub fn a_0(&self) -> f64 {
        (3.0 * (1.0 - self.nu) * self.R * self.R_e() * self.P_0 / (4.0 * self.G() * self.R_r)).cbrt()
    }

    /// R_e = √(RR_r) \[m\].
    pub fn R_e(&self) -> f64 {
        (self.R * self.R_r).sqrt()
    }

    /// Below (22): θ = (2πa₀/λ)(1 − τ/2) \[rad\], 2πa₀/λ in full stick and πa₀/λ in full slip.
    pub fn theta(&self) -> f64 {
        2.0 * PI * self.a_0() / self.lambda * (1.0 - self.tau / 2.0)
    }

    /// Below (22): W₁ at a point of the rail \[W\]. `Lag` is the reading behind the paper's figures.
    pub fn W_1_at_rail(&self, phase: DissipationPhase) -> Complex64 {
        let lag = match phase {
            DissipationPhase::Lag => self.theta(),
            DissipationPhase::Lead => -self.theta(),
            DissipationPhase::None => 0.0,
        };
        self.W_1() * (-i * lag).exp()
    }
}

/// Section 3: vertical dynamics.
impl Paper {
    /// (23) H_rail = exp(−i3π/4) / \[2√2 (m_rail³EI_rail)^{1/4} ω^{3/2}\] \[m/N\].
    pub fn H_rail(&self) -> Complex64 {
        let stiffness = (self.m_rail.powi(3) * self.E * self.I_rail).powf(0.25) * self.omega().powf(1.5);
        (-i * 3.0 * PI / 4.0).exp() / (2.0 * 2.0_f64.sqrt() * stiffness)
    }

    /// (24) P₁ = Δ/(H_rail + H_w + 1/k_H) \[N\].
    pub fn P_1(&self) -> Complex64 {
        self.Delta / (self.H_rail() + self.H_w() + 1.0 / self.k_H())
    }

    /// (25) H_w = −1/(m_wω²) \[m/N\].
    pub fn H_w(&self) -> f64 {
        -1.0 / (self.m_w * self.omega().powi(2))
    }

    /// (26) k_H = \[6G²P₀R_e/(1 − ν)²\]^{1/3} \[N/m\]. Printed with (1 − ν²).
    pub fn k_H(&self) -> f64 {
        (6.0 * self.G().powi(2) * self.P_0 * self.R_e() / (1.0 - self.nu).powi(2)).cbrt()
    }
}

/// Appendix: the rail under a load F₀ exp(iωt) that moves at V, without damping.
impl Paper {
    /// (27) and (28) with Ĉ → 0: u = U(x − Vt) exp(iωt) under F₀ = 1 N \[m/N\], ξ = (x − Vt)ω/V; real part.
    pub fn u(&self, x: f64, t: f64) -> f64 {
        let xi = (x - self.V * t) * self.omega() / self.V;
        let ([s_1, s_2, s_3, s_4], [A_1, A_2, A_3, A_4]) = (self.s(), self.A());
        let U = match xi > 0.0 {
            true => A_1 * (s_1 * xi).exp() + A_4 * (s_4 * xi).exp(),
            false => A_2 * (s_2 * xi).exp() + A_3 * (s_3 * xi).exp(),
        };
        (U * (i * self.omega() * t).exp()).re
    }

    /// (29) K = EIω²/(mV⁴) \[-\].
    pub fn K(&self) -> f64 {
        self.E * self.I_rail * self.omega().powi(2) / (self.m_rail * self.V.powi(4))
    }

    /// (30) Kσ⁴ − σ² + 2σ − 1 + Ĉ(−iσ + i) = 0, its roots s = iσ for Ĉ → 0⁺, K > 1/16: s₁ and s₄ die out ahead of the load, s₂ and s₃
    /// behind it; s₃ and s₄ by g₃ and g₄, whose parts along Ĉ are −1/(2i√(1 + 4k)) and its opposite.
    pub fn s(&self) -> [Complex64; 4] {
        let k = self.K().sqrt();
        let (first, second) = (Complex64::from(1.0 - 4.0 * k).sqrt(), (1.0 + 4.0 * k).sqrt());
        [1.0 + first, 1.0 - first, (second - 1.0).into(), (-1.0 - second).into()].map(|sigma| i * sigma / (2.0 * k))
    }

    /// (31) and (32), solved for A₁ to A₄ under F₀ = 1 N \[m/N\]: continuity of u, u′ and u″, and the jump V³/(EIω³) of u‴. Each is the
    /// jump over the product of the differences of its root from the others, of opposite sign behind the load.
    pub fn A(&self) -> [Complex64; 4] {
        let s = self.s();
        let jump = self.V.powi(3) / (self.E * self.I_rail * self.omega().powi(3));
        let of = |j: usize| {
            let others = (0..4).filter(|&other| other != j);
            jump / others.map(|other| s[j] - s[other]).product::<Complex64>()
        };
        [of(0), -of(1), -of(2), of(3)]
    }

    /// (33) u₀ = A₁ + A₄ under F₀ = 1 N \[m/N\]: the receptance under the moving load, (23) for V → 0.
    pub fn u_0(&self) -> Complex64 {
        let [A_1, _, _, A_4] = self.A();
        A_1 + A_4
    }
}

#[cfg(test)]
mod tests;
