//! Results appear whole or not at all.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};

use riffel_plot::{DEFAULT_PNG_SCALE, LineFigure, png};
use riffel_study::Stop;
use tempfile::TempDir;

use crate::error::CliError;

/// Exit status of a program that Ctrl-C stopped.
pub(crate) const INTERRUPTED: u8 = 130;

/// The temporary folder in use, for the handler of Ctrl-C to remove.
static ACTIVE: Mutex<Option<Active>> = Mutex::new(None);

struct Active {
    temporary: TempDir,
    /// The folder of results, if it was made for this run.
    made: Option<PathBuf>,
}

impl Active {
    fn discard(self) {
        let _ = self.temporary.close();
        if let Some(made) = self.made {
            // Fails, as it should, where something has been put there meanwhile.
            let _ = fs::remove_dir(made);
        }
    }
}

fn active() -> MutexGuard<'static, Option<Active>> {
    // The data is a path: nothing about it is broken by a panic elsewhere.
    ACTIVE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A study under way, which ends by itself when it is asked to.
static STUDY: OnceLock<Arc<Stop>> = OnceLock::new();

/// Let Ctrl-C ask a study to stop, instead of ending the program; the second one ends it.
pub(crate) fn stop_on_interrupt() -> Arc<Stop> {
    STUDY.get_or_init(Arc::default).clone()
}

/// On Ctrl-C or a request to end, remove what is half-written and leave with status 130.
///
/// The handler waits for the lock, so it never cuts into the renaming of finished files.
pub(crate) fn clean_up_on_interrupt() {
    // Fails only if a handler is set already, which this program does once.
    let _ = ctrlc::set_handler(|| {
        if let Some(stop) = STUDY.get().filter(|stop| !stop.is_asked()) {
            return stop.ask();
        }
        let mut guard = active();
        if let Some(active) = guard.take() {
            active.discard();
        }
        std::process::exit(INTERRUPTED.into());
    });
}

/// A folder of results in the making: files are written to a temporary folder inside it and renamed
/// all together at the end. Dropped before [`publish`](Self::publish), nothing remains.
pub(crate) struct Staging {
    folder: PathBuf,
    temporary: PathBuf,
    files: Vec<String>,
}

impl Staging {
    /// Prepare the folder, making it if need be.
    pub(crate) fn new(folder: &Path) -> Result<Self, CliError> {
        let cannot_write = |reason| CliError::Write {
            path: folder.to_owned(),
            reason,
        };
        let mut guard = active();
        let made = !folder.exists();
        fs::create_dir_all(folder).map_err(cannot_write)?;
        let temporary = tempfile::Builder::new()
            .prefix(".riffel-")
            .tempdir_in(folder)
            .map_err(cannot_write)?;
        let path = temporary.path().to_owned();
        *guard = Some(Active {
            temporary,
            made: made.then(|| folder.to_owned()),
        });
        Ok(Self {
            folder: folder.to_owned(),
            temporary: path,
            files: Vec::new(),
        })
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
    pub(crate) fn write_picture(&mut self, name: &str, svg: &str) -> Result<(), CliError> {
        self.write(&format!("{name}.png"), png(svg, DEFAULT_PNG_SCALE)?)?;
        self.write(&format!("{name}.svg"), svg)
    }

    /// Write a figure as PNG, SVG and page.
    pub(crate) fn write_figure(&mut self, name: &str, figure: &LineFigure) -> Result<(), CliError> {
        self.write_picture(name, &figure.svg()?)?;
        self.write(&format!("{name}.html"), figure.html()?)
    }

    /// Write a file piece by piece.
    pub(crate) fn write_with(
        &mut self,
        name: &str,
        write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
    ) -> Result<(), CliError> {
        let path = self.path(name);
        File::create(&path)
            .map(BufWriter::new)
            .and_then(|mut file| {
                write(&mut file)?;
                file.flush()
            })
            .map_err(|reason| self.cannot_write(name, reason))
    }

    /// Rename every file to its place; returns their names.
    pub(crate) fn publish(mut self) -> Result<Vec<String>, CliError> {
        let mut guard = active();
        for name in &self.files {
            fs::rename(self.temporary.join(name), self.folder.join(name))
                .map_err(|reason| self.cannot_write(name, reason))?;
        }
        if let Some(active) = guard.take() {
            let _ = active.temporary.close();
        }
        Ok(std::mem::take(&mut self.files))
    }

    fn cannot_write(&self, name: &str, reason: io::Error) -> CliError {
        CliError::Write {
            path: self.folder.join(name),
            reason,
        }
    }
}

impl Drop for Staging {
    fn drop(&mut self) {
        // After `publish` there is nothing left to discard.
        if let Some(active) = active().take() {
            active.discard();
        }
    }
}

/// Write one file whole, by a temporary name beside it.
pub(crate) fn write_file(path: &Path, text: &str, replace: bool) -> Result<(), CliError> {
    let cannot_write = |reason| CliError::Write {
        path: path.to_owned(),
        reason,
    };
    let folder = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    let mut builder = tempfile::Builder::new();
    builder.prefix(".riffel-");
    // A temporary file is for its owner alone; this one becomes a file like any other.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let mut file = builder.tempfile_in(folder).map_err(cannot_write)?;
    file.write_all(text.as_bytes()).map_err(cannot_write)?;
    let placed = if replace {
        file.persist(path)
    } else {
        file.persist_noclobber(path)
    };
    match placed {
        Ok(_) => Ok(()),
        Err(error) if error.error.kind() == io::ErrorKind::AlreadyExists => Err(CliError::Exists {
            path: path.to_owned(),
        }),
        Err(error) => Err(cannot_write(error.error)),
    }
}
