//! The loop on all axes: its equations beside NumPy's, the structures it asks, and a whole map.

use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

use riffel::contact::{ContactDerivative, ContactResponse, CreepForces, Creepages, MeanRolling, RollingContact};
use riffel::feedback::Contact;
use riffel::growth::RowEvaluator;
use riffel::receptance::Structure;
use riffel::wheelset::{Motion, Wheelset};
use riffel::{Axis, Complex64, DissipationPhase, EnergyWear, GrowthMap, Loop, Place, PlaceOfWear, Rail, Ridge};
use riffel_case::Case;

use crate::contestant::{Failure, Peers, machine};
use crate::section::Section;
use crate::{median, ratio, sizes};

/// Seconds of a task, and a sum of its result.
pub(crate) fn task(name: &str, points: usize) -> Result<(f64, f64), Failure> {
    match name {
        "one-wheel" => equations(1, points),
        "eight-wheels" => equations(8, points),
        "wheelset" => wheelset(points),
        "twisting" => twisting(&[], points),
        "twisting-discrete" => twisting(&[DISCRETE], points),
        "map" => map(|feedback, wavelength, speed| {
            let map = GrowthMap::compute(feedback, wavelength, speed, |_| ());
            map.rows().flat_map(|(_, row)| row).map(|value| value.re).sum()
        }),
        "ridge" => map(|feedback, wavelength, speed| {
            let ridge = Ridge::search(feedback, wavelength, speed);
            ridge.points.iter().map(|point| point.normalized_dissipation).sum()
        }),
        _ => Err("no such task of the loop on all axes".into()),
    }
}

/// A structure whose receptances are at hand: a matrix that falls with the frequency.
struct AtHand(Vec<Complex64>);

impl AtHand {
    fn matrix(size: usize) -> Self {
        let entry = |(row, column): (usize, usize)| match row.abs_diff(column) {
            0 => Complex64::new(2e-9, -0.5e-9),
            distance => Complex64::new(0.3e-9, -0.06e-9) / (1 + distance) as f64,
        };
        let places = (0..size).flat_map(|row| (0..size).map(move |column| (row, column)));
        Self(places.map(entry).collect())
    }
}

impl Structure for AtHand {
    /// Of places that are told apart by the matrix alone there is no receptance of two.
    fn cross_receptance(&self, _: f64, _: f64, _: Place, _: Place) -> Complex64 {
        Complex64::new(f64::NAN, f64::NAN)
    }

    fn receptance_matrix(&self, w: f64, _: f64, _: &[Place], matrix: &mut [Complex64]) {
        let scale = 3000.0 / w;
        for (entry, own) in matrix.iter_mut().zip(&self.0) {
            *entry = own * scale;
        }
    }
}

/// A structure that does not move.
struct Still;

impl Structure for Still {
    fn cross_receptance(&self, _: f64, _: f64, _: Place, _: Place) -> Complex64 {
        Complex64::ZERO
    }

    fn receptance_matrix(&self, _: f64, _: f64, _: &[Place], matrix: &mut [Complex64]) {
        matrix.fill(Complex64::ZERO);
    }
}

/// A quasi-static contact with round numbers.
struct Round;

impl RollingContact for Round {
    fn steady(&self) -> MeanRolling {
        MeanRolling {
            normal_force: 50e3,
            friction: 0.4,
            creepages: Creepages { longitudinal: 1e-3, lateral: 5e-4, spin: 0.0 },
            forces: CreepForces { longitudinal: 6e3, lateral: 3e3 },
        }
    }

    fn response(&self, _: f64) -> ContactResponse {
        let by = |force: [f64; 2], energy: f64| ContactDerivative {
            force: force.map(Complex64::from),
            energy: energy.into(),
            energy_at_rail: None,
            error: None,
        };
        ContactResponse {
            by_load: by([0.08, 0.04], 1e-4),
            by_longitudinal: by([4e6, -5e5], 9e3),
            by_lateral: Some(by([-5e5, 5e6], 5e3)),
            by_spin: None,
            by_curvature: None,
        }
    }
}

