//! What a request says of the file that it brings.

use axum::http::{HeaderMap, header};

/// Kind of a file that comes, and its length if it is announced.
pub(super) fn kind_and_length(headers: &HeaderMap) -> (&'static str, Option<u64>) {
    let text = |name| headers.get(name).and_then(|value| value.to_str().ok());
    let announced = text(header::CONTENT_LENGTH).and_then(|length| length.parse().ok());
    let kind = match text(header::CONTENT_TYPE) {
        Some("text/plain") => "txt",
        _ => "csv",
    };
    (kind, announced)
}
