//! The readers of `fuzz/targets`: built with counters of coverage, run by libFuzzer.
//!
//! The counters are a pass of LLVM that the stable compiler has, too; sanitizers, which it has not, would find nothing
//! in code without `unsafe`.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use super::{Target, corpus};
use crate::{Outcome, root};

/// What makes the compiler count.
const COUNTERS: &str = "--cfg fuzzing -Cpasses=sancov-module -Cllvm-args=-sanitizer-coverage-level=4 \
    -Cllvm-args=-sanitizer-coverage-inline-8bit-counters -Cllvm-args=-sanitizer-coverage-pc-table";

/// Longest time on one input \[s\] and most memory \[MB\]. Targets hold a reader to one second of processor time
/// themselves; this is for a reader that never ends, on a machine with other work.
const LIMITS: [&str; 2] = ["-timeout=300", "-rss_limit_mb=1024"];
/// Longest input, bytes.
const LONGEST_INPUT: usize = 20_000;

fn folder() -> PathBuf {
    root().join("target/fuzz")
}

/// The processor and system that the compiler builds for. Named, it keeps the counters out of build scripts.
fn host() -> Result<String, String> {
    let told = Command::new("rustc").arg("-vV").output();
    let told = told.map_err(|reason| format!("cannot run rustc: {reason}"))?;
    let told = String::from_utf8_lossy(&told.stdout).into_owned();
    let host = told.lines().find_map(|line| line.strip_prefix("host: "));
    host.map(str::to_owned)
        .ok_or_else(|| "rustc -vV names no host".to_owned())
}

pub(super) fn build(targets: &[Target]) -> Outcome {
    // The versions of the workspace; what only the targets need is added to them.
    fs::copy(root().join("Cargo.lock"), root().join("fuzz/Cargo.lock"))
        .map_err(|reason| format!("cannot write fuzz/Cargo.lock: {reason}"))?;
    let host = host()?;
    let folder = folder();
    let mut cargo = Command::new(env!("CARGO"));
    cargo
        .args(["build", "--release", "--target", &host, "--target-dir"])
        .arg(&folder)
        .env("RUSTFLAGS", COUNTERS)
        .current_dir(root().join("fuzz"));
    for target in targets {
        cargo.args(["--bin", target.name()]);
    }
    println!("# cargo build --release, in fuzz");
    succeeds(&mut cargo, "the build of the fuzz targets")
}

/// Run a target, from the files of the project and what earlier runs found to lead farther.
pub(super) fn run(target: Target, seconds: u64, seed: u64) -> Outcome {
    let name = target.name();
    let corpus = folder().join("corpus").join(name);
    let findings = folder().join("findings").join(name);
    for folder in [&corpus, &findings] {
        fs::create_dir_all(folder)
            .map_err(|reason| format!("cannot make {}: {reason}", folder.display()))?;
    }
    for (index, seed) in corpus::seeds(target)?.iter().enumerate() {
        let path = corpus.join(format!("seed-{index}"));
        fs::write(&path, seed)
            .map_err(|reason| format!("cannot write {}: {reason}", path.display()))?;
    }
    println!("# {name}, {seconds} s");
    let mut fuzzer = Command::new(folder().join(host()?).join("release").join(name));
    fuzzer
        .arg(&corpus)
        .args(LIMITS)
        .arg(format!("-max_total_time={seconds}"))
        .arg(format!("-max_len={LONGEST_INPUT}"))
        .arg(format!("-seed={seed}"))
        .arg(format!("-artifact_prefix={}/", findings.display()))
        .arg("-print_final_stats=1");
    succeeds(
        &mut fuzzer,
        &format!("{name}: its input is in {}; fuzzing", findings.display()),
    )
}

fn succeeds(command: &mut Command, what: &str) -> Outcome {
    match command.status() {
        Ok(status) if status.success() => Ok(()),
        Ok(_) => Err(format!("{what} failed")),
        Err(reason) => Err(format!("{what} cannot be run: {reason}")),
    }
}
