//! `riffel simulate`

mod evolution;
mod surface;

use std::ops::RangeInclusive;

use riffel::forecast::SpeedDistribution;
use riffel::passage::Outcome;
use riffel_answers::simulate::{
    EvolutionRequest, PassageAnswer, PassageRequest, SinusoidAnswer, SinusoidRequest, SmoothRailAnswer, Surface,
};
use riffel_case::Case;
use riffel_case::traffic::Traffic;

use crate::arguments::{Simulate, positive};
use crate::error::CliError;
use crate::messages::print_remarks;
use crate::output::{json, table};
use crate::results::Results;
use surface::surface;

/// Steps of a march along a profile \[m\].
const STEPS: RangeInclusive<f64> = 0.05e-3..=0.1;

pub(crate) fn run(arguments: &Simulate) -> miette::Result<u8> {
    let case = arguments.case.read()?;
    let step = arguments.step.map(|step| positive("--step", step)).transpose()?;
    if let Some(step) = step.filter(|step| arguments.sinusoid.is_none() && !STEPS.contains(step)) {
        Err(CliError::Argument {
            argument: "--step",
            value: format!("{:e} m", step),
            rule: "between 0.05 and 100 mm: the contact is some millimetres long".to_owned(),
        })?;
    }
    if arguments.sinusoid.is_some() {
        let length = arguments.length.map(|_| "--length");
        arguments.only_for_profiles(arguments.layout.given().or(length))?;
    }
    if let Some(passages) = arguments.passages {
        return many(arguments, &case, whole(passages)?, step);
    }
    let speed = arguments.speed()?;
    if arguments.smooth {
        arguments.only_for_profiles(arguments.layout.given())?;
        on_smooth_rail(arguments, &case, speed, step)?;
        return Ok(0);
    }
    if let Some(sinusoid) = &arguments.sinusoid {
        let request = SinusoidRequest::new(speed, sinusoid.of_sinusoid()?, step);
        let request = SinusoidRequest {
            contact_filter: arguments.contact_filter,
            transient: arguments.transient,
            ..request.map_err(CliError::from)?
        };
        over_sinusoid(arguments, &case, request)?;
        return Ok(0);
    }
    let largest_step = step.unwrap_or(PassageRequest::USUAL_STEP);
    let request = PassageRequest {
        speed,
        profile: surface(arguments, &case, largest_step)?.into_profile(),
        largest_step,
        contact_filter: arguments.contact_filter,
    };
    along_profile(arguments, &case, request)?;
    Ok(0)
}

/// Passages of the wheel at one speed, or of those of a traffic.
fn many(arguments: &Simulate, case: &Case, passages: u64, step: Option<f64>) -> miette::Result<u8> {
    let traffic = match &arguments.traffic {
        Some(path) => Traffic::read(path)?,
        None => {
            let speed = SpeedDistribution::single(arguments.speed()?);
            Traffic::of_case(speed.map_err(|error| CliError::Physics { input: "--speed".to_owned(), error })?)
        }
    };
    print_remarks(traffic.remarks());
    let (surface, largest_step) = match &arguments.sinusoid {
        Some(sinusoid) => {
            let sinusoid = sinusoid.of_sinusoid()?;
            let slowest = traffic.speeds().iter().map(|speeds| speeds.range().0);
            let slowest = slowest.fold(f64::INFINITY, f64::min);
            let request = SinusoidRequest::new(slowest, sinusoid, step);
            let step = request.map_err(CliError::from)?.step();
            let surface = Surface::of_sinusoid(sinusoid, case.track.support_spacing());
            (surface.map_err(CliError::from)?, step)
        }
        None => {
            let step = step.unwrap_or(PassageRequest::USUAL_STEP);
            (surface(arguments, case, step)?, step)
        }
    };
    let request = EvolutionRequest { traffic, surface, largest_step, contact_filter: arguments.contact_filter };
    Ok(evolution::run(arguments, case, request, passages)?)
}

/// A number of passages.
fn whole(passages: f64) -> Result<u64, CliError> {
    /// Largest number of passages: a century of a train a second has a third.
    const MOST: f64 = 1e10;
    if passages.fract() == 0.0 && (1.0..=MOST).contains(&passages) {
        return Ok(passages as u64);
    }
    Err(CliError::Argument {
        argument: "--passages",
        value: passages.to_string(),
        rule: format!("a whole number from 1 to {MOST:e}"),
    })
}

