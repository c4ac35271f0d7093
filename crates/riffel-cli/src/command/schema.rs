//! `riffel schema`

use crate::output::print_json;

pub(crate) fn run() -> miette::Result<()> {
    print_json(&riffel_case::json_schema());
    Ok(())
}
