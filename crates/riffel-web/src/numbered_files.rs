//! Files in the folder of a page, by numbers: a record of a rail, earlier ones, data of a calibration.

use riffel_keys::say;
use std::fs;
use std::path::Path;
use std::sync::{Mutex, MutexGuard, PoisonError};

use crate::fault::{Fault, file_is_gone};

/// Most files of one folder: a record and the one that takes its place, six earlier ones, six of measurements.
pub(crate) const MOST: usize = 14;

/// The files of one folder by number.
#[derive(Default)]
pub(crate) struct NumberedFiles(Mutex<Numbered>);

#[derive(Default)]
struct Numbered {
    /// The last number that was given.
    last: u32,
    /// Numbers and names of files; a file that is still coming has no name.
    files: Vec<(u32, Option<String>)>,
}

/// The place of a record that is coming, given back unless it is kept.
pub(crate) struct Coming<'a> {
    records: &'a NumberedFiles,
    number: u32,
}

impl Coming<'_> {
    pub(crate) fn number(&self) -> u32 {
        self.number
    }

    /// The file is there under a name; its number.
    pub(crate) fn keep(self, name: String) -> u32 {
        let number = self.number;
        let mut numbered = self.records.numbered();
        for (_, place) in numbered.files.iter_mut().filter(|(own, _)| *own == number) {
            *place = Some(name.clone());
        }
        number
    }
}

impl Drop for Coming<'_> {
    fn drop(&mut self) {
        let mut numbered = self.records.numbered();
        numbered.files.retain(|(number, name)| *number != self.number || name.is_some());
    }
}

impl NumberedFiles {
    fn numbered(&self) -> MutexGuard<'_, Numbered> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// A place for one more.
    pub(crate) fn reserve(&self) -> Result<Coming<'_>, Fault> {
        let mut numbered = self.numbered();
        if numbered.files.len() >= MOST {
            return Err(Fault::bad(say!(there_are_such_files_already_which, most = MOST)));
        }
        numbered.last += 1;
        let number = numbered.last;
        numbered.files.push((number, None));
        Ok(Coming { records: self, number })
    }

    /// The name of the file of a number.
    pub(crate) fn file(&self, number: u32) -> Result<String, Fault> {
        let numbered = self.numbered();
        let mut files = numbered.files.iter();
        files.find_map(|(own, name)| name.clone().filter(|_| *own == number)).ok_or_else(file_is_gone)
    }

    /// Remove a record from its folder; one that is not there is removed already.
    pub(crate) fn remove(&self, folder: &Path, number: u32) {
        let Ok(name) = self.file(number) else { return };
        // What is being read goes with the folder.
        let _ = fs::remove_file(folder.join(name));
        self.numbered().files.retain(|(own, _)| *own != number);
    }
}
