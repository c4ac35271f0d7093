//! `POST /api/own-values`: the keys of a case that differ from presets and defaults, with what these give.

use std::collections::BTreeMap;

use riffel_case::OwnValue;
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
        let own = self.case.read()?.own_values().into_iter();
        let own = own.map(|OwnValue { key, without }| (key, without));
        Reply::json(&own.collect::<BTreeMap<String, toml::Value>>())
    }
}
