//! `POST /api/roughness`: the file of a measured rail; `POST /api/measure`: what it says.

use axum::body::Body;
use axum::extract::State;
use axum::http::HeaderMap;
use riffel_answers::page::{CaseText, TRAFFIC_FILE, Traffic};
use riffel_rail::{Limit, LimitTable};
use serde::Deserialize;
use serde_json::{Value, json};

use super::earlier::{Earlier, EarlierRecord};
use super::file_headers::kind_and_length;
use super::reading::Reading;
use crate::Page;
use crate::fault::{Fault, Refusal};
use crate::queue::Wanted;
use crate::request::{Asked, Asker};
use crate::told::Told;
use crate::uploads::Upload;
use crate::workspace::Workspace;

/// The case beside the record.
pub(super) const CASE_FILE: &str = "case.toml";

/// Farthest look ahead.
const MOST_MONTHS: f64 = 1200.0;

/// Receive a file, whose kind is told by the header Content-Type.
pub(crate) async fn post(
    State(page): State<Page>,
    asker: Asker,
    headers: HeaderMap,
    body: Body,
) -> Result<Told<Value>, Refusal> {
    let (kind, announced) = kind_and_length(&headers);
    let owner = asker.owner()?;
    let upload = page.uploads.receive(owner, kind, announced, body).await?;
    Ok(Told(json!({ "bytes": upload.bytes })))
}

#[derive(Deserialize)]
pub(crate) struct Question {
    pub(super) case: CaseText,
    /// Name of the file to the user.
    pub(super) name: String,
    #[serde(flatten)]
    pub(super) traffic: Traffic,
    pub(super) months: f64,
    #[serde(flatten)]
    pub(super) reading: Reading,
    /// When the rail was measured, as 2026-01-31.
    #[serde(default)]
    date: Option<String>,
    /// Earlier records of the same rail, the oldest first.
    #[serde(default)]
    earlier: Vec<EarlierRecord>,
}

impl Question {
    pub(super) fn check(&self) -> Result<(), Fault> {
        self.traffic.read()?;
        let months = self.months;
        if !(months > 0.0 && months <= MOST_MONTHS) {
            return Err(Fault::bad(format!("months: {months}, but must be above zero and at most {MOST_MONTHS}")));
        }
        Ok(())
    }

    /// The earlier records that are asked about.
    pub(super) fn earlier(&self, upload: &Upload) -> Result<Earlier, Fault> {
        Earlier::new(&self.earlier, self.date.as_deref(), upload)
    }

    /// The files of the question in a folder of their own: case, traffic and record, by its name here.
    pub(super) fn put(&self, upload: &Upload) -> Result<(Workspace, String), Fault> {
        // It is checked here, and opens no file.
        self.case.read()?;
        let files = Workspace::within(upload.folder())?;
        let record = files.put(&upload.file(), &self.name)?;
        files.write(CASE_FILE, &self.case.toml()?)?;
        files.write(TRAFFIC_FILE, &self.traffic.toml()?)?;
        Ok((files, record))
    }
}

pub(crate) async fn measure(
    State(page): State<Page>,
    asker: Asker,
    Asked(question): Asked<Question>,
) -> Result<Told<Value>, Refusal> {
    question.check()?;
    let upload = page.uploads.of(&asker.owner()?)?;
    let earlier = question.earlier(&upload)?;
    let program = page.program.clone();
    page.long
        .run(asker.subject("measure"), move |wanted| {
            let (files, record) = question.put(&upload)?;
            let before = earlier.put(&files)?;
            let ask = |name, question: &Value| program.ask(files.path(), name, question, wanted);
            // Short of a diagnosis or a forecast the levels are still worth seeing.
            let ask_or_fault = |name, question| fault_as_answer(ask(name, question), wanted);
            let reading = &question.reading;
            let roughness = ask("roughness", &reading.add_to(json!({ "file": record })))?;
            let mut diagnose = reading.add_to(json!({
                "case": CASE_FILE, "roughness": record, "traffic": TRAFFIC_FILE,
                "speed": question.traffic.speed_range(),
            }));
            earlier.add_to(&before, &mut diagnose);
            let diagnosis = ask_or_fault("diagnose", &diagnose)?;
            let forecast = reading.add_to(json!({
                "case": CASE_FILE, "spectrum": record, "traffic": TRAFFIC_FILE, "months": question.months,
            }));
            let mut fitted = forecast.clone();
            earlier.add_to_forecast(&before, question.traffic.passages_per_day, &mut fitted);
            let mut answer = ask_or_fault("forecast", &fitted)?;
            // Short of a fit the forecast is still worth seeing.
            if fitted != forecast && answer.get("fault").is_some() {
                let without = ask_or_fault("forecast", &forecast)?;
                let fault = std::mem::replace(&mut answer, without)["fault"].take();
                if answer.get("fault").is_none() {
                    answer["fit_fault"] = fault;
                }
            }
            let forecast = answer;
            Ok(Told(json!({
                "roughness": roughness, "diagnosis": diagnosis, "forecast": forecast, "limits": limits(),
            })))
        })
        .await
}

/// The answer, or the fault in its place; none where nobody waits any more.
pub(super) fn fault_as_answer(answer: Result<Value, Fault>, wanted: &Wanted) -> Result<Value, Fault> {
    match answer {
        Err(fault) if wanted.still() => Ok(json!({ "fault": fault })),
        outcome => outcome,
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
