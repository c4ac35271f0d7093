//! The site of a report.

use std::path::Path;

use riffel_keys::text_file::read_keys;
use riffel_keys::{CaseError, KeyFile};
use serde::Deserialize;

/// What a report says of its site; every key is optional.
#[derive(Debug, Clone, PartialEq, Eq, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Site {
    /// Title of the report.
    pub title: Option<String>,
    /// Railway or metro.
    pub railway: Option<String>,
    /// Line.
    pub line: Option<String>,
    /// Track or rail: "down, left".
    pub track: Option<String>,
    /// Where: station, chainage, radius.
    pub place: Option<String>,
    /// When it was measured.
    pub measured_on: Option<String>,
    /// What it was measured with.
    pub instrument: Option<String>,
    /// Who wrote the report.
    pub author: Option<String>,
    /// Date of the report.
    pub date: Option<String>,
    /// What else the reader should know.
    pub remarks: Option<String>,
}

/// The file: one table.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SiteFile {
    site: Site,
}

impl Site {
    /// Read a TOML file with the table `[site]`.
    ///
    /// # Errors
    /// [`CaseError`] with the key, the line and the rule.
    pub fn read(path: &Path) -> Result<Self, CaseError> {
        Self::parse(&path.display().to_string(), &read_keys(path, "site")?)
    }

    /// Read it from TOML; `name` is the one shown in errors.
    ///
    /// # Errors
    /// [`CaseError`] with the key, the line and the rule.
    pub fn parse(name: &str, text: &str) -> Result<Self, CaseError> {
        let written: SiteFile = KeyFile::parse(name, text)?.deserialize()?;
        Ok(written.site)
    }

    /// What there is, each with its name, in the order of the report; title and remarks aside.
    pub fn facts(&self) -> Vec<(&'static str, &str)> {
        [
            ("Railway", &self.railway),
            ("Line", &self.line),
            ("Track", &self.track),
            ("Place", &self.place),
            ("Measured on", &self.measured_on),
            ("Instrument", &self.instrument),
            ("Author", &self.author),
            ("Date", &self.date),
        ]
        .into_iter()
        .filter_map(|(name, value)| Some((name, value.as_deref()?)))
        .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_site_has_what_it_says() {
        let site = Site::parse("site", "[site]\nline = \"U2\"\ntitle = \"T\"\n").unwrap();
        assert_eq!(site.facts(), [("Line", "U2")]);
        let wrong = Site::parse("site", "[site]\nlien = \"U2\"\n").unwrap_err();
        assert!(wrong.to_string().contains("lien"), "{wrong}");
    }
}
