//! `POST /api/report`: the report of a measured rail; `POST /api/report/case`: that of a case alone.

use std::path::Path;

use axum::extract::State;
use axum::http::header;
use axum::response::IntoResponse;
use riffel_keys::Language;
use riffel_page::CaseText;
use serde::Deserialize;

use super::roughness::{self, Reading};
use super::traffic::TRAFFIC_FILE;
use crate::Page;
use crate::fault::{Fault, Refusal};
use crate::request::{Asked, Asker};

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

/// The option of the program for a language.
fn spoken(language: Language) -> [&'static str; 2] {
    let name = match language {
        Language::English => "en",
        Language::German => "de",
    };
    ["--language", name]
}

pub(crate) async fn of_rail(
    State(page): State<Page>,
    asker: Asker,
    Asked(OfRail {
        rail: question,
        language,
    }): Asked<OfRail>,
) -> Result<impl IntoResponse, Refusal> {
    question.check()?;
    let upload = page.uploads.of(&asker.owner()?)?;
    let earlier = question.earlier(&upload)?;
    let program = page.program.clone();
    let html = page
        .long
        .run(asker.subject("report"), move |wanted| {
            question.write(&upload)?;
            let (file, months) = (upload.name.as_str(), question.months.to_string());
            let more = [question.traffic.speed_arguments(), earlier.of_diagnosis()].concat();
            let names = question.names(&upload, &earlier);
            let reading = Reading::new(&upload, question.format.as_ref())?;
            let mut arguments = vec![
                "report",
                "case.toml",
                "--roughness",
                file,
                "--traffic",
                TRAFFIC_FILE,
                "--months",
                &months,
                "-o",
                REPORT,
            ];
            arguments.extend(more.iter().map(String::as_str));
            arguments.extend(reading.format());
            arguments.extend(spoken(language));
            let run = program.run(upload.folder(), &arguments, wanted);
            run.map_err(|fault| fault.in_words(|words| names.put_into(words)))?;
            Ok(names.put_into_page(&report_in(upload.folder())?))
        })
        .await?;
    Ok(attached(html))
}

#[derive(Deserialize)]
pub(crate) struct Question {
    case: CaseText,
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
            let stored = |error| Fault::defect(&format!("the case cannot be stored: {error}"));
            let folder = uploads.folder().map_err(stored)?;
            let text = question.case.toml()?;
            std::fs::write(folder.path().join("case.toml"), text).map_err(stored)?;
            let [option, language] = spoken(question.language);
            let arguments = ["report", "case.toml", "-o", REPORT, option, language];
            program.run(folder.path(), &arguments, wanted)?;
            report_in(folder.path())
        })
        .await?;
    Ok(attached(html))
}

fn report_in(folder: &Path) -> Result<String, Fault> {
    std::fs::read_to_string(folder.join(REPORT))
        .map_err(|error| Fault::defect(&format!("there is no report: {error}")))
}

/// A page for the disk of the user, not for this origin to show.
fn attached(html: String) -> impl IntoResponse {
    (
        [
            (header::CONTENT_TYPE, "application/octet-stream"),
            (header::CONTENT_DISPOSITION, "attachment"),
        ],
        html,
    )
}
