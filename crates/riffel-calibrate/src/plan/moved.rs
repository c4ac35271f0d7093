//! The text of a plan for another folder.

use std::ops::Range;
use std::path::Path;

use toml::de::{DeTable, DeValue};

use super::usual::from;
use super::{Plan, beside};

impl Plan {
    /// Its text as it is to stand in a folder: files that it names relative to its own are named relative to that one. All else
    /// stays, remarks of the writer among it.
    pub(crate) fn text_in(&self, folder: &Path) -> String {
        let own = self.inputs[0].parent().unwrap_or_else(|| Path::new(""));
        let mut text = self.text.clone();
        if from(folder, own).is_empty() {
            return text;
        }
        let Ok(table) = DeTable::parse(&self.text) else {
            return text;
        };
        let mut names = named(table.get_ref());
        names.sort_by_key(|(place, _)| place.start);
        // From the end on, so that places before it stay.
        for (place, name) in names.into_iter().rev() {
            let path = beside(own, &name);
            // Roughness of wheels may be a table of ours.
            if !Path::new(&name).is_absolute() && path.exists() {
                let moved = from(folder, &path);
                text.replace_range(place, &format!("{moved:?}"));
            }
        }
        text
    }
}

/// The files that a plan names, with their places in its text.
fn named(table: &DeTable<'_>) -> Vec<(Range<usize>, String)> {
    let mut found = Vec::new();
    let mut add = |table: &DeTable<'_>, key: &str| {
        if let Some(value) = table.get(key)
            && let DeValue::String(name) = value.get_ref()
        {
            found.push((value.span(), name.to_string()));
        }
    };
    ["case", "traffic"].iter().for_each(|key| add(table, key));
    for (list, key) in [("data", "file"), ("data", "roughness"), ("data", "wheel_roughness"), ("action", "changes")] {
        if let Some(DeValue::Array(items)) = table.get(list).map(|it| it.get_ref()) {
            for item in items {
                if let DeValue::Table(item) = item.get_ref() {
                    add(item, key);
                }
            }
        }
    }
    found
}
