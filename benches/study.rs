//! Studies: Monte-Carlo samples of the ridge, as `riffel study` runs them.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use riffel_study::{ResultFolder, Shard, Stop, Study};

use crate::contestant::{Contestant, Failure};
use crate::{check_agreement, median};

/// Samples of the comparison of threads.
const SAMPLES: usize = 100_000;
/// Rounds of the comparison of threads: each takes half a minute on one.
const ROUNDS: usize = 3;
/// Samples of the fit, with their rounds.
const SIZES: [(usize, usize); 5] = [(100, 11), (1000, 11), (10_000, 5), (100_000, 3), (1_000_000, 1)];
/// Samples of the comparison with a cluster, with its rounds.
const CLUSTER: (usize, usize) = (30_000, 5);
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
pub(crate) fn contest(samples: usize) -> Result<(f64, f64), Failure> {
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
pub(crate) fn report(
    text: &mut String,
    folder: &Path,
    one: &mut Contestant,
    two: &mut Contestant,
) -> Result<(), Failure> {
    let (mut singles, mut doubles) = (Vec::new(), Vec::new());
    for _ in 0..ROUNDS {
        let single = one.once("study free", SAMPLES)?;
        let double = two.once("study free", SAMPLES)?;
        if single.1 != double.1 {
            return Err("the study gives other numbers on two threads".into());
        }
        singles.push(single.0);
        doubles.push(double.0);
    }
    let [single, double] = [singles, doubles].map(median);
    writeln!(text, "\n## Study: {SAMPLES} Monte-Carlo samples, ridge over 60 speeds × 241 wavelengths, free beam\n")?;
    writeln!(text, "| threads | s | µs a sample and thread | efficiency |\n|---|---|---|---|")?;
    let each = |seconds: f64, threads: f64| 1e6 * seconds * threads / SAMPLES as f64;
    writeln!(text, "| one | {single:.1} | {:.0} | |", each(single, 1.0))?;
    writeln!(text, "| two | {double:.1} | {:.0} | {:.0} % |\n", each(double, 2.0), 100.0 * single / (2.0 * double))?;

    writeln!(text, "| samples | s on two threads | µs a sample |\n|---|---|---|")?;
    let mut points = Vec::new();
    for (samples, rounds) in SIZES {
        let seconds =
            (0..rounds).map(|_| Ok(two.once("study free", samples)?.0)).collect::<Result<Vec<f64>, Failure>>()?;
        let seconds = median(seconds);
        points.push((samples as f64, seconds));
        writeln!(text, "| {samples} | {seconds:.2} | {:.0} |", 1e6 * seconds / samples as f64)?;
    }
    // From 10⁴ samples on; below that the files weigh more than the samples.
    let (exponent, second) = fit(&points[2..]);
    let nodes = 100.0;
    writeln!(
        text,
        "\nFrom reading the plan to the last file, synchronised. Time grows as the number of samples to the power \
         {exponent:.2} from 10⁴ to 10⁶; below, the files of the chunks weigh. Extrapolated and not measured: {nodes:.0} \
         nodes of {NODE:.0} such threads as shards that share nothing would take {:.2} s for 10⁶ samples and {:.1} min for \
         10⁹, start of the jobs, file system and merging apart. {ROUNDS} rounds on one thread and on two.",
        second * 1e6f64.powf(exponent) * 2.0 / (nodes * NODE),
        second * 1e6f64.powf(exponent) * 1e3 * 2.0 / (nodes * NODE) / 60.0,
    )?;
    cluster(text, folder, two)
}

/// Two workers of Dask beside two threads.
fn cluster(text: &mut String, folder: &Path, two: &mut Contestant) -> Result<(), Failure> {
    let (samples, rounds) = CLUSTER;
    let place = scratch();
    fs::create_dir_all(&place)?;
    fs::write(place.join("nominal.toml"), riffel_case::NOMINAL_CASE)?;
    fs::write(place.join("study.toml"), plan(samples))?;
    let mut dask = Contestant::riffel_of_python(folder, "study_dask.py", 2)?;
    let task = format!("study {}", place.join("study.toml").display());
    let (mut threads, mut workers) = (Vec::new(), Vec::new());
    for _ in 0..rounds {
        let own = two.once("study free", samples)?;
        let there = dask.once(&task, samples)?;
        check_agreement("studies on threads and on workers", (there.1, own.1), 1e-12)?;
        threads.push(own.0);
        workers.push(there.0);
    }
    fs::remove_dir_all(&place)?;
    let [threads, workers] = [threads, workers].map(median);
    writeln!(
        text,
        "\n{samples} samples take {threads:.1} s on two threads and {workers:.1} s on two workers of a local cluster of Dask, \
         processes of one thread beside a scheduler that shares the same two cores: an efficiency of {:.0} %. {rounds} rounds.",
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
