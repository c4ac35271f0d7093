//! Every law against Kalker's exact half-space theory.

use super::checks::ELLIPSE;
use super::{
    Carter2d, CreepLaw, Creepages, FallingFriction, Fastsim, JohnsonVermeulen, Polach, ShenHedrickElkins,
    SlopeReduction, TractionBound,
};

/// Creepage and Q/μP of CONTACT at 50 kN, μ = 0.4, extrapolated over three grids, ±0.5 %.
const CONTACT: [[f64; 2]; 18] = [
    [0.0001, 0.04271],
    [0.0002, 0.08433],
    [0.00035, 0.14456],
    [0.0005, 0.20220],
    [0.00075, 0.29271],
    [0.001, 0.37718],
    [0.00125, 0.45521],
    [0.0015, 0.52693],
    [0.00175, 0.59238],
    [0.002, 0.65188],
    [0.0025, 0.75474],
    [0.003, 0.83637],
    [0.0035, 0.89856],
    [0.004, 0.94330],
    [0.0045, 0.97295],
    [0.005, 0.99035],
    [0.006, 0.99924],
    [0.008, 0.99961],
];

/// Lowest and highest deviation of Q/μP from CONTACT \[% of the local value\].
fn deviation(law: &dyn CreepLaw) -> [f64; 2] {
    let limit = law.friction() * 50e3;
    CONTACT.iter().fold([f64::MAX, f64::MIN], |[low, high], &[xi, exact]| {
        let ratio = law.forces(50e3, Creepages::longitudinal(xi)).longitudinal / limit;
        let percent = 100.0 * (ratio / exact - 1.0);
        [low.min(percent), high.max(percent)]
    })
}

/// The ranges that the laws' documentation states.
#[test]
fn deviation_from_exact_theory_is_as_documented() {
    let coulomb = FallingFriction::constant(0.4);
    let fastsim = |bound| Fastsim::new(ELLIPSE, 0.4, bound, Fastsim::DEFAULT_DIVISIONS).unwrap();
    let laws: [(&str, &dyn CreepLaw, [f64; 2]); 6] = [
        ("Carter", &Carter2d::of_ellipse(ELLIPSE, 0.3, 0.4).unwrap(), [-27.39, 0.04]),
        ("Vermeulen and Johnson", &JohnsonVermeulen::new(ELLIPSE, 0.4).unwrap(), [-2.24, 0.04]),
        ("Shen, Hedrick and Elkins", &ShenHedrickElkins::new(ELLIPSE, 0.4).unwrap(), [-2.24, 0.04]),
        ("Polach", &Polach::new(ELLIPSE, coulomb, SlopeReduction::NONE, 20.0).unwrap(), [-5.13, 6.75]),
        ("FASTSIM, parabolic", &fastsim(TractionBound::Parabolic), [-3.41, 0.13]),
        ("FASTSIM, elliptic", &fastsim(TractionBound::Elliptic), [-5.15, 6.87]),
    ];
    for (name, law, [low, high]) in laws {
        let found = deviation(law);
        assert!((found[0] - low).abs() < 0.06 && (found[1] - high).abs() < 0.06, "{name}: {found:.2?} %");
    }
}
