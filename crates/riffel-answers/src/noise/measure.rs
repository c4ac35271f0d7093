//! What would make a train quieter: one thing changed, and nothing else.

use riffel::roughness::Spectrum;
use riffel_case::Case;
use riffel_keys::{Message, fixed, say, shown_speed};
use riffel_noise::{Energies, Part};
use serde::Serialize;

use super::sources::Radiation;
use super::train::Train;
use crate::Result;
use crate::pads::with_pads_of;

/// A measure with what it does.
#[derive(Debug, Clone, Serialize)]
pub struct Measure {
    /// What is done.
    pub title: Message,
    /// Of the level now, less what is saved.
    pub total_dba: Option<f64>,
    /// What it saves of the level \[dB(A)\], over the bands that are known before and after; below zero where it is
    /// louder.
    pub saved_db: f64,
    /// Levels after it.
    #[serde(skip)]
    pub levels: Energies,
}

/// Share of the level that the bands known before and after may lack \[dB(A)\].
const LACKING: f64 = 0.5;

/// Damping ratio of a wheel with dampers, a hundred times that of its steel alone: chosen.
const DAMPED: f64 = 0.01;

/// Grinding, speed, pads and dampers, each alone.
pub(super) fn measures(case: &Case, train: &Train, radiation: &Radiation<'_>, now: &Energies) -> Result<Vec<Measure>> {
    let (roughness, speed) = (&train.roughness, train.speed);
    let total = |levels: &Energies| levels.a_weighted(Part::Total).unwrap_or(f64::NEG_INFINITY);
    let mut found = Vec::new();
    let mut add = |title: Message, levels: Energies| {
        let [before, after] = [now.within(&levels), levels.within(now)];
        let level = total(&before);
        if total(now) - level <= LACKING {
            let saved_db = level - total(&after);
            found.push(Measure {
                title,
                total_dba: now.a_weighted(Part::Total).map(|now| now - saved_db),
                saved_db,
                levels,
            });
        }
    };
    let (table, _) = &train.limit;
    let ground = ground_to_limit(train)?;
    add(say!(rail_ground_to, edition = &table.edition), train.levels(radiation, &ground)?);
    for factor in [0.8, 0.5] {
        let title = say!(at_speed, speed = shown_speed(factor * speed, 0));
        let slower = train.radiation(case, train.wheel_modes(), factor * speed)?;
        add(title, train.levels(&slower, roughness)?);
    }
    add(say!(rail_dampers), now.with_track_at(0.5));
    if let Some(modes) = train.wheel_modes() {
        let damped = modes.damped(DAMPED);
        let damped = train.radiation(case, Some(&damped), speed)?;
        let title = say!(wheel_dampers, percent = fixed(1e2 * DAMPED, 0));
        add(title, train.levels(&damped, roughness)?);
    }
    let pad = case.file.track.pad.as_ref().and_then(|pad| pad.stiffness);
    // Measured decay rates are those of the pads that are there.
    if let (Some(stiffness), None) = (pad, &train.radiator.decay_rate) {
        for (factor, title) in [(0.5, say!(softer_pads)), (2.0, say!(stiffer_pads))] {
            let other = with_pads_of(case, factor * stiffness.si())?;
            let other = train.radiation(&other, train.wheel_modes(), speed)?;
            add(title, train.levels(&other, roughness)?);
        }
    }
    Ok(found)
}

/// The rail with no band above the limit; bands without a limit stay.
fn ground_to_limit(train: &Train) -> Result<Spectrum> {
    let (_, limit) = &train.limit;
    Ok(train.roughness.map(|level| {
        let limit = limit.spectrum().level(level.band);
        level.level.min(limit.unwrap_or(f64::INFINITY))
    })?)
}
