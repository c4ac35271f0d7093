//! What to grind of the rails of a record, as data.

use riffel::roughness::{GrindSection, GrindSettings, line_length};
use riffel_keys::{Message, Value, fixed, say};
use riffel_rail::name_in_words;
use serde::Serialize;

use super::RailAnswer;

/// What to grind of all rails.
#[derive(Serialize)]
pub(crate) struct Grind {
    sections: Vec<GroundSection>,
    /// Length of line where a rail is to be ground.
    pub(crate) total_m: f64,
    /// Of the line that was measured.
    share_of_length: f64,
    merge_m: f64,
    grinding_length_m: f64,
}

/// A section to grind.
#[derive(Serialize)]
pub(crate) struct GroundSection {
    /// Left out where it stands with its rail.
    #[serde(skip_serializing_if = "Option::is_none")]
    rail: Option<String>,
    from_m: f64,
    to_m: f64,
    band_from_m: f64,
    band_to_m: f64,
    rms_over_limit: f64,
    /// Which of the stretches that lie over each other, where places go back.
    #[serde(skip_serializing_if = "Option::is_none")]
    stretch: Option<usize>,
}

impl GroundSection {
    /// Rows of a rail, without its name.
    pub(crate) fn of_rail(rail: &RailAnswer) -> impl Iterator<Item = Self> {
        rail.sections.iter().map(|section| Self {
            rail: None,
            from_m: section.from,
            to_m: section.to,
            band_from_m: section.band.from(),
            band_to_m: section.band.to(),
            rms_over_limit: section.ratio,
            stretch: rail.analysis.stretch_to_name(section.stretch),
        })
    }
}

impl Grind {
    pub(super) fn new(rails: &[RailAnswer], settings: &GrindSettings) -> Self {
        let sections = || rails.iter().flat_map(|rail| &rail.sections);
        let ground = rails.iter().flat_map(|rail| rail.analysis.measured_within(&rail.sections));
        let measured = rails.iter().flat_map(|rail| rail.analysis.numbered_stretches());
        let named = rails.iter().flat_map(|rail| {
            let own = GroundSection::of_rail(rail);
            own.map(|section| GroundSection { rail: Some(rail.name.clone()), ..section })
        });
        Self {
            sections: named.collect(),
            total_m: line_length(sections().map(|section| (section.stretch, section.from, section.to))),
            share_of_length: line_length(ground) / line_length(measured),
            merge_m: settings.merge,
            grinding_length_m: settings.shortest,
        }
    }

    /// The sums in a sentence.
    pub(super) fn in_words(&self, rails: &[RailAnswer]) -> Message {
        let (line, share) = (fixed(self.total_m, 1), fixed(100.0 * self.share_of_length, 1));
        match rails {
            [_, _, ..] => {
                let rails = rails.iter().map(|rail| {
                    let length: f64 = rail.sections.iter().map(GrindSection::length).sum();
                    let name = name_in_words(&rail.name);
                    say!(metres_of_rail, name, length = fixed(length, 1))
                });
                let rails: Value = rails.collect();
                say!(line_of_rails_to_grind, length = line, rails, share)
            }
            _ => say!(line_to_grind, length = line, share),
        }
    }
}
