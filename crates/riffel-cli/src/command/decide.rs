//! `riffel decide`

use riffel_answers::Answer;
use riffel_answers::decide::DecideAnswer;
use riffel_calibrate::finished;

use crate::arguments::Decide;
use crate::messages::print_remarks;
use crate::output::{json, print};
use crate::results::readable;
use crate::staging::Staging;

pub(crate) fn run(arguments: &Decide) -> miette::Result<()> {
    let (plan, chains) = finished(&arguments.folder, arguments.plan.as_deref())?;
    let answer = DecideAnswer::new(&plan, &chains)?;
    if arguments.json {
        print(&json(&answer))?;
    } else {
        let mut staging = Staging::new("decide", &arguments.folder)?;
        staging.write_figure(answer.name(), &answer.figure())?;
        for table in answer.tables() {
            staging.write_with(&format!("{}.csv", table.name), |file| table.csv(file))?;
        }
        staging.write("decision.json", json(&answer))?;
        let files = staging.publish()?.join(" ");
        let folder = arguments.folder.display();
        print(&format!("{}{folder}: {files}\n", readable(&answer)))?;
    }
    print_remarks(answer.remarks());
    Ok(())
}
