//! The page against the loop, and against itself.

use std::sync::Arc;

use proptest::prelude::*;

use super::*;
use crate::contact::{MeanState, QuasiStatic};
use crate::feedback::OneWheel;
use crate::receptance::{EulerBernoulliBeam, FreeBeam, MovingBeam};
use crate::wheelset::{Motion, RigidInertia, RigidMass};
use crate::*;

const PHASES: [DissipationPhase; 3] = [DissipationPhase::Lag, DissipationPhase::Lead, DissipationPhase::None];

fn rail(paper: &Paper) -> EulerBernoulliBeam {
    let steel = ElasticMaterial::new(paper.E, paper.nu).unwrap();
    EulerBernoulliBeam::new(steel, paper.I_rail, paper.m_rail).unwrap()
}

fn feedback(paper: &Paper, phase: DissipationPhase) -> (Loop, HertzContact) {
    let steel = ElasticMaterial::new(paper.E, paper.nu).unwrap();
    let hertz = HertzContact::new(steel, paper.R, paper.R_r, paper.P_0).unwrap();
    let law = Carter3d::new(hertz, paper.mu).unwrap();
    let contact = QuasiStatic::new(law, paper.P_0, MeanState::TractiveRatio(paper.tau)).unwrap();
    let wear = EnergyWear::new(1e-9, STEEL_DENSITY, hertz.semi_axis_lateral()).unwrap();
    let one = OneWheel {
        track: Arc::new(FreeBeam::new(rail(paper))),
        wheel: Arc::new(RigidMass::new(paper.m_w).unwrap()),
        contact_stiffness: hertz.stiffness(),
        contact: Arc::new(contact),
        rotation: Motion::compliant(RigidInertia::new(paper.I_w, paper.R).unwrap()),
        wave: None,
        place_of_wear: PlaceOfWear::new(phase, hertz.semi_axis_longitudinal(), paper.tau),
        wear,
        amplitude: paper.Delta,
    };
    (one.close().unwrap(), hertz)
}

/// Equal to 1e-12 of the modulus: some tens of roundings, cube roots of τ near one among them.
fn same(one: impl Into<Complex64>, other: impl Into<Complex64>) -> Result<(), TestCaseError> {
    let (one, other) = (one.into(), other.into());
    prop_assert!((one - other).norm() <= 1e-12 * other.norm(), "{one:e} {other:e}");
    Ok(())
}

prop_compose! {
    fn papers()(
        tau in 0.01..0.98, mu in 0.1..0.6, P_0 in 20e3..120e3, R in 0.3..0.6, R_r in 0.15..0.6,
        m_w in 200.0..900.0, inertia in 0.1..10.0, V in 5.0..80.0, lambda in 0.02..0.3,
    ) -> Paper {
        let I_w = inertia * Paper::NOMINAL.I_w;
        Paper { tau, mu, P_0, R, R_r, m_w, I_w, V, lambda, ..Paper::NOMINAL }
    }
}

