//! Who is computing in a folder of results.

use riffel_arrays::InUse;

use super::ResultFolder;
use crate::{Shard, StudyError};

/// Locked by who computes: by a whole run for itself, by shards together.
const LOCK: &str = "in-use.lock";

impl ResultFolder {
    /// Take the right to compute a shard: none for a second run of the same shard, or of all beside any other. Where the file
    /// system has no locks nobody is kept out.
    ///
    /// # Errors
    /// [`StudyError::InUse`], [`StudyError::Write`].
    pub fn occupy(&self, shard: Shard) -> Result<Vec<InUse>, StudyError> {
        let take = |name: &str, shared| {
            let taken = InUse::take(&self.path, name, shared);
            let taken = taken.map_err(StudyError::write(&self.path))?;
            taken.ok_or_else(|| StudyError::InUse { folder: self.path.clone() })
        };
        if shard == Shard::ALL {
            return Ok(vec![take(LOCK, false)?]);
        }
        let own = format!("in-use-{}-of-{}.lock", shard.index, shard.count);
        Ok(vec![take(LOCK, true)?, take(&own, false)?])
    }
}
