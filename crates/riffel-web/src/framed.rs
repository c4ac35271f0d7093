//! Numbers by the ten thousand, with a head that says what they are.

use axum::http::header;
use axum::response::{IntoResponse, Response};
use serde::Serialize;

use crate::fault::Fault;

/// The length of the head in bytes (u32, little-endian), the head in JSON, padded with blanks to a multiple
/// of four bytes, then the values (f32, little-endian): the browser looks at them as they lie, where a map
/// in JSON would take it longer to read than to draw.
pub(crate) struct Framed<T> {
    pub(crate) head: T,
    pub(crate) values: Vec<f32>,
}

impl<T: Serialize> IntoResponse for Framed<T> {
    fn into_response(self) -> Response {
        let Ok(mut head) = serde_json::to_vec(&self.head) else {
            return Fault::defect("the answer cannot be written").into_response();
        };
        head.resize(head.len().next_multiple_of(4), b' ');
        let Ok(length) = u32::try_from(head.len()) else {
            return Fault::defect("the answer is too long").into_response();
        };
        let mut bytes = Vec::with_capacity(4 + head.len() + 4 * self.values.len());
        bytes.extend(length.to_le_bytes());
        bytes.extend(head);
        bytes.extend(self.values.iter().flat_map(|value| value.to_le_bytes()));
        ([(header::CONTENT_TYPE, "application/octet-stream")], bytes).into_response()
    }
}
