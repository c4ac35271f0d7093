//! `riffel compare --remedies`

use riffel_answers::remedies::RemediesAnswer;
use riffel_case::traffic::Traffic;

use crate::arguments::Compare;
use crate::progress::Progress;
use crate::results::Results;

pub(super) fn run(arguments: &Compare) -> miette::Result<()> {
    let case = arguments.case.read()?;
    let traffic = arguments.traffic.as_deref().map(Traffic::read);
    let traffic = traffic.transpose()?;
    let progress = Progress::new(riffel_keys::say!(progress_remedies), RemediesAnswer::steps(&case));
    let answer = RemediesAnswer::new(&case, traffic.as_ref(), &|by| progress.advance(by))?;
    drop(progress);
    let answer = answer.with_costs(&arguments.costs.iter().cloned().collect())?;
    let results = Results::of("remedies", &arguments.case, &arguments.results);
    Ok(results.answer(&answer)?)
}
