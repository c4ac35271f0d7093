//! The keys of the case file, and what each takes.

use std::sync::LazyLock;

use riffel_keys::quantity::{KINDS, Kind};
use serde_json::Value;

use crate::file::CaseFile;

/// A key of the case file, dotted, and what it takes.
#[derive(Debug, Clone, PartialEq)]
pub struct CaseKey {
    /// The key, as in `contact.friction`.
    pub key: String,
    /// What it is, as in the schema.
    pub description: String,
    /// The quantity it takes; none for a choice, a name or a whole number.
    pub quantity: Option<Kind>,
    /// Where it stands in the schema, as a JSON pointer.
    pub(crate) pointer: String,
}

impl CaseKey {
    /// Every key that takes a value, in the order of the schema.
    pub fn all() -> &'static [Self] {
        static KEYS: LazyLock<Vec<CaseKey>> = LazyLock::new(|| {
            let schema = schemars::schema_for!(CaseFile).to_value();
            let mut keys = Vec::new();
            collect("", "", &schema, &mut keys);
            keys
        });
        &KEYS
    }

    /// The key of this name.
    pub fn find(key: &str) -> Option<&'static Self> {
        Self::all().iter().find(|known| known.key == key)
    }

    /// The name of the key most like a text.
    pub fn nearest(text: &str) -> &'static str {
        let likeness = |known: &&Self| strsim::jaro_winkler(text, &known.key);
        Self::all()
            .iter()
            .max_by(|a, b| likeness(a).total_cmp(&likeness(b)))
            .map_or("", |known| &known.key)
    }
}

/// The keys below the schema of a table, which stands at a pointer.
fn collect(parent: &str, pointer: &str, root: &Value, keys: &mut Vec<CaseKey>) {
    let table = root.pointer(pointer);
    let Some(properties) = table.and_then(|table| table["properties"].as_object()) else {
        return;
    };
    for (name, property) in properties {
        let key = match parent {
            "" => name.clone(),
            parent => format!("{parent}.{name}"),
        };
        let own = format!("{pointer}/properties/{name}");
        if let Some(table) = referred(property)
            && root
                .pointer(table)
                .is_some_and(|table| table["properties"].is_object())
        {
            collect(&key, table, root, keys);
            continue;
        }
        let description = property["description"].as_str().unwrap_or_default();
        let unit = property["unit"].as_str();
        keys.push(CaseKey {
            key,
            description: description.trim_end_matches('.').to_owned(),
            quantity: unit.and_then(|unit| KINDS.iter().find(|kind| kind.unit == unit).copied()),
            pointer: own,
        });
    }
}

/// The pointer of the schema behind a reference, also behind one that may be null or something shorter.
fn referred(schema: &Value) -> Option<&str> {
    let inner = schema["anyOf"].as_array().and_then(|any| any.first());
    inner.unwrap_or(schema)["$ref"].as_str()?.strip_prefix('#')
}

#[cfg(test)]
mod tests {
    use super::*;
    use riffel_keys::{PhysicalRange, RANGES};

    #[test]
    fn keys_know_their_quantities() {
        let unit = |key: &str| CaseKey::find(key).unwrap().quantity.map(|kind| kind.unit);
        assert_eq!(unit("contact.friction"), Some(""));
        assert_eq!(unit("track.pad.stiffness"), Some("N/m"));
        assert_eq!(unit("rail.second_moment"), Some("m4"));
        assert_eq!(unit("contact.polach.friction_decay"), Some("s/m"));
        assert_eq!(unit("map.speed.min"), Some("m/s"));
        assert_eq!(unit("rail.section"), None);
        assert_eq!(unit("contact.grid"), None);
        assert_eq!(unit("track.model"), None);
        assert!(CaseKey::find("contact").is_none());
    }

    /// A unit tells the kind of quantity, and the schema gives one for every quantity.
    #[test]
    fn units_tell_kinds_apart() {
        for (index, kind) in KINDS.iter().enumerate() {
            assert!(KINDS[..index].iter().all(|other| other.unit != kind.unit));
        }
        let quantities = CaseKey::all().iter().filter(|key| key.quantity.is_some());
        assert!(quantities.count() > 30);
    }

    /// No key of the case that takes a quantity is without a range, and none has two.
    #[test]
    fn every_quantity_of_the_case_has_one_range() {
        for key in CaseKey::all() {
            let has = |range: &&PhysicalRange| range.keys.contains(&key.key.as_str());
            let kinds: Vec<Kind> = RANGES.iter().filter(has).map(|range| range.kind).collect();
            assert_eq!(kinds, Vec::from_iter(key.quantity), "{}", key.key);
        }
    }
}
