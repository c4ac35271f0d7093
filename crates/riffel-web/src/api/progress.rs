//! `POST /api/progress`: how far the work on a subject of the page is.

use axum::extract::State;
use serde::Deserialize;

use crate::Page;
use crate::fault::Refusal;
use crate::queue::Progress;
use crate::request::{Asked, Asker};
use crate::told::Told;

#[derive(Deserialize)]
pub(crate) struct Question {
    /// The last part of the path that was asked, such as `remedies`.
    subject: String,
}

pub(crate) async fn post(
    State(page): State<Page>,
    asker: Asker,
    Asked(question): Asked<Question>,
) -> Result<Told<Progress>, Refusal> {
    let subject = asker.subject(&question.subject);
    let progress = subject.and_then(|subject| page.queues().find_map(|queue| queue.progress(&subject)));
    Ok(Told(progress.unwrap_or_default()))
}
