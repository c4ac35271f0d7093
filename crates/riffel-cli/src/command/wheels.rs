//! `riffel map --wheels`

use std::collections::BTreeMap;

use riffel_answers::wheels::WheelsAnswer;
use riffel_case::Case;

use crate::arguments::Map;
use crate::messages::say;
use crate::output::{json, table};
use crate::progress::Progress;
use crate::results::Results;

pub(super) fn run(arguments: &Map) -> miette::Result<()> {
    let case = arguments.case.read_at(arguments.position)?;
    let progress = Progress::new(
        riffel_keys::say!(progress_wheels),
        WheelsAnswer::rows(&case),
    );
    let answer = WheelsAnswer::new(&case, |rows| progress.advance(rows))?;
    drop(progress);
    let results = Results::of("wheels", &arguments.case, &arguments.results);
    let document = || json(&answer.document(&case));
    results.hand_out(
        document,
        |staging| {
            if let Some(maps) = answer.map_figure(&case) {
                staging.write_picture("map", &maps.picture()?)?;
                staging.write("map.html", maps.html()?)?;
            }
            staging.write_figure("growth", &answer.curve_figure(&case))?;
            staging.write_with("wheels.csv", |file| answer.wheels_csv(file))?;
            staging.write_with("growth.csv", |file| answer.growth_csv(file))?;
            answer.netcdf(&case, &staging.path("map.nc"))?;
            staging.write("summary.json", document())
        },
        || readable(&case, &answer),
    )?;
    for (note, wheels) in notes(&answer) {
        say(match wheels.len() == answer.in_loop().count() {
            true => format!("note: {note}"),
            false => format!("note: {}: {note}", wheels.join("; ")),
        });
    }
    Ok(())
}

/// What there is to say of wheels, each sentence once with its wheels, in the order of the first.
fn notes(answer: &WheelsAnswer) -> Vec<(String, Vec<&str>)> {
    let mut places: BTreeMap<String, usize> = BTreeMap::new();
    let mut notes: Vec<(String, Vec<&str>)> = Vec::new();
    for (wheel, growth) in answer.in_loop() {
        for remark in &growth.remarks {
            let words = remark.to_string();
            let place = *places.entry(words.clone()).or_insert_with(|| {
                notes.push((words, Vec::new()));
                notes.len() - 1
            });
            notes[place].1.push(&wheel.name);
        }
    }
    notes
}

/// The wheels for the terminal.
fn readable(case: &Case, answer: &WheelsAnswer) -> String {
    let title = case.file.title.as_deref().unwrap_or("Wheels of a curve");
    let (heading, rows) = answer.table();
    let mut table = table(&heading);
    for row in rows {
        table.add_row(row);
    }
    let mut text = format!(
        "{title}\nall wheels in the curve of {:.0} m at {:.0} km/h\n{table}\n{}\n",
        answer.curve.radius.abs(),
        3.6 * answer.curve.speed,
        answer.sentence()
    );
    for wheel in &answer.wheels {
        if let Err(reason) = &wheel.growth {
            text += &format!("not in the loop: {}: {reason}\n", wheel.name);
        }
    }
    text
}
