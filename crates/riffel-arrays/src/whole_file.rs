//! Files that are there whole or not at all, in folders where no link is followed.

use std::fs::{self, FileType};
use std::io::{self, Write};
use std::path::{Component, Path, PathBuf};

use tempfile::NamedTempFile;

/// What the names of half-written files begin with.
pub const PREFIX: &str = ".riffel-";

/// Whether a name is that of a file or folder in the making: the prefix and six letters or digits.
pub fn is_half_written(name: &str) -> bool {
    let rest = name.strip_prefix(PREFIX);
    rest.is_some_and(|rest| rest.len() == 6 && rest.bytes().all(|byte| byte.is_ascii_alphanumeric()))
}

/// The path of a file or folder below a folder of results, whose name has `/` between its parts. The folder itself may be a link:
/// somebody named it.
///
/// # Errors
/// A part that is neither a folder nor a regular file: a link would lead to somebody else's. A name that leads out of the folder.
pub fn place(folder: &Path, name: &str) -> io::Result<PathBuf> {
    let mut path = folder.to_owned();
    for part in Path::new(name).components() {
        path.push(part);
        let refuse = |what: &str| {
            let path = path.display();
            Err(io::Error::other(format!("{path} is {what}; only a regular file is replaced by another")))
        };
        if !matches!(part, Component::Normal(_)) {
            return refuse("outside the folder of results");
        }
        match fs::symlink_metadata(&path) {
            Ok(there) if !there.is_dir() && !there.is_file() => {
                return refuse(kind(there.file_type()));
            }
            _ => {}
        }
    }
    Ok(path)
}

/// What something on a disk is, with its article.
pub fn kind(file: FileType) -> &'static str {
    #[cfg(unix)]
    {
        use std::os::unix::fs::FileTypeExt;
        if file.is_block_device() || file.is_char_device() {
            return "a device";
        }
        if file.is_fifo() {
            return "a pipe";
        }
        if file.is_socket() {
            return "a socket";
        }
    }
    if file.is_dir() {
        "a folder"
    } else if file.is_symlink() {
        "a link"
    } else if file.is_file() {
        "a file"
    } else {
        "no regular file"
    }
}

/// Write a file below a folder of results under another name beside its place, in folders that are made if need be, and rename it.
///
/// # Errors
/// Errors of [`place`], and what the system says.
pub fn write(folder: &Path, name: &str, bytes: &[u8]) -> io::Result<()> {
    let path = place(folder, name)?;
    let persisted = half_written(&path, bytes)?.persist(path);
    persisted.map(drop).map_err(|error| error.error)
}

/// [`write()`], but only where nothing is yet.
///
/// # Errors
/// [`io::ErrorKind::AlreadyExists`], also where two processes write it at once; those of [`write()`].
pub fn write_new(folder: &Path, name: &str, bytes: &[u8]) -> io::Result<()> {
    let path = place(folder, name)?;
    let persisted = half_written(&path, bytes)?.persist_noclobber(path);
    persisted.map(drop).map_err(|error| error.error)
}

fn half_written(path: &Path, bytes: &[u8]) -> io::Result<NamedTempFile> {
    let folder = path.parent().unwrap_or_else(|| Path::new("."));
    let mut builder = tempfile::Builder::new();
    builder.prefix(PREFIX);
    // A temporary file is for its owner alone; this one becomes a file like any other.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let mut file = match builder.tempfile_in(folder) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            fs::create_dir_all(folder)?;
            builder.tempfile_in(folder)?
        }
        file => file?,
    };
    file.write_all(bytes)?;
    file.as_file().sync_data()?;
    Ok(file)
}

/// Rename a whole file to its place below a folder of results.
///
/// # Errors
/// Errors of [`place`], and what the system says.
pub fn put(file: &Path, folder: &Path, name: &str) -> io::Result<()> {
    fs::rename(file, place(folder, name)?)
}

/// Have the names in a folder written to the disk, where the system does so.
///
/// # Errors
/// What the system says.
pub fn synchronise(folder: &Path) -> io::Result<()> {
    if cfg!(not(unix)) {
        return Ok(());
    }
    fs::File::open(folder)?.sync_all()
}

/// Remove half-written files below a folder.
///
/// # Errors
/// What the system says.
pub fn sweep(folder: &Path) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let path = entry.path();
        if entry.file_type()?.is_dir() {
            sweep(&path)?;
        } else if is_half_written(&entry.file_name().to_string_lossy()) {
            fs::remove_file(&path)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(unix)]
    #[test]
    fn nothing_is_written_through_a_link_or_out_of_the_folder() {
        let there = tempfile::tempdir().unwrap();
        let [victim, results] = ["victim", "results"].map(|name| there.path().join(name));
        fs::create_dir_all(&victim).unwrap();
        fs::create_dir_all(&results).unwrap();
        fs::write(victim.join("a"), "precious").unwrap();
        let link = |to: &str, name: &str| std::os::unix::fs::symlink(to, results.join(name));
        link("../victim", "folder").unwrap();
        link("../victim/a", "file").unwrap();
        link("../victim/none", "dangling").unwrap();
        let whole = there.path().join("whole");
        fs::write(&whole, "x").unwrap();
        for name in ["folder/a", "folder/b/c", "file", "dangling", "../victim/a"] {
            for written in [write(&results, name, b"x"), write_new(&results, name, b"x"), put(&whole, &results, name)] {
                let told = written.unwrap_err().to_string();
                let what = ["is a link", "is outside the folder"];
                assert!(what.iter().any(|what| told.contains(what)), "{told}");
            }
        }
        assert_eq!(fs::read(victim.join("a")).unwrap(), b"precious");
        assert_eq!(fs::read_dir(&victim).unwrap().count(), 1);
        // The folder itself may be reached by a link.
        write(&results.join("folder"), "b", b"x").unwrap();
        assert_eq!(fs::read(victim.join("b")).unwrap(), b"x");
        assert!(write_new(&victim, "b", b"y").is_err());
        assert_eq!(fs::read(victim.join("b")).unwrap(), b"x");
    }
}
