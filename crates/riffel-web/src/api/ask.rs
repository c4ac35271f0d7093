//! `POST /api/ask/NAME`: a question of [`riffel ask`](riffel_answers::question), answered by a process of its own.
//!
//! The body holds the keys of the question. In the place of a file stands one that the page has sent, `{ "upload": 3, "name": "rail.csv" }`,
//! or its text, `{ "text": "…", "name": "line.csv" }`; the process reads no others.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use axum::extract::{Path, State};
use axum::http::{HeaderMap, header};
use axum::response::IntoResponse;
use riffel_answers::page::{CaseText, check_bounds};
use riffel_answers::question::{AnyQuestion, Kind, known};
use riffel_keys::question::{of_json, without_null};
use riffel_keys::{Language, say};
use serde::Deserialize;
use serde_json::{Map, Value};

use crate::Page;
use crate::fault::{Fault, Refusal, file_is_gone};
use crate::request::{ClientId, JsonBytes};
use crate::uploads::{Sent, Uploads};
use crate::workspace::Workspace;

/// What the page asks about files, which may take long: one after the other.
const ABOUT_FILES: [&str; 5] = ["along", "measure", "noise", "report", "roughness"];
/// The question that is asked of each file for itself: a newer one does not take the place of an older.
const OF_EACH_FILE: &str = "roughness";

/// A file in a question.
#[derive(Deserialize)]
#[serde(untagged, deny_unknown_fields)]
enum FileOfPage {
    /// One that was sent, with its name to the user.
    Sent { upload: u32, name: String },
    /// Its text.
    Written { text: String, name: String },
}

pub(crate) async fn post(
    State(page): State<Page>,
    Path(name): Path<String>,
    client: ClientId,
    headers: HeaderMap,
    JsonBytes(json): JsonBytes,
) -> Result<impl IntoResponse, Refusal> {
    let question = known(&name).map_err(Fault::from)?;
    let keys = of_json(&json).map_err(Fault::bad)?;
    let language = headers.get(header::ACCEPT_LANGUAGE).and_then(|code| code.to_str().ok());
    let language = Language::ALL.iter().find(|one| Some(one.code()) == language).copied().unwrap_or_default();
    let sent = client.owner().and_then(|owner| page.uploads.of(&owner)).ok();
    let subject = client.subject(&name).filter(|_| name != OF_EACH_FILE);
    let (program, uploads) = (page.program.clone(), page.uploads.clone());
    // A file that is removed while the question waits still stands in it.
    let own = sent.clone();
    let placed = tokio::task::spawn_blocking(move || {
        check(question, &keys)?;
        placed(keys, own.as_deref(), &uploads)
    });
    let (keys, files) = placed.await.unwrap_or_else(|_| Err(Fault::defect(say!(the_computation_broke_off))))?;
    // Others take a minute at the most, and hold up neither the files nor the sliders.
    let queue = if ABOUT_FILES.contains(&&*name) { &page.long } else { &page.marches };
    let answer = queue
        .run(subject, move |cancel| {
            // The folder of the page stays as long as there is work in it.
            let _sent = sent;
            let printed = program.answer(files.path(), question.name(), &Value::Object(keys), language, cancel)?;
            let kind = if printed.starts_with('{') { "application/json" } else { "text/csv; charset=utf-8" };
            Ok(([(header::CONTENT_TYPE, kind)], printed))
        })
        .await?;
    Ok(answer)
}

/// `Ok` for a question within what the page computes that says no place to write to.
fn check(question: &dyn AnyQuestion, keys: &Map<String, Value>) -> Result<(), Fault> {
    // Results have this name also where it is no key of the question.
    let places = question.keys().iter().filter(|key| key.is_path && key.kind != Kind::File);
    let mut places = places.map(|key| key.name.as_str()).chain(["output"]);
    if let Some(place) = places.find(|place| keys.contains_key(*place)) {
        return Err(Fault::bad(say!(place_is_not_for_a_page, key = place)));
    }
    check_bounds(keys)?;
    // Its faults have the key of the form.
    if let Some(case @ Value::Object(_)) = keys.get("case") {
        let case = toml::Table::deserialize(without_null(case.clone()))
            .map_err(|error| Fault::misunderstood(&error.to_string()))?;
        CaseText::Keys(case).read()?;
    }
    Ok(())
}

/// A question with its files in a folder of its own.
fn placed(
    mut keys: Map<String, Value>,
    sent: Option<&Sent>,
    uploads: &Uploads,
) -> Result<(Map<String, Value>, Workspace), Fault> {
    let files = Workspace::within(sent.map_or(uploads.place(), Sent::folder), |_| false)?;
    let mut places = Places { sent, files: &files, of_uploads: BTreeMap::new() };
    keys.iter_mut().try_for_each(|(key, value)| places.put(key, value))?;
    Ok((keys, files))
}

/// The folder of a question, with the names of the uploads in it.
struct Places<'a> {
    sent: Option<&'a Sent>,
    files: &'a Workspace,
    of_uploads: BTreeMap<(u32, String), String>,
}

impl Places<'_> {
    /// Put a file of the page into the folder, and its name there in the place of what stands for it.
    fn put(&mut self, key: &str, value: &mut Value) -> Result<(), Fault> {
        if let Value::Array(list) = value {
            return list.iter_mut().try_for_each(|one| self.put(key, one));
        }
        let place = match FileOfPage::deserialize(&*value) {
            Ok(FileOfPage::Sent { upload, name }) => {
                let file = self.sent.ok_or_else(file_is_gone)?.file(upload)?;
                match self.of_uploads.entry((upload, name)) {
                    Entry::Occupied(there) => there.get().clone(),
                    Entry::Vacant(place) => {
                        let name = self.files.put(&file, &place.key().1)?;
                        place.insert(name).clone()
                    }
                }
            }
            Ok(FileOfPage::Written { text, name }) => self.files.put_text(&text, &name)?,
            Err(_) if value["name"].is_null() && (value["upload"].is_u64() || value["text"].is_string()) => {
                return Err(Fault::bad(say!(key_as_subject, key = format!("{key}.name"), rule = say!(is_missing))));
            }
            Err(_) => return Ok(()),
        };
        *value = place.into();
        Ok(())
    }
}
