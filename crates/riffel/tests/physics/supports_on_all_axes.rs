//! Wheels that pass discrete supports, down and across, in time.

use std::f64::consts::TAU;
use std::sync::Arc;

use riffel::contact::{CreepLaw, Creepages, MeanState, QuasiStatic};
use riffel::feedback::{Contact, Loop};
use riffel::passage::{ContactInTime, ImpulseResponse, PassageModel, Sinusoid, StructuresInTime};
use riffel::receptance::{
    Bar, MovingLoadOnSupports, PeriodicTrack, SpatialMovingLoad, SpatialRail, SpatialTrack, Structure, Support,
    Supports, Uncoupled,
};
use riffel::wheelset::{Motion, RigidInertia, RigidMass};
use riffel::{Carter3d, Complex64, Direction, Place, Rail, RollingContact};

use crate::fixtures::{layer, sheared as beam, sleepers as down, steel};
use crate::general_loop::{contact, hertz};

const SPACING: f64 = 0.6;
const SPEED: f64 = 12.0;
const MASS: f64 = 400.0;
const INERTIA: f64 = 40.0;
const RADIUS: f64 = 0.46;
const LOAD: f64 = 60e3;

/// 60E1 that bends both ways and stretches, with so much viscous loss that the quadrature is quick.
fn track() -> SpatialTrack {
    let rail = SpatialRail {
        lateral: Some(beam(5.127e-6, 2e4)),
        longitudinal: Some(Bar::new(steel(), 7.67e-3, 60.2).unwrap()),
        ..beam(3.04e-5, 2e4).into()
    };
    let across = Support::one_layer(layer(40e6, 40e3));
    let supports = Supports { vertical: Some(down()), lateral: Some(across), longitudinal: Some(across) };
    SpatialTrack::discrete(rail, supports, SPACING).unwrap()
}

fn law() -> Arc<dyn CreepLaw> {
    Arc::new(Carter3d::new(hertz(), 0.35).unwrap())
}

fn in_time(feedback: &Loop, track: &SpatialTrack) -> PassageModel {
    let track = SpatialMovingLoad::new(track, SPEED).unwrap();
    let contacts = feedback.contacts().iter();
    let contacts = contacts.map(|contact| ContactInTime::new(contact, law()).unwrap());
    PassageModel {
        contacts: contacts.collect(),
        structures: StructuresInTime::over_supports(feedback, &track, &[]).unwrap(),
        contact_filter: None,
        speed: SPEED,
    }
}

/// One wheel along one axis, its rail fitted by itself and on all axes, over waves of 60 µm: harmonics to 10⁻³ of the first, as far as two fits of the
/// rail are apart.
// Long: follows a wheel over supports in time twice, by two fits of the rail.
#[test]
fn one_wheel_along_one_axis_is_the_same_on_supports() {
    let mean = MeanState::TractiveRatio(0.4);
    let rolling = QuasiStatic::new(law(), LOAD, mean).unwrap();
    let rail = beam(3.04e-5, 2e4);
    let periodic = PeriodicTrack::new(rail, down(), SPACING).unwrap();
    let moving = MovingLoadOnSupports::new(&periodic, SPEED).unwrap();
    let response = ImpulseResponse::over_supports(&moving).unwrap();
    let (mass, inertia) = (RigidMass::new(MASS).unwrap(), RigidInertia::new(INERTIA, RADIUS).unwrap());
    let one = PassageModel {
        structures: StructuresInTime::of_one_wheel(response, &mass, Some(&inertia)),
        contacts: vec![ContactInTime::of_one_wheel(rolling.steady(), hertz().stiffness(), law()).unwrap()],
        contact_filter: None,
        speed: SPEED,
    };
    let supports = Supports { vertical: Some(down()), ..Supports::default() };
    let spatial = SpatialTrack::discrete(rail.into(), supports, SPACING).unwrap();
    let motion = [Motion::Compliant(()), Motion::Held];
    let wheels = Uncoupled { longitudinal: Some(Arc::new(inertia)), lateral: None, vertical: Some(Arc::new(mass)) };
    let contacts = vec![contact(0.0, Arc::new(rolling), motion)];
    let feedback = Loop::new(Arc::new(spatial), Arc::new(wheels), contacts, 1e-6).unwrap();
    let all = in_time(&feedback, &spatial);
    let profile = Sinusoid { amplitude: 60e-6, wavelength: 0.047 };
    let expected = one.settle(profile, 100).unwrap().swap_remove(0);
    let got = all.settle(profile, 100).unwrap().swap_remove(0);
    let first = expected.harmonics[1];
    for (got, expected) in got.harmonics.iter().zip(&expected.harmonics) {
        let off = |got: Complex64, expected: Complex64, first: Complex64| {
            let error = (got - expected).norm() / first.norm();
            assert!(error < 1e-3, "{got} {expected}: {error:e}");
        };
        off(got.normal_force, expected.normal_force, first.normal_force);
        off(got.tangential_force, expected.tangential_force, first.tangential_force);
        off(got.creepage, expected.creepage, first.creepage);
    }
}

