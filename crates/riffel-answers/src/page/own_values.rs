//! `POST /api/own-values`: the keys of a case that differ from presets and defaults, with what these give.

use std::collections::BTreeMap;

use riffel_case::{OwnValue, own_values};
use serde::Deserialize;

use crate::page::{CaseText, Fault, Reply};

#[derive(Deserialize)]
pub(crate) struct Question {
    case: CaseText,
}

impl crate::page::Question for Question {
    fn subject(&self) -> Option<String> {
        Some("own-values".to_owned())
    }

    fn answer(&self) -> Result<Reply, Fault> {
        let own = own_values(&self.case.read()?).into_iter();
        let own = own.map(|OwnValue { key, without }| (key, without));
        Reply::json(&own.collect::<BTreeMap<String, toml::Value>>())
    }
}
