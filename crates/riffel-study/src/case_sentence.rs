//! What a case says of a value that the user did not write as an override.

use riffel_keys::CaseError;

/// What the case says, without the override that the user did not write.
pub(crate) fn case_sentence(error: &CaseError) -> String {
    match error {
        CaseError::Override { message, .. } => message.clone(),
        error => error.to_string(),
    }
}
