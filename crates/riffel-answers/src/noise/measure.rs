//! What would make a train quieter: one thing changed, and nothing else.

use riffel::roughness::LevelLimit;
use riffel_case::Case;

use super::{NoiseRequest, Part, PassByLevels, levels_of, levels_with_wheel_dampers};
use crate::AnswerError;
use crate::pads::with_pads_of;

/// A measure with what it does.
#[derive(Debug, Clone, PartialEq)]
pub struct Measure {
    /// What is done.
    pub title: String,
    /// Levels after it.
    pub levels: PassByLevels,
    /// What it saves of the level \[dB(A)\], over the bands that are known before and after; below zero where it is
    /// louder.
    pub saved: f64,
}

/// Share of the level that the bands known before and after may lack \[dB(A)\].
const LACKING: f64 = 0.5;

/// Damping ratio of a wheel with dampers, a hundred times that of its steel alone: chosen.
const DAMPED: f64 = 0.01;

/// Grinding, speed, pads and dampers, each alone.
pub(super) fn measures(
    case: &Case,
    request: &NoiseRequest,
    now: &PassByLevels,
) -> Result<Vec<Measure>, AnswerError> {
    let mut found = Vec::new();
    let mut add = |title: String, levels: PassByLevels| {
        let [before, after] = [now.within(&levels), levels.within(now)];
        let level = before.a_weighted(Part::Total);
        if now.a_weighted(Part::Total) - level <= LACKING {
            found.push(Measure {
                title,
                saved: level - after.a_weighted(Part::Total),
                levels,
            });
        }
    };
    let (table, limit) = &request.limit;
    let ground = ground_to(request, limit)?;
    add(
        format!("rail ground to {}", table.edition),
        levels_of(case, request, &ground, request.speed)?,
    );
    for factor in [0.8, 0.5] {
        let slower = levels_of(case, request, &request.roughness, factor * request.speed)?;
        add(format!("{:.0} km/h", 3.6 * factor * request.speed), slower);
    }
    add(
        "rail dampers that double the decay rate".to_owned(),
        now.with_track_at(0.5),
    );
    if let Some(levels) = levels_with_wheel_dampers(case, request, DAMPED)? {
        add(
            format!("wheel dampers, modes of {:.0} % damping", 1e2 * DAMPED),
            levels,
        );
    }
    let pad = case.file.track.pad.as_ref().and_then(|pad| pad.stiffness);
    // Measured decay rates are those of the pads that are there.
    if let (Some(stiffness), None) = (pad, &request.decay) {
        for (factor, word) in [(0.5, "half"), (2.0, "twice")] {
            let other = with_pads_of(case, factor * stiffness.si())?;
            add(
                format!("pads of {word} the stiffness"),
                levels_of(&other, request, &request.roughness, request.speed)?,
            );
        }
    }
    Ok(found)
}

/// The rail with no band above the limit; bands without a limit stay.
fn ground_to(
    request: &NoiseRequest,
    limit: &LevelLimit,
) -> Result<riffel::roughness::Spectrum, AnswerError> {
    Ok(request.roughness.map(|level| {
        let limit = limit.spectrum().level(level.band);
        level.level.min(limit.unwrap_or(f64::INFINITY))
    })?)
}
