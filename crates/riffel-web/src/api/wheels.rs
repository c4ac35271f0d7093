//! `POST /api/curve/wheels`: growth of a case under every wheel of the bogie in its curve.

use std::collections::BTreeMap;

use axum::extract::State;
use riffel_answers::wheels::WheelsAnswer;
use riffel_case::Case;
use riffel_keys::CaseError;
use riffel_page::CaseText;
use serde::Deserialize;
use serde_json::{Value, json};

use super::curve;
use crate::Page;
use crate::fault::{Fault, Refusal};
use crate::queue::Wanted;
use crate::request::{Asked, Asker};
use crate::told::Told;
use crate::uploads::Uploads;

/// The curve in `folder` of a question.
const FILE: &str = "curve.toml";

#[derive(Deserialize)]
pub(crate) struct Question {
    #[serde(flatten)]
    curve: curve::Question,
    case: CaseText,
}

pub(crate) async fn post(
    State(page): State<Page>,
    asker: Asker,
    Asked(question): Asked<Question>,
) -> Result<Told<Value>, Refusal> {
    question.curve.check()?;
    let uploads = page.uploads.clone();
    page.queue
        .run(asker.subject("wheels"), move |wanted| {
            question.answer(wanted, &uploads)
        })
        .await
}

impl Question {
    fn answer(&self, wanted: &Wanted, uploads: &Uploads) -> Result<Told<Value>, Fault> {
        let case = self.case.read()?;
        let folder = curve::place(uploads)?;
        let paths = self.curve.put(folder.path())?;
        let named = |fault: Fault| fault.in_words(|words| self.curve.named(words, &paths));
        let of_case = |error: CaseError| named(error.into());
        let curving = self.curve.curving(&paths).map_err(of_case)?;
        curve::store(&folder.path().join(FILE), &curving.toml())?;
        let case = case.on_curve(folder.path(), FILE).map_err(of_case)?;
        if !wanted.still() {
            return Err(Fault::superseded());
        }
        let answer = WheelsAnswer::new(&case, |_| ()).map_err(|error| named(error.into()))?;
        let mut document = json!(answer.document(&case));
        // The case with its wheel is the question.
        document
            .as_object_mut()
            .map(|document| document.remove("inputs"));
        for (wheel, told) in answer
            .wheels
            .iter()
            .zip(document["wheels"].as_array_mut().into_iter().flatten())
        {
            let Ok(growth) = &wheel.growth else { continue };
            let keys = growth.case.keys_of_curve().map_err(of_case)?;
            told["keys"] = json!(keys.into_iter().collect::<BTreeMap<_, _>>());
        }
        document["give_way"] = json!(Case::keys_that_give_way().collect::<Vec<_>>());
        self.curve.name(&mut document, &paths);
        Ok(Told(document))
    }
}
