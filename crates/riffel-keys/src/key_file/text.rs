//! The text of a file of keys, and where its keys and values stand.

use std::collections::HashMap;
use std::ops::Range;

use toml::de::{DeTable, DeValue};

/// What was read; the same however many overrides are applied.
pub(super) struct Text {
    pub(super) name: String,
    pub(super) text: String,
    /// Dotted key → its value in the text.
    values: HashMap<String, Range<usize>>,
    /// Dotted key → the key itself in the text.
    pub(super) keys: HashMap<String, Range<usize>>,
}

impl Text {
    pub(super) fn empty(name: &str) -> Self {
        Self { name: name.to_owned(), text: String::new(), values: HashMap::new(), keys: HashMap::new() }
    }

    pub(super) fn index(&mut self, parent: &str, table: &DeTable<'_>) {
        for (key, value) in table {
            let path = join(parent, key.get_ref());
            self.keys.insert(path.clone(), key.span());
            self.values.insert(path.clone(), value.span());
            match value.get_ref() {
                DeValue::Table(table) => self.index(&path, table),
                DeValue::Array(items) => {
                    for (index, item) in items.iter().enumerate() {
                        let path = format!("{path}[{index}]");
                        self.keys.insert(path.clone(), item.span());
                        if let DeValue::Table(table) = item.get_ref() {
                            self.index(&path, table);
                        }
                    }
                }
                _ => {}
            }
        }
    }

    /// The text of the value of a key.
    pub(super) fn value(&self, key: &str) -> Option<&str> {
        self.text.get(self.values.get(key)?.clone())
    }

    /// The value of the key, the key itself, or the nearest table or list around it.
    pub(super) fn span(&self, key: &str) -> Option<Range<usize>> {
        let mut path = key;
        loop {
            let found = match self.values.get(path) {
                // A table is shown by its header, not by its whole text.
                Some(value) if !self.keys.keys().any(|other| within(other, path)) => Some(value),
                _ => self.keys.get(path),
            };
            if let Some(range) = found {
                return Some(range.clone());
            }
            path = &path[..path.rfind(['.', '['])?];
        }
    }
}

pub(super) fn within(key: &str, table: &str) -> bool {
    key.strip_prefix(table).is_some_and(|rest| rest.starts_with('.'))
}

pub(super) fn join(parent: &str, key: &str) -> String {
    if parent.is_empty() { key.to_owned() } else { format!("{parent}.{key}") }
}
