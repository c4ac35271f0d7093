//! `riffel study sensitivity`

use riffel_answers::study::{SensitivityAnswer, SensitivityRequest};
use riffel_keys::number;
use riffel_study::ResultFolder;

use crate::arguments::Sensitivity;
use crate::messages::complain;
use crate::results::Results;

pub(super) fn run(arguments: &Sensitivity) -> miette::Result<u8> {
    let (study, folder) = ResultFolder::open(&arguments.folder)?;
    let summary = folder.summary()?;
    if summary.chunks_finished < summary.chunks {
        let folder = arguments.folder.display();
        complain(riffel_keys::say!(
            study_not_finished,
            folder = folder.to_string(),
            missing = number(summary.chunks - summary.chunks_finished),
            chunks = number(summary.chunks)
        ));
        return Ok(1);
    }
    let confidence = arguments.confidence.si();
    let request = SensitivityRequest { results: arguments.results.clone(), confidence };
    let answer = SensitivityAnswer::new(&study, &folder, &request)?;
    let output = arguments.output.as_deref();
    Results::in_folder("study sensitivity", &arguments.folder, output, arguments.json).answer(&answer)?;
    Ok(0)
}
