//! Files that came from a page: in a private folder, removed at the end and, after a crash, at the next
//! start.

use riffel_keys::say;
use riffel_keys::text_file::Encoding;
use std::fs::{self, File};
use std::io::{self, Read as _};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use axum::body::Body;
use axum::http::StatusCode;
use http_body_util::BodyExt;
use tempfile::{Builder, TempDir};
use tokio::io::AsyncWriteExt;
use tokio::sync::Semaphore;

use crate::fault::{Fault, disk, file_is_gone};
use crate::numbered_files::NumberedFiles;
use crate::workspace::Workspace;

/// Largest file: a kilometre of rail in steps of a millimetre is some 20 MB of text.
const LARGEST: u64 = 2 << 30;
/// Pages whose files are kept; one more takes the place of that unused for longest.
const MOST_PAGES: usize = 8;
/// Files that may come at a time: slow ones keep nobody out.
const MOST_COMING: usize = 8;
/// Size of all files together, in the largest.
const MOST_ON_DISK: u64 = 4;
/// Bytes by which a file is told to be text.
const HEAD: u64 = 64 << 10;
/// Bytes after which it is looked at anew.
const LOOKED_AT: u64 = 16 << 20;
/// Time for the next piece of a file.
const PIECE_TIME: Duration = Duration::from_secs(30);
/// Bytes a second that must come beyond that time: the page is on this machine, or near.
const SLOWEST: f64 = 1e6;

const PREFIX: &str = "riffel-serve-";
/// Held locked as long as the folder is in use: who gets the lock may remove it.
const LOCK: &str = "in-use";

/// The files of all pages.
#[derive(Clone)]
pub(crate) struct Uploads(Arc<Inner>);

struct Inner {
    /// Dropped before the folder, which some systems would not remove with an open file in it.
    _lock: File,
    folder: TempDir,
    coming: Semaphore,
    pages: Mutex<Vec<(String, Arc<Sent>)>>,
    largest: u64,
}

/// The files that a page has sent, in a folder of their own; removed with the last who uses it.
pub(crate) struct Sent {
    /// The chains that were drawn of its measurements.
    drawn: Mutex<Option<Arc<Drawn>>>,
    folder: TempDir,
    files: NumberedFiles,
}

/// Chains that were drawn: the folder of the question, with its plan.
pub(crate) struct Drawn {
    pub(crate) files: Workspace,
    pub(crate) plan: String,
}

impl Sent {
    /// The chains that were drawn last.
    pub(crate) fn drawn(&self) -> Result<Arc<Drawn>, Fault> {
        let gone = || {
            Fault::refused(StatusCode::GONE, say!(the_calibration_is_no_longer_here), say!(choose_its_data_once_more))
        };
        self.drawn.lock().unwrap_or_else(PoisonError::into_inner).clone().ok_or_else(gone)
    }

    /// Keep chains in the place of those before.
    pub(crate) fn keep(&self, drawn: Drawn) {
        *self.drawn.lock().unwrap_or_else(PoisonError::into_inner) = Some(Arc::new(drawn));
    }

    pub(crate) fn folder(&self) -> &Path {
        self.folder.path()
    }

    /// The file of a number.
    pub(crate) fn file(&self, number: u32) -> Result<PathBuf, Fault> {
        self.files.file(number).map(|name| self.folder().join(name))
    }

    /// Remove the file of a number.
    pub(crate) fn remove(&self, number: u32) {
        self.files.remove(self.folder(), number);
    }
}

impl Uploads {
    /// A new private folder; those that a crash left behind are removed.
    pub(crate) fn new() -> io::Result<Self> {
        Self::within(&std::env::temp_dir(), LARGEST)
    }

    pub(crate) fn within(place: &Path, largest: u64) -> io::Result<Self> {
        remove_the_forsaken(place);
        let folder = private(tempfile::Builder::new().prefix(PREFIX)).tempdir_in(place)?;
        let lock = File::create(folder.path().join(LOCK))?;
        lock.try_lock().map_err(io::Error::from)?;
        Ok(Self(Arc::new(Inner {
            _lock: lock,
            folder,
            coming: Semaphore::new(MOST_COMING),
            pages: Mutex::default(),
            largest,
        })))
    }

