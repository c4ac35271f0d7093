//! `POST /api/export/…`: the map as pictures and as a page.

use axum::extract::{Path, State};
use axum::http::header;
use axum::response::IntoResponse;
use riffel::GrowthMap;
use riffel_answers::map::map_figure;
use riffel_answers::page::CaseText;
use riffel_answers::ridge::ridge_of;
use riffel_plot::DEFAULT_PNG_SCALE;
use serde::Deserialize;

use crate::Page;
use crate::fault::{Fault, Refusal};
use crate::request::{ClientId, Json};

#[derive(Deserialize)]
pub(crate) struct Question {
    case: CaseText,
}

/// A kind of file.
#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Kind {
    Png,
    Svg,
    Html,
}

impl Kind {
    fn content_type(self) -> &'static str {
        match self {
            Self::Png => "image/png",
            Self::Svg => "image/svg+xml",
            // A page is for the disk of the user, not for this origin to show.
            Self::Html => "application/octet-stream",
        }
    }
}

pub(crate) async fn post(
    State(page): State<Page>,
    Path(kind): Path<Kind>,
    client: ClientId,
    Json(question): Json<Question>,
) -> Result<impl IntoResponse, Refusal> {
    let bytes = page
        .queue
        .run(client.subject(kind.content_type()), move |_| {
            let case = question.case.read()?;
            let map = GrowthMap::compute(&case.feedback, case.wavelength, case.speed, |_| ());
            let ridge = ridge_of(&case, &case.feedback);
            let figure = map_figure(&case, &map, &ridge, Vec::new());
            let unable = |error| Fault::bad(format!("the figure cannot be drawn: {error}"));
            match kind {
                Kind::Png => figure.picture().and_then(|picture| picture.png(DEFAULT_PNG_SCALE)),
                Kind::Svg => figure.picture().map(|picture| picture.svg().into_bytes()),
                Kind::Html => figure.html().map(String::into_bytes),
            }
            .map_err(unable)
        })
        .await?;
    Ok(([(header::CONTENT_TYPE, kind.content_type()), (header::CONTENT_DISPOSITION, "attachment")], bytes))
}
