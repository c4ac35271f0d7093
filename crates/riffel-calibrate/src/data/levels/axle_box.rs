//! Levels of an axle box that runs over the rail.

use std::path::Path;

use riffel_case::Case;
use riffel_keys::CaseError;

use super::row::{self, Row};
use super::table;
use crate::file::Kind;
use crate::kernel::Kernel;

/// Levels of acceleration on an axle box.
#[derive(Clone)]
pub(crate) struct AxleBoxRun {
    pub(crate) view: usize,
    pub(crate) rows: Vec<Row>,
    /// \[m/s\]
    pub(crate) speed: f64,
    pub(crate) common_error: f64,
    pub(crate) missed: Option<Kernel>,
}

impl AxleBoxRun {
    pub(crate) fn rows(path: &Path, case: &Case, passages: f64) -> Result<Vec<Row>, CaseError> {
        let numbers = table::Numbers::of(path, Kind::AxleBox)?;
        row::rows(&numbers, path, case, |_| passages)
    }
}
