//! All surveys of lines, told.

use riffel_keys::{Message, number, say};
use riffel_network::{ChartedLine, ChartedSection, ChartedSurvey, StripChart};
use serde::Serialize;

use super::words::{hundredths, kilometres, nothing, shown};
use crate::{Answer, Column, ResultFile, Table};

/// Sections of every survey of lines.
#[derive(Serialize)]
#[serde(transparent)]
pub struct ChartAnswer {
    chart: StripChart,
    #[serde(skip)]
    remarks: Vec<Message>,
}

impl ChartAnswer {
    /// Of a chart.
    pub fn new(chart: StripChart) -> Self {
        let left_out = chart.lines_not_drawn();
        let remark = (left_out > 0).then(|| say!(lines_are_not_drawn, count = number(left_out)));
        Self { chart, remarks: remark.into_iter().collect() }
    }

    /// Every survey with its line.
    fn surveys(&self) -> impl Iterator<Item = (&ChartedLine, &ChartedSurvey)> {
        self.chart.lines.iter().flat_map(|line| line.surveys.iter().map(move |survey| (line, survey)))
    }

    /// What a reader sees: one row for each survey.
    fn shown(&self) -> Table {
        let surveys: Vec<_> = self.surveys().collect();
        let worst = |survey: &ChartedSurvey, of: &dyn Fn(&ChartedSection) -> Message| {
            let sections = survey.sections.iter();
            let worst = sections.max_by(|one, other| one.rms_over_limit.total_cmp(&other.rms_over_limit));
            worst.map_or_else(nothing, of)
        };
        Table {
            name: "surveys",
            columns: vec![
                shown(say!(line_column), &surveys, |(line, _)| Message::verbatim(&line.line)),
                shown(say!(date_column), &surveys, |(_, survey)| Message::verbatim(&survey.date)),
                shown(say!(kilometres_column), &surveys, |(_, survey)| length(survey, f64::NEG_INFINITY)),
                shown(say!(kilometres_over_limit_column), &surveys, |(_, survey)| length(survey, 1.0)),
                shown(say!(worst_column), &surveys, |(_, survey)| {
                    worst(survey, &|section| hundredths(section.rms_over_limit))
                }),
                shown(say!(at_kilometre_column), &surveys, |(_, survey)| {
                    worst(survey, &|section| kilometres(section.from_m))
                }),
            ],
        }
    }

    /// One row for each section of each survey.
    fn sections(&self) -> Table {
        let rows: Vec<_> = self
            .surveys()
            .flat_map(|(line, survey)| survey.sections.iter().map(move |section| (line, survey, section)))
            .collect();
        let rows = || rows.iter();
        let number =
            |name: &str, of: fn(&ChartedSection) -> f64| Column::exact(name, rows().map(|(_, _, section)| of(section)));
        Table {
            name: self.name(),
            columns: vec![
                Column::names("line", rows().map(|(line, ..)| &line.line)),
                Column::names("date", rows().map(|(_, survey, _)| &survey.date)),
                number("from_m", |section| section.from_m),
                number("to_m", |section| section.to_m),
                Column::names("rail", rows().map(|(_, _, section)| &section.rail)),
                number("band_from_m", |section| section.band_m[0]),
                number("band_to_m", |section| section.band_m[1]),
                number("rms_m", |section| section.rms_m),
                number("rms_over_limit", |section| section.rms_over_limit),
            ],
        }
    }
}

/// Kilometres of the sections of a survey that are over a ratio to the limit.
fn length(survey: &ChartedSurvey, ratio: f64) -> Message {
    let sections = survey.sections.iter().filter(|section| section.rms_over_limit > ratio);
    kilometres(sections.fold(0.0, |sum, section| sum + section.to_m - section.from_m))
}

impl Answer for ChartAnswer {
    fn name(&self) -> &'static str {
        "chart"
    }

    fn introduction(&self) -> Vec<Message> {
        self.chart.lines.is_empty().then(|| say!(no_survey_in_store)).into_iter().collect()
    }

    fn tables(&self) -> Vec<Table> {
        match self.has_files() {
            true => vec![self.shown(), self.sections()],
            false => Vec::new(),
        }
    }

    fn has_files(&self) -> bool {
        !self.chart.lines.is_empty()
    }

    fn files(&self) -> Vec<ResultFile<'_>> {
        vec![ResultFile::Strips(self.name(), self.chart.figure()), ResultFile::Table(self.sections())]
    }

    fn remarks(&self) -> &[Message] {
        &self.remarks
    }
}
