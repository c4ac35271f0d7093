//! Convergence of the exact theory of rolling contact.

use riffel::contact::HalfSpace;
use riffel::{Complex64, HertzContact};

use crate::fixtures::steel;

/// Creep force and, at λ = 8a and over its quasi-static value, its response to creepage.
fn at(across: usize) -> (f64, Complex64) {
    let hertz = HertzContact::exact(steel(), 0.46, 0.23, 50e3).unwrap();
    let contact = HalfSpace::new(hertz, 0.4, across).unwrap();
    let state = contact.roll(2.5e-4).unwrap();
    let response = |wavelength| contact.response(&state, wavelength).unwrap().by_longitudinal.force[0];
    let wavelength = 8.0 * hertz.semi_axis_longitudinal();
    (state.tangential_force() / 20e3, response(wavelength) / response(f64::INFINITY))
}

/// What extrapolation leaves falls with the grid. 0.1045 and 0.737∠−0.829 are the values of 144
/// elements; each limit is the error found and half as much again.
#[test]
fn responses_converge() {
    let limit = Complex64::from_polar(0.737, -0.829);
    for (across, of_force, of_response) in [(24, 1.2e-2, 1.2e-2), (36, 3e-3, 5e-3), (72, 2e-3, 3e-3)] {
        let (force, response) = at(across);
        assert!((force / 0.1045 - 1.0).abs() < of_force, "{across}: {force}");
        assert!((response - limit).norm() < of_response, "{across}: {response}");
    }
}
