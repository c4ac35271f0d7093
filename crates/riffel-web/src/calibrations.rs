//! What pages have measured to calibrate a case by, and the chains that were drawn for it.

use riffel_keys::say;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use axum::http::StatusCode;
use tempfile::TempDir;

use crate::fault::Fault;
use crate::numbered_files::NumberedFiles;
use crate::uploads::Uploads;
use crate::workspace::Workspace;

/// Calibrations that are kept, one of each page; one more, and the oldest goes.
const MOST: usize = 8;

/// The calibrations of all pages.
#[derive(Clone, Default)]
pub(crate) struct Calibrations(Arc<Mutex<Vec<OfPage>>>);

/// The name of a page, and its calibration.
type OfPage = (String, Arc<Calibration>);

/// The calibration of a page, in a folder that goes with it.
pub(crate) struct Calibration {
    pub(crate) folder: TempDir,
    /// The data.
    pub(crate) data: NumberedFiles,
    drawn: Mutex<Option<Arc<Drawn>>>,
}

/// Chains that were drawn: the folder of the question, with its plan.
pub(crate) struct Drawn {
    pub(crate) files: Workspace,
    pub(crate) plan: String,
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Calibrations {
    /// That of a page.
    pub(crate) fn of(&self, page: &str) -> Result<Arc<Calibration>, Fault> {
        let calibrations = locked(&self.0);
        let own = calibrations.iter().find(|(other, _)| other == page);
        own.map(|(_, calibration)| calibration.clone()).ok_or_else(gone)
    }

    /// That of a page, begun if there is none.
    pub(crate) fn begin(&self, page: String, uploads: &Uploads) -> Result<Arc<Calibration>, Fault> {
        if let Ok(calibration) = self.of(&page) {
            return Ok(calibration);
        }
        let folder = uploads.folder()?;
        let calibration = Arc::new(Calibration { folder, data: NumberedFiles::default(), drawn: Mutex::default() });
        let mut calibrations = locked(&self.0);
        if calibrations.len() >= MOST {
            calibrations.remove(0);
        }
        calibrations.push((page, calibration.clone()));
        Ok(calibration)
    }
}

impl Calibration {
    /// Its chains, if they were drawn.
    pub(crate) fn drawn(&self) -> Result<Arc<Drawn>, Fault> {
        locked(&self.drawn).clone().ok_or_else(gone)
    }

    /// Keep chains in the place of those before.
    pub(crate) fn keep(&self, drawn: Drawn) {
        *locked(&self.drawn) = Some(Arc::new(drawn));
    }
}

fn gone() -> Fault {
    Fault::refused(StatusCode::GONE, say!(the_calibration_is_no_longer_here), say!(choose_its_data_once_more))
}
