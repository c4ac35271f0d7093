//! Presets and dependent defaults in the place of keys left out.

use riffel::RigidInertia;

use super::Builder;
use crate::file::{Rail, Sleeper, Track};
use crate::preset::{PresetValues, RailPreset, TrackPreset};
use crate::quantity::Quantity;
use crate::{CaseError, preset};

impl Builder {
    /// Put presets and dependent defaults in the place of keys left out.
    pub(super) fn fill_in(&mut self) -> Result<(), CaseError> {
        if let Some(name) = &self.file.rail.section {
            let Some(PresetValues::Rail(preset)) = named(name) else {
                return Err(self.unknown_preset("rail.section", name, "rail"));
            };
            fill_in_rail(&mut self.file.rail, &preset);
        }
        if let Some(name) = &self.file.track.preset {
            let Some(PresetValues::Track(preset)) = named(name) else {
                return Err(self.unknown_preset("track.preset", name, "track"));
            };
            fill_in_track(&mut self.file.track, &preset);
        }
        let wheel = &mut self.file.wheel;
        wheel.inertia.get_or_insert_with(|| {
            let (mass, radius) = (wheel.mass.si(), wheel.rolling_radius.si());
            Quantity::new(RigidInertia::reduced_inertia(mass, radius))
        });
        Ok(())
    }

    fn unknown_preset(&self, key: &str, name: &str, kind: &str) -> CaseError {
        let known: Vec<String> = preset::presets()
            .into_iter()
            .filter(|preset| preset.values.kind() == kind)
            .map(|preset| preset.name)
            .collect();
        self.source.invalid(
            key,
            &format!("is \"{name}\", but no {kind} preset has that name"),
            &format!("allowed: {}", known.join(", ")),
        )
    }
}

fn named(name: &str) -> Option<PresetValues> {
    preset::preset(name).ok().map(|preset| preset.values)
}

/// Keys that are written stay; the preset gives the others.
fn fill_in_rail(rail: &mut Rail, preset: &RailPreset) {
    rail.mass_per_length
        .get_or_insert(preset.mass_per_length.quantity);
    rail.second_moment
        .get_or_insert(preset.second_moment.quantity);
}

fn fill_in_track(track: &mut Track, preset: &TrackPreset) {
    track
        .support_spacing
        .get_or_insert(preset.support_spacing.quantity);
    let pad = track.pad.get_or_insert_default();
    pad.stiffness.get_or_insert(preset.pad_stiffness.quantity);
    pad.damping.get_or_insert(preset.pad_damping.quantity);
    let ballast = track.ballast.get_or_insert_default();
    ballast
        .stiffness
        .get_or_insert(preset.ballast_stiffness.quantity);
    ballast
        .damping
        .get_or_insert(preset.ballast_damping.quantity);
    track.sleeper.get_or_insert(Sleeper {
        mass: preset.sleeper_mass.quantity,
    });
}
