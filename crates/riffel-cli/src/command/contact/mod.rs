//! `riffel contact`

mod creep_curves;
mod document;
mod frequency_response;
mod patch;
mod patch_figure;

use riffel::KalkerCoefficients;
use riffel_case::Case;
use riffel_figures::polach;
use riffel_plot::{Arrangement, LineFigure, Series};

use crate::arguments::{Contact, positive};
use crate::error::CliError;
use crate::output::{Progress, print, print_json, print_remarks, table};
use crate::staging::Staging;
use creep_curves::CreepCurves;
use document::document;
use frequency_response::FrequencyResponse;
use patch::Patch;
use patch_figure::patch_figure;

pub(crate) fn run(arguments: &Contact) -> miette::Result<()> {
    let case = arguments.case.read()?;
    let patch = Patch::new(&case)?;
    let creepages = creepages(arguments, &patch)?;
    let ratios = ratios(arguments)?;

    let progress = Progress::new("contact", creepages.len() + ratios.len() + 1);
    // First what is refused soonest.
    let response = FrequencyResponse::new(&patch, ratios, &progress)?;
    let curves = CreepCurves::new(&patch, creepages, &progress)?;
    drop(progress);

    if arguments.json {
        print_json(&document(&patch, &curves, &response));
        print_remarks(&case.remarks);
        if arguments.output.is_none() {
            return Ok(());
        }
    }

    let folder = arguments
        .case
        .folder(arguments.output.as_deref(), "contact");
    let mut staging = Staging::new(&folder)?;
    staging.write_figure("contact", &figure(&case, &patch, &curves, &response))?;
    staging.write_figure("patch", &patch_figure(&case, &patch))?;
    staging.write_with("creep-curve.csv", |file| curves.table(file))?;
    staging.write_with("frequency-response.csv", |file| response.table(file))?;
    staging.write_with("patch.csv", |file| patch.table(file))?;
    let files = staging.publish()?;
    if !arguments.json {
        let place = format!("{}: {}\n", folder.display(), files.join(" "));
        print(&(readable(&case, &patch, &curves) + &place));
        print_remarks(&case.remarks);
    }
    Ok(())
}

/// The creepages asked for \[-\], or equally spaced ones to beyond full slip.
fn creepages(arguments: &Contact, patch: &Patch) -> Result<Vec<f64>, CliError> {
    const POINTS: u32 = 40;
    const BEYOND_FULL_SLIP: f64 = 1.2;
    if arguments.creepage.is_empty() {
        let last = BEYOND_FULL_SLIP * patch.full_slip_creepage();
        return Ok((1..=POINTS)
            .map(|index| last * f64::from(index) / f64::from(POINTS))
            .collect());
    }
    let given = arguments.creepage.iter();
    given
        .map(|&creepage| positive("--creepage", creepage))
        .collect()
}

/// The wavelengths asked for \[semi-axes\], or some equally spaced in their logarithm.
fn ratios(arguments: &Contact) -> Result<Vec<f64>, CliError> {
    const POINTS: u32 = 61;
    const SHORTEST: f64 = 2.0;
    const LONGEST: f64 = 100.0;
    if arguments.ratio.is_empty() {
        let last = POINTS - 1;
        return Ok((0..POINTS)
            .map(|index| match index {
                0 => SHORTEST,
                _ if index == last => LONGEST,
                _ => SHORTEST * (LONGEST / SHORTEST).powf(f64::from(index) / f64::from(last)),
            })
            .collect());
    }
    let given = arguments.ratio.iter();
    given.map(|&ratio| positive("--ratio", ratio)).collect()
}

/// A refusal of the physics, with what was computed.
fn refused(input: impl Into<String>) -> impl FnOnce(riffel::Error) -> CliError {
    let input = input.into();
    move |error| CliError::Physics { input, error }
}

/// The parameters of the contact in one sentence.
fn parameters(case: &Case, patch: &Patch) -> String {
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
    patch: &Patch,
    curves: &CreepCurves,
    response: &FrequencyResponse,
) -> LineFigure {
    let [modulus, phase] = response.panels();
    LineFigure {
        title: "Rolling contact: creep curves and frequency response".to_owned(),
        caption: format!(
            "Responses of the half-space about its mean state, exp(+iωt); the energy left on the rail is that of \
             the whole passage, relative to the instant at which the wheel centre passes. {}",
            parameters(case, patch)
        ),
        panels: vec![curves.panel(patch), modulus, phase],
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
fn readable(case: &Case, patch: &Patch, curves: &CreepCurves) -> String {
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
