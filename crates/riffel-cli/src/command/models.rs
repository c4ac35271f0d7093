//! `riffel compare --models`

use riffel_answers::models::{ModelsAnswer, ModelsRequest};
use riffel_case::model::FieldModel;

use crate::arguments::Compare;
use crate::progress::Progress;
use crate::results::Results;
use crate::terminal::Terminal;

pub(super) fn run(arguments: &Compare, models: &[&'static FieldModel]) -> miette::Result<()> {
    let speed = match &arguments.speed {
        Some(speed) => Some(speed.within("--speed", &Terminal)?),
        None => None,
    };
    let case = arguments.case.read()?;
    let steps = match models.len() {
        0 => FieldModel::ALL.len(),
        named => named,
    };
    let progress = Progress::new(riffel_keys::say!(progress_models), steps);
    let request = ModelsRequest { models: models.to_vec(), speed };
    let answer = ModelsAnswer::new(&case, &request, &|by| progress.advance(by))?;
    drop(progress);
    let results = Results::of("models", &arguments.case, &arguments.results);
    Ok(results.answer(&answer)?)
}
