//! Figures 4 and 5: dissipation over wavelength and speed.

use riffel::{GrowthMap, Ridge};
use riffel_case::Case;
use riffel_case::file::CaseFile;
use riffel_keys::quantity::Quantity;
use riffel_keys::{Language, say};
use riffel_plot::{MapFigure, MapPanel};

use super::{Drawing, Model, PaperFigure};
use crate::map::{Shown, panel};
use crate::parameters::parameters_in;
use crate::{Result, Rows, Table};

/// Tractive ratios of the left and the right panel.
const TRACTIVE_RATIOS: [f64; 2] = [0.1, 0.95];

pub(super) fn figure_4(model: Model, language: Language) -> Result<PaperFigure> {
    let title = say!(figure_4).text(language);
    maps(language, model.title(&title, language), |ratio| model.nominal(|keys| in_window(keys, ratio)))
}

pub(super) fn figure_5(model: Model, language: Language) -> Result<PaperFigure> {
    let title = say!(figure_5).text(language);
    maps(language, model.title(&title, language), |ratio| model.bhaskar_track(|keys| in_window(keys, ratio)))
}

/// A tractive ratio, over the window of the paper, as far in speed as the line stays within 80 mm.
fn in_window(keys: &mut CaseFile, tractive_ratio: f64) {
    keys.map.speed.max = Quantity::new(40.0);
    keys.map.speed.points = 141;
    keys.map.wavelength.points = 121;
    keys.contact.tractive_ratio = Some(Quantity::new(tractive_ratio));
}

fn maps(language: Language, title: String, case: impl Fn(f64) -> Result<Case>) -> Result<PaperFigure> {
    let mut panels = Vec::new();
    let mut caption = String::new();
    let mut points = Vec::new();
    for (letter, ratio) in ["a", "b"].into_iter().zip(TRACTIVE_RATIOS) {
        let case = case(ratio)?;
        let map = GrowthMap::compute(&case.feedback, case.wavelength, case.speed, |_| ());
        let ridge = Ridge::of_map(&case.feedback, &map);
        panels.push(MapPanel {
            subtitle: language.numbers(&format!("({letter}) τ = {ratio}")),
            ..panel(&case, &map, &ridge, Shown::Power)
        });
        if caption.is_empty() {
            let parameters = parameters_in(&case, language);
            caption = language.numbers(
                &say!(parameters_of, letter, parameters, sign = say!(sign_of_growth).text(language)).text(language),
            );
        }
        points.extend(points_of(&case, ratio, &map));
    }
    let table = Table {
        name: "figure",
        columns: vec![
            points.exact("tractive_ratio", |point| point.tractive_ratio),
            points.exact("wavelength_m", |point| point.wavelength),
            points.exact("speed_m_per_s", |point| point.speed),
            points.exact("dissipation_re_w", |point| point.dissipation),
            points.exact("normalized_dissipation_re", |point| point.normalized_dissipation),
        ],
    };
    Ok(PaperFigure { drawing: Drawing::Maps(MapFigure { title, caption, panels }), table })
}

/// A point of a panel.
struct Point {
    tractive_ratio: f64,
    /// \[m\].
    wavelength: f64,
    /// \[m/s\].
    speed: f64,
    /// \[W\].
    dissipation: f64,
    normalized_dissipation: f64,
}

fn points_of<'a>(case: &'a Case, tractive_ratio: f64, map: &'a GrowthMap) -> impl Iterator<Item = Point> + 'a {
    let full_slip = case.steady.full_slip_energy_per_metre();
    map.rows().flat_map(move |(speed, row)| {
        row.iter().enumerate().map(move |(index, value)| Point {
            tractive_ratio,
            wavelength: map.wavelength().value(index),
            speed,
            dissipation: value.re * full_slip * speed,
            normalized_dissipation: value.re,
        })
    })
}
