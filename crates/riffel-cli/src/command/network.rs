//! `riffel network`

use std::path::Path;

use riffel_answers::network::{ChartAnswer, GrowthAnswer, IngestedAnswer, PlanAnswer, StatusAnswer, WorstAnswer};
use riffel_answers::{Answer, ExpectedRates};
use riffel_case::Case;
use riffel_case::traffic::Traffic;
use riffel_keys::{Message, number, say};
use riffel_network::{
    Aim, Budget, ExpectedGrowth, Judgement, NetworkError, Store, StoreSettings, StripChart, SurveyFile, growth,
    left_out_of_growth, plan, status, worst,
};
use riffel_rail::{LimitTable, read_date};

use crate::arguments::{CaseArguments, Judged, Network, NetworkCommand, Posterior, network, positive};
use crate::error::CliError;
use crate::messages::{language, print_remarks};
use crate::output::{json_of, print};
use crate::progress::Progress;
use crate::results::{Results, readable};

pub(crate) fn run(arguments: &Network) -> miette::Result<()> {
    match &arguments.command {
        NetworkCommand::Ingest(arguments) => ingest(arguments),
        NetworkCommand::Status(arguments) => {
            let store = Store::open(&arguments.store)?;
            tell(arguments.json, &StatusAnswer(status(&store)?))?;
            tell_left_out(&store)
        }
        NetworkCommand::Worst(arguments) => {
            let (store, judgement, section) = judged(&arguments.judged)?;
            let until = arguments.until.as_deref().map(|text| day("--until", text));
            let most = arguments.most as usize;
            let found = worst(&store, &judgement, section, until.transpose()?, most)?;
            tell(arguments.judged.json, &WorstAnswer::new(found, &judgement))?;
            tell_left_out(&store)
        }
        NetworkCommand::Growth(arguments) => {
            let (store, judgement, section) = judged(&arguments.judged)?;
            let judgement = expecting(&store, judgement, &arguments.expected)?;
            let between = match (&arguments.from, &arguments.to) {
                (Some(from), Some(to)) => Some([day("--from", from)?, day("--to", to)?]),
                _ => None,
            };
            let mut found = growth(&store, &judgement, section, between)?;
            found.truncate(arguments.most as usize);
            let left_out = left_out_of_growth(&store, between)?;
            tell(arguments.judged.json, &GrowthAnswer::new(found, &judgement, left_out))?;
            tell_left_out(&store)
        }
        NetworkCommand::Chart(arguments) => chart(arguments),
        NetworkCommand::Plan(arguments) => {
            let (store, judgement, section) = judged(&arguments.judged)?;
            let judgement = expecting(&store, judgement, &arguments.expected)?;
            let budget = match (arguments.length, arguments.money, arguments.cost_per_metre) {
                (Some(length), ..) => Budget::of_length(positive("--length", length)?),
                (None, money, per_metre) => Budget {
                    money: money.unwrap_or(0.0),
                    per_metre: per_metre.unwrap_or(1.0),
                    per_site: arguments.cost_per_site,
                },
            };
            let aim = match arguments.most_track {
                true => Aim::MostTrack,
                false => Aim::WorstFirst,
            };
            let found = plan(&store, &judgement, section, arguments.months, &budget, aim)?;
            tell(arguments.judged.json, &PlanAnswer::new(found, arguments.money.is_some()))?;
            tell_left_out(&store)
        }
        NetworkCommand::Check(arguments) => {
            let store = Store::open(&arguments.store)?;
            tell_left_out(&store)?;
            match store.damaged().count() {
                0 => Ok(print(&printed(&say!(surveys_are_whole, count = number(store.surveys()?.len()))))?),
                damaged => Err(NetworkError::NotWhole { damaged }.into()),
            }
        }
    }
}

