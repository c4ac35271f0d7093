//! Figures 4 and 5: dissipation over wavelength and speed.

use riffel::{GrowthMap, Ridge};
use riffel_case::Case;
use riffel_case::file::CaseFile;
use riffel_keys::quantity::Quantity;
use riffel_keys::{Language, say};
use riffel_plot::{MapFigure, MapPanel};

use super::{Drawing, Model, PaperFigure};
use crate::AnswerError;
use crate::map::{Shown, panel};
use crate::parameters::parameters_in;

/// Tractive ratios of the left and the right panel.
const TRACTIVE_RATIOS: [f64; 2] = [0.1, 0.95];

pub(super) fn figure_4(model: Model, language: Language) -> Result<PaperFigure, AnswerError> {
    let title = say!(figure_4).text(language);
    maps(language, model.title(&title, language), |ratio| model.nominal(|keys| in_window(keys, ratio)))
}

pub(super) fn figure_5(model: Model, language: Language) -> Result<PaperFigure, AnswerError> {
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

fn maps(
    language: Language,
    title: String,
    case: impl Fn(f64) -> Result<Case, AnswerError>,
) -> Result<PaperFigure, AnswerError> {
    let mut panels = Vec::new();
    let mut caption = String::new();
    let mut writer = csv::Writer::from_writer(Vec::new());
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
                &say!(
                    parameters_of,
                    letter = letter,
                    parameters = parameters,
                    sign = say!(sign_of_growth).text(language)
                )
                .text(language),
            );
        }
        rows(&case, ratio, &map, &mut writer).map_err(|error| AnswerError::Table(error.to_string()))?;
    }
    let figure = MapFigure { title, caption, panels };
    Ok(PaperFigure {
        drawing: Drawing::Maps(figure),
        csv: writer.into_inner().map_err(|error| AnswerError::Table(error.to_string()))?,
    })
}

/// The numbers of one panel, header included before the first.
fn rows(case: &Case, ratio: f64, map: &GrowthMap, writer: &mut csv::Writer<Vec<u8>>) -> csv::Result<()> {
    #[derive(serde::Serialize)]
    struct Record {
        tractive_ratio: f64,
        wavelength_m: f64,
        speed_m_per_s: f64,
        dissipation_re_w: f64,
        normalized_dissipation_re: f64,
    }
    let full_slip = case.steady.full_slip_energy_per_metre();
    for (speed, row) in map.rows() {
        for (index, value) in row.iter().enumerate() {
            writer.serialize(Record {
                tractive_ratio: ratio,
                wavelength_m: map.wavelength().value(index),
                speed_m_per_s: speed,
                dissipation_re_w: value.re * full_slip * speed,
                normalized_dissipation_re: value.re,
            })?;
        }
    }
    Ok(())
}
