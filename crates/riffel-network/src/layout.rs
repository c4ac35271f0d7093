//! Where the files of a store are, and which of them are its own: no other is written to or removed, and no link is followed.

use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

use jiff::civil::Date;
use riffel_arrays::{InUse, whole_file};
use tempfile::TempDir;

use crate::NetworkError;
use crate::name::{day_of_arrays, line_name, record_name};
use crate::store::Store;

/// The surveys, a folder for each line.
const SURVEYS: &str = "surveys";
/// Held while surveys are added.
const LOCK: &str = "network.lock";
/// An empty file in a folder of half-written arrays: the mark by which it is known.
const HALF_WRITTEN: &str = "half-written";
/// What is in a folder that is there, by name, without links; nothing where there is none.
fn entries(folder: &Path) -> Result<Vec<(String, fs::FileType)>, NetworkError> {
    let mut found = Vec::new();
    if !folder.exists() {
        return Ok(found);
    }
    for entry in fs::read_dir(folder).map_err(NetworkError::read(folder))? {
        let entry = entry.map_err(NetworkError::read(folder))?;
        let kind = entry.file_type().map_err(NetworkError::read(folder))?;
        found.push((entry.file_name().to_string_lossy().into_owned(), kind));
    }
    Ok(found)
}

/// `Ok` where nothing is, or what `is_right` takes for its own.
fn check_own(path: &Path, is_right: impl Fn(&fs::Metadata) -> bool) -> Result<(), NetworkError> {
    match fs::symlink_metadata(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
        Ok(there) if is_right(&there) => Ok(()),
        Err(error) => Err(NetworkError::read(path)(error)),
        Ok(_) => Err(NetworkError::Foreign { path: path.to_owned() }),
    }
}

impl Store {
    /// `Ok` if the folder is new, empty, or has no more than what a first survey leaves that was broken off at once.
    pub(crate) fn check_free(&self) -> Result<(), NetworkError> {
        let is_own = |(name, kind): &(String, fs::FileType)| {
            let path = self.folder.join(name);
            let is_empty = || fs::metadata(path).is_ok_and(|there| there.len() == 0);
            kind.is_file() && (whole_file::is_half_written(name) || name == LOCK && is_empty())
        };
        match entries(&self.folder)?.iter().all(is_own) {
            true => Ok(()),
            false => Err(NetworkError::NotANetwork { folder: self.folder.clone() }),
        }
    }

    /// Hold the store against others that add to it.
    pub(crate) fn lock(&self) -> Result<InUse, NetworkError> {
        check_own(&self.folder.join(LOCK), fs::Metadata::is_file)?;
        let taken = InUse::take(&self.folder, LOCK, false);
        let taken = taken.map_err(NetworkError::write(&self.folder))?;
        taken.ok_or_else(|| NetworkError::Locked { folder: self.folder.clone() })
    }

    /// The folder of a line.
    pub(crate) fn line_folder(&self, line: &str) -> PathBuf {
        self.folder.join(SURVEYS).join(line_name(line))
    }

    /// The folders of all lines.
    pub(crate) fn line_folders(&self) -> Result<Vec<PathBuf>, NetworkError> {
        let folder = self.folder.join(SURVEYS);
        check_own(&folder, fs::Metadata::is_dir)?;
        let lines = entries(&folder)?.into_iter();
        let lines = lines.filter(|(_, kind)| kind.is_dir());
        Ok(lines.map(|(name, _)| folder.join(name)).collect())
    }

    /// The records of surveys in the folder of a line.
    pub(crate) fn record_files(folder: &Path) -> Result<Vec<PathBuf>, NetworkError> {
        let is_record = |(name, kind): &(String, fs::FileType)| {
            let day = name.strip_suffix(".json");
            kind.is_file() && day.is_some_and(|day| day.parse::<Date>().is_ok())
        };
        let files = entries(folder)?.into_iter().filter(is_record);
        Ok(files.map(|(name, _)| folder.join(name)).collect())
    }

    /// Arrays in the folder of a line whose day has none of these records.
    pub(crate) fn arrays_without(folder: &Path, records: &[PathBuf]) -> Result<Vec<PathBuf>, NetworkError> {
        let is_lost = |(name, kind): &(String, fs::FileType)| {
            let day = day_of_arrays(name).filter(|_| kind.is_dir());
            day.is_some_and(|day| !records.contains(&folder.join(record_name(day))))
        };
        let lost = entries(folder)?.into_iter().filter(is_lost);
        Ok(lost.map(|(name, _)| folder.join(name)).collect())
    }

    /// `Ok` if a survey of the line may be written: no link or file stands in the way, and no line that is called the same but
    /// for capitals, whose folder is the same on systems that ignore them.
    pub(crate) fn check_writable(&self, line: &str) -> Result<(), NetworkError> {
        let surveys = self.folder.join(SURVEYS);
        check_own(&surveys, fs::Metadata::is_dir)?;
        let name = line_name(line);
        let there = entries(&surveys)?;
        if !there.iter().any(|(other, _)| *other == name)
            && let Some((other, _)) = (there.iter()).find(|(other, _)| other.eq_ignore_ascii_case(&name))
        {
            return Err(NetworkError::Value {
                what: "the line",
                value: format!("\"{line}\""),
                rule: format!("spelt with the capitals of the folder {other} of the store"),
            });
        }
        check_own(&surveys.join(name), fs::Metadata::is_dir)
    }

    /// A new folder for arrays in the making in that of a line. It is removed when it is dropped, and by the next that adds to
    /// the line where the process is killed before.
    pub(crate) fn half_written(folder: &Path) -> Result<TempDir, NetworkError> {
        let temporary = tempfile::Builder::new()
            .prefix(whole_file::PREFIX)
            .tempdir_in(folder)
            .map_err(NetworkError::write(folder))?;
        let mark = temporary.path().join(HALF_WRITTEN);
        File::create_new(&mark).map_err(NetworkError::write(&mark))?;
        Ok(temporary)
    }

    /// Remove from the folder of a line what was written in part, and arrays of a day that are not those of its record.
    pub(crate) fn sweep(folder: &Path, day: Date, recorded: &str) -> Result<(), NetworkError> {
        for (name, kind) in entries(folder)? {
            let path = folder.join(&name);
            let is_half_written = whole_file::is_half_written(&name);
            let is_replaced = name != recorded && day_of_arrays(&name) == Some(day);
            let removed = if kind.is_dir() && (is_half_written && path.join(HALF_WRITTEN).is_file() || is_replaced) {
                fs::remove_dir_all(&path)
            } else if kind.is_file() && is_half_written {
                fs::remove_file(&path)
            } else {
                Ok(())
            };
            removed.map_err(NetworkError::write(&path))?;
        }
        Ok(())
    }
}
