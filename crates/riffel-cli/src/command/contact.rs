//! `riffel contact`

use riffel_answers::contact::{ContactAnswer, ContactRequest, FrequencyResponse, RollingTheories};
use riffel_answers::stress::StressAnswer;
use riffel_case::CaseContact;
use riffel_keys::CaseError;

use crate::arguments::{Contact, positive};
use crate::error::CliError;
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

    Ok(Results::of("contact", &arguments.case, &arguments.results).answer(&answer)?)
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
