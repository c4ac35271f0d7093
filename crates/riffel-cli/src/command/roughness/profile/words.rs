//! What was computed of a profile, as a reader sees it on the terminal.

use std::path::Path;

use riffel::roughness::{BandSummary, GrindSection, WavelengthBand};

use super::Report;
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
            "band mm",
            "rms µm",
            "highest moving rms µm",
            "highest peak-to-peak µm",
            "window m",
            "limit µm",
            "over limit",
        ]);
        for band in &self.bands {
            rows.add_row(band_row(band));
        }
        text += &format!("{rows}\n");
        for verdict in &self.verdicts {
            text += &format!("{}\n", verdict.sentence);
        }
        text + &self.grind_in_words()
    }

    fn grind_in_words(&self) -> String {
        /// Sections that a terminal shows; the file has all.
        const SHOWN: usize = 20;
        if self.bands.iter().all(|band| band.limit.is_none()) {
            return String::new();
        }
        if self.sections.is_empty() {
            return "nothing to grind: no band is over its limit anywhere\n".to_owned();
        }
        let mut rows = table(&[
            "grind",
            "from m",
            "to m",
            "length m",
            "worst band mm",
            "rms/limit",
        ]);
        for (index, section) in self.sections.iter().take(SHOWN).enumerate() {
            rows.add_row(grind_row(index, section));
        }
        let total: f64 = self.sections.iter().map(GrindSection::length).sum();
        let more = match self.sections.len().saturating_sub(SHOWN) {
            0 => String::new(),
            more => format!("{more} more in grind.csv; "),
        };
        let share = 100.0 * total / self.length;
        format!("{rows}\n{more}in all {total:.2} m to grind, {share:.1} % of the length\n")
    }
}

/// A band in the table of a reader: name, RMS values \[µm\], window \[m\], limit and share.
pub(crate) fn band_row(band: &BandSummary) -> [String; 7] {
    [
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

/// A section in the table of a reader: number, places and length \[m\], worst band and its ratio.
pub(crate) fn grind_row(index: usize, section: &GrindSection) -> [String; 6] {
    [
        format!("{}", index + 1),
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
