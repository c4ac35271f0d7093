//! What is asked of variants, of remedies and of the models of the field.

use std::borrow::Cow;
use std::path::Path;
use std::sync::Arc;

use riffel::forecast::SpeedDistribution;
use riffel_case::model::FieldModel;
use riffel_case::traffic::{Traffic, UsualTraffic};
use riffel_case::{Case, Hold, Variant};
use riffel_keys::quantity::{Quantity, Speed};
use riffel_keys::{CaseError, Message, say, shown_speed};
use riffel_rail::Survey;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;
use serde_json::json;

use super::{CompareAnswer, CompareRequest, compare_over};
use crate::models::{ModelsAnswer, ModelsRequest};
use crate::question::{
    AsWritten, CaseSource, Client, EarlierRecords, GroundSource, Money, PosteriorSource, Question, RecordLayout, Rule,
    Source, of_keys, over,
};
use crate::remedies::RemediesAnswer;
use crate::{Answer, Result, level_limit};

/// What would help: growth on a case and on variants of it, side by side.
#[derive(Debug, Deserialize, JsonSchema)]
pub struct CompareQuestion {
    /// The case.
    #[serde(flatten)]
    pub case: CaseSource,
    /// File of changes to the case and its speeds; may be repeated.
    #[serde(rename = "with")]
    #[schemars(extend("value_name" = "TOML"))]
    pub variants: Vec<Source<Variant>>,
    /// Remedies in place of variants: those that the case has keys for, ranked by what each does to growth.
    remedies: bool,
    /// What a remedy costs by its id in --json, as in --cost softer-pads=9000, in one currency for all; what then gains
    /// most months of grinding interval for it comes first; may be repeated.
    #[serde(rename = "cost")]
    #[schemars(with = "Vec<String>", extend("value_name" = "REMEDY=NUMBER"))]
    costs: Vec<Cost>,
    /// The case by models of the field in place of variants: all that fit, or those named, as in --models
    /// grassie-johnson-1985,riffel.
    #[schemars(extend("value_name" = "NAMES", "alone" = "all"))]
    models: Option<Models>,
    /// Speed of the wheel of the case, in m/s or with its unit [default: the usual traffic of its line].
    pub speed: Option<AsWritten<Speed>>,
    /// Standard deviation of the speed.
    #[schemars(extend("value_name" = "SPEED"))]
    speed_deviation: Option<Quantity<Speed>>,
    /// Traffic file, in place of the wheel of the case.
    #[schemars(extend("value_name" = "TOML"))]
    pub traffic: Option<Source<Traffic>>,
    /// A calibration of the case.
    #[serde(flatten)]
    pub posterior: PosteriorSource,
    /// What variants of friction or load hold: force, ratio (Q₀/μP₀) or creepage [default: what the case or the
    /// vehicle gives, ratio or creepage].
    #[schemars(extend("value_name" = "WHAT", "tells_words" = true))]
    pub hold: Option<Hold>,
    /// Measured rail, to say when each variant reaches the limit; of several dates growth goes on as measured.
    #[schemars(extend("value_name" = "FILE"))]
    pub spectrum: Option<Source<Survey>>,
    /// Records before the spectrum.
    #[serde(flatten)]
    earlier: EarlierRecords,
    /// The rail that will be ground.
    #[serde(flatten)]
    pub ground: GroundSource,
    /// How the records are read.
    #[serde(flatten)]
    layout: RecordLayout,
    /// Keep the spectra of a table whose column has this value; may be repeated.
    #[serde(rename = "where")]
    #[schemars(extend("value_name" = "COLUMN=VALUE"))]
    choose: Vec<String>,
    /// Limit of the levels, by name or as a TOML file.
    #[schemars(extend("default" = "iso-3095-2013"))]
    limit: String,
}

/// What a remedy costs, by its id.
#[derive(Debug, Deserialize)]
#[serde(try_from = "String")]
struct Cost(String, Money);

