//! `POST /api/earlier`: an earlier record of the rail; `/read`: its spectrum; `/remove`: it goes.

use axum::Json;
use axum::body::Body;
use axum::extract::State;
use axum::http::HeaderMap;
use riffel_rail::{ReaderFormat, read_date};
use serde::Deserialize;
use serde_json::{Value, json};

use super::names::Names;
use super::roughness::{Reading, kind_and_length};
use crate::Page;
use crate::fault::{Fault, Refusal};
use crate::request::{Asked, Asker};
use crate::uploads::Upload;

/// Receive a file beside that of the page.
pub(crate) async fn post(
    State(page): State<Page>,
    asker: Asker,
    headers: HeaderMap,
    body: Body,
) -> Result<Json<Value>, Refusal> {
    let (kind, announced) = kind_and_length(&headers);
    let owner = asker.owner()?;
    let received = page
        .uploads
        .receive_earlier(&owner, kind, announced, body)
        .await?;
    let (number, bytes) = received;
    Ok(Json(json!({ "number": number, "bytes": bytes })))
}

#[derive(Deserialize)]
pub(crate) struct Removal {
    number: u32,
}

pub(crate) async fn remove(
    State(page): State<Page>,
    asker: Asker,
    Asked(removal): Asked<Removal>,
) -> Result<Json<Value>, Refusal> {
    // With the record of the page its earlier ones are gone, too.
    if let Ok(upload) = page.uploads.of(&asker.owner()?) {
        upload.earlier.remove(upload.folder(), removal.number);
    }
    Ok(Json(json!({})))
}

#[derive(Deserialize)]
pub(crate) struct Question {
    number: u32,
    name: String,
    #[serde(default)]
    format: Option<ReaderFormat>,
}

/// What `riffel roughness` says of an earlier record.
pub(crate) async fn read(
    State(page): State<Page>,
    asker: Asker,
    Asked(question): Asked<Question>,
) -> Result<Json<Value>, Refusal> {
    let upload = page.uploads.of(&asker.owner()?)?;
    let file = upload.earlier.file(question.number)?;
    let program = page.program.clone();
    let subject = asker.subject(&format!("earlier record {}", question.number));
    page.long
        .run(subject, move |wanted| {
            let reading = Reading::of_file(&file, &upload, question.format.as_ref())?;
            let names = Names::new([(file, question.name)]);
            let arguments = reading.arguments("roughness", &["--json"]);
            names
                .document(&program, upload.folder(), &arguments, wanted)
                .map(Json)
        })
        .await
}

/// An earlier record in a question.
#[derive(Deserialize)]
pub(super) struct EarlierRecord {
    number: u32,
    /// Name of the file to the user.
    name: String,
    #[serde(default)]
    date: Option<String>,
}

/// Earlier records as the program is told of them, the oldest first.
pub(super) struct Earlier {
    files: Vec<String>,
    names: Vec<String>,
    /// Dates of all records, that of the present one last; empty if one has none.
    dates: Vec<String>,
    /// The latest record with a date before that of the present one, and the days between.
    dated: Option<(String, f64)>,
}

impl Earlier {
    pub(super) fn new(
        records: &[EarlierRecord],
        date: Option<&str>,
        upload: &Upload,
    ) -> Result<Self, Fault> {
        let files = records
            .iter()
            .map(|record| upload.earlier.file(record.number))
            .collect::<Result<Vec<_>, _>>()?;
        let given = records.iter().map(|record| record.date.as_deref());
        let given: Vec<Option<_>> = given
            .chain([date])
            .map(|date| date.map(read_date).transpose())
            .collect::<Result<_, _>>()
            .map_err(|sentence| Fault::bad(format!("the date of a record: {sentence}")))?;
        let (own, before) = (given[records.len()], &given[..records.len()]);
        let all: Option<Vec<_>> = given.iter().copied().collect();
        // Without the dates of all the order is that of the records, and each is held against the present one.
        let pairs: Vec<_> = match (&all, own) {
            (Some(dates), _) => dates.windows(2).map(|pair| (pair[0], pair[1])).collect(),
            (None, Some(own)) => before.iter().flatten().map(|&date| (date, own)).collect(),
            (None, None) => Vec::new(),
        };
        if let Some((earlier, later)) = pairs.iter().find(|(earlier, later)| later <= earlier) {
            return Err(Fault::bad(format!(
                "the dates of the records do not rise: {later} comes after {earlier}; give the oldest first"
            )));
        }
        let dated = before
            .iter()
            .zip(&files)
            .filter_map(|(date, file)| Some(((*date)?, file)))
            .max();
        let dated = dated.zip(own).and_then(|((before, file), own)| {
            let days = own.since(before).ok()?.get_days();
            Some((file.clone(), f64::from(days)))
        });
        let dates = all.filter(|_| !files.is_empty()).unwrap_or_default();
        let dates = dates.iter().map(ToString::to_string).collect();
        Ok(Self {
            files,
            names: records.iter().map(|record| record.name.clone()).collect(),
            dates,
            dated,
        })
    }

