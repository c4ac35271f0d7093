//! An answer in JSON.

use axum::http::{StatusCode, header};
use axum::response::{IntoResponse, Response};
use riffel_answers::page::written;
use serde::Serialize;

/// What is sent as JSON, its messages as data.
#[derive(Debug)]
pub(crate) struct JsonWithMessages<T>(pub(crate) T);

impl<T: Serialize> IntoResponse for JsonWithMessages<T> {
    fn into_response(self) -> Response {
        match written(&self.0) {
            Ok(bytes) => ([(header::CONTENT_TYPE, "application/json")], bytes).into_response(),
            Err(fault) => (StatusCode::INTERNAL_SERVER_ERROR, fault.message()).into_response(),
        }
    }
}
