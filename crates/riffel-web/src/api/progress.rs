//! `POST /api/progress`: how far the work on a subject of the page is.

use axum::extract::State;
use serde::Deserialize;

use crate::Page;
use crate::fault::Refusal;
use crate::json_with_messages::JsonWithMessages;
use crate::queue::Progress;
use crate::request::{ClientId, Json};

#[derive(Deserialize)]
pub(crate) struct Question {
    /// The last part of the path that was asked, such as `remedies`.
    subject: String,
}

pub(crate) async fn post(
    State(page): State<Page>,
    client: ClientId,
    Json(question): Json<Question>,
) -> Result<JsonWithMessages<Progress>, Refusal> {
    let subject = client.subject(&question.subject);
    let progress = subject.and_then(|subject| page.queues().find_map(|queue| queue.progress(&subject)));
    Ok(JsonWithMessages(progress.unwrap_or_default()))
}
