mod every_direction;
mod table;

use num_complex::Complex64;

use super::influence::Convolution;
use super::*;
use crate::contact::NonSteady;
use crate::fixtures::{hertz, steel};
use every_direction::{derivatives, oblique};

fn contact(across: usize) -> HalfSpace {
    HalfSpace::new(hertz(), 0.4, across).unwrap()
}

/// Under the traction q√(1 − r²/a²) along x over a circle both bodies move apart by
/// (πq/16Ga)\[4(2 − ν)a² − (4 − 3ν)x² − (4 − ν)y²\] within it (Johnson 1985, equation 3.91). Elements
/// of constant traction on 40 × 40, and the staircase of the edge: 0.5 %.
#[test]
fn influence_is_cerrutis() {
    let (a, q) = (5e-3, 1e6);
    let patch = Patch::new(a, a, 40).unwrap();
    let influence = Influence::new(steel(), &patch);
    let pressure = patch.pressure_of((a, a)).into_iter();
    let along: Vec<f64> = pressure.map(|share| q * share).collect();
    let across = vec![0.0; patch.len()];
    let moved = Convolution::new(&influence, &patch).real([&along, &across], [1.0, 0.0]);
    let (g, poisson) = (steel().shear_modulus(), 0.3);
    for (index, &(x, y)) in patch.centres.iter().enumerate() {
        let expected = std::f64::consts::PI * q / (16.0 * g * a)
            * (4.0 * (2.0 - poisson) * a * a - (4.0 - 3.0 * poisson) * x * x - (4.0 - poisson) * y * y);
        let error = (moved[0][index] - expected).abs() / expected;
        assert!(error < 5e-3, "{x} {y}: {error}");
    }
}

/// The transform of both parts at once is the difference of two displacements.
#[test]
fn difference_is_that_of_apply() {
    let patch = Patch::new(6e-3, 4e-3, 16).unwrap();
    let influence = Influence::new(steel(), &patch);
    let count = patch.len();
    let tractions =
        [0, 1].map(|part| -> Vec<f64> { (0..count).map(|index| ((3 + part) as f64 * index as f64).sin()).collect() });
    let complex =
        [0, 1].map(|part: usize| tractions[part].iter().map(|&value| Complex64::from(value)).collect::<Vec<_>>());
    let mut convolution = Convolution::new(&influence, &patch);
    let expected = convolution.complex([&complex[0], &complex[1]], [Complex64::ONE, -Complex64::ONE]);
    let got = convolution.real([&tractions[0], &tractions[1]], [1.0, -1.0]);
    let size = expected[0].iter().map(|value| value.norm()).fold(0.0, f64::max);
    for part in 0..2 {
        for (got, expected) in got[part].iter().zip(&expected[part]) {
            assert!((got - expected.re).abs() < 1e-13 * size);
        }
    }
}

/// The creep force of one grid errs in proportion to the size of its elements: the difference from n
/// to 2n is twice that from 2n to 4n, within what the staircase of the edge adds.
#[test]
fn error_is_of_first_order() {
    let force = |across: usize| {
        let grid = Grid::new(hertz(), 0.4, across).unwrap();
        let state = grid.roll(Creepages::longitudinal(5e-4), None).unwrap();
        grid.patch.forces(&state.tractions).longitudinal
    };
    let [coarse, middle, fine] = [12, 24, 48].map(force);
    let ratio = (coarse - middle) / (middle - fine);
    assert!((1.5..3.0).contains(&ratio), "{ratio}");
    // What extrapolation leaves is a tenth of the error of the finer of its two grids.
    let (once, twice) = (2.0 * middle - coarse, 2.0 * fine - middle);
    assert!((once - twice).abs() < 0.2 * (middle - fine).abs(), "{once} {twice}");
}

/// Friction holds everywhere: |p| ≤ μp, and traction along the slip where it slips.
#[test]
fn friction_law_holds() {
    let contact = contact(24);
    let state = contact.roll(1.5e-3).unwrap();
    let mut slipping = 0;
    for (index, element) in contact.elements(&state).enumerate() {
        let (x, y) = element.traction;
        assert!(x.hypot(y) <= element.bound * (1.0 + 1e-4), "{element:?}");
        if element.slips {
            slipping += 1;
            let slip = [0, 1].map(|part| state.fine.distance[part][index]);
            let along = (x * slip[0] + y * slip[1]) / (x.hypot(y) * slip[0].hypot(slip[1]));
            assert!(along > 1.0 - 1e-3, "{along}");
        }
    }
    assert!(slipping > 50);
}

