//! Tables of transfer functions from roughness to sound power: data files with name, edition and source.

use std::path::Path;

use include_dir::{Dir, include_dir};
use riffel_keys::quantity::{Frequency, Quantity};
use riffel_keys::text_file::read_keys;
use riffel_keys::{CaseError, KeyFile};
use riffel_noise::{FrequencyBand, TransferFunction};
use serde::Deserialize;

use crate::built_in::built_in;

/// The tables, built into the program.
static FILES: Dir<'static> = include_dir!("$CARGO_MANIFEST_DIR/transfers");

/// What a transfer function belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum TransferPart {
    /// Rail and sleepers.
    Track,
    /// Wheel and bogie.
    Vehicle,
}

/// A transfer function with who set it.
#[derive(Debug, Clone, PartialEq)]
pub struct TransferTable {
    /// Name for the command line.
    pub name: String,
    /// What it is.
    pub title: String,
    /// What it belongs to.
    pub part: TransferPart,
    /// Edition, for reports.
    pub edition: String,
    /// Where the numbers come from.
    pub source: String,
    /// The numbers.
    pub function: TransferFunction,
}

/// The file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct TransferKeys {
    name: String,
    title: String,
    part: TransferPart,
    edition: String,
    source: String,
    level: Vec<LevelKeys>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct LevelKeys {
    frequency: Quantity<Frequency>,
    level_db: f64,
}

impl TransferTable {
    /// A table of the given name, or in the given file if the name ends in `.toml`, for a part.
    ///
    /// # Errors
    /// [`CaseError`] for a name that is not known, a table of the other part, or with the key and the line of the file.
    pub fn find(name: &str, part: TransferPart) -> Result<Self, CaseError> {
        let known = Self::all();
        let named = known.iter().find(|table| table.name.eq_ignore_ascii_case(name));
        let path = Path::new(name);
        let table = match named {
            Some(table) => table.clone(),
            None if path.extension().is_some_and(|extension| extension == "toml") => {
                Self::parse(name, &read_keys(path, "table of transfer functions")?)?
            }
            None => {
                let names = known.iter().filter(|table| table.part == part);
                let names: Vec<&str> = names.map(|table| table.name.as_str()).collect();
                return Err(CaseError::data(
                    path,
                    format!(
                        "no transfer function has this name; there are {}, or a file that ends in .toml",
                        names.join(", ")
                    ),
                ));
            }
        };
        if table.part == part {
            return Ok(table);
        }
        let [is, must] = match part {
            TransferPart::Track => ["a vehicle", "a track"],
            TransferPart::Vehicle => ["a track", "a vehicle"],
        };
        Err(CaseError::data(path, format!("is the transfer function of {is}, but must be one of {must}")))
    }

    /// All tables that come with Riffel, by name.
    pub fn all() -> Vec<Self> {
        built_in(&FILES, |name, text| Self::parse(name, text).ok(), |table| &table.name)
    }

    /// Read a table from TOML; `name` is the one shown in errors.
    ///
    /// # Errors
    /// [`CaseError`] with the key, the line and the rule.
    pub fn parse(name: &str, text: &str) -> Result<Self, CaseError> {
        let source = KeyFile::parse(name, text)?;
        let written: TransferKeys = source.deserialize()?;
        let mut levels = Vec::new();
        for level in &written.level {
            let frequency = level.frequency.si();
            let band = FrequencyBand::containing(frequency)
                .filter(|band| (frequency / band.centre() - 1.0).abs() <= 0.05)
                .ok_or_else(|| {
                    let message = format!(
                        "`level.frequency` is {}, but must be the centre of a one-third octave",
                        level.frequency
                    );
                    source.invalid("level", &message, "write 1000 Hz, 1250 Hz, 1600 Hz and so on")
                })?;
            levels.push((band, level.level_db));
        }
        let function = TransferFunction::new(levels).map_err(|error| source.invalid("level", error.to_string(), ""))?;
        Ok(Self {
            name: written.name,
            title: written.title,
            part: written.part,
            edition: written.edition,
            source: written.source,
            function,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_reads_and_names_its_source() {
        assert_eq!(TransferTable::all().len(), FILES.files().count());
        for table in TransferTable::all() {
            assert!(table.source.contains("2015/996"), "{table:?}");
            for band in FrequencyBand::all() {
                assert!(table.function.level(band).is_some(), "{}: {band:?}", table.name);
            }
        }
    }

    #[test]
    fn tables_are_found_by_name_and_part() -> Result<(), CaseError> {
        let table = TransferTable::find("CNOSSOS-monobloc-hard-pads", TransferPart::Track)?;
        assert_eq!(table.function.level(FrequencyBand::new(30)), Some(102.5));
        let other = TransferTable::find(&table.name, TransferPart::Vehicle).unwrap_err();
        assert!(other.to_string().contains("must be one of a vehicle"), "{other}");
        let unknown = TransferTable::find("slab", TransferPart::Track).unwrap_err();
        assert!(unknown.to_string().contains("cnossos-wooden-sleepers"), "{unknown}");
        let head = "name = \"n\"\ntitle = \"t\"\npart = \"track\"\nedition = \"e\"\nsource = \"s\"\n";
        for (rest, part) in [
            ("level = []", "must have a band"),
            ("[[level]]\nfrequency = \"1120 Hz\"\nlevel_db = 1.0", "1120 Hz"),
            ("[[level]]\nfrequency = \"20 mm\"\nlevel_db = 1.0", "mm"),
        ] {
            let error = TransferTable::parse("t.toml", &format!("{head}{rest}")).unwrap_err();
            assert!(error.to_string().contains(part), "{error}");
        }
        Ok(())
    }
}
