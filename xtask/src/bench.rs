//! Benchmarks beside their peers, and a trial of all of them.

use std::path::Path;
use std::process::Command;

use crate::step::{cargo, run, run_beside};
use crate::{Outcome, root};

/// Write `benches/README.md`, or its section on the first build alone.
pub(crate) fn write(build: bool) -> Outcome {
    // The numbers are those of what is handed out; the first build is that of the sources.
    let profile = if build { "release" } else { "dist" };
    let mut bench = cargo(&["run", "--profile", profile, "--package", "riffel-bench"]);
    if build {
        bench.args(["--", "--build"]);
    }
    run(&mut bench)
}

/// Every contestant on tiny sizes, so that none is forgotten between two reports; those whose packages a Python lacks are left out.
pub(crate) fn test(python: &Path) -> Outcome {
    let mut trial = Command::new(root().join("target/debug/riffel-bench"));
    run_beside(trial.arg("--smoke").arg("--python").arg(python))
}
