//! Growth of the sections of a network, told.

use riffel_keys::{Message, number, range, say};
use riffel_network::{Judgement, SectionGrowth};
use serde::Serialize;

use super::words::{hundredths, kilometres, kind_in_words, millimetres, nothing, tenths};
use crate::number_alone;
use crate::{Answer, Rows, Table};

/// Sections over their surveys.
#[derive(Serialize)]
#[serde(transparent)]
pub struct GrowthAnswer {
    sections: Vec<SectionGrowth>,
    #[serde(skip)]
    remarks: Vec<Message>,
}

impl GrowthAnswer {
    /// Of sections that were judged, and what was left out of them.
    pub fn new(sections: Vec<SectionGrowth>, judgement: &Judgement, left_out: Vec<String>) -> Self {
        let remarks = judgement.remark().into_iter().chain(left_out);
        Self { sections, remarks: remarks.map(Message::verbatim).collect() }
    }
}

fn growth(section: &SectionGrowth) -> Message {
    match (section.growth_db_per_year, section.growth_error_db_per_year) {
        (None, _) => nothing(),
        _ if section.ground => say!(kind_ground),
        (Some(growth), Some(error)) => number_alone(format!("{} ± {error:.1}", tenths(growth))),
        (Some(growth), None) => number_alone(tenths(growth)),
    }
}

/// Until the limit is reached, and between what months: "9.1–14.2", "more than 9.1" where there may be no end.
fn months(section: &SectionGrowth) -> Message {
    let Some(months) = section.months_to_limit else {
        return match section.ground {
            true => say!(growth_not_known),
            false => say!(no_growth_in_table),
        };
    };
    let (middle, tenth) = (number(format!("{months:.1}")), |months: f64| format!("{months:.1}"));
    match (months > 0.0, section.months_to_limit_band_80) {
        (true, Some([early, late])) if late.is_finite() => {
            number_alone(format!("{months:.1} ({})", range([early, late], tenth)))
        }
        (true, Some([early, _])) => say!(months_or_more, months = middle, early = number(tenth(early))),
        (true, None) => say!(number_alone, number = middle),
        (false, _) => say!(over_its_limit),
    }
}

impl Answer for GrowthAnswer {
    fn name(&self) -> &'static str {
        "growth"
    }

    fn tables(&self) -> Vec<Table> {
        let sections = &self.sections;
        let mut columns = vec![
            sections.shown(say!(line_column), |section| Message::verbatim(&section.line)),
            sections.shown(say!(rail_word), |section| Message::verbatim(&section.rail)),
            sections.shown(say!(from_kilometre_column), |section| kilometres(section.from_m)),
            sections.shown(say!(to_kilometre_column), |section| kilometres(section.to_m)),
            sections.shown(say!(band_column), |section| millimetres(section.band_m)),
            sections.shown(say!(between_column), |section| Message::verbatim(section.dates.join(" "))),
            sections.shown(say!(rms_column), |section| {
                let [before, after] = section.rms_m.map(|rms| 1e6 * rms);
                number_alone(format!("{before:.2} → {after:.2}"))
            }),
            sections.shown(say!(decibels_a_year_column), growth),
            sections.numbers(say!(surveys_column), |section| section.surveys),
            sections.shown(say!(over_limit_column), |section| hundredths(section.rms_over_limit)),
            sections.shown(say!(kind_column), |section| kind_in_words(section.kind)),
            sections.shown(say!(months_to_limit_column), months),
        ];
        if sections.iter().any(|section| section.expected_growth_db_per_year.is_some()) {
            columns.push(sections.shown(say!(expected_growth_column), |section| {
                section.expected_growth_db_per_year.map_or_else(nothing, |expected| {
                    let [low, high] = expected.band_80.map(|end| number(tenths(end)));
                    say!(middle_from_to, middle = number(tenths(expected.median)), from = low, to = high)
                })
            }));
        }
        vec![Table { name: "sections", columns }]
    }

    fn remarks(&self) -> &[Message] {
        &self.remarks
    }
}
