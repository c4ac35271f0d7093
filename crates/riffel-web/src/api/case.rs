//! `POST /api/case`: a case checked, as keys and as text.

use axum::Json;
use axum::extract::State;
use serde::{Deserialize, Serialize};

use super::note::Note;
use crate::Page;
use crate::fault::Fault;
use crate::request::{Asked, CaseText};

#[derive(Deserialize)]
pub(crate) struct Question {
    case: CaseText,
}

#[derive(Serialize)]
pub(crate) struct Answer {
    /// The keys as they were written.
    keys: toml::Table,
    /// The same as a case file.
    toml: String,
    /// Every key, with presets and defaults.
    complete: riffel_case::file::CaseFile,
    remarks: Vec<Note>,
}

pub(crate) async fn post(
    State(page): State<Page>,
    Asked(question): Asked<Question>,
) -> Result<Json<Answer>, Fault> {
    page.queue
        .run(None, move |_| {
            let case = question.case.read()?;
            let toml = question.case.toml()?;
            let keys = toml
                .parse()
                .map_err(|error| Fault::bad(format!("not valid TOML: {error}")))?;
            Ok(Json(Answer {
                keys,
                toml,
                complete: case.file,
                remarks: case.remarks.iter().map(Note::from).collect(),
            }))
        })
        .await
}
