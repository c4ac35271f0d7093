//! Figures 2–8 of Afferrante & Ciavarella (2009), from the case files of the repository; with the
//! contact of the paper or another.

mod maps;
mod ridges;
mod vertical;

use riffel_case::{BHASKAR_TRACK_CASE, Case, NOMINAL_CASE};
use riffel_plot::LineFigure;

use crate::arguments::ModelArgument;
use crate::error::CliError;

/// A figure and its numbers.
pub(crate) struct PaperFigure {
    pub(crate) svg: String,
    pub(crate) csv: Vec<u8>,
}

/// Number in the paper and how it is made.
type Entry = (u8, fn(Model) -> miette::Result<PaperFigure>);

/// All figures, in order.
pub(crate) const FIGURES: [Entry; 7] = [
    (2, vertical::figure_2),
    (3, vertical::figure_3),
    (4, maps::figure_4),
    (5, maps::figure_5),
    (6, ridges::figure_6),
    (7, ridges::figure_7),
    (8, ridges::figure_8),
];

/// The contact of the figures: the paper's, or another in its place.
#[derive(Clone, Copy)]
pub(crate) struct Model(ModelArgument);

impl From<ModelArgument> for Model {
    fn from(argument: ModelArgument) -> Self {
        Self(argument)
    }
}

impl Model {
    fn nominal(self, overrides: &[String]) -> miette::Result<Case> {
        self.case("cases/nominal.toml", NOMINAL_CASE, overrides)
    }

    fn bhaskar_track(self, overrides: &[String]) -> miette::Result<Case> {
        self.case("cases/bhaskar-track.toml", BHASKAR_TRACK_CASE, overrides)
    }

    fn case(self, name: &str, text: &str, overrides: &[String]) -> miette::Result<Case> {
        let response = match self.0 {
            ModelArgument::QuasiStatic => None,
            ModelArgument::SpringDashpot => Some("contact.response=spring-dashpot".to_owned()),
            ModelArgument::NonSteady => Some("contact.response=non-steady".to_owned()),
        };
        let overrides: Vec<String> = overrides.iter().cloned().chain(response).collect();
        Ok(Case::parse(name, text, &overrides)?)
    }

    /// The title of a figure, with the contact where it is not the paper's.
    fn title(self, title: &str) -> String {
        let contact = match self.0 {
            ModelArgument::QuasiStatic => "",
            ModelArgument::SpringDashpot => ", spring and dashpot",
            ModelArgument::NonSteady => ", non-steady contact",
        };
        format!("{title}{contact}")
    }

    /// Whether the contact is that of the paper.
    fn is_the_papers(self) -> bool {
        self.0 == ModelArgument::QuasiStatic
    }

    /// Whether a table of the contact's response must be made for each mean state.
    fn is_tabulated(self) -> bool {
        self.0 == ModelArgument::NonSteady
    }
}

/// Curves with every sample in one tidy table.
fn lines(figure: &LineFigure) -> miette::Result<PaperFigure> {
    let svg = figure.svg().map_err(CliError::from)?;
    let mut writer = csv::Writer::from_writer(Vec::new());
    let mut write = || -> csv::Result<()> {
        writer.write_record(["panel", "series", "x_quantity", "x", "y_quantity", "y"])?;
        for panel in &figure.panels {
            for series in &panel.series {
                for (x, y) in series.x.iter().zip(&series.y) {
                    writer.serialize((
                        &panel.subtitle,
                        &series.label,
                        &panel.x_label,
                        x,
                        &panel.y_label,
                        y,
                    ))?;
                }
            }
        }
        Ok(())
    };
    write().map_err(|error| CliError::Table(error.to_string()))?;
    let csv = writer
        .into_inner()
        .map_err(|error| CliError::Table(error.to_string()))?;
    Ok(PaperFigure { svg, csv })
}
