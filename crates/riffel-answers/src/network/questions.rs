//! What is asked of the surveys of many lines.

use std::path::PathBuf;

use jiff::civil::Date;
use riffel_case::Case;
use riffel_case::traffic::Traffic;
use riffel_keys::quantity::{Length, Quantity};
use riffel_keys::{Message, say};
use riffel_network::{
    Aim, Budget, ExpectedGrowth, Judgement, NetworkError, Store, StoreSettings, StripChart, SurveyFile, growth,
    left_out_of_growth, plan, status, worst,
};
use riffel_rail::{LimitTable, read_date};
use schemars::JsonSchema;
use serde::Deserialize;

use super::{ChartAnswer, GrowthAnswer, IngestedAnswer, PlanAnswer, StatusAnswer, WholeAnswer, WorstAnswer};
use crate::question::{CaseSource, Client, Files, Money, PosteriorSource, Question, Rule, Source, positive};
use crate::{Answer, AnswerError, ExpectedRates, Result};

/// The folder of a store.
#[derive(Debug, Deserialize, JsonSchema)]
struct InStore {
    /// Folder of the store.
    #[schemars(with = "String", extend("positional" = true, "path" = true))]
    store: PathBuf,
}

/// What sections are judged by.
#[derive(Debug, Deserialize, JsonSchema)]
struct Judged {
    #[serde(flatten)]
    store: InStore,
    /// Limit of the RMS in bands of wavelength, by name or as a TOML file.
    #[schemars(extend("default" = "grassie-1999"))]
    limit: String,
    /// Length of a section.
    #[schemars(extend("value_name" = "LENGTH", "default" = "100 m"))]
    section: Quantity<Length>,
}

/// What the traffic of a line is expected to make of it.
#[derive(Debug, Deserialize, JsonSchema)]
struct Expected {
    /// Case file of the track: growth that its traffic is expected to make stands beside that of the surveys, and in its place
    /// where a line has one survey or was ground.
    #[schemars(extend("value_name" = "CASE"))]
    case: Option<Source<Case>>,
    /// Traffic file [default: the usual traffic of a line of this kind].
    #[schemars(extend("value_name" = "TOML"))]
    traffic: Option<Source<Traffic>>,
    /// Folder of a finished calibration of the case: growth over its draws and under its traffic.
    #[schemars(with = "Option<String>", extend("value_name" = "DIR", "path" = true))]
    posterior: Option<PathBuf>,
    /// The line that the case is of [default: all].
    #[schemars(extend("value_name" = "NAME"))]
    line: Option<String>,
}

impl InStore {
    fn open(&self) -> Result<Store> {
        Ok(Store::open(&self.store)?)
    }
}

impl Judged {
    /// Store, limit and length of a section.
    fn open(&self) -> Result<(Store, Judgement, f64)> {
        let store = self.store.open()?;
        let judgement = Judgement::new(&store, &LimitTable::find(&self.limit)?)?;
        Ok((store, judgement, positive("--section", self.section)?))
    }
}

impl Expected {
    /// A judgement with the growth that the traffic of a line is expected to make.
    fn of(&self, store: &Store, judgement: Judgement, client: &dyn Client) -> Result<Judgement> {
        let Some(case) = &self.case else {
            return Ok(judgement);
        };
        let bands = judgement.ends_of_bands();
        let case = CaseSource::new(case.clone(), Vec::new());
        let posterior = PosteriorSource { posterior: self.posterior.clone() };
        let growth = match posterior.draws(&case, client)? {
            Some(draws) => {
                let step = client.begin(say!(progress_draws_of_calibration), draws.count());
                ExpectedRates::over(&draws, &bands, &step)?
            }
            None => {
                let traffic = self.traffic.as_ref().map(|traffic| traffic.value(Traffic::read)).transpose()?;
                ExpectedRates::new(&*case.read(client)?, traffic.as_deref(), &bands)?
            }
        };
        client.remark(growth.without_rate.as_slice());
        let growth = growth.of_bands.into_iter().map(|growth| {
            growth.map(|growth| ExpectedGrowth {
                median: growth.median,
                band_50: growth.band_50,
                band_80: growth.band_80,
            })
        });
        Ok(judgement.expecting(store, self.line.as_deref(), growth.collect())?)
    }
}

