//! The page behind `riffel serve`: the whole model in a browser, from one program.
//!
//! [`serve`] listens on this machine and answers until it is told to end. Everything that the page loads is
//! inside the program. Cases come as the keys of a case file and are read by `riffel_case`, so that errors
//! are those of the program; they may not name files. Work stands in a bounded queue; whatever nobody waits
//! for any more is dropped.

mod answered;
mod api;
mod assets;
mod fault;
mod file;
mod guard;
mod impatient;
mod json_with_messages;
mod numbered_files;
mod plan_changes;
mod program;
mod queue;
mod request;
mod server;
mod uploads;
mod workspace;

use axum::Router;
use axum::http::StatusCode;
use axum::response::{IntoResponse, Response};
use axum::routing::{get, post};

use answered::Answered;
use fault::{Fault, Refusal};
use program::Program;
use queue::Queue;
use riffel_answers::page::QUESTIONS;
use uploads::Uploads;

pub use file::{FILE_GENERATOR, PAGE_MODULE, PageFileError, page_file};
pub use server::{Options, ServeError, serve};

/// What all requests share.
#[derive(Clone)]
pub(crate) struct Page {
    /// Work of milliseconds to seconds.
    queue: Queue,
    /// What it has answered.
    answered: Answered,
    /// Marches in time, one at a time: they take up to a minute, beside which maps and cases are still answered.
    marches: Queue,
    /// Work on files, one at a time, which must not hold up the sliders.
    long: Queue,
    /// Calibrations, one at a time: they take up to minutes, beside which measured rails are still answered.
    chains: Queue,
    uploads: Uploads,
    program: Program,
}

impl Page {
    fn queues(&self) -> impl Iterator<Item = &Queue> {
        [&self.queue, &self.marches, &self.long, &self.chains].into_iter()
    }
}

/// The page as a service.
pub(crate) fn router(page: Page) -> Router {
    let questions = QUESTIONS.into_iter().fold(Router::new(), |router, (path, reader)| {
        let answer = move |page, client, asked| api::questions::post(path, reader, page, client, asked);
        router.route(path, post(answer))
    });
    questions
        .route("/", get(assets::page))
        .route("/assets/{version}/{name}", get(assets::file))
        .route("/api/vocabulary", get(api::questions::vocabulary))
        .route("/api/curve", post(api::curve::post))
        .route("/api/curve/wheels", post(api::wheels::post))
        .route("/api/export/{kind}", post(api::export::post))
        .route("/api/ask/{name}", post(api::ask::post))
        .route("/api/upload", post(api::upload::post))
        .route("/api/upload/remove", post(api::upload::remove))
        .route("/api/upload/kept", post(api::upload::kept))
        .route("/api/calibration", post(api::calibration::post))
        .route("/api/calibration/plan", post(api::calibration::plan))
        .route("/api/calibration/decision", post(api::decision::post))
        .route("/api/calibration/example", get(api::calibration::example))
        .route("/api/progress", post(api::progress::post))
        .fallback(nothing_here)
        .layer(axum::middleware::from_fn(guard::guard))
        .with_state(page)
}

async fn nothing_here() -> Response {
    Refusal(Fault::refused(StatusCode::NOT_FOUND, "there is nothing here".to_owned(), "")).into_response()
}

#[cfg(test)]
mod tests;