/// Name the surveys of which something is lost or damaged.
fn tell_left_out(store: &Store) -> miette::Result<()> {
    let damaged = store.damaged();
    let remarks: Vec<Message> = damaged.map(|error| say!(survey_is_left_out, reason = error.to_string())).collect();
    print_remarks(&remarks);
    Ok(())
}

fn tell(as_json: bool, answer: &dyn Answer) -> miette::Result<()> {
    let text = if as_json { json_of(|| answer.document()) } else { readable(answer) };
    print(&text)?;
    print_remarks(answer.remarks());
    Ok(())
}

fn ingest(arguments: &network::Ingest) -> miette::Result<()> {
    let resolution = arguments.resolution;
    let settings = StoreSettings { resolution: resolution.map(|length| positive("--resolution", length)).transpose()? };
    let store = Store::create_or_open(&arguments.store, settings)?;
    let file = SurveyFile::check(&arguments.path)?;
    let file = file.rename(arguments.rename.iter().cloned().collect())?;
    let progress = Progress::new(riffel_keys::say!(progress_taking_in_blocks), file.rows() as usize);
    let (line, date) = (&arguments.line, &arguments.date);
    let found = store.ingest(line, date, &file, arguments.replace, &|by| progress.advance(by))?;
    drop(progress);
    tell(arguments.json, &IngestedAnswer::new(found))
}

fn chart(arguments: &network::Chart) -> miette::Result<()> {
    let (store, judgement, section) = judged(&arguments.judged)?;
    let (line, rail) = (arguments.line.as_deref(), arguments.rail.as_deref());
    let chart = StripChart::new(&store, &judgement, section, line, rail)?;
    tell_left_out(&store)?;
    if chart.lines.is_empty() {
        return Ok(print(&printed(&say!(no_survey_in_store)))?);
    }
    let mut name = arguments.judged.store.file_name().unwrap_or_default().to_owned();
    name.push("-chart");
    let results = Results::in_folder("network", Path::new(&name), arguments.output.as_deref(), arguments.judged.json);
    Ok(results.answer(&ChartAnswer::new(chart))?)
}

fn printed(message: &Message) -> String {
    message.text(language()) + "\n"
}

/// Store, limit and length of a section.
fn judged(arguments: &Judged) -> miette::Result<(Store, Judgement, f64)> {
    let store = Store::open(&arguments.store)?;
    let judgement = Judgement::new(&store, &LimitTable::find(&arguments.limit)?)?;
    Ok((store, judgement, positive("--section", arguments.section)?))
}

/// The same with the growth that the traffic of a line is expected to make.
fn expecting(store: &Store, judgement: Judgement, expected: &network::Expected) -> miette::Result<Judgement> {
    let Some(case) = &expected.case else {
        return Ok(judgement);
    };
    let bands = judgement.ends_of_bands();
    let posterior = Posterior { posterior: expected.posterior.clone() };
    let growth = match posterior.draws(&CaseArguments::of(case, &[]))? {
        Some(draws) => {
            let progress = Progress::new(riffel_keys::say!(progress_draws_of_calibration), draws.count());
            ExpectedRates::over(&draws, &bands, &|by| progress.advance(by))
        }
        None => {
            let case = Case::read(case, &[])?;
            let traffic = expected.traffic.as_deref().map(Traffic::read).transpose()?;
            ExpectedRates::new(&case, traffic.as_ref(), &bands)
        }
    };
    let growth = growth.map_err(CliError::from)?;
    print_remarks(growth.without_rate.as_slice());
    let growth = growth.of_bands.into_iter().map(|growth| {
        growth.map(|growth| ExpectedGrowth { median: growth.median, band_50: growth.band_50, band_80: growth.band_80 })
    });
    Ok(judgement.expecting(store, expected.line.as_deref(), growth.collect())?)
}

fn day(argument: &'static str, text: &str) -> Result<jiff::civil::Date, CliError> {
    read_date(text).map_err(|sentence| CliError::Range { argument, message: format!(": {sentence}") })
}
