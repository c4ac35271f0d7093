//! The page of the book on decay rates: its tables and its figure.

use std::fs;

use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, Rgb, Scale, Series};
use riffel_validation::decay_rate::{FIT, MEASUREMENT, MeasuredBand, fit_in_words, table_by_assumption, table_by_band};

use crate::marked::between_marks;
use crate::{Outcome, root};

const PAGE: &str = "docs/src/decay-rate.md";
const PICTURE: &str = "docs/src/images/decay-rate.png";

/// Lower limit of the vertical decay rate \[dB/m\] of a track for type tests, from 250 Hz by band:
/// ISO 3095:2013, Figure 3.
const LIMIT: [f64; 14] = [2.0, 2.0, 6.0, 6.0, 6.0, 2.19, 0.8, 0.8, 0.8, 0.8, 0.8, 0.8, 0.8, 0.8];

const GREY: Rgb = Rgb(200, 200, 200);
const BLUE: Rgb = Rgb(0, 114, 178);
const VERMILION: Rgb = Rgb(213, 94, 0);

/// The page with its generated parts as they should be; the words between them are kept.
pub(crate) fn page() -> Result<String, String> {
    let page = fs::read_to_string(root().join(PAGE)).map_err(|error| format!("cannot read {PAGE}: {error}"))?;
    let parts = [("fit", fit_in_words()), ("by band", table_by_band()), ("by assumption", table_by_assumption())];
    parts.iter().try_fold(page, |page, (name, text)| between_marks(PAGE, &page, name, text))
}

/// Draw the figure of the page. Like the picture of the README it is not compared.
pub(crate) fn picture() -> Outcome {
    crate::draw(PICTURE, &figure())
}

fn figure() -> LineFigure {
    LineFigure {
        title: "Track decay rate, vertical: Niederwangen and a fitted track".to_owned(),
        caption: format!(
            "Measured: {} curves without rail dampers, 2012–2015 (CC0-1.0). Computed: 60E1 rail every 0.6 m on \
             sleepers of 145 kg; fitted pads of {:.0} MN/m, loss factor {:.2}. One-third octaves of EN 15461, \
             force in mid-span.",
            MEASUREMENT.curves.len(),
            FIT.pad_stiffness / 1e6,
            FIT.pad_loss_factor
        ),
        panels: vec![decay_rates(), residuals()],
        arrangement: Arrangement::Stacked,
    }
}

fn decay_rates() -> LinePanel {
    let mut series: Vec<Series> = MEASUREMENT
        .curves
        .iter()
        .enumerate()
        .map(|(index, curve)| {
            let name = if index == 0 { "measured" } else { "" };
            line(name, curve.clone(), LineStyle::Solid, GREY)
        })
        .collect();
    let quartile = |index: usize| by_band(|band| band.quartiles[index]);
    let limited = frequencies().len() - LIMIT.len();
    series.extend([
        line("quartiles", quartile(1), LineStyle::Dotted, BLUE),
        line("", quartile(3), LineStyle::Dotted, BLUE),
        line("median", quartile(2), LineStyle::Solid, BLUE),
        Series {
            x: frequencies().split_off(limited),
            ..line("ISO 3095 limit", LIMIT.to_vec(), LineStyle::Dashed, Rgb::BLACK)
        },
        line("computed", FIT.decay_rates.clone(), LineStyle::Solid, VERMILION),
    ]);
    LinePanel {
        y_label: "decay rate [dB/m]".to_owned(),
        y_scale: Scale::Log,
        y_range: Some((0.1, 100.0)),
        series,
        ..over_frequency()
    }
}

fn residuals() -> LinePanel {
    let level = |index: usize| by_band(|band| band.level(band.quartiles[index]));
    let computed = MEASUREMENT.bands.iter().zip(&FIT.decay_rates);
    let computed = computed.map(|(band, &rate)| band.level(rate)).collect();
    LinePanel {
        y_label: "10 lg(rate/median) [dB]".to_owned(),
        y_range: Some((-6.0, 6.0)),
        series: vec![
            line("", level(2), LineStyle::Solid, BLUE),
            line("quartiles", level(1), LineStyle::Dotted, BLUE),
            line("", level(3), LineStyle::Dotted, BLUE),
            line("computed", computed, LineStyle::Markers, VERMILION),
        ],
        ..over_frequency()
    }
}

fn over_frequency() -> LinePanel {
    LinePanel {
        x_label: "one-third octave f [Hz]".to_owned(),
        x_scale: Scale::Log,
        x_range: Some((90.0, 5600.0)),
        ..LinePanel::default()
    }
}

fn line(label: &str, y: Vec<f64>, style: LineStyle, color: Rgb) -> Series {
    Series { label: label.to_owned(), x: frequencies(), y, style, color: Some(color) }
}

fn frequencies() -> Vec<f64> {
    by_band(|band| band.nominal_frequency)
}

fn by_band(value: impl Fn(&MeasuredBand) -> f64) -> Vec<f64> {
    MEASUREMENT.bands.iter().map(value).collect()
}
