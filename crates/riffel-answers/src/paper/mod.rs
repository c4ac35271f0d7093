//! Figures 2–8 of Afferrante & Ciavarella (2009), from the case files of the repository; with the
//! contact of the paper or another.

mod maps;
mod ridges;
mod vertical;

#[cfg(not(target_family = "wasm"))]
use riffel_case::file::{CaseFile, ContactDynamics};
use riffel_case::{BHASKAR_TRACK_CASE, Case, NOMINAL_CASE};
use riffel_keys::{Language, say};
use riffel_plot::{LineFigure, MapFigure, Picture, PlotError};

use crate::{Result, Rows, Table};

/// A figure and its numbers.
pub struct PaperFigure {
    /// What is drawn.
    pub drawing: Drawing,
    /// Its numbers.
    pub table: Table,
}

/// What a figure is.
pub enum Drawing {
    /// Maps.
    Maps(MapFigure),
    /// Curves.
    Lines(LineFigure),
}

#[cfg(not(target_family = "wasm"))]
impl PaperFigure {
    /// The figure as a picture.
    ///
    /// # Errors
    /// [`PlotError`].
    pub fn picture(&self) -> Result<Picture, PlotError> {
        match &self.drawing {
            Drawing::Maps(figure) => figure.picture(),
            Drawing::Lines(figure) => figure.picture(),
        }
    }
}

/// Number in the paper and how it is made, with its words in a language.
pub type Entry = (u8, fn(Model, Language) -> Result<PaperFigure>);

/// All figures, in order.
pub const FIGURES: [Entry; 7] = [
    (2, vertical::figure_2),
    (3, vertical::figure_3),
    (4, maps::figure_4),
    (5, maps::figure_5),
    (6, ridges::figure_6),
    (7, ridges::figure_7),
    (8, ridges::figure_8),
];

/// The contact of the figures: how it answers to oscillations.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Model {
    /// At once, by the paper's creep law: the figures as printed.
    QuasiStatic,
    /// By a spring and a dashpot in series, with the paper's creep law.
    SpringDashpot,
    /// By the exact theory of non-steady rolling.
    NonSteady,
}

impl Model {
    fn nominal(self, change: impl FnOnce(&mut CaseFile)) -> Result<Case> {
        self.case("cases/nominal.toml", NOMINAL_CASE, change)
    }

    fn bhaskar_track(self, change: impl FnOnce(&mut CaseFile)) -> Result<Case> {
        self.case("cases/bhaskar-track.toml", BHASKAR_TRACK_CASE, change)
    }

    fn case(self, name: &str, text: &str, change: impl FnOnce(&mut CaseFile)) -> Result<Case> {
        let case = Case::parse(name, text, &[])?;
        Ok(case.edit(|keys| {
            change(keys);
            match self {
                Self::QuasiStatic => {}
                Self::SpringDashpot => keys.contact.response = ContactDynamics::SpringDashpot,
                Self::NonSteady => keys.contact.response = ContactDynamics::NonSteady,
            }
        })?)
    }

    /// The title of a figure, with the contact where it is not the paper's.
    fn title(self, title: &str, language: Language) -> String {
        let contact = match self {
            Self::QuasiStatic => String::new(),
            Self::SpringDashpot => say!(plus_spring_and_dashpot).text(language),
            Self::NonSteady => say!(plus_non_steady).text(language),
        };
        format!("{title}{contact}")
    }

    /// Whether the contact is that of the paper.
    fn is_the_papers(self) -> bool {
        self == Self::QuasiStatic
    }

    /// Whether a table of the contact's response must be made for each mean state.
    fn is_tabulated(self) -> bool {
        self == Self::NonSteady
    }
}

/// Curves with every sample in one tidy table.
fn lines(language: Language, mut figure: LineFigure) -> PaperFigure {
    figure.title = language.numbers(&figure.title);
    figure.caption = language.numbers(&figure.caption);
    for panel in &mut figure.panels {
        panel.subtitle = language.numbers(&panel.subtitle);
        for series in &mut panel.series {
            series.label = language.numbers(&series.label);
        }
    }
    let samples = figure.panels.iter().flat_map(|panel| {
        panel.series.iter().flat_map(move |series| {
            let samples = series.x.iter().zip(&series.y);
            samples.map(move |(x, y)| (panel, series, *x, *y))
        })
    });
    let samples: Vec<_> = samples.collect();
    let table = Table {
        name: "figure",
        columns: vec![
            samples.names("panel", |(panel, ..)| &panel.subtitle),
            samples.names("series", |(_, series, ..)| &series.label),
            samples.names("x_quantity", |(panel, ..)| &panel.x_label),
            samples.exact("x", |(.., x, _)| *x),
            samples.names("y_quantity", |(panel, ..)| &panel.y_label),
            samples.exact("y", |(.., y)| *y),
        ],
    };
    PaperFigure { table, drawing: Drawing::Lines(figure) }
}
