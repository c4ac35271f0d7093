//! `riffel diagnose`

mod request;

use super::roughness::read;
use crate::arguments::Diagnose;
use crate::results::Results;

pub(crate) use request::diagnosis;

pub(crate) fn run(arguments: &Diagnose) -> miette::Result<()> {
    let case = arguments.case.read()?;
    let record = read(&arguments.roughness, &arguments.record.layout)?;
    let diagnosis = diagnosis(&case, &arguments.roughness, &record, &arguments.record)?;
    let results = Results::of("diagnosis", &arguments.case, &arguments.results);
    Ok(results.by("diagnose").answer(&diagnosis)?)
}
