//! What was computed of a profile, as a reader sees it on the terminal.

use std::path::Path;

use riffel::roughness::{BandSummary, GrindSection, WavelengthBand};

use super::{RailReport, Report};
use crate::output::table;

impl Report {
    /// What was understood of the file.
    pub(crate) fn understood(&self) -> String {
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

    pub(super) fn readable(&self, path: &Path) -> String {
        let removed = self.removed();
        let mut text = format!("{}\n{}", path.display(), self.understood());
        text += &format!(
            "{:.3} m to {:.3} m, {:.3} m of rail sampled every {:.4} mm; {} and {} removed\n",
            self.record.from,
            self.record.to,
            self.length,
            1e3 * self.record.spacing,
            counted(removed.spikes, "spike"),
            counted(removed.pits, "pit"),
        );
        let mut rows = table(&[
            "rail",
            "band mm",
            "rms µm",
            "highest moving rms µm",
            "highest peak-to-peak µm",
            "window m",
            "limit µm",
            "over limit",
        ]);
        for rail in &self.rails {
            for band in &rail.analysis.bands {
                rows.add_row(band_row(&rail.name, band));
            }
        }
        text += &format!("{rows}\n");
        if let Some(worst) = self.worst() {
            text += &format!("{worst}\n");
        }
        for verdict in self.verdicts() {
            text += &format!("{}\n", verdict.sentence);
        }
        text + &self.grind_in_words()
    }

    fn grind_in_words(&self) -> String {
        /// Sections that a terminal shows; the file has all.
        const SHOWN: usize = 20;
        if !self.knows_what_to_grind() {
            return String::new();
        }
        let sections = self.sections();
        if sections.is_empty() {
            return "nothing to grind: no band is over its limit anywhere\n".to_owned();
        }
        let mut rows = table(&[
            "grind",
            "rail",
            "from m",
            "to m",
            "length m",
            "worst band mm",
            "rms/limit",
        ]);
        for (index, (rail, section)) in sections.iter().take(SHOWN).enumerate() {
            rows.add_row(grind_row(index, &rail.name, section));
        }
        let more = match sections.len().saturating_sub(SHOWN) {
            0 => String::new(),
            more => format!("{more} more in grind.csv; "),
        };
        format!("{rows}\n{more}{}\n", self.total())
    }

    /// What to grind of all rails, the worst rail first.
    pub(crate) fn sections(&self) -> Vec<(&RailReport, &GrindSection)> {
        let rails = self.rails.iter();
        rails
            .flat_map(|rail| rail.sections.iter().map(move |section| (rail, section)))
            .collect()
    }

    /// The sums of what to grind in a sentence.
    pub(crate) fn total(&self) -> String {
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
pub(crate) fn band_row(rail: &str, band: &BandSummary) -> [String; 8] {
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
pub(crate) fn grind_row(index: usize, rail: &str, section: &GrindSection) -> [String; 7] {
    [
        format!("{}", index + 1),
        rail.to_owned(),
        format!("{:.2}", section.from),
        format!("{:.2}", section.to),
        format!("{:.2}", section.length()),
        name(&section.band),
        format!("{:.2}", section.ratio),
    ]
}

pub(crate) fn counted(count: usize, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

/// A band in millimetres.
pub(crate) fn name(band: &WavelengthBand) -> String {
    format!("{:.0}–{:.0}", 1e3 * band.from(), 1e3 * band.to())
}
