//! Riffel beside its peers, in turn in one run; medians and ratios, for the machine is noisy.
//!
//! `cargo xtask bench` prints the report and writes it to `benches/README.md`. Every contestant is a
//! process of its own that keeps what it needs between tasks, as a program in use does.

mod contestant;

use std::fmt::Write as _;
use std::io::{BufRead, Write as _};
use std::path::Path;
use std::time::Instant;

use riffel::{Axis, Complex64, FeedbackLoop, GrowthMap, Ridge, RowEvaluator};
use riffel_case::{BHASKAR_TRACK_CASE, Case, NOMINAL_CASE};

use contestant::{Contestant, Failure, machine, numpy_version};

/// Points along each axis of the map of the comparison.
const SIDE: usize = 1001;
const ROUNDS: usize = 41;

/// The argument that makes this program a contestant.
pub(crate) const CONTESTANT: &str = "--contestant";

fn main() -> Result<(), Failure> {
    if std::env::args().any(|argument| argument == CONTESTANT) {
        return contest();
    }
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let report = report(folder)?;
    println!("{report}");
    std::fs::write(folder.join("README.md"), report)?;
    Ok(())
}

/// The tracks of the tasks.
fn feedback(track: &str) -> Result<FeedbackLoop, Failure> {
    let moving = ["track.model=moving-beam".to_owned()];
    let (text, overrides): (&str, &[String]) = match track {
        "moving" => (NOMINAL_CASE, &moving),
        "two-layer" => (BHASKAR_TRACK_CASE, &[]),
        _ => (NOMINAL_CASE, &[]),
    };
    Ok(Case::parse("benchmark", text, overrides)?.feedback)
}

