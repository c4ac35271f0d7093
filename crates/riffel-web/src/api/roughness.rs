//! `POST /api/roughness`: the file of a measured rail; `POST /api/measure`: what it says.

use axum::Json;
use axum::body::Body;
use axum::extract::State;
use axum::http::{HeaderMap, header};
use riffel_page::CaseText;
use riffel_rail::{Limit, LimitTable, ReaderFormat};
use serde::Deserialize;
use serde_json::{Value, json};

use super::earlier::{Earlier, EarlierRecord};
use super::names::Names;
use super::traffic::{TRAFFIC_FILE, Traffic};
use crate::Page;
use crate::fault::{Fault, Refusal};
use crate::program::Program;
use crate::queue::Wanted;
use crate::request::{Asked, Asker};
use crate::uploads::Upload;

/// Farthest look ahead.
const MOST_MONTHS: f64 = 1200.0;

/// Receive a file, whose kind is told by the header Content-Type.
pub(crate) async fn post(
    State(page): State<Page>,
    asker: Asker,
    headers: HeaderMap,
    body: Body,
) -> Result<Json<Value>, Refusal> {
    let (kind, announced) = kind_and_length(&headers);
    let owner = asker.owner()?;
    let upload = page.uploads.receive(owner, kind, announced, body).await?;
    Ok(Json(json!({ "bytes": upload.bytes })))
}

/// Kind of a file that comes, and its length if it is announced.
pub(super) fn kind_and_length(headers: &HeaderMap) -> (&'static str, Option<u64>) {
    let text = |name| headers.get(name).and_then(|value| value.to_str().ok());
    let announced = text(header::CONTENT_LENGTH).and_then(|length| length.parse().ok());
    let kind = match text(header::CONTENT_TYPE) {
        Some("text/plain") => "txt",
        _ => "csv",
    };
    (kind, announced)
}

#[derive(Deserialize)]
pub(crate) struct Question {
    pub(super) case: CaseText,
    /// Name of the file to the user.
    pub(super) name: String,
    #[serde(flatten)]
    pub(super) traffic: Traffic,
    pub(super) months: f64,
    /// How the files are laid out, where the reader has chosen columns.
    #[serde(default)]
    pub(super) format: Option<ReaderFormat>,
    /// When the rail was measured, as 2026-01-31.
    #[serde(default)]
    date: Option<String>,
    /// Earlier records of the same rail, the oldest first.
    #[serde(default)]
    earlier: Vec<EarlierRecord>,
}

/// How the program is told to read the file of a page.
pub(super) struct Reading {
    file: String,
    chosen: bool,
}

/// A reader profile beside the file.
const FORMAT: &str = "format.toml";

impl Reading {
    /// Put the reader profile, if there is one, beside the file.
    pub(super) fn new(upload: &Upload, format: Option<&ReaderFormat>) -> Result<Self, Fault> {
        Self::of_file(&upload.name, upload, format)
    }

    /// The same for another file in the folder.
    pub(super) fn of_file(
        file: &str,
        upload: &Upload,
        format: Option<&ReaderFormat>,
    ) -> Result<Self, Fault> {
        if let Some(format) = format {
            let text = toml::to_string(format)
                .map_err(|error| Fault::bad(format!("the columns cannot be written: {error}")))?;
            std::fs::write(upload.folder().join(FORMAT), text).map_err(|error| {
                Fault::defect(&format!("the columns cannot be stored: {error}"))
            })?;
        }
        Ok(Self {
            file: file.to_owned(),
            chosen: format.is_some(),
        })
    }

    /// Those of `riffel roughness` on the file, and more.
    pub(super) fn arguments<'a>(&'a self, command: &'a str, more: &[&'a str]) -> Vec<&'a str> {
        let mut arguments = vec![command, &self.file];
        arguments.extend(self.format());
        arguments.extend(more);
        arguments
    }

    /// Arguments that name the reader profile.
    pub(super) fn format(&self) -> Vec<&'static str> {
        if self.chosen {
            vec!["--format", FORMAT]
        } else {
            Vec::new()
        }
    }
}

impl Question {
    pub(super) fn check(&self) -> Result<(), Fault> {
        self.traffic.check()?;
        let months = self.months;
        if !(months > 0.0 && months <= MOST_MONTHS) {
            return Err(Fault::bad(format!(
                "months: {months}, but must be above zero and at most {MOST_MONTHS}"
            )));
        }
        Ok(())
    }

