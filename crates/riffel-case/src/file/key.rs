//! The keys of the case file, and what each takes.

use std::sync::LazyLock;

use riffel_keys::quantity::{KINDS, Kind};
use serde_json::{Map, Value};

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
    /// Every key that takes a value, in the order of the schema. A list is one value.
    pub fn all() -> &'static [Self] {
        &KEYS.0
    }

    /// Every key of the items of a list, `[]` after the name of the list.
    pub(crate) fn in_lists() -> &'static [Self] {
        &KEYS.1
    }

    /// The key of this name.
    pub fn find(key: &str) -> Option<&'static Self> {
        Self::all().iter().find(|known| known.key == key)
    }

    /// The key of this name, also of one in the item of a list, `wheelset.discs[0].mass`.
    pub(crate) fn at(key: &str) -> Option<&'static Self> {
        let Some((list, item)) = key.split_once('[') else {
            return Self::find(key);
        };
        let (_, rest) = item.split_once(']')?;
        let in_list = |known: &&Self| known.key.strip_prefix(list) == Some(&format!("[]{rest}"));
        Self::in_lists().iter().find(in_list)
    }

    /// The name of the key most like a text.
    pub fn nearest(text: &str) -> &'static str {
        let likeness = |known: &&Self| strsim::jaro_winkler(text, &known.key);
        Self::all().iter().max_by(|a, b| likeness(a).total_cmp(&likeness(b))).map_or("", |known| &known.key)
    }
}

/// Every key outside lists, and every one inside.
static KEYS: LazyLock<(Vec<CaseKey>, Vec<CaseKey>)> = LazyLock::new(|| {
    let keys = keys_of(&schemars::schema_for!(CaseFile).to_value());
    keys.into_iter().partition(|key| !key.key.contains("[]"))
});

/// The keys of a file of this schema.
pub(crate) fn keys_of(schema: &Value) -> Vec<CaseKey> {
    let mut keys = Vec::new();
    collect("", "", schema, &mut keys);
    keys
}

/// The keys below the schema of a table, which stands at a pointer; those of the items of a list `discs` are called
/// `discs[]`.
fn collect(parent: &str, pointer: &str, root: &Value, keys: &mut Vec<CaseKey>) {
    let Some(properties) = properties(pointer, root) else {
        return;
    };
    for (name, property) in properties {
        let key = match parent {
            "" => name.clone(),
            parent => format!("{parent}.{name}"),
        };
        let own = format!("{pointer}/properties/{name}");
        let choices = choices(property);
        let tables = choices.iter().filter_map(|choice| table(choice, root));
        let tables: Vec<&str> = tables.collect();
        for table in &tables {
            collect(&key, table, root, keys);
        }
        let unit = choices.iter().find_map(|choice| choice["unit"].as_str());
        if !tables.is_empty() && unit.is_none() {
            continue;
        }
        let description = property["description"].as_str().unwrap_or_default();
        let mut push = |key: String, unit: Option<&str>, pointer: String| {
            keys.push(CaseKey {
                key,
                description: description.trim_end_matches('.').to_owned(),
                quantity: unit.and_then(|unit| KINDS.iter().find(|kind| kind.unit == unit).copied()),
                pointer,
            });
        };
        push(key.clone(), unit, own.clone());
        let item = &property["items"];
        if let Some(unit) = item["unit"].as_str() {
            push(format!("{key}[]"), Some(unit), format!("{own}/items"));
        } else if let Some(table) = table(item, root) {
            collect(&format!("{key}[]"), table, root, keys);
        }
    }
}

/// The properties of the schema at a pointer, if it is that of a table.
fn properties<'a>(pointer: &str, root: &'a Value) -> Option<&'a Map<String, Value>> {
    root.pointer(pointer)?["properties"].as_object()
}

/// A schema, or those of which it is any.
fn choices(schema: &Value) -> Vec<&Value> {
    match schema["anyOf"].as_array() {
        Some(any) => any.iter().flat_map(choices).collect(),
        None => vec![schema],
    }
}

/// The pointer of the table that a schema refers to.
fn table<'a>(schema: &'a Value, root: &Value) -> Option<&'a str> {
    let pointer = schema["$ref"].as_str()?.strip_prefix('#')?;
    properties(pointer, root).map(|_| pointer)
}

#[cfg(test)]
mod tests {
    use super::*;
    use riffel_keys::PhysicalRange;

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
        // A number or a table.
        assert_eq!(unit("contact.creepage"), Some(""));
        assert_eq!(unit("contact.creepage.spin"), Some("rad/m"));
        // A list is one value.
        assert_eq!(unit("wheelset.discs"), None);
        assert!(CaseKey::find("wheelset.discs[].mass").is_none());
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
        for key in CaseKey::all().iter().chain(CaseKey::in_lists()) {
            // The range of a list is that of its items.
            let items = format!("{}[]", key.key);
            if CaseKey::in_lists().iter().any(|item| item.key == items) {
                assert_eq!(key.quantity, None);
                continue;
            }
            let name = key.key.replace("[]", "");
            let has = |range: &&PhysicalRange| range.keys.contains(&name.as_str());
            let kinds: Vec<Kind> = PhysicalRange::all().filter(has).map(|range| range.kind).collect();
            assert_eq!(kinds, Vec::from_iter(key.quantity), "{}", key.key);
        }
        let in_lists: Vec<&str> = CaseKey::in_lists().iter().map(|key| &*key.key).collect();
        assert!(in_lists.contains(&"train.wheels[]"), "{in_lists:?}");
        assert!(in_lists.contains(&"wheelset.discs[].mass"));
        assert!(in_lists.contains(&"wheelset.axle.segments[].diameter"));
    }
}
