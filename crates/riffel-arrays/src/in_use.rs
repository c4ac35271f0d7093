//! Who is writing to a folder.

use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};

use crate::whole_file::place;

/// Times that a lock is tried whose file somebody removes.
const TRIES: usize = 100;

/// The right to write to a folder, given back when it is dropped.
#[derive(Debug)]
#[must_use]
pub struct InUse {
    path: PathBuf,
    file: File,
}

impl InUse {
    /// Take it by a file of the folder, which is made if need be: alone, or together with all who share it. `None` where somebody
    /// else has it; where the file system has no locks nobody is kept out.
    ///
    /// # Errors
    /// Errors of [`place`], and what the system says.
    pub fn take(folder: &Path, name: &str, shared: bool) -> io::Result<Option<Self>> {
        fs::create_dir_all(folder)?;
        let path = place(folder, name)?;
        let mut options = File::options();
        options.write(true).create(true).truncate(false);
        let mut tries = 0;
        loop {
            tries += 1;
            let file = options.open(&path)?;
            let locked = match shared {
                true => file.try_lock_shared(),
                false => file.try_lock(),
            };
            if let Err(TryLockError::WouldBlock) = locked {
                return Ok(None);
            }
            // Whoever had it before may have removed its file between the two steps.
            if is_at(&file, &path) || tries == TRIES {
                return Ok(Some(Self { path, file }));
            }
        }
    }
}

impl Drop for InUse {
    fn drop(&mut self) {
        // The file that several share goes with the last of them, and one that holds something is somebody's.
        let is_last = self.file.unlock().is_ok() && self.file.try_lock().is_ok();
        let is_empty = fs::metadata(&self.path).is_ok_and(|there| there.len() == 0);
        if is_last && is_empty && is_at(&self.file, &self.path) {
            let _ = fs::remove_file(&self.path);
        }
    }
}

/// Whether an open file is that of the path.
#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let number = |there: fs::Metadata| (there.dev(), there.ino());
    let open = file.metadata().map(number).ok();
    open.is_some() && open == fs::symlink_metadata(path).map(number).ok()
}

/// Whether an open file is that of the path: other systems remove no open file.
#[cfg(not(unix))]
fn is_at(_: &File, _: &Path) -> bool {
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Threads that come and go: never two at once inside, which a lock on a removed file would let happen.
    #[test]
    fn one_at_a_time_has_it() {
        use std::sync::atomic::{AtomicUsize, Ordering};
        let folder = tempfile::tempdir().unwrap();
        let [inside, times] = [AtomicUsize::new(0), AtomicUsize::new(0)];
        std::thread::scope(|scope| {
            for _ in 0..4 {
                scope.spawn(|| {
                    for _ in 0..2000 {
                        if let Some(_held) = InUse::take(folder.path(), "lock", false).unwrap() {
                            assert_eq!(inside.fetch_add(1, Ordering::SeqCst), 0);
                            times.fetch_add(1, Ordering::SeqCst);
                            inside.fetch_sub(1, Ordering::SeqCst);
                        }
                    }
                });
            }
        });
        assert!(times.into_inner() > 100);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
        let shared = [true, true].map(|shared| InUse::take(folder.path(), "lock", shared).unwrap());
        assert!(shared.iter().all(Option::is_some));
        assert!(InUse::take(folder.path(), "lock", false).unwrap().is_none());
    }
}
