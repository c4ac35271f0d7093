//! `riffel schema`

use riffel_answers::question::known;

use crate::arguments::Schema;
use crate::output::print_json;

pub(crate) fn run(arguments: &Schema) -> miette::Result<()> {
    match arguments {
        Schema { traffic: true, .. } => print_json(&riffel_case::traffic_schema())?,
        Schema { study: true, .. } => print_json(&riffel_study::plan_schema())?,
        Schema { question: name, .. } if !name.is_empty() => print_json(&known(&name.join(" "))?.schema())?,
        _ => print_json(&riffel_case::json_schema())?,
    }
    Ok(())
}