/// The slope of the creep curve is the response at zero frequency, and the dissipation there is that of
/// ξQ: the balance of energy. The curve is that of elements that slip whole and is extrapolated by another order: 1 %.
#[test]
fn slow_response_is_the_slope_of_the_creep_curve() {
    let contact = contact(36);
    let creepage = 1e-3;
    let state = contact.roll(creepage).unwrap();
    let step = 0.1 * creepage;
    let force = |creepage: f64| contact.roll(creepage).unwrap().tangential_force();
    let slope = (force(creepage + step) - force(creepage - step)) / (2.0 * step);
    let response = contact.response(&state, f64::INFINITY).unwrap();
    assert!(
        (response.by_longitudinal.force[0].re / slope - 1.0).abs() < 1e-2,
        "{} {slope}",
        response.by_longitudinal.force[0]
    );
    let energy = state.tangential_force() + creepage * response.by_longitudinal.force[0].re;
    assert!((response.by_longitudinal.energy.re / energy - 1.0).abs() < 5e-3);
    assert!((response.by_load.energy.re / (creepage * response.by_load.force[0].re) - 1.0).abs() < 1e-3);
}

/// By dimension Q/μP depends on the creepage over μ(P/GR²)^{1/3} alone: the response to load at zero
/// frequency, against the steady state under another load.
#[test]
fn slow_response_to_load_is_that_of_another_load() {
    let contact = contact(24);
    let state = contact.roll(1e-3).unwrap();
    let force = |load: f64| {
        let other = HalfSpace::new(hertz().under(load), 0.4, 24).unwrap();
        other.roll(1e-3).unwrap().tangential_force()
    };
    let slope = (force(50.1e3) - force(49.9e3)) / 200.0;
    let response = contact.response(&state, f64::INFINITY).unwrap();
    assert!((response.by_load.force[0].re / slope - 1.0).abs() < 5e-3, "{} {slope}", response.by_load.force[0]);
}

/// Long waves leave at the rail what they dissipate at the wheel; short ones hardly move the force.
#[test]
fn limits_of_wavelength() {
    let contact = contact(24);
    let state = contact.roll_at_tractive_ratio(0.3).unwrap();
    let limit = contact.response(&state, f64::INFINITY).unwrap();
    let rail = [limit.by_load.at_rail(0.0), limit.by_longitudinal.at_rail(0.0)];
    assert!((rail[1] - limit.by_longitudinal.energy).norm() < 1e-9 * limit.by_longitudinal.energy.norm());
    let long = contact.response(&state, 6.0).unwrap();
    assert!(
        (long.by_longitudinal.force[0] - limit.by_longitudinal.force[0]).norm()
            < 0.02 * limit.by_longitudinal.force[0].norm()
    );
    let short = contact.response(&state, 9e-3).unwrap();
    assert!(short.by_longitudinal.force[0].norm() < 0.3 * limit.by_longitudinal.force[0].norm());
    assert!(short.by_longitudinal.force[0].im < 0.0, "a contact answers late");
}

#[test]
fn tractive_ratio_is_met() {
    let contact = contact(16);
    for ratio in [0.05, 0.5, 0.95] {
        let state = contact.roll_at_tractive_ratio(ratio).unwrap();
        assert!((state.tangential_force() / 20e3 - ratio).abs() < 1e-6);
    }
    assert!(contact.roll_at_tractive_ratio(1.0).is_err());
    assert!(contact.roll(-1e-3).is_err());
    assert!(HalfSpace::new(hertz(), 0.4, 15).is_err());
    assert!(HalfSpace::new(hertz(), 0.0, 16).is_err());
}

/// A wavelength of a few elements is refused.
#[test]
fn too_coarse_a_grid_is_refused() {
    let contact = contact(16);
    let state = contact.roll(1e-3).unwrap();
    let error = contact.response(&state, 4e-3).unwrap_err().to_string();
    assert!(error.contains("refine the grid"), "{error}");
}

