//! What is asked of a report.

use std::path::PathBuf;

use riffel_case::{Case, Hold, Variant};
use riffel_keys::say;
use riffel_rail::RoughnessFile;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::working::Working;
use super::{GENERATOR, Site};
use crate::diagnose::DiagnosedRail;
use crate::question::{Client, EarlierRecords, Files, GroundSource, Question, RecordLayout, Rule, Source};
use crate::{Answer, AnswerError, Existing, OwnText, Result};

/// One printable page: roughness, limits, what to grind, growth map, diagnosis, forecast, what-if.
#[derive(Debug, Deserialize, JsonSchema)]
pub struct ReportQuestion {
    /// Case file, for growth map and diagnosis [default: none, and the report goes without them].
    #[schemars(extend("positional" = true))]
    pub(super) case: Option<Source<Case>>,
    /// Override a value of the case, as in --set contact.friction=0.3; may be repeated.
    #[schemars(extend("value_name" = "KEY=VALUE"))]
    pub(super) set: Vec<String>,
    /// Longitudinal profile, or table of one-third-octave levels [default: none, and the report is on the case].
    #[schemars(extend("value_name" = "FILE"))]
    pub(super) roughness: Option<Source<RoughnessFile>>,
    /// Folder of a finished calibration of the case: growth, what becomes of the rail, variants and noise over its draws.
    #[schemars(with = "Option<String>", extend("value_name" = "DIR", "path" = true))]
    pub(super) posterior: Option<PathBuf>,
    #[serde(flatten)]
    pub(super) rail: DiagnosedRail,
    /// Limit table, by name or as a TOML file; may be repeated [default: iso-3095-2013, grassie-1999].
    pub(super) limit: Vec<String>,
    /// File of changes to the case, as for riffel compare; may be repeated.
    #[serde(rename = "with")]
    #[schemars(extend("value_name" = "TOML"))]
    pub(super) variants: Vec<Source<Variant>>,
    /// What variants of friction or load hold, as for riffel compare: force, ratio or creepage.
    #[schemars(extend("value_name" = "WHAT", "tells_words" = true))]
    pub(super) hold: Option<Hold>,
    #[serde(flatten)]
    pub(super) ground: GroundSource,
    /// Months that the forecast looks ahead.
    #[schemars(extend("value_name" = "M"))]
    pub(super) months: Option<f64>,
    /// Let growth go by the wear coefficient of the case, also where another is fitted to the records; the fit is told.
    pub(super) keep_coefficient: bool,
    /// Axle passages between the oldest --earlier and --roughness, to fit the wear coefficient to [default: from the dates
    /// and the traffic file].
    #[schemars(extend("value_name" = "N"))]
    pub(super) passages_between: Option<f64>,
    /// Highest level of a passing coach that is allowed, to say in how many months it is reached.
    #[schemars(extend("value_name" = "DECIBELS"))]
    pub(super) limit_dba: Option<f64>,
    /// Roughness of the wheels for rolling noise: a file of spectra, or cnossos-cast-iron-blocks, cnossos-composite-blocks or
    /// cnossos-disc-brakes [default: none, smooth wheels].
    #[schemars(with = "Option<Source<()>>", extend("value_name" = "FILE"))]
    pub(super) wheel_roughness: Option<String>,
    /// Modes of the web and tyre of the wheels for rolling noise by name, straight-web-920, or as a TOML file [default: none,
    /// rigid wheels].
    #[schemars(extend("value_name" = "MODES"))]
    pub(super) wheel_modes: Option<String>,
    /// Title [default: that of the site, or "Rail roughness and corrugation"].
    #[schemars(extend("value_name" = "WORDS"))]
    pub(super) title: Option<String>,
    /// TOML file with the table `site`: title, railway, line, track, place, measured_on, instrument, author,
    /// date, remarks.
    #[schemars(extend("value_name" = "TOML"))]
    pub(super) site: Option<Source<Site>>,
    /// Page to write.
    #[schemars(with = "String", extend("value_name" = "HTML", "path" = true, "default" = "report.html"))]
    output: PathBuf,
    /// Replace the file if it is there and is no report of an earlier run.
    force: bool,
}

