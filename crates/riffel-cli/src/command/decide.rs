//! `riffel decide`

use std::path::Path;

use riffel_answers::Answer;
use riffel_answers::decide::DecideAnswer;
use riffel_calibrate::{Chains, Folder, Plan, plan_of};

use crate::arguments::Decide;
use crate::messages::print_remarks;
use crate::output::{json, print};
use crate::results::readable;
use crate::staging::Staging;

/// The plan of a finished calibration and its chains.
pub(crate) fn calibration(folder: &Path, plan: Option<&Path>) -> miette::Result<(Plan, Chains)> {
    let plan = match plan {
        Some(path) => Plan::read(path)?,
        None => Plan::read(&plan_of(folder)?)?,
    };
    let chains = Folder::finished(&plan, folder)?.chains_of_all()?;
    Ok((plan, chains))
}

pub(crate) fn run(arguments: &Decide) -> miette::Result<()> {
    let (plan, chains) = calibration(&arguments.folder, arguments.plan.as_deref())?;
    let answer = DecideAnswer::new(&plan, &chains)?;
    if arguments.json {
        print(&json(&answer))?;
    } else {
        let tables = answer.tables();
        let mut staging = Staging::new("decide", &arguments.folder)?;
        staging.write_figure(DecideAnswer::NAME, &answer.figure())?;
        for table in &tables {
            staging.write_with(&format!("{}.csv", table.name), |file| table.csv(file))?;
        }
        staging.write("decision.json", json(&answer))?;
        let files = staging.publish()?.join(" ");
        let folder = arguments.folder.display();
        print(&format!(
            "{}{folder}: {files}\n",
            readable(&answer, &tables)
        ))?;
    }
    print_remarks(answer.remarks());
    Ok(())
}