    /// The private folder.
    pub(crate) fn place(&self) -> &Path {
        self.0.folder.path()
    }

    /// Write what comes to disk, piece by piece, as one more file of a page; its number and its size in bytes. A picture or a document
    /// is refused.
    pub(crate) async fn receive(
        &self,
        page: &str,
        is_plain_text: bool,
        announced: Option<u64>,
        body: Body,
    ) -> Result<(u32, u64), Fault> {
        let sent = self.begin(page)?;
        let place = sent.files.reserve()?;
        // Nothing of what was sent becomes part of a path.
        let name = format!("{}.{}", place.number(), if is_plain_text { "txt" } else { "csv" });
        let path = sent.folder().join(&name);
        let stored = self.store(&path, announced, body).await.and_then(|bytes| is_text(&path).map(|()| bytes));
        match stored {
            Ok(bytes) => Ok((place.keep(name), bytes)),
            Err(fault) => {
                let _ = fs::remove_file(path);
                Err(fault)
            }
        }
    }

    /// Write what comes to a new file; its size in bytes.
    async fn store(&self, path: &Path, announced: Option<u64>, mut body: Body) -> Result<u64, Fault> {
        let inner = &*self.0;
        let too_large = || {
            Fault::refused(
                StatusCode::PAYLOAD_TOO_LARGE,
                say!(the_file_is_larger_than_mib, size = inner.largest >> 20),
                say!(riffel_roughness_reads_larger_ones),
            )
        };
        if announced.is_some_and(|bytes| bytes > inner.largest) {
            return Err(too_large());
        }
        let Ok(_coming) = inner.coming.try_acquire() else {
            return Err(Fault::busy(say!(other_files_are_just_coming_in)));
        };
        self.check_room(announced.unwrap_or(0))?;
        let mut file = tokio::fs::File::create(path).await.map_err(disk)?;
        let (mut bytes, mut looked_at) = (0, 0);
        let begun = Instant::now();
        loop {
            let piece = tokio::time::timeout(PIECE_TIME, body.frame()).await;
            let piece = piece.map_err(|_| {
                Fault::refused(
                    StatusCode::REQUEST_TIMEOUT,
                    say!(nothing_of_the_file_came_for, seconds = PIECE_TIME.as_secs()),
                    "",
                )
            })?;
            let Some(piece) = piece else { break };
            let piece = piece.map_err(|_| Fault::bad(say!(the_file_broke_off_on_its)))?;
            if let Ok(data) = piece.into_data() {
                bytes += data.len() as u64;
                if bytes > inner.largest {
                    return Err(too_large());
                }
                file.write_all(&data).await.map_err(disk)?;
            }
            if bytes - looked_at > LOOKED_AT {
                looked_at = bytes;
                self.check_room(0)?;
            }
            let late = begun.elapsed().saturating_sub(PIECE_TIME).as_secs_f64();
            if late * SLOWEST > bytes as f64 {
                return Err(Fault::refused(
                    StatusCode::REQUEST_TIMEOUT,
                    say!(the_file_came_more_slowly_than, rate = 1e-3 * SLOWEST),
                    "",
                ));
            }
        }
        file.flush().await.map_err(disk)?;
        Ok(bytes)
    }

    /// `Ok` if so many bytes more have room beside all files that are there.
    fn check_room(&self, more: u64) -> Result<(), Fault> {
        let inner = &*self.0;
        let most = MOST_ON_DISK * inner.largest;
        match size_of(inner.folder.path()) + more > most {
            true => Err(Fault::refused(
                StatusCode::INSUFFICIENT_STORAGE,
                say!(the_files_of_all_pages_have, size = most >> 20),
                say!(close_pages_that_are_not_needed),
            )),
            false => Ok(()),
        }
    }

