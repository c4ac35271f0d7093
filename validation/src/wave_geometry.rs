//! The geometry of a wave against transient rolling over the true gap, and its filter.

use riffel::contact::{ContactFilter, Creepages, CurvatureFilter, HalfSpace, HalfSpaceRolling, OscillatingCreepages};
use riffel::{Complex64, ElasticMaterial, HertzContact};
use riffel_numerics::bisection::bisection;
use serde::Deserialize;

use crate::Row;
use crate::ground::nominal;

const TRANSIENT: &str = include_str!("../reference/wave-geometry/half_space.csv");
const POINTS: &str = include_str!("../reference/wave-geometry/points.csv");
const PHI: &str = include_str!("../reference/wave-geometry/phi.csv");

#[derive(Deserialize)]
struct Transient {
    axis: String,
    tractive_ratio: f64,
    wavelength_m: f64,
    energy_re: f64,
    energy_im: f64,
    force_re: f64,
    force_im: f64,
}

#[derive(Deserialize)]
struct PaperPoint {
    track: String,
    tractive_ratio: f64,
    wavelength_m: f64,
    speed_m_per_s: f64,
    patch: String,
    dissipation_phase: String,
    contact_filter: bool,
    phi: f64,
    kappa_per_m: f64,
    rail_re: f64,
    rail_im: f64,
    without_re: f64,
    without_im: f64,
    growth_rate_per_passage: f64,
}

#[derive(Deserialize)]
struct Phi {
    ka: f64,
    a_over_b: f64,
    phi: f64,
}

fn rows<T: for<'a> Deserialize<'a>>(file: &'static str) -> Vec<T> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(file.as_bytes());
    reader.deserialize().collect::<Result<_, _>>().expect("numbers")
}

/// The state of the references: at a tractive ratio along or across the rail, or 3 % of slip.
fn state(contact: &HalfSpace, axis: &str, ratio: f64) -> HalfSpaceRolling {
    const FULL_SLIP: f64 = 0.03;
    let across = |creepage: f64| {
        let lateral = Creepages { lateral: creepage, ..Creepages::default() };
        contact.roll_with(lateral).expect("a steady state")
    };
    match (axis, ratio) {
        ("x", 1.0) => contact.roll(FULL_SLIP).expect("a steady state"),
        ("x", _) => contact.roll_at_tractive_ratio(ratio).expect("a steady state"),
        (_, 1.0) => across(FULL_SLIP),
        _ => {
            let is_beyond = |creepage| contact.steady(&across(creepage)).tractive_ratio() >= ratio;
            let [low, high] = bisection([0.0, FULL_SLIP], 1e-4 * FULL_SLIP, is_beyond);
            across(0.5 * (low + high))
        }
    }
}

pub(crate) fn wave_under_the_half_space() -> Row {
    const ELEMENTS: usize = 40;
    let steel = ElasticMaterial::new(207e9, 0.3).expect("a steel");
    let hertz = HertzContact::new(steel, 0.46, 0.23, 50e3).expect("a contact");
    let contact = HalfSpace::new(hertz, 0.4, ELEMENTS).expect("a grid");
    let rows: Vec<Transient> = rows(TRANSIENT);
    let (mut worst, mut compared): (f64, usize) = (0.0, 0);
    for states in rows.chunk_by(|one, other| one.axis == other.axis && one.tractive_ratio == other.tractive_ratio) {
        let axis = states[0].axis.as_str();
        let state = state(&contact, axis, states[0].tractive_ratio);
        let steady = contact.steady(&state);
        let (force, energy) = (steady.forces.magnitude(), steady.energy_per_metre());
        let wavelengths: Vec<f64> = states.iter().map(|row| row.wavelength_m).collect();
        let oscillating = OscillatingCreepages::InPlane.on_waves();
        let responses = contact.responses(&state, &wavelengths, oscillating, || ());
        for (row, response) in states.iter().zip(responses) {
            let response = response.expect("a response");
            let by = response.by_curvature.expect("asked for");
            let part = usize::from(axis == "y");
            let errors = [
                by.at_rail(0.0) / energy - Complex64::new(row.energy_re, row.energy_im),
                by.force[part] / force - Complex64::new(row.force_re, row.force_im),
            ];
            worst = errors.iter().map(|error| error.norm()).fold(worst, f64::max);
            compared += 2;
        }
    }
    Row {
        statement: "Energy at the rail and creep force by the geometry of a wave, exact contact, 40 elements across, along and across",
        source: "transient rolling over the true gap, `wave-geometry/half_space.csv`",
        expected: format!("{compared} complex responses"),
        got: format!("within {worst:.3}"),
        tolerance: "0.03: 0.012 of the reference, whose grids scatter by 0.026 at 120 mm, and 0.02 that this grid tells of itself",
        holds: worst <= 0.03 && compared == 60,
    }
}

