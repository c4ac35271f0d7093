//! Geometry of a wheelset on its track, its exact contact, and a bogie in a curve.

use std::fmt::Write as _;
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

use riffel::Rail;
use riffel_case::traffic::{Traffic, bands_of};
use riffel_case::{Case, CurvingCase, Variant};
use riffel_curving::profile::ContactSurface;

use crate::contestant::{Contestant, Failure, Peers, machine};
use crate::section::Section;
use crate::{median, sizes};

/// Yaws of the geometry.
const YAWS: [f64; 3] = [0.0, 5e-3, 10e-3];

fn case(name: &str, overrides: &[&str]) -> Result<CurvingCase, Failure> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../cases").join(format!("{name}.toml"));
    let overrides: Vec<String> = overrides.iter().map(|one| (*one).to_owned()).collect();
    Ok(CurvingCase::read(&path, &overrides)?)
}

/// One task by its name, with the number of repetitions inside it.
pub(crate) fn task(name: &str, repeats: usize) -> Result<(f64, f64), Failure> {
    match name {
        "geometry" => geometry(repeats),
        "contact" => contact(repeats),
        "traffic" => traffic(repeats),
        _ => equilibrium(name, repeats),
    }
}

/// Both wheels of a wheelset at every shift and yaw.
fn geometry(repeats: usize) -> Result<(f64, f64), Failure> {
    let wheelset = case("profiles", &[])?.wheelset_on_track()?;
    let shifts = sizes().shifts;
    let places: Vec<(f64, f64)> =
        YAWS.iter().flat_map(|yaw| (0..shifts).map(|index| (1e-4 * f64::from(index - shifts / 2), *yaw))).collect();
    let begun = Instant::now();
    let mut sum = 0.0;
    for _ in 0..repeats {
        let contacts = wheelset.contacts(black_box(&places));
        let found = contacts.into_iter().flatten();
        sum = found.map(|contact| contact.rolling_radius_difference().abs()).sum();
    }
    Ok((begun.elapsed().as_secs_f64() / repeats as f64, sum))
}

/// The right wheel of a centred wheelset under a load, without stiffness.
fn contact(repeats: usize) -> Result<(f64, f64), Failure> {
    let case = case("profiles", &[])?;
    let (wheelset, steel) = (case.wheelset_on_track()?, case.steel()?);
    let place = wheelset.contact(0.0, 0.0)?;
    let begun = Instant::now();
    let mut sum = 0.0;
    for _ in 0..repeats {
        let load = black_box(60e3);
        sum = wheelset
            .under_load(&place, Rail::Right, steel, load, ContactSurface::Flat, sizes().patch_elements)?
            .state()
            .approach();
    }
    Ok((begun.elapsed().as_secs_f64() / repeats as f64, sum))
}

/// One equilibrium of the bogie of a case, without the search for others; "CASE+LAW" names a creep law.
fn equilibrium(name: &str, repeats: usize) -> Result<(f64, f64), Failure> {
    let (name, law) = name.split_once('+').unwrap_or((name, "shen-hedrick-elkins"));
    let law = format!("contact.creep_law={law}");
    let vehicle = case(name, &[&law])?.vehicle_in_curve()?;
    let begun = Instant::now();
    let mut sum = 0.0;
    for _ in 0..repeats {
        sum = black_box(&vehicle).equilibrium()?.frictional_power;
    }
    Ok((begun.elapsed().as_secs_f64() / repeats as f64, sum))
}

/// Growth on both rails under four bogies at as many speeds as asked, every wheel in its own state of the metro curve.
fn traffic(speeds: usize) -> Result<(f64, f64), Failure> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../cases/metro-curve.toml");
    let listed = (0..speeds).map(|speed| {
        let kmh = 35.0 + 30.0 * speed as f64 / speeds as f64;
        let share = (speeds as f64).recip();
        format!("{{ speed = \"{kmh} km/h\", share = {share} }}")
    });
    let listed = listed.collect::<Vec<_>>().join(", ");
    let bogie = |load: i32| {
        format!(
            "[[vehicle]]\nname = \"{load} kN\"\nshare = 0.25\ncurve = true\nwheel_load = \"{load} kN\"\nspeeds = [{listed}]\n"
        )
    };
    let traffic = Traffic::parse("traffic.toml", &[42, 45, 48, 51].map(bogie).concat())?;
    let begun = Instant::now();
    let mut sum = 0.0;
    for rail in ["low", "high"] {
        let case = Case::read(&path, &[format!("contact.from.rail={rail}")])?.sharing_parts();
        let on = traffic.on(&case, &bands_of(&case), &Variant::none(""), &|_| ())?;
        sum += on.growth.rates().iter().sum::<f64>();
    }
    Ok((begun.elapsed().as_secs_f64(), sum))
}

/// The section of the report.
pub(crate) fn report(text: &mut Section, peers: &Peers) -> Result<(), Failure> {
    let (mut one, mut two) = (peers.riffel(1)?, peers.riffel(2)?);
    let (rounds, fewest, shifts, elements, speeds) =
        (sizes().few_rounds, sizes().fewest_rounds, sizes().shifts, sizes().patch_elements, sizes().speeds);
    let milliseconds = |contestant: &mut Contestant, name: &str, repeats: usize, rounds: usize| {
        let times = (0..rounds)
            .map(|_| Ok(contestant.time(&format!("curving {name}"), repeats)?.0))
            .collect::<Result<Vec<f64>, Failure>>()?;
        Ok::<f64, Failure>(1e3 * median(times))
    };
    let [single, double] =
        [milliseconds(&mut one, "geometry", 1, rounds)?, milliseconds(&mut two, "geometry", 1, rounds)?];
    let contact = milliseconds(&mut one, "contact", 3, rounds)?;
    writeln!(
        text,
        "Medians of {rounds} rounds, of {fewest} of the growth; one thread unless said. Machine: {}.\n",
        machine()
    )?;
    writeln!(text, "| what | took | asked |\n|---|---|---|")?;
    writeln!(
        text,
        "| wheelset on its track, both rails, S1002 on 60E1, {shifts} shifts 0.1 mm apart at three yaws | {single:.0} ms on one \
         thread, {double:.0} ms on two | 50 ms |"
    )?;
    writeln!(text, "| exact contact of one wheel on its profiles, {elements} elements | {contact:.1} ms | 20 ms |")?;
    for (name, what, asked) in [
        ("bogie", "cones with a flange (`bogie.toml`)", "5 ms"),
        ("profiles", "profiles (`profiles.toml`)", "5 ms"),
        ("metro-curve", "two points (`metro-curve.toml`)", "5 ms"),
        ("metro-curve+fastsim", "the same with FASTSIM", "1 s"),
    ] {
        let repeats = if name.contains('+') { 1 } else { 20 };
        let took = milliseconds(&mut one, name, repeats, rounds)?;
        writeln!(text, "| equilibrium of a bogie by steps from straight track: {what} | {took:.2} ms | {asked} |")?;
    }
    let took = 1e-3 * milliseconds(&mut two, "traffic", speeds, fewest)?;
    writeln!(
        text,
        "| growth on both rails under four bogies at {speeds} speeds, every wheel in its own state of `metro-curve.toml`, two threads | {took:.1} s | 1 s |"
    )?;
    Ok(())
}
