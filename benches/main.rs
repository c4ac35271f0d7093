//! Riffel beside its peers, in turn in one run; medians and ratios, for the machine is noisy.
//!
//! `cargo xtask bench` prints the report and writes it to `benches/README.md`. Every contestant is a
//! process of its own that keeps what it needs between tasks, as a program in use does.

mod contact;
mod contestant;
mod curving;
mod first_build;
mod general;
mod passage;
mod python;
mod roughness;
mod study;

use std::fmt::Write as _;
use std::hint::black_box;
use std::io::{BufRead, Write as _};
use std::path::Path;
use std::time::Instant;

use riffel::growth::RowEvaluator;
use riffel::receptance::{Beam, Layer, PeriodicTrack, ShearSection, Support};
use riffel::{Axis, Complex64, ElasticMaterial, GrowthMap, Loop, Receptance, Ridge};
use riffel_case::{BHASKAR_TRACK_CASE, Case, NOMINAL_CASE};

use contestant::{Contestant, Failure, machine, numpy_version, rolland_version};

/// Points along each axis of the map of the comparison.
const SIDE: usize = 1001;
const ROUNDS: usize = 41;
/// Frequencies of the receptance of the comparison.
const FREQUENCIES: usize = 200;
/// rolland takes a quarter of a second a turn.
const ROLLAND_ROUNDS: usize = 5;
/// Points along each axis of the map under a moving load on layers, whose points cost most.
const MOVING_LOAD_SIDE: usize = 101;

/// The argument that makes this program a contestant.
pub(crate) const CONTESTANT: &str = "--contestant";

/// The argument that prints the section on Python alone and writes nothing.
const PYTHON: &str = "--python";

/// The argument that prints one section alone, by its name, and writes nothing.
const SECTION: &str = "--section";

/// The argument that records the first build alone.
const BUILD: &str = "--build";

fn main() -> Result<(), Failure> {
    if std::env::args().any(|argument| argument == CONTESTANT) {
        return contest();
    }
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    if std::env::args().any(|argument| argument == PYTHON) {
        let mut text = String::new();
        python::report(&mut text, folder)?;
        println!("{text}");
        return Ok(());
    }
    if std::env::args().any(|argument| argument == BUILD) {
        return first_build::record(folder);
    }
    let mut arguments = std::env::args().skip_while(|argument| argument != SECTION);
    if let Some(section) = arguments.nth(1) {
        let mut text = String::new();
        let (mut one, mut two) = (Contestant::riffel(1)?, Contestant::riffel(2)?);
        match &*section {
            "general" => general::report(&mut text, folder, &mut one, &mut two)?,
            "contact" => contact::report(&mut text, &mut one)?,
            "curving" => curving::report(&mut text, &mut one, &mut two)?,
            "passage" => passage::report(&mut text, folder, &mut one)?,
            "tracks" => report_tracks(&mut text, &mut one)?,
            _ => return Err("sections are general, contact, curving, passage and tracks".into()),
        }
        println!("{text}");
        return Ok(());
    }
    let report = report(folder)? + &first_build::recorded(folder);
    println!("{report}");
    std::fs::write(folder.join("README.md"), report)?;
    Ok(())
}

/// The tracks of the tasks.
fn feedback(track: &str) -> Result<Loop, Failure> {
    const MOVING: &str = "track.model=moving-beam";
    const PERIODIC: [&str; 4] =
        ["rail.section=60E1", "track.model=two-layer-periodic", "track.preset=br-stiff", "track.position=0.35 m"];
    let (text, overrides) = match track {
        "moving" => (NOMINAL_CASE, vec![MOVING]),
        "wave-geometry" => (NOMINAL_CASE, vec!["contact.wave_geometry=true"]),
        "flow" => {
            let law = [
                "damage.laws=[\"wear\", \"flow\"]",
                "damage.spread=0.1",
                "damage.flow.depth=\"1 nm\"",
                "damage.flow.exponent=1",
            ];
            (NOMINAL_CASE, law.to_vec())
        }
        "two-layer" => (BHASKAR_TRACK_CASE, vec![]),
        "moving-two-layer" => (BHASKAR_TRACK_CASE, vec![MOVING]),
        "periodic" => {
            let lossy = [&PERIODIC[..], &["rail.loss_factor=0.02"]].concat();
            (NOMINAL_CASE, lossy)
        }
        "periodic-lossless" => (NOMINAL_CASE, PERIODIC.to_vec()),
        _ => (NOMINAL_CASE, vec![]),
    };
    let overrides: Vec<_> = overrides.into_iter().map(str::to_owned).collect();
    Ok(Case::parse("benchmark", text, &overrides)?.feedback)
}

