//! Values that a program or a table gives keys of a case.

use toml::{Table, Value};

/// A key of a case, dotted, and its value: a number in SI, or what stands in a case file.
pub type Setting = (String, Value);

/// The keys of a table, each with its value.
pub fn settings(table: &Table) -> Vec<Setting> {
    settings_until(table, |_| false)
}

/// Keys of a table with their values, if some keys have tables as their values.
pub(crate) fn settings_until(table: &Table, is_key: impl Fn(&str) -> bool) -> Vec<Setting> {
    fn walk(parent: &str, table: &Table, is_key: &dyn Fn(&str) -> bool, found: &mut Vec<Setting>) {
        for (key, value) in table {
            let path = match parent {
                "" => key.clone(),
                parent => format!("{parent}.{key}"),
            };
            match value {
                Value::Table(inner) if !is_key(&path) => walk(&path, inner, is_key, found),
                value => found.push((path, value.clone())),
            }
        }
    }
    let mut found = Vec::new();
    walk("", table, &is_key, &mut found);
    found
}