/// The paper's loop on waves that have a shape.
pub(crate) fn waves_in_the_loop_of_the_paper() -> Row {
    let rows: Vec<PaperPoint> = rows(POINTS);
    let mut worst = 0f64;
    for row in &rows {
        let mut overrides = vec![
            "contact.wave_geometry=true".to_owned(),
            format!("contact.wave_patch={}", row.patch),
            format!("contact.dissipation_phase={}", row.dissipation_phase),
            format!("contact.tractive_ratio={}", row.tractive_ratio),
        ];
        if row.track == "bhaskar" {
            overrides.push("track.model=two-layer".to_owned());
            overrides.push("track.preset=bhaskar-inferred".to_owned());
        }
        let overrides: Vec<&str> = overrides.iter().map(String::as_str).collect();
        let case = nominal(&overrides);
        let with = case.feedback.at(row.wavelength_m, row.speed_m_per_s);
        let plain = case.feedback.clone().without_wave_geometry();
        let plain = plain.at(row.wavelength_m, row.speed_m_per_s);
        let wave = with.contacts[0].wave.expect("a geometry");
        let per_metre = case.steady.energy_per_metre() * case.feedback.amplitude();
        let [whole, load] = [&with, &plain].map(|state| state.contacts[0].energy_at_rail / per_metre);
        // The loop is linear in the oscillation of the load, which a filter reduces.
        let filter = ContactFilter::of(&case.hertz);
        let wavenumber = std::f64::consts::TAU / row.wavelength_m;
        let pressed = match row.contact_filter {
            true => filter.amplitude(wavenumber, 0.0),
            false => 1.0,
        };
        let without = load * pressed;
        let rail = without + whole - load;
        let expected = Complex64::new(row.rail_re, row.rail_im);
        let growth = with.growth_rate * rail.re / whole.re;
        let off = (row.growth_rate_per_passage * rail.norm() / rail.re).abs();
        for error in [
            (rail - expected).norm() / expected.norm(),
            (without - Complex64::new(row.without_re, row.without_im)).norm() / without.norm(),
            (growth - row.growth_rate_per_passage).abs() / off,
            wave.curvature_per_metre / row.kappa_per_m - 1.0,
            wave.share / row.phi - 1.0,
        ] {
            worst = worst.max(error.abs());
        }
    }
    Row {
        statement: "The loop of the paper on waves that have a shape: κ, Φ, energy at the rail with and without, growth",
        source: "two closed forms in double precision, `wave-geometry/points.csv`",
        expected: format!("{} points", rows.len()),
        got: format!("within {worst:.0e}"),
        tolerance: "1e-9",
        holds: worst <= 1e-9 && rows.len() == 27,
    }
}

pub(crate) fn curvature_filter() -> Row {
    let rows: Vec<Phi> = rows(PHI);
    let errors = rows.iter().map(|row| {
        let filter = CurvatureFilter::new(1.0, 1.0 / row.a_over_b).expect("an ellipse");
        (filter.share(row.ka) - row.phi).abs()
    });
    let worst = errors.fold(0.0, f64::max);
    Row {
        statement: "Share Φ of the curvature of a wave that an ellipse feels",
        source: "series in quadruple precision, `wave-geometry/phi.csv`",
        expected: format!("{} values", rows.len()),
        got: format!("within {worst:.0e}"),
        tolerance: "1e-11: rounding of 72 terms",
        holds: worst <= 1e-11 && rows.len() == 28,
    }
}
