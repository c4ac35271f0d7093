//! Rolling contact: the half-space theory in the steady state, in time and at the frequency itself.

use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::hint::black_box;
use std::time::Instant;

use riffel::contact::{
    CreepEllipse, CreepLaw, Creepages, Fastsim, HalfSpace, HalfSpaceRolling, KalkerCoefficients, NonSteady,
    Oscillating, OscillatingCreepages, RollingContact, TractionBound, TransientRolling,
};
use riffel::damage::stress::{EllipseStress, Traction};
use riffel::{ElasticMaterial, HertzContact};

use crate::contestant::{Contestant, Failure, Peers, machine};
use crate::section::Section;
use crate::{median, sizes};

/// Mean milliseconds a case of CONTACT on 40 × 40 elements, tolerance 1e-5, measured on another machine of
/// two processors: `validation/reference/contact/timing.csv`.
const CONTACT_STEADY: [f64; 2] = [45.41, 89.36];
const CONTACT_STEP: f64 = 6.21;

const FRICTION: f64 = 0.4;
const LOAD: f64 = 50e3;

fn hertz(load: f64) -> Result<HertzContact, Failure> {
    let steel = ElasticMaterial::new(207e9, 0.3)?;
    Ok(HertzContact::exact(steel, 0.46, 0.23, load)?)
}

/// Seconds of a task with so many elements across, and a sum of its result.
pub(crate) fn task(name: &str, across: usize) -> Result<(f64, f64), Failure> {
    match name {
        "steady" => steady(across),
        "step" => steps(across),
        "response" => response(across),
        "table" => table(across),
        "one-wavelength" => one_wavelength(across),
        "case" => table_of_case(across, OscillatingCreepages::Longitudinal.into()),
        "case-on-waves" => table_of_case(across, OscillatingCreepages::Longitudinal.on_waves()),
        "followed" => followed(across),
        "fastsim" => fastsim(across),
        "stress" => stress(Traction::full_slip(FRICTION, [1.0, 0.0]), across),
        "stress-partial" => stress(Traction::partial_slip(FRICTION, [1.0, 0.0], 0.5), across),
        _ => Err("no such task of the contact".into()),
    }
}

/// Stress under one patch at so many points along and across and half as many depths.
fn stress(traction: Traction, across: usize) -> Result<(f64, f64), Failure> {
    let contact = hertz(LOAD)?;
    let ratio = contact.semi_axis_longitudinal() / contact.semi_axis_lateral();
    let ellipse = EllipseStress::of_ratio(ratio, 0.3);
    let side: Vec<f64> = (0..across).map(|index| 4.0 * (index as f64 + 0.5) / across as f64 - 2.0).collect();
    let depths: Vec<f64> = (0..across / 2).map(|index| 4.0 * index as f64 / across as f64).collect();
    let begun = Instant::now();
    let stresses = black_box(traction.field(&ellipse, [&side, &side, &depths]));
    let seconds = begun.elapsed().as_secs_f64();
    Ok((seconds, stresses.iter().map(|stress| stress[2]).sum()))
}

/// Mean of steady states from free rolling to full slip, each from nothing.
fn steady(across: usize) -> Result<(f64, f64), Failure> {
    let contact = HalfSpace::new(hertz(LOAD)?, FRICTION, across)?;
    let creepages: Vec<f64> = (1..=20).map(|index| 2e-4 * f64::from(index)).collect();
    let begun = Instant::now();
    let mut sum = 0.0;
    for &creepage in &creepages {
        sum += contact.roll(creepage)?.tangential_force();
    }
    Ok((begun.elapsed().as_secs_f64() / creepages.len() as f64, sum))
}

/// Mean of steps while the creepage oscillates by a fifth over a wavelength of three diameters.
fn steps(across: usize) -> Result<(f64, f64), Failure> {
    let mut contact = TransientRolling::new(hertz(LOAD)?, FRICTION, across)?;
    contact.shift(LOAD, 0.0)?;
    let creepage = |step: usize| {
        let wave = (TAU * step as f64 / (3 * across) as f64).cos();
        Creepages::longitudinal(1e-3 * (1.0 + 0.2 * wave))
    };
    let settled = 2 * across;
    for step in 0..settled {
        contact.roll(LOAD, creepage(step))?;
    }
    let count = 59;
    let begun = Instant::now();
    let mut sum = 0.0;
    for step in settled..settled + count {
        sum += contact.roll(LOAD, creepage(step))?.forces.longitudinal;
    }
    Ok((begun.elapsed().as_secs_f64() / count as f64, sum))
}

