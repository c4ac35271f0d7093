//! `POST /api/report`: the report of a measured rail; `POST /api/report/case`: that of a case alone.

use axum::extract::State;
use axum::http::header;
use axum::response::IntoResponse;
use riffel_answers::page::{CaseText, TRAFFIC_FILE, Traffic};
use riffel_keys::Language;
use serde::Deserialize;
use serde_json::{Value, json};

use super::roughness::{self, CASE_FILE};
use crate::Page;
use crate::fault::{Fault, Refusal};
use crate::program::Program;
use crate::queue::Wanted;
use crate::request::{Asked, Asker};
use crate::workspace::Workspace;

/// The page that the program writes.
const REPORT: &str = "report.html";

/// A report of a rail, and the language of its words.
#[derive(Deserialize)]
pub(crate) struct OfRail {
    #[serde(flatten)]
    rail: roughness::Question,
    #[serde(default)]
    language: Language,
}

pub(crate) async fn of_rail(
    State(page): State<Page>,
    asker: Asker,
    Asked(OfRail { rail: question, language }): Asked<OfRail>,
) -> Result<impl IntoResponse, Refusal> {
    question.check()?;
    let upload = page.uploads.of(&asker.owner()?)?;
    let earlier = question.earlier(&upload)?;
    let program = page.program.clone();
    let html = page
        .long
        .run(asker.subject("report"), move |wanted| {
            let (files, record) = question.put(&upload)?;
            let mut report = question.reading.add_to(json!({
                "case": CASE_FILE, "roughness": record, "traffic": TRAFFIC_FILE, "months": question.months,
                "speed": question.traffic.speed_range(), "output": REPORT,
                // As on the page, which takes a fitted coefficient only when it is told to.
                "keep_coefficient": true,
            }));
            earlier.add_to(&earlier.put(&files)?, &mut report);
            write(&program, &files, &report, language, wanted)
        })
        .await?;
    Ok(attached(html))
}

#[derive(Deserialize)]
pub(crate) struct Question {
    case: CaseText,
    /// The traffic of the line; none, and it is the usual one.
    #[serde(default)]
    traffic: Option<Traffic>,
    #[serde(default)]
    language: Language,
}

pub(crate) async fn of_case(
    State(page): State<Page>,
    asker: Asker,
    Asked(question): Asked<Question>,
) -> Result<impl IntoResponse, Refusal> {
    let (program, uploads) = (page.program.clone(), page.uploads.clone());
    let html = page
        .long
        .run(asker.subject("report"), move |wanted| {
            // It is checked here, and opens no file.
            question.case.read()?;
            let folder = uploads.folder()?;
            let files = Workspace::within(folder.path())?;
            files.write(CASE_FILE, &question.case.toml()?)?;
            let mut report = json!({ "case": CASE_FILE, "output": REPORT });
            if let Some(traffic) = &question.traffic {
                traffic.read()?;
                files.write(TRAFFIC_FILE, &traffic.toml()?)?;
                report["traffic"] = TRAFFIC_FILE.into();
            }
            write(&program, &files, &report, question.language, wanted)
        })
        .await?;
    Ok(attached(html))
}

/// The report that the program writes to a question.
fn write(
    program: &Program,
    files: &Workspace,
    question: &Value,
    language: Language,
    wanted: &Wanted,
) -> Result<String, Fault> {
    let own = std::process::id().to_string();
    let words = ["ask", "--messages", "--page", &own, "report", "--language", language.code()];
    program.run(files.path(), &words, question, wanted)?;
    files.read(REPORT)
}

/// A page for the disk of the user, not for this origin to show.
fn attached(html: String) -> impl IntoResponse {
    ([(header::CONTENT_TYPE, "application/octet-stream"), (header::CONTENT_DISPOSITION, "attachment")], html)
}
