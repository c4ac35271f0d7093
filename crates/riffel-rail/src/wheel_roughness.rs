//! Roughness of wheels: data files with name, edition and source.

use std::path::Path;

use include_dir::{Dir, include_dir};
use riffel::roughness::Spectrum;
use riffel_keys::CaseError;

use crate::built_in::built_in;
use crate::{Limit, LimitTable, Survey};

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
    /// The table of a name; `None` if no table has it.
    pub fn find(name: &str) -> Option<Self> {
        let mut tables = Self::all().into_iter();
        tables.find(|table| table.name.eq_ignore_ascii_case(name))
    }

    /// The levels of the table of a name, or else of a file, with what they are called; `None` if there is neither.
    ///
    /// # Errors
    /// [`CaseError`] for a file that holds no roughness.
    pub fn named_or_in(name: &str, path: &Path) -> Result<Option<(String, Spectrum)>, CaseError> {
        if let Some(table) = Self::find(name) {
            return Ok(Some((table.name, table.spectrum)));
        }
        let is_given = riffel_keys::question::holds(path);
        if !(is_given || path.exists()) {
            return Ok(None);
        }
        let name = if is_given { "given" } else { name };
        Ok(Some((name.to_owned(), Survey::mean_of(path)?)))
    }

    /// The names of all tables, in one sentence.
    pub fn names() -> String {
        let names = Self::all().into_iter().map(|table| table.name);
        names.collect::<Vec<_>>().join(", ")
    }

    /// All tables that come with Riffel, by name.
    pub fn all() -> Vec<Self> {
        built_in(&FILES, |name, text| Self::parse(name, text).ok()?, |table| &table.name)
    }

    fn parse(name: &str, text: &str) -> Result<Option<Self>, CaseError> {
        let table = LimitTable::parse(name, text)?;
        Ok(match table.limit {
            Limit::Levels(levels) => {
                Some(Self { name: table.name, title: table.title.to_string(), spectrum: levels.spectrum().clone() })
            }
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
