//! `POST /api/export/csv`: the map as the table of the program.

use crate::map::map_csv;
use riffel::GrowthMap;
use serde::Deserialize;

use crate::page::{CaseText, Fault, Reply};

#[derive(Deserialize)]
pub(crate) struct Question {
    case: CaseText,
}

impl crate::page::Question for Question {
    fn subject(&self) -> Option<String> {
        Some("table".to_owned())
    }

    fn answer(&self) -> Result<Reply, Fault> {
        let case = self.case.read()?;
        let (wavelength, speed) = (case.wavelength, case.speed);
        let map = GrowthMap::compute(&case.feedback, wavelength, speed, |_| ());
        let mut bytes = Vec::new();
        map_csv(&map, &mut bytes, |_| ())
            .map_err(|error| Fault::bad(format!("the table cannot be written: {error}")))?;
        Ok(Reply { content_type: "text/csv; charset=utf-8", attached: true, bytes })
    }
}
