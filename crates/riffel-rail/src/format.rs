//! The reader profile: how a file of text is laid out.

use std::path::Path;

use riffel_keys::quantity::{Length, Quantity};
use riffel_keys::table::{DecimalMark, Delimiter};
use riffel_keys::text_file::read_keys;
use riffel_keys::{CaseError, KeyFile};
use serde::{Deserialize, Serialize};

use crate::length_unit::metres;

/// How to read a file of roughness: what `--format` takes and `--save-format` writes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ReaderFormat {
    /// What stands between two cells.
    pub delimiter: Delimiter,
    /// What stands before the decimals.
    #[serde(default)]
    pub decimal: DecimalMark,
    /// Lines before the first line of numbers, the header among them.
    #[serde(default)]
    pub header_lines: usize,
    /// Fixed step between samples, for a file without positions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spacing: Option<Quantity<Length>>,
    /// Column of the position along the rail.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub position: Option<Column>,
    /// Columns of heights, one for each rail or line of measurement.
    pub rails: Vec<Column>,
    /// Columns, from 1, whose cells tell records apart: rows that differ in them are no one rail.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub labels: Vec<usize>,
}

/// A column and its unit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Column {
    /// Place in the row, from 1.
    pub column: usize,
    /// Unit of its numbers: m, km, mm, um.
    pub unit: String,
    /// Name in reports.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub name: String,
}

impl Column {
    /// Size of the unit in metres; None if it is no length.
    pub(super) fn metres(&self) -> Option<f64> {
        metres(&self.unit)
    }
}

const ZERO: &str = "has the column 0, but columns count from 1";

impl ReaderFormat {
    /// Read a reader profile.
    ///
    /// # Errors
    /// [`CaseError`] with the key, the line and the rule.
    pub fn read(path: &Path) -> Result<Self, CaseError> {
        Self::parse(&path.display().to_string(), &read_keys(path, "reader profile")?)
    }

    /// Read a reader profile from TOML; `name` is the one shown in errors.
    ///
    /// # Errors
    /// [`CaseError`] with the key, the line and the rule.
    pub fn parse(name: &str, text: &str) -> Result<Self, CaseError> {
        let source = KeyFile::parse(name, text)?;
        let format: Self = source.deserialize()?;
        format.check(&source)?;
        Ok(format)
    }

    fn check(&self, source: &KeyFile) -> Result<(), CaseError> {
        if self.rails.is_empty() {
            return Err(source.invalid(
                "rails",
                "is empty, but must name at least one column of heights",
                "write rails = [{ column = 2, unit = \"um\", name = \"left\" }]",
            ));
        }
        match (&self.spacing, &self.position) {
            (Some(_), Some(_)) => {
                return Err(source.invalid(
                    "spacing",
                    "and `position` exclude each other",
                    "give the one that the file goes by",
                ));
            }
            (None, None) => {
                return Err(source.missing(
                    "position",
                    "give position = { column = 1, unit = \"m\" }, or spacing = \"1 mm\" for a file without",
                ));
            }
            (Some(spacing), None) if spacing.si() <= 0.0 => {
                return Err(source.invalid("spacing", format!("is {spacing}, but must be greater than zero"), ""));
            }
            _ => {}
        }
        if self.labels.contains(&0) {
            return Err(source.invalid("labels", ZERO, ""));
        }
        let position = self.position.iter().map(|column| ("position", column));
        let rails = self.rails.iter().map(|column| ("rails", column));
        for (key, column) in position.chain(rails) {
            if column.column == 0 {
                return Err(source.invalid(key, ZERO, ""));
            }
            if column.metres().is_none() {
                let rule = format!("has the unit \"{}\", which is no length", column.unit);
                return Err(source.invalid(key, &rule, "write m, km, mm or um"));
            }
        }
        Ok(())
    }

    /// The profile as TOML.
    pub fn toml(&self) -> String {
        // Plain tables of texts and numbers.
        toml::to_string(self).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_reads_back() -> Result<(), CaseError> {
        let text = "delimiter = \"semicolon\"\ndecimal = \"comma\"\nheader_lines = 3\n\
                    position = { column = 1, unit = \"km\" }\n\
                    rails = [{ column = 3, unit = \"mm\", name = \"left\" }, { column = 4, unit = \"um\" }]\n";
        let format = ReaderFormat::parse("trolley.toml", text)?;
        assert_eq!(format.rails[0].metres(), Some(1e-3));
        assert_eq!(ReaderFormat::parse("again", &format.toml())?, format);
        Ok(())
    }

    #[test]
    fn wrong_profiles_are_refused_with_their_key() {
        let start = "delimiter = \"comma\"\n";
        for (rest, part) in [
            ("rails = []\nspacing = 0.001", "`rails` is empty"),
            ("rails = [{ column = 1, unit = \"um\" }]", "`position` is missing"),
            ("rails = [{ column = 0, unit = \"um\" }]\nspacing = 0.001", "column 0"),
            ("rails = [{ column = 1, unit = \"kg\" }]\nspacing = 0.001", "no length"),
            ("rails = [{ column = 1, unit = \"um\" }]\nspacing = \"-1 mm\"", "greater than zero"),
            ("rail = 3", "`rail`"),
            ("rails = [{ column = 1, unit = \"um\" }]\nspacing = 0.001\nlabels = [0]", "column 0"),
        ] {
            let error = ReaderFormat::parse("f.toml", &format!("{start}{rest}")).unwrap_err();
            assert!(error.to_string().contains(part), "{error}");
        }
    }
}
