use num_complex::Complex64;

use super::influence::Convolution;
use super::*;
use crate::ElasticMaterial;
use crate::contact::KalkerCoefficients;
use crate::contact::{ContactDerivative, NonSteady};

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

const ALONG: OscillatingCreepages = OscillatingCreepages::Longitudinal;

/// A table that was made for one wavelength says the same, bit for bit, as one that was made for a wide window.
#[test]
fn table_of_the_response_does_not_depend_on_its_window() {
    let contact = contact(16);
    let state = contact.roll_at_tractive_ratio(0.2).unwrap();
    let table =
        |from, to| crate::contact::NonSteady::new(&contact, &state, ALONG, from, to, 1e-4).unwrap();
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
    let to = |tolerance| {
        crate::contact::NonSteady::new(&contact, &state, ALONG, 0.02, 0.1, tolerance).unwrap()
    };
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

/// Longitudinal and lateral creepage and spin about which all four inputs answer.
fn oblique() -> Creepages {
    Creepages {
        longitudinal: 6e-4,
        lateral: -4e-4,
        spin: 0.2,
    }
}

/// All derivatives of a response.
fn derivatives(response: ContactResponse) -> [ContactDerivative; 4] {
    [
        response.by_load,
        response.by_longitudinal,
        response.by_lateral.unwrap(),
        response.by_spin.unwrap(),
    ]
}

/// The error that comes with a response bounds what 24 elements miss of 64, of which the error is a quarter; at states
/// and an ellipse that were not used to find it.
#[test]
fn errors_are_bounded() {
    let hertz = HertzContact::exact(steel(), 0.4, 0.7, 80e3).unwrap();
    let [coarse, fine] = [24, 64].map(|across| HalfSpace::new(hertz, 0.3, across).unwrap());
    let a = hertz.semi_axis_longitudinal();
    let (mut largest, mut smallest): (f64, f64) = (0.0, 1.0);
    for creepages in [
        Creepages::longitudinal(9e-4),
        oblique(),
        Creepages {
            spin: 0.3,
            ..Creepages::default()
        },
    ] {
        let [got, exact] = [&coarse, &fine].map(|contact| {
            let state = contact.roll_with(creepages).unwrap();
            [3.0, 7.0].map(|ratio| derivatives(contact.response(&state, ratio * a).unwrap()))
        });
        for (got, exact) in got.iter().flatten().zip(exact.iter().flatten()) {
            let error = got.error.unwrap();
            let of_force = [0, 1].map(|part| (got.force[part] - exact.force[part]).norm());
            let of_force = of_force[0].hypot(of_force[1]);
            let of_energy = (got.energy - exact.energy).norm();
            let of_energy = of_energy.max((got.at_rail(0.0) - exact.at_rail(0.0)).norm());
            assert!(of_force <= error.force, "{creepages:?} {of_force} {got:?}");
            assert!(
                of_energy <= error.energy,
                "{creepages:?} {of_energy} {got:?}"
            );
            let share = error.force / got.force[0].norm().hypot(got.force[1].norm());
            largest = largest.max(of_force / error.force);
            smallest = smallest.min(share);
        }
    }
    // It is no idle bound either.
    assert!(largest > 0.1 && smallest < 0.05, "{largest} {smallest}");
}

/// Slow lateral creepage and spin: the slopes of the creep forces.
#[test]
fn slow_response_is_the_slope_in_every_direction() {
    let contact = contact(24);
    let state = contact.roll_with(oblique()).unwrap();
    let response = contact.response(&state, f64::INFINITY).unwrap();
    let slope = |step: Creepages| {
        let forces = [1.0, -1.0].map(|sign| {
            let creepages = Creepages {
                longitudinal: oblique().longitudinal + sign * step.longitudinal,
                lateral: oblique().lateral + sign * step.lateral,
                spin: oblique().spin + sign * step.spin,
            };
            contact.roll_with(creepages).unwrap().forces()
        });
        forces[0].combine(0.5, forces[1], -0.5)
    };
    let nothing = Creepages::default();
    for (by, step, size) in [
        (
            response.by_lateral.unwrap(),
            Creepages {
                lateral: 2e-5,
                ..nothing
            },
            2e-5,
        ),
        (
            response.by_spin.unwrap(),
            Creepages {
                spin: 1e-2,
                ..nothing
            },
            1e-2,
        ),
    ] {
        let slope = slope(step);
        let error = (by.force[0].re - slope.longitudinal / size)
            .hypot(by.force[1].re - slope.lateral / size);
        assert!(
            error < 0.02 * slope.magnitude() / size,
            "{by:?} {slope:?} {error}"
        );
    }
}

/// Q/μP depends on creepages over P^{1/3} and on the spin alone, so that P ∂Q/∂P = Q − (ξ ∂Q/∂ξ + η ∂Q/∂η)/3. The
/// elements stretch with the patch; what is left is the extrapolation of the steady force by another order.
#[test]
fn response_to_load_is_homogeneous() {
    let contact = contact(36);
    let state = contact.roll_with(oblique()).unwrap();
    let [load, longitudinal, lateral, _] =
        derivatives(contact.response(&state, f64::INFINITY).unwrap());
    let forces = [state.forces().longitudinal, state.forces().lateral];
    for (part, force) in forces.into_iter().enumerate() {
        let slopes = oblique().longitudinal * longitudinal.force[part].re
            + oblique().lateral * lateral.force[part].re;
        let expected = force - slopes / 3.0;
        let error = (50e3 * load.force[part].re - expected).abs() / state.forces().magnitude();
        assert!(error < 1e-2, "{part}: {error}");
    }
}

/// Small creepages: Kalker's coefficients, longitudinal, lateral and of spin, which drives the lateral force alone.
#[test]
fn small_creepages_are_kalkers() {
    let hertz = hertz();
    let contact = contact(36);
    let state = contact.roll(0.0).unwrap();
    let [_, longitudinal, lateral, spin] =
        derivatives(contact.response(&state, f64::INFINITY).unwrap());
    let (a, b) = (hertz.semi_axis_longitudinal(), hertz.semi_axis_lateral());
    let coefficients = KalkerCoefficients::new(0.3, a / b).unwrap();
    let scale = hertz.material().shear_modulus() * a * b;
    for (got, expected) in [
        (longitudinal.force[0], scale * coefficients.c11),
        (lateral.force[1], scale * coefficients.c22),
        (spin.force[1], scale * (a * b).sqrt() * coefficients.c23),
    ] {
        assert!((got.re / expected - 1.0).abs() < 0.015, "{got} {expected}");
    }
    for (none, of) in [
        (longitudinal.force[1], longitudinal.force[0]),
        (lateral.force[0], lateral.force[1]),
        (spin.force[0], spin.force[1]),
    ] {
        assert!(none.norm() < 1e-4 * of.norm(), "{none} {of}");
    }
}

/// In full slip the force has the size μP and the direction of the creepage, whatever its size.
#[test]
fn full_slip_answers_to_direction_and_load_alone() {
    let contact = contact(24);
    let creepages = Creepages {
        longitudinal: 0.012,
        lateral: 0.016,
        spin: 0.0,
    };
    let state = contact.roll_with(creepages).unwrap();
    let [load, longitudinal, lateral, _] =
        derivatives(contact.response(&state, f64::INFINITY).unwrap());
    let turning = 20e3 / creepages.magnitude();
    for part in 0..2 {
        let direction = [0.6, 0.8];
        assert!((load.force[part].re - 0.4 * direction[part]).abs() < 4e-3);
        let along = 0.6 * longitudinal.force[part].re + 0.8 * lateral.force[part].re;
        assert!(along.abs() < 0.01 * turning, "{along}");
    }
    let across = 0.8 * (0.8 * longitudinal.force[0].re - 0.6 * lateral.force[0].re)
        - 0.6 * (0.8 * longitudinal.force[1].re - 0.6 * lateral.force[1].re);
    assert!((across / turning - 1.0).abs() < 0.02, "{across} {turning}");
}

/// Between τ = 0.98 and full slip the responses go from the one to the other without a step.
#[test]
fn responses_join_full_slip() {
    let contact = contact(36);
    let saturation = Carter3d::new(hertz(), 0.4).unwrap().saturation_creepage();
    let mut before: Option<[Complex64; 6]> = None;
    for step in 0..10 {
        let creepage = saturation * 0.6 * 1.05f64.powi(step);
        let state = contact.roll(creepage).unwrap();
        let steady = contact.steady(&state);
        let energy = steady.energy_per_metre();
        let response = contact.response(&state, 0.05).unwrap();
        let wave = response.by_curvature.unwrap();
        let now = [
            response.by_longitudinal.force[0] * creepage / steady.forces.magnitude(),
            response.by_longitudinal.at_rail(0.0) * creepage / energy,
            response.by_load.force[0] * 50e3 / steady.forces.magnitude(),
            response.by_load.at_rail(0.0) * 50e3 / energy,
            wave.force[0] / steady.forces.magnitude(),
            wave.at_rail(0.0) / energy,
        ];
        if let Some(before) = before {
            for (one, other) in before.iter().zip(now) {
                assert!((one - other).norm() < 0.1, "{creepage} {one} {other}");
            }
        }
        before = Some(now);
    }
}

/// Slow creepage meets a resistance in every direction.
#[test]
fn slow_creep_is_passive() {
    let contact = contact(16);
    for share in [0.2, 1.0, 3.0] {
        let creepages = Creepages {
            longitudinal: share * oblique().longitudinal,
            lateral: share * oblique().lateral,
            spin: oblique().spin,
        };
        let state = contact.roll_with(creepages).unwrap();
        let [_, longitudinal, lateral, _] =
            derivatives(contact.response(&state, f64::INFINITY).unwrap());
        let (xx, yy) = (longitudinal.force[0].re, lateral.force[1].re);
        let xy = 0.5 * (longitudinal.force[1].re + lateral.force[0].re);
        assert!(xx > 0.0 && yy > 0.0 && xx * yy > xy * xy, "{xx} {yy} {xy}");
    }
}

/// Many wavelengths at once say what each says alone, but for the residual of 1e-5 that both leave, and cost less than
/// a fifth of it.
#[test]
fn sweep_is_what_each_wavelength_says() {
    use super::influence::CONVOLUTIONS;
    let contact = contact(24);
    let state = contact.roll_with(oblique()).unwrap();
    let a = hertz().semi_axis_longitudinal();
    let count = 40;
    let wavelengths: Vec<f64> = (0..count)
        .map(|index| 2.0 * a * 50.0_f64.powf(f64::from(index) / f64::from(count - 1)))
        .collect();
    let before = CONVOLUTIONS.get();
    let told = std::cell::Cell::new(0);
    let progress = || told.set(told.get() + 1);
    let swept = contact.responses(&state, &wavelengths, OscillatingCreepages::All, progress);
    assert_eq!(told.get(), wavelengths.len());
    let between = CONVOLUTIONS.get();
    assert_eq!(swept.len(), wavelengths.len());
    let alone = wavelengths
        .iter()
        .map(|&wavelength| contact.response(&state, wavelength).unwrap());
    for (swept, alone) in swept.into_iter().zip(alone) {
        for (swept, alone) in derivatives(swept.unwrap()).iter().zip(derivatives(alone)) {
            let size = alone.force[0].norm().hypot(alone.force[1].norm());
            for part in 0..2 {
                assert!((swept.force[part] - alone.force[part]).norm() < 1e-4 * size);
            }
            let size = alone.energy.norm().max(alone.at_rail(0.0).norm());
            assert!((swept.energy - alone.energy).norm() < 1e-4 * size);
            assert!((swept.at_rail(0.0) - alone.at_rail(0.0)).norm() < 1e-4 * size);
        }
    }
    let (sweep, each) = (between - before, CONVOLUTIONS.get() - between);
    assert!(5 * sweep < each, "{sweep} {each}");
}

#[test]
fn outside_in_takes_each_once() {
    for count in 0..20 {
        let mut order = super::outside_in(count);
        assert!(count < 3 || order[..2] == [0, count - 1]);
        order.sort_unstable();
        assert_eq!(order, (0..count).collect::<Vec<_>>());
    }
}

/// Without Poisson's effect a tangential force feels no direction, so neither does rolling.
#[test]
fn direction_does_not_matter_without_poisson() {
    let material = ElasticMaterial::new(207e9, 0.0).unwrap();
    let hertz = HertzContact::exact(material, 0.3, 0.3, 50e3).unwrap();
    let contact = HalfSpace::new(hertz, 0.4, 16).unwrap();
    let along = contact.roll(1e-3).unwrap();
    let across = contact
        .roll_with(Creepages {
            lateral: 1e-3,
            ..Creepages::default()
        })
        .unwrap();
    let wavelength = 5.0 * hertz.semi_axis_longitudinal();
    let [load, longitudinal, lateral, _] =
        derivatives(contact.response(&along, wavelength).unwrap());
    let [turned_load, turned_longitudinal, turned_lateral, _] =
        derivatives(contact.response(&across, wavelength).unwrap());
    let wave = |state| {
        contact
            .response(state, wavelength)
            .unwrap()
            .by_curvature
            .unwrap()
    };
    let (by_wave, turned_by_wave) = (wave(&along), wave(&across));
    for (straight, turned) in [
        (by_wave.force[0], turned_by_wave.force[1]),
        (by_wave.energy, turned_by_wave.energy),
        (by_wave.at_rail(0.0), turned_by_wave.at_rail(0.0)),
        (load.force[0], turned_load.force[1]),
        (load.energy, turned_load.energy),
        (load.at_rail(0.0), turned_load.at_rail(0.0)),
        (longitudinal.force[0], turned_lateral.force[1]),
        (longitudinal.energy, turned_lateral.energy),
        (longitudinal.at_rail(0.0), turned_lateral.at_rail(0.0)),
        (lateral.force[1], turned_longitudinal.force[0]),
    ] {
        assert!((straight - turned).norm() < 1e-4 * straight.norm());
    }
}

/// Seen in a mirror along the rail, lateral creepage, lateral force and spin change their sign.
#[test]
fn mirrored_contact_answers_mirrored() {
    let contact = contact(16);
    let mirrored = Creepages {
        longitudinal: oblique().longitudinal,
        lateral: -oblique().lateral,
        spin: -oblique().spin,
    };
    let [straight, mirrored] = [oblique(), mirrored].map(|creepages| {
        let state = contact.roll_with(creepages).unwrap();
        derivatives(contact.response(&state, 0.025).unwrap())
    });
    for (input, (straight, mirrored)) in straight.into_iter().zip(mirrored).enumerate() {
        let sign = if input < 2 { 1.0 } else { -1.0 };
        for (straight, mirrored) in [
            (straight.force[0], sign * mirrored.force[0]),
            (straight.force[1], -sign * mirrored.force[1]),
            (straight.energy, sign * mirrored.energy),
            (straight.at_rail(0.0), sign * mirrored.at_rail(0.0)),
        ] {
            assert!(
                (straight - mirrored).norm() < 1e-3 * straight.norm(),
                "{input}"
            );
        }
    }
}

/// A long wave is a wheel of the radius R/(1 + κ) that rolls slower by 1 + κ, in every direction and with spin. The response of the grid
/// of 36 is within 2 %, the differences of forces within 0.5 %.
#[test]
fn slow_wave_is_the_slope_by_the_radius() {
    const STEP: f64 = 0.05;
    let exact = HertzContact::exact(steel(), 0.46, 0.23, 50e3).unwrap();
    let on = |curvature: f64| {
        let hertz = exact
            .with_longitudinal_radius(0.46 / (1.0 + curvature))
            .unwrap();
        HalfSpace::new(hertz, 0.4, 36).unwrap()
    };
    let contact = on(0.0);
    let state = contact.roll_with(oblique()).unwrap();
    let steady = contact.steady(&state);
    let by_radius = crate::contact::WaveGeometry::derivative(STEP, |curvature| {
        Ok::<_, Error>(on(curvature).roll_with(oblique())?.forces())
    });
    let response = contact.response(&state, f64::INFINITY).unwrap();
    let got = response.by_curvature.unwrap();
    let expected = response
        .with_curvature(by_radius.unwrap(), &steady)
        .by_curvature
        .unwrap();
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
    assert!(
        10 * wavy <= 16 * flat,
        "{wavy} sums over all elements for a table on waves, {flat} without"
    );
    assert!(
        (1..=82).contains(&steady),
        "{steady} sums over all elements for a steady state"
    );
    assert!(
        (1..=878).contains(&response),
        "{response} sums over all elements for three responses"
    );
}