    /// Names of the files here with those to the user.
    pub(super) fn named(&self) -> impl Iterator<Item = (String, String)> {
        self.files.iter().cloned().zip(self.names.iter().cloned())
    }

    /// Arguments of a diagnosis or a report.
    pub(super) fn of_diagnosis(&self) -> Vec<String> {
        let files = self.files.iter();
        let mut arguments: Vec<String> = files
            .flat_map(|file| ["--earlier".to_owned(), file.clone()])
            .collect();
        if !self.dates.is_empty() {
            arguments.extend(["--dates".to_owned(), self.dates.join(",")]);
        }
        arguments
    }

    /// Arguments of a forecast, under so many axle passages a day.
    pub(super) fn of_forecast(&self, passages_per_day: f64) -> Vec<String> {
        self.dated.as_ref().map_or_else(Vec::new, |(file, days)| {
            let passages = (days * passages_per_day).to_string();
            ["--earlier", file, "--passages-between", &passages]
                .map(str::to_owned)
                .to_vec()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::uploads::Uploads;

    fn records(dates: &[Option<&str>]) -> Vec<EarlierRecord> {
        let numbered = (1..).zip(dates);
        numbered
            .map(|(number, date)| EarlierRecord {
                number,
                name: format!("{number}"),
                date: date.map(str::to_owned),
            })
            .collect()
    }

    #[tokio::test]
    async fn the_program_is_told_of_files_dates_and_passages() {
        let place = tempfile::tempdir().unwrap();
        let uploads = Uploads::within(place.path(), 100).unwrap();
        let body = || Body::from("1,2\n");
        let upload = uploads.receive("a".to_owned(), "csv", None, body()).await;
        let upload = upload.unwrap();
        for _ in 0..2 {
            uploads
                .receive_earlier("a", "csv", None, body())
                .await
                .unwrap();
        }
        let asked = |dates: &[Option<&str>], own| Earlier::new(&records(dates), own, &upload);
        let told = |dates: &[Option<&str>], own| {
            let earlier = asked(dates, own).unwrap();
            let arguments = [earlier.of_diagnosis(), earlier.of_forecast(1000.0)].concat();
            arguments.join(" ")
        };
        let files = "--earlier earlier-1.csv --earlier earlier-2.csv";
        assert_eq!(told(&[], Some("2026-05-01")), "");
        assert_eq!(told(&[None, None], None), files);
        // 365 days of 1000 passages; the diagnosis has dates where all records have one.
        assert_eq!(
            told(
                &[Some("2024-05-01"), Some("2025-05-01")],
                Some("2026-05-01")
            ),
            format!(
                "{files} --dates 2024-05-01,2025-05-01,2026-05-01 --earlier earlier-2.csv --passages-between 365000"
            )
        );
        assert_eq!(
            told(&[Some("2025-05-01"), None], Some("2026-05-01")),
            format!("{files} --earlier earlier-1.csv --passages-between 365000")
        );
        assert_eq!(told(&[Some("2025-05-01"), None], None), files);
        for (dates, own, words) in [
            (
                [Some("2025-05-01"), Some("2024-05-01")],
                Some("2026-05-01"),
                "do not rise",
            ),
            (
                [Some("2026-05-01"), None],
                Some("2026-05-01"),
                "do not rise",
            ),
            ([Some("--output=/tmp"), None], None, "the date of a record"),
        ] {
            let fault = asked(&dates, own).err().unwrap();
            assert!(fault.message().contains(words), "{}", fault.message());
        }
        upload.earlier.remove(upload.folder(), 2);
        let gone = asked(&[None, None], None).err().unwrap();
        assert_eq!(gone.status(), 410);
    }
}
