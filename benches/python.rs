//! The same map from Rust and from Python.

use std::fmt::Write as _;
use std::path::Path;

use crate::contestant::{Contestant, Failure};
use crate::{ROUNDS, SIDE, check_agreement, median};

/// What a call from Python costs more.
pub(crate) fn report(text: &mut String, folder: &Path) -> Result<(), Failure> {
    writeln!(text, "\n## Growth map from Python, {SIDE} × {SIDE} points, free beam\n")?;
    writeln!(text, "| threads | Rust ns a point | Python ns a point | Python costs |\n|---|---|---|---|")?;
    for (threads, name) in [(1, "one"), (2, "two")] {
        let mut rust = Contestant::riffel(threads)?;
        let mut python = Contestant::riffel_of_python(folder, "map_riffel.py", threads)?;
        let mut times = [const { Vec::new() }; 3];
        for _ in 0..ROUNDS {
            let (seconds, sum) = rust.time("map free", SIDE)?;
            let (of_python, sum_of_python) = python.time("map free", SIDE)?;
            check_agreement("maps of Rust and Python", (sum_of_python, sum), 1e-12)?;
            let found = [seconds, of_python, of_python / seconds];
            for (times, value) in times.iter_mut().zip(found) {
                times.push(value);
            }
        }
        let [rust, python, ratio] = times.map(median);
        let each = 1e9 / (SIDE * SIDE) as f64;
        writeln!(text, "| {name} | {:.2} | {:.2} | {:+.1} % |", each * rust, each * python, 100.0 * (ratio - 1.0))?;
    }
    writeln!(
        text,
        "\n`GrowthMap::compute` beside `riffel.Case.growth_map()` over the window of its case, from the call \
         to the `xarray.Dataset`, in turn; the last column is the median of the ratios of each turn."
    )?;
    Ok(())
}
