//! Presets: data files under `presets/`, each value with its source.

use std::fmt;
use std::sync::LazyLock;

use include_dir::{Dir, include_dir};
use riffel_keys::quantity::Kind;
use riffel_keys::{CaseError, Language, Message, Words, clipped, say};
use serde::Deserialize;
use serde_json::json;
use toml::{Table, Value};

use crate::CaseKey;

/// The data files, built into the program.
static FILES: Dir<'static> = include_dir!("$CARGO_MANIFEST_DIR/presets");

/// How well a value is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Badge {
    /// Measured on the thing itself.
    Measured,
    /// Published as representative.
    Typical,
    /// Chosen or inferred by us.
    Assumed,
}

impl Badge {
    /// In a word.
    pub fn words(self) -> Message {
        match self {
            Self::Measured => say!(badge_measured),
            Self::Typical => say!(badge_typical),
            Self::Assumed => say!(badge_assumed),
        }
    }
}

/// In English.
impl fmt::Display for Badge {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.words().fmt(formatter)
    }
}

/// What a preset describes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PresetKind {
    /// A rail section.
    Rail,
    /// All supports of a track.
    Track,
    /// A rail pad.
    Pad,
    /// A sleeper.
    Sleeper,
    /// Ballast.
    Ballast,
    /// A wheelset.
    Wheelset,
    /// A wheel with its load.
    Vehicle,
}

impl PresetKind {
    /// Every kind, those that fill in single parts before those that fill in the whole.
    pub(crate) const ALL: [Self; 7] =
        [Self::Rail, Self::Pad, Self::Sleeper, Self::Ballast, Self::Track, Self::Wheelset, Self::Vehicle];

    /// The key of a case file that takes the name.
    pub fn key(self) -> &'static str {
        match self {
            Self::Rail => "rail.section",
            Self::Track => "track.preset",
            Self::Pad => "track.pad.preset",
            Self::Sleeper => "track.sleeper.preset",
            Self::Ballast => "track.ballast.preset",
            Self::Wheelset => "wheelset.preset",
            Self::Vehicle => "vehicle",
        }
    }

    /// The kind, for a sentence.
    pub(crate) fn in_words(self) -> Message {
        match self {
            Self::Rail => say!(rail_word),
            Self::Track => say!(track_kind),
            Self::Pad => say!(pad_kind),
            Self::Sleeper => say!(sleeper_kind),
            Self::Ballast => say!(ballast_kind),
            Self::Wheelset => say!(wheelset),
            Self::Vehicle => say!(vehicle_kind),
        }
    }

    /// The kind, as a word.
    pub fn name(self) -> &'static str {
        match self {
            Self::Rail => "rail",
            Self::Track => "track",
            Self::Pad => "pad",
            Self::Sleeper => "sleeper",
            Self::Ballast => "ballast",
            Self::Wheelset => "wheelset",
            Self::Vehicle => "vehicle",
        }
    }
}

/// Values for some keys of a case file.
#[derive(Debug, Clone, PartialEq)]
pub struct Preset {
    /// The name used in a case file.
    pub name: String,
    /// Other names.
    pub aliases: Vec<String>,
    /// What it describes.
    pub kind: PresetKind,
    /// What it is.
    pub title: Words,
    /// Its values, in the order of the file.
    pub values: Vec<PresetValue>,
}

/// One value of a preset with its source.
#[derive(Debug, Clone, PartialEq)]
pub struct PresetValue {
    /// The key of a case file it stands for, dotted, as in `rail.area` or `wheelset.discs[0].mass`.
    pub key: String,
    /// The value as written, in engineers' units.
    pub value: String,
    /// How well it is known.
    pub badge: Badge,
    /// Where it comes from; what others have published stays in English.
    pub source: Words,
}

impl PresetValue {
    /// What the key takes; none for a choice.
    fn quantity(&self) -> Option<Kind> {
        CaseKey::at(&self.key)?.quantity
    }

    /// The list that it belongs to, if any.
    pub(crate) fn list(&self) -> Option<&str> {
        Some(self.key.split_once('[')?.0)
    }
}

/// A preset as it stands in its file: after the head, one table for each key, also for those of the items of a list.
#[derive(Deserialize)]
struct PresetFile {
    name: String,
    #[serde(default)]
    aliases: Vec<String>,
    kind: PresetKind,
    title: String,
    #[serde(flatten)]
    tables: Table,
}

/// The table of one key.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PresetFileValue {
    value: String,
    badge: Badge,
    source: String,
}

impl Preset {
    fn read(text: &str) -> Result<Self, toml::de::Error> {
        let written: PresetFile = toml::from_str(text)?;
        let mut values = Vec::new();
        collect(&written.name, "", written.tables, &mut values)?;
        Ok(Self {
            title: Words::new("Preset", &written.name, written.title),
            name: written.name,
            aliases: written.aliases,
            kind: written.kind,
            values,
        })
    }

    /// The preset as one JSON document: each value as written and, where it is a quantity, in SI with its unit.
    pub fn document(&self) -> serde_json::Value {
        let values = self.values.iter().map(|value| {
            let quantity = value.quantity();
            let document = json!({
                "value": value.value,
                "value_si": quantity.and_then(|kind| kind.read(&value.value).ok()),
                "unit_si": quantity.map(|kind| kind.unit),
                "badge": value.badge.to_string(),
                "source": value.source.text(Language::English),
            });
            (value.key.clone(), document)
        });
        json!({
            "kind": self.kind.name(),
            "key": self.kind.key(),
            "name": self.name,
            "aliases": self.aliases,
            "title": self.title.text(Language::English),
            "values": values.collect::<serde_json::Map<_, _>>(),
        })
    }

