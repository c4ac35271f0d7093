//! `POST /api/roughness`: the file of a measured rail; `POST /api/measure`: what it says.

use axum::Json;
use axum::body::Body;
use axum::extract::State;
use axum::http::{HeaderMap, header};
use riffel_page::CaseText;
use riffel_rail::{Limit, LimitTable, ReaderFormat};
use serde::Deserialize;
use serde_json::{Value, json};

use crate::Page;
use crate::fault::{Fault, Refusal};
use crate::program::Program;
use crate::queue::Wanted;
use crate::request::{Asked, Asker};
use crate::uploads::Upload;

/// Longest name of a file that is shown.
pub(super) const LONGEST_NAME: usize = 120;

/// Receive a file, whose kind is told by the header Content-Type.
pub(crate) async fn post(
    State(page): State<Page>,
    asker: Asker,
    headers: HeaderMap,
    body: Body,
) -> Result<Json<Value>, Refusal> {
    let text = |name| headers.get(name).and_then(|value| value.to_str().ok());
    let announced = text(header::CONTENT_LENGTH).and_then(|length| length.parse().ok());
    let kind = match text(header::CONTENT_TYPE) {
        Some("text/plain") => "txt",
        _ => "csv",
    };
    let owner = asker.owner()?;
    let upload = page.uploads.receive(owner, kind, announced, body).await?;
    Ok(Json(json!({ "bytes": upload.bytes })))
}

#[derive(Deserialize)]
pub(crate) struct Question {
    pub(super) case: CaseText,
    /// Name of the file to the user.
    pub(super) name: String,
    slowest_m_per_s: f64,
    fastest_m_per_s: f64,
    passages_per_day: f64,
    pub(super) months: f64,
    /// How the file is laid out, where the reader has chosen its columns.
    #[serde(default)]
    pub(super) format: Option<ReaderFormat>,
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
        if let Some(format) = format {
            let text = toml::to_string(format)
                .map_err(|error| Fault::bad(format!("the columns cannot be written: {error}")))?;
            std::fs::write(upload.folder().join(FORMAT), text).map_err(|error| {
                Fault::defect(&format!("the columns cannot be stored: {error}"))
            })?;
        }
        Ok(Self {
            file: upload.name.clone(),
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

/// Words of the program with the name that the user knows.
pub(super) fn named(name: &str, words: &str, upload: &Upload) -> String {
    let name: String = name.chars().take(LONGEST_NAME).collect();
    words.replace(&upload.name, &name)
}

impl Question {
    pub(super) fn check(&self) -> Result<(), Fault> {
        let [slowest, fastest] = [self.slowest_m_per_s, self.fastest_m_per_s];
        if !(slowest > 0.0 && slowest <= fastest && fastest < 200.0) {
            return Err(Fault::bad(format!(
                "the speeds of the traffic go from {:.1} to {:.1} km/h, but must be above zero and rise",
                3.6 * slowest,
                3.6 * fastest
            )));
        }
        for (what, value, most) in [
            ("axle passages a day", self.passages_per_day, 1e6),
            ("months", self.months, 1200.0),
        ] {
            if !(value > 0.0 && value <= most) {
                return Err(Fault::bad(format!(
                    "{what}: {value}, but must be above zero and at most {most}"
                )));
            }
        }
        Ok(())
    }

    /// Mean speed of the traffic \[m/s\].
    pub(super) fn mean_speed(&self) -> f64 {
        (self.slowest_m_per_s + self.fastest_m_per_s) / 2.0
    }

    /// One kind of vehicle, that of the case, at speeds spread evenly over their range.
    fn traffic(&self) -> String {
        let [slowest, fastest] = [self.slowest_m_per_s, self.fastest_m_per_s];
        let mean = self.mean_speed();
        // Of an even distribution.
        let deviation = (fastest - slowest) / 12f64.sqrt();
        let deviation = if deviation > 0.0 {
            format!(", standard_deviation = {deviation}")
        } else {
            String::new()
        };
        format!(
            "title = \"traffic of the page\"\n[line]\npassages_per_day = {:?}\n\
             [[vehicle]]\nname = \"the wheel of the case\"\nshare = 1\nspeed = {{ mean = {mean}{deviation} }}\n",
            self.passages_per_day
        )
    }

    pub(super) fn speeds(&self) -> String {
        format!("{} m/s..{} m/s", self.slowest_m_per_s, self.fastest_m_per_s)
    }

    /// Words of the program with the name that the user knows.
    pub(super) fn named(&self, words: &str, upload: &Upload) -> String {
        named(&self.name, words, upload)
    }

    /// Put case and traffic beside the file.
    pub(super) fn write(&self, upload: &Upload) -> Result<(), Fault> {
        // It is checked here, and opens no file.
        self.case.read()?;
        let write = |name: &str, text: &str| std::fs::write(upload.folder().join(name), text);
        write("case.toml", &self.case.toml()?)
            .and_then(|()| write("traffic.toml", &self.traffic()))
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
    let program = page.program.clone();
    page.long
        .run(asker.subject("measurement"), move |wanted| {
            question.write(&upload)?;
            let run = Run {
                question: &question,
                program: &program,
                upload: &upload,
                wanted,
            };
            let file = upload.name.as_str();
            let reading = Reading::new(&upload, question.format.as_ref())?;
            let roughness = run.document(&reading.arguments("roughness", &["--json"]))?;
            let speeds = question.speeds();
            // Short of a diagnosis or a forecast the levels are still worth seeing.
            let mut diagnose = vec!["diagnose", "case.toml", "--roughness", file, "--speed", &speeds, "--json"];
            diagnose.extend(reading.format());
            let diagnosis = run.document_or_fault(&diagnose)?;
            let months = question.months.to_string();
            let mut forecast = vec![
                "forecast", "case.toml", "--spectrum", file, "--traffic", "traffic.toml", "--months", &months,
                "--json",
            ];
            forecast.extend(reading.format());
            let forecast = run.document_or_fault(&forecast)?;
            Ok(Json(json!({
                "roughness": roughness, "diagnosis": diagnosis, "forecast": forecast, "limits": limits(),
            })))
        })
        .await
}

/// The program on the file of a question.
pub(super) struct Run<'a> {
    pub(super) question: &'a Question,
    pub(super) program: &'a Program,
    pub(super) upload: &'a Upload,
    pub(super) wanted: &'a Wanted,
}

impl Run<'_> {
    fn document(&self, arguments: &[&str]) -> Result<Value, Fault> {
        let named = |words: &str| self.question.named(words, self.upload);
        let printed = self
            .program
            .run(self.upload.folder(), arguments, self.wanted)
            .map_err(|fault| fault.in_words(named))?;
        serde_json::from_str(&named(&printed))
            .map_err(|_| Fault::defect("the program printed something else than a document"))
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