/// The table of a case in creepage along the rail, from 20 to 200 mm, the steady state at hand.
fn table_of_case(across: usize, oscillating: Oscillating) -> Result<(f64, f64), Failure> {
    let contact = HalfSpace::new(hertz(LOAD)?, FRICTION, across)?;
    let state = contact.roll(1e-3)?;
    let begun = Instant::now();
    let tolerance = NonSteady::DEFAULT_TOLERANCE;
    let table = NonSteady::new(&contact, &state, oscillating, 0.02, 0.2, tolerance)?;
    let seconds = begun.elapsed().as_secs_f64();
    Ok((seconds, table.response(0.05).by_load.force[0].norm()))
}

/// A sum of the responses at so many wavelengths from 2 to 100 semi-axes, in even ratios.
fn sum_of_responses(
    contact: &HalfSpace,
    state: &HalfSpaceRolling,
    creepages: OscillatingCreepages,
    count: usize,
) -> Result<f64, Failure> {
    let a = hertz(LOAD)?.semi_axis_longitudinal();
    let share = |index: usize| index as f64 / (count - 1) as f64;
    let wavelength = |index| 2.0 * a * 50.0_f64.powf(share(index));
    let wavelengths: Vec<f64> = (0..count).map(wavelength).collect();
    let mut sum = 0.0;
    for response in contact.responses(state, &wavelengths, creepages, || ()) {
        let response = response?;
        sum += response.by_longitudinal.force[0].norm() + response.by_load.force[0].norm();
    }
    Ok(sum)
}

/// Thirty wavelengths, both inputs, and the steady state before.
fn response(across: usize) -> Result<(f64, f64), Failure> {
    let hertz = hertz(LOAD)?;
    let begun = Instant::now();
    let contact = HalfSpace::new(hertz, FRICTION, across)?;
    let state = contact.roll_at_tractive_ratio(0.3)?;
    let sum = sum_of_responses(&contact, &state, OscillatingCreepages::Longitudinal, sizes().wavelengths[0])?;
    Ok((begun.elapsed().as_secs_f64(), sum))
}

/// Sixty-four wavelengths and all four inputs about creepage in any direction, the steady state at hand.
fn table(across: usize) -> Result<(f64, f64), Failure> {
    let hertz = hertz(LOAD)?;
    let contact = HalfSpace::new(hertz, FRICTION, across)?;
    let state = contact.roll_with(Creepages { longitudinal: 6e-4, lateral: 6e-4, spin: 0.3 })?;
    let begun = Instant::now();
    let sum = sum_of_responses(&contact, &state, OscillatingCreepages::All, sizes().wavelengths[1])?;
    Ok((begun.elapsed().as_secs_f64(), sum))
}

/// The response to creepage and load at a wavelength of eight semi-axes.
fn one_wavelength(across: usize) -> Result<(f64, f64), Failure> {
    let hertz = hertz(LOAD)?;
    let contact = HalfSpace::new(hertz, FRICTION, across)?;
    let state = contact.roll(1e-3)?;
    let begun = Instant::now();
    let response = contact.response(&state, 8.0 * hertz.semi_axis_longitudinal())?;
    let seconds = begun.elapsed().as_secs_f64();
    Ok((seconds, response.by_longitudinal.force[0].norm()))
}

/// Response to oscillations of creepage and of load, followed in time on one grid: two diameters until the
/// start is forgotten, and one wave.
fn followed(across: usize) -> Result<(f64, f64), Failure> {
    const SHARE: f64 = 0.05;
    let begun = Instant::now();
    let mut sum = 0.0;
    for by_load in [false, true] {
        let mut contact = TransientRolling::new(hertz(1.1 * LOAD)?, FRICTION, across)?;
        contact.shift(LOAD, 0.0)?;
        for step in 0..6 * across {
            let wave = 1.0 + SHARE * (TAU * step as f64 / (4 * across) as f64).cos();
            let (load, creepage) = if by_load { (wave, 1.0) } else { (1.0, wave) };
            let creepage = Creepages::longitudinal(1e-3 * creepage);
            sum += contact.roll(LOAD * load, creepage)?.forces.longitudinal;
        }
    }
    Ok((begun.elapsed().as_secs_f64(), sum))
}

fn fastsim(across: usize) -> Result<(f64, f64), Failure> {
    const REPEATS: usize = 200;
    let hertz = hertz(LOAD)?;
    let (a, b) = (hertz.semi_axis_longitudinal(), hertz.semi_axis_lateral());
    let ellipse = CreepEllipse::new(hertz, KalkerCoefficients::new(0.3, a / b)?);
    let law = Fastsim::new(ellipse, FRICTION, TractionBound::Parabolic, across)?;
    let creepages = Creepages { longitudinal: 8e-4, lateral: 3e-4, spin: 0.2 };
    let begun = Instant::now();
    let mut sum = 0.0;
    for _ in 0..REPEATS {
        sum += black_box(&law).forces(LOAD, black_box(creepages)).magnitude();
    }
    Ok((begun.elapsed().as_secs_f64() / REPEATS as f64, sum))
}

