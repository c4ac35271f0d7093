//! `riffel schema`

use riffel_answers::question::known;

use crate::arguments::Schema;
use crate::output::print_json;
use crate::session::Session;

pub(crate) fn run(session: &Session, arguments: &Schema) -> miette::Result<()> {
    match arguments {
        Schema { traffic: true, .. } => print_json(session.voice, &riffel_case::traffic_schema())?,
        Schema { study: true, .. } => print_json(session.voice, &riffel_study::plan_schema())?,
        Schema { question: name, .. } if !name.is_empty() => {
            print_json(session.voice, &known(&name.join(" "))?.schema())?
        }
        _ => print_json(session.voice, &riffel_case::json_schema())?,
    }
    Ok(())
}