/// Name the surveys of which something is lost or damaged; returns how many there are.
fn tell_damaged(store: &Store, client: &dyn Client) -> usize {
    let damaged = store.damaged().map(|error| say!(survey_is_left_out, reason = error.to_string()));
    let damaged: Vec<Message> = damaged.collect();
    client.remark(&damaged);
    damaged.len()
}

/// An answer, with the surveys named of which something is lost or damaged.
fn told(answer: impl Answer + 'static, store: &Store, client: &dyn Client) -> Box<dyn Answer> {
    tell_damaged(store, client);
    Box::new(answer)
}

fn day(argument: &'static str, text: &str) -> Result<Date> {
    read_date(text).map_err(|sentence| AnswerError::Range { argument, message: format!(": {sentence}") })
}

/// Add a survey of a line at a date; the store is made if need be.
#[derive(Debug, Deserialize, JsonSchema)]
pub struct IngestQuestion {
    #[serde(flatten)]
    store: InStore,
    /// Blocks along the rails, as `riffel axlebox` and `riffel roughness` write them: rail,from_m,to_m and
    /// rms_30_to_100_mm_m for each band.
    #[schemars(with = "Source<()>", extend("positional" = true, "value_name" = "CSV"))]
    csv: PathBuf,
    /// The line.
    #[schemars(extend("value_name" = "NAME"))]
    line: String,
    /// Day of the survey, as in 2026-01-31.
    date: String,
    /// Length of a cell of a new store [default: that of most blocks].
    #[schemars(extend("value_name" = "LENGTH"))]
    resolution: Option<Quantity<Length>>,
    /// Call a rail of the file by another name; may be repeated. Without it "Höhe links", "L", "1" or "gauche" is the rail that the
    /// line calls left.
    #[schemars(with = "Vec<String>", extend("value_name" = "OLD=NEW"))]
    rename: Vec<Renamed>,
    /// Put it in the place of another survey of the line on that day.
    replace: bool,
}

/// The name of a rail and another one for it.
#[derive(Debug, Clone, Deserialize)]
#[serde(try_from = "String")]
struct Renamed([String; 2]);

impl TryFrom<String> for Renamed {
    type Error = &'static str;

    fn try_from(text: String) -> Result<Self, &'static str> {
        match text.split_once('=').map(|(old, new)| (old.trim(), new.trim())) {
            Some((old, new)) if !old.is_empty() && !new.is_empty() => Ok(Self([old, new].map(str::to_owned))),
            _ => Err("must be OLD=NEW"),
        }
    }
}

impl Question for IngestQuestion {
    const NAME: &'static str = "network ingest";
    const EXAMPLE: &'static str = "Example: riffel network ingest railway blocks.csv --line \"Main line\" --date 2026-01-31\n\n\
        The same survey again changes nothing, and one that was stopped is done anew: surveys are there whole or not at all.";
    const FILES: Files = Files::None;

    fn ask(&self, client: &dyn Client) -> Result<Box<dyn Answer>> {
        let resolution = self.resolution.map(|length| positive("--resolution", length)).transpose()?;
        let store = Store::create_or_open(&self.store.store, StoreSettings { resolution })?;
        let renamed = self.rename.iter().map(|Renamed([old, new])| (old.clone(), new.clone()));
        let file = SurveyFile::check(&self.csv)?.rename(renamed.collect())?;
        let step = client.begin(say!(progress_taking_in_blocks), file.rows() as usize);
        Ok(Box::new(IngestedAnswer::new(store.ingest(&self.line, &self.date, &file, self.replace, &step)?)))
    }
}

/// Lines, dates, kilometres and the RMS of the latest surveys.
#[derive(Debug, Deserialize, JsonSchema)]
pub struct StatusQuestion {
    #[serde(flatten)]
    store: InStore,
}

