//! Values that a program or a table gives keys of a case.

use toml::{Table, Value};

/// A key of a case, dotted, and its value: a number in SI, or what stands in a case file.
pub type Setting = (String, Value);

/// The keys of a table, each with its value.
pub fn settings(table: &Table) -> Vec<Setting> {
    fn walk(parent: &str, table: &Table, found: &mut Vec<Setting>) {
        for (key, value) in table {
            let path = match parent {
                "" => key.clone(),
                parent => format!("{parent}.{key}"),
            };
            match value {
                Value::Table(inner) => walk(&path, inner, found),
                value => found.push((path, value.clone())),
            }
        }
    }
    let mut found = Vec::new();
    walk("", table, &mut found);
    found
}
