//! A folder for files in the making, beside the place where they go.

use std::fs::{self, File};
use std::io;
use std::path::Path;

use tempfile::TempDir;

/// What the names of such folders begin with.
const PREFIX: &str = ".riffel-";
/// Held locked as long as the run lives that made the folder: whoever gets the lock may remove it.
const LOCK: &str = "lock";

/// A temporary folder of this run; removed when it is dropped, and after a crash by the next run that writes to the
/// same place.
pub(crate) struct Scratch {
    /// Dropped before the folder, which some systems would not remove with an open file in it.
    lock: File,
    folder: TempDir,
}

impl Scratch {
    /// A new one in a folder, from which those of runs that were killed are removed.
    pub(crate) fn new_in(place: &Path) -> io::Result<Self> {
        remove_leftovers(place);
        let folder = tempfile::Builder::new().prefix(PREFIX).tempdir_in(place)?;
        // Under its name the lock is there only when it is held: another run never sees it free too early.
        let lock = tempfile::NamedTempFile::new_in(folder.path())?;
        // Where the file system has no locks nobody else can take it either, and the folder is left alone.
        let _ = lock.as_file().try_lock();
        let lock = lock.persist(folder.path().join(LOCK))?;
        Ok(Self { lock, folder })
    }

    pub(crate) fn path(&self) -> &Path {
        self.folder.path()
    }

    /// Remove it now.
    pub(crate) fn close(self) {
        drop(self.lock);
        let _ = self.folder.close();
    }
}

/// Remove what killed runs left behind in a folder. A folder whose lock is held, or that has none, is not touched: it
/// belongs to a run that lives, here or on another machine that shares the disk, or to somebody else.
fn remove_leftovers(place: &Path) {
    let Ok(entries) = fs::read_dir(place) else {
        return;
    };
    for entry in entries.flatten() {
        let is_folder = entry.file_type().is_ok_and(|kind| kind.is_dir());
        if !is_folder || !entry.file_name().to_string_lossy().starts_with(PREFIX) {
            continue;
        }
        // Open for writing: some shared disks lock nothing else.
        let lock = File::options().write(true).open(entry.path().join(LOCK));
        if let Ok(lock) = lock
            && lock.try_lock().is_ok()
        {
            let _ = fs::remove_dir_all(entry.path());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn leftovers_go_and_what_is_in_use_stays() {
        let place = tempfile::tempdir().unwrap();
        let in_use = Scratch::new_in(place.path()).unwrap();
        let crashed = place.path().join(".riffel-crashed");
        let foreign = place.path().join(".riffel-notes");
        fs::create_dir(&crashed).unwrap();
        fs::write(crashed.join(LOCK), "").unwrap();
        fs::write(crashed.join("map.csv"), "1,2\n").unwrap();
        fs::create_dir(&foreign).unwrap();
        fs::write(foreign.join("diary.txt"), "mine").unwrap();
        drop(Scratch::new_in(place.path()).unwrap());
        assert!(in_use.path().exists() && foreign.join("diary.txt").exists());
        assert!(!crashed.exists());
    }
}
