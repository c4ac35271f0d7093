//! `riffel calibrate check`

use riffel_answers::calibration_check::CalibrationCheck;
use riffel_answers::{Answer, level_limit};
use riffel_calibrate::{Plan, Simulated};

use super::LIMIT;
use crate::arguments::CheckCalibration;
use crate::messages::{complain, language, print_remarks};
use crate::output::{json, print};
use crate::progress::Progress;
use crate::results::readable;
use crate::staging::{INTERRUPTED, Staging, stop_on_interrupt};
use crate::threads::on_threads;

/// The truth does not lie anywhere among the draws.
const UNEVEN: u8 = 1;

pub(super) fn run(arguments: &CheckCalibration) -> miette::Result<u8> {
    let plan = Plan::read(&arguments.plan)?;
    let (_, limit) = level_limit(LIMIT)?;
    let stop = stop_on_interrupt();
    let progress = Progress::counting(riffel_keys::say!(progress_simulations), arguments.runs);
    let work = || Simulated::of(&plan, arguments.runs, &limit, &|done| progress.advance(done as usize), &stop);
    let Some(simulated) = on_threads(arguments.threads, work)?? else {
        complain(riffel_keys::say!(check_stopped));
        return Ok(INTERRUPTED);
    };
    let answer = CalibrationCheck::new(plan.file.title.clone(), simulated);
    print(&match arguments.json {
        true => json(&answer),
        false => readable(&answer),
    })?;
    if let Some(folder) = &arguments.output {
        let mut staging = Staging::new("calibrate check", folder)?;
        for file in answer.files() {
            staging.write_result(file)?;
        }
        staging.write(answer.document_name(), json(&answer))?;
        let files = staging.publish()?.join(" ");
        if !arguments.json {
            print(&format!("{}: {files}\n", folder.display()))?;
        }
    }
    print_remarks(&plan.remarks);
    let doubts = answer.doubts();
    doubts.iter().for_each(|doubt| complain(doubt.text(language())));
    Ok(if doubts.is_empty() { 0 } else { UNEVEN })
}
