//! Riffel beside its peers, in turn in one run; medians and ratios, for the machine is noisy.
//!
//! `cargo xtask bench` prints the report and writes it to `benches/README.md`, each section as it is done. Results that differ more
//! than they may are told in their section, and by the status at the end. Every contestant is a process of its own that keeps what
//! it needs between tasks, as a program in use does.

mod contact;
mod contestant;
mod curving;
mod first_build;
mod general;
mod map;
mod passage;
mod python;
mod readme;
mod receptance;
mod roughness;
mod section;
mod sizes;
mod study;
mod tracks;

use std::io::{BufRead, Write as _};
use std::process::ExitCode;

use contestant::{Absent, Failure, Peers};
use readme::Readme;
use section::Section;
use sizes::Sizes;

/// The argument that makes this program a contestant.
pub(crate) const CONTESTANT: &str = "--contestant";
/// The argument that tries all sections on tiny sizes and writes nothing.
pub(crate) const SMOKE: &str = "--smoke";
/// The argument before the Python that has the packages of the peers.
const PYTHON: &str = "--python";
/// The argument that prints one section alone, by its name, and writes nothing.
const SECTION: &str = "--section";
/// The argument that records the first build alone.
const BUILD: &str = "--build";

/// A section of the report.
struct Part {
    /// How it is asked for.
    name: &'static str,
    title: &'static str,
    report: fn(&mut Section, &Peers) -> Result<(), Failure>,
}

const PARTS: [Part; 12] = [
    Part { name: "map", title: "Growth map", report: map::report },
    Part { name: "python", title: "Growth map from Python", report: python::report },
    Part { name: "receptance", title: "Receptance at mid-span", report: receptance::report },
    Part { name: "tracks", title: "Other tracks", report: tracks::report },
    Part { name: "general", title: "Loop on all axes", report: general::report },
    Part { name: "contact", title: "Rolling contact", report: contact::report },
    Part { name: "passage", title: "A wheel in time", report: passage::report },
    Part { name: "curving", title: "Profiles and curves", report: curving::report },
    Part { name: "roughness", title: "Roughness", report: roughness::report },
    Part { name: "study", title: "Study", report: study::report },
    Part { name: "size", title: "Cost against size", report: map::report_sizes },
    BUILD_PART,
];
const BUILD_PART: Part = Part { name: "build", title: "First build", report: first_build::report };

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().collect();
    let outcome = match has(CONTESTANT) {
        true => contest().map(|()| true),
        false => run(&arguments),
    };
    match outcome {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("riffel-bench: {error}");
            ExitCode::FAILURE
        }
    }
}

fn has(argument: &str) -> bool {
    std::env::args().any(|own| own == argument)
}

/// Whether this is a trial.
pub(crate) fn is_smoke() -> bool {
    has(SMOKE)
}

/// What sections work on, and how often.
pub(crate) fn sizes() -> &'static Sizes {
    if is_smoke() { &sizes::SMOKE } else { &sizes::FULL }
}

/// Write the sections that are asked for; whether all were done and all results agree.
fn run(arguments: &[String]) -> Result<bool, Failure> {
    let value = |name: &str| arguments.iter().skip_while(|argument| *argument != name).nth(1);
    let asked = value(SECTION);
    let chosen = |part: &&Part| match asked {
        Some(name) => part.name == name,
        None => has(BUILD) == (part.name == BUILD_PART.name),
    };
    let parts: Vec<&Part> = PARTS.iter().filter(chosen).collect();
    if parts.is_empty() {
        return Err(format!("sections are {}", PARTS.map(|part| part.name).join(", ")).into());
    }
    let peers = Peers::new(value(PYTHON).map(Into::into));
    let readme = (asked.is_none() && !is_smoke()).then(|| Readme::of(&peers.folder));
    let mut good = true;
    for part in parts {
        let mut section = Section::new(part.title);
        match (part.report)(&mut section, &peers) {
            Ok(()) if is_smoke() => println!("{}: {}", part.name, section.comparisons()),
            Ok(()) => println!("## {}\n\n{section}", part.title),
            Err(absent) if is_smoke() && absent.is::<Absent>() => println!("{} is left out: {absent}", part.name),
            // The others are done all the same.
            Err(error) => {
                eprintln!("{}: {error}", part.name);
                good = false;
                continue;
            }
        }
        good &= section.agrees();
        if let Some(readme) = &readme {
            readme.write(&section, &PARTS.map(|part| part.title))?;
        }
    }
    Ok(good)
}

/// Answer each line "TASK TRACK POINTS" with the seconds it took and a sum of the result.
fn contest() -> Result<(), Failure> {
    for line in std::io::stdin().lock().lines() {
        let line = line?;
        let [task, track, points] = line.split(' ').collect::<Vec<_>>()[..] else {
            return Err("a task has three words".into());
        };
        let points = points.parse()?;
        let (seconds, sum) = match task {
            "receptance" => receptance::task(points)?,
            "contact" => contact::task(track, points)?,
            "curving" => curving::task(track, points)?,
            "general" => general::task(track, points)?,
            "passage" => passage::task(track, points)?,
            "study" => study::task(points)?,
            _ if task.starts_with("roughness") => roughness::task(task, track, points)?,
            _ => map::task(task, track, points)?,
        };
        println!("{seconds} {sum}");
        std::io::stdout().flush()?;
    }
    Ok(())
}

pub(crate) fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// A ratio with the digits that its noise leaves.
pub(crate) fn ratio(value: f64) -> String {
    let decimals = usize::from(value < 100.0);
    format!("{value:.decimals$}")
}
