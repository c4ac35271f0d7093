//! What is asked of the roughness of a rail.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use riffel::roughness::GrindSettings;
use riffel_keys::quantity::{Length, Quantity};
use riffel_rail::{LimitTable, LinePlace, Record, RoughnessFile, Survey};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::json;

use super::synthesised::Synthesised;
use super::{ProfileAnswer, ProfileRequest, SpectraAnswer};
use crate::question::{Client, Question, RecordLayout, Rule, Source, choose_nothing, of_keys, positive};
use crate::{Answer, AnswerError, Result};

/// A measured rail: roughness levels, statistics of wavelength bands, limits, what to grind.
#[derive(Debug, Deserialize, JsonSchema)]
pub struct RoughnessQuestion {
    /// Longitudinal profile, or table of one-third-octave levels: text in columns, or - for standard input.
    #[schemars(extend("positional" = true))]
    file: Option<Source<RoughnessFile>>,
    #[serde(flatten)]
    layout: RecordLayout,
    /// Save how the file was read as a reader profile.
    #[schemars(with = "Option<String>", extend("value_name" = "TOML", "path" = true))]
    save_format: Option<PathBuf>,
    /// Longest wavelength of the spectrum [default: a quarter of the record, at most 2 m].
    #[schemars(extend("value_name" = "LENGTH"))]
    longest: Option<Quantity<Length>>,
    /// Window of the moving RMS and peak-to-peak value [default: ten of the longest wavelength of each
    /// band, at least 1 m].
    #[schemars(extend("value_name" = "LENGTH"))]
    window: Option<Quantity<Length>>,
    /// Length of the blocks whose RMS is tabled.
    #[schemars(extend("value_name" = "LENGTH", "default" = "10 m"))]
    block: Quantity<Length>,
    /// Good length up to which two sections are ground as one.
    #[schemars(extend("value_name" = "LENGTH", "default" = "10 m"))]
    merge: Quantity<Length>,
    /// Shortest length that is ground; shorter sections are widened to it.
    #[schemars(extend("value_name" = "LENGTH", "default" = "10 m"))]
    grinding_length: Quantity<Length>,
    /// Limit table, by name or as a TOML file; may be repeated [default: iso-3095-2013, grassie-1999].
    limit: Vec<String>,
    /// Curves, stations, welds and joints along the line, told with the sections of a profile: a table with the columns position, or
    /// from and to, and kind and name.
    #[schemars(extend("value_name" = "FILE"))]
    along: Option<Source<Vec<LinePlace>>>,
    /// Keep the spectra of a table whose column has this value; may be repeated.
    #[serde(rename = "where")]
    #[schemars(extend("value_name" = "COLUMN=VALUE"))]
    choose: Vec<String>,
    /// Group the spectra of a table by a column and compare the groups.
    #[schemars(extend("value_name" = "COLUMN"))]
    by: Option<String>,
    /// Make a profile to a recipe instead of reading one [default recipe: built in]; written to --output or
    /// to standard output.
    #[schemars(with = "Option<Source<()>>", extend("value_name" = "RECIPE", "alone" = ""))]
    synthesise: Option<PathBuf>,
    /// Folder for the results, made if need be [default: FILE-roughness]; with --synthesise the file.
    #[schemars(with = "Option<String>", extend("value_name" = "DIR", "path" = true))]
    output: Option<PathBuf>,
    /// With --synthesise, replace the file if it is there.
    force: bool,
}

impl RoughnessQuestion {
    /// What is computed of a profile.
    fn request(&self) -> Result<ProfileRequest> {
        let or_zero = |argument, length: Quantity<Length>| match length.si() {
            below if below < 0.0 => {
                let rule = "zero or greater".to_owned();
                Err(AnswerError::argument(argument, length, rule))
            }
            metres => Ok(metres),
        };
        self.longest.map(|longest| positive("--longest", longest)).transpose()?;
        Ok(ProfileRequest {
            longest: self.longest,
            window: self.window.map(|window| positive("--window", window)).transpose()?,
            block: positive("--block", self.block)?,
            grinding: GrindSettings {
                merge: or_zero("--merge", self.merge)?,
                shortest: or_zero("--grinding-length", self.grinding_length)?,
            },
        })
    }

