//! The files of one question to the program, under the names that the user knows, so that all that is said of them is said in
//! the user's words.

use std::fs;
use std::io::Write;
use std::path::Path;

use tempfile::{NamedTempFile, TempDir};

use crate::fault::{Fault, disk};

/// Longest name of a file \[bytes\].
const LONGEST_NAME: usize = 120;

/// A folder for one question, which goes with it.
pub(crate) struct Workspace {
    folder: TempDir,
    is_own: fn(&str) -> bool,
}

impl Workspace {
    /// A folder within another, on whose disk the files are; `is_own` tells the small letters of names that no file of the user has.
    pub(crate) fn within(folder: &Path, is_own: fn(&str) -> bool) -> Result<Self, Fault> {
        let folder = tempfile::tempdir_in(folder).map_err(disk)?;
        Ok(Self { folder, is_own })
    }

    pub(crate) fn path(&self) -> &Path {
        self.folder.path()
    }

    /// Write a file of an own name, in the place of one that may be there: never into that one.
    pub(crate) fn write(&self, name: &str, text: &str) -> Result<(), Fault> {
        debug_assert!((self.is_own)(name), "{name} may be that of a file of the user");
        let mut file = NamedTempFile::new_in(self.path()).map_err(disk)?;
        file.write_all(text.as_bytes()).map_err(disk)?;
        file.persist(self.path().join(name)).map(|_| ()).map_err(|error| disk(error.error))
    }

    /// A file that the program has written.
    pub(crate) fn read(&self, name: impl AsRef<Path>) -> Result<String, Fault> {
        let path = self.path().join(name);
        fs::read_to_string(path).map_err(|error| Fault::defect(format!("no result: {error}")))
    }

    /// Put a file in; its name here, which is that of the user as far as it can be one.
    pub(crate) fn put(&self, file: &Path, name: &str) -> Result<String, Fault> {
        let name = self.free(name);
        let place = self.path().join(&name);
        // Not every disk has links.
        fs::hard_link(file, &place).or_else(|_| fs::copy(file, &place).map(|_| ())).map_err(disk)?;
        Ok(name)
    }

    /// Put a text in as a file; its name here, likewise.
    pub(crate) fn put_text(&self, text: &str, name: &str) -> Result<String, Fault> {
        let name = self.free(name);
        fs::write(self.path().join(&name), text).map_err(disk)?;
        Ok(name)
    }

    /// A name for a file of the user that no other has.
    fn free(&self, name: &str) -> String {
        let plain = file_name(name);
        let mut names = (2..).map(|number| format!("{number}-{plain}"));
        let is_free = |name: &String| !(self.is_own)(&name.to_lowercase()) && !self.path().join(name).exists();
        let name = Some(plain.clone()).filter(is_free);
        name.or_else(|| names.find(is_free)).unwrap_or(plain)
    }
}

/// A name without what parts folders, what a terminal obeys and what systems keep for themselves.
fn file_name(name: &str) -> String {
    let plain = |c: char| match c {
        '/' | '\\' | ':' | '*' | '?' | '"' | '<' | '>' | '|' => '_',
        c if c.is_control() => '_',
        c => c,
    };
    let mut end = name.len().min(LONGEST_NAME);
    while !name.is_char_boundary(end) {
        end -= 1;
    }
    let name: String = name[..end].chars().map(plain).collect();
    match name.trim().trim_matches('.') {
        "" | "-" => "record".to_owned(),
        name => name.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_have_the_names_of_the_user_and_stay_in_the_folder() {
        let folder = tempfile::tempdir().unwrap();
        let record = folder.path().join("record.csv");
        fs::write(&record, "0,1\n").unwrap();
        let is_own = |name: &str| ["traffic.toml", "plan.toml"].contains(&name);
        let workspace = Workspace::within(folder.path(), is_own).unwrap();
        let long = "ä".repeat(200);
        for (name, here) in [
            ("Mai 2026 (links).csv", "Mai 2026 (links).csv"),
            ("Mai 2026 (links).csv", "2-Mai 2026 (links).csv"),
            ("../../etc/passwd", "_.._etc_passwd"),
            ("a\u{1b}[31m\n.csv", "a_[31m_.csv"),
            ("..", "record"),
            ("-", "2-record"),
            ("traffic.toml", "2-traffic.toml"),
            ("Plan.TOML", "2-Plan.TOML"),
            ("case.toml", "case.toml"),
            (".table", "table"),
            (&long, &"ä".repeat(60)),
        ] {
            assert_eq!(workspace.put(&record, name).unwrap(), here);
            assert_eq!(workspace.read(here).unwrap(), "0,1\n");
        }
    }
    /// A file of the user shares its bytes with the one that was sent.
    #[test]
    fn what_is_written_never_goes_into_a_file_of_the_user() {
        let folder = tempfile::tempdir().unwrap();
        let record = folder.path().join("record.csv");
        fs::write(&record, "0,1\n").unwrap();
        let workspace = Workspace::within(folder.path(), |_| true).unwrap();
        fs::hard_link(&record, workspace.path().join("case.toml")).unwrap();
        workspace.write("case.toml", "title").unwrap();
        assert_eq!(workspace.read("case.toml").unwrap(), "title");
        assert_eq!(fs::read_to_string(record).unwrap(), "0,1\n");
    }
}