/// Median time of each task \[ms\], and that of the table of a case with the geometry of the wave over that without.
fn measured(riffel: &mut Contestant) -> Result<([f64; 11], f64), Failure> {
    let (across, response) = (sizes().elements, sizes().response_elements);
    let tasks = [
        ("steady", across),
        ("step", across),
        ("response", response),
        ("table", response),
        ("case", response),
        ("case-on-waves", response),
        ("one-wavelength", response),
        ("followed", response),
        ("fastsim", sizes().cells),
        ("stress", sizes().stress_points),
        ("stress-partial", sizes().stress_points),
    ];
    let mut times = tasks.map(|_| Vec::new());
    for round in 0..sizes().few_rounds {
        for ((name, across), times) in tasks.iter().zip(&mut times) {
            let task = format!("contact {name}");
            // Seconds, in which nothing need be warm.
            let (seconds, _) = match *name {
                "followed" if round >= sizes().fewest_rounds => continue,
                "followed" => riffel.once(&task, *across)?,
                _ => riffel.time(&task, *across)?,
            };
            times.push(seconds);
        }
    }
    let ratios: Vec<f64> = times[5].iter().zip(&times[4]).map(|(waves, flat)| waves / flat).collect();
    Ok((times.map(|times| 1e3 * median(times)), median(ratios)))
}

/// The section of the report.
pub(crate) fn report(text: &mut Section, peers: &Peers) -> Result<(), Failure> {
    let (times, on_waves_costs) = measured(&mut peers.riffel(1)?)?;
    let (across, elements, cells, points) =
        (sizes().elements, sizes().response_elements, sizes().cells, sizes().stress_points);
    let [wavelengths, of_table] = sizes().wavelengths;
    let [steady, step, response, table, of_case, on_waves, one, followed, fastsim, stress, stress_partial] = times;
    let rounds = sizes().few_rounds;
    writeln!(text, "Half-space theory, one thread; medians of {rounds} rounds. Machine: {}.\n", machine())?;
    writeln!(text, "| task | Riffel | beside it | Riffel is |\n|---|---|---|---|")?;
    writeln!(
        text,
        "| steady rolling, {across} × {across} elements, and {0} × {0} to extrapolate, from free rolling to full slip | \
         {steady:.1} ms | CONTACT, {across} × {across} alone: {1:.0} ms and {2:.0} ms by its two solvers | {3:.0} × and \
         {4:.0} × faster |",
        across / 2,
        CONTACT_STEADY[0],
        CONTACT_STEADY[1],
        CONTACT_STEADY[0] / steady,
        CONTACT_STEADY[1] / steady,
    )?;
    writeln!(
        text,
        "| step of transient rolling, {across} × {across} | {step:.2} ms | CONTACT: {CONTACT_STEP:.1} ms | {:.1} × faster |",
        CONTACT_STEP / step
    )?;
    writeln!(
        text,
        "| frequency response, {wavelengths} wavelengths, load, both creepages and spin, {elements} × {elements} and a \
         quarter of it | {response:.0} ms | | |"
    )?;
    writeln!(
        text,
        "| the same, {of_table} wavelengths, about creepage along and across the rail with spin, the steady state at hand | \
         {table:.0} ms | | |"
    )?;
    writeln!(
        text,
        "| table of a case, 20–200 mm, load, creepage along the rail and the geometry of the wave | {on_waves:.0} ms | without \
         the wave: {of_case:.0} ms | {on_waves_costs:.2} times that |"
    )?;
    writeln!(
        text,
        "| the response at one wavelength, 8 a | {one:.1} ms | Riffel followed in time: {followed:.0} ms | {:.0} × faster |",
        followed / one
    )?;
    writeln!(
        text,
        "| FASTSIM, {cells} × {cells} cells, with lateral creepage and spin | {:.1} µs | | |",
        1e3 * fastsim
    )?;
    writeln!(
        text,
        "| stress under the patch, {points} × {points} × {0} points, full slip | {stress:.0} ms | in partial slip \
         {stress_partial:.0} ms | |",
        points / 2
    )?;
    writeln!(
        text,
        "\nCONTACT's times are not of this run: they were taken with its tolerance of 1e-5 on another \
         machine of two processors (`validation/reference/contact/timing.csv`). Riffel's tolerance is 1e-6 in the \
         steady state and 1e-5 in time."
    )?;
    Ok(())
}