/// Answer each line "TASK TRACK SIDE" with the seconds it took and a sum of the result.
fn contest() -> Result<(), Failure> {
    for line in std::io::stdin().lock().lines() {
        let line = line?;
        let [task, track, side] = line.split(' ').collect::<Vec<_>>()[..] else {
            return Err("a task has three words".into());
        };
        let feedback = feedback(track)?;
        let wavelength = Axis::new(0.020, 0.080, side.parse()?)?;
        let speed = Axis::new(5.0, 60.0, side.parse()?)?;
        let begun = Instant::now();
        let (seconds, sum): (f64, f64) = match task {
            "map" => {
                let map = GrowthMap::compute(&feedback, wavelength, speed, |_| ());
                let seconds = begun.elapsed().as_secs_f64();
                let values = map.rows().flat_map(|(_, row)| row);
                (seconds, values.map(|value| value.re).sum())
            }
            "rows" => {
                let mut evaluator = RowEvaluator::new(&feedback, &wavelength.values());
                let mut row = vec![Complex64::ZERO; wavelength.points()];
                let mut sum = 0.0;
                for index in 0..speed.points() {
                    evaluator.evaluate(speed.value(index), &mut row);
                    // A few values show that the row was computed and cost nothing.
                    sum += row[0].re + row[row.len() / 2].re;
                }
                (begun.elapsed().as_secs_f64(), sum)
            }
            _ => {
                let ridge = Ridge::search(&feedback, wavelength, speed);
                let seconds = begun.elapsed().as_secs_f64();
                let values = ridge.points.iter();
                (
                    seconds,
                    values.map(|point| point.normalized_dissipation).sum(),
                )
            }
        };
        println!("{seconds} {sum}");
        std::io::stdout().flush()?;
    }
    Ok(())
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Median nanoseconds a point of a task.
fn cost(
    contestant: &mut Contestant,
    task: &str,
    side: usize,
    rounds: usize,
) -> Result<f64, Failure> {
    let seconds = (0..rounds)
        .map(|_| Ok(contestant.time(task, side)?.0))
        .collect::<Result<Vec<f64>, Failure>>()?;
    Ok(1e9 * median(seconds) / (side * side) as f64)
}

fn report(folder: &Path) -> Result<String, Failure> {
    let mut numpy = Contestant::numpy(folder)?;
    let (mut one, mut two) = (Contestant::riffel(1)?, Contestant::riffel(2)?);
    let mut text = String::from("# Benchmarks\n\n");
    writeln!(
        text,
        "Written by `cargo xtask bench`. Machine: {}.",
        machine()
    )?;
    writeln!(
        text,
        "Contestants work in turn in one run, each task after a warm-up of its own; times are medians of \
         {ROUNDS} rounds and include the memory of the result.\n"
    )?;

    let mut times = [const { Vec::new() }; 3];
    for _ in 0..ROUNDS {
        let written = numpy.time("as-written", SIDE)?;
        let tuned = numpy.time("tuned", SIDE)?;
        let single = one.time("map free", SIDE)?;
        for (times, (seconds, sum)) in times.iter_mut().zip([written, tuned, single]) {
            if ((sum - written.1) / written.1).abs() > 1e-9 {
                return Err(format!("the maps differ: {sum}, {} in NumPy", written.1).into());
            }
            times.push(1e9 * seconds / (SIDE * SIDE) as f64);
        }
    }
    let [written, tuned, single] = times.map(median);
    let version = numpy_version(folder)?;
    writeln!(text, "## Growth map, {SIDE} × {SIDE} points, free beam\n")?;
    writeln!(text, "| contestant | ns a point | ratio |\n|---|---|---|")?;
    writeln!(
        text,
        "| NumPy {version}, formulas as printed, one thread | {written:.1} | |"
    )?;
    writeln!(
        text,
        "| NumPy {version}, tuned by hand, one thread | {tuned:.1} | |"
    )?;
    writeln!(
        text,
        "| Riffel, one thread | {single:.1} | {:.1} × NumPy as printed, {:.1} × NumPy tuned |",
        written / single,
        tuned / single
    )?;

    writeln!(text, "\n## Threads, {SIDE} × {SIDE} points, free beam\n")?;
    let (mut singles, mut doubles) = (Vec::new(), Vec::new());
    for _ in 0..ROUNDS {
        singles.push(one.time("map free", SIDE)?.0);
        doubles.push(two.time("map free", SIDE)?.0);
    }
    let [single, double] =
        [singles, doubles].map(|times| 1e9 * median(times) / (SIDE * SIDE) as f64);
    writeln!(text, "| threads | ns a point | ratio |\n|---|---|---|")?;
    writeln!(text, "| one | {single:.1} | 1 |")?;
    writeln!(text, "| two | {double:.1} | {:.2} |\n", single / double)?;

    writeln!(
        text,
        "## Other tracks, {SIDE} × {SIDE} points, one thread\n"
    )?;
    writeln!(
        text,
        "| track | map, ns a point | ridge alone, ns a point |\n|---|---|---|"
    )?;
    for (name, track) in [
        ("free beam", "free"),
        ("moving beam, closed form", "moving"),
        ("two layers, table good to 1e-9", "two-layer"),
    ] {
        let map = cost(&mut one, &format!("map {track}"), SIDE, ROUNDS)?;
        let ridge = cost(&mut one, &format!("ridge {track}"), SIDE, ROUNDS)?;
        writeln!(text, "| {name} | {map:.1} | {ridge:.1} |")?;
    }

    writeln!(text, "\n## Cost against size, free beam, one thread\n")?;
    writeln!(
        text,
        "| points | row by row, no map kept | whole map in memory | ridge alone |\n|---|---|---|---|"
    )?;
    for (side, rounds) in [(100, 401), (316, 201), (1000, 41), (3162, 11), (10_000, 5)] {
        let rows = cost(&mut one, "rows free", side, rounds)?;
        let map = cost(&mut one, "map free", side, rounds)?;
        let ridge = cost(&mut one, "ridge free", side, rounds)?;
        writeln!(text, "| {side}² | {rows:.1} | {map:.1} | {ridge:.1} |")?;
    }
    text.push_str(
        "\nNanoseconds a point. What a large map costs more than its rows is the first touch of its memory, 16 bytes \
         a point, which the system gives page by page. The ridge search keeps one row for each thread; its cost \
         includes the refinement of each speed's minimum, some 20 to 30 evaluations of the whole loop, which weighs \
         on short rows.\n",
    );
    Ok(text)
}
