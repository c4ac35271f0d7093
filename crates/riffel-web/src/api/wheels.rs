//! `POST /api/curve/wheels`: growth of a case under every wheel of the bogie in its curve.

use riffel_case::{Case, keys_of_curve, keys_that_give_way, on_curve};
use std::collections::BTreeMap;
use std::path::Path;

use axum::extract::State;
use riffel_answers::page::CaseText;
use riffel_answers::wheels::WheelsAnswer;
use riffel_keys::message::as_data;
use riffel_keys::text_file::with_texts;
use serde::Deserialize;
use serde_json::{Value, json};

use super::curve;
use crate::Page;
use crate::fault::{Fault, Refusal};
use crate::json_with_messages::JsonWithMessages;
use crate::request::{ClientId, Json};

#[derive(Deserialize)]
pub(crate) struct Question {
    #[serde(flatten)]
    curve: curve::Question,
    case: CaseText,
}

pub(crate) async fn post(
    State(page): State<Page>,
    client: ClientId,
    Json(question): Json<Question>,
) -> Result<JsonWithMessages<Value>, Refusal> {
    question.curve.check()?;
    page.queue.run(client.subject("wheels"), move |_| question.answer()).await
}

impl Question {
    fn answer(&self) -> Result<JsonWithMessages<Value>, Fault> {
        let case = self.case.read()?;
        let curve = (curve::NAME.to_owned(), self.curve.curving()?.toml());
        let texts = self.curve.texts().into_iter().chain([curve]);
        with_texts(texts, || Self::of_case(&case))
    }

    /// The answer for a case, while the curve and its profiles can be read.
    fn of_case(case: &Case) -> Result<JsonWithMessages<Value>, Fault> {
        let case = on_curve(case, Path::new(""), curve::NAME)?;
        let answer = WheelsAnswer::new(&case, |_| ())?;
        // Its messages too are data, of which the page makes words in its language.
        let mut document = as_data(|| json!(answer));
        // The case with its wheel is the question.
        document.as_object_mut().map(|document| document.remove("inputs"));
        for (wheel, told) in answer.wheels.iter().zip(document["wheels"].as_array_mut().into_iter().flatten()) {
            let Some(in_loop) = &wheel.in_loop else {
                continue;
            };
            let keys = keys_of_curve(&in_loop.case)?;
            told["keys"] = json!(keys.into_iter().collect::<BTreeMap<_, _>>());
        }
        document["give_way"] = json!(keys_that_give_way().collect::<Vec<_>>());
        Ok(JsonWithMessages(document))
    }
}
