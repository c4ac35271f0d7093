//! Tables of the exact contact that several cases share.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

use riffel::RollingContact;
use riffel_keys::CaseError;

/// Tables of the exact contact by all that they depend on, for cases that are built from one another and differ in
/// other joints: a table costs a second. By default nothing is kept.
#[derive(Clone, Default)]
pub(crate) struct ContactTables(Option<Arc<Mutex<Known>>>);

type Known = HashMap<String, Arc<dyn RollingContact>>;

impl ContactTables {
    /// Tables that are kept as long as any case that shares them.
    pub(crate) fn shared() -> Self {
        Self(Some(Arc::default()))
    }

    /// The table of a contact that `key` tells from all others, made if it is not known.
    pub(crate) fn get(
        &self,
        key: impl FnOnce() -> String,
        make: impl FnOnce() -> Result<Arc<dyn RollingContact>, CaseError>,
    ) -> Result<Arc<dyn RollingContact>, CaseError> {
        let Some(known) = &self.0 else {
            return make();
        };
        // Held while a table is made, so that none is made twice.
        let mut known = known.lock().unwrap_or_else(PoisonError::into_inner);
        let key = key();
        if let Some(table) = known.get(&key) {
            return Ok(table.clone());
        }
        let table = make()?;
        known.insert(key, table.clone());
        Ok(table)
    }
}
