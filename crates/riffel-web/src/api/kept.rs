//! `POST /api/kept`: a file that the page has sent, as it came: after a reload the page has it no more.

use axum::extract::State;
use axum::http::{StatusCode, header};
use axum::response::IntoResponse;
use serde::Deserialize;

use crate::Page;
use crate::fault::{Fault, Refusal, file_is_gone};
use crate::request::{Asked, Asker};

/// Largest file that is given back \[bytes\]: in a project it is text, of which browsers take no more.
const LARGEST: u64 = 256 << 20;

#[derive(Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Kind {
    Record,
    Earlier,
    Measurements,
}

#[derive(Deserialize)]
pub(crate) struct Question {
    kind: Kind,
    /// Of several.
    #[serde(default)]
    number: u32,
}

pub(crate) async fn post(
    State(page): State<Page>,
    asker: Asker,
    Asked(question): Asked<Question>,
) -> Result<impl IntoResponse, Refusal> {
    let owner = asker.owner()?;
    let number = question.number;
    let path = match question.kind {
        Kind::Record => page.uploads.of(&owner)?.file(),
        Kind::Earlier => {
            let upload = page.uploads.of(&owner)?;
            upload.folder().join(upload.earlier.file(number)?)
        }
        Kind::Measurements => {
            let own = page.calibrations.of(&owner)?;
            own.folder.path().join(own.data.file(number)?)
        }
    };
    let about = tokio::fs::metadata(&path).await.map_err(|_| file_is_gone())?;
    if about.len() > LARGEST {
        return Err(Refusal(Fault::refused(
            StatusCode::PAYLOAD_TOO_LARGE,
            format!("the file is larger than {} MiB", LARGEST >> 20),
            "",
        )));
    }
    let bytes = tokio::fs::read(&path).await.map_err(|_| file_is_gone())?;
    Ok(([(header::CONTENT_TYPE, "application/octet-stream")], bytes))
}
