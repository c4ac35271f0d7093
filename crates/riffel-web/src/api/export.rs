//! `POST /api/export/…`: the map as the program's own files.

use axum::extract::{Path, State};
use axum::http::header;
use axum::response::IntoResponse;
use riffel::{GrowthMap, Ridge};
use riffel_answers::map::{map_csv, map_figure};
use riffel_plot::{DEFAULT_PNG_SCALE, png};
use serde::Deserialize;

use crate::Page;
use crate::fault::Fault;
use crate::request::{Asked, Asker, CaseText};

#[derive(Deserialize)]
pub(crate) struct Question {
    case: CaseText,
}

/// A kind of file.
#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Kind {
    Csv,
    Png,
    Svg,
    Html,
}

impl Kind {
    fn content_type(self) -> &'static str {
        match self {
            Self::Csv => "text/csv; charset=utf-8",
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
    asker: Asker,
    Asked(question): Asked<Question>,
) -> Result<impl IntoResponse, Fault> {
    let bytes = page
        .queue
        .run(asker.subject(kind.content_type()), move |wanted| {
            let case = question.case.read()?;
            let map = GrowthMap::compute_while(
                &case.feedback,
                case.wavelength,
                case.speed,
                || wanted.still(),
                |_| (),
            );
            let figure = || {
                let ridge = Ridge::of_map(&case.feedback, &map);
                map_figure(&case, &map, &ridge, Vec::new())
            };
            match kind {
                Kind::Csv => {
                    let mut bytes = Vec::new();
                    map_csv(&map, &mut bytes, |_| ()).map_err(|error| {
                        Fault::bad(format!("the table cannot be written: {error}"))
                    })?;
                    Ok(bytes)
                }
                Kind::Png => Ok(png(&figure().svg()?, DEFAULT_PNG_SCALE)?),
                Kind::Svg => Ok(figure().svg()?.into_bytes()),
                Kind::Html => Ok(figure().html()?.into_bytes()),
            }
        })
        .await?;
    Ok((
        [
            (header::CONTENT_TYPE, kind.content_type()),
            (header::CONTENT_DISPOSITION, "attachment"),
        ],
        bytes,
    ))
}
