//! What a user says of how a record is laid out.

use riffel_keys::quantity::{Length, Quantity};

use crate::format::{Column, ReaderFormat};
use crate::length_unit::LengthUnit;

/// How to read records; what is left out is found from their first lines.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Layout {
    /// The reader profile.
    pub format: Option<ReaderFormat>,
    /// Step between samples of a file without positions.
    pub spacing: Option<Quantity<Length>>,
    /// Unit of the heights, whatever the file or the reader profile says.
    pub height_unit: Option<LengthUnit>,
    /// Unit of the positions, whatever the file or the reader profile says.
    pub position_unit: Option<LengthUnit>,
}

impl Layout {
    /// The reader profile with what was said besides it.
    pub(super) fn apply(&self, format: &ReaderFormat) -> ReaderFormat {
        let mut format = format.clone();
        if format.position.is_none() && self.spacing.is_some() {
            format.spacing = self.spacing;
        }
        let set = |column: &mut Column, unit: &Option<LengthUnit>| {
            if let Some(unit) = unit {
                column.unit.clone_from(&unit.0);
            }
        };
        for rail in &mut format.rails {
            set(rail, &self.height_unit);
        }
        if let Some(position) = &mut format.position {
            set(position, &self.position_unit);
        }
        format
    }
}