proptest! {
    /// (1) to (26) are the loop.
    #[test]
    fn the_page_is_the_loop(paper in papers()) {
        for phase in PHASES {
            let (feedback, hertz) = feedback(&paper, phase);
            let state = feedback.at(paper.lambda, paper.V);
            let steady = feedback.steady();
            same(paper.omega(), state.angular_frequency)?;
            same(paper.a_0(), hertz.semi_axis_longitudinal())?; // (22)
            same(paper.k_H(), hertz.stiffness())?; // (26)
            let law = Carter3d::new(hertz, paper.mu).unwrap();
            same(paper.xi_max(paper.P_0), law.saturation_creepage())?; // (6), (7)
            same(paper.xi_0(), steady.creepages.longitudinal)?; // (2), (5)
            same(paper.W_0(), state.mean_dissipation)?; // (8)
            let (by_load, by_creepage) = (state.response.by_load, state.response.by_longitudinal);
            same(paper.Q_P(), by_load.force[0])?; // (9)
            same(paper.Q_Omega(), by_creepage.force[0] * (-paper.R / paper.V))?; // (10)
            same(paper.W_P(), by_load.energy * paper.V)?; // (11)
            same(paper.W_Omega(), by_creepage.energy * -paper.R)?; // (12)
            same(paper.H_rail(), state.normal_receptance())?; // (23)
            same(paper.P_1(), state.normal_force())?; // (24), (25)
            same(paper.Q_1(), state.tangential_force())?; // (18)
            same(paper.xi_1(), state.creepage())?; // (4), (16)
            same(paper.W_1(), state.dissipation)?; // (19)
            same(paper.W_1_at_rail(phase), state.dissipation_at_rail)?;
            let lag = state.normalized_dissipation * (i * state.dissipation_lag_angle).exp();
            same(paper.W_1_hat(), lag)?; // (20), (21)
        }
    }

    /// (13) to (17) hold of what (18) and (19) solve them for; (3) and (15) of the mean state.
    #[test]
    fn the_page_is_consistent(paper in papers()) {
        let (P_1, Omega_1) = (paper.P_1(), paper.Omega_1());
        same(paper.Q_1_of(P_1, Omega_1), paper.Q_1())?; // (13)
        same(paper.W_1_of(P_1, Omega_1), paper.W_1())?; // (14)
        same(paper.Q_1_by_itself(paper.Q_1()), paper.Q_1())?; // (17)
        // One minus one thousandth loses three digits.
        prop_assert!((paper.xi(paper.Omega_0()) - paper.xi_0()).abs() < 1e-15); // (3)
        let step = 1e-3 * paper.P_0;
        let torque = paper.dOmega_dt(paper.tau * paper.mu * paper.P_0 + step) * paper.I_w; // (15)
        prop_assert!((torque / (step * paper.R) - 1.0).abs() < 1e-10);
        prop_assert!((paper.P(0.0) - paper.P_0 - P_1.re).abs() < 1e-9 * paper.P_0); // (1)
    }

    /// (9) and (11) are derivatives of (5) with ξ_max ∝ P^{1/3}: central differences, error 1e-10 of truncation and 1e-10 of rounding.
    #[test]
    fn derivatives_by_the_load(paper in papers()) {
        let (step, xi_0) = (1e-5 * paper.P_0, paper.xi_0());
        let slope = (paper.Q(paper.P_0 + step, xi_0) - paper.Q(paper.P_0 - step, xi_0)) / (2.0 * step);
        prop_assert!((slope - paper.Q_P()).abs() < 1e-8 * paper.mu, "{slope} {}", paper.Q_P());
    }

    /// (29) to (33) are the moving load. The four roots nearly form a square at low speed, and products of their differences lose
    /// digits: 1e-11.
    #[test]
    fn the_appendix_is_the_moving_load(paper in papers()) {
        let beam = MovingBeam::new(rail(&paper));
        let receptance = beam.receptance(paper.omega(), paper.V);
        prop_assert!((paper.u_0() - receptance).norm() < 1e-11 * receptance.norm());
        let (K, [s_1, s_2, s_3, s_4], [A_1, A_2, A_3, A_4]) = (paper.K(), paper.s(), paper.A());
        for s in paper.s() {
            let sigma = s / i;
            let residual = K * sigma.powi(4) - sigma * sigma + 2.0 * sigma - 1.0; // (30)
            prop_assert!(residual.norm() < 1e-12 * (sigma * sigma).norm().max(1.0), "{residual}");
        }
        let size = A_1.norm() + A_2.norm();
        for power in 0..3 {
            let ahead = A_1 * s_1.powi(power) + A_4 * s_4.powi(power);
            let behind = A_2 * s_2.powi(power) + A_3 * s_3.powi(power);
            prop_assert!((ahead - behind).norm() < 1e-11 * size * s_1.norm().powi(power)); // (31)
        }
        let jump = A_1 * s_1.powi(3) + A_4 * s_4.powi(3) - A_2 * s_2.powi(3) - A_3 * s_3.powi(3);
        let asked = paper.V.powi(3) / (paper.E * paper.I_rail * paper.omega().powi(3));
        prop_assert!((jump / asked - 1.0).norm() < 1e-10); // (32)
    }
}

/// (28) by finite differences of (27), ahead of the load and behind it: E I u'''' + m ü = 0. Fourth differences of step 2 % of the
/// wave leave 1e-3 of truncation.
#[test]
fn the_field_solves_the_equation_of_the_beam() {
    let paper = Paper::NOMINAL;
    let wave = 2.0 * PI * (paper.E * paper.I_rail / (paper.m_rail * paper.omega().powi(2))).powf(0.25);
    let (dx, dt) = (0.02 * wave, 0.02 / paper.omega());
    for x in [-1.3 * wave, -0.4 * wave, 0.4 * wave, 0.9 * wave] {
        let u = |n: f64| paper.u(x + n * dx, 0.0);
        let bending = (u(-2.0) - 4.0 * u(-1.0) + 6.0 * u(0.0) - 4.0 * u(1.0) + u(2.0)) / dx.powi(4);
        let inertia = (paper.u(x, dt) - 2.0 * paper.u(x, 0.0) + paper.u(x, -dt)) / dt.powi(2);
        let [bending, inertia] = [paper.E * paper.I_rail * bending, paper.m_rail * inertia];
        let size = paper.m_rail * paper.omega().powi(2) * paper.u_0().norm();
        assert!((bending + inertia).abs() < 5e-3 * size, "{x} {bending} {inertia}");
    }
}

/// Fig. 3: Δ is chosen so that max |P₁/P₀| is one, which (26) gives to 3 % with (1 − ν)².
#[test]
fn the_largest_force_is_that_of_figure_3() {
    let largest = (100..3000).map(|frequency| {
        let paper = Paper { lambda: Paper::NOMINAL.V / f64::from(frequency), ..Paper::NOMINAL };
        paper.P_1().norm() / paper.P_0
    });
    let largest = largest.fold(0.0, f64::max);
    assert!((largest - 1.029).abs() < 1e-3, "{largest}");
}
