//! `riffel compare --models`

use riffel_answers::models::{ModelsAnswer, ModelsRequest};
use riffel_case::Case;
use riffel_case::model::FieldModel;

use crate::arguments::Compare;
use crate::messages::{print_remarks, say};
use crate::output::{json, table};
use crate::progress::Progress;
use crate::results::Results;

pub(super) fn run(arguments: &Compare, models: &[&'static FieldModel]) -> miette::Result<()> {
    let speed = match &arguments.speed {
        Some(speed) => Some(speed.within("--speed")?),
        None => None,
    };
    let case = arguments.case.read()?;
    let steps = match models.len() {
        0 => FieldModel::ALL.len(),
        named => named,
    };
    let progress = Progress::new(riffel_keys::say!(progress_models), steps);
    let request = ModelsRequest {
        models: models.to_vec(),
        speed,
    };
    let answer = ModelsAnswer::new(&case, &request, &|by| progress.advance(by))?;
    drop(progress);
    let results = Results::of("models", &arguments.case, &arguments.results);
    let document = || json(&answer.document(&case));
    results.hand_out(
        document,
        |staging| {
            staging.write_figure("models", &answer.figure(&case))?;
            if let Some(plane) = answer.complex_plane(&case) {
                staging.write_figure("complex-plane", &plane)?;
            }
            staging.write_with("growth.csv", |file| answer.growth_csv(file))?;
            staging.write("summary.json", document())
        },
        || readable(&case, &answer),
    )?;
    print_remarks(&case.remarks_at(answer.speed));
    for (model, growth) in answer.on_case() {
        if let Some(remark) = &growth.unstable {
            say(format!("note: {}: {remark}", model.title));
        }
    }
    Ok(())
}

/// The models for the terminal.
fn readable(case: &Case, answer: &ModelsAnswer) -> String {
    let title = case.file.title.as_deref().unwrap_or("Models of the field");
    let mut rows = table(&[
        "",
        "highest 10⁻⁶ per passage",
        "mm",
        "Hz",
        "passages to double",
    ]);
    for (model, growth) in answer.on_case() {
        let mut row = vec![model.title.to_owned()];
        match growth.highest {
            Some(highest) => row.extend([
                format!("{:+.4}", 1e6 * highest.rate),
                format!(
                    "{:.1}{}",
                    1e3 * highest.wavelength,
                    if highest.at_edge { " (edge)" } else { "" }
                ),
                format!("{:.0}", highest.frequency),
                format!("{:.2e}", highest.doubling_passages()),
            ]),
            None => row.push("no growth".to_owned()),
        }
        rows.add_row(row);
    }
    let mut text = format!("{title}, {}\n{rows}\n", answer.passing());
    let mut moves = String::new();
    for (model, growth) in answer.on_case() {
        if let Some(difference) = growth.differs_by.first() {
            let sentence = difference.sentence(growth.highest);
            moves += &format!("  {}: {sentence}\n", model.title);
        }
    }
    if !moves.is_empty() {
        text += "what moves it most: the one joint that, taken from the case with the exact contact, changes growth most\n";
        text += &moves;
    }
    for of in &answer.models {
        if let Err(reason) = &of.growth {
            text += &format!("not on this case: {}: {reason}\n", of.model.title);
        }
    }
    text
}