impl Question for StatusQuestion {
    const NAME: &'static str = "network status";
    const EXAMPLE: &'static str = "Example: riffel network status railway";
    const FILES: Files = Files::None;

    fn ask(&self, client: &dyn Client) -> Result<Box<dyn Answer>> {
        let store = self.store.open()?;
        Ok(told(StatusAnswer(status(&store)?), &store, client))
    }
}

/// Sections of the latest surveys that are farthest over their limit.
#[derive(Debug, Deserialize, JsonSchema)]
pub struct WorstQuestion {
    #[serde(flatten)]
    judged: Judged,
    /// The state of this day [default: of the latest surveys].
    #[schemars(extend("value_name" = "DATE"))]
    until: Option<String>,
    /// Show so many sections.
    #[schemars(range(min = 1, max = 4_294_967_295_u32), extend("value_name" = "N", "default" = 20))]
    most: u32,
}

impl Question for WorstQuestion {
    const NAME: &'static str = "network worst";
    const EXAMPLE: &'static str = "Example: riffel network worst railway --section \"200 m\" --most 10";
    const FILES: Files = Files::None;

    fn ask(&self, client: &dyn Client) -> Result<Box<dyn Answer>> {
        let (store, judgement, section) = self.judged.open()?;
        let until = self.until.as_deref().map(|text| day("--until", text)).transpose()?;
        let found = worst(&store, &judgement, section, until, self.most as usize)?;
        Ok(told(WorstAnswer::new(found, &judgement), &store, client))
    }
}

/// How sections grew over their surveys, or between two dates, and when they reach their limit.
#[derive(Debug, Deserialize, JsonSchema)]
pub struct GrowthQuestion {
    #[serde(flatten)]
    judged: Judged,
    #[serde(flatten)]
    expected: Expected,
    /// The earlier day: growth begins with the latest survey up to it [default: with the first survey].
    #[schemars(extend("value_name" = "DATE"))]
    from: Option<String>,
    /// The later day: growth ends with the latest survey up to it [default: with the last survey].
    #[schemars(extend("value_name" = "DATE"))]
    to: Option<String>,
    /// Show so many sections.
    #[schemars(range(min = 1, max = 4_294_967_295_u32), extend("value_name" = "N", "default" = 20))]
    most: u32,
}

impl Question for GrowthQuestion {
    const NAME: &'static str = "network growth";
    const EXAMPLE: &'static str = "Examples:\n  riffel network growth railway --from 2025-01-31 --to 2026-01-31\n  \
        riffel network growth railway --line \"Main line\" --case case.toml --traffic traffic.toml";
    const RULES: &'static [Rule] = &[
        Rule::OneOf(&["traffic", "posterior"]),
        Rule::Needs(&["traffic", "posterior", "line"], &["case"]),
        Rule::Needs(&["from"], &["to"]),
        Rule::Needs(&["to"], &["from"]),
    ];
    const FILES: Files = Files::None;

    fn ask(&self, client: &dyn Client) -> Result<Box<dyn Answer>> {
        let (store, judgement, section) = self.judged.open()?;
        let judgement = self.expected.of(&store, judgement, client)?;
        let between = match (&self.from, &self.to) {
            (Some(from), Some(to)) => Some([day("--from", from)?, day("--to", to)?]),
            _ => None,
        };
        let mut found = growth(&store, &judgement, section, between)?;
        found.truncate(self.most as usize);
        let left_out = left_out_of_growth(&store, between)?;
        Ok(told(GrowthAnswer::new(found, &judgement, left_out), &store, client))
    }
}

/// What to grind with a budget.
#[derive(Debug, Deserialize, JsonSchema)]
pub struct PlanQuestion {
    #[serde(flatten)]
    judged: Judged,
    #[serde(flatten)]
    expected: Expected,
    /// Plan for the state in so many months.
    #[schemars(extend("value_name" = "M", "default" = 12))]
    months: f64,
    /// Length of track that can be ground.
    #[schemars(extend("value_name" = "LENGTH"))]
    length: Option<Quantity<Length>>,
    /// Money that can be spent.
    money: Option<Money>,
    /// Cost of a metre of track.
    #[schemars(extend("value_name" = "MONEY"))]
    cost_per_metre: Option<Money>,
    /// Choose the sites that bring the most track below its limit, not the worst sections first.
    most_track: bool,
    /// Cost of each site, besides.
    #[schemars(extend("value_name" = "MONEY", "default" = 0))]
    cost_per_site: Money,
}

