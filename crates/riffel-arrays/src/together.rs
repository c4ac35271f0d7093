//! Files of a folder that appear together.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use tempfile::TempDir;

use crate::whole_file::{PREFIX, place, write};

/// Files in the making in a folder beside their places, where they go when all are whole: a full disk leaves what was there before.
/// Dropped before [`publish`](Self::publish), nothing remains. For one process at a time, which holds the folder
/// [in use](crate::InUse).
#[derive(Debug)]
pub struct Together {
    folder: PathBuf,
    made: TempDir,
}

impl Together {
    /// None yet; what a killed process left is removed.
    ///
    /// # Errors
    /// Errors of [`place`], and what the system says.
    pub fn new_in(folder: &Path) -> io::Result<Self> {
        let name = format!("{PREFIX}results");
        match fs::remove_dir_all(place(folder, &name)?) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
            _ => {}
        }
        let mut builder = tempfile::Builder::new();
        Ok(Self { folder: folder.to_owned(), made: builder.prefix(&name).rand_bytes(0).tempdir_in(folder)? })
    }

    /// Write one of them.
    ///
    /// # Errors
    /// Errors of [`place`], and what the system says.
    pub fn write(&self, name: &str, bytes: &[u8]) -> io::Result<()> {
        place(&self.folder, name)?;
        write(self.made.path(), name, bytes)
    }

    /// Rename all to their places, those of a folder after what is in the folders below it, so that its own document comes last.
    ///
    /// # Errors
    /// What the system says.
    pub fn publish(self) -> io::Result<()> {
        settle(self.made.path(), &self.folder)
    }
}

fn settle(from: &Path, to: &Path) -> io::Result<()> {
    let entries: io::Result<Vec<fs::DirEntry>> = fs::read_dir(from)?.collect();
    let mut entries = entries?;
    entries.sort_by_key(|entry| (entry.path().is_file(), entry.file_name()));
    for entry in entries {
        let place = to.join(entry.file_name());
        match entry.path().is_dir() && place.is_dir() {
            true => settle(&entry.path(), &place)?,
            false => fs::rename(entry.path(), place)?,
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_appear_or_none_and_what_was_there_stays() {
        let there = tempfile::tempdir().unwrap();
        let folder = there.path();
        write(folder, "tree/notes.txt", b"mine").unwrap();
        write(folder, "tree/own/zarr.json", b"old").unwrap();
        let read = |name: &str| fs::read_to_string(folder.join(name)).unwrap_or_default();
        let begun = Together::new_in(folder).unwrap();
        begun.write("tree/own/zarr.json", b"new").unwrap();
        drop(begun);
        assert_eq!(read("tree/own/zarr.json"), "old");
        assert_eq!(fs::read_dir(folder).unwrap().count(), 1);
        // A killed process leaves its folder.
        write(folder, ".riffel-results/tree/half", b"x").unwrap();
        let all = Together::new_in(folder).unwrap();
        for name in ["tree/own/zarr.json", "tree/more/zarr.json", "table.csv"] {
            all.write(name, b"new").unwrap();
        }
        all.publish().unwrap();
        for name in ["tree/own/zarr.json", "tree/more/zarr.json", "table.csv"] {
            assert_eq!(read(name), "new", "{name}");
        }
        assert_eq!(read("tree/notes.txt"), "mine");
        assert_eq!(fs::read_dir(folder).unwrap().count(), 2);
    }
}