/// Lines at ω + nΩ on each side that the balance below takes.
const LINES: isize = 4;

/// Two wheels with a contact angle that creep along and across a rail which bends both ways and stretches, over a small wave: what it
/// adds to the forces on a smooth rail is the harmonic balance
///
/// ```text
/// P_m/k = Δ p δ_m0 − [Σ_l Ĥ_{m−l}(ω_l) f_l + H_w(ω_m) f_m]_n,   Vξ_m = −iω_m [the same]_{x,t},   Q_m = F_P P_m + F_ξ ξ_m
/// ```
///
/// solved here by elimination. Over the largest line of its axis P is right to 3·10⁻³, Q_t to 6·10⁻³ and Q_x to 2·10⁻²: on the smooth
/// rail the load varies by 5·10⁻³ as supports pass, and the longitudinal creepage of a wheel that turns freely by a fifth, and with
/// them the stiffness of Hertz and the slopes of the law, which the balance leaves out.
// Long: marches two wheels over tens of bays in half millimetres, the side that is held against the balance.
#[test]
fn small_waves_are_the_balance_of_all_axes() {
    const ANGLE: f64 = 0.1;
    const TOLERANCE: [f64; 3] = [2e-2, 6e-3, 3e-3];
    let amplitude = 1e-8;
    let (wavelength, distance) = (0.02, 1.7);
    let mean = MeanState::Creepages(Creepages { longitudinal: 4e-4, lateral: 8e-4, spin: 0.0 });
    let rolling = QuasiStatic::new(law(), LOAD, mean).unwrap();
    let wheels = Uncoupled {
        longitudinal: Some(Arc::new(RigidInertia::new(INERTIA, RADIUS).unwrap())),
        lateral: Some(Arc::new(RigidMass::new(2.0 * MASS).unwrap())),
        vertical: Some(Arc::new(RigidMass::new(MASS).unwrap())),
    };
    let motion = [Motion::Compliant(()), Motion::Compliant(())];
    let rolling: Arc<dyn RollingContact> = Arc::new(rolling);
    let contacts =
        [0.0, -distance].map(|along| Contact { angle: ANGLE, ..contact(along, rolling.clone(), motion.clone()) });
    let track = track();
    let wheels = Arc::new(wheels);
    let feedback = Loop::new(Arc::new(track), wheels.clone(), contacts.to_vec(), amplitude).unwrap();
    let model = in_time(&feedback, &track);
    assert!(model.structures.share_cut() < 1e-5, "{:e}", model.structures.share_cut());

    let steps_to_bay = 1200;
    let step = SPACING / f64::from(steps_to_bay);
    let memory = model.memory().unwrap();
    let run_in = ((memory / SPACING).ceil() as usize + 6) * steps_to_bay as usize;
    let counted = 16 * steps_to_bay as usize;
    let mut without = model.march(step).unwrap();
    let mut with = without.clone();
    let count = (2 * LINES + 1) as usize;
    let mut lines = vec![[[Complex64::ZERO; 3]; 2]; count];
    let (k, turn) = (TAU / wavelength, TAU / SPACING);
    for index in 1..=run_in + counted {
        let x = index as f64 * step;
        let grown = (index as f64 / (0.5 * run_in as f64)).min(1.0);
        let heights = [0.0, -distance].map(|along| grown * amplitude * (k * (x + along)).cos());
        let smooth = without.advance(&[0.0; 2]);
        let rough = with.advance(&heights);
        if index <= run_in {
            continue;
        }
        let share = TAU * (index - run_in) as f64 / counted as f64;
        let window = 0.35875 - 0.48829 * share.cos() + 0.14128 * (2.0 * share).cos() - 0.01168 * (3.0 * share).cos();
        let scale = 2.0 * window / (0.35875 * counted as f64);
        for (line, m) in lines.iter_mut().zip(-LINES..) {
            let wave = Complex64::from_polar(scale, -(k + turn * m as f64) * x);
            for (contact, (rough, smooth)) in line.iter_mut().zip(rough.iter().zip(smooth)) {
                contact[0] += wave * (rough.tangential_force - smooth.tangential_force);
                contact[1] += wave * (rough.lateral_force - smooth.lateral_force);
                contact[2] += wave * (rough.normal_force - smooth.normal_force);
            }
        }
    }

    let expected = balance(&track, &*wheels, &*rolling, ANGLE, distance, k, amplitude);
    let largest = |axis: usize| {
        let lines = expected.iter().flatten();
        lines.map(|force| force[axis].norm()).fold(0.0, f64::max)
    };
    for ((got, expected), m) in lines.iter().zip(&expected).zip(-LINES..) {
        // The outermost lack neighbours.
        if m.abs() > LINES - 2 {
            continue;
        }
        for (wheel, (got, expected)) in got.iter().zip(expected).enumerate() {
            for axis in 0..3 {
                let error = (got[axis] - expected[axis]).norm() / largest(axis);
                assert!(error < TOLERANCE[axis], "line {m}, wheel {wheel}, axis {axis}: {error:e}");
            }
        }
    }
    // Neighbours are no small matter.
    let beside = expected[LINES as usize + 1][0][1].norm();
    assert!(beside > 0.02 * largest(1), "{beside:e} {:e}", largest(1));
}

