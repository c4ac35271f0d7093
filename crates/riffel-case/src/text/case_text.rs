//! The keys of a case as they were written, overridden and filled in by presets.

use riffel_keys::{CaseError, KeyFile, Message, overridden_key, say};
use std::collections::BTreeSet;

use riffel_keys::quantity::{Kind, Length, Speed};
use toml::{Table, Value};

use crate::CaseKey;
use crate::file::{CaseFile, LEFT_WHEEL, MeasuredWear};
use crate::text::preset::PresetKind;

/// Keys that take the name of a profile.
const PROFILES: [&str; 5] =
    ["profiles.wheel", LEFT_WHEEL, "profiles.rail", "profiles.rail.left", "profiles.rail.right"];

/// Keys of the wheel that a wheelset replaces.
pub(crate) const REPLACED_BY_WHEELSET: [&str; 4] =
    ["wheel.mass", "wheel.inertia", "wheel.rotation", "wheel.normal_direction"];

/// The file of keys of a case, with what its reader should know.
#[derive(Clone)]
pub(crate) struct CaseText {
    pub(crate) keys: KeyFile,
    pub(crate) remarks: Vec<Message>,
    /// Keys whose values are those of presets.
    pub(crate) filled_in: BTreeSet<String>,
}

/// A file of keys of a case, or of some of them, the axes of its map and its measured wear written as tables.
///
/// # Errors
/// Errors of [`KeyFile::parse`].
pub fn case_keys(name: &str, text: &str) -> Result<KeyFile, CaseError> {
    let mut keys = KeyFile::parse(name, text)?;
    spread_axes(&mut keys);
    Ok(keys)
}

impl CaseText {
    /// Read TOML; `name` is shown in errors.
    pub(crate) fn parse(name: &str, text: &str) -> Result<Self, CaseError> {
        let keys = case_keys(name, text)?;
        // In a case `vehicle` is the name of a preset.
        if let Some(Value::Array(_)) = keys.table().get("vehicle") {
            return Err(keys.refuse("vehicle", say!(traffic_file_for_case)));
        }
        Ok(Self::of(keys))
    }

    pub(crate) fn of(keys: KeyFile) -> Self {
        Self { keys, remarks: Vec::new(), filled_in: BTreeSet::new() }
    }

    /// The error of a case that names a file by a key and may not.
    pub(crate) fn names_a_file(&self, key: &str) -> CaseError {
        self.keys.invalid(key, say!(is_a_file_and_this_case), say!(use_it_in_a_case_file))
    }

    /// Apply overrides `key=value` in their order. One of two keys that exclude each other replaces the
    /// other, unless the overrides give both; a wheelset replaces the wheel of a file without one.
    pub(crate) fn apply(&mut self, assignments: &[String]) -> Result<(), CaseError> {
        let mut set = Vec::new();
        let has_wheelset = self.keys.has("wheelset");
        for assignment in assignments {
            let key = overridden_key(assignment);
            let takes_a_name = PresetKind::ALL.iter().any(|kind| kind.key() == key) || PROFILES.contains(&key);
            set.push(self.keys.set(assignment, takes_a_name)?);
            self.spread_axes();
        }
        self.replace_others(has_wheelset, set.iter().map(String::as_str));
        Ok(())
    }

    /// Axes of the map that are written as ranges become tables.
    pub(crate) fn spread_axes(&mut self) {
        spread_axes(&mut self.keys);
    }

