//! A folder of results: whose it is, and what in it is its own.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use riffel_arrays::{InUse, whole_file};

use crate::error::CalibrationError;
use crate::names::{GROUPS, MODELS, PARTS, SUMMARY, TREE};
use crate::plan::Plan;
use crate::record::Record;

/// Held by who draws.
const LOCK: &str = "in-use.lock";

/// A folder of results.
pub struct Folder<'a> {
    pub(crate) plan: &'a Plan,
    pub(crate) path: PathBuf,
    pub(crate) record: Record,
    /// Whether parts of chains that are there are believed.
    pub(crate) goes_on: bool,
    _in_use: Option<InUse>,
}

impl<'a> Folder<'a> {
    /// The folder for the results of a plan, made if need be and held until it is dropped. With `restart` finished parts of the
    /// chains of this plan are kept, and those of another plan are removed, but no file that was not written here; without, chains are
    /// drawn anew.
    ///
    /// # Errors
    /// [`CalibrationError`] for a folder of something else, of another plan without `restart`, or where another run draws.
    pub fn begin(plan: &'a Plan, path: &Path, restart: bool) -> Result<Self, CalibrationError> {
        let mut record = Record::of(plan)?;
        let write = CalibrationError::write;
        check(path)?;
        let in_use = InUse::take(path, LOCK, false).map_err(write(path))?;
        let in_use = in_use.ok_or_else(|| CalibrationError::InUse { folder: path.to_owned() })?;
        // Somebody may have begun here since.
        check(path)?;
        match Record::read(path) {
            Some(there) if there.is_like(&record) => record.arrays = there.arrays,
            Some(_) if !restart && has_parts(path) => {
                let folder = path.to_owned();
                return Err(CalibrationError::OtherPlan { folder });
            }
            Some(there) => clear(path, &there).map_err(write(path))?,
            None => {}
        }
        whole_file::sweep(path).map_err(write(path))?;
        let folder = Self { plan, path: path.to_owned(), record, goes_on: restart, _in_use: Some(in_use) };
        for name in [PARTS, TREE, MODELS] {
            whole_file::place(path, name).map_err(write(&path.join(name)))?;
        }
        folder.put(Record::NAME, &folder.record.bytes())?;
        Ok(folder)
    }

    /// A folder whose chains are read, not drawn.
    pub(crate) fn to_read(plan: &'a Plan, path: &Path, record: Record) -> Self {
        Self { plan, path: path.to_owned(), record, goes_on: true, _in_use: None }
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    pub(crate) fn put(&self, name: &str, bytes: &[u8]) -> Result<(), CalibrationError> {
        whole_file::write(&self.path, name, bytes).map_err(CalibrationError::write(&self.path.join(name)))
    }
}

/// `Ok` if a folder is new, empty, or of a calibration, if only one that was broken off at once.
fn check(folder: &Path) -> Result<(), CalibrationError> {
    let is_own = |name: &str| name == LOCK || whole_file::is_half_written(name);
    let is_free = names(folder).iter().all(|name| is_own(name));
    match is_free || Record::read(folder).is_some() {
        true => Ok(()),
        false => Err(CalibrationError::NoCalibration { folder: folder.to_owned() }),
    }
}

/// Names in a folder; empty if it is not there.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let names = entries.map(|entry| entry.file_name().to_string_lossy().into_owned());
    names.collect()
}

/// Whether a name is that of a part of a chain, as in `3-0`.
fn is_part(name: &str) -> bool {
    let numbers = name.split_once('-');
    numbers.is_some_and(|(chain, part)| [chain, part].iter().all(|it| it.parse::<u64>().is_ok()))
}

fn has_parts(folder: &Path) -> bool {
    names(&folder.join(PARTS)).iter().any(|name| is_part(name))
}

/// Remove what was drawn for a plan, the document of its arrays first: from then on they are not believed. What was not written here
/// stays, and so do the folders that hold it.
fn clear(folder: &Path, there: &Record) -> io::Result<()> {
    let remove = |name: &str| match fs::remove_file(whole_file::place(folder, name)?) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
        _ => Ok(()),
    };
    let mut emptied = Vec::new();
    remove(&format!("{TREE}/zarr.json"))?;
    remove(SUMMARY)?;
    for array in &there.arrays {
        let chunks = whole_file::place(folder, &format!("{TREE}/{array}/c"))?;
        match fs::remove_dir_all(chunks) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
            _ => remove(&format!("{TREE}/{array}/zarr.json"))?,
        }
        emptied.push(format!("{TREE}/{array}"));
    }
    for group in GROUPS {
        remove(&format!("{TREE}/{group}/zarr.json"))?;
        emptied.push(format!("{TREE}/{group}"));
    }
    for part in names(&folder.join(PARTS)) {
        if is_part(&part) {
            remove(&format!("{PARTS}/{part}"))?;
        }
    }
    for model in names(&folder.join(MODELS)) {
        let name = format!("{MODELS}/{model}");
        let of_model = whole_file::place(folder, &name)?;
        if let Some(there) = Record::read(&of_model) {
            clear(&of_model, &there)?;
            remove(&format!("{name}/{}", Record::NAME))?;
        }
        emptied.push(name);
    }
    emptied.extend([TREE, PARTS, MODELS].map(str::to_owned));
    // Fails, as it should, where somebody has put something there.
    emptied.iter().for_each(|name| drop(fs::remove_dir(folder.join(name))));
    Ok(())
}
