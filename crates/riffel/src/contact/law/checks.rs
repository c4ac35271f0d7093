//! What the tests of every creep law share.

use super::{CreepEllipse, CreepForces, CreepLaw, Creepages, ForceLimit};
use approx::assert_relative_eq;

/// The contact of the reference creep curve: 0.46 m on 0.23 m, 50 kN, E = 207 GPa, ν = 0.3.
///
/// Kalker (1990), table E.3, linear in b/a = 0.6306 between 0.6 and 0.7, 1/C quadratic in ν.
pub(in crate::contact) const ELLIPSE: CreepEllipse = CreepEllipse {
    normal_force: 50e3,
    semi_axis_longitudinal: 5.944e-3,
    semi_axis_lateral: 3.748e-3,
    shear_modulus: 79.6e9,
    c11: 4.882_1,
    c22: 4.506_4,
    c23: 2.191_8,
};

/// Derivatives against central differences with the relative step `step`. The tolerance is relative
/// to the largest slope of the law; a difference that straddles full slip is left out, because the
/// corner halves it.
pub(in crate::contact) fn derivatives_match(
    law: &dyn CreepLaw,
    force: f64,
    creepages: Creepages,
    step: f64,
    tolerance: f64,
) {
    let at = law.derivatives(force, creepages);
    let central = |high: CreepForces, low: CreepForces, width: f64| high.combine(1.0 / width, low, -1.0 / width);
    let shifted = |xi: f64, eta: f64| Creepages {
        longitudinal: creepages.longitudinal + xi,
        lateral: creepages.lateral + eta,
        ..creepages
    };
    let scale = law.friction() * force;
    let creepage = scale / ELLIPSE.under(force).linear_slopes()[0];
    let (dp, dx) = (step * force, step * creepage);
    let steepest = scale / creepage;
    let rows = [
        (
            at.by_normal_force,
            central(law.forces(force + dp, creepages), law.forces(force - dp, creepages), 2.0 * dp),
            law.friction(),
        ),
        (
            at.by_longitudinal,
            central(law.forces(force, shifted(dx, 0.0)), law.forces(force, shifted(-dx, 0.0)), 2.0 * dx),
            steepest,
        ),
        (
            at.by_lateral,
            central(law.forces(force, shifted(0.0, dx)), law.forces(force, shifted(0.0, -dx)), 2.0 * dx),
            steepest,
        ),
    ];
    for (exact, difference, scale) in rows {
        let tolerance = (tolerance + 4.0 * step) * scale;
        assert_relative_eq!(exact.longitudinal, difference.longitudinal, epsilon = tolerance);
        assert_relative_eq!(exact.lateral, difference.lateral, epsilon = tolerance);
    }
}

/// |F| ≤ μP, and F is odd in the creepages.
pub(in crate::contact) fn stays_below_friction(law: &dyn CreepLaw, force: f64, creepages: Creepages) {
    let forces = law.forces(force, creepages);
    assert!(forces.magnitude() <= law.friction() * force * (1.0 + 1e-12));
    let opposite = law.forces(
        force,
        Creepages { longitudinal: -creepages.longitudinal, lateral: -creepages.lateral, spin: -creepages.spin },
    );
    let rounding = 1e-12 * law.friction() * force;
    assert_relative_eq!(forces.longitudinal, -opposite.longitudinal, epsilon = rounding);
    assert_relative_eq!(forces.lateral, -opposite.lateral, epsilon = rounding);
}

/// A thousandth of a small creepage answers as the linear theory says, to the relative tolerance.
pub(in crate::contact) fn starts_linear(
    law: &dyn CreepLaw,
    ellipse: &CreepEllipse,
    force: f64,
    creepages: Creepages,
    tolerance: f64,
) {
    let linear = ellipse.under(force).linear_forces(creepages);
    // u = 1e-5 leaves a bend of u/3.
    let small = 1e-5 * law.friction() * force / linear.magnitude();
    let creepages = Creepages {
        longitudinal: small * creepages.longitudinal,
        lateral: small * creepages.lateral,
        spin: small * creepages.spin,
    };
    let forces = law.forces(force, creepages);
    let tolerance = tolerance * small * linear.magnitude();
    assert_relative_eq!(forces.longitudinal, small * linear.longitudinal, epsilon = tolerance);
    assert_relative_eq!(forces.lateral, small * linear.lateral, epsilon = tolerance);
}

/// The longitudinal force grows up to the limit of the law, and is μP beyond full slip.
pub(in crate::contact) fn grows_to_limit(law: &dyn CreepLaw, force: f64) {
    let limit = law.limit(force);
    let at = |xi: f64| law.forces(force, Creepages::longitudinal(xi)).longitudinal;
    let mut last = 0.0;
    for i in 1..=100 {
        let next = at(f64::from(i) / 100.0 * limit.creepage());
        assert!(next > last, "{next} after {last} at step {i}");
        last = next;
    }
    match limit {
        ForceLimit::FullSlip(creepage) => {
            assert_relative_eq!(at(creepage), law.friction() * force, max_relative = 1e-12);
            assert_relative_eq!(at(2.0 * creepage), law.friction() * force, max_relative = 1e-12);
        }
        ForceLimit::AdhesionMaximum(creepage) => assert!(at(1.02 * creepage) < last),
        ForceLimit::None => {}
    }
}
