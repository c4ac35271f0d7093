//! Parts that several cases share.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

use riffel_keys::CaseError;

/// Parts of one kind by all that they depend on, for cases that are built from one another and differ in other joints. By default
/// nothing is kept.
#[derive(Clone)]
pub(crate) struct Shared<T>(Option<Arc<Mutex<HashMap<String, T>>>>);

impl<T> Default for Shared<T> {
    fn default() -> Self {
        Self(None)
    }
}

impl<T: Clone> Shared<T> {
    /// Parts that are kept as long as any case that shares them.
    pub(crate) fn kept() -> Self {
        Self(Some(Arc::default()))
    }

    /// Whether parts are kept.
    pub(crate) fn is_kept(&self) -> bool {
        self.0.is_some()
    }

    /// The part that `key` tells from all others, made if it is not known.
    pub(crate) fn get(
        &self,
        key: impl FnOnce() -> String,
        make: impl FnOnce() -> Result<T, CaseError>,
    ) -> Result<T, CaseError> {
        let Some(known) = &self.0 else {
            return make();
        };
        // Held while a part is made, so that none is made twice.
        let mut known = known.lock().unwrap_or_else(PoisonError::into_inner);
        let key = key();
        if let Some(part) = known.get(&key) {
            return Ok(part.clone());
        }
        let part = make()?;
        known.insert(key, part.clone());
        Ok(part)
    }
}
