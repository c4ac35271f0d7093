//! Results appear whole or not at all.

mod manifest;
mod place;
mod staged_file;

use std::fs::{self, File};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

use riffel_answers::map::map_csv;
use riffel_answers::{ResultFile, Table, fingerprint};
use riffel_arrays::whole_file;
use riffel_plot::{DEFAULT_PNG_SCALE, LineFigure, Picture, html_of_stages};
use tempfile::TempPath;

use crate::error::CliError;
use crate::interrupt::Active;
use crate::progress::Progress;
use crate::scratch::Scratch;
use crate::session::Session;
use manifest::{Files, Manifest};
use staged_file::StagedFile;

/// A folder of results in the making: files are written to a temporary folder inside it and renamed
/// all together at the end. Dropped before [`publish`](Self::publish), nothing remains.
pub(crate) struct Staging<'a> {
    session: &'a Session,
    command: &'static str,
    folder: PathBuf,
    temporary: PathBuf,
    files: Vec<String>,
}

impl<'a> Staging<'a> {
    /// Prepare the folder for the files of a command, making it if need be.
    pub(crate) fn new(session: &'a Session, command: &'static str, folder: &Path) -> Result<Self, CliError> {
        place::check_folder(folder)?;
        // What is wrong with the folder is better known before the work than after it.
        Manifest::read(folder)?;
        let mut guard = session.interrupt.active();
        let made = !folder.exists();
        fs::create_dir_all(folder).map_err(|reason| cannot_write(folder, reason))?;
        let made = made.then(|| folder.to_owned());
        Self::within(session, &mut guard, command, folder, made)
    }

    fn within(
        session: &'a Session,
        active: &mut Option<Active>,
        command: &'static str,
        folder: &Path,
        made: Option<PathBuf>,
    ) -> Result<Self, CliError> {
        let scratch = Scratch::new_in(folder).map_err(|reason| cannot_write(folder, reason))?;
        let temporary = scratch.path().to_owned();
        *active = Some(Active { scratch, made });
        Ok(Self { session, command, folder: folder.to_owned(), temporary, files: Vec::new() })
    }

    /// Where a writer that wants a path may make the file of the given name.
    pub(crate) fn path(&mut self, name: &str) -> PathBuf {
        self.files.push(name.to_owned());
        self.temporary.join(name)
    }

    /// Write a whole file.
    pub(crate) fn write(&mut self, name: &str, bytes: impl AsRef<[u8]>) -> Result<(), CliError> {
        self.write_with(name, |file| file.write_all(bytes.as_ref()))
    }

    /// Write a drawing as PNG and SVG.
    pub(crate) fn write_picture(&mut self, name: &str, picture: &Picture) -> Result<(), CliError> {
        self.write(&format!("{name}.png"), picture.png(DEFAULT_PNG_SCALE)?)?;
        self.write(&format!("{name}.svg"), picture.svg())
    }

    /// Write a figure as PNG, SVG and page.
    pub(crate) fn write_figure(&mut self, name: &str, figure: &LineFigure) -> Result<(), CliError> {
        self.write_picture(name, &figure.picture()?)?;
        self.write(&format!("{name}.html"), figure.html()?)
    }

    /// Write a file of an answer.
    pub(crate) fn write_result(&mut self, file: ResultFile<'_>) -> Result<(), CliError> {
        match file {
            ResultFile::Lines(name, figure) => self.write_figure(name, &figure),
            ResultFile::Picture(name, figure) => self.write_picture(name, &figure.picture()?),
            ResultFile::Maps(name, maps) => {
                self.write_picture(name, &maps.picture()?)?;
                self.write(&format!("{name}.html"), maps.html()?)
            }
            ResultFile::Strips(name, strips) => self.write_picture(name, &strips.picture()?),
            ResultFile::Bars(name, bars) => self.write_picture(name, &bars.picture()?),
            ResultFile::Table(table) => self.write_table(table.name, &table),
            ResultFile::TableAs(name, table) => self.write_table(&name, &table),
            ResultFile::Stages(name, figures) => {
                let stages: Vec<_> = figures.iter().map(|(name, figure)| (name.as_str(), figure)).collect();
                self.write(&format!("{name}.html"), html_of_stages(&stages)?)
            }
            ResultFile::Map(name, map) => {
                let progress =
                    Progress::new(self.session.voice, riffel_keys::say!(progress_writing_map), map.speed().points());
                self.write_with(&format!("{name}.csv"), |file| map_csv(map, file, |rows| progress.advance(rows)))
            }
            ResultFile::Grid(name, grid) => {
                let path = self.path(&format!("{name}.nc"));
                Ok(grid.write(&path)?)
            }
        }
    }

    fn write_table(&mut self, name: &str, table: &Table) -> Result<(), CliError> {
        self.write_with(&format!("{name}.csv"), |file| table.csv(file))
    }

