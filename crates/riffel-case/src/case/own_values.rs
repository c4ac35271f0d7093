//! Values that a case gives in place of those of presets and defaults.

use riffel_keys::CaseError;
use toml::{Table, Value};

use crate::Case;
use crate::file::CaseFile;
use crate::file::setting::settings;

/// A key that is written, and whose preset or default is another value.
#[derive(Debug, Clone, PartialEq)]
pub struct OwnValue {
    /// The key, dotted.
    pub key: String,
    /// What it would be if it were not written: a number in SI with its unit, or a name.
    pub without: Value,
}

/// The keys that are written and differ from what presets and defaults would give, in the order of the file. One without which
/// there is no case, or nothing in its place, is left out.
pub fn own_values(case: &Case) -> Vec<OwnValue> {
    let filled = |removed: Option<&str>| -> Result<Table, CaseError> {
        let mut text = case.unfilled.clone();
        removed.iter().for_each(|key| text.keys.remove(key));
        text.fill_in()?;
        let file: CaseFile = text.deserialize()?;
        Table::try_from(file).map_err(|error| case.refuse("", error.to_string()))
    };
    let Ok(own) = filled(None) else {
        return Vec::new();
    };
    let written = settings(case.unfilled.keys.table()).into_iter();
    let differing = written.filter_map(|(key, _)| {
        let without = filled(Some(&key)).ok()?;
        let without = at(&without, &key)?.clone();
        (Some(&without) != at(&own, &key)).then_some(OwnValue { key, without })
    });
    differing.collect()
}

/// The value of a dotted key.
fn at<'a>(table: &'a Table, key: &str) -> Option<&'a Value> {
    match key.split_once('.') {
        Some((first, rest)) => at(table.get(first)?.as_table()?, rest),
        None => table.get(key),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::METRO_CASE;

    fn own(overrides: &[&str]) -> Vec<(String, String)> {
        let overrides: Vec<String> = overrides.iter().map(|key| (*key).to_owned()).collect();
        let case = Case::parse("metro", METRO_CASE, &overrides).unwrap();
        let values = own_values(&case).into_iter();
        let values = values.map(|OwnValue { key, without }| match without {
            Value::String(text) => (key, text),
            other => (key, other.to_string()),
        });
        values.collect()
    }

    /// 60 MN/m is the preset of the slab: written as it is, it is nobody's own. Friction has no default to go back to.
    #[test]
    fn what_differs_from_a_preset_says_what_it_was() {
        let of = |overrides: &[&str], key: &str| {
            own(overrides).into_iter().find(|(own, _)| own == key).map(|(_, without)| without)
        };
        let pads = "track.pad.stiffness";
        assert_eq!(of(&[], pads), None);
        assert_eq!(of(&["track.pad.stiffness=60 kN/mm"], pads), None);
        assert_eq!(of(&["track.pad.stiffness=30 MN/m"], pads).as_deref(), Some("6e7 N/m"));
        assert_eq!(of(&["contact.friction=0.5"], "contact.friction"), None);
    }
}
