//! `riffel schema`

use clap::CommandFactory;

use crate::arguments::{Arguments, Schema};
use crate::output::print_json;
use crate::question;

pub(crate) fn run(arguments: &Schema) -> miette::Result<()> {
    match arguments {
        Schema { traffic: true, .. } => print_json(&riffel_case::traffic_schema())?,
        Schema { study: true, .. } => print_json(&riffel_study::plan_schema())?,
        Schema { question, .. } if !question.is_empty() => {
            let command = question::find(&Arguments::command(), question)?;
            print_json(&question::schema(&command, question))?;
        }
        _ => print_json(&riffel_case::json_schema())?,
    }
    Ok(())
}
