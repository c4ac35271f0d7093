//! Shares of a whole.

use riffel_keys::{CaseError, KeyFile, number, say};

/// How far the sum of shares may be from one: shares in tenths of a per cent.
const SHARE_TOLERANCE: f64 = 2e-3;

/// `Ok` where the shares of a key sum to one.
pub(super) fn sums_to_one(source: &KeyFile, key: &str, shares: impl Iterator<Item = f64>) -> Result<(), CaseError> {
    let sum: f64 = shares.sum();
    if (sum - 1.0).abs() <= SHARE_TOLERANCE {
        return Ok(());
    }
    let message = say!(the_shares_of_sum_to_but, key, sum = number(format_args!("{sum:.4}")));
    Err(source.refuse(&format!("{key}[0].share"), &message))
}
