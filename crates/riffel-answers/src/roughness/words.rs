//! What was computed of a profile, in words.

use riffel::roughness::{BandSummary, GrindSection, WavelengthBand};
use riffel_keys::decimal;

use super::{ProfileAnswer, RailAnswer};

impl ProfileAnswer {
    /// What was understood of the file.
    pub fn understood(&self) -> String {
        let format = &self.record.format;
        let header = match format.header_lines {
            0 => "no header".to_owned(),
            1 => "a header of one line".to_owned(),
            lines => format!("a header of {lines} lines"),
        };
        let position = match &format.position {
            Some(column) => {
                let order = if self.record.falling { ", falling" } else { "" };
                format!(
                    "position in column {} [{}]{order}",
                    column.column, column.unit
                )
            }
            None => "no position".to_owned(),
        };
        let rails: Vec<String> = format
            .rails
            .iter()
            .zip(&self.record.rails)
            .map(|(column, rail)| {
                format!(
                    "{} in column {} [{}]",
                    rail.name, column.column, column.unit
                )
            })
            .collect();
        format!(
            "read as: {}, {}, {header}; {position}; {}\n",
            format.delimiter.words(),
            format.decimal.words(),
            rails.join(", ")
        )
    }

    /// What to grind of all rails, the worst rail first.
    pub fn sections(&self) -> Vec<(&RailAnswer, &GrindSection)> {
        let rails = self.rails.iter();
        rails
            .flat_map(|rail| rail.sections.iter().map(move |section| (rail, section)))
            .collect()
    }

    /// The sums of what to grind in a sentence.
    pub fn total(&self) -> String {
        let (line, share) = self.line_to_grind();
        let share = 100.0 * share;
        let rails: Vec<String> = self
            .rails
            .iter()
            .map(|rail| {
                let length: f64 = rail.sections.iter().map(GrindSection::length).sum();
                format!("{} {length:.1} m", rail.name)
            })
            .collect();
        let rails = match &rails[..] {
            [_, _, ..] => format!(" ({})", rails.join(", ")),
            _ => String::new(),
        };
        format!("in all {line:.1} m of line to grind{rails}, {share:.1} % of the line measured")
    }
}

/// A band in the table of a reader: rail, name, RMS values \[µm\], window \[m\], limit and share.
pub fn band_row(rail: &str, band: &BandSummary) -> [String; 8] {
    [
        rail.to_owned(),
        name(&band.band),
        format!("{:.2}", 1e6 * band.rms),
        format!("{:.2}", 1e6 * band.moving_rms_max),
        format!("{:.1}", 1e6 * band.peak_to_peak_max),
        format!("{:.1}", band.window),
        band.limit
            .map_or_else(String::new, |limit| format!("{:.0}", 1e6 * limit)),
        band.share_over_limit
            .map_or_else(String::new, |share| format!("{:.1} %", 100.0 * share)),
    ]
}

/// A section in the table of a reader: number, rail, places and length \[m\], worst band and its ratio.
pub fn grind_row(index: usize, rail: &str, section: &GrindSection) -> [String; 7] {
    [
        format!("{}", index + 1),
        rail.to_owned(),
        decimal(section.from, 2),
        format!("{:.2}", section.to),
        format!("{:.2}", section.length()),
        name(&section.band),
        format!("{:.2}", section.ratio),
    ]
}

/// So many of something.
pub fn counted(count: usize, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

/// A band in millimetres.
pub(super) fn name(band: &WavelengthBand) -> String {
    format!("{:.0}–{:.0}", 1e3 * band.from(), 1e3 * band.to())
}
