//! `riffel contact`

use riffel::contact::KalkerCoefficients;
use riffel_answers::contact::{ContactAnswer, ContactRequest, FrequencyResponse, RollingTheories};
use riffel_answers::stress::StressAnswer;
use riffel_case::file::CreepLawName;
use riffel_case::{CaseContact, SteadyContact};
use riffel_keys::CaseError;

use crate::arguments::{Contact, positive};
use crate::error::CliError;
use crate::messages::print_remarks;
use crate::output::{json, table};
use crate::progress::Progress;
use crate::results::Results;

pub(crate) fn run(arguments: &Contact) -> miette::Result<()> {
    let contact = arguments.case.read_contact()?;
    if arguments.stress {
        return stress(arguments, &contact);
    }
    let theories = RollingTheories::new(contact)?;
    let creepages = creepages(arguments, &theories)?;
    let ratios = ratios(arguments)?;

    let progress = Progress::new(riffel_keys::say!(progress_contact), creepages.len() + ratios.len() + 1);
    let request = ContactRequest { creepages: Some(creepages), ratios: Some(ratios) };
    let answer = ContactAnswer::new(theories, request, || progress.advance(1)).map_err(of_argument)?;
    drop(progress);

    let results = Results::of("contact", &arguments.case, &arguments.results);
    results.hand_out(
        || json(&answer.document()),
        |staging| {
            staging.write_figure("contact", &answer.figure())?;
            staging.write_figure("patch", &answer.patch_figure())?;
            staging.write_with("creep-curve.csv", |file| answer.creep_curve_csv(file))?;
            if answer.response.is_some() {
                staging.write_with("frequency-response.csv", |file| answer.frequency_response_csv(file))?;
            }
            staging.write_with("patch.csv", |file| answer.patch_csv(file))
        },
        || readable(&answer),
    )?;
    print_remarks(&answer.remarks());
    Ok(())
}

/// Stress in the rail.
fn stress(arguments: &Contact, contact: &CaseContact) -> miette::Result<()> {
    let points: Vec<[f64; 3]> = arguments.stress_at.iter().map(|point| point.0).collect();
    let answer = StressAnswer::new(contact, &points)?;
    Results::of("contact", &arguments.case, &arguments.results).answer(&answer)?;
    Ok(())
}

/// The creepages asked for \[-\], or equally spaced ones to beyond full slip.
fn creepages(arguments: &Contact, theories: &RollingTheories) -> Result<Vec<f64>, CliError> {
    if arguments.creepage.is_empty() {
        return Ok(theories.default_creepages());
    }
    let given = arguments.creepage.iter();
    given.map(|&creepage| positive("--creepage", creepage)).collect()
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
        CaseError::Physics { input, error } => {
            CliError::Physics { input: input.replace("λ/a = ", "--ratio "), error }.into()
        }
        error => error.into(),
    }
}

/// The contact for the terminal.
fn readable(answer: &ContactAnswer) -> String {
    let (patch, curves) = (&answer.theories, &answer.curves);
    const ROWS: usize = 8;
    let hertz = patch.hertz;
    let KalkerCoefficients { c11, c22, c23, c33 } = patch.laws.kalker;
    let title = patch.contact.file.title.as_deref();
    let mut text = format!("{}\n", title.unwrap_or("Contact"));
    text.push_str(&format!(
        "ellipse {:.2} mm along and {:.2} mm across the rail, approach {:.1} µm\n\
         peak pressure {:.0} MPa, stiffness {:.0} MN/m\n\
         Kalker's coefficients C₁₁ = {c11:.3}, C₂₂ = {c22:.3}, C₂₃ = {c23:.3}, C₃₃ = {c33:.3}\n",
        2e3 * hertz.semi_axis_longitudinal(),
        2e3 * hertz.semi_axis_lateral(),
        1e6 * hertz.approach(),
        1e-6 * hertz.peak_pressure(),
        1e-6 * hertz.stiffness(),
    ));
    text.push_str(&match patch.along_rail() {
        true => format!(
            "mean state by half-space: tractive ratio {:.3} at creepage {:.4} %\n",
            patch.exact_tractive_ratio(),
            100.0 * patch.state.creepage(),
        ),
        false => steady(patch),
    });
    if answer.response.is_none() {
        text.push_str("near full slip there is no slope, and no frequency response\n");
    }
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

/// Steady rolling about a table of creepages: by the law of the case, and by the exact one.
fn steady(patch: &RollingTheories) -> String {
    let exact = SteadyContact::exact(&patch.half_space, &patch.state);
    let mut steady = vec![(&exact, CreepLawName::HALF_SPACE)];
    if patch.contact.law.is_some() {
        steady.insert(0, (&patch.steady, patch.contact.creep_law()));
    }
    let lines = steady.into_iter().map(|(steady, law)| {
        let forces = steady.rolling.forces;
        let mut line = format!(
            "mean state by {}: {:.3} kN along and {:.3} kN across the rail, tractive ratio {:.3}",
            law.name(),
            1e-3 * forces.longitudinal,
            1e-3 * forces.lateral,
            steady.rolling.tractive_ratio(),
        );
        if let Some(moment) = steady.spin_moment {
            line.push_str(&format!(", spin moment {moment:.2} Nm"));
        }
        if let Some(energy) = steady.energy_per_metre() {
            line.push_str(&format!(", {energy:.2} J/m dissipated"));
        }
        line + "\n"
    });
    lines.collect()
}
