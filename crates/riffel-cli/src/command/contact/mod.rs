//! `riffel contact`

mod creep_curves;
mod document;
mod frequency_response;
mod patch_figure;

use document::document;
use patch_figure::{patch_figure, patch_table};
use riffel::contact::KalkerCoefficients;
use riffel_case::{Case, CreepCurves, FrequencyResponse, RollingTheories};
use riffel_figures::polach;
use riffel_keys::CaseError;
use riffel_plot::{Arrangement, LineFigure, Series};

use crate::arguments::{Contact, positive};
use crate::error::CliError;
use crate::messages::print_remarks;
use crate::output::{Progress, print, print_json, table};
use crate::staging::Staging;

pub(crate) fn run(arguments: &Contact) -> miette::Result<()> {
    let case = arguments.case.read()?;
    let patch = RollingTheories::new(&case)?;
    let creepages = creepages(arguments, &patch)?;
    let ratios = ratios(arguments)?;

    let progress = Progress::new("contact", creepages.len() + ratios.len() + 1);
    // First what is refused soonest.
    let response =
        FrequencyResponse::new(&patch, ratios, || progress.advance(1)).map_err(of_argument)?;
    let curves = CreepCurves::new(&patch, creepages, || progress.advance(1))?;
    drop(progress);

    if arguments.json {
        print_json(&document(&patch, &curves, &response))?;
        print_remarks(&case.remarks);
        if arguments.output.is_none() {
            return Ok(());
        }
    }

    let folder = arguments
        .case
        .folder(arguments.output.as_deref(), "contact");
    let mut staging = Staging::new("contact", &folder)?;
    staging.write_figure("contact", &figure(&case, &patch, &curves, &response))?;
    staging.write_figure("patch", &patch_figure(&case, &patch))?;
    staging.write_with("creep-curve.csv", |file| creep_curves::table(&curves, file))?;
    staging.write_with("frequency-response.csv", |file| {
        frequency_response::table(&response, file)
    })?;
    staging.write_with("patch.csv", |file| patch_table(&patch, file))?;
    let files = staging.publish()?;
    if !arguments.json {
        let place = format!("{}: {}\n", folder.display(), files.join(" "));
        print(&(readable(&case, &patch, &curves) + &place))?;
        print_remarks(&case.remarks);
    }
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

/// The parameters of the contact in one sentence.
fn parameters(case: &Case, patch: &RollingTheories) -> String {
    let material = patch.hertz.material();
    format!(
        "E = {:.0} GPa, ν = {}; R = {:.2} m, R_r = {:.2} m, P = {:.0} kN, μ = {}; ellipse {:.2} × {:.2} mm; \
         mean state τ = {:.3}, ξ₀ = {:.4} %; {} elements over a diameter{}.",
        1e-9 * case.file.steel.youngs_modulus.si(),
        material.poisson_ratio(),
        patch.hertz.rolling_radius(),
        case.file.contact.transverse_radius.si(),
        1e-3 * patch.hertz.normal_force(),
        patch.friction,
        2e3 * patch.hertz.semi_axis_longitudinal(),
        2e3 * patch.hertz.semi_axis_lateral(),
        patch.tractive_ratio(patch.state.tangential_force()),
        100.0 * patch.state.creepage(),
        case.file.contact.grid,
        match polach(case).as_str() {
            "" => String::new(),
            words => format!("; Polach{words}"),
        },
    )
}

fn figure(
    case: &Case,
    patch: &RollingTheories,
    curves: &CreepCurves,
    response: &FrequencyResponse,
) -> LineFigure {
    let [modulus, phase] = frequency_response::panels(response);
    LineFigure {
        title: "Rolling contact: creep curves and frequency response".to_owned(),
        caption: format!(
            "Responses of the half-space about its mean state, exp(+iωt); the energy left on the rail is that of \
             the whole passage, relative to the instant at which the wheel centre passes. {}",
            parameters(case, patch)
        ),
        panels: vec![creep_curves::panel(curves, patch), modulus, phase],
        arrangement: Arrangement::Stacked,
    }
}

/// A curve from left to right, in whichever order its samples were asked for.
fn line(label: &str, x: &[f64], y: &[f64]) -> Series {
    let mut samples: Vec<(f64, f64)> = x.iter().copied().zip(y.iter().copied()).collect();
    samples.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (x, y) = samples.into_iter().unzip();
    Series {
        label: label.to_owned(),
        x,
        y,
        ..Series::default()
    }
}

/// The contact for the terminal.
fn readable(case: &Case, patch: &RollingTheories, curves: &CreepCurves) -> String {
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
