//! `riffel contact`

use riffel::contact::KalkerCoefficients;
use riffel_answers::contact::{ContactAnswer, ContactRequest, FrequencyResponse, RollingTheories};
use riffel_case::Case;
use riffel_keys::CaseError;

use crate::arguments::{Contact, positive};
use crate::error::CliError;
use crate::messages::print_remarks;
use crate::output::{Progress, json, table};
use crate::results::Results;

pub(crate) fn run(arguments: &Contact) -> miette::Result<()> {
    let case = arguments.case.read()?;
    let theories = RollingTheories::new(&case)?;
    let creepages = creepages(arguments, &theories)?;
    let ratios = ratios(arguments)?;

    let progress = Progress::new("contact", creepages.len() + ratios.len() + 1);
    let request = ContactRequest {
        creepages: Some(creepages),
        ratios: Some(ratios),
    };
    let answer =
        ContactAnswer::new(theories, request, || progress.advance(1)).map_err(of_argument)?;
    drop(progress);

    let results = Results {
        command: "contact",
        case: &arguments.case,
        output: arguments.output.as_deref(),
        json: arguments.json,
    };
    results.hand_out(
        || json(&answer.document()),
        |staging| {
            staging.write_figure("contact", &answer.figure(&case))?;
            staging.write_figure("patch", &answer.patch_figure(&case))?;
            staging.write_with("creep-curve.csv", |file| answer.creep_curve_csv(file))?;
            staging.write_with("frequency-response.csv", |file| {
                answer.frequency_response_csv(file)
            })?;
            staging.write_with("patch.csv", |file| answer.patch_csv(file))
        },
        || readable(&case, &answer),
    )?;
    print_remarks(&case.remarks);
    Ok(())
}

/// The creepages asked for \[-\], or equally spaced ones to beyond full slip.
fn creepages(arguments: &Contact, theories: &RollingTheories) -> Result<Vec<f64>, CliError> {
    if arguments.creepage.is_empty() {
        return Ok(theories.default_creepages());
    }
    let given = arguments.creepage.iter();
    given
        .map(|&creepage| positive("--creepage", creepage))
        .collect()
}

/// The wavelengths asked for \[semi-axes\], or some equally spaced in their logarithm.
fn ratios(arguments: &Contact) -> Result<Vec<f64>, CliError> {
    if arguments.ratio.is_empty() {
        return Ok(FrequencyResponse::default_ratios());
    }
    let given = arguments.ratio.iter();
    given.map(|&ratio| positive("--ratio", ratio)).collect()
}

/// A wavelength that the contact refuses, under the name of its argument.
fn of_argument(error: CaseError) -> miette::Report {
    match error {
        CaseError::Physics { input, error } => CliError::Physics {
            input: input.replace("λ/a = ", "--ratio "),
            error,
        }
        .into(),
        error => error.into(),
    }
}

/// The contact for the terminal.
fn readable(case: &Case, answer: &ContactAnswer) -> String {
    let (patch, curves) = (&answer.theories, &answer.curves);
    const ROWS: usize = 8;
    let hertz = patch.hertz;
    let KalkerCoefficients { c11, c22, c23, c33 } = patch.laws.kalker;
    let mut text = format!("{}\n", case.file.title.as_deref().unwrap_or("Contact"));
    text.push_str(&format!(
        "ellipse {:.2} mm along and {:.2} mm across the rail, approach {:.1} µm\n\
         peak pressure {:.0} MPa, stiffness {:.0} MN/m\n\
         Kalker's coefficients C₁₁ = {c11:.3}, C₂₂ = {c22:.3}, C₂₃ = {c23:.3}, C₃₃ = {c33:.3}\n\
         mean state by half-space: tractive ratio {:.3} at creepage {:.4} %\n",
        2e3 * hertz.semi_axis_longitudinal(),
        2e3 * hertz.semi_axis_lateral(),
        1e6 * hertz.approach(),
        1e-6 * hertz.peak_pressure(),
        1e-6 * hertz.stiffness(),
        patch.tractive_ratio(patch.state.tangential_force()),
        100.0 * patch.state.creepage(),
    ));
    let mut header = vec!["creepage"];
    header.extend(curves.laws.iter().map(|law| law.key));
    let mut rows = table(&header);
    let count = curves.creepages.len();
    let shown = count.min(ROWS);
    for place in 1..=shown {
        let index = place * count / shown - 1;
        let mut row = vec![format!("{:.4} %", 100.0 * curves.creepages[index])];
        let ratios = curves.laws.iter();
        row.extend(ratios.map(|law| format!("{:.4}", law.tractive_ratios[index])));
        rows.add_row(row);
    }
    text.push_str(&format!("tractive ratio Q/μP\n{rows}\n"));
    text
}
