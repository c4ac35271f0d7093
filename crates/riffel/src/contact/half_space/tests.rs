use num_complex::Complex64;

use super::influence::Convolution;
use super::*;
use crate::ElasticMaterial;

fn steel() -> ElasticMaterial {
    ElasticMaterial::new(207e9, 0.3).unwrap()
}

fn hertz() -> HertzContact {
    HertzContact::new(steel(), 0.46, 0.23, 50e3).unwrap()
}

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
            * (4.0 * (2.0 - poisson) * a * a
                - (4.0 - 3.0 * poisson) * x * x
                - (4.0 - poisson) * y * y);
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
    let tractions = [0, 1].map(|part| -> Vec<f64> {
        (0..count)
            .map(|index| ((3 + part) as f64 * index as f64).sin())
            .collect()
    });
    let complex = [0, 1].map(|part: usize| {
        tractions[part]
            .iter()
            .map(|&value| Complex64::from(value))
            .collect::<Vec<_>>()
    });
    let mut convolution = Convolution::new(&influence, &patch);
    let expected = convolution.complex(
        [&complex[0], &complex[1]],
        [Complex64::ONE, -Complex64::ONE],
    );
    let got = convolution.real([&tractions[0], &tractions[1]], [1.0, -1.0]);
    let size = expected[0]
        .iter()
        .map(|value| value.norm())
        .fold(0.0, f64::max);
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
    assert!(
        (once - twice).abs() < 0.2 * (middle - fine).abs(),
        "{once} {twice}"
    );
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
/// ξQ: the balance of energy.
#[test]
fn slow_response_is_the_slope_of_the_creep_curve() {
    let contact = contact(24);
    let creepage = 1e-3;
    let state = contact.roll(creepage).unwrap();
    let step = 1e-3 * creepage;
    let force = |creepage: f64| contact.roll(creepage).unwrap().tangential_force();
    let slope = (force(creepage + step) - force(creepage - step)) / (2.0 * step);
    let response = contact.response(&state, f64::INFINITY).unwrap();
    assert!(
        (response.by_longitudinal.force[0].re / slope - 1.0).abs() < 2e-3,
        "{} {slope}",
        response.by_longitudinal.force[0]
    );
    let energy = state.tangential_force() + creepage * response.by_longitudinal.force[0].re;
    assert!((response.by_longitudinal.energy.re / energy - 1.0).abs() < 1e-3);
    assert!(
        (response.by_load.energy.re / (creepage * response.by_load.force[0].re) - 1.0).abs() < 1e-3
    );
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
    assert!(
        (response.by_load.force[0].re / slope - 1.0).abs() < 5e-3,
        "{} {slope}",
        response.by_load.force[0]
    );
}

/// Long waves leave at the rail what they dissipate at the wheel; short ones hardly move the force.
#[test]
fn limits_of_wavelength() {
    let contact = contact(24);
    let state = contact.roll_at_tractive_ratio(0.3).unwrap();
    let limit = contact.response(&state, f64::INFINITY).unwrap();
    let rail = [
        limit.by_load.at_rail(0.0),
        limit.by_longitudinal.at_rail(0.0),
    ];
    assert!(
        (rail[1] - limit.by_longitudinal.energy).norm()
            < 1e-9 * limit.by_longitudinal.energy.norm()
    );
    let long = contact.response(&state, 6.0).unwrap();
    assert!(
        (long.by_longitudinal.force[0] - limit.by_longitudinal.force[0]).norm()
            < 0.02 * limit.by_longitudinal.force[0].norm()
    );
    let short = contact.response(&state, 9e-3).unwrap();
    assert!(short.by_longitudinal.force[0].norm() < 0.3 * limit.by_longitudinal.force[0].norm());
    assert!(
        short.by_longitudinal.force[0].im < 0.0,
        "a contact answers late"
    );
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

/// A table that was made for one wavelength says the same, bit for bit, as one that was made for a wide window.
#[test]
fn table_of_the_response_does_not_depend_on_its_window() {
    let contact = contact(16);
    let state = contact.roll_at_tractive_ratio(0.2).unwrap();
    let table =
        |from, to| crate::contact::NonSteady::new(&contact, &state, from, to, 1e-4).unwrap();
    let wide = table(0.02, 0.1);
    for wavelength in [0.02, 0.0311, 0.055, 0.1] {
        for other in [
            table(wavelength, wavelength),
            table(0.6 * wavelength, 1.7 * wavelength),
        ] {
            assert_eq!(
                crate::RollingContact::response(&other, wavelength),
                crate::RollingContact::response(&wide, wavelength)
            );
        }
    }
}

/// The table between its nodes, at places that are none of those it was checked at.
#[test]
fn table_of_the_response() {
    let contact = contact(16);
    let state = contact.roll_at_tractive_ratio(0.2).unwrap();
    let to =
        |tolerance| crate::contact::NonSteady::new(&contact, &state, 0.02, 0.1, tolerance).unwrap();
    for tolerance in [1e-2, 1e-4] {
        let table = to(tolerance);
        for wavelength in [0.02, 0.0213, 0.037, 0.0771, 0.1] {
            let (got, expected) = (
                crate::RollingContact::response(&table, wavelength),
                contact.response(&state, wavelength).unwrap(),
            );
            let (rail, expected_rail) = (
                [got.by_load.at_rail(0.0), got.by_longitudinal.at_rail(0.0)],
                [
                    expected.by_load.at_rail(0.0),
                    expected.by_longitudinal.at_rail(0.0),
                ],
            );
            for (got, expected) in [
                (got.by_load.force[0], expected.by_load.force[0]),
                (
                    got.by_longitudinal.force[0],
                    expected.by_longitudinal.force[0],
                ),
                (rail[0], expected_rail[0]),
                (rail[1], expected_rail[1]),
            ] {
                assert!(
                    (got - expected).norm() < 2.0 * tolerance * expected.norm(),
                    "{wavelength}"
                );
            }
        }
    }
    let table = to(1e-4);
    assert!(crate::RollingContact::response(&table, 0.01).by_load.force[0].is_nan());
}

/// What a steady state and a response cost, in products with the matrix of influences: those needed today and a tenth
/// more. A preconditioner or a start that is lost shows here without a clock.
#[test]
fn work_of_the_half_space() {
    use super::gmres::PRODUCTS;
    let contact = contact(36);
    let products = |work: &mut dyn FnMut()| {
        let before = PRODUCTS.get();
        work();
        PRODUCTS.get() - before
    };
    let mut state = None;
    let steady = products(&mut || state = Some(contact.roll(1e-3).unwrap()));
    let state = state.unwrap();
    let response = products(&mut || {
        for wavelength in [0.03, 0.05, 0.08] {
            contact.response(&state, wavelength).unwrap();
        }
    });
    assert!(
        (1..=63).contains(&steady),
        "{steady} products for a steady state"
    );
    assert!(
        (1..=260).contains(&response),
        "{response} products for three responses"
    );
}
