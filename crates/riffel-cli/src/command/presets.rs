//! `riffel presets`

use riffel_case::{Preset, preset, presets};

use crate::arguments::Presets;
use crate::messages::language;
use crate::output::{print, print_json, text_table};

pub(crate) fn run(arguments: &Presets) -> miette::Result<()> {
    if arguments.json {
        match &arguments.name {
            None => print_json(&presets().iter().map(Preset::document).collect::<Vec<_>>())?,
            Some(name) => print_json(&preset(name)?.document())?,
        }
        return Ok(());
    }
    let text = match &arguments.name {
        None => {
            let mut table = text_table(&["name", "key", "what it is"]);
            for preset in presets() {
                let title = preset.title.text(language());
                table.add_row([&preset.name, preset.kind.key(), title]);
            }
            format!("{table}\nriffel presets NAME shows the values with their sources\n")
        }
        Some(name) => {
            let preset = preset(name)?;
            let mut table = text_table(&["key", "value", "", "source"]);
            for value in &preset.values {
                let badge = value.badge.words().text(language());
                let source = value.source.text(language());
                table.add_row([&value.key, &value.value, &badge, source]);
            }
            let (title, key, name) = (preset.title.text(language()), preset.kind.key(), &preset.name);
            format!("{title}\n{key} = \"{name}\"\n{table}\n")
        }
    };
    print(&text)?;
    Ok(())
}