    /// Name and aliases.
    fn names(&self) -> impl Iterator<Item = &String> {
        std::iter::once(&self.name).chain(&self.aliases)
    }

    fn is_called(&self, name: &str) -> bool {
        self.names().any(|known| known.eq_ignore_ascii_case(name))
    }
}

/// The values of a preset in the tables below a dotted key.
fn collect(preset: &str, parent: &str, table: Table, values: &mut Vec<PresetValue>) -> Result<(), toml::de::Error> {
    for (name, inner) in table {
        let key = if parent.is_empty() { name } else { format!("{parent}.{name}") };
        match inner {
            Value::Table(inner) if !inner.contains_key("source") => {
                collect(preset, &key, inner, values)?;
            }
            Value::Array(items) => {
                for (index, item) in items.into_iter().enumerate() {
                    collect(preset, &format!("{key}[{index}]"), item.try_into()?, values)?;
                }
            }
            other => {
                let written: PresetFileValue = other.try_into()?;
                values.push(PresetValue {
                    source: Words::new("Preset", &format!("{preset}-{key}"), written.source),
                    key,
                    value: written.value,
                    badge: written.badge,
                });
            }
        }
    }
    Ok(())
}

/// All presets, by kind and name.
pub fn presets() -> &'static [Preset] {
    // Read once: a study builds a case for each of its samples.
    static PRESETS: LazyLock<Vec<Preset>> = LazyLock::new(|| {
        let mut presets: Vec<Preset> = FILES
            .dirs()
            .flat_map(|folder| folder.files())
            .filter_map(|file| Preset::read(file.contents_utf8()?).ok())
            .collect();
        presets.sort_by(|a, b| (a.kind, &a.name).cmp(&(b.kind, &b.name)));
        presets
    });
    &PRESETS
}

/// The preset of the given name or alias, upper or lower case.
///
/// # Errors
/// [`CaseError::UnknownPreset`] with the nearest name.
pub fn preset(name: &str) -> Result<&'static Preset, CaseError> {
    let presets = presets();
    if let Some(preset) = presets.iter().find(|preset| preset.is_called(name)) {
        return Ok(preset);
    }
    let likeness = |known: &&String| strsim::jaro_winkler(name, known);
    let nearest = presets.iter().flat_map(Preset::names).max_by(|a, b| likeness(a).total_cmp(&likeness(b)));
    Err(CaseError::UnknownPreset { name: clipped(name).into_owned(), nearest: nearest.cloned().unwrap_or_default() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use riffel_keys::PhysicalRange;

    #[test]
    fn every_file_reads_and_says_where_its_values_come_from() {
        let files = FILES.dirs().flat_map(|folder| folder.files());
        for file in files {
            let preset = Preset::read(file.contents_utf8().unwrap())
                .unwrap_or_else(|error| panic!("{}: {error}", file.path().display()));
            assert!(!preset.values.is_empty());
            for value in &preset.values {
                assert!(value.source.text(Language::English).len() > 20, "{value:?}");
            }
        }
    }

    /// Values that others have published name who did, and stay as they are.
    #[test]
    fn titles_and_sources_of_our_own_are_said_in_every_language() {
        for preset in presets() {
            let own = preset.values.iter();
            let own = own.filter(|value| value.badge == Badge::Assumed);
            let words = own.map(|value| &value.source).chain([&preset.title]);
            for words in words {
                assert!(words.is_in(Language::German), "{}: {words}", preset.name);
            }
        }
    }

    /// Every value reads in SI, so that no preset fails only when it is used.
    #[test]
    fn documents_give_every_quantity_in_si() {
        for preset in presets() {
            let document = preset.document();
            for (key, value) in document["values"].as_object().unwrap() {
                let is_choice = key == "wheelset.model";
                assert_eq!(value["value_si"].is_f64(), !is_choice, "{} {key}: {value}", preset.name);
            }
        }
        let rail = preset("UIC60").unwrap().document();
        assert_eq!(rail["values"]["rail.second_moment"]["unit_si"], "m4");
        // 3038.3 cm4; ten digits to spare for the conversion.
        let si = rail["values"]["rail.second_moment"]["value_si"].as_f64();
        assert!((si.unwrap() / 3.0383e-5 - 1.0).abs() < 1e-6);
    }

    #[test]
    fn names_and_aliases_are_unique() {
        let presets = presets();
        for preset in presets {
            for name in preset.names() {
                let called = presets.iter().filter(|other| other.is_called(name));
                assert_eq!(called.count(), 1, "{name}");
            }
        }
    }

    /// What the presets give is usual, so that a remark never speaks of a value that the user did not write.
    #[test]
    fn presets_are_usual() {
        for Preset { name, values, .. } in presets() {
            for value in values {
                let Some(kind) = value.quantity() else {
                    continue;
                };
                let si = kind.read(&value.value).unwrap();
                let [from, to] = PhysicalRange::of(&value.key).unwrap().usual;
                assert!((from..=to).contains(&si), "{name}: {} = {si}", value.key);
            }
        }
    }
}
