//! Who is computing in a folder of results.

use std::fs::{self, File, TryLockError};
use std::path::{Path, PathBuf};

use super::ResultFolder;
use crate::{Shard, StudyError};

/// Locked by who computes: by a whole run for itself, by shards together.
const LOCK: &str = "in-use.lock";

/// The right to compute a shard of a folder, given back when dropped.
#[derive(Debug)]
#[must_use]
pub struct InUse {
    locks: Vec<(PathBuf, File)>,
}

impl ResultFolder {
    /// Take the right to compute a shard: none for a second run of the same shard, or of all beside any other. Where the file
    /// system has no locks nobody is kept out.
    ///
    /// # Errors
    /// [`StudyError::InUse`], [`StudyError::Write`].
    pub fn occupy(&self, shard: Shard) -> Result<InUse, StudyError> {
        let is_whole = shard == Shard::ALL;
        let mut in_use = InUse { locks: Vec::new() };
        in_use.lock(self.path.join(LOCK), !is_whole, &self.path)?;
        if !is_whole {
            let own = format!("in-use-{}-of-{}.lock", shard.index, shard.count);
            in_use.lock(self.path.join(own), false, &self.path)?;
        }
        Ok(in_use)
    }
}

impl InUse {
    fn lock(&mut self, path: PathBuf, shared: bool, folder: &Path) -> Result<(), StudyError> {
        let mut options = File::options();
        let file = options.write(true).create(true).truncate(false);
        let file = file.open(&path).map_err(StudyError::write(&path))?;
        let locked = match shared {
            true => file.try_lock_shared(),
            false => file.try_lock(),
        };
        if let Err(TryLockError::WouldBlock) = locked {
            return Err(StudyError::InUse {
                folder: folder.to_owned(),
            });
        }
        self.locks.push((path, file));
        Ok(())
    }
}

impl Drop for InUse {
    fn drop(&mut self) {
        for (path, file) in self.locks.drain(..) {
            // The file that shards share goes with the last of them.
            let is_last = file.unlock().is_ok() && file.try_lock().is_ok();
            if is_last {
                let _ = fs::remove_file(path);
            }
        }
    }
}
