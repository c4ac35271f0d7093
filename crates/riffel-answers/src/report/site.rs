//! The site of a report.

use std::path::Path;

use riffel_keys::text_file::read_keys;
use riffel_keys::{CaseError, KeyFile, Message, say};
use serde::Deserialize;

use super::grinding_cost::GrindingCost;

/// What a report says of its site; every key is optional.
#[derive(Debug, Clone, PartialEq, Default, Deserialize)]
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
    /// What grinding costs: the table `[cost]` beside `[site]`.
    #[serde(skip)]
    pub cost: Option<GrindingCost>,
}

/// The file: two tables.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SiteFile {
    #[serde(default)]
    site: Site,
    cost: Option<GrindingCost>,
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
        let file = KeyFile::parse(name, text)?;
        let SiteFile { mut site, cost } = file.deserialize()?;
        cost.as_ref().map_or(Ok(()), |cost| cost.check(&file))?;
        site.cost = cost;
        Ok(site)
    }

    /// What there is, each with its name, in the order of the report; title and remarks aside.
    pub fn facts(&self) -> Vec<(Message, &str)> {
        [
            (say!(railway), &self.railway),
            (say!(line_of_site), &self.line),
            (say!(track), &self.track),
            (say!(place_of_site), &self.place),
            (say!(measured_on), &self.measured_on),
            (say!(instrument), &self.instrument),
            (say!(author), &self.author),
            (say!(date_of_report), &self.date),
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
        assert_eq!(site.facts(), [(say!(line_of_site), "U2")]);
        let wrong = Site::parse("site", "[site]\nlien = \"U2\"\n").unwrap_err();
        assert!(wrong.to_string().contains("lien"), "{wrong}");
        let cost = |shift: &str| {
            let text = format!("[cost]\ncurrency = \"EUR\"\ngrinding_shift = {shift}\nlength_a_shift = \"800 m\"\n");
            Site::parse("site", &text)
        };
        assert_eq!(cost("15000").unwrap().cost.unwrap().length_a_shift.si(), 800.0);
        let wrong = cost("-3").unwrap_err().to_string();
        assert!(wrong.contains("`cost.grinding_shift` is -3, but must be greater than zero"), "{wrong}");
        let thousands = cost("15.000").unwrap_err().to_string();
        assert!(thousands.contains("15000 or 15:"), "{thousands}");
    }
}
