//! What was computed of a profile, in words.

use riffel::roughness::WavelengthBand;
use riffel_keys::{Message, Value, fixed, number, range, say};
use riffel_rail::name_in_words;

use super::ProfileAnswer;

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
                    true => say!(falling_position_in_column, column, unit),
                    false => say!(position_in_column, column, unit),
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
        say!(read_as, delimiter = format.delimiter.words(), decimal = format.decimal.words(), header, position, rails)
    }
}

/// From where to where \[m\], and on which stretch where places go back.
pub(super) fn place_in_words(from: f64, to: f64, stretch: Option<usize>) -> Message {
    let (from, to) = (fixed(from, 0), fixed(to, 0));
    match stretch {
        Some(stretch) => say!(place_on_stretch, from, to, stretch = number(stretch)),
        None => say!(place_from_to, from, to),
    }
}

/// A band in millimetres.
pub(super) fn name(band: &WavelengthBand) -> String {
    range([band.from(), band.to()], |end| format!("{:.0}", 1e3 * end))
}
