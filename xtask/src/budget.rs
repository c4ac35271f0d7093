//! Processor time of the whole check: what it may take, and what it took.

use std::fs;
use std::hint::black_box;
use std::iter::successors;
use std::time::Instant;

use crate::Outcome;

/// Processor time of the whole check from a fresh clone \[s\], on the cores that do the [`work`] in that [time](WORK): its steps one by one
/// took 2710 s with the settings of `.ci/run`, and some 400 s go to the benchmarks, to cores that share a cache, and to lines of
/// backtraces and records for the next build without those settings.
const CHECK: f64 = 3100.0;
/// Times that, which is too much.
const TOO_MUCH: f64 = 1.2;
/// Time in which these cores do the [`work`] \[s\].
const WORK: f64 = 0.016;

/// Processor time of all commands that have ended \[s\]; `None` where the system does not tell.
pub(crate) fn taken() -> Option<f64> {
    /// Ticks a second, on all processors of Linux.
    const TICKS: f64 = 100.0;
    let text = fs::read_to_string("/proc/self/stat").ok()?;
    // Behind the name, which may hold anything; then cutime and cstime of proc(5), fields 16 and 17.
    let (_, fields) = text.rsplit_once(')')?;
    let mut fields = fields.split_whitespace().skip(13);
    let mut ticks = || fields.next()?.parse::<f64>().ok();
    Some((ticks()? + ticks()?) / TICKS)
}

/// `Ok` if the check took no more than a fifth above its budget, by the speed of this processor.
pub(crate) fn hold() -> Outcome {
    let Some(taken) = taken() else {
        return Ok(());
    };
    let budget = CHECK * (slowness() / WORK).max(1.0);
    println!("# {taken:.0} s of processor time; the budget is {budget:.0} s");
    match taken > TOO_MUCH * budget {
        true => Err(format!(
            "the check took {taken:.0} s of processor time, more than {TOO_MUCH} times its budget of {budget:.0} s: \
             `cargo xtask test --times` tells what is slow"
        )),
        false => Ok(()),
    }
}

/// Shortest time of a few in which this processor does the [`work`] \[s\].
fn slowness() -> f64 {
    let times = (0..10).map(|_| {
        let begin = Instant::now();
        black_box(work(black_box(1)));
        begin.elapsed().as_secs_f64()
    });
    times.fold(f64::INFINITY, f64::min)
}

/// A sum over random numbers that are sorted, which keeps caches and branches as busy as a compiler does.
fn work(seed: u64) -> u64 {
    let random = |state: &u64| {
        let mixed = state ^ (state << 13);
        let mixed = mixed ^ (mixed >> 7);
        Some(mixed ^ (mixed << 17))
    };
    let mut numbers: Vec<u64> = successors(Some(seed), random).take(500_000).collect();
    numbers.sort_unstable();
    numbers.iter().step_by(7).fold(0, |sum, number| sum ^ number)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::process::Command;

    /// A second of a shell that only counts.
    #[cfg(target_os = "linux")]
    #[test]
    fn ended_commands_are_counted() {
        let before = taken().unwrap();
        let count = "end=$(($(date +%s%N)+300000000)); while [ $(date +%s%N) -lt $end ]; do :; done";
        assert!(Command::new("sh").args(["-c", count]).status().unwrap().success());
        let spent = taken().unwrap() - before;
        assert!(spent > 0.02, "{spent}");
    }
}
