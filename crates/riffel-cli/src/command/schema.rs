//! `riffel schema`

use crate::arguments::Schema;
use crate::output::print_json;

pub(crate) fn run(arguments: &Schema) -> miette::Result<()> {
    print_json(&match arguments {
        Schema { traffic: true, .. } => riffel_case::traffic_schema(),
        Schema { study: true, .. } => riffel_study::plan_schema(),
        _ => riffel_case::json_schema(),
    })?;
    Ok(())
}
