//! `POST` of the questions that need no server: see [`riffel_answers::page`]. `GET /api/vocabulary`: its words.

use std::sync::Arc;

use axum::extract::State;
use axum::http::{HeaderValue, header};
use axum::response::{IntoResponse, Response};
use riffel_answers::page::{Reader, Reply, VOCABULARY};

use crate::Page;
use crate::fault::Refusal;
use crate::queue::Progress;
use crate::request::{ClientId, JsonBytes};

pub(crate) async fn post(
    path: &'static str,
    reader: Reader,
    State(page): State<Page>,
    client: ClientId,
    JsonBytes(json): JsonBytes,
) -> Result<Response, Refusal> {
    if let Some(reply) = page.answered.to(path, &json) {
        return Ok(sent(Arc::unwrap_or_clone(reply)));
    }
    let question = reader(&json)?;
    let kind = question.subject();
    let queue = match kind.as_deref() {
        Some("passage") => &page.marches,
        _ => &page.queue,
    };
    let subject = kind.and_then(|kind| client.subject(&kind));
    let answered = page.answered.clone();
    let reply = queue
        .run(subject, move |cancel| {
            let tell = |done, of| cancel.tell(Progress { done, of });
            answered.keep(path, json, cancel, || question.answer_telling(&tell))
        })
        .await?;
    // One that is not kept has no other owner, and is not copied.
    Ok(sent(Arc::unwrap_or_clone(reply)))
}

fn sent(reply: Reply) -> Response {
    let kind = HeaderValue::from_static(reply.content_type);
    let mut response = ([(header::CONTENT_TYPE, kind)], reply.bytes).into_response();
    if reply.attached {
        let attachment = HeaderValue::from_static("attachment");
        let headers = response.headers_mut();
        headers.insert(header::CONTENT_DISPOSITION, attachment);
    }
    response
}

pub(crate) async fn vocabulary() -> impl IntoResponse {
    ([(header::CONTENT_TYPE, "application/json")], VOCABULARY.as_str())
}
