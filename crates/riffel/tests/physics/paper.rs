//! The paper's rail and its contact on waves.

use std::sync::Arc;

use riffel::receptance::FreeBeam;
use riffel::{Carter3d, Complex64, Error, HertzContact, Receptance};

use crate::fixtures::{hertz, rail};

/// The free rail of the paper.
pub(crate) fn free_beam() -> Arc<dyn Receptance> {
    Arc::new(FreeBeam::new(rail()))
}

/// The contact of the paper on waves: the wheel has the radius R/(1 + κ).
pub(crate) fn hertz_on_wave(curvature: f64) -> Result<HertzContact, Error> {
    hertz().with_longitudinal_radius(hertz().rolling_radius() / (1.0 + curvature))
}

/// The law of the paper on waves.
pub(crate) fn law_on_wave(curvature: f64) -> Result<Carter3d, Error> {
    Carter3d::new(hertz_on_wave(curvature)?, 0.4)
}

/// Assert equality to a relative tolerance.
pub(crate) fn close(got: Complex64, expected: Complex64, tolerance: f64) {
    let off = (got - expected).norm();
    assert!(off <= tolerance * expected.norm(), "{got} {expected}: {off:.1e}");
}
