//! What a folder of results says of itself.

use std::fs;
use std::path::{Path, PathBuf, absolute};

use riffel_arrays::json;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use crate::error::CalibrationError;
use crate::plan::Plan;

/// `calibration.json`
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Record {
    /// SHA-256 over all that the draws follow from.
    pub(crate) fingerprint: String,
    version: String,
    /// Where the plan is.
    pub(crate) plan: PathBuf,
    /// The arrays of `posterior.zarr`, once they are written: all else there is somebody else's.
    #[serde(default)]
    pub(crate) arrays: Vec<String>,
}

impl Record {
    pub(crate) const NAME: &str = "calibration.json";

    pub(crate) fn of(plan: &Plan) -> Result<Self, CalibrationError> {
        let own = plan.inputs[0].as_path();
        Ok(Self {
            fingerprint: fingerprint(plan)?,
            version: env!("CARGO_PKG_VERSION").to_owned(),
            plan: fs::canonicalize(own).or_else(|_| absolute(own)).unwrap_or_default(),
            arrays: Vec::new(),
        })
    }

    /// That of a folder, if it has one.
    pub(crate) fn read(folder: &Path) -> Option<Self> {
        let bytes = fs::read(folder.join(Self::NAME)).ok()?;
        serde_json::from_slice(&bytes).ok()
    }

    pub(crate) fn bytes(&self) -> Vec<u8> {
        json(self)
    }

    /// Whether both are of the same draws.
    pub(crate) fn is_like(&self, other: &Self) -> bool {
        (&self.fingerprint, &self.version) == (&other.fingerprint, &other.version)
    }

    /// 52 bits of the fingerprint as a number, which each part of a chain ends with.
    pub(crate) fn mark(&self) -> f64 {
        let digits = self.fingerprint.get(..13).unwrap_or_default();
        u64::from_str_radix(digits, 16).unwrap_or_default() as f64
    }
}

/// SHA-256 over all that the numbers follow from: the plan without its decisions, the text of all other files.
fn fingerprint(plan: &Plan) -> Result<String, CalibrationError> {
    let mut hash = Sha256::new();
    hash.update(plan.of_draws());
    for path in &plan.inputs[1..] {
        let bytes = fs::read(path).map_err(|reason| CalibrationError::Read { path: path.clone(), reason })?;
        hash.update((bytes.len() as u64).to_le_bytes());
        hash.update(bytes);
    }
    let digest = hash.finalize();
    Ok(digest.iter().map(|byte| format!("{byte:02x}")).collect())
}