/// A long wave is a wheel of the radius R/(1 + κ) that rolls slower by 1 + κ, in every direction and with spin. The response of the grid
/// of 36 is within 2 %, the differences of forces within 0.5 %.
#[test]
fn slow_wave_is_the_slope_by_the_radius() {
    const STEP: f64 = 0.05;
    let exact = HertzContact::exact(steel(), 0.46, 0.23, 50e3).unwrap();
    let on = |curvature: f64| {
        let hertz = exact.curved(curvature).unwrap();
        HalfSpace::new(hertz, 0.4, 36).unwrap()
    };
    let contact = on(0.0);
    let state = contact.roll_with(oblique()).unwrap();
    let steady = contact.steady(&state);
    let by_radius = crate::contact::WaveGeometry::derivative(STEP, |curvature| {
        let forces = on(curvature).roll_with(oblique())?.forces();
        Ok::<_, Error>([forces.longitudinal, forces.lateral])
    });
    let by_radius = by_radius.map(|[longitudinal, lateral]| CreepForces { longitudinal, lateral });
    let response = contact.response(&state, f64::INFINITY).unwrap();
    let got = response.by_curvature.unwrap();
    let expected = response.with_curvature(by_radius.unwrap(), &steady).by_curvature.unwrap();
    let size = steady.forces.magnitude();
    for part in 0..2 {
        let missed = (got.force[part] - expected.force[part]).norm();
        assert!(missed < 0.02 * size, "{part}: {missed} of {size}");
    }
}

/// Waves much shorter than the patch shear it without rolling, with the stiffness 4Ga/(2 − ν) of a circle along and
/// across. Tractions are infinite at the edge and the waves have eight elements: 8 %.
#[test]
fn short_waves_meet_mindlins_stiffness() {
    let hertz = HertzContact::exact(steel(), 0.3, 0.3, 50e3).unwrap();
    let a = hertz.semi_axis_longitudinal();
    let stiffness = 4.0 * hertz.material().shear_modulus() * a / 1.7;
    let contact = HalfSpace::new(hertz, 0.4, 64).unwrap();
    let state = contact.roll(0.0).unwrap();
    let [short, long] = [0.5, 1.0].map(|ratio| {
        let response = derivatives(contact.response(&state, ratio * a).unwrap());
        let wavenumber = Complex64::new(0.0, 2.0 * std::f64::consts::PI / (ratio * a));
        [response[1].force[0], response[2].force[1]].map(|force| force * wavenumber / stiffness)
    });
    for (short, long) in short.into_iter().zip(long) {
        assert!((short - 1.0).norm() < 0.08, "{short}");
        assert!((short - 1.0).norm() < (long - 1.0).norm(), "{short} {long}");
    }
}

/// What a point of the rail receives of a long wave is quasi-static, but for a share that goes with ka.
#[test]
fn long_waves_are_quasi_static() {
    let contact = contact(24);
    let a = hertz().semi_axis_longitudinal();
    let state = contact.roll_with(oblique()).unwrap();
    let slow = derivatives(contact.response(&state, f64::INFINITY).unwrap());
    let deviation = |ratio: f64| {
        let response = derivatives(contact.response(&state, ratio * a).unwrap());
        let at_rail = [0, 1, 2, 3].map(|input| response[input].at_rail(0.0));
        let slow = slow.map(|by| by.energy);
        [0, 1, 2, 3].map(|input| (at_rail[input] / slow[input] - 1.0).norm())
    };
    let (long, longer) = (deviation(100.0), deviation(400.0));
    for (long, longer) in long.into_iter().zip(longer) {
        assert!(long < 0.15, "{long}");
        assert!((3.0..5.0).contains(&(long / longer)), "{long} {longer}");
    }
}

/// What a steady state and a response cost, in sums over all elements: those needed today and a tenth
/// more. A preconditioner or a start that is lost shows here without a clock.
#[test]
fn work_of_the_half_space() {
    use super::influence::CONVOLUTIONS;
    let contact = contact(36);
    let products = |work: &mut dyn FnMut()| {
        let before = CONVOLUTIONS.get();
        work();
        CONVOLUTIONS.get() - before
    };
    let mut state = None;
    let steady = products(&mut || state = Some(contact.roll(1e-3).unwrap()));
    let state = state.unwrap();
    let response = products(&mut || {
        for wavelength in [0.03, 0.05, 0.08] {
            contact.response(&state, wavelength).unwrap();
        }
    });
    let table = |oscillating: Oscillating| {
        let tolerance = NonSteady::DEFAULT_TOLERANCE;
        NonSteady::new(&contact, &state, oscillating, 0.02, 0.2, tolerance).unwrap();
    };
    let flat = products(&mut || table(OscillatingCreepages::Longitudinal.into()));
    let wavy = products(&mut || table(OscillatingCreepages::Longitudinal.on_waves()));
    assert!(10 * wavy <= 16 * flat, "{wavy} sums over all elements for a table on waves, {flat} without");
    assert!((1..=82).contains(&steady), "{steady} sums over all elements for a steady state");
    assert!((1..=878).contains(&response), "{response} sums over all elements for three responses");
}