    /// The earlier records that are asked about.
    pub(super) fn earlier(&self, upload: &Upload) -> Result<Earlier, Fault> {
        Earlier::new(&self.earlier, self.date.as_deref(), upload)
    }

    /// Names of all files that are asked about.
    pub(super) fn names(&self, upload: &Upload, earlier: &Earlier) -> Names {
        let own = (upload.name.clone(), self.name.clone());
        Names::new([own].into_iter().chain(earlier.named()))
    }

    /// Put case and traffic beside the file.
    pub(super) fn write(&self, upload: &Upload) -> Result<(), Fault> {
        // It is checked here, and opens no file.
        self.case.read()?;
        let write = |name: &str, text: &str| std::fs::write(upload.folder().join(name), text);
        let traffic = self.traffic.toml()?;
        write("case.toml", &self.case.toml()?)
            .and_then(|()| write(TRAFFIC_FILE, &traffic))
            .map_err(|error| Fault::defect(&format!("the case cannot be stored: {error}")))
    }
}

pub(crate) async fn measure(
    State(page): State<Page>,
    asker: Asker,
    Asked(question): Asked<Question>,
) -> Result<Json<Value>, Refusal> {
    question.check()?;
    let upload = page.uploads.of(&asker.owner()?)?;
    let earlier = question.earlier(&upload)?;
    let program = page.program.clone();
    page.long
        .run(asker.subject("measurement"), move |wanted| {
            question.write(&upload)?;
            let run = Run {
                names: question.names(&upload, &earlier),
                program: &program,
                upload: &upload,
                wanted,
            };
            let file = upload.name.as_str();
            let reading = Reading::new(&upload, question.format.as_ref())?;
            let roughness = run.document(&reading.arguments("roughness", &["--json"]))?;
            // Short of a diagnosis or a forecast the levels are still worth seeing.
            let mut diagnose = vec![
                "diagnose", "case.toml", "--roughness", file, "--traffic", TRAFFIC_FILE, "--json",
            ];
            let more = [question.traffic.speed_arguments(), earlier.of_diagnosis()].concat();
            diagnose.extend(more.iter().map(String::as_str));
            diagnose.extend(reading.format());
            let diagnosis = run.document_or_fault(&diagnose)?;
            let months = question.months.to_string();
            let mut forecast = vec![
                "forecast",
                "case.toml",
                "--spectrum",
                file,
                "--traffic",
                TRAFFIC_FILE,
                "--months",
                &months,
                "--json",
            ];
            forecast.extend(reading.format());
            let between = earlier.of_forecast(question.traffic.passages_per_day);
            let between = between.iter().map(String::as_str);
            let fitted = [forecast.clone(), between.collect()].concat();
            let mut answer = run.document_or_fault(&fitted)?;
            // Short of a fit the forecast is still worth seeing.
            if fitted != forecast && answer.get("fault").is_some() {
                let without = run.document_or_fault(&forecast)?;
                let fault = std::mem::replace(&mut answer, without)["fault"].take();
                if answer.get("fault").is_none() {
                    answer["fit_fault"] = fault;
                }
            }
            let forecast = answer;
            Ok(Json(json!({
                "roughness": roughness, "diagnosis": diagnosis, "forecast": forecast, "limits": limits(),
            })))
        })
        .await
}

/// The program on the file of a question.
pub(super) struct Run<'a> {
    pub(super) names: Names,
    pub(super) program: &'a Program,
    pub(super) upload: &'a Upload,
    pub(super) wanted: &'a Wanted,
}

impl Run<'_> {
    fn document(&self, arguments: &[&str]) -> Result<Value, Fault> {
        let folder = self.upload.folder();
        self.names
            .document(self.program, folder, arguments, self.wanted)
    }

    /// The document, or the fault in its place; none where nobody waits any more.
    pub(super) fn document_or_fault(&self, arguments: &[&str]) -> Result<Value, Fault> {
        match self.document(arguments) {
            Err(fault) if self.wanted.still() => Ok(json!({ "fault": fault })),
            outcome => outcome,
        }
    }
}

/// The limits of levels that come with Riffel.
fn limits() -> Vec<Value> {
    let tables = LimitTable::all();
    tables
        .iter()
        .filter_map(|table| match &table.limit {
            Limit::Levels(limit) => {
                let levels = limit.spectrum().levels().iter();
                let levels = levels.map(|level| [level.band.wavelength(), level.level]);
                Some(json!({ "edition": table.edition, "source": table.source,
                    "wavelength_m_and_level_db": levels.collect::<Vec<_>>() }))
            }
            Limit::Rms(_) => None,
        })
        .collect()
}