impl TryFrom<String> for Cost {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        match text.split_once('=') {
            Some((id, sum)) if !sum.trim().is_empty() => Ok(Self(id.trim().to_owned(), sum.parse()?)),
            _ => Err("write it as in softer-pads=9000".to_owned()),
        }
    }
}

/// Models of the field that are named; none for all that fit.
#[derive(Debug, Deserialize)]
#[serde(try_from = "String")]
struct Models(Vec<&'static FieldModel>);

impl TryFrom<String> for Models {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        match &*text {
            "all" => Ok(Self(Vec::new())),
            names => FieldModel::named(names.split(',').map(str::trim)).map(Self).map_err(|error| error.to_string()),
        }
    }
}

impl JsonSchema for Models {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "Models".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "string" })
    }
}

impl CompareQuestion {
    /// Variants of a case under a limit, all else by default; the variants are not there yet.
    ///
    /// # Errors
    /// None but those of a default that does not fit its key.
    pub fn of_variants(case: CaseSource, limit: &str) -> Result<Self> {
        let question: Self = of_keys(json!({ "case": "", "with": [""], "limit": limit }))?;
        Ok(Self { case, variants: Vec::new(), ..question })
    }

    /// The comparison of variants on a case that was read; `client` is told how far it is and what is unusual.
    ///
    /// # Errors
    /// [`AnswerError::Argument`](crate::AnswerError::Argument) with the key at fault, [`AnswerError::Case`](crate::AnswerError::Case) with the key or the file.
    pub fn answer_on(&self, case: &Case, client: &dyn Client) -> Result<CompareAnswer> {
        let read = |path: &Path| self.layout.survey(path, client);
        let survey = self.spectrum.as_ref().map(|source| source.value(read)).transpose()?;
        let variant = |source: &Source<Variant>| {
            let mut variant = Arc::unwrap_or_clone(source.value(Variant::read)?);
            variant.hold = self.hold;
            Ok(variant)
        };
        let variants = self.variants.iter().map(variant).collect::<Result<Vec<_>, CaseError>>()?;
        let draws = self.posterior.draws(&self.case, client)?;
        let (traffic, speeds) = match draws.as_ref().and_then(|draws| draws.traffic.clone()) {
            Some(traffic) => titled(traffic),
            None => self.traffic(case, client)?,
        };
        let limit = level_limit(&self.limit)?;
        let ground = self.ground.read(&limit, client)?;
        let path = self.spectrum.as_ref().and_then(Source::path);
        let dated =
            |survey| self.earlier.of_dates(Arc::unwrap_or_clone(survey), path, &self.layout, &self.choose, client);
        let survey = survey.map(dated).transpose()?;
        let steps = (1 + variants.len()) * traffic.file.vehicle.len();
        let hold = self.hold;
        let mut request =
            CompareRequest { variants, traffic, speeds, hold, survey, ground, limit, over_posterior: None };
        request.over_posterior = over(draws.as_ref(), client, |draws, step| compare_over(draws, &request, step))?;
        let survey = request.survey.clone();
        let answer = CompareAnswer::new(case, request, &client.begin(say!(progress_variants), steps));
        answer.map_err(|error| self.ground.outside(survey.as_ref(), case, error))
    }

    /// The traffic with its speeds in words: that of the file, the wheel of the case at the speed that is asked for, or the usual one
    /// of its line.
    fn traffic(&self, case: &Case, client: &dyn Client) -> Result<(Traffic, Message)> {
        if let Some(traffic) = &self.traffic {
            return Ok(titled(Traffic::clone(&*traffic.value(Traffic::read)?)));
        }
        let Some(mean) = &self.speed else {
            let usual = UsualTraffic::of(case);
            return Ok((usual.traffic()?, say!(compared_under, traffic = usual.in_words())));
        };
        let mean = mean.within("--speed", client)?;
        let deviation = self.speed_deviation.map_or(0.0, |speed| speed.si());
        let speeds = SpeedDistribution::normal(mean, deviation)
            .map_err(|error| CaseError::Physics { input: "--speed-deviation".to_owned(), error })?;
        let speed = shown_speed(speeds.mean(), 1);
        let words = match speeds.deviation() {
            0.0 => say!(at_speed, speed),
            deviation => say!(at_spread_speed, speed, deviation = shown_speed(deviation, 1)),
        };
        Ok((Traffic::of_case(speeds), words))
    }

