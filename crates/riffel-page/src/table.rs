//! `POST /api/export/csv`: the map as the table of the program.

use riffel::GrowthMap;
use riffel_answers::map::map_csv;
use serde::Deserialize;

use crate::{CaseText, Fault, Reply, Wanted};

#[derive(Deserialize)]
pub(crate) struct Question {
    case: CaseText,
}

impl crate::Question for Question {
    fn subject(&self) -> Option<String> {
        Some("table".to_owned())
    }

    fn answer(&self, wanted: Wanted) -> Result<Reply, Fault> {
        let case = self.case.read()?;
        let (wavelength, speed) = (case.wavelength, case.speed);
        let map = GrowthMap::compute_while(&case.feedback, wavelength, speed, wanted, |_| ());
        let mut bytes = Vec::new();
        map_csv(&map, &mut bytes, |_| ())
            .map_err(|error| Fault::bad(format!("the table cannot be written: {error}")))?;
        Ok(Reply {
            content_type: "text/csv; charset=utf-8",
            attached: true,
            bytes,
        })
    }
}
