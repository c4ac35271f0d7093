//! Studies: Monte-Carlo samples of the ridge, as `riffel study` runs them.

use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;
use std::time::Instant;

use riffel_study::{ResultFolder, Shard, Stop, Study};

use crate::contestant::{Contestant, Failure, Peers, machine};
use crate::section::Section;
use crate::{median, sizes};

/// Threads of a node of the extrapolation.
const NODE: f64 = 64.0;

/// Three parameters of the nominal case, its ridge over 60 speeds and 241 wavelengths.
fn plan(samples: usize) -> String {
    format!(
        r#"
case = "nominal.toml"
set.map.speed = {{ min = "5 m/s", max = "60 m/s", points = 60 }}
design = {{ method = "random", samples = {samples} }}
outputs.ridge = true
[[parameter]]
key = "contact.friction"
uniform = {{ min = 0.2, max = 0.5 }}
[[parameter]]
key = "contact.tractive_ratio"
triangular = {{ min = 0.02, mode = 0.1, max = 0.4 }}
[[parameter]]
key = "wheel.mass"
normal = {{ mean = "350 kg", standard_deviation = "40 kg", min = "200 kg", max = "500 kg" }}
"#
    )
}

fn scratch() -> PathBuf {
    let target = concat!(env!("CARGO_MANIFEST_DIR"), "/../target/bench-study");
    PathBuf::from(target).join(std::process::id().to_string())
}

/// Seconds of a study from reading its plan to its last file, and the sum of the highest growth rates.
pub(crate) fn task(samples: usize) -> Result<(f64, f64), Failure> {
    let place = scratch();
    fs::create_dir_all(&place)?;
    fs::write(place.join("nominal.toml"), riffel_case::NOMINAL_CASE)?;
    fs::write(place.join("study.toml"), plan(samples))?;
    let results = place.join("results");

    let begun = Instant::now();
    let study = Study::read(&place.join("study.toml"))?;
    let folder = ResultFolder::begin(&study, &results)?;
    study.run(&folder, &folder.pending(Shard::ALL)?, &|| (), &Stop::default())?;
    let seconds = begun.elapsed().as_secs_f64();

    let sum = folder.output("highest_growth_rate")?.iter().sum();
    fs::remove_dir_all(&place)?;
    Ok((seconds, sum))
}

/// The section of the report.
pub(crate) fn report(text: &mut Section, peers: &Peers) -> Result<(), Failure> {
    let (samples, rounds) = (sizes().study, sizes().fewest_rounds);
    let (mut one, mut two) = (peers.riffel(1)?, peers.riffel(2)?);
    let (mut singles, mut doubles) = (Vec::new(), Vec::new());
    for _ in 0..rounds {
        let single = one.once("study free", samples)?;
        let double = two.once("study free", samples)?;
        text.compare("one thread and two", (double.1, single.1), 0.0);
        singles.push(single.0);
        doubles.push(double.0);
    }
    let [single, double] = [singles, doubles].map(median);
    writeln!(
        text,
        "{samples} Monte-Carlo samples, ridge over 60 speeds × 241 wavelengths, free beam; {rounds} rounds. Machine: {}.\n",
        machine()
    )?;
    writeln!(text, "| threads | s | µs a sample and thread | efficiency |\n|---|---|---|---|")?;
    let each = |seconds: f64, threads: f64| 1e6 * seconds * threads / samples as f64;
    writeln!(text, "| one | {single:.2} | {:.0} | |", each(single, 1.0))?;
    writeln!(text, "| two | {double:.2} | {:.0} | {:.0} % |", each(double, 2.0), 100.0 * single / (2.0 * double))?;
    report_sizes(text, &mut two)?;
    report_cluster(text, peers, &mut two)
}

/// Time by number of samples.
fn report_sizes(text: &mut Section, two: &mut Contestant) -> Result<(), Failure> {
    writeln!(text, "\n| samples | s on two threads | µs a sample |\n|---|---|---|")?;
    let mut points = Vec::new();
    for &(samples, rounds) in sizes().studies {
        let seconds =
            (0..rounds).map(|_| Ok(two.once("study free", samples)?.0)).collect::<Result<Vec<f64>, Failure>>()?;
        let seconds = median(seconds);
        points.push((samples as f64, seconds));
        writeln!(text, "| {samples} | {seconds:.2} | {:.0} |", 1e6 * seconds / samples as f64)?;
    }
    let (exponent, second) = fit(&points);
    let [(fewest, _), .., (most, _)] = points[..] else {
        return Err("a slope needs two sizes".into());
    };
    let nodes = 100.0;
    let shared = |samples: f64| second * samples.powf(exponent) * 2.0 / (nodes * NODE);
    writeln!(
        text,
        "\nFrom reading the plan to the last file, synchronised. Time grows as the number of samples to the power \
         {exponent:.2} from {fewest} to {most}. By that slope, and not measured: {:.0} s for 10⁶ samples on two threads; {nodes:.0} \
         nodes of {NODE:.0} such threads as shards that share nothing would take {:.2} s for 10⁶ samples and {:.1} min for 10⁹, \
         start of the jobs, file system and merging apart.",
        second * 1e6f64.powf(exponent),
        shared(1e6),
        1e3 * shared(1e6) / 60.0,
    )?;
    Ok(())
}

/// Two workers of Dask beside two threads.
fn report_cluster(text: &mut Section, peers: &Peers, two: &mut Contestant) -> Result<(), Failure> {
    let (samples, rounds) = (sizes().study, sizes().fewest_rounds);
    let place = scratch();
    fs::create_dir_all(&place)?;
    fs::write(place.join("nominal.toml"), riffel_case::NOMINAL_CASE)?;
    fs::write(place.join("study.toml"), plan(samples))?;
    let mut dask = peers.riffel_of_python(&peers.python_with_riffel()?, "study_dask.py", 2)?;
    let task = format!("study {}", place.join("study.toml").display());
    let (mut threads, mut workers) = (Vec::new(), Vec::new());
    for _ in 0..rounds {
        let own = two.once("study free", samples)?;
        let there = dask.once(&task, samples)?;
        text.compare("threads and workers of Dask", (there.1, own.1), 1e-12);
        threads.push(own.0);
        workers.push(there.0);
    }
    // It ends with what it has put there.
    drop(dask);
    fs::remove_dir_all(&place)?;
    let [threads, workers] = [threads, workers].map(median);
    writeln!(
        text,
        "\n{samples} samples take {threads:.1} s on two threads and {workers:.1} s on two workers of a local cluster of Dask, \
         processes of one thread beside a scheduler that shares the same two cores: an efficiency of {:.0} %.",
        100.0 * threads / workers
    )?;
    Ok(())
}

/// Exponent and factor of the power law that fits the logarithms best.
fn fit(points: &[(f64, f64)]) -> (f64, f64) {
    let count = points.len() as f64;
    let logarithms = points.iter().map(|(x, y)| (x.ln(), y.ln()));
    let (sum_x, sum_y) = logarithms.clone().fold((0.0, 0.0), |(x, y), (u, v)| (x + u, y + v));
    let (mean_x, mean_y) = (sum_x / count, sum_y / count);
    let (covariance, variance) = logarithms.fold((0.0, 0.0), |(covariance, variance), (u, v)| {
        (covariance + (u - mean_x) * (v - mean_y), variance + (u - mean_x).powi(2))
    });
    let exponent = covariance / variance;
    (exponent, (mean_y - exponent * mean_x).exp())
}
