//! `POST /api/figure`: a figure of Afferrante & Ciavarella (2009), as data for the page to draw.

use crate::paper::{Drawing, FIGURES, Model};
use riffel_keys::Language;
use riffel_plot::{LinePanel, LineStyle, MapPanel, Scale};
use serde::Deserialize;
use serde_json::{Value, json};

use crate::page::{Fault, Reply};

#[derive(Deserialize)]
pub(crate) struct Question {
    number: u8,
    contact: Contact,
    /// Of the words of the figure.
    #[serde(default)]
    language: Language,
}

#[derive(Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Contact {
    QuasiStatic,
    SpringDashpot,
    NonSteady,
}

impl crate::page::Question for Question {
    fn subject(&self) -> Option<String> {
        Some(format!("figure {}", self.number))
    }

    fn answer(&self) -> Result<Reply, Fault> {
        let number = self.number;
        let (_, make) = FIGURES
            .into_iter()
            .find(|(known, _)| *known == number)
            .ok_or_else(|| Fault::bad(format!("the paper has no figure {number} that is computed")))?;
        let model = match self.contact {
            Contact::QuasiStatic => Model::QuasiStatic,
            Contact::SpringDashpot => Model::SpringDashpot,
            Contact::NonSteady => Model::NonSteady,
        };
        let figure = make(model, self.language)?;
        Reply::json(&match figure.drawing {
            Drawing::Maps(figure) => json!({
                "title": figure.title, "caption": figure.caption,
                "maps": figure.panels.iter().map(map).collect::<Vec<_>>(),
            }),
            Drawing::Lines(figure) => json!({
                "title": figure.title, "caption": figure.caption,
                "lines": figure.panels.iter().map(lines).collect::<Vec<_>>(),
            }),
        })
    }
}

/// A map; values keep the sign of the paper.
fn map(panel: &MapPanel) -> Value {
    // Five digits are more than the eye has.
    let values: Vec<f32> = panel.values.iter().map(|&value| value as f32).collect();
    json!({
        "subtitle": panel.subtitle, "value_label": panel.value_label, "values": values,
        "wavelength_m": panel.wavelength_m, "speed_m_per_s": panel.speed_m_per_s,
        "best_fit_frequency_hz": panel.best_fit_frequency_hz, "rays_hz": panel.rays_hz,
        "branches": panel.branches.iter().map(|branch| json!({
            "frequency_hz": branch.frequency_hz,
            "points": {
                "wavelength_m": branch.points.iter().map(|point| point.0).collect::<Vec<_>>(),
                "speed_m_per_s": branch.points.iter().map(|point| point.1).collect::<Vec<_>>(),
            },
        })).collect::<Vec<_>>(),
        "ridge": {
            "wavelength_m": panel.ridge.iter().map(|mark| mark.wavelength_m).collect::<Vec<_>>(),
            "speed_m_per_s": panel.ridge.iter().map(|mark| mark.speed_m_per_s).collect::<Vec<_>>(),
            "at_edge": panel.ridge.iter().map(|mark| mark.at_edge).collect::<Vec<_>>(),
        },
    })
}

fn lines(panel: &LinePanel) -> Value {
    let scale = |scale| match scale {
        Scale::Linear => "linear",
        Scale::Log => "log",
    };
    json!({
        "subtitle": panel.subtitle, "x_label": panel.x_label, "y_label": panel.y_label,
        "x_scale": scale(panel.x_scale), "y_scale": scale(panel.y_scale),
        "x_range": panel.x_range, "y_range": panel.y_range,
        "series": panel.series.iter().map(|series| json!({
            // JSON knows no NaN: what is not there is null, and breaks the line.
            "label": series.label, "x": series.x, "y": series.y,
            "style": match series.style {
                LineStyle::Solid => "solid",
                LineStyle::Dashed => "dash",
                LineStyle::Dotted => "dot",
                LineStyle::Markers => "markers",
            },
        })).collect::<Vec<_>>(),
    })
}
