//! What tells the results of one plan from those of another.

use std::path::Path;

use riffel_keys::CaseError;
use riffel_keys::text_file::{LARGEST_RESPONSES, read_bounded};
use sha2::{Digest, Sha256};

use crate::plan::Plan;

/// SHA-256 over all that the numbers follow from: the keys of the plan but its title and the place of its case,
/// the keys of the case but its title, and the files of data that the case reads. Comments do not count.
pub(crate) fn fingerprint(
    plan: &Plan,
    case_name: &str,
    case_text: &str,
    data: &[(String, Vec<u8>)],
) -> Result<String, CaseError> {
    let mut hash = Sha256::new();
    let mut add = |bytes: &[u8]| {
        // With its length, so that nothing moves from one part to the next unseen.
        hash.update((bytes.len() as u64).to_le_bytes());
        hash.update(bytes);
    };
    let mut keys = plan.table.clone();
    keys.remove("title");
    keys.remove("case");
    add(keys.to_string().as_bytes());
    let mut keys = riffel_case::case_keys(case_name, case_text)?.table().clone();
    keys.remove("title");
    add(keys.to_string().as_bytes());
    for (name, bytes) in data {
        add(name.as_bytes());
        add(bytes);
    }
    Ok(hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect())
}

/// A file of data as the case names it, relative to the folder of the case.
pub(crate) fn read_data(folder: &Path, names: &[String]) -> Result<Vec<(String, Vec<u8>)>, CaseError> {
    names
        .iter()
        .map(|name| {
            let path = folder.join(name);
            let bytes = read_bounded(&path, "file of data", LARGEST_RESPONSES)?;
            Ok((name.clone(), bytes))
        })
        .collect()
}
