//! `riffel simulate`

mod evolution;
mod surface;

use std::ops::RangeInclusive;

use riffel::forecast::SpeedDistribution;
use riffel_answers::simulate::{
    EvolutionRequest, PassageAnswer, PassageRequest, SinusoidAnswer, SinusoidRequest, SmoothRailAnswer, Surface,
};
use riffel_case::Case;
use riffel_case::traffic::Traffic;

use crate::arguments::{Simulate, positive};
use crate::error::CliError;
use crate::messages::print_remarks;
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
        results(arguments).answer(&SmoothRailAnswer::new(&case, speed, step)?)?;
        return Ok(0);
    }
    if let Some(sinusoid) = &arguments.sinusoid {
        let request = SinusoidRequest::new(speed, sinusoid.of_sinusoid()?, step);
        let request = SinusoidRequest {
            contact_filter: arguments.contact_filter,
            transient: arguments.transient,
            ..request.map_err(CliError::from)?
        };
        results(arguments).answer(&SinusoidAnswer::new(&case, request)?)?;
        return Ok(0);
    }
    let largest_step = step.unwrap_or(PassageRequest::USUAL_STEP);
    let request = PassageRequest {
        speed,
        profile: surface(arguments, &case, largest_step)?.into_profile(),
        largest_step,
        contact_filter: arguments.contact_filter,
    };
    results(arguments).answer(&PassageAnswer::new(&case, request)?)?;
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

fn results(arguments: &Simulate) -> Results {
    Results::of("simulate", &arguments.case, &arguments.results)
}
