//! What a page asks, read within limits of size and time.

use std::time::Duration;

use axum::body::{Body, to_bytes};
use axum::extract::{FromRequest, Request};
use axum::http::{StatusCode, header};
use riffel::contact::HalfSpace;
use riffel_case::Case;
use riffel_case::file::ContactDynamics;
use serde::Deserialize;
use serde::de::DeserializeOwned;

use crate::fault::Fault;

/// Largest case, as text.
pub(crate) const LARGEST_CASE: usize = 64 * 1024;

/// Largest request: a case with seven to compare, and what stands around them.
const LARGEST_REQUEST: usize = 9 * LARGEST_CASE;

/// Time in which a whole request must have come.
const READING_TIME: Duration = Duration::from_secs(10);

/// Most points of a map on the page; the program computes larger ones.
const MOST_MAP_POINTS: u64 = 250_000;

/// Finest grid of a non-steady contact on the page, the default: its table takes about a second.
const FINEST_GRID: u64 = HalfSpace::DEFAULT_ELEMENTS as u64;

/// A request in JSON.
pub(crate) struct Asked<T>(pub(crate) T);

/// Header by which a page tells its requests from those of other pages.
const PAGE: &str = "x-riffel-page";

/// The page that asks, as it calls itself.
#[derive(Clone)]
pub(crate) struct Asker(Option<String>);

impl Asker {
    /// The name of the page, which owns its file.
    pub(crate) fn owner(&self) -> Result<String, Fault> {
        self.0.clone().ok_or_else(|| {
            Fault::bad("a request about a file must say which page it comes from (X-Riffel-Page)")
        })
    }

    /// Name of one kind of answer for this page, of which only the newest is wanted.
    pub(crate) fn subject(&self, kind: &str) -> Option<String> {
        self.0.as_ref().map(|page| format!("{kind} of {page}"))
    }
}

impl<S: Sync> axum::extract::FromRequestParts<S> for Asker {
    type Rejection = std::convert::Infallible;

    async fn from_request_parts(
        parts: &mut axum::http::request::Parts,
        _: &S,
    ) -> Result<Self, Self::Rejection> {
        let page = parts.headers.get(PAGE).and_then(|page| page.to_str().ok());
        Ok(Self(
            page.filter(|page| page.len() <= 64).map(str::to_owned),
        ))
    }
}

impl<S: Sync, T: DeserializeOwned> FromRequest<S> for Asked<T> {
    type Rejection = Fault;

    async fn from_request(request: Request, _: &S) -> Result<Self, Fault> {
        let kind = request.headers().get(header::CONTENT_TYPE);
        if !kind.is_some_and(|kind| kind.as_bytes().starts_with(b"application/json")) {
            return Err(Fault::refused(
                StatusCode::UNSUPPORTED_MEDIA_TYPE,
                "a request must be JSON".to_owned(),
                "send the header Content-Type: application/json",
            ));
        }
        let bytes = tokio::time::timeout(READING_TIME, read(request.into_body()))
            .await
            .map_err(|_| {
                Fault::refused(
                    StatusCode::REQUEST_TIMEOUT,
                    format!(
                        "the request did not come within {} s",
                        READING_TIME.as_secs()
                    ),
                    "",
                )
            })??;
        serde_json::from_slice(&bytes)
            .map(Self)
            .map_err(|error| Fault::misunderstood(&error.to_string()))
    }
}

async fn read(body: Body) -> Result<axum::body::Bytes, Fault> {
    to_bytes(body, LARGEST_REQUEST).await.map_err(|_| {
        Fault::refused(
            StatusCode::PAYLOAD_TOO_LARGE,
            format!("the request is larger than {} KiB", LARGEST_REQUEST / 1024),
            "a case is a few hundred bytes long",
        )
    })
}

/// A case as the page holds it.
#[derive(Deserialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum CaseText {
    /// The text of a case file.
    Toml(String),
    /// The same keys as JSON, quantities with their units in strings.
    Keys(toml::Table),
}

impl CaseText {
    /// The case as TOML.
    pub(crate) fn toml(&self) -> Result<String, Fault> {
        let text = match self {
            Self::Toml(text) => text.clone(),
            Self::Keys(keys) => toml::to_string(keys)
                .map_err(|error| Fault::bad(format!("the case cannot be written: {error}")))?,
        };
        if text.len() > LARGEST_CASE {
            return Err(Fault::refused(
                StatusCode::PAYLOAD_TOO_LARGE,
                format!("the case is larger than {} KiB", LARGEST_CASE / 1024),
                "",
            ));
        }
        Ok(text)
    }

    /// The case, checked, within what the page computes. It opens no file.
    pub(crate) fn read(&self) -> Result<Case, Fault> {
        let text = self.toml()?;
        check_grid(&text)?;
        let case = Case::parse_sealed("case.toml", &text)?;
        let map = &case.file.map;
        let points = map.wavelength.points * map.speed.points;
        if points > MOST_MAP_POINTS {
            return Err(Fault::of_key(
                "map",
                format!(
                    "`map`: {points} points are more than the {MOST_MAP_POINTS} that the page computes"
                ),
                "lower map.wavelength.points or map.speed.points; the program itself computes larger maps",
            ));
        }
        Ok(case)
    }
}

/// Refuse what would take minutes before it is begun.
fn check_grid(text: &str) -> Result<(), Fault> {
    #[derive(Deserialize)]
    struct File {
        contact: Contact,
    }
    #[derive(Deserialize)]
    struct Contact {
        response: ContactDynamics,
        grid: u64,
    }
    // What does not read as this has the defaults, or a fault that the reader of the case names.
    match toml::from_str::<File>(text) {
        Ok(File { contact })
            if contact.grid > FINEST_GRID && contact.response == ContactDynamics::NonSteady =>
        {
            Err(Fault::of_key(
                "contact.grid",
                format!(
                    "`contact.grid` is {}, but the page goes up to {FINEST_GRID} with a non-steady response",
                    contact.grid
                ),
                "the program itself goes further",
            ))
        }
        _ => Ok(()),
    }
}
