//! Figures 2–8 of Afferrante & Ciavarella (2009), from the case files of the repository.

mod maps;
mod ridges;
mod vertical;

use riffel_case::{BHASKAR_TRACK_CASE, Case, NOMINAL_CASE};
use riffel_plot::LineFigure;

use crate::error::CliError;

/// A figure and its numbers.
pub(crate) struct PaperFigure {
    pub(crate) svg: String,
    pub(crate) csv: Vec<u8>,
}

/// Number in the paper and how it is made.
type Entry = (u8, fn() -> miette::Result<PaperFigure>);

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

fn nominal(overrides: &[String]) -> miette::Result<Case> {
    Ok(Case::parse("cases/nominal.toml", NOMINAL_CASE, overrides)?)
}

fn bhaskar_track(overrides: &[String]) -> miette::Result<Case> {
    Ok(Case::parse(
        "cases/bhaskar-track.toml",
        BHASKAR_TRACK_CASE,
        overrides,
    )?)
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
