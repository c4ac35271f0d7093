//! Where a network is roughest, told.

use riffel_keys::{Message, say};
use riffel_network::{Judgement, WorstPlace};
use serde::Serialize;

use super::words::{hundredths, kilometres, kind_in_words, millimetres, nothing, tenths};
use crate::number_alone;
use crate::{Answer, Rows, Table};

/// Sections that are rough, the worst first.
#[derive(Serialize)]
#[serde(transparent)]
pub struct WorstAnswer {
    places: Vec<WorstPlace>,
    #[serde(skip)]
    remarks: Vec<Message>,
}

impl WorstAnswer {
    /// Of places that were judged.
    pub fn new(places: Vec<WorstPlace>, judgement: &Judgement) -> Self {
        Self { places, remarks: judgement.remark().into_iter().map(Message::verbatim).collect() }
    }
}

impl Answer for WorstAnswer {
    fn name(&self) -> &'static str {
        "worst"
    }

    fn tables(&self) -> Vec<Table> {
        let places = &self.places;
        if places.is_empty() {
            return Vec::new();
        }
        let columns = vec![
            places.shown(say!(line_column), |place| Message::verbatim(&place.line)),
            places.shown(say!(date_column), |place| Message::verbatim(&place.date)),
            places.shown(say!(rail_word), |place| Message::verbatim(&place.rail)),
            places.shown(say!(from_kilometre_column), |place| kilometres(place.from_m)),
            places.shown(say!(to_kilometre_column), |place| kilometres(place.to_m)),
            places.shown(say!(band_column), |place| millimetres(place.band_m)),
            places.shown(say!(rms_column), |place| hundredths(1e6 * place.rms_m)),
            places.shown(say!(over_limit_column), |place| hundredths(place.rms_over_limit)),
            places.shown(say!(kind_column), |place| kind_in_words(place.kind)),
            places.shown(say!(decibels_a_year_column), |place| {
                place.growth_db_per_year.map_or_else(nothing, |growth| number_alone(tenths(growth)))
            }),
        ];
        vec![Table { name: "places", columns }]
    }

    fn sentences(&self) -> Vec<Message> {
        self.places.is_empty().then(|| say!(no_section_in_limited_band)).into_iter().collect()
    }

    fn remarks(&self) -> &[Message] {
        &self.remarks
    }
}
