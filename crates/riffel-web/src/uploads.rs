//! Files that came from a page: in a private folder, removed at the end and, after a crash, at the next
//! start.

use riffel_keys::say;
use riffel_keys::text_file::Encoding;
use std::fs::{self, File};
use std::io::{self, Read as _};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use axum::body::Body;
use axum::http::StatusCode;
use http_body_util::BodyExt;
use tempfile::TempDir;
use tokio::io::AsyncWriteExt;
use tokio::sync::Semaphore;

use crate::fault::{Fault, disk, file_is_gone};
use crate::numbered_files::NumberedFiles;

/// Largest file: a kilometre of rail in steps of a millimetre is some 20 MB of text.
const LARGEST: u64 = 2 << 30;
/// Files that are kept, one of each page; one more, and the oldest goes.
const MOST_FILES: usize = 8;
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
    files: Mutex<Vec<(String, Arc<Upload>)>>,
    largest: u64,
}

/// One file in a folder of its own, with the earlier records of the same rail; removed with the last who uses it.
pub(crate) struct Upload {
    folder: TempDir,
    /// Its name in there, made here.
    pub(crate) name: String,
    pub(crate) bytes: u64,
    pub(crate) earlier: NumberedFiles,
}

impl Upload {
    pub(crate) fn folder(&self) -> &Path {
        self.folder.path()
    }

    /// The file of the page.
    pub(crate) fn file(&self) -> PathBuf {
        self.folder().join(&self.name)
    }
}

/// Name of a file made of what is told of its kind: nothing of what was sent becomes part of a path.
fn file_name(stem: &str, kind: &str) -> String {
    format!("{stem}.{}", if kind == "txt" { "txt" } else { "csv" })
}

impl Uploads {
    /// A new private folder; those that a crash left behind are removed.
    pub(crate) fn new() -> io::Result<Self> {
        Self::within(&std::env::temp_dir(), LARGEST)
    }

    pub(crate) fn within(place: &Path, largest: u64) -> io::Result<Self> {
        remove_the_forsaken(place);
        // For its owner alone.
        let folder = tempfile::Builder::new().prefix(PREFIX).tempdir_in(place)?;
        let lock = File::create(folder.path().join(LOCK))?;
        lock.try_lock().map_err(io::Error::from)?;
        Ok(Self(Arc::new(Inner {
            _lock: lock,
            folder,
            coming: Semaphore::new(MOST_COMING),
            files: Mutex::default(),
            largest,
        })))
    }

    /// The private folder.
    pub(crate) fn place(&self) -> &Path {
        self.0.folder.path()
    }

    /// Write what comes to disk, piece by piece, as the file of a page.
    pub(crate) async fn receive(
        &self,
        page: String,
        kind: &str,
        announced: Option<u64>,
        body: Body,
    ) -> Result<Arc<Upload>, Fault> {
        let folder = self.folder()?;
        let name = file_name("record", kind);
        let path = folder.path().join(&name);
        let bytes = self.store(&path, announced, body).await?;
        // A picture or a document takes no place of a record.
        let mut head = Vec::new();
        let file = File::open(&path).map_err(disk)?;
        file.take(HEAD).read_to_end(&mut head).map_err(disk)?;
        Encoding::of(&head).map_err(|binary| Fault::bad(binary.to_string()))?;
        let upload = Arc::new(Upload { folder, name, bytes, earlier: NumberedFiles::default() });
        let mut files = self.files();
        files.retain(|(other, _)| *other != page);
        if files.len() >= MOST_FILES {
            files.remove(0);
        }
        files.push((page, upload.clone()));
        Ok(upload)
    }

