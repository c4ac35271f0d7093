//! `riffel schema`

use clap::CommandFactory;

use crate::arguments::{Arguments, Schema};
use crate::output::print_json;
use crate::question;

pub(crate) fn run(arguments: &Schema) -> miette::Result<()> {
    match arguments {
        Schema { traffic: true, .. } => print_json(&riffel_case::traffic_schema())?,
        Schema { study: true, .. } => print_json(&riffel_study::plan_schema())?,
        Schema { question: name, .. } if !name.is_empty() => {
            let schema = match riffel_answers::question::named(&name.join(" ")) {
                Some(data) => data.schema(),
                None => question::schema(&question::find(&Arguments::command(), name)?, name),
            };
            print_json(&schema)?;
        }
        _ => print_json(&riffel_case::json_schema())?,
    }
    Ok(())
}
