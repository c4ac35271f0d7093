//! The growth map of the free beam beside NumPy, on threads, and by its size.

use std::fmt::Write as _;
use std::time::Instant;

use riffel::growth::RowEvaluator;
use riffel::{Axis, Complex64, GrowthMap, Ridge};

use crate::contestant::{Contestant, Failure, Peers, machine};
use crate::section::Section;
use crate::tracks::feedback;
use crate::{median, sizes};

/// A map, its rows one by one, or its ridge.
pub(crate) fn task(task: &str, track: &str, side: usize) -> Result<(f64, f64), Failure> {
    let feedback = feedback(track)?;
    let wavelength = Axis::new(0.020, 0.080, side)?;
    let speed = Axis::new(5.0, 60.0, side)?;
    let begun = Instant::now();
    Ok(match task {
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
            let sum = values.map(|point| point.normalized_dissipation).sum();
            (seconds, sum)
        }
    })
}

/// Median nanoseconds a point of a task.
fn cost(contestant: &mut Contestant, task: &str, side: usize, rounds: usize) -> Result<f64, Failure> {
    let seconds = (0..rounds).map(|_| Ok(contestant.time(task, side)?.0)).collect::<Result<Vec<f64>, Failure>>()?;
    Ok(1e9 * median(seconds) / (side * side) as f64)
}

/// The section of the map.
pub(crate) fn report(text: &mut Section, peers: &Peers) -> Result<(), Failure> {
    let (side, rounds) = (sizes().side, sizes().rounds);
    let mut numpy = peers.numpy("map_numpy.py", &[])?;
    let (mut one, mut two) = (peers.riffel(1)?, peers.riffel(2)?);
    let mut times = [const { Vec::new() }; 3];
    for _ in 0..rounds {
        let written = numpy.time("as-written", side)?;
        let tuned = numpy.time("tuned", side)?;
        let single = one.time("map free", side)?;
        text.compare("NumPy", (written.1, single.1), 1e-9);
        text.compare("NumPy, tuned by hand", (tuned.1, single.1), 1e-9);
        for (times, (seconds, _)) in times.iter_mut().zip([written, tuned, single]) {
            times.push(1e9 * seconds / (side * side) as f64);
        }
    }
    let [written, tuned, single] = times.map(median);
    let version = peers.numpy_version()?;
    writeln!(text, "{side} × {side} points, free beam; {rounds} rounds. Machine: {}.\n", machine())?;
    writeln!(text, "| contestant | ns a point | ratio |\n|---|---|---|")?;
    writeln!(text, "| NumPy {version}, formulas as printed, one thread | {written:.1} | |")?;
    writeln!(text, "| NumPy {version}, tuned by hand, one thread | {tuned:.1} | |")?;
    writeln!(
        text,
        "| Riffel, one thread | {single:.1} | {:.1} × NumPy as printed, {:.1} × NumPy tuned |",
        written / single,
        tuned / single
    )?;

    let (mut singles, mut doubles) = (Vec::new(), Vec::new());
    for _ in 0..rounds {
        singles.push(one.time("map free", side)?.0);
        doubles.push(two.time("map free", side)?.0);
    }
    let [single, double] = [singles, doubles].map(|times| 1e9 * median(times) / (side * side) as f64);
    writeln!(text, "\n| threads | ns a point | ratio |\n|---|---|---|")?;
    writeln!(text, "| one | {single:.1} | 1 |")?;
    writeln!(text, "| two | {double:.1} | {:.2} |", single / double)?;
    Ok(())
}

/// The section of maps of several sizes.
pub(crate) fn report_sizes(text: &mut Section, peers: &Peers) -> Result<(), Failure> {
    let mut one = peers.riffel(1)?;
    writeln!(text, "Free beam, one thread. Machine: {}.\n", machine())?;
    writeln!(text, "| points | row by row, no map kept | whole map in memory | ridge alone |\n|---|---|---|---|")?;
    for &(side, rounds) in sizes().sides {
        let rows = cost(&mut one, "rows free", side, rounds)?;
        let map = cost(&mut one, "map free", side, rounds)?;
        let ridge = cost(&mut one, "ridge free", side, rounds)?;
        writeln!(text, "| {side}² | {rows:.1} | {map:.1} | {ridge:.1} |")?;
    }
    writeln!(
        text,
        "\nNanoseconds a point. What a large map costs more than its rows is the first touch of its memory, 16 bytes \
         a point, which the system gives page by page. The ridge search keeps one row for each thread; its cost \
         includes the refinement of each speed's minimum, some 20 to 30 evaluations of the whole loop, which weighs \
         on short rows."
    )?;
    Ok(())
}
