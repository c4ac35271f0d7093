//! Limit tables: data files with name, edition and source.

use std::path::Path;

use include_dir::{Dir, include_dir};
use riffel::roughness::{LevelLimit, RmsLimit, Spectrum, ThirdOctave, WavelengthBand};
use riffel_keys::quantity::{Length, Quantity, Ratio};
use riffel_keys::text_file::read_keys;
use riffel_keys::{CaseError, KeyFile, Words};
use serde::Deserialize;

use crate::built_in::built_in;

/// The limit tables, built into the program.
static FILES: Dir<'static> = include_dir!("$CARGO_MANIFEST_DIR/limits");

/// A limit with who set it.
#[derive(Debug, Clone, PartialEq)]
pub struct LimitTable {
    /// Name for the command line.
    pub name: String,
    /// What it is.
    pub title: Words,
    /// Edition, for reports.
    pub edition: String,
    /// Where the numbers come from.
    pub source: String,
    /// The numbers.
    pub limit: Limit,
}

/// Numbers of a limit table.
#[derive(Debug, Clone, PartialEq)]
pub enum Limit {
    /// Of one-third-octave levels.
    Levels(LevelLimit),
    /// Of RMS in bands of wavelength.
    Rms(RmsLimit),
}

/// The file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct LimitKeys {
    name: String,
    title: String,
    edition: String,
    source: String,
    share_of_length: Option<Quantity<Ratio>>,
    #[serde(default)]
    level: Vec<LevelKeys>,
    #[serde(default)]
    band: Vec<BandKeys>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct LevelKeys {
    wavelength: Quantity<Length>,
    level_db: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct BandKeys {
    from: Quantity<Length>,
    to: Quantity<Length>,
    rms: Quantity<Length>,
}

impl LimitTable {
    /// A table of the given name, or in the given file if the name ends in `.toml`.
    ///
    /// # Errors
    /// [`CaseError`] for a name that is not known, or with the key and the line of the file.
    pub fn find(name: &str) -> Result<Self, CaseError> {
        let known = Self::all();
        if let Some(table) = known.iter().find(|table| table.name.eq_ignore_ascii_case(name)) {
            return Ok(table.clone());
        }
        let path = Path::new(name);
        if path.extension().is_none_or(|extension| extension != "toml") {
            let names: Vec<&str> = known.iter().map(|table| table.name.as_str()).collect();
            return Err(CaseError::data(
                path,
                format!("no limit table has this name; there are {}, or a file that ends in .toml", names.join(", ")),
            ));
        }
        Self::parse(name, &read_keys(path, "limit table")?)
    }

    /// The tables of some names, each as by [`find`](Self::find); without names all that come with Riffel.
    ///
    /// # Errors
    /// Errors of [`find`](Self::find).
    pub fn named(names: &[String]) -> Result<Vec<Self>, CaseError> {
        match names {
            [] => Ok(Self::all()),
            names => names.iter().map(|name| Self::find(name)).collect(),
        }
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
        let written: LimitKeys = source.deserialize()?;
        let limit = match (&written.level[..], &written.band[..]) {
            ([_, ..], []) => levels(&source, &written.level)?,
            ([], [_, ..]) => bands(&source, &written)?,
            _ => {
                return Err(source.invalid(
                    "",
                    "a limit table has either [[level]] or [[band]] entries",
                    "write [[level]] wavelength = \"20 mm\", level_db = -6.2, or [[band]] from, to, rms",
                ));
            }
        };
        Ok(Self {
            title: Words::new("Limit", &written.name, written.title),
            name: written.name,
            edition: written.edition,
            source: written.source,
            limit,
        })
    }
}

fn levels(source: &KeyFile, written: &[LevelKeys]) -> Result<Limit, CaseError> {
    let refuse = |error: riffel::Error| source.invalid("level", error.to_string(), "");
    let levels: Result<Vec<_>, _> =
        written.iter().map(|level| Ok((ThirdOctave::containing(level.wavelength.si())?, level.level_db))).collect();
    let spectrum = Spectrum::new(levels.map_err(refuse)?).map_err(refuse)?;
    Ok(Limit::Levels(LevelLimit::new(spectrum)))
}

fn bands(source: &KeyFile, written: &LimitKeys) -> Result<Limit, CaseError> {
    let refuse = |error: riffel::Error| source.invalid("band", error.to_string(), "");
    let bands: Result<Vec<_>, _> = written
        .band
        .iter()
        .map(|band| Ok((WavelengthBand::new(band.from.si(), band.to.si())?, band.rms.si())))
        .collect();
    let share = written.share_of_length.map_or(0.0, |share| share.si());
    let limit = RmsLimit::new(bands.map_err(refuse)?, share).map_err(refuse)?;
    Ok(Limit::Rms(limit))
}

#[cfg(test)]
mod tests {
    use super::*;
    use riffel_keys::Language;

    #[test]
    fn every_file_reads_and_names_edition_and_source_and_has_a_title_in_every_language() {
        assert_eq!(LimitTable::all().len(), FILES.files().count());
        for table in LimitTable::all() {
            assert!(table.edition.len() > 5 && table.source.len() > 40, "{table:?}");
            assert!(table.title.is_in(Language::German), "{}", table.title);
        }
    }

    #[test]
    fn iso_3095_has_its_22_points() -> Result<(), CaseError> {
        let Limit::Levels(limit) = LimitTable::find("ISO-3095-2013")?.limit else {
            panic!("no levels");
        };
        let spectrum = limit.spectrum();
        assert_eq!(spectrum.levels().len(), 22);
        for (millimetres, level) in [(400.0, 17.1), (31.5, -5.0), (20.0, -6.2), (3.15, -11.0)] {
            let band = ThirdOctave::containing(1e-3 * millimetres).unwrap();
            assert_eq!(spectrum.level(band), Some(level));
        }
        Ok(())
    }

    #[test]
    fn grassie_has_the_bands_of_grinding() -> Result<(), CaseError> {
        let Limit::Rms(limit) = LimitTable::find("grassie-1999")?.limit else {
            panic!("no RMS");
        };
        let limits = WavelengthBand::GRINDING.map(|band| limit.of(band).unwrap());
        for (limit, expected) in limits.iter().zip([3e-6, 7e-6, 7e-6, 45e-6]) {
            assert!((limit - expected).abs() < 1e-12);
        }
        assert!((limit.share() - 0.05).abs() < 1e-12);
        Ok(())
    }

    #[test]
    fn wrong_tables_are_refused() {
        assert!(LimitTable::find("iso-3095-2005").is_err());
        let head = "name = \"n\"\ntitle = \"t\"\nedition = \"e\"\nsource = \"s\"\n";
        for (rest, part) in [
            ("", "either [[level]] or [[band]]"),
            ("[[level]]\nwavelength = \"-20 mm\"\nlevel_db = 1.0", "`level`"),
            ("[[band]]\nfrom = \"30 mm\"\nto = \"10 mm\"\nrms = \"3 um\"", "must be above the shortest"),
            ("[[band]]\nfrom = \"10 mm\"\nto = \"30 mm\"\nrms = \"3 kg\"", "kg"),
        ] {
            let error = LimitTable::parse("l.toml", &format!("{head}{rest}")).unwrap_err();
            assert!(error.to_string().contains(part), "{error}");
        }
    }
}