/// Wheels 2.5 m apart whose receptances are at hand.
fn at_hand(wheels: usize) -> Result<Loop, Failure> {
    let rolling: Arc<dyn RollingContact> = Arc::new(Round);
    let wear = EnergyWear::new(2.5e-9, 7850.0, 4e-3)?;
    let contacts = (0..wheels).map(|wheel| Contact {
        along: -2.5 * wheel as f64,
        rail: Rail::Right,
        angle: 0.0,
        profile: 1.0,
        stiffness: 1e9,
        rolling: rolling.clone(),
        motion: [const { Motion::Compliant(()) }; 2],
        moving: None,
        wave: None,
        place_of_wear: PlaceOfWear::new(DissipationPhase::None, 6e-3, 0.3),
        wear,
        damage: None,
    });
    let track = Arc::new(AtHand::matrix(3 * wheels));
    Ok(Loop::new(track, Arc::new(Still), contacts.collect(), 1e-5)?)
}

/// Ŵ₁ on a square of wavelengths of 20–80 mm and speeds of 5–60 m/s.
fn equations(wheels: usize, side: usize) -> Result<(f64, f64), Failure> {
    let feedback = at_hand(wheels)?;
    let wavelength = Axis::new(0.020, 0.080, side)?;
    let speed = Axis::new(5.0, 60.0, side)?;
    let mut row = vec![Complex64::ZERO; side];
    let begun = Instant::now();
    let mut evaluator = RowEvaluator::new(feedback, &wavelength.values());
    let mut sum = 0.0;
    for index in 0..side {
        evaluator.evaluate(speed.value(index), &mut row);
        sum += row.iter().map(|value| value.re).sum::<f64>();
    }
    Ok((begun.elapsed().as_secs_f64(), sum))
}

fn frequencies(points: usize) -> impl Iterator<Item = f64> {
    let share = move |index: usize| index as f64 / (points - 1) as f64;
    (0..points).map(move |index| TAU * 20.0 * (3000.0_f64 / 20.0).powf(share(index)))
}

fn path(case: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../cases").join(case)
}

fn case(name: &str, overrides: &[&str]) -> Result<Case, Failure> {
    let overrides: Vec<String> = overrides.iter().map(|&text| text.to_owned()).collect();
    Ok(Case::read(&path(name), &overrides)?)
}

const CURVE: &str = "curve.toml";
const DISCRETE: &str = "track.model=one-layer-periodic";

/// All six by six receptances of a flexible wheelset with its brake discs.
fn wheelset(points: usize) -> Result<(f64, f64), Failure> {
    let case = case("wheelset-metro-trailer.toml", &[])?;
    let wheelset = case.wheelset.ok_or("the case has a wheelset")?;
    let begun = Instant::now();
    let mut sum = 0.0;
    for w in frequencies(points) {
        let receptances = black_box(wheelset.receptances(w));
        sum += receptances[2][2].norm();
    }
    Ok((begun.elapsed().as_secs_f64(), sum))
}

/// The three by three receptances of a rail that twists, under a lone wheel whose own cost next to nothing.
fn twisting(overrides: &[&str], points: usize) -> Result<(f64, f64), Failure> {
    let text = std::fs::read_to_string(path(CURVE))?;
    let (before, rest) = text.split_once("[wheelset]").ok_or("a wheelset")?;
    let (_, after) = rest.split_once("[steel]").ok_or("keys of the steel")?;
    let text = format!("{before}mass = \"350 kg\"\n[steel]{after}");
    let overrides: Vec<String> = overrides.iter().map(|&text| text.to_owned()).collect();
    let feedback = Case::parse("benchmark", &text, &overrides)?.feedback;
    let begun = Instant::now();
    let mut sum = 0.0;
    for w in frequencies(points) {
        let receptances = black_box(feedback.receptances(w, 10.0));
        let [track, _] = receptances.ok_or("no wheel follows freely")?;
        sum += track[1][1].norm();
    }
    Ok((begun.elapsed().as_secs_f64(), sum))
}

