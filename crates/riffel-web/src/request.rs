//! What a page asks, read within limits of size and time.

use riffel_keys::say;
use std::time::Duration;

use axum::body::{Body, Bytes, to_bytes};
use axum::extract::{FromRequest, Request};
use axum::http::{StatusCode, header};
use riffel_answers::page::LARGEST_CASE;
use serde::de::DeserializeOwned;

use crate::fault::{Fault, Refusal};

/// Largest request: a case with seven to compare, and what stands around them.
const LARGEST_REQUEST: usize = 9 * LARGEST_CASE;

/// Time in which a whole request must have come.
const READING_TIME: Duration = Duration::from_secs(10);

/// A request in JSON, read.
pub(crate) struct Json<T>(pub(crate) T);

/// A request in JSON, as it came.
pub(crate) struct JsonBytes(pub(crate) Bytes);

/// Header by which a page tells its requests from those of other pages.
const PAGE: &str = "x-riffel-page";

/// The page that asks, as it calls itself.
#[derive(Clone)]
pub(crate) struct ClientId(Option<String>);

impl ClientId {
    /// The name of the page, which owns its file.
    pub(crate) fn owner(&self) -> Result<String, Fault> {
        self.0
            .clone()
            .ok_or_else(|| Fault::bad("a request about a file must say which page it comes from (X-Riffel-Page)"))
    }

    /// Name of one kind of answer for this page, of which only the newest is wanted.
    pub(crate) fn subject(&self, kind: &str) -> Option<String> {
        self.0.as_ref().map(|page| format!("{kind} of {page}"))
    }
}

impl<S: Sync> axum::extract::FromRequestParts<S> for ClientId {
    type Rejection = std::convert::Infallible;

    async fn from_request_parts(parts: &mut axum::http::request::Parts, _: &S) -> Result<Self, Self::Rejection> {
        let page = parts.headers.get(PAGE).and_then(|page| page.to_str().ok());
        Ok(Self(page.filter(|page| page.len() <= 64).map(str::to_owned)))
    }
}

impl<S: Sync, T: DeserializeOwned> FromRequest<S> for Json<T> {
    type Rejection = Refusal;

    async fn from_request(request: Request, state: &S) -> Result<Self, Refusal> {
        let JsonBytes(json) = JsonBytes::from_request(request, state).await?;
        Ok(Self(riffel_answers::page::understood(&json)?))
    }
}

impl<S: Sync> FromRequest<S> for JsonBytes {
    type Rejection = Refusal;

    async fn from_request(request: Request, _: &S) -> Result<Self, Refusal> {
        let kind = request.headers().get(header::CONTENT_TYPE);
        if !kind.is_some_and(|kind| kind.as_bytes().starts_with(b"application/json")) {
            return Err(Refusal(Fault::refused(
                StatusCode::UNSUPPORTED_MEDIA_TYPE,
                "a request must be JSON".to_owned(),
                "send the header Content-Type: application/json",
            )));
        }
        let bytes = tokio::time::timeout(READING_TIME, read(request.into_body())).await.map_err(|_| {
            Fault::refused(
                StatusCode::REQUEST_TIMEOUT,
                say!(the_request_did_not_come_within, seconds = READING_TIME.as_secs()),
                "",
            )
        })??;
        Ok(Self(bytes))
    }
}

async fn read(body: Body) -> Result<Bytes, Fault> {
    to_bytes(body, LARGEST_REQUEST).await.map_err(|_| {
        Fault::refused(
            StatusCode::PAYLOAD_TOO_LARGE,
            say!(the_request_is_larger_than_kib, size = LARGEST_REQUEST / 1024),
            say!(a_case_is_a_few_hundred),
        )
    })
}
