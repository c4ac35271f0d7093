//! Where a file may be put: where there is none yet, or in place of a regular file that is no input of the run.

use std::fs::{self, Metadata};
use std::io;
use std::path::{Path, PathBuf};

use riffel_arrays::whole_file::kind;

use crate::error::CliError;
use crate::session::Session;

/// `Ok` if a file may be put at the path.
pub(super) fn check(session: &Session, path: &Path) -> Result<(), CliError> {
    let there = match fs::symlink_metadata(path) {
        Ok(there) => there,
        Err(reason) if reason.kind() == io::ErrorKind::NotFound => return Ok(()),
        Err(reason) => {
            return Err(CliError::Write { path: path.to_owned(), reason });
        }
    };
    if !there.is_file() {
        return Err(CliError::NotAFile { path: path.to_owned(), what: kind(there.file_type()) });
    }
    let is_input = |input: &PathBuf| fs::metadata(input).is_ok_and(|known| is_same(path, &there, input, &known));
    if session.reads(is_input) {
        return Err(CliError::IsAnInput { path: path.to_owned() });
    }
    Ok(())
}

/// `Ok` if the path is a folder, leads to one, or is free for one.
pub(super) fn check_folder(path: &Path) -> Result<(), CliError> {
    match fs::metadata(path) {
        Ok(there) if !there.is_dir() => {
            Err(CliError::NotAFolder { path: path.to_owned(), what: kind(there.file_type()) })
        }
        _ => Ok(()),
    }
}

/// True if two paths are the same file, also under two names.
#[cfg(unix)]
fn is_same(_: &Path, one: &Metadata, _: &Path, other: &Metadata) -> bool {
    use std::os::unix::fs::MetadataExt;
    (one.dev(), one.ino()) == (other.dev(), other.ino())
}

/// True if two paths are the same file, links followed.
#[cfg(not(unix))]
fn is_same(one: &Path, _: &Metadata, other: &Path, _: &Metadata) -> bool {
    match (fs::canonicalize(one), fs::canonicalize(other)) {
        (Ok(one), Ok(other)) => one == other,
        _ => false,
    }
}
