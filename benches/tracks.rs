//! Maps and ridges of other tracks beside those of the free beam.

use std::fmt::Write as _;

use riffel::Loop;
use riffel_case::{BHASKAR_TRACK_CASE, Case, NOMINAL_CASE};

use crate::contestant::{Failure, Peers, machine};
use crate::section::Section;
use crate::{median, ratio, sizes};

/// The tracks of the tasks.
pub(crate) fn feedback(track: &str) -> Result<Loop, Failure> {
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

/// The section of the report.
pub(crate) fn report(text: &mut Section, peers: &Peers) -> Result<(), Failure> {
    let mut riffel = peers.riffel(1)?;
    let (side, moving_load_side, rounds) = (sizes().side, sizes().moving_load_side, sizes().few_rounds);
    let tracks = [
        ("free beam", "free", side),
        ("the same, with the geometry of the wave", "wave-geometry", side),
        ("the same, with flow under a spread of loads beside wear", "flow", side),
        ("moving beam, closed form", "moving", side),
        ("two layers, table good to 1e-9", "two-layer", side),
        ("discrete two-layer supports, Timoshenko rail of loss factor 0.02, at mid-span", "periodic", side),
        ("the same, rail without loss", "periodic-lossless", side),
        ("load moving on two layers", "moving-two-layer", moving_load_side),
    ];
    let mut maps = tracks.map(|_| Vec::new());
    let mut ridges = tracks.map(|_| Vec::new());
    for _ in 0..rounds {
        for (kind, times) in [("map", &mut maps), ("ridge", &mut ridges)] {
            for ((_, track, side), times) in tracks.iter().zip(times) {
                let (seconds, _) = riffel.time(&format!("{kind} {track}"), *side)?;
                times.push(1e9 * seconds / (side * side) as f64);
            }
        }
    }
    let [maps, ridges] = [maps, ridges].map(|times| times.map(median));

    writeln!(text, "{side} × {side} points, one thread; {rounds} rounds. Machine: {}.\n", machine())?;
    writeln!(text, "| track | map, ns a point | times free beam | ridge alone, ns a point |\n|---|---|---|---|")?;
    for (((name, _, own), map), ridge) in tracks.iter().zip(maps).zip(ridges) {
        let points = match *own == side {
            true => String::new(),
            false => format!(", {own} × {own} points"),
        };
        let ratio = ratio(map / maps[0]);
        writeln!(text, "| {name}{points} | {map:.1} | {ratio} | {ridge:.1} |")?;
    }
    Ok(())
}