impl ReportQuestion {
    /// The first option that is for rolling noise, with its value.
    pub(super) fn of_noise(&self) -> Option<(&'static str, String)> {
        let options = [
            ("--limit-dba", self.limit_dba.map(|limit| limit.to_string())),
            ("--wheel-roughness", self.wheel_roughness.clone()),
            ("--wheel-modes", self.wheel_modes.clone()),
        ];
        options.into_iter().find_map(|(option, value)| Some((option, value?)))
    }

    /// The first option that is for a section with a limit of levels.
    pub(super) fn needs_levels(&self) -> Option<&'static str> {
        let options = [
            ("--with", !self.variants.is_empty()),
            ("--ground", self.ground.ground.is_some()),
            ("--from-limit", self.ground.from_limit.is_some()),
            ("--months", self.months.is_some()),
        ];
        let option = options.into_iter().find_map(|(option, is_given)| is_given.then_some(option));
        option.or_else(|| Some(self.of_noise()?.0))
    }

    /// The error of an option that needs a limit of levels, where there is none.
    pub(super) fn without_levels(&self, option: &str) -> AnswerError {
        let rule = format!("a limit of levels where there is a {option}");
        AnswerError::argument("--limit", self.limit.join(", "), rule)
    }
}

/// A report as a page of HTML.
#[derive(Serialize)]
struct ReportAnswer {
    page: String,
    #[serde(skip)]
    path: PathBuf,
    #[serde(skip)]
    force: bool,
}

impl Question for ReportQuestion {
    const NAME: &'static str = "report";
    const EXAMPLE: &'static str = "\
        Example: riffel report case.toml --roughness profile.csv --traffic traffic.toml --with soft-pads.toml --site site.toml -o report.html\n\n\
        Without --roughness it is a report on the case alone: its growth map and, by --with, what would help.\n\n\
        With an earlier record and the traffic since then, the wear coefficient is fitted to the change, and where its 95 % \
        interval lies above zero the whole report goes by it in place of that of the case.";
    const RULES: &'static [Rule] = &[
        Rule::Needs(&["set", "posterior"], &["case"]),
        Rule::Needs(RecordLayout::KEYS, &["roughness"]),
        EarlierRecords::RULE,
        Rule::Needs(&["earlier", "where", "by", "speed", "torsion", "bending", "from_vehicle"], &["roughness"]),
        Rule::Needs(&["earlier", "speed", "torsion", "bending", "from_vehicle", "traffic", "with"], &["case"]),
        Rule::Needs(&["hold"], &["with"]),
        Rule::OneOf(&["ground", "from_limit"]),
        Rule::Needs(&["ground", "from_limit"], &["traffic", "with"]),
        Rule::Needs(&["months"], &["traffic"]),
        Rule::Needs(&["months"], &["roughness", "posterior"]),
        Rule::Needs(&["keep_coefficient"], &["case"]),
        Rule::Needs(&["passages_between", "limit_dba"], &["traffic"]),
        Rule::Needs(&["wheel_roughness", "wheel_modes", "limit_dba"], &["roughness"]),
        Rule::Needs(&["wheel_roughness", "wheel_modes"], &["case"]),
        Rule::AnyOf(&["roughness", "case"]),
    ];
    const FILES: Files = Files::Text;

    fn ask(&self, client: &dyn Client) -> Result<Box<dyn Answer>> {
        let page = Working::new(self, client)?.page()?;
        Ok(Box::new(ReportAnswer { page, path: self.output.clone(), force: self.force }))
    }
}

impl Answer for ReportAnswer {
    fn name(&self) -> &'static str {
        "report"
    }

    fn has_files(&self) -> bool {
        false
    }

    fn own_text(&self) -> Option<OwnText<'_>> {
        Some(OwnText {
            path: Some(&self.path),
            text: (&*self.page).into(),
            existing: if self.force { Existing::Replaced } else { Existing::ReplacedIfKnown(Some(GENERATOR)) },
            written: Some(say!(report_is_written, file = self.path.display().to_string())),
        })
    }
}