fn along_profile(arguments: &Simulate, case: &Case, request: PassageRequest) -> Result<(), CliError> {
    let speed = request.speed;
    let answer = PassageAnswer::new(case, request)?;
    results(arguments).hand_out(
        || json(&answer.document()),
        |staging| {
            staging.write_figure("passage", &answer.figure(case))?;
            staging.write_with("passage.csv", |file| answer.course().csv(file))?;
            let figure = answer.figure(case);
            answer.course().netcdf(&figure.title, &staging.path("passage.nc"))?;
            for other in answer.other_courses() {
                let name = format!("passage-{}-{}", other.name.wheel, other.name.rail);
                staging.write_with(&format!("{name}.csv"), |file| other.course.csv(file))?;
            }
            staging.write("passage.json", json(&answer.document()))
        },
        || readable_passage(case, &answer),
    )?;
    print_remarks(&case.remarks_at(speed));
    print_remarks(&answer.remarks);
    Ok(())
}

fn results(arguments: &Simulate) -> Results<'_> {
    Results::of("simulate", &arguments.case, &arguments.results)
}

/// What a passage was like, for the terminal.
fn readable_passage(case: &Case, answer: &PassageAnswer) -> String {
    let document = answer.document();
    let profile = &answer.request.profile;
    format!(
        "{}\n{:.2} m from {:.3} m on at {:.1} km/h, a run-in of {:.2} m before, steps of {:.3} mm\n\
         normal force {:.2} to {:.2} kN; {}\nmean creepage {:.4} %, mean dissipation {:.4} J/m\n",
        case.file.title.as_deref().unwrap_or("Wheel along a profile"),
        profile.length(),
        profile.start(),
        3.6 * document.speed_m_per_s,
        document.run_in_m,
        1e3 * document.step_m,
        1e-3 * document.minimum_normal_force_n,
        1e-3 * document.maximum_normal_force_n,
        without_contact(document.contact_loss_fraction),
        100.0 * document.mean_creepage,
        document.mean_dissipation_j_per_m,
    )
}

fn without_contact(share: f64) -> String {
    match share {
        0.0 => "always in contact".to_owned(),
        share => format!("no contact for {:.1} % of the time", 100.0 * share),
    }
}

/// Wheels on a smooth rail.
fn on_smooth_rail(arguments: &Simulate, case: &Case, speed: f64, step: Option<f64>) -> Result<(), CliError> {
    let answer = SmoothRailAnswer::new(case, speed, step)?;
    results(arguments).hand_out(
        || json(&answer.document()),
        |staging| {
            let figure = answer.figure(case);
            staging.write_figure("smooth", &figure)?;
            staging.write_with("smooth.csv", |file| answer.course().csv(file))?;
            answer.course().netcdf(&figure.title, &staging.path("smooth.nc"))?;
            let names = answer.contacts.iter().zip(answer.courses()).skip(1);
            for (name, course) in names {
                let file = format!("smooth-{}-{}.csv", name.wheel, name.rail);
                staging.write_with(&file, |file| course.csv(file))?;
            }
            staging.write("smooth.json", json(&answer.document()))
        },
        || readable_motion(case, &answer),
    )?;
    print_remarks(&case.remarks_at(speed));
    print_remarks(&answer.remarks);
    Ok(())
}

