//! Riffel beside its peers, alternating in one run; medians and ratios, for the machine is noisy.
//!
//! `cargo xtask bench` prints the table and writes it to `benches/README.md`.

mod peer;

use std::fmt::Write as _;
use std::path::Path;
use std::time::Instant;

use rayon::{ThreadPool, ThreadPoolBuilder};
use riffel::{Axis, FeedbackLoop, GrowthMap, Ridge};
use riffel_case::{BHASKAR_TRACK_CASE, Case, NOMINAL_CASE};

use peer::{Failure, Peer};

/// Points along each axis of the map of the comparison.
const SIDE: usize = 1001;
const ROUNDS: usize = 21;

fn main() -> Result<(), Failure> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut peer = Peer::start(folder)?;
    let report = report(&mut peer)?;
    println!("{report}");
    std::fs::write(folder.join("README.md"), report)?;
    Ok(())
}

fn feedback(text: &str, overrides: &[&str]) -> Result<FeedbackLoop, Failure> {
    let overrides: Vec<String> = overrides.iter().map(|&text| text.to_owned()).collect();
    Ok(Case::parse("benchmark", text, &overrides)?.feedback)
}

fn axes(side: usize) -> Result<(Axis, Axis), Failure> {
    Ok((Axis::new(0.020, 0.080, side)?, Axis::new(5.0, 60.0, side)?))
}

fn pool(threads: usize) -> Result<ThreadPool, Failure> {
    Ok(ThreadPoolBuilder::new().num_threads(threads).build()?)
}

/// Seconds for one map and the sum of its real parts.
fn map_seconds(
    pool: &ThreadPool,
    feedback: &FeedbackLoop,
    side: usize,
) -> Result<(f64, f64), Failure> {
    let (wavelength, speed) = axes(side)?;
    let begun = Instant::now();
    let map = pool.install(|| GrowthMap::compute(feedback, wavelength, speed, |_| ()));
    let seconds = begun.elapsed().as_secs_f64();
    Ok((
        seconds,
        map.normalized_dissipation()
            .iter()
            .map(|value| value.re)
            .sum(),
    ))
}

fn ridge_seconds(pool: &ThreadPool, feedback: &FeedbackLoop, side: usize) -> Result<f64, Failure> {
    let (wavelength, speed) = axes(side)?;
    let begun = Instant::now();
    let ridge = pool.install(|| Ridge::search(feedback, wavelength, speed));
    let seconds = begun.elapsed().as_secs_f64();
    if ridge.points.len() == side {
        Ok(seconds)
    } else {
        Err("a ridge of the wrong length".into())
    }
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn per_point(seconds: f64, side: usize) -> f64 {
    1e9 * seconds / (side * side) as f64
}

fn report(peer: &mut Peer) -> Result<String, Failure> {
    let (one, two) = (pool(1)?, pool(2)?);
    let free = feedback(NOMINAL_CASE, &[])?;
    let mut text = String::from("# Benchmarks\n\n");
    writeln!(
        text,
        "Written by `cargo xtask bench`. Machine: {}.",
        peer::machine()
    )?;
    writeln!(
        text,
        "Peers run in the same run, in turn with Riffel; times are medians of {ROUNDS} rounds, memory for the result \
         included on both sides.\n"
    )?;

    // Side by side: NumPy, one thread, two threads, round by round.
    let (mut numpy, mut single, mut double) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..ROUNDS {
        let (seconds, peer_sum) = peer.map(SIDE)?;
        let (on_one, sum) = map_seconds(&one, &free, SIDE)?;
        let (on_two, _) = map_seconds(&two, &free, SIDE)?;
        if ((sum - peer_sum) / peer_sum).abs() > 1e-9 {
            return Err(format!("the maps differ: {sum} here, {peer_sum} in NumPy").into());
        }
        numpy.push(seconds);
        single.push(on_one);
        double.push(on_two);
    }
    let (numpy, single, double) = (median(numpy), median(single), median(double));
    writeln!(text, "## Growth map, {SIDE} × {SIDE} points, free beam\n")?;
    writeln!(text, "| | ns a point | ratio |\n|---|---|---|")?;
    writeln!(
        text,
        "| NumPy {}, one thread | {:.1} | 1 |",
        peer.version(),
        per_point(numpy, SIDE)
    )?;
    writeln!(
        text,
        "| Riffel, one thread | {:.1} | {:.1} × NumPy |",
        per_point(single, SIDE),
        numpy / single
    )?;
    writeln!(
        text,
        "| Riffel, two threads | {:.1} | {:.2} × one thread |\n",
        per_point(double, SIDE),
        single / double
    )?;

    writeln!(
        text,
        "## Other tracks, {SIDE} × {SIDE} points, one thread\n"
    )?;
    writeln!(
        text,
        "| track | map, ns a point | ridge alone, ns a point |\n|---|---|---|"
    )?;
    for (name, feedback) in [
        ("free beam", free.clone()),
        (
            "moving beam, closed form",
            feedback(NOMINAL_CASE, &["track.model=moving-beam"])?,
        ),
        (
            "two layers, table good to 1e-9",
            feedback(BHASKAR_TRACK_CASE, &[])?,
        ),
    ] {
        let (mut maps, mut ridges) = (Vec::new(), Vec::new());
        for _ in 0..ROUNDS {
            maps.push(map_seconds(&one, &feedback, SIDE)?.0);
            ridges.push(ridge_seconds(&one, &feedback, SIDE)?);
        }
        let (map, ridge) = (
            per_point(median(maps), SIDE),
            per_point(median(ridges), SIDE),
        );
        writeln!(text, "| {name} | {map:.1} | {ridge:.1} |")?;
    }

    writeln!(text, "\n## Cost against size, free beam, one thread\n")?;
    writeln!(
        text,
        "| points | ns a point | ridge alone, ns a point |\n|---|---|---|"
    )?;
    for (side, rounds) in [(100, 201), (316, 101), (1000, 21), (3162, 7), (10_000, 3)] {
        let (mut maps, mut ridges) = (Vec::new(), Vec::new());
        for _ in 0..rounds {
            maps.push(map_seconds(&one, &free, side)?.0);
            ridges.push(ridge_seconds(&one, &free, side)?);
        }
        let (map, ridge) = (
            per_point(median(maps), side),
            per_point(median(ridges), side),
        );
        writeln!(text, "| {side}² | {map:.1} | {ridge:.1} |")?;
    }
    text.push_str(
        "\nThe ridge search keeps one row of the map in memory for each thread; its cost includes the refinement of \
         each speed's minimum, some 35 evaluations of the whole loop, which weighs on short rows.\n",
    );
    Ok(text)
}
