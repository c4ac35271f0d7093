//! What the first command costs: a release build into an empty folder.

use std::fmt::Write as _;
use std::process::Command;
use std::time::Instant;

use serde_json::Value;

use crate::contestant::{Failure, Peers, machine};
use crate::section::Section;

/// The crates that are shown.
const SHOWN: usize = 12;

/// Build the program anew.
pub(crate) fn report(text: &mut Section, peers: &Peers) -> Result<(), Failure> {
    let root = peers.folder.join("..");
    let fetch = Command::new("cargo").arg("fetch").current_dir(&root).status()?;
    if !fetch.success() {
        return Err("cargo fetch failed".into());
    }
    let target = tempfile::tempdir_in(root.join("target"))?;
    let (begin, before) = (Instant::now(), processor_seconds_of_children());
    let build = Command::new("cargo")
        .args(["build", "--release", "--quiet", "--timings"])
        .env("CARGO_TARGET_DIR", target.path())
        .current_dir(&root)
        .status()?;
    let (wall, after) = (begin.elapsed(), processor_seconds_of_children());
    if !build.success() {
        return Err("cargo build failed".into());
    }
    let page = target.path().join("cargo-timings/cargo-timing.html");
    let units = units(&std::fs::read_to_string(page)?)?;

    let mut crates: Vec<&str> = units.iter().map(|(name, _)| name.as_str()).collect();
    crates.sort_unstable();
    crates.dedup();
    writeln!(
        text,
        "Written by `cargo xtask bench --build`. Machine: {}. `cargo build --release` into an empty folder, sources \
         fetched before.\n",
        machine()
    )?;
    writeln!(text, "| crates, versions apart | wall | processor |\n|---|---|---|")?;
    let seconds = wall.as_secs_f64();
    let processor = match (before, after) {
        (Some(before), Some(after)) => format!("{:.0} s", after - before),
        _ => "not known here".to_owned(),
    };
    writeln!(
        text,
        "| {} | {:.0} min {:02.0} s | {processor} |\n",
        crates.len(),
        (seconds / 60.0).floor(),
        (seconds % 60.0).floor()
    )?;
    let total: f64 = units.iter().map(|(_, seconds)| seconds).sum();
    writeln!(
        text,
        "The crates that take longest, by the time from the start of their compiler to its end, of {total:.0} s:\n"
    )?;
    writeln!(text, "| crate | s |\n|---|---|")?;
    let mut by_crate: Vec<(&str, f64)> = crates
        .iter()
        .map(|&name| {
            let own = units.iter().filter(|(other, _)| other == name);
            (name, own.map(|(_, seconds)| seconds).sum())
        })
        .collect();
    by_crate.sort_by(|a, b| b.1.total_cmp(&a.1));
    for (name, seconds) in by_crate.iter().take(SHOWN) {
        writeln!(text, "| {name} | {seconds:.1} |")?;
    }
    Ok(())
}

/// Name with version, and seconds, of all that the compiler was run for, from cargo's page of timings.
fn units(page: &str) -> Result<Vec<(String, f64)>, Failure> {
    let data = page
        .split_once("const UNIT_DATA = ")
        .and_then(|(_, rest)| rest.split_once("];"))
        .map(|(data, _)| format!("{data}]"))
        .ok_or("cargo's page of timings has no UNIT_DATA")?;
    let units: Vec<Value> = serde_json::from_str(&data)?;
    let unit = |unit: &Value| {
        let name = unit["name"].as_str()?;
        let version = unit["version"].as_str()?;
        Some((format!("{name} {version}"), unit["duration"].as_f64()?))
    };
    units.iter().map(|value| unit(value).ok_or_else(|| format!("cannot read {value}").into())).collect()
}

/// Processor time of all processes that were started and waited for, where Linux tells it.
fn processor_seconds_of_children() -> Option<f64> {
    let stat = std::fs::read_to_string("/proc/self/stat").ok()?;
    // proc(5): fields 16 and 17, in ticks of 1/100 s; the name in field 2 ends with the last parenthesis.
    let (_, fields) = stat.rsplit_once(')')?;
    let mut fields = fields.split_whitespace().skip(13);
    let mut ticks = || fields.next()?.parse::<f64>().ok();
    Some((ticks()? + ticks()?) / 100.0)
}
