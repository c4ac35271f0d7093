//! Wheelsets that several cases share.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

use riffel::wheelset::RememberingWheelset;
use riffel_keys::CaseError;

use crate::wheelset::CaseWheelset;

/// A wheelset of a case that remembers what it answered.
pub(crate) type KeptWheelset = RememberingWheelset<Arc<CaseWheelset>>;

/// Wheelsets by all that they depend on, for cases that are built from one another and differ in other joints: of a vehicle in
/// its curve every wheel at every speed has a case of its own. By default nothing is kept.
#[derive(Clone, Default)]
pub(crate) struct KeptWheelsets(Option<Arc<Mutex<Known>>>);

type Known = HashMap<String, (Arc<CaseWheelset>, Arc<KeptWheelset>)>;

impl KeptWheelsets {
    /// Wheelsets that are kept as long as any case that shares them.
    pub(crate) fn shared() -> Self {
        Self(Some(Arc::default()))
    }

    /// The wheelset that `key` tells from all others, made if it is not known, and beside it, where wheelsets are kept, the
    /// same with its memory.
    pub(crate) fn get(
        &self,
        key: impl FnOnce() -> String,
        make: impl FnOnce() -> Result<CaseWheelset, CaseError>,
    ) -> Result<(Arc<CaseWheelset>, Option<Arc<KeptWheelset>>), CaseError> {
        let Some(known) = &self.0 else {
            return Ok((Arc::new(make()?), None));
        };
        let mut known = known.lock().unwrap_or_else(PoisonError::into_inner);
        let key = key();
        if let Some((wheelset, kept)) = known.get(&key) {
            return Ok((wheelset.clone(), Some(kept.clone())));
        }
        let wheelset = Arc::new(make()?);
        let kept = Arc::new(RememberingWheelset::new(wheelset.clone()));
        known.insert(key, (wheelset.clone(), kept.clone()));
        Ok((wheelset, Some(kept)))
    }
}
