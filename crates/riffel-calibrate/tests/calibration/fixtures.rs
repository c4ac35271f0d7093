//! Plans of the validation, in folders of their own.

use std::fs;
use std::path::{Path, PathBuf};

/// The folder of a set.
pub(crate) fn folder(set: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation/calibration").join(set)
}

/// Copy the files of a set.
pub(crate) fn copy_set(set: &str, to: &Path) {
    for entry in fs::read_dir(folder(set)).unwrap() {
        let path = entry.unwrap().path();
        fs::copy(&path, to.join(path.file_name().unwrap())).unwrap();
    }
}