    /// A folder for work of a moment, which goes with it.
    pub(crate) fn folder(&self) -> Result<TempDir, Fault> {
        tempfile::tempdir_in(self.0.folder.path()).map_err(disk)
    }

    /// The files of a page.
    pub(crate) fn of(&self, page: &str) -> Result<Arc<Sent>, Fault> {
        let mut pages = self.pages();
        let place = pages.iter().position(|(other, _)| other == page).ok_or_else(file_is_gone)?;
        // The one that was used last goes last.
        let own = pages.remove(place);
        let sent = own.1.clone();
        pages.push(own);
        Ok(sent)
    }

    /// The files of a page, none at first.
    fn begin(&self, page: &str) -> Result<Arc<Sent>, Fault> {
        if let Ok(sent) = self.of(page) {
            return Ok(sent);
        }
        let sent = Arc::new(Sent { drawn: Mutex::default(), folder: self.folder()?, files: NumberedFiles::default() });
        let mut pages = self.pages();
        if pages.len() >= MOST_PAGES {
            pages.remove(0);
        }
        pages.push((page.to_owned(), sent.clone()));
        Ok(sent)
    }

    fn pages(&self) -> MutexGuard<'_, Vec<(String, Arc<Sent>)>> {
        self.0.pages.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// `Ok` for a file that begins as text does.
fn is_text(path: &Path) -> Result<(), Fault> {
    let mut head = Vec::new();
    File::open(path).and_then(|file| file.take(HEAD).read_to_end(&mut head)).map_err(disk)?;
    Encoding::of(&head).map(|_| ()).map_err(|binary| Fault::bad(binary.to_string()))
}

/// A folder for its owner alone, whatever others may do where it stands.
#[cfg(unix)]
fn private<'a, 'b, 'c>(folder: &'c mut Builder<'a, 'b>) -> &'c mut Builder<'a, 'b> {
    use std::os::unix::fs::PermissionsExt;
    folder.permissions(fs::Permissions::from_mode(0o700))
}

/// Windows gives a temporary folder to its owner.
#[cfg(not(unix))]
fn private<'a, 'b, 'c>(folder: &'c mut Builder<'a, 'b>) -> &'c mut Builder<'a, 'b> {
    folder
}

/// Bytes of all files below a folder; what cannot be read has none.
fn size_of(folder: &Path) -> u64 {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let sizes = entries.map(|entry| match entry.metadata() {
        Ok(kind) if kind.is_dir() => size_of(&entry.path()),
        Ok(kind) => kind.len(),
        Err(_) => 0,
    });
    sizes.sum()
}

/// Remove folders whose program is gone. What belongs to others, or cannot be removed, stays.
fn remove_the_forsaken(place: &Path) {
    let Ok(entries) = fs::read_dir(place) else {
        return;
    };
    let folders = entries
        .flatten()
        .filter(|entry| entry.file_name().to_string_lossy().starts_with(PREFIX))
        // Of the entry itself, not of what a link points to.
        .filter(|entry| entry.file_type().is_ok_and(|kind| kind.is_dir()))
        .map(|entry| entry.path());
    for folder in folders {
        if is_forsaken(&folder) {
            let _ = fs::remove_dir_all(&folder);
        }
    }
}

