//! `riffel wheelset`

use riffel_answers::mode_in_words;
use riffel_answers::receptance::ReceptanceCurves;
use riffel_answers::wheelset::{HIGHEST, WheelsetAnswer};
use riffel_case::{Case, CaseWheelset};

use super::receptance::within;
use crate::arguments::Wheelset;
use crate::messages::{language, print_remarks};
use crate::output::{json, table};
use crate::results::Results;

/// Frequencies of the receptances where none are listed: the lowest \[Hz\], and how many.
const USUAL: (f64, u32) = (20.0, 600);

pub(crate) fn run(arguments: &Wheelset) -> miette::Result<()> {
    let case = arguments.case.read()?;
    let frequencies = match &arguments.frequencies[..] {
        [] => {
            let wheelset = case.wheelset.as_ref();
            let (lowest, highest) = wheelset.map_or((0.0, f64::INFINITY), |wheelset| wheelset.frequency_range());
            ReceptanceCurves::frequencies(USUAL.0.max(lowest), HIGHEST.min(highest), USUAL.1)
        }
        listed => within("--frequencies", listed)?,
    };
    let answer = WheelsetAnswer::new(&case, frequencies)?;
    let results = Results::of("wheelset", &arguments.case, &arguments.results);
    results.hand_out(
        || json(&answer.document()),
        |staging| {
            staging.write_figure("receptance", &answer.figure(&case))?;
            if let Some(shapes) = answer.shapes() {
                staging.write_figure("modes", &shapes)?;
            }
            staging.write_with("modes.csv", |file| answer.modes_csv(file))?;
            staging.write_with("receptance.csv", |file| answer.receptances_csv(file))
        },
        || readable(&case, &answer),
    )?;
    print_remarks(&case.remarks);
    Ok(())
}

/// The natural frequencies for the terminal.
fn readable(case: &Case, answer: &WheelsetAnswer) -> String {
    let mut text = format!("{}\n", case.file.title.as_deref().unwrap_or("Wheelset"));
    if answer.modes.is_empty() {
        let why = match case.wheelset.as_deref() {
            Some(CaseWheelset::Measured(_)) => "measured: its natural frequencies are the peaks of its receptances",
            _ => "a free rigid body: it has no natural frequency",
        };
        return text + why + "\n";
    }
    let mut rows = table(&["natural frequency Hz", "mode"]);
    for mode in &answer.modes {
        let name = mode_in_words(&mode.name).text(language());
        rows.add_row([format!("{:.2}", mode.frequency), name]);
    }
    text += &format!("{rows}\n");
    text
}
