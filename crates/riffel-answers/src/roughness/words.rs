//! What was computed of a profile, in words.

use riffel::roughness::{BandSummary, GrindSection, WavelengthBand};
use riffel_keys::{Language, Message, Value, decimal, fixed, number, range, say};
use riffel_rail::name_in_words;

use super::{ProfileAnswer, RailAnswer};

impl ProfileAnswer {
    /// What was understood of the file.
    pub fn understood(&self) -> Message {
        let format = &self.record.format;
        let header = match format.header_lines {
            0 => say!(no_header),
            1 => say!(header_of_one_line),
            lines => say!(header_of_lines, count = number(lines)),
        };
        let position = format.position.as_ref().map_or_else(
            || say!(no_position),
            |column| {
                let (unit, column) = (&column.unit, number(column.column));
                match self.record.falling {
                    true => say!(falling_position_in_column, column = column, unit = unit),
                    false => say!(position_in_column, column = column, unit = unit),
                }
            },
        );
        let rails = format.rails.iter().zip(&self.record.rails);
        let rails: Value = rails
            .map(|(column, rail)| {
                say!(
                    rail_in_column,
                    name = name_in_words(&rail.name),
                    column = number(column.column),
                    unit = &column.unit
                )
            })
            .collect();
        say!(
            read_as,
            delimiter = format.delimiter.words(),
            decimal = format.decimal.words(),
            header = header,
            position = position,
            rails = rails
        )
    }

    /// What to grind of all rails, the worst rail first.
    pub fn sections(&self) -> Vec<(&RailAnswer, &GrindSection)> {
        let rails = self.rails.iter();
        rails.flat_map(|rail| rail.sections.iter().map(move |section| (rail, section))).collect()
    }

    /// The sums of what to grind in a sentence.
    pub fn total(&self) -> Message {
        let (line, share) = self.line_to_grind();
        let (line, share) = (fixed(line, 1), fixed(100.0 * share, 1));
        match &self.rails[..] {
            [_, _, ..] => {
                let rails = self.rails.iter().map(|rail| {
                    let length: f64 = rail.sections.iter().map(GrindSection::length).sum();
                    let name = name_in_words(&rail.name);
                    say!(metres_of_rail, name = name, length = fixed(length, 1))
                });
                let rails: Value = rails.collect();
                say!(line_of_rails_to_grind, length = line, rails = rails, share = share)
            }
            _ => say!(line_to_grind, length = line, share = share),
        }
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
        band.limit.map_or_else(String::new, |limit| format!("{:.0}", 1e6 * limit)),
        band.share_over_limit.map_or_else(String::new, |share| format!("{:.1} %", 100.0 * share)),
    ]
}

/// A section in the table of a reader: number, rail and where places go back its stretch, places and length \[m\], worst band and its
/// ratio.
pub fn grind_row(index: usize, rail: &RailAnswer, section: &GrindSection, language: Language) -> [String; 7] {
    let place = name_and_stretch(rail, section.stretch, language);
    [
        format!("{}", index + 1),
        place,
        decimal(section.from, 2),
        format!("{:.2}", section.to),
        format!("{:.2}", section.length()),
        name(&section.band),
        format!("{:.2}", section.ratio),
    ]
}

/// Name of a rail, and where places go back the number of a stretch of it.
fn name_and_stretch(rail: &RailAnswer, stretch: usize, language: Language) -> String {
    let name = name_in_words(&rail.name).text(language);
    match rail.analysis.stretch_to_name(stretch) {
        Some(stretch) => say!(rail_on_stretch, rail = name, stretch = number(stretch)).text(language),
        None => name,
    }
}

/// From where to where \[m\], and on which stretch where places go back.
pub(super) fn place_in_words(from: f64, to: f64, stretch: Option<usize>) -> Message {
    let (from, to) = (fixed(from, 0), fixed(to, 0));
    match stretch {
        Some(stretch) => say!(place_on_stretch, from = from, to = to, stretch = number(stretch)),
        None => say!(place_from_to, from = from, to = to),
    }
}

/// A band in millimetres.
pub(super) fn name(band: &WavelengthBand) -> String {
    range([band.from(), band.to()], |end| format!("{:.0}", 1e3 * end))
}
