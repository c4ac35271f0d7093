//! `riffel map --wheels`

use riffel_answers::wheels::WheelsAnswer;

use crate::arguments::Map;
use crate::progress::Progress;
use crate::results::Results;

pub(super) fn run(arguments: &Map) -> miette::Result<()> {
    let case = arguments.case.read_at(arguments.position)?;
    let progress = Progress::new(riffel_keys::say!(progress_wheels), WheelsAnswer::rows(&case));
    let answer = WheelsAnswer::new(&case, |rows| progress.advance(rows))?;
    drop(progress);
    let results = Results::of("wheels", &arguments.case, &arguments.results);
    Ok(results.answer(&answer)?)
}