    fn by_models(&self, models: &[&'static FieldModel], client: &dyn Client) -> Result<ModelsAnswer> {
        let speed = self.speed.as_ref().map(|speed| speed.within("--speed", client)).transpose()?;
        let case = self.case.read(client)?;
        let steps = match models.len() {
            0 => FieldModel::all().len(),
            named => named,
        };
        let request = ModelsRequest { models: models.to_vec(), speed };
        ModelsAnswer::new(&case, &request, &client.begin(say!(progress_models), steps))
    }

    fn remedies(&self, client: &dyn Client) -> Result<RemediesAnswer> {
        let case = self.case.read(client)?;
        let traffic = self.traffic.as_ref().map(|traffic| traffic.value(Traffic::read)).transpose()?;
        let step = client.begin(say!(progress_remedies), RemediesAnswer::steps(&case));
        let answer = RemediesAnswer::new(&case, traffic.as_deref(), &step)?;
        answer.with_costs(&self.costs.iter().map(|Cost(id, sum)| (id.clone(), sum.0)).collect())
    }
}

/// A traffic with its title.
fn titled(traffic: Traffic) -> (Traffic, Message) {
    let title = traffic.file.title.clone();
    (traffic, title.map_or_else(|| say!(traffic_word), Message::verbatim))
}

/// Keys of a record of the rail, and how it is judged.
const OF_RECORDS: [&str; 7] = ["with", "hold", "spectrum", "ground", "from_limit", "where", "limit"];

impl Question for CompareQuestion {
    const NAME: &'static str = "compare";
    const EXAMPLE: &'static str = "\
        Example: riffel compare case.toml --with soft-pads.toml --with slower.toml --speed \"100 km/h\"\n\n\
        A file of changes has a title and the keys of the case that change, in their tables:\n\n  \
        title = \"soft pads, slower\"\n  [track]\n  pad = { stiffness = \"120 MN/m\" }\n  [speed]\n  factor = 0.8\n\n\
        [speed] takes mean or factor, and standard_deviation or standard_deviation_factor. What lasts longest after grinding: \
        riffel compare case.toml --with soft-pads.toml --traffic traffic.toml --from-limit \"-6 dB\"\n\n\
        What helps most: riffel compare case.toml --remedies\n\n\
        The same case by the models of the field: riffel compare case.toml --models --speed \"100 km/h\"";
    const RULES: &'static [Rule] = &[
        Rule::OneOf(&["models", "remedies"]),
        Rule::Excludes("remedies", &OF_RECORDS),
        Rule::Excludes("remedies", &["speed", "posterior"]),
        Rule::Excludes("models", &OF_RECORDS),
        Rule::Excludes("models", &["speed_deviation", "traffic"]),
        Rule::AnyOf(&["with", "models", "remedies"]),
        Rule::Needs(&["cost"], &["remedies"]),
        Rule::OneOf(&["speed", "traffic", "posterior"]),
        Rule::Needs(&["speed_deviation"], &["speed"]),
        Rule::Needs(&["earlier"], &["spectrum"]),
        Rule::Needs(RecordLayout::KEYS, &["spectrum"]),
        EarlierRecords::RULE,
        Rule::OneOf(&["ground", "from_limit"]),
        Rule::Needs(&["where"], &["spectrum"]),
    ];

    fn ask(&self, client: &dyn Client) -> Result<Box<dyn Answer>> {
        if let Some(Models(models)) = &self.models {
            return Ok(Box::new(self.by_models(models, client)?));
        }
        if self.remedies {
            return Ok(Box::new(self.remedies(client)?));
        }
        Ok(Box::new(self.answer_on(&*self.case.read(client)?, client)?))
    }
}