/// Discrete supports, a rail that twists, a flexible wheelset on both rails.
fn map(compute: impl Fn(&Loop, Axis, Axis) -> f64) -> Result<(f64, f64), Failure> {
    let case = case(CURVE, &[DISCRETE])?;
    let (along, speeds) = sizes().general_map;
    let wavelength = Axis::new(0.030, 0.150, along)?;
    let speed = Axis::new(5.0, 15.0, speeds)?;
    let begun = Instant::now();
    let sum = compute(&case.feedback, wavelength, speed);
    Ok((begun.elapsed().as_secs_f64(), sum))
}

/// The section of the report.
pub(crate) fn report(text: &mut Section, peers: &Peers) -> Result<(), Failure> {
    let (rounds, frequencies, (along, speeds)) = (sizes().few_rounds, sizes().frequencies, sizes().general_map);
    let [one_side, eight_side] = sizes().equation_sides;
    let (mut one, mut two) = (peers.riffel(1)?, peers.riffel(2)?);
    let mut numpy = peers.numpy("general_numpy.py", &[])?;
    let equations = [("one-wheel", one_side), ("eight-wheels", eight_side)];
    let mut ours = equations.map(|_| Vec::new());
    let mut theirs = equations.map(|_| Vec::new());
    let structures = ["wheelset", "twisting", "twisting-discrete"];
    let mut receptances = structures.map(|_| Vec::new());
    let whole = ["map", "ridge"];
    let mut maps = whole.map(|_| Vec::new());
    for _ in 0..rounds {
        for (index, (name, side)) in equations.into_iter().enumerate() {
            let (seconds, sum) = one.time(&format!("general {name}"), side)?;
            let (by_numpy, expected) = numpy.time(name, side)?;
            text.compare("NumPy", (sum, expected), 1e-9);
            let points = (side * side) as f64;
            ours[index].push(1e6 * seconds / points);
            theirs[index].push(1e6 * by_numpy / points);
        }
        for (name, times) in structures.iter().zip(&mut receptances) {
            let (seconds, _) = one.time(&format!("general {name}"), frequencies)?;
            times.push(1e6 * seconds / frequencies as f64);
        }
        for (name, times) in whole.iter().zip(&mut maps) {
            times.push(two.time(&format!("general {name}"), along)?.0);
        }
    }
    let [ours, theirs] = [ours, theirs].map(|times| times.map(median));
    let [wheelset, twisting, discrete] = receptances.map(median);
    let [map, ridge] = maps.map(median);
    writeln!(text, "Medians of {rounds} rounds. Machine: {}.\n", machine())?;
    writeln!(
        text,
        "| equations alone, receptances at hand, one thread | Riffel, µs a point | NumPy {}, `linalg.solve` of all points at \
         once | Riffel is |\n|---|---|---|---|",
        peers.numpy_version()?
    )?;
    for (index, name) in ["one wheel, 3 axes", "8 wheels, 3 axes"].into_iter().enumerate() {
        writeln!(
            text,
            "| {name} | {:.2} | {:.2} | {} × faster |",
            ours[index],
            theirs[index],
            ratio(theirs[index] / ours[index])
        )?;
    }
    writeln!(
        text,
        "\n| receptances, one thread | µs a frequency |\n|---|---|\n\
         | flexible wheelset with brake discs, 6 × 6 | {wheelset:.2} |\n\
         | rail that bends, twists and warps on even supports, 3 × 3 | {twisting:.2} |\n\
         | the same on discrete supports | {discrete:.2} |\n\n\
         | {} × {} points, discrete supports, twisting rails, flexible wheelset on both, two threads | s |\n|---|---|\n\
         | map | {map:.2} |\n| ridge | {ridge:.2} |",
        along, speeds
    )?;
    Ok(())
}
