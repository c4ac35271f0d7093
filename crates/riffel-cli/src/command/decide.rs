//! `riffel decide`

use riffel_answers::decide::DecideAnswer;
use riffel_calibrate::finished;

use crate::arguments::Decide;
use crate::results::Results;

pub(crate) fn run(arguments: &Decide) -> miette::Result<()> {
    let (plan, chains) = finished(&arguments.folder, arguments.plan.as_deref())?;
    let answer = DecideAnswer::new(&plan, &chains)?;
    Ok(Results::in_folder("decide", &arguments.folder, None, arguments.json).answer(&answer)?)
}
