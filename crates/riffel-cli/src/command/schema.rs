//! `riffel schema`

use crate::arguments::Schema;
use crate::output::print_json;

pub(crate) fn run(arguments: &Schema) {
    print_json(&match arguments.traffic {
        true => riffel_case::traffic_schema(),
        false => riffel_case::json_schema(),
    });
}
