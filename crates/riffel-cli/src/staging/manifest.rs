//! `riffel-manifest.json`: which files of a folder Riffel wrote, so that a later run removes those that it no longer
//! writes, and touches no others.

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::Path;

use riffel_answers::fingerprint;
use serde::{Deserialize, Serialize};

use crate::error::CliError;

/// Its name in every folder of results.
pub(super) const NAME: &str = "riffel-manifest.json";

/// Name of a file in the folder → its SHA-256 when it was written.
pub(super) type Files = BTreeMap<String, String>;

/// What the commands have written to one folder.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Manifest {
    riffel_version: String,
    /// Command → the files of its last run. Two commands may share a folder.
    written: BTreeMap<String, Files>,
}

impl Manifest {
    /// That of a folder, without entries if it has none.
    pub(super) fn read(folder: &Path) -> Result<Self, CliError> {
        let path = folder.join(NAME);
        let text = match fs::read_to_string(&path) {
            Ok(text) => text,
            Err(reason) if reason.kind() == io::ErrorKind::NotFound => {
                return Ok(Self { riffel_version: String::new(), written: BTreeMap::new() });
            }
            Err(reason) => return Err(CliError::Manifest { path, reason }),
        };
        serde_json::from_str(&text).map_err(|error| CliError::Manifest { path, reason: error.into() })
    }

    /// True if a command wrote the file.
    pub(super) fn lists(&self, name: &str) -> bool {
        self.written.values().any(|files| files.contains_key(name))
    }

    /// Put the files of a run in place of those of the last run of the same command, and return the files that it no
    /// longer writes.
    pub(super) fn replace(&mut self, command: &str, files: &Files) -> Files {
        env!("CARGO_PKG_VERSION").clone_into(&mut self.riffel_version);
        let mut stale = self.written.remove(command).unwrap_or_default();
        stale.retain(|name, _| !files.contains_key(name));
        for others in self.written.values_mut() {
            others.retain(|name, _| !files.contains_key(name));
        }
        self.written.retain(|_, others| !others.is_empty());
        self.written.insert(command.to_owned(), files.clone());
        stale
    }
}

/// Remove files that are still as they were written. What has been changed since is its owner's and stays.
pub(super) fn remove(folder: &Path, files: &Files) {
    for (name, written) in files {
        let path = folder.join(name);
        // A manifest from elsewhere must not reach out of its folder.
        let inside = Path::new(name).file_name().is_some_and(|last| last == name.as_str());
        let is_file = fs::symlink_metadata(&path).is_ok_and(|there| there.is_file());
        if inside && is_file && fingerprint(&path).is_ok_and(|now| now == *written) {
            let _ = fs::remove_file(path);
        }
    }
}
