//! `POST /api/earlier`: an earlier record of the rail; `/read`: its spectrum; `/remove`: it goes.

use riffel_keys::say;
use std::path::PathBuf;

use axum::body::Body;
use axum::extract::State;
use axum::http::HeaderMap;
use riffel_rail::read_date;
use serde::Deserialize;
use serde_json::{Value, json};

use super::numbered::{self, Removal};
use super::reading::Reading;
use crate::Page;
use crate::fault::{Fault, Refusal};
use crate::request::{Asked, Asker};
use crate::told::Told;
use crate::uploads::Upload;
use crate::workspace::Workspace;

/// Receive a file beside that of the page.
pub(crate) async fn post(
    State(page): State<Page>,
    asker: Asker,
    headers: HeaderMap,
    body: Body,
) -> Result<Told<Value>, Refusal> {
    let upload = page.uploads.of(&asker.owner()?)?;
    let place = (upload.folder(), &upload.earlier, "earlier");
    numbered::receive(&page, place, &headers, body).await
}

pub(crate) async fn remove(
    State(page): State<Page>,
    asker: Asker,
    Asked(removal): Asked<Removal>,
) -> Result<Told<Value>, Refusal> {
    // With the record of the page its earlier ones are gone, too.
    if let Ok(upload) = page.uploads.of(&asker.owner()?) {
        upload.earlier.remove(upload.folder(), removal.number);
    }
    Ok(Told(json!({})))
}

#[derive(Deserialize)]
pub(crate) struct Question {
    number: u32,
    name: String,
    #[serde(flatten)]
    reading: Reading,
}

