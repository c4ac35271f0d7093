//! Presets in the place of keys left out.

use riffel_keys::{CaseError, say};

use crate::text::case_text::{CaseText, REPLACED_BY_WHEELSET};
use crate::text::preset::{Preset, PresetKind, preset, presets};

impl CaseText {
    /// Put the values of the presets that the case names in the place of keys left out: first those of
    /// single parts, then those of the whole track.
    ///
    /// The damping of a layer is one choice: where a viscous damping or a loss factor is given, a
    /// preset adds neither. The inertia of a wheel goes with its mass, and a wheelset takes the place of both. A list is
    /// one value, and an axle of segments has no one length and diameter. A preset of which nothing is left is worth a
    /// remark.
    pub(crate) fn fill_in(&mut self) -> Result<(), CaseError> {
        for kind in PresetKind::ALL {
            let key = kind.key();
            let Some(name) = self.keys.text_of(key) else {
                continue;
            };
            let preset = preset(name)
                .ok()
                .filter(|preset| preset.kind == kind)
                .ok_or_else(|| self.unknown_preset(kind, name))?;
            self.fill_in_one(preset);
        }
        Ok(())
    }

    fn fill_in_one(&mut self, preset: &Preset) {
        let missing: Vec<_> = preset
            .values
            .iter()
            .filter(|value| match value.key.rsplit_once('.') {
                _ if value.list().is_some_and(|list| self.keys.has(list)) => false,
                _ if value.list().is_some() => true,
                Some((layer, "damping" | "loss_factor")) => {
                    !self.keys.has(&format!("{layer}.damping")) && !self.keys.has(&format!("{layer}.loss_factor"))
                }
                _ if REPLACED_BY_WHEELSET.contains(&&*value.key) && self.keys.has("wheelset") => false,
                _ if value.key == "wheel.inertia" => !self.keys.has(&value.key) && !self.keys.has("wheel.mass"),
                Some(("wheelset.axle", "length" | "diameter")) if self.keys.has("wheelset.axle.segments") => false,
                _ => !self.keys.has(&value.key),
            })
            .collect();
        if missing.is_empty() {
            let (key, name) = (preset.kind.key(), &preset.name);
            self.remarks.push(say!(preset_changes_nothing, key = key.to_string(), name = name.to_string()));
        }
        for value in missing {
            self.keys.put(&value.key, value.value.as_str());
            self.filled_in.insert(value.key.clone());
            self.filled_in.extend(value.list().map(str::to_owned));
        }
    }

    fn unknown_preset(&self, kind: PresetKind, name: &str) -> CaseError {
        let known: Vec<String> = presets()
            .iter()
            .filter(|preset| preset.kind == kind)
            .map(|preset| match &preset.aliases[..] {
                [] => preset.name.clone(),
                aliases => format!("{} ({})", preset.name, aliases.join(", ")),
            })
            .collect();
        self.keys.invalid(
            kind.key(),
            say!(is_no_preset, name, kind = kind.in_words()),
            say!(allowed_names, allowed = known.join(", ")),
        )
    }
}
