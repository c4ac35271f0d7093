//! `POST /api/wheelset`: how the wheelset of a case moves at its natural frequencies.

use axum::Json;
use axum::extract::State;
use riffel_answers::wheelset_motions::WheelsetMotions;
use serde::Deserialize;

use crate::Page;
use crate::fault::Fault;
use crate::request::{Asked, Asker, CaseText};

#[derive(Deserialize)]
pub(crate) struct Question {
    case: CaseText,
}

pub(crate) async fn post(
    State(page): State<Page>,
    asker: Asker,
    Asked(question): Asked<Question>,
) -> Result<Json<WheelsetMotions>, Fault> {
    page.queue
        .run(asker.subject("wheelset"), move |_| {
            Ok(Json(WheelsetMotions::new(&question.case.read()?)?))
        })
        .await
}
