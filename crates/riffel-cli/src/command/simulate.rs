//! `riffel simulate`

use riffel::passage::Sinusoid;
use riffel_answers::simulate::{SinusoidAnswer, SinusoidRequest};
use riffel_case::Case;

use crate::arguments::{Simulate, SinusoidArgument, positive};
use crate::error::CliError;
use crate::messages::print_remarks;
use crate::output::{json, table};
use crate::results::Results;

pub(crate) fn run(arguments: &Simulate) -> miette::Result<()> {
    let case = arguments.case.read()?;
    let speed = arguments.speed.within("--speed")?;
    let step = arguments
        .step
        .map(|step| positive("--step", step))
        .transpose()?;
    if let Some(sinusoid) = &arguments.sinusoid {
        over_sinusoid(arguments, &case, speed, step, sinusoid)?;
    }
    Ok(())
}

fn over_sinusoid(
    arguments: &Simulate,
    case: &Case,
    speed: f64,
    step: Option<f64>,
    sinusoid: &SinusoidArgument,
) -> Result<(), CliError> {
    let [amplitude, wavelength] = sinusoid.within()?;
    let steps = match step {
        None => SinusoidRequest::USUAL_STEPS,
        Some(step) => steps_to_a_wave(wavelength, step)?,
    };
    let request = SinusoidRequest {
        speed,
        profile: Sinusoid {
            amplitude,
            wavelength,
        },
        steps,
    };
    let answer = SinusoidAnswer::new(case, request)?;
    let results = Results {
        command: "simulate",
        case: &arguments.case,
        output: arguments.output.as_deref(),
        json: arguments.json,
    };
    results.hand_out(
        || json(&answer.document()),
        |staging| {
            staging.write_figure("wave", &answer.figure(case))?;
            staging.write_with("wave.csv", |file| answer.course().csv(file))?;
            staging.write("harmonics.json", json(&answer.document()).as_bytes())
        },
        || readable(case, &answer),
    )?;
    print_remarks(&case.remarks);
    print_remarks(&answer.remarks);
    Ok(())
}

/// As many steps to a wave as none is longer than asked.
fn steps_to_a_wave(wavelength: f64, step: f64) -> Result<usize, CliError> {
    /// Fewer do not show the fifth harmonic, more take minutes.
    const STEPS: std::ops::RangeInclusive<f64> = 20.0..=16384.0;
    let steps = (wavelength / step).ceil();
    if STEPS.contains(&steps) {
        return Ok(steps as usize);
    }
    Err(CliError::Argument {
        argument: "--step",
        value: format!("{step} m"),
        rule: format!(
            "between {:.1e} and {:.1e} m, so that a wave has {} to {} steps",
            wavelength / STEPS.end(),
            wavelength / STEPS.start(),
            STEPS.start(),
            STEPS.end()
        ),
    })
}

/// Harmonics for the terminal.
fn readable(case: &Case, answer: &SinusoidAnswer) -> String {
    let SinusoidRequest { speed, profile, .. } = answer.request;
    let settled = &answer.settled;
    let mut rows = table(&[
        "harmonic",
        "normal force kN",
        "creep force kN",
        "creepage %",
        "dissipation J/m",
    ]);
    for (n, harmonic) in settled.harmonics.iter().enumerate() {
        let size = |value: riffel::Complex64, scale: f64| match n {
            0 => format!("{:.4}", scale * value.re),
            _ => format!("{:.4}", scale * value.norm()),
        };
        rows.add_row([
            if n == 0 {
                "mean".to_owned()
            } else {
                n.to_string()
            },
            size(harmonic.normal_force, 1e-3),
            size(harmonic.tangential_force, 1e-3),
            size(harmonic.creepage, 100.0),
            size(harmonic.dissipation, 1.0),
        ]);
    }
    let [least, largest] = settled.normal_force;
    format!(
        "{}\n{:.1} mm and {:.1} µm at {:.1} km/h, {:.1} Hz\n{rows}\nnormal force {:.2} to {:.2} kN; {}\n",
        case.file
            .title
            .as_deref()
            .unwrap_or("Wheel over a sinusoid"),
        1e3 * profile.wavelength,
        1e6 * profile.amplitude,
        3.6 * speed,
        speed / profile.wavelength,
        1e-3 * least,
        1e-3 * largest,
        match settled.contact_loss {
            0.0 => "always in contact".to_owned(),
            share => format!("no contact for {:.1} % of the time", 100.0 * share),
        },
    )
}
