//! Roughness of wheels: data files with name, edition and source.

use include_dir::{Dir, include_dir};
use riffel::roughness::Spectrum;
use riffel_keys::CaseError;

use crate::built_in::built_in;
use crate::{Limit, LimitTable};

/// The tables, built into the program; they are written as limits of levels are.
static FILES: Dir<'static> = include_dir!("$CARGO_MANIFEST_DIR/wheels");

/// Roughness of wheels of one kind.
#[derive(Debug, Clone, PartialEq)]
pub struct WheelRoughness {
    /// Name for the command line.
    pub name: String,
    /// What it is.
    pub title: String,
    /// Its levels.
    pub spectrum: Spectrum,
}

impl WheelRoughness {
    /// The table of a name; none where no table has it.
    pub fn find(name: &str) -> Option<Self> {
        let mut tables = Self::all().into_iter();
        tables.find(|table| table.name.eq_ignore_ascii_case(name))
    }

    /// All tables that come with Riffel, by name.
    pub fn all() -> Vec<Self> {
        built_in(
            &FILES,
            |name, text| Self::parse(name, text).ok()?,
            |table| &table.name,
        )
    }

    fn parse(name: &str, text: &str) -> Result<Option<Self>, CaseError> {
        let table = LimitTable::parse(name, text)?;
        Ok(match table.limit {
            Limit::Levels(levels) => Some(Self {
                name: table.name,
                title: table.title.to_string(),
                spectrum: levels.spectrum().clone(),
            }),
            Limit::Rms(_) => None,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use riffel::roughness::ThirdOctave;

    #[test]
    fn every_file_reads() {
        assert_eq!(WheelRoughness::all().len(), FILES.files().count());
        let discs = WheelRoughness::find("cnossos-disc-brakes").unwrap();
        let band = ThirdOctave::containing(0.02).unwrap();
        assert_eq!(discs.spectrum.level(band), Some(-8.6));
        assert_eq!(WheelRoughness::find("drum-brakes"), None);
    }
}
