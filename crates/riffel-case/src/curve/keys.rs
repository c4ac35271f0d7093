//! Which keys a case of curving may hold, and what values they may have.

use riffel_keys::{CaseError, KeyFile, Message, say};
use std::sync::LazyLock;

use toml::{Table, Value};

use crate::CaseKey;
use crate::file::CurvingFile;
use crate::file::key::keys_of;

static KEYS: LazyLock<Vec<CaseKey>> = LazyLock::new(|| keys_of(&schemars::schema_for!(CurvingFile).to_value()));

impl CaseKey {
    /// The key of this name, of a case or of what curving takes of one, as `contact.friction.left`.
    pub fn find_with_curving(key: &str) -> Option<&'static Self> {
        Self::find(key).or_else(|| KEYS.iter().find(|known| known.key == key))
    }
}

/// `Ok` if every key is one of curving or of a case.
pub(super) fn refuse_unknown(keys: &KeyFile) -> Result<(), CaseError> {
    refuse_unknown_in(keys, "", keys.table())
}

fn refuse_unknown_in(keys: &KeyFile, parent: &str, table: &Table) -> Result<(), CaseError> {
    for (name, value) in table {
        let key = match parent {
            "" => name.clone(),
            parent => format!("{parent}.{name}"),
        };
        let known = || KEYS.iter().chain(CaseKey::all());
        if known().any(|known| known.key == key) {
            continue;
        }
        let is_table = known().any(|known| known.key.strip_prefix(&key).is_some_and(|rest| rest.starts_with('.')));
        match value {
            Value::Table(inner) if is_table => refuse_unknown_in(keys, &key, inner)?,
            // The reader tells of a value where a table is needed.
            _ if is_table => {}
            _ => {
                let likeness = |known: &&CaseKey| strsim::jaro_winkler(&key, &known.key);
                let nearest = known().max_by(|a, b| likeness(a).total_cmp(&likeness(b)));
                let help = nearest.map_or(String::new(), |near| format!("did you mean {}?", near.key));
                return Err(keys.invalid(&key, say!(is_unknown_key), &help));
            }
        }
    }
    Ok(())
}

/// What is to be asked about values that are not usual.
///
/// # Errors
/// [`CaseError`] for a value outside its physical range.
pub(super) fn judge(keys: &KeyFile) -> Result<Vec<Message>, CaseError> {
    let mut remarks = Vec::new();
    for known in KEYS.iter() {
        match known.key.split_once("[]") {
            None => remarks.extend(keys.judge(&known.key)?),
            Some((list, rest)) => {
                for index in 0..keys.length_of(list) {
                    remarks.extend(keys.judge(&format!("{list}[{index}]{rest}"))?);
                }
            }
        }
    }
    Ok(remarks)
}

#[cfg(test)]
mod tests {
    use super::*;
    use riffel_keys::PhysicalRange;

    #[test]
    fn every_quantity_of_curving_has_a_range() {
        for known in KEYS.iter().filter(|known| known.quantity.is_some()) {
            let range = PhysicalRange::of(&known.key.replace("[]", "[0]"));
            assert_eq!(range.map(|range| range.kind), known.quantity, "{}", known.key);
        }
        assert!(KEYS.iter().any(|known| known.key == "contact.friction.left"));
        assert!(KEYS.iter().any(|known| known.key == "bogie.drive_torque[]"));
    }
}
