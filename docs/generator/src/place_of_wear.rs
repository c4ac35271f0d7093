//! The page of the book on rolling contact: its comparison of the readings of the place of wear.

use std::fs;

use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, OKABE_ITO, Series};
use riffel_validation::place_of_wear::{READINGS, Reading, TRACTIVE_RATIOS, table};

use crate::marked::between_marks;
use crate::{Outcome, root};

const PAGE: &str = "docs/src/rolling-contact.md";
const PICTURE: &str = "docs/src/images/place-of-wear.png";

/// The page with its generated part as it should be; the words around it are kept.
pub(crate) fn page() -> Result<String, String> {
    let page = fs::read_to_string(root().join(PAGE)).map_err(|error| format!("cannot read {PAGE}: {error}"))?;
    between_marks(PAGE, &page, "place of wear", &table())
}

/// Draw the figure of the page. Like the other pictures it is not compared.
pub(crate) fn picture() -> Outcome {
    crate::draw(PICTURE, &figure())
}

fn figure() -> LineFigure {
    LineFigure {
        title: "Ridge of growth by the place of wear, and by the exact contact".to_owned(),
        caption: "Nominal case, free rail; wavelengths of 20–80 mm. Left: frequency of the highest growth, left out \
                  where that sits at the edge of the window or nothing grows. Right: growth rate per passage on \
                  the ridge, positive where corrugation grows. exp(+iωt), braking positive."
            .to_owned(),
        panels: TRACTIVE_RATIOS.iter().flat_map(|&ratio| [frequency(ratio), growth(ratio)]).collect(),
        arrangement: Arrangement::SideBySide,
    }
}

fn frequency(ratio: f64) -> LinePanel {
    let value = |reading: &Reading| {
        let points = reading.ridge.points.iter();
        points
            .map(|point| match point.at_edge || point.normalized_dissipation > 0.0 {
                true => f64::NAN,
                false => point.frequency,
            })
            .collect()
    };
    LinePanel {
        y_label: "frequency of the ridge [Hz]".to_owned(),
        y_range: Some((0.0, 1200.0)),
        ..panel(ratio, &value)
    }
}

fn growth(ratio: f64) -> LinePanel {
    let value = |reading: &Reading| {
        let points = reading.ridge.points.iter();
        points.map(|point| 1e6 * point.growth_rate).collect()
    };
    let mut panel = panel(ratio, &value);
    // The panel beside it names them.
    for series in &mut panel.series {
        series.label.clear();
    }
    LinePanel { y_label: "growth per passage [10⁻⁶]".to_owned(), ..panel }
}

/// A curve for each contact over speed.
fn panel(ratio: f64, value: &dyn Fn(&Reading) -> Vec<f64>) -> LinePanel {
    use LineStyle::{Dashed, Dotted, Solid};
    let looks = [(Dashed, OKABE_ITO[1]), (Dotted, OKABE_ITO[2]), (Dashed, OKABE_ITO[3]), (Solid, OKABE_ITO[0])];
    let readings = READINGS.iter().filter(|reading| reading.tractive_ratio == ratio);
    LinePanel {
        subtitle: format!("τ = {ratio}"),
        x_label: "speed V [m/s]".to_owned(),
        x_range: Some((5.0, 60.0)),
        series: readings
            .zip(looks)
            .map(|(reading, (style, color))| Series {
                label: reading.contact.replace(['*', '`'], ""),
                x: reading.ridge.points.iter().map(|point| point.speed).collect(),
                y: value(reading),
                style,
                color: Some(color),
            })
            .collect(),
        ..LinePanel::default()
    }
}
