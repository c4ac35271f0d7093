//! `riffel network`

use std::path::Path;

use riffel_answers::network::ChartAnswer;
use riffel_keys::{Message, number, say};
use riffel_network::{Judgement, NetworkError, Store, StripChart};
use riffel_rail::LimitTable;

use crate::arguments::{Judged, Network, NetworkCommand, network, positive};
use crate::messages::{language, print_remarks};
use crate::output::print;
use crate::results::Results;

pub(crate) fn run(arguments: &Network) -> miette::Result<()> {
    match &arguments.command {
        NetworkCommand::Chart(arguments) => chart(arguments),
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
