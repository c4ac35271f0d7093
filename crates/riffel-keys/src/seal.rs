//! Files that a process may read: all of the machine, or those of the folder in which it works.
//!
//! A process that answers a page is sealed: whatever key of a case, a plan or a file of changes names a file, none beside
//! those that the page has sent is opened.

use std::fs::File;
use std::io;
use std::path::{Component, Path};
use std::sync::atomic::{AtomicBool, Ordering};

static SEALED: AtomicBool = AtomicBool::new(false);

/// Read no file outside the present folder until the process ends, and let cases name none.
pub fn seal() {
    SEALED.store(true, Ordering::Relaxed);
}

/// True after [`seal`].
pub fn is_sealed() -> bool {
    SEALED.load(Ordering::Relaxed)
}

/// Open a file to read it.
///
/// # Errors
/// Errors of [`File::open`]; [`io::ErrorKind::PermissionDenied`] in a sealed process for a path that leaves the present
/// folder, whether or not there is such a file.
pub fn open(path: &Path) -> io::Result<File> {
    if is_sealed() && !stays_here(path) {
        let reason = "only files that the page has sent are read";
        return Err(io::Error::new(io::ErrorKind::PermissionDenied, reason));
    }
    File::open(path)
}

/// True for a path that names something of the present folder or below.
fn stays_here(path: &Path) -> bool {
    let here = |part| matches!(part, Component::Normal(_) | Component::CurDir);
    path.components().all(here)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_stay_in_the_folder_or_leave_it() {
        for here in ["record.csv", "./a/b.csv", "a..b", "..a"] {
            assert!(stays_here(Path::new(here)), "{here}");
        }
        for elsewhere in ["/etc/passwd", "..", "../a.csv", "a/../../b", "./../a"] {
            assert!(!stays_here(Path::new(elsewhere)), "{elsewhere}");
        }
    }
}
