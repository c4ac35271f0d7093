//! What the rails of a survey are called in their line.

use std::collections::BTreeMap;

use riffel_rail::find_rail;
use sha2::{Digest, Sha256};

use crate::record::SurveyRecord;
use crate::{NetworkError, SurveyFile};

/// The names of the rails of a file in the line.
pub(crate) struct LineRails {
    /// By their order in the file.
    pub(crate) names: Vec<String>,
    /// Names of the file that the line has others for.
    pub(crate) renamed: BTreeMap<String, String>,
    /// Those that no other survey of the line has.
    pub(crate) new: Vec<String>,
}

impl LineRails {
    /// A rail is called as the other surveys of its line call it, in any language.
    ///
    /// # Errors
    /// [`NetworkError::Value`] for two rails of one name.
    pub(crate) fn new(file: &SurveyFile, others: &[&SurveyRecord]) -> Result<Self, NetworkError> {
        let there = file.rails.join(", ");
        let known = || others.iter().flat_map(|survey| survey.rails.iter());
        let mut once: Vec<&str> = known().map(|rail| rail.name.as_str()).collect();
        // Each of them once, or none would be the only one of its kind.
        once.sort_unstable();
        once.dedup();
        let (mut names, mut renamed) = (Vec::new(), file.renamed.clone());
        for own in &file.rails {
            let place = find_rail(once.iter().copied(), own);
            let name = place.map_or_else(|| own.clone(), |place| once[place].to_owned());
            if names.contains(&name) {
                return Err(NetworkError::Value {
                    what: "the rail",
                    value: name,
                    rule: format!("the only one of that name; the file has {there}"),
                });
            }
            if name != *own {
                renamed.insert(own.clone(), name.clone());
            }
            names.push(name);
        }
        let is_new = |name: &&String| !once.is_empty() && !once.contains(&name.as_str());
        Ok(Self { new: names.iter().filter(is_new).cloned().collect(), names, renamed })
    }

    /// The SHA-256 of the file; of it and the names where these are not those of the file.
    pub(crate) fn sha256(&self, file: &SurveyFile) -> String {
        if self.renamed.is_empty() {
            return file.sha256.clone();
        }
        let bytes = Sha256::digest(format!("{}\n{}", file.sha256, self.names.join("\n")));
        bytes.iter().map(|byte| format!("{byte:02x}")).collect()
    }
}