/// Answer each line "TASK TRACK POINTS" with the seconds it took and a sum of the result.
fn contest() -> Result<(), Failure> {
    for line in std::io::stdin().lock().lines() {
        let line = line?;
        let [task, track, points] = line.split(' ').collect::<Vec<_>>()[..] else {
            return Err("a task has three words".into());
        };
        let (seconds, sum) = match task {
            "receptance" => receptance(points.parse()?)?,
            "contact" => contact::task(track, points.parse()?)?,
            "curving" => curving::task(track, points.parse()?)?,
            "general" => general::task(track, points.parse()?)?,
            "passage" => passage::task(track, points.parse()?)?,
            "study" => study::contest(points.parse()?)?,
            _ if task.starts_with("roughness") => roughness::contest(task, track, points.parse()?)?,
            _ => growth(task, track, points.parse()?)?,
        };
        println!("{seconds} {sum}");
        std::io::stdout().flush()?;
    }
    Ok(())
}

/// A map, its rows one by one, or its ridge.
fn growth(task: &str, track: &str, side: usize) -> Result<(f64, f64), Failure> {
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

/// Receptances from 20 Hz to 3000 Hz, spaced evenly in logarithm, and the sum of their moduli.
fn receptance(points: usize) -> Result<(f64, f64), Failure> {
    /// A single turn is too short for the clock and for the processor to settle.
    const REPEATS: usize = 50;
    let angular_frequencies: Vec<f64> = (0..points)
        .map(|index| index as f64 / (points - 1) as f64)
        .map(|share| std::f64::consts::TAU * 20.0 * (3000.0_f64 / 20.0).powf(share))
        .collect();
    let begun = Instant::now();
    let mut receptances = Vec::new();
    for _ in 0..REPEATS {
        let track = black_box(uic60_on_stiff_pads()?);
        let values = angular_frequencies.iter();
        receptances = black_box(values.map(|&w| track.receptance(w, 0.0)).collect());
    }
    let seconds = begun.elapsed().as_secs_f64() / REPEATS as f64;
    Ok((seconds, receptances.iter().map(|value| value.norm()).sum()))
}

/// At mid-span; values of validation/reference/receptance/uic60_stiff_pad.json.
fn uic60_on_stiff_pads() -> Result<PeriodicTrack, Failure> {
    let spacing = 0.6;
    let section = ShearSection { area: 7.67e-3, shear_coefficient: 0.393, shear_modulus: 80.769e9, density: 7850.0 };
    let steel = ElasticMaterial::new(210e9, 0.3)?;
    let rail = Beam::timoshenko(steel, 3.037e-5, 60.2, section)?.with_loss_factor(0.02)?;
    let support = Support::two_layer(Layer::new(800e6, 30e3)?, 162.0, Layer::new(100e6, 60e3)?)?;
    Ok(PeriodicTrack::new(rail, support, spacing)?.at(spacing / 2.0))
}

/// An error unless two contestants found the same.
fn check_agreement(what: &str, (sum, expected): (f64, f64), tolerance: f64) -> Result<(), Failure> {
    let difference = ((sum - expected) / expected).abs();
    if difference <= tolerance {
        return Ok(());
    }
    let message = format!("the {what} differ by {difference:.1e}, more than {tolerance:.0e}: {sum}, not {expected}");
    Err(message.into())
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// A ratio with the digits that its noise leaves.
fn ratio(value: f64) -> String {
    let decimals = usize::from(value < 100.0);
    format!("{value:.decimals$}")
}

/// Median nanoseconds a point of a task.
fn cost(contestant: &mut Contestant, task: &str, side: usize, rounds: usize) -> Result<f64, Failure> {
    let seconds = (0..rounds).map(|_| Ok(contestant.time(task, side)?.0)).collect::<Result<Vec<f64>, Failure>>()?;
    Ok(1e9 * median(seconds) / (side * side) as f64)
}

fn report(folder: &Path) -> Result<String, Failure> {
    let mut numpy = Contestant::numpy(folder, "map_numpy.py")?;
    let (mut one, mut two) = (Contestant::riffel(1)?, Contestant::riffel(2)?);
    let mut text = String::from("# Benchmarks\n\n");
    writeln!(text, "Written by `cargo xtask bench`. Machine: {}; profile `dist`.", machine())?;
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
            check_agreement("maps", (sum, written.1), 1e-9)?;
            times.push(1e9 * seconds / (SIDE * SIDE) as f64);
        }
    }
    let [written, tuned, single] = times.map(median);
    let version = numpy_version(folder)?;
    writeln!(text, "## Growth map, {SIDE} × {SIDE} points, free beam\n")?;
    writeln!(text, "| contestant | ns a point | ratio |\n|---|---|---|")?;
    writeln!(text, "| NumPy {version}, formulas as printed, one thread | {written:.1} | |")?;
    writeln!(text, "| NumPy {version}, tuned by hand, one thread | {tuned:.1} | |")?;
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
    let [single, double] = [singles, doubles].map(|times| 1e9 * median(times) / (SIDE * SIDE) as f64);
    writeln!(text, "| threads | ns a point | ratio |\n|---|---|---|")?;
    writeln!(text, "| one | {single:.1} | 1 |")?;
    writeln!(text, "| two | {double:.1} | {:.2} |\n", single / double)?;

    python::report(&mut text, folder)?;
    report_receptances(&mut text, folder, &mut one)?;
    report_tracks(&mut text, &mut one)?;
    general::report(&mut text, folder, &mut one, &mut two)?;
    contact::report(&mut text, &mut one)?;
    curving::report(&mut text, &mut one, &mut two)?;
    passage::report(&mut text, folder, &mut one)?;
    roughness::report(&mut text, folder, &mut one, &mut two)?;
    study::report(&mut text, folder, &mut one, &mut two)?;

    writeln!(text, "\n## Cost against size, free beam, one thread\n")?;
    writeln!(text, "| points | row by row, no map kept | whole map in memory | ridge alone |\n|---|---|---|---|")?;
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

/// The receptance of one track beside the peers.
fn report_receptances(text: &mut String, folder: &Path, riffel: &mut Contestant) -> Result<(), Failure> {
    let mut numpy = Contestant::numpy(folder, "receptance_numpy.py")?;
    let mut rolland = Contestant::rolland(folder);
    let mut times = [const { Vec::new() }; 4];
    for round in 0..ROUNDS {
        let single = riffel.time("receptance uic60", FREQUENCIES)?;
        let written = numpy.time("as-written", FREQUENCIES)?;
        let tuned = numpy.time("tuned", FREQUENCIES)?;
        check_agreement("receptances of Riffel and NumPy", (written.1, single.1), 1e-9)?;
        check_agreement("receptances of Riffel and NumPy", (tuned.1, single.1), 1e-9)?;
        for (times, (seconds, _)) in times.iter_mut().zip([single, written, tuned]) {
            times.push(seconds);
        }
        if let Ok(rolland) = &mut rolland
            && round < ROLLAND_ROUNDS
        {
            let (seconds, sum) = rolland.time("rolland", FREQUENCIES)?;
            check_agreement("receptances of rolland and Riffel", (sum, single.1), 1e-6)?;
            times[3].push(seconds);
        }
    }
    let [single, written, tuned, others] = times;
    let [single, written, tuned] = [single, written, tuned].map(|times| 1e6 * median(times));
    let row = |contestant: &str, track: &str, time: f64| {
        let each = time / FREQUENCIES as f64;
        let ratio = ratio(time / single);
        format!("| {contestant} | {track} | {time:.0} | {each:.2} | {ratio} × faster |")
    };

    writeln!(text, "## Receptance at mid-span, {FREQUENCIES} frequencies, 20–3000 Hz, one thread\n")?;
    writeln!(text, "Timoshenko rail on discrete two-layer supports: UIC 60 on stiff pads, rail loss factor 0.02.\n")?;
    writeln!(text, "| contestant | track | µs | µs a frequency | Riffel is |\n|---|---|---|---|---|")?;
    let each = single / FREQUENCIES as f64;
    writeln!(text, "| Riffel | infinite | {single:.0} | {each:.2} | |")?;
    let version = numpy_version(folder)?;
    let contestant = format!("NumPy {version}, matrices of the bay, `eig` and `solve`");
    writeln!(text, "{}", row(&contestant, "infinite", written))?;
    let contestant = format!("NumPy {version}, tuned by hand");
    writeln!(text, "{}", row(&contestant, "infinite", tuned))?;
    let contestant = format!("rolland {}, `TSBDiscr2L`", rolland_version(folder)?);
    match rolland {
        Ok(_) => writeln!(text, "{}", row(&contestant, "122 supports", 1e6 * median(others)))?,
        Err(reason) => writeln!(text, "| {contestant} | 122 supports | not installed: {reason} | | |")?,
    }
    writeln!(
        text,
        "\nThe frequencies are given; all else is timed. Riffel and NumPy solve the infinite track exactly, by its \
         Floquet waves; rolland solves an infinite rail on a finite number of supports, a dense matrix for each \
         frequency. The sums of |H| must agree with Riffel's to 1e-9 in NumPy and to 1e-6 in rolland. rolland takes \
         {ROLLAND_ROUNDS} of the {ROUNDS} rounds."
    )?;
    Ok(())
}

/// Maps and ridges of other tracks beside those of the free beam.
fn report_tracks(text: &mut String, riffel: &mut Contestant) -> Result<(), Failure> {
    let tracks = [
        ("free beam", "free", SIDE),
        ("the same, with the geometry of the wave", "wave-geometry", SIDE),
        ("the same, with flow under a spread of loads beside wear", "flow", SIDE),
        ("moving beam, closed form", "moving", SIDE),
        ("two layers, table good to 1e-9", "two-layer", SIDE),
        ("discrete two-layer supports, Timoshenko rail of loss factor 0.02, at mid-span", "periodic", SIDE),
        ("the same, rail without loss", "periodic-lossless", SIDE),
        ("load moving on two layers", "moving-two-layer", MOVING_LOAD_SIDE),
    ];
    let mut maps = tracks.map(|_| Vec::new());
    let mut ridges = tracks.map(|_| Vec::new());
    for _ in 0..ROUNDS {
        for (kind, times) in [("map", &mut maps), ("ridge", &mut ridges)] {
            for ((_, track, side), times) in tracks.iter().zip(times) {
                let (seconds, _) = riffel.time(&format!("{kind} {track}"), *side)?;
                times.push(1e9 * seconds / (side * side) as f64);
            }
        }
    }
    let [maps, ridges] = [maps, ridges].map(|times| times.map(median));

    writeln!(text, "\n## Other tracks, {SIDE} × {SIDE} points, one thread\n")?;
    writeln!(text, "| track | map, ns a point | times free beam | ridge alone, ns a point |\n|---|---|---|---|")?;
    for (((name, _, side), map), ridge) in tracks.iter().zip(maps).zip(ridges) {
        let points = match *side {
            SIDE => String::new(),
            side => format!(", {side} × {side} points"),
        };
        let ratio = ratio(map / maps[0]);
        writeln!(text, "| {name}{points} | {map:.1} | {ratio} | {ridge:.1} |")?;
    }
    Ok(())
}