    fn profile(
        &self,
        path: &Path,
        record: Record,
        limits: &[LimitTable],
        request: &ProfileRequest,
        client: &dyn Client,
    ) -> Result<ProfileAnswer> {
        choose_nothing(path, &self.choose, self.by.as_deref())?;
        // A table that is none is told of before the work.
        let along = self.along.as_ref().map(|along| along.value(LinePlace::read)).transpose()?;
        let mut answer = ProfileAnswer::new(path, record, limits, request, client)?;
        answer.save_format = self.save_format.clone();
        Ok(answer.beside(along.map(Arc::unwrap_or_clone).unwrap_or_default()))
    }

    fn spectra(&self, survey: Survey, limits: &[LimitTable]) -> Result<SpectraAnswer> {
        let of_profiles = [
            ("--longest", self.longest.map(|value| value.to_string())),
            ("--window", self.window.map(|value| value.to_string())),
            ("--along", self.along.as_ref().map(|along| along.name().display().to_string())),
        ];
        let given = of_profiles.into_iter().find_map(|(argument, value)| Some((argument, value?)));
        if let Some((argument, value)) = given {
            let path = survey.path().display();
            let rule = format!("left out: it is for profiles, and {path} is a table of spectra");
            return Err(AnswerError::argument(argument, value, rule));
        }
        Ok(SpectraAnswer::new(&survey.choose(&self.choose)?, limits, self.by.as_deref())?)
    }

    /// What a file says that is read by a layout, all else by default.
    ///
    /// # Errors
    /// None but those of a default that does not fit its key.
    pub(crate) fn of_file(file: Source<RoughnessFile>, layout: RecordLayout) -> Result<Self> {
        let question: Self = of_keys(json!({ "file": "" }))?;
        Ok(Self { file: Some(file), layout, ..question })
    }

    /// What the file says; `None` where a profile is made.
    ///
    /// # Errors
    /// [`AnswerError::Argument`] with the rule, [`AnswerError::Case`] with the file at fault.
    pub(crate) fn measured(&self, client: &dyn Client) -> Result<Option<MeasuredAnswer>> {
        let Some(file) = &self.file else {
            return Ok(None);
        };
        let (request, limits) = (self.request()?, LimitTable::named(&self.limit)?);
        let record = file.value(|path| self.layout.read(path, client))?;
        Ok(Some(match Arc::unwrap_or_clone(record) {
            RoughnessFile::Profile(record) => {
                MeasuredAnswer::Profile(Box::new(self.profile(file.name(), record, &limits, &request, client)?))
            }
            RoughnessFile::Spectra(spectra, warnings) => {
                MeasuredAnswer::Spectra(Box::new(self.spectra(Survey::new(file.name(), spectra, warnings)?, &limits)?))
            }
        }))
    }
}

/// What a file of roughness says.
#[derive(Serialize)]
#[serde(untagged)]
pub(crate) enum MeasuredAnswer {
    /// A profile.
    Profile(Box<ProfileAnswer>),
    /// A table of spectra.
    Spectra(Box<SpectraAnswer>),
}

impl Question for RoughnessQuestion {
    const NAME: &'static str = "roughness";
    const EXAMPLE: &'static str = "\
        Example: riffel roughness --synthesise -o profile.csv && riffel roughness profile.csv -o results\n\n\
        A file whose heights are in mm and does not say so: riffel roughness trolley.txt --height-unit mm";
    const RULES: &'static [Rule] = &[
        Rule::AnyOf(&["file", "synthesise"]),
        Rule::OneOf(&["file", "synthesise"]),
        Rule::Needs(&["force"], &["synthesise"]),
        Rule::Needs(RecordLayout::KEYS, &["file"]),
    ];

    fn ask(&self, client: &dyn Client) -> Result<Box<dyn Answer>> {
        Ok(match self.measured(client)? {
            Some(MeasuredAnswer::Profile(answer)) => answer,
            Some(MeasuredAnswer::Spectra(answer)) => answer,
            None => {
                let recipe = self.synthesise.as_deref().filter(|path| !path.as_os_str().is_empty());
                Box::new(Synthesised::new(recipe, self.output.clone(), self.force)?)
            }
        })
    }
}