    /// Write a file piece by piece.
    pub(crate) fn write_with(
        &mut self,
        name: &str,
        write: impl FnOnce(&mut StagedFile) -> io::Result<()>,
    ) -> Result<(), CliError> {
        let path = self.path(name);
        File::create(&path)
            .and_then(|file| {
                let mut file = StagedFile::new(file, name);
                write(&mut file)?;
                file.finish()
            })
            .map_err(|reason| self.cannot_write(name, reason))
    }

    /// Rename every file to its place and remove those of the last run that this one has not written; returns the
    /// names.
    pub(crate) fn publish(mut self) -> Result<Vec<String>, CliError> {
        let mut manifest = Manifest::read(&self.folder)?;
        let mut written = Files::new();
        for name in &self.files {
            check_file(self.session, &manifest, &self.folder, name)?;
            let fingerprint =
                fingerprint(&self.temporary.join(name)).map_err(|reason| self.cannot_write(name, reason))?;
            written.insert(name.clone(), fingerprint);
        }
        let stale = manifest.replace(self.command, &written);
        place::check(self.session, &self.folder.join(manifest::NAME))?;
        let names = self.files.clone();
        self.write(manifest::NAME, crate::output::json(self.session.voice, &manifest))?;
        let mut guard = self.session.interrupt.active();
        // The manifest first: what it lists and does not find does no harm, what it does not list is never replaced.
        for name in self.files.iter().rev() {
            whole_file::put(&self.temporary.join(name), &self.folder, name)
                .map_err(|reason| self.cannot_write(name, reason))?;
        }
        manifest::remove(&self.folder, &stale);
        if let Some(active) = guard.take() {
            active.scratch.close();
        }
        Ok(names)
    }

    fn cannot_write(&self, name: &str, reason: io::Error) -> CliError {
        cannot_write(&self.folder.join(name), reason)
    }
}

impl Drop for Staging<'_> {
    fn drop(&mut self) {
        // After `publish` there is nothing left to discard.
        if let Some(active) = self.session.interrupt.active().take() {
            active.discard();
        }
    }
}

/// What is done with a regular file that is there already.
#[derive(Clone, Copy)]
pub(crate) enum Existing {
    /// Replace it, unless it is an input.
    Replace,
    /// Keep it, and tell what else one can do than give another name.
    Keep(&'static str),
}

impl Existing {
    /// Replaced if it says the same, or if its head holds the mark of what writes it: a page is written anew, as the results of a folder
    /// are.
    pub(crate) fn known(path: &Path, text: &str, mark: Option<&str>) -> Self {
        /// Bytes within which the mark stands.
        const HEAD: u64 = 1024;
        let mut head = Vec::new();
        let has_mark = |mark| {
            File::open(path)
                .and_then(|file| file.take(HEAD).read_to_end(&mut head))
                .is_ok_and(|_| String::from_utf8_lossy(&head).contains(mark))
        };
        let is_same = || path.is_file() && fs::read(path).is_ok_and(|there| there == text.as_bytes());
        match mark.map_or_else(is_same, has_mark) {
            true => Self::Replace,
            false => Self::Keep("--force to replace it"),
        }
    }
}

/// Write one file whole.
pub(crate) fn write_file(session: &Session, path: &Path, text: &str, existing: Existing) -> Result<(), CliError> {
    const NAME: &str = "file";
    place::check(session, path)?;
    let folder = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    if !folder.is_dir() {
        let what = format!("there is no folder {}", folder.display());
        return Err(cannot_write(path, io::Error::other(what)));
    }
    let mut staging = Staging::within(session, &mut session.interrupt.active(), "", folder, None)?;
    staging.write(NAME, text)?;
    let file = staging.temporary.join(NAME);
    let _placing = session.interrupt.active();
    let placed = match existing {
        Existing::Replace => fs::rename(&file, path),
        Existing::Keep(_) => {
            TempPath::try_from_path(&file).and_then(|file| file.persist_noclobber(path).map_err(|error| error.error))
        }
    };
    placed.map_err(|reason| match existing {
        Existing::Keep(way_out) if reason.kind() == io::ErrorKind::AlreadyExists => {
            CliError::Exists { path: path.to_owned(), way_out }
        }
        _ => cannot_write(path, reason),
    })
}

/// `Ok` if a command may write its files to a folder: what is wrong with it is better known before long work than after it.
pub(crate) fn check_files(session: &Session, folder: &Path, names: &[&str]) -> Result<(), CliError> {
    place::check_folder(folder)?;
    let manifest = Manifest::read(folder)?;
    let mut names = names.iter();
    names.try_for_each(|name| check_file(session, &manifest, folder, name))
}

/// `Ok` if a file is not there, or is that of a run before.
fn check_file(session: &Session, manifest: &Manifest, folder: &Path, name: &str) -> Result<(), CliError> {
    let path = folder.join(name);
    place::check(session, &path)?;
    match path.exists() && !manifest.lists(name) {
        true => Err(CliError::Foreign { path }),
        false => Ok(()),
    }
}

fn cannot_write(path: &Path, reason: io::Error) -> CliError {
    CliError::Write { path: path.to_owned(), reason }
}
