//! `POST /api/stability`: where over speed and friction the loop oscillates without any profile.

use crate::Answer as _;
use crate::stability_map::StabilityMap;
use riffel_keys::Message;
use serde::{Deserialize, Serialize};

use crate::page::{CaseText, Fault, Reply};

#[derive(Deserialize)]
pub(crate) struct Question {
    case: CaseText,
}

#[derive(Serialize)]
struct Answer<'a> {
    #[serde(flatten)]
    map: &'a StabilityMap,
    sentences: Vec<Message>,
    notes: &'a [Message],
}

impl crate::page::Question for Question {
    fn subject(&self) -> Option<String> {
        Some("stability".to_owned())
    }

    fn answer(&self) -> Result<Reply, Fault> {
        let case = self.case.read()?;
        let map = StabilityMap::new(&case, &StabilityMap::frictions(), &|_| ())?;
        Reply::json(&Answer { sentences: map.sentences(), notes: &map.remarks, map: &map })
    }
}