/// What became of a push, for the terminal.
fn readable_motion(case: &Case, answer: &SmoothRailAnswer) -> String {
    let document = answer.document();
    let mut rows = table(&[
        "wheel",
        "rail",
        "normal force kN",
        "creep force kN",
        "lateral kN",
        "creepage %",
        "lateral %",
        "stick %",
        "dissipation J/m",
    ]);
    let range = |[least, most]: [f64; 2], scale: f64, digits: usize| {
        format!("{:.digits$} to {:.digits$}", scale * least, scale * most)
    };
    for contact in &document.contacts {
        rows.add_row([
            contact.name.wheel.to_string(),
            contact.name.rail.to_owned(),
            range(contact.normal_force_n, 1e-3, 2),
            range(contact.tangential_force_n, 1e-3, 2),
            range(contact.lateral_force_n, 1e-3, 2),
            range(contact.creepage, 100.0, 3),
            range(contact.lateral_creepage, 100.0, 3),
            format!("{:.0}", 100.0 * contact.stick_fraction),
            format!("{:.1}", contact.mean_dissipation_j_per_m),
        ]);
    }
    let outcome = match (answer.motion.outcome, document.frequency_hz) {
        (Outcome::LimitCycle, Some(frequency)) => format!("a limit cycle of {frequency:.1} Hz"),
        (_, Some(frequency)) => format!("no settled period, like itself at {frequency:.1} Hz"),
        (Outcome::RunsAway, None) => "the wheels slide off".to_owned(),
        (_, None) => "the push dies out".to_owned(),
    };
    let linear = match (document.linear_unstable_roots, document.linear_frequency_hz) {
        (Some(0), _) => "the linear loop is stable".to_owned(),
        (Some(_), Some(frequency)) => match document.linear_growth_rate_per_s {
            Some(growth) => format!(
                "the linear loop is unstable near {frequency:.0} Hz, where it grows e-fold in {:.3} s",
                growth.recip()
            ),
            None => format!("the linear loop is unstable near {frequency:.0} Hz"),
        },
        (Some(_), None) => "the linear loop is unstable".to_owned(),
        (None, _) => "the linear loop cannot be judged".to_owned(),
    };
    format!(
        "{}\nsmooth rail at {:.1} km/h, {:.1} s: {outcome}; {linear}\n{rows}\n",
        case.file.title.as_deref().unwrap_or("Wheels on a smooth rail"),
        3.6 * document.speed_m_per_s,
        document.rolled_s,
    )
}

fn over_sinusoid(arguments: &Simulate, case: &Case, request: SinusoidRequest) -> Result<(), CliError> {
    let answer = SinusoidAnswer::new(case, request)?;
    results(arguments).hand_out(
        || json(&answer.document()),
        |staging| {
            staging.write_figure("wave", &answer.figure(case))?;
            staging.write_with("wave.csv", |file| answer.course().csv(file))?;
            let figure = answer.figure(case);
            answer.course().netcdf(&figure.title, &staging.path("wave.nc"))?;
            staging.write("harmonics.json", json(&answer.document()))
        },
        || readable(case, &answer),
    )?;
    print_remarks(&case.remarks_at(answer.request.speed));
    print_remarks(&answer.remarks);
    Ok(())
}

/// Harmonics for the terminal.
fn readable(case: &Case, answer: &SinusoidAnswer) -> String {
    let SinusoidRequest { speed, profile, .. } = answer.request;
    let settled = &answer.settled;
    let on_all_axes = !answer.contacts.is_empty();
    let mut heads = vec!["harmonic", "normal force kN", "creep force kN", "creepage %", "dissipation J/m"];
    if on_all_axes {
        heads.extend(["lateral force kN", "lateral creepage %"]);
    }
    if answer.energy_at_rail.is_some() {
        heads.push("at the rail J/m");
    }
    let mut rows = table(&heads);
    for (n, harmonic) in settled.harmonics.iter().enumerate() {
        let size = |value: riffel::Complex64, scale: f64| match n {
            0 => format!("{:.4}", scale * value.re),
            _ => format!("{:.4}", scale * value.norm()),
        };
        let mut row = vec![
            if n == 0 { "mean".to_owned() } else { n.to_string() },
            size(harmonic.normal_force, 1e-3),
            size(harmonic.tangential_force, 1e-3),
            size(harmonic.creepage, 100.0),
            size(harmonic.dissipation, 1.0),
        ];
        if on_all_axes {
            row.push(size(harmonic.lateral_force, 1e-3));
            row.push(size(harmonic.lateral_creepage, 100.0));
        }
        if let Some(energy) = answer.energy_at_rail {
            row.push(size(energy[n], 1.0));
        }
        rows.add_row(row);
    }
    let [least, largest] = settled.normal_force;
    format!(
        "{}\n{:.1} mm and {:.1} µm at {:.1} km/h, {:.1} Hz\n{rows}\nnormal force {:.2} to {:.2} kN; {}\n",
        case.file.title.as_deref().unwrap_or("Wheel over a sinusoid"),
        1e3 * profile.wavelength,
        1e6 * profile.amplitude,
        3.6 * speed,
        speed / profile.wavelength,
        1e-3 * least,
        1e-3 * largest,
        without_contact(settled.contact_loss),
    )
}
