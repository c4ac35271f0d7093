//! Files of a page by number: one more, or one less.

use std::path::Path;

use axum::body::Body;
use axum::http::HeaderMap;
use serde::Deserialize;
use serde_json::{Value, json};

use super::file_headers::kind_and_length;
use crate::Page;
use crate::fault::Refusal;
use crate::numbered_files::NumberedFiles;
use crate::told::Told;

/// Receive one more file of a folder.
pub(super) async fn receive(
    page: &Page,
    (folder, files, stem): (&Path, &NumberedFiles, &str),
    headers: &HeaderMap,
    body: Body,
) -> Result<Told<Value>, Refusal> {
    let (kind, announced) = kind_and_length(headers);
    let uploads = &page.uploads;
    let received = uploads.receive_numbered(folder, files, stem, kind, (announced, body));
    let (number, bytes) = received.await?;
    Ok(Told(json!({ "number": number, "bytes": bytes })))
}

/// The file that goes.
#[derive(Deserialize)]
pub(crate) struct Removal {
    pub(super) number: u32,
}
