//! All surveys of lines, kilometre by date.

use rayon::prelude::*;
use riffel_plot::{ChainageUnit, Rgb, Strip, StripClass, StripFigure, StripPanel, StripRow};
use serde::Serialize;

use crate::alignment::Alignment;
use crate::judgement::SectionInBand;
use crate::record::SurveyRecord;
use crate::{Judgement, NetworkError, Sections, Store};

/// Lines that a picture holds; others are in the table.
const MOST_LINES: usize = 12;
/// Ends of the classes of RMS over limit, and their colours: blues below the limit, yellow to red above it.
const CLASSES: [(f64, Rgb); 6] = [
    (0.5, Rgb(222, 235, 247)),
    (0.8, Rgb(158, 202, 225)),
    (1.0, Rgb(66, 146, 198)),
    (1.5, Rgb(254, 204, 92)),
    (2.0, Rgb(240, 120, 40)),
    (f64::INFINITY, Rgb(165, 15, 21)),
];

/// Sections of every survey of lines, each as far over its limit as its worst rail is.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StripChart {
    /// Name of the limit table.
    pub limit: String,
    /// Length of a section \[m\].
    pub section_m: f64,
    /// The lines by name.
    pub lines: Vec<ChartedLine>,
}

/// The surveys of a line.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ChartedLine {
    /// The line.
    pub line: String,
    /// By date.
    pub surveys: Vec<ChartedSurvey>,
}

/// A survey of a line.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ChartedSurvey {
    /// The day.
    pub date: String,
    /// Along the line.
    pub sections: Vec<ChartedSection>,
}

/// A section of a survey.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ChartedSection {
    /// First place \[m\].
    pub from_m: f64,
    /// Last place \[m\].
    pub to_m: f64,
    /// The rail that is farthest over its limit.
    pub rail: String,
    /// The band in which it is \[m\].
    pub band_m: [f64; 2],
    /// RMS in it \[m\].
    pub rms_m: f64,
    /// RMS over limit.
    pub rms_over_limit: f64,
}

impl StripChart {
    /// Sections of some length \[m\] of all surveys of all lines, or of one, of all rails, or of one. On all cores, a survey on
    /// each. Memory: a row for each section of each survey.
    ///
    /// # Errors
    /// Errors of the files; [`NetworkError::Value`] for a line or rail that the store does not have, and a section shorter than a
    /// cell.
    pub fn new(
        store: &Store,
        judgement: &Judgement,
        length: f64,
        line: Option<&str>,
        rail: Option<&str>,
    ) -> Result<Self, NetworkError> {
        let surveys = store.surveys()?;
        let is_of_line = |survey: &&SurveyRecord| line.is_none_or(|line| survey.line == line);
        let of_line: Vec<&SurveyRecord> = surveys.iter().filter(is_of_line).collect();
        if let Some(line) = line.filter(|_| of_line.is_empty()) {
            let known = surveys.iter().map(|survey| survey.line.as_str());
            return Err(NetworkError::not_there("the line", line, known));
        }
        let rails = || of_line.iter().flat_map(|survey| &survey.rails);
        if let Some(rail) = rail.filter(|rail| rails().all(|known| known.name != *rail)) {
            let known = rails().map(|rail| rail.name.as_str());
            return Err(NetworkError::not_there("the rail", rail, known));
        }
        let charted: Result<Vec<ChartedSurvey>, NetworkError> =
            of_line.par_iter().map(|survey| charted(store, survey, judgement, length, rail)).collect();
        let mut lines: Vec<ChartedLine> = Vec::new();
        for (survey, charted) in of_line.iter().zip(charted?) {
            match lines.last_mut().filter(|last| last.line == survey.line) {
                Some(last) => last.surveys.push(charted),
                None => lines.push(ChartedLine { line: survey.line.clone(), surveys: vec![charted] }),
            }
        }
        Ok(Self { limit: judgement.limit.clone(), section_m: length, lines })
    }

    /// Lines that the picture leaves out.
    pub fn lines_not_drawn(&self) -> usize {
        self.lines.len().saturating_sub(MOST_LINES)
    }

    /// A panel for each line, the latest survey at its foot; the longest twelve lines, in the order of their names.
    pub fn figure(&self) -> StripFigure {
        let mut drawn: Vec<&ChartedLine> = self.lines.iter().collect();
        let sections = |line: &ChartedLine| -> usize {
            let surveys = line.surveys.iter();
            surveys.map(|survey| survey.sections.len()).max().unwrap_or(0)
        };
        drawn.sort_by_key(|line| std::cmp::Reverse(sections(line)));
        drawn.truncate(MOST_LINES);
        drawn.sort_by(|one, other| one.line.cmp(&other.line));
        let mut from = 0.0;
        let classes = CLASSES.map(|(to, color)| {
            let label = match (from, to) {
                (0.0, to) => format!("up to {to:.1}"),
                (from, to) if to.is_infinite() => format!("above {from:.1}"),
                (from, to) => format!("{from:.1}–{to:.1}"),
            };
            from = to;
            StripClass { label, to, color }
        });
        StripFigure {
            title: "Roughness along the lines, survey by survey".to_owned(),
            caption: format!(
                "RMS over the limit \"{}\" in the worst band of the worst rail, in sections of {} m; white is not measured. Of \
                 sections narrower than a pixel the worst is drawn.",
                self.limit, self.section_m
            ),
            classes: classes.to_vec(),
            panels: drawn.into_iter().map(panel).collect(),
        }
    }
}

fn panel(line: &ChartedLine) -> StripPanel {
    let sections = line.surveys.iter().flat_map(|survey| &survey.sections);
    let unit = ChainageUnit::suiting(sections.map(|section| section.to_m));
    let strip = |section: &ChartedSection| Strip {
        from: unit.of(section.from_m),
        to: unit.of(section.to_m),
        value: section.rms_over_limit,
    };
    StripPanel {
        subtitle: line.line.clone(),
        x_label: unit.axis_label().to_owned(),
        rows: line
            .surveys
            .iter()
            .map(|survey| StripRow { label: survey.date.clone(), strips: survey.sections.iter().map(strip).collect() })
            .collect(),
    }
}

/// The worst rail of each section of a survey.
fn charted(
    store: &Store,
    survey: &SurveyRecord,
    judgement: &Judgement,
    length: f64,
    rail: Option<&str>,
) -> Result<ChartedSurvey, NetworkError> {
    let mut worst = std::collections::BTreeMap::new();
    for record in survey.rails.iter().filter(|one| rail.is_none_or(|rail| one.name == rail)) {
        let (share, here) = (judgement.share, Alignment::default());
        let sections = Sections::placed(store, survey, record, length, share, &here, None)?;
        for section in sections.sections {
            let Some(SectionInBand { band, ratio, .. }) = judgement.worst(&section) else {
                continue;
            };
            let charted = ChartedSection {
                from_m: section.from,
                to_m: section.to,
                rail: record.name.clone(),
                band_m: judgement.ends(band),
                rms_m: section.rms[band],
                rms_over_limit: ratio,
            };
            let known = worst.entry(section.index).or_insert_with(|| charted.clone());
            if known.rms_over_limit < ratio {
                *known = charted;
            }
        }
    }
    Ok(ChartedSurvey { date: survey.date.to_string(), sections: worst.into_values().collect() })
}