    /// Remove what keys that were set replace, in a text that had a wheelset before or not.
    pub(crate) fn replace_others<'a>(&mut self, had_wheelset: bool, set: impl Iterator<Item = &'a str> + Clone) {
        let sets = |key: &str| set.clone().any(|other| is_within(other, key));
        for [one, other] in [["contact.tractive_ratio", "contact.creepage"], ["wear.coefficient", "wear.measured"]] {
            match (sets(one), sets(other)) {
                (true, false) => self.keys.remove(other),
                (false, true) => self.keys.remove(one),
                _ => {}
            }
        }
        if !had_wheelset && sets("wheelset") {
            let replaced = REPLACED_BY_WHEELSET.iter().filter(|key| !sets(key));
            replaced.for_each(|key| self.keys.remove(key));
        }
    }

    /// The keys as types, where some that are left out have a number that stands for what is still to come, as has friction that is
    /// a table of both rails.
    pub(crate) fn deserialize_with(&self, stand_ins: &[&str]) -> Result<CaseFile, CaseError> {
        const ANY: f64 = 1.0;
        let mut text = self.clone();
        for key in stand_ins {
            if !self.keys.has(key) || self.is_table(key) {
                text.keys.put(key, ANY);
            }
        }
        text.deserialize()
    }

    /// True for a key `table.name` that is a table itself.
    pub(crate) fn is_table(&self, key: &str) -> bool {
        let found = key.split_once('.').and_then(|(table, name)| self.keys.table().get(table)?.get(name));
        found.is_some_and(Value::is_table)
    }

    /// The keys as types, with defaults in the place of those left out.
    pub(crate) fn deserialize(&self) -> Result<CaseFile, CaseError> {
        self.keys.deserialize_or(|key| {
            let text = self.keys.text_of(key)?;
            let example = match key {
                "wear.measured" => {
                    let rule = say!(is_no_measured_wear, text);
                    return Some(self.keys.invalid(key, rule, ""));
                }
                "map.wavelength" => "20-80 mm",
                "map.speed" => "60-90 km/h",
                _ => return None,
            };
            let rule =
                format!("is \"{text}\", but must be a range as in \"{example}\", or a table of min, max and points");
            Some(self.keys.invalid(key, &rule, ""))
        })
    }

    /// `Ok` if every value lies in its physical range; what is written and unusual becomes a remark.
    pub(crate) fn judge(&mut self) -> Result<(), CaseError> {
        for key in CaseKey::all() {
            let remark = self.keys.judge(&key.key)?;
            let remark = remark.filter(|_| !self.filled_in.contains(&key.key));
            self.remarks.extend(remark);
        }
        for key in CaseKey::in_lists() {
            let Some((list, rest)) = key.key.split_once("[]") else {
                continue;
            };
            for index in 0..self.keys.length_of(list) {
                let remark = self.keys.judge(&format!("{list}[{index}]{rest}"))?;
                self.remarks.extend(remark);
            }
        }
        Ok(())
    }

    /// True for a key that is written, in the file or in an override, and not filled in by a preset.
    pub(crate) fn is_written(&self, key: &str) -> bool {
        self.keys.has(key) && !self.filled_in.contains(key)
    }
}

/// True for a key and for those of the table that it is.
pub(crate) fn is_within(key: &str, table: &str) -> bool {
    let rest = key.strip_prefix(table);
    rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
}

/// Turn the axes of the map that are written as ranges, `map.speed = "60-90 km/h"`, and the wear measured that is written as a text
/// into tables.
fn spread_axes(keys: &mut KeyFile) {
    for (axis, kind) in [("map.wavelength", Kind::of::<Length>()), ("map.speed", Kind::of::<Speed>())] {
        let ends = keys.text_of(axis).and_then(|text| kind.range_in_words(text));
        if let Some(ends) = ends {
            let ends = ["min", "max"].into_iter().zip(ends);
            let ends = ends.map(|(name, end)| (name.to_owned(), Value::String(end)));
            keys.put(axis, ends.collect::<Table>());
        }
    }
    let wear = keys.text_of("wear.measured").and_then(MeasuredWear::in_words);
    if let Some(wear) = wear {
        let wear = ["depth", "per"].into_iter().zip(wear);
        let wear = wear.map(|(name, value)| (name.to_owned(), Value::String(value)));
        keys.put("wear.measured", wear.collect::<Table>());
    }
}