impl Question for PlanQuestion {
    const NAME: &'static str = "network plan";
    const EXAMPLE: &'static str = "Examples:\n  riffel network plan railway --months 12 --length \"20 km\"\n  \
        riffel network plan railway --months 12 --money 500000 --cost-per-metre 12 --cost-per-site 3000 --most-track";
    const RULES: &'static [Rule] = &[
        Rule::OneOf(&["traffic", "posterior"]),
        Rule::Needs(&["traffic", "posterior", "line"], &["case"]),
        Rule::AnyOf(&["length", "money"]),
        Rule::Excludes("length", &["money", "cost_per_metre", "cost_per_site"]),
        Rule::Needs(&["money"], &["cost_per_metre"]),
        Rule::Needs(&["cost_per_metre", "cost_per_site"], &["money"]),
    ];
    const FILES: Files = Files::None;

    fn ask(&self, client: &dyn Client) -> Result<Box<dyn Answer>> {
        let (store, judgement, section) = self.judged.open()?;
        let judgement = self.expected.of(&store, judgement, client)?;
        let budget = match self.length {
            Some(length) => Budget::of_length(positive("--length", length)?),
            None => Budget {
                money: self.money.map_or(0.0, |money| money.0),
                per_metre: self.cost_per_metre.map_or(1.0, |cost| cost.0),
                per_site: self.cost_per_site.0,
            },
        };
        let aim = match self.most_track {
            true => Aim::MostTrack,
            false => Aim::WorstFirst,
        };
        let found = plan(&store, &judgement, section, self.months, &budget, aim)?;
        Ok(told(PlanAnswer::new(found, self.money.is_some()), &store, client))
    }
}

/// Every survey of a line, kilometre by date, as a picture and a table.
#[derive(Debug, Deserialize, JsonSchema)]
pub struct ChartQuestion {
    #[serde(flatten)]
    judged: Judged,
    /// This line alone.
    #[schemars(extend("value_name" = "NAME"))]
    line: Option<String>,
    /// This rail alone [default: the worst of all at each place].
    #[schemars(extend("value_name" = "NAME"))]
    rail: Option<String>,
    /// Folder for the results, made if need be [default: STORE-chart].
    #[schemars(with = "Option<String>", extend("value_name" = "DIR", "path" = true))]
    pub output: Option<PathBuf>,
}

impl Question for ChartQuestion {
    const NAME: &'static str = "network chart";
    const EXAMPLE: &'static str = "Example: riffel network chart railway --line \"Main line\" -o main-line";

    fn ask(&self, client: &dyn Client) -> Result<Box<dyn Answer>> {
        let (store, judgement, section) = self.judged.open()?;
        let chart = StripChart::new(&store, &judgement, section, self.line.as_deref(), self.rail.as_deref())?;
        Ok(told(ChartAnswer::new(chart), &store, client))
    }
}

/// Read all of a store and name what is lost or damaged.
#[derive(Debug, Deserialize, JsonSchema)]
pub struct CheckQuestion {
    #[serde(flatten)]
    store: InStore,
}

impl Question for CheckQuestion {
    const NAME: &'static str = "network check";
    const EXAMPLE: &'static str = "Example: riffel network check railway";
    const FILES: Files = Files::None;

    fn ask(&self, client: &dyn Client) -> Result<Box<dyn Answer>> {
        let store = self.store.open()?;
        match tell_damaged(&store, client) {
            0 => Ok(Box::new(WholeAnswer { surveys: store.surveys()?.len() })),
            damaged => Err(NetworkError::NotWhole { damaged }.into()),
        }
    }
}
