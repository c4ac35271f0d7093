//! A fault as an answer of the server.

use axum::http::{HeaderValue, StatusCode, header};
use axum::response::{IntoResponse, Response};
pub(crate) use riffel_answers::page::Fault;
use riffel_keys::say;

use crate::json_with_messages::JsonWithMessages;

/// There is no such file any more.
pub(crate) fn file_is_gone() -> Fault {
    Fault::refused(StatusCode::GONE, say!(the_file_is_no_longer_here), say!(choose_it_once_more))
}

/// A file of a page cannot be written: most often the disk is full.
pub(crate) fn disk(error: impl ToString) -> Fault {
    let folder = std::env::temp_dir().display().to_string();
    Fault::refused(
        StatusCode::INSUFFICIENT_STORAGE,
        say!(the_file_cannot_be_stored, error = error.to_string()),
        say!(free_room_on_the_disk, folder = folder),
    )
}

/// A fault that is sent in place of an answer.
#[derive(Debug)]
pub(crate) struct Refusal(pub(crate) Fault);

impl From<Fault> for Refusal {
    fn from(fault: Fault) -> Self {
        Self(fault)
    }
}

impl IntoResponse for Refusal {
    fn into_response(self) -> Response {
        let Self(fault) = self;
        let status = StatusCode::from_u16(fault.status());
        let retry_after = fault.retry_after_s();
        let status = status.unwrap_or(StatusCode::INTERNAL_SERVER_ERROR);
        let mut response = (status, JsonWithMessages(fault)).into_response();
        if let Some(seconds) = retry_after {
            response.headers_mut().insert(header::RETRY_AFTER, HeaderValue::from(seconds));
        }
        response
    }
}
