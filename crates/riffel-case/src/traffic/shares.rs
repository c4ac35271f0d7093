//! Shares of a whole.

use riffel_keys::{CaseError, KeyFile};

/// How far the sum of shares may be from one: shares in tenths of a per cent.
const SHARE_TOLERANCE: f64 = 2e-3;

/// `Ok` where the shares of a key sum to one.
pub(super) fn sums_to_one(
    source: &KeyFile,
    key: &str,
    shares: impl Iterator<Item = f64>,
) -> Result<(), CaseError> {
    let sum: f64 = shares.sum();
    if (sum - 1.0).abs() <= SHARE_TOLERANCE {
        return Ok(());
    }
    let message = format!("the shares of `{key}` sum to {sum:.4}, but must sum to 1");
    Err(source.refuse(&format!("{key}[0].share"), &message))
}
