//! The page of the book that lists the presets.

use std::fmt::Write as _;

use riffel_case::{PresetKind, presets};

/// Every preset with its values and their sources.
pub(crate) fn page() -> String {
    let mut text = String::from(
        "# Presets\n\n\
         Written by `cargo xtask generate` from the files under `presets/`. A value is *measured* on the thing itself,\n\
         *typical* (published as representative) or *assumed* (chosen or inferred by us). None is filled in from\n\
         memory: what has no source is left out, and the case must give it. [The case file](case-file.md#presets)\n\
         says how presets and written values go together.\n",
    );
    let mut kind: Option<PresetKind> = None;
    for preset in presets() {
        if kind != Some(preset.kind) {
            let (name, key) = (preset.kind.name(), preset.kind.key());
            // Writing to a string does not fail.
            let _ = write!(text, "\n## For a {name}: `{key}`\n");
            kind = Some(preset.kind);
        }
        let _ = write!(text, "\n### `{}`\n\n{}.", preset.name, preset.title);
        if !preset.aliases.is_empty() {
            let _ = write!(text, " Also called {}.", preset.aliases.join(", "));
        }
        text.push_str("\n\n| key | value | | source |\n|---|---|---|---|\n");
        for value in &preset.values {
            let _ = writeln!(text, "| `{}` | {} | {} | {} |", value.key, value.value, value.badge, value.source);
        }
    }
    text
}