/// True if nobody holds the lock of the folder.
fn is_forsaken(folder: &Path) -> bool {
    let lock: PathBuf = folder.join(LOCK);
    File::options().write(true).open(lock).is_ok_and(|lock| lock.try_lock().is_ok())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_of_a_crash_are_removed_and_those_in_use_are_not() {
        let place = tempfile::tempdir().unwrap();
        let running = Uploads::within(place.path(), 1).unwrap();
        let crashed = place.path().join("riffel-serve-crashed");
        fs::create_dir(&crashed).unwrap();
        fs::write(crashed.join(LOCK), "").unwrap();
        fs::write(crashed.join("record.csv"), "1,2\n").unwrap();
        let foreign = place.path().join("riffel-serve-foreign");
        fs::create_dir(&foreign).unwrap();

        let next = Uploads::within(place.path(), 1).unwrap();
        assert!(!crashed.exists());
        assert!(foreign.exists(), "without a lock it is not ours");
        assert!(running.0.folder.path().exists() && next.0.folder.path().exists());
        drop((running, next));
        assert_eq!(fs::read_dir(place.path()).unwrap().count(), 1);
    }

    #[cfg(unix)]
    #[test]
    fn the_folder_is_its_owners_alone() {
        use std::os::unix::fs::PermissionsExt;
        let place = tempfile::tempdir().unwrap();
        let uploads = Uploads::within(place.path(), 1).unwrap();
        let mode = fs::metadata(uploads.place()).unwrap().permissions().mode();
        assert_eq!(mode & 0o777, 0o700);
    }

    #[tokio::test]
    async fn a_file_beyond_the_limit_or_without_text_leaves_nothing_behind() {
        let place = tempfile::tempdir().unwrap();
        let uploads = Uploads::within(place.path(), 1000).unwrap();
        let receive = |bytes: usize, announced| uploads.receive("a", false, announced, Body::from(vec![b'1'; bytes]));
        assert!(receive(1001, None).await.is_err());
        assert!(receive(10, Some(1001)).await.is_err());
        assert!(uploads.receive("a", false, None, Body::from("\x7fELF\0\0\0\0")).await.is_err());
        let inside = || fs::read_dir(uploads.of("a").unwrap().folder()).unwrap().count();
        assert_eq!(inside(), 0);
        // The number of one that failed is not given again.
        assert_eq!(receive(1000, None).await.unwrap(), (4, 1000));
        assert_eq!(inside(), 1);
        assert!(uploads.of("b").is_err());
    }

    #[tokio::test]
    async fn the_files_of_all_pages_have_a_limit() {
        let place = tempfile::tempdir().unwrap();
        let uploads = Uploads::within(place.path(), 1000).unwrap();
        let receive = async |page: u32, bytes: usize| {
            let body = Body::from(vec![b'1'; bytes]);
            uploads.receive(&page.to_string(), false, Some(bytes as u64), body).await
        };
        for page in 0..4 {
            receive(page, 1000).await.unwrap();
        }
        let refused = receive(4, 1).await.err().unwrap();
        assert_eq!(refused.status(), StatusCode::INSUFFICIENT_STORAGE);
        assert!(uploads.of("0").unwrap().file(1).is_ok(), "nobody else's file goes for it");
    }

    #[tokio::test]
    async fn files_go_by_their_numbers_and_pages_by_their_age() {
        let place = tempfile::tempdir().unwrap();
        let uploads = Uploads::within(place.path(), 1000).unwrap();
        let receive = async |page: &str| uploads.receive(page, true, None, Body::from("1,2\n")).await;
        assert_eq!(receive("a").await.unwrap(), (1, 4));
        let sent = uploads.of("a").unwrap();
        assert!(sent.file(1).unwrap().ends_with("1.txt"));
        for _ in 0..2 {
            sent.remove(1);
        }
        assert_eq!(sent.file(1).unwrap_err().status(), StatusCode::GONE);
        for number in 0..crate::numbered_files::MOST as u32 {
            assert_eq!(receive("a").await.unwrap().0, number + 2);
        }
        assert!(receive("a").await.is_err(), "one too many");
        for page in 1..MOST_PAGES {
            receive(&page.to_string()).await.unwrap();
        }
        // Whoever was used last stays.
        assert!(uploads.of("a").is_ok());
        let folder = uploads.of("1").unwrap().folder().to_owned();
        uploads.of("a").unwrap();
        for page in ["b", "c", "d"] {
            receive(page).await.unwrap();
        }
        assert!(uploads.of("a").is_ok());
        for page in 0..MOST_PAGES {
            receive(&format!("other {page}")).await.unwrap();
        }
        assert!(uploads.of("1").is_err() && !folder.exists());
        drop(sent);
        assert!(uploads.of("a").is_err());
    }
}
