//! All surveys of lines, told.

use riffel_keys::{Message, number, say};
use riffel_network::{ChartedLine, ChartedSection, ChartedSurvey, StripChart};
use serde::Serialize;

use super::words::{hundredths, kilometres, nothing};
use crate::{Answer, ResultFile, Rows, Table};

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
                surveys.shown(say!(line_column), |(line, _)| Message::verbatim(&line.line)),
                surveys.shown(say!(date_column), |(_, survey)| Message::verbatim(&survey.date)),
                surveys.shown(say!(kilometres_column), |(_, survey)| length(survey, f64::NEG_INFINITY)),
                surveys.shown(say!(kilometres_over_limit_column), |(_, survey)| length(survey, 1.0)),
                surveys.shown(say!(worst_column), |(_, survey)| {
                    worst(survey, &|section| hundredths(section.rms_over_limit))
                }),
                surveys.shown(say!(at_kilometre_column), |(_, survey)| {
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
        Table {
            name: self.name(),
            columns: vec![
                rows.names("line", |(line, ..)| &line.line),
                rows.names("date", |(_, survey, _)| &survey.date),
                rows.exact("from_m", |(_, _, section)| section.from_m),
                rows.exact("to_m", |(_, _, section)| section.to_m),
                rows.names("rail", |(_, _, section)| &section.rail),
                rows.exact("band_from_m", |(_, _, section)| section.band_m[0]),
                rows.exact("band_to_m", |(_, _, section)| section.band_m[1]),
                rows.exact("rms_m", |(_, _, section)| section.rms_m),
                rows.exact("rms_over_limit", |(_, _, section)| section.rms_over_limit),
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