    /// Write what comes to disk as one of the files of a folder; its number and its size in bytes.
    pub(crate) async fn receive_numbered(
        &self,
        folder: &Path,
        files: &NumberedFiles,
        stem: &str,
        kind: &str,
        (announced, body): (Option<u64>, Body),
    ) -> Result<(u32, u64), Fault> {
        let place = files.reserve()?;
        let name = file_name(&format!("{stem}-{}", place.number()), kind);
        let path = folder.join(&name);
        match self.store(&path, announced, body).await {
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

    /// The file of a page.
    pub(crate) fn of(&self, page: &str) -> Result<Arc<Upload>, Fault> {
        self.files().iter().find(|(other, _)| other == page).map(|(_, upload)| upload.clone()).ok_or_else(file_is_gone)
    }

    fn files(&self) -> std::sync::MutexGuard<'_, Vec<(String, Arc<Upload>)>> {
        self.0.files.lock().unwrap_or_else(PoisonError::into_inner)
    }
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

    #[tokio::test]
    async fn a_file_beyond_the_limit_leaves_nothing_behind() {
        let place = tempfile::tempdir().unwrap();
        let uploads = Uploads::within(place.path(), 1000).unwrap();
        let inside = || fs::read_dir(uploads.0.folder.path()).unwrap().count();
        let receive =
            |bytes: usize, announced| uploads.receive("a".to_owned(), "csv", announced, Body::from(vec![b'1'; bytes]));
        assert!(receive(1001, None).await.is_err());
        assert!(receive(10, Some(1001)).await.is_err());
        assert_eq!(inside(), 1, "the lock alone");
        let first = receive(1000, None).await.unwrap();
        assert_eq!((first.bytes, inside()), (1000, 2));
        drop(first);
        let second = receive(7, Some(7)).await.unwrap();
        assert_eq!(inside(), 2, "the newer file took the place of the older");
        assert_eq!(uploads.of("a").unwrap().bytes, second.bytes);
        assert!(uploads.of("b").is_err());
    }

    #[tokio::test]
    async fn the_files_of_all_pages_have_a_limit() {
        let place = tempfile::tempdir().unwrap();
        let uploads = Uploads::within(place.path(), 1000).unwrap();
        let receive = |page: u32, bytes: usize| {
            let body = Body::from(vec![b'1'; bytes]);
            uploads.receive(page.to_string(), "csv", Some(bytes as u64), body)
        };
        for page in 0..4 {
            receive(page, 1000).await.unwrap();
        }
        let refused = receive(4, 1).await.err().unwrap();
        assert_eq!(refused.status(), StatusCode::INSUFFICIENT_STORAGE);
        assert!(uploads.of("0").is_ok(), "nobody else's file goes for it");
    }

    #[tokio::test]
    async fn earlier_records_lie_beside_the_file_and_go_with_it() {
        let place = tempfile::tempdir().unwrap();
        let uploads = Uploads::within(place.path(), 1000).unwrap();
        let earlier = async |bytes: usize| {
            let upload = uploads.of("a")?;
            let files = (upload.folder(), &upload.earlier);
            let body = Body::from(vec![b'1'; bytes]);
            let received = uploads.receive_numbered(files.0, files.1, "earlier", "../../txt", (None, body));
            received.await
        };
        assert!(earlier(1).await.is_err(), "beside no record");
        let body = || Body::from("1,2\n");
        let record = uploads.receive("a".to_owned(), "txt", None, body());
        let record = record.await.unwrap();
        let inside = || fs::read_dir(record.folder()).unwrap().count();
        assert_eq!(earlier(3).await.unwrap(), (1, 3));
        assert!(earlier(1001).await.is_err());
        assert_eq!(inside(), 2, "what was too large is gone");
        // The number of one that failed or was removed is not given again.
        assert_eq!(earlier(4).await.unwrap().0, 3);
        assert_eq!(record.earlier.file(1).unwrap(), "earlier-1.csv");
        record.earlier.remove(record.folder(), 1);
        record.earlier.remove(record.folder(), 1);
        assert!(record.earlier.file(1).is_err() && record.earlier.file(3).is_ok());
        assert_eq!(inside(), 2);
        for _ in 1..crate::numbered_files::MOST {
            earlier(1).await.unwrap();
        }
        assert!(earlier(1).await.is_err(), "one too many");
        // Another record takes the place of all.
        let folder = record.folder().to_owned();
        drop(record);
        let other = uploads.receive("a".to_owned(), "csv", None, body());
        assert!(other.await.unwrap().earlier.file(3).is_err());
        assert!(!folder.exists());
    }
}
