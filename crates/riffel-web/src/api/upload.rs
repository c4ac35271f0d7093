//! `POST /api/upload`: a file of the page; `/remove`: it goes; `/kept`: it comes back, for after a reload the page has it no more.

use axum::body::Body;
use axum::extract::State;
use axum::http::{HeaderMap, StatusCode, header};
use axum::response::IntoResponse;
use serde::Deserialize;
use serde_json::{Value, json};

use crate::Page;
use crate::fault::{Fault, Refusal, file_is_gone};
use crate::json_with_messages::JsonWithMessages;
use crate::request::{ClientId, Json};

/// Largest file that is given back \[bytes\]: in a project it is text, of which browsers take no more.
const LARGEST: u64 = 256 << 20;

/// A file by its number.
#[derive(Deserialize)]
pub(crate) struct Handle {
    upload: u32,
}

/// Receive a file, whose kind is told by the header Content-Type.
pub(crate) async fn post(
    State(page): State<Page>,
    client: ClientId,
    headers: HeaderMap,
    body: Body,
) -> Result<JsonWithMessages<Value>, Refusal> {
    let text = |name| headers.get(name).and_then(|value| value.to_str().ok());
    let announced = text(header::CONTENT_LENGTH).and_then(|length| length.parse().ok());
    let is_text = text(header::CONTENT_TYPE) == Some("text/plain");
    let (upload, bytes) = page.uploads.receive(&client.owner()?, is_text, announced, body).await?;
    Ok(JsonWithMessages(json!({ "upload": upload, "bytes": bytes })))
}

pub(crate) async fn remove(
    State(page): State<Page>,
    client: ClientId,
    Json(Handle { upload }): Json<Handle>,
) -> Result<JsonWithMessages<Value>, Refusal> {
    if let Ok(sent) = page.uploads.of(&client.owner()?) {
        sent.remove(upload);
    }
    Ok(JsonWithMessages(json!({})))
}

pub(crate) async fn kept(
    State(page): State<Page>,
    client: ClientId,
    Json(Handle { upload }): Json<Handle>,
) -> Result<impl IntoResponse, Refusal> {
    let path = page.uploads.of(&client.owner()?)?.file(upload)?;
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