/// What `riffel roughness` says of an earlier record.
pub(crate) async fn read(
    State(page): State<Page>,
    asker: Asker,
    Asked(question): Asked<Question>,
) -> Result<Told<Value>, Refusal> {
    let upload = page.uploads.of(&asker.owner()?)?;
    let file = upload.earlier.file(question.number)?;
    let program = page.program.clone();
    let subject = asker.subject(&format!("earlier record {}", question.number));
    page.long
        .run(subject, move |wanted| {
            let files = Workspace::within(upload.folder())?;
            let file = files.put(&upload.folder().join(file), &question.name)?;
            let question = question.reading.add_to(json!({ "file": file }));
            program.ask(files.path(), "roughness", &question, wanted).map(Told)
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
    /// Their files, with the names to the user.
    files: Vec<(PathBuf, String)>,
    /// Dates of all records, that of the present one last; empty if one has none.
    dates: Vec<String>,
    /// Which one is the latest with a date before that of the present one, and the days between.
    dated: Option<(usize, f64)>,
}

impl Earlier {
    pub(super) fn new(records: &[EarlierRecord], date: Option<&str>, upload: &Upload) -> Result<Self, Fault> {
        let files = records
            .iter()
            .map(|record| {
                let file = upload.earlier.file(record.number)?;
                Ok((upload.folder().join(file), record.name.clone()))
            })
            .collect::<Result<Vec<_>, Fault>>()?;
        let given = records.iter().map(|record| record.date.as_deref());
        let given: Vec<Option<_>> = given
            .chain([date])
            .map(|date| date.map(read_date).transpose())
            .collect::<Result<_, _>>()
            .map_err(|sentence| Fault::bad(say!(the_date_of_a_record, sentence = sentence)))?;
        let (own, before) = (given[records.len()], &given[..records.len()]);
        let all: Option<Vec<_>> = given.iter().copied().collect();
        // Without the dates of all the order is that of the records, and each is held against the present one.
        let pairs: Vec<_> = match (&all, own) {
            (Some(dates), _) => dates.windows(2).map(|pair| (pair[0], pair[1])).collect(),
            (None, Some(own)) => before.iter().flatten().map(|&date| (date, own)).collect(),
            (None, None) => Vec::new(),
        };
        if let Some((earlier, later)) = pairs.iter().find(|(earlier, later)| later <= earlier) {
            return Err(Fault::bad(say!(
                the_dates_of_the_records_do,
                later = later.to_string(),
                earlier = earlier.to_string()
            )));
        }
        let dated = before.iter().enumerate().filter_map(|(place, date)| Some(((*date)?, place))).max();
        let dated = dated.zip(own).and_then(|((before, place), own)| {
            let days = own.since(before).ok()?.get_days();
            Some((place, f64::from(days)))
        });
        let dates = all.filter(|_| !files.is_empty()).unwrap_or_default();
        let dates = dates.iter().map(ToString::to_string).collect();
        Ok(Self { files, dates, dated })
    }

    /// Put the records into the folder of a question; their names there.
    pub(super) fn put(&self, folder: &Workspace) -> Result<Vec<String>, Fault> {
        let files = self.files.iter();
        files.map(|(file, name)| folder.put(file, name)).collect()
    }

    /// Whether all records have a date, and there are earlier ones.
    pub(super) fn has_dates(&self) -> bool {
        !self.dates.is_empty()
    }

    /// Name the records, and their dates, in a question.
    pub(super) fn add_to(&self, names: &[String], question: &mut Value) {
        question["earlier"] = json!(names);
        if !self.dates.is_empty() {
            question["dates"] = self.dates.join(",").into();
        }
    }

    /// Name the records in the question of a forecast; where not all have dates, the latest that has one, under so many axle passages
    /// a day.
    pub(super) fn add_to_forecast(&self, names: &[String], per_day: f64, question: &mut Value) {
        if self.has_dates() {
            self.add_to(names, question);
        } else if let Some((place, days)) = self.dated {
            question["earlier"] = names[place].as_str().into();
            question["passages_between"] = json!(days * per_day);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::uploads::Uploads;

    fn records(dates: &[Option<&str>]) -> Vec<EarlierRecord> {
        let numbered = (1..).zip(dates);
        numbered
            .map(|(number, date)| EarlierRecord { number, name: format!("{number}"), date: date.map(str::to_owned) })
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
            let files = (upload.folder(), &upload.earlier);
            let received = uploads.receive_numbered(files.0, files.1, "earlier", "csv", (None, body()));
            received.await.unwrap();
        }
        let asked = |dates: &[Option<&str>], own| Earlier::new(&records(dates), own, &upload);
        let told = |dates: &[Option<&str>], own| {
            let earlier = asked(dates, own).unwrap();
            let files = Workspace::within(place.path()).unwrap();
            let names = earlier.put(&files).unwrap();
            let (mut diagnosis, mut forecast) = (json!({}), json!({}));
            earlier.add_to(&names, &mut diagnosis);
            earlier.add_to_forecast(&names, 1000.0, &mut forecast);
            json!([diagnosis, forecast])
        };
        let undated = json!({ "earlier": ["1", "2"] });
        let year = |name| json!({ "earlier": name, "passages_between": 365_000.0 });
        assert_eq!(told(&[], Some("2026-05-01")), json!([{ "earlier": [] }, {}]));
        assert_eq!(told(&[None, None], None), json!([undated, {}]));
        // Dates where all records have one; a forecast has 365 days of 1000 passages where they have not.
        let dates = "2024-05-01,2025-05-01,2026-05-01";
        assert_eq!(
            told(&[Some("2024-05-01"), Some("2025-05-01")], Some("2026-05-01")),
            json!([{ "earlier": ["1", "2"], "dates": dates }, { "earlier": ["1", "2"], "dates": dates }])
        );
        assert_eq!(told(&[Some("2025-05-01"), None], Some("2026-05-01")), json!([undated, year("1")]));
        assert_eq!(told(&[Some("2025-05-01"), None], None), json!([undated, {}]));
        for (dates, own, words) in [
            ([Some("2025-05-01"), Some("2024-05-01")], Some("2026-05-01"), "do not rise"),
            ([Some("2026-05-01"), None], Some("2026-05-01"), "do not rise"),
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