/// Forces at both wheels by lines and axes.
fn balance(
    track: &SpatialTrack,
    wheels: &dyn Structure,
    rolling: &dyn RollingContact,
    angle: f64,
    distance: f64,
    k: f64,
    amplitude: f64,
) -> Vec<[[Complex64; 3]; 2]> {
    let moving = SpatialMovingLoad::new(track, SPEED).unwrap();
    let places: Vec<Place> = [0.0, -distance]
        .into_iter()
        .flat_map(|along| Direction::ALL.map(|direction| Place { along, rail: Rail::Right, direction }))
        .collect();
    let count = (2 * LINES + 1) as usize;
    let passing = TAU * SPEED / SPACING;
    let frequency = |m: isize| k * SPEED + m as f64 * passing;
    let (sine, cosine) = angle.sin_cos();
    // Rows are x, t, n of the contact in the axes of the track, on the right rail.
    let axes = [[1.0, 0.0, 0.0], [0.0, cosine, -sine], [0.0, sine, cosine]];
    let turned = |matrix: &dyn Fn(usize, usize) -> Complex64, row: usize, column: usize| {
        let (a, b) = (row / 3, column / 3);
        let mut sum = Complex64::ZERO;
        for i in 0..3 {
            for j in 0..3 {
                sum += matrix(3 * a + i, 3 * b + j) * axes[row % 3][i] * axes[column % 3][j];
            }
        }
        sum
    };
    let response = rolling.response(TAU / k);
    let by = [response.by_longitudinal.force, response.by_lateral.unwrap().force];
    let by_load = response.by_load.force;
    let unknowns = 6 * count;
    let mut matrix = vec![vec![Complex64::ZERO; unknowns + 1]; unknowns];
    for (l, column) in (-LINES..=LINES).zip(0..) {
        let harmonics = moving.harmonics(frequency(l), &places, 2 * LINES as usize).unwrap();
        for (m, row) in (-LINES..=LINES).zip(0..) {
            let w = frequency(m);
            let harmonic = harmonics.at(m - l).unwrap();
            let receptance = |i: usize, j: usize| {
                let wheel = match m == l && i / 3 == j / 3 {
                    true => wheels.cross_receptance(w, SPEED, places[i], places[j]),
                    false => Complex64::ZERO,
                };
                harmonic[6 * i + j] + wheel
            };
            for i in 0..6 {
                for j in 0..6 {
                    let moved = turned(&receptance, i, j);
                    let at = &mut matrix[6 * row + i];
                    if i % 3 == 2 {
                        at[6 * column + j] += moved;
                        continue;
                    }
                    // Q + F_ξ iω/V u = F_P P, over both tangential rows of the contact.
                    let rate = Complex64::new(0.0, w / SPEED);
                    let contact = 6 * row + 3 * (i / 3);
                    for (at, by) in matrix[contact..contact + 2].iter_mut().zip(by[i % 3]) {
                        at[6 * column + j] += by * rate * moved;
                    }
                }
            }
        }
    }
    for m in 0..count {
        for i in 0..6 {
            let row = 6 * m + i;
            if i % 3 == 2 {
                matrix[row][row] += hertz().stiffness().recip();
                if m == LINES as usize {
                    let along = if i < 3 { 0.0 } else { -distance };
                    matrix[row][unknowns] = amplitude * Complex64::cis(k * along);
                }
            } else {
                matrix[row][row] += 1.0;
                matrix[row][6 * m + 3 * (i / 3) + 2] -= by_load[i % 3];
            }
        }
    }
    let solution = eliminated(matrix);
    let lines = solution.chunks_exact(6);
    lines.map(|line| [0, 3].map(|from| [0, 1, 2].map(|axis| line[from + axis]))).collect()
}

/// Gauss with pivots of the largest share of their row.
fn eliminated(mut matrix: Vec<Vec<Complex64>>) -> Vec<Complex64> {
    let count = matrix.len();
    for row in &mut matrix {
        let size = row[..count].iter().map(|entry| entry.norm()).fold(0.0, f64::max);
        row.iter_mut().for_each(|entry| *entry /= size);
    }
    for column in 0..count {
        let pivot =
            (column..count).max_by(|&a, &b| matrix[a][column].norm().total_cmp(&matrix[b][column].norm())).unwrap();
        matrix.swap(column, pivot);
        let own = matrix[column].clone();
        for row in matrix.iter_mut().skip(column + 1) {
            let factor = row[column] / own[column];
            for (entry, own) in row.iter_mut().zip(&own).skip(column) {
                *entry -= factor * own;
            }
        }
    }
    let mut solution = vec![Complex64::ZERO; count];
    for row in (0..count).rev() {
        let known: Complex64 = (row + 1..count).map(|column| matrix[row][column] * solution[column]).sum();
        solution[row] = (matrix[row][count] - known) / matrix[row][row];
    }
    solution
}
