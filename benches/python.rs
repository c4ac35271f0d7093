//! The same map from Rust and from Python.

use std::fmt::Write as _;

use crate::contestant::{Failure, Peers, machine};
use crate::section::Section;
use crate::{median, sizes};

/// What a call from Python costs more.
pub(crate) fn report(text: &mut Section, peers: &Peers) -> Result<(), Failure> {
    let (side, rounds) = (sizes().side, sizes().rounds);
    let interpreter = peers.python_with_riffel()?;
    writeln!(text, "{side} × {side} points, free beam; {rounds} rounds. Machine: {}.\n", machine())?;
    writeln!(text, "| threads | Rust ns a point | Python ns a point | Python costs |\n|---|---|---|---|")?;
    for (threads, name) in [(1, "one"), (2, "two")] {
        let mut rust = peers.riffel(threads)?;
        let mut python = peers.riffel_of_python(&interpreter, "map_riffel.py", threads)?;
        let mut times = [const { Vec::new() }; 3];
        for _ in 0..rounds {
            let (seconds, sum) = rust.time("map free", side)?;
            let (of_python, sum_of_python) = python.time("map free", side)?;
            text.compare("Rust and Python", (sum_of_python, sum), 1e-12);
            let found = [seconds, of_python, of_python / seconds];
            for (times, value) in times.iter_mut().zip(found) {
                times.push(value);
            }
        }
        let [rust, python, ratio] = times.map(median);
        let each = 1e9 / (side * side) as f64;
        writeln!(text, "| {name} | {:.2} | {:.2} | {:+.1} % |", each * rust, each * python, 100.0 * (ratio - 1.0))?;
    }
    writeln!(
        text,
        "\n`GrowthMap::compute` beside `riffel.Case.growth_map()` over the window of its case, from the call \
         to the `xarray.Dataset`, in turn; the last column is the median of the ratios of each turn."
    )?;
    Ok(())
}
