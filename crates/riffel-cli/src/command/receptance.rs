//! `riffel receptance`

use riffel::Direction;
use riffel_answers::receptance::{MatrixAnswer, ReceptanceAnswer, ReceptanceCurves, ReceptanceRequest};
use riffel_case::{Case, Track};
use riffel_keys::quantity::Frequency;

use crate::arguments::{Asked, DirectionArgument, Receptance};
use crate::error::CliError;
use crate::results::Results;

pub(crate) fn run(arguments: &Receptance) -> miette::Result<()> {
    let case = arguments.case.read_at(arguments.position)?;
    if arguments.matrix {
        return matrix(arguments, &case);
    }
    let direction = match arguments.direction {
        DirectionArgument::Vertical => Direction::Vertical,
        DirectionArgument::Lateral => Direction::Lateral,
        DirectionArgument::Longitudinal => Direction::Longitudinal,
    };
    let track = case.track_in(direction)?;
    let speed = speed(arguments, &case)?;
    let (from, to) = range(arguments, &track)?;
    let request =
        ReceptanceRequest { direction, speed, frequencies: ReceptanceCurves::frequencies(from, to, arguments.points) };
    let answer = ReceptanceAnswer::new(&case, request)?;
    Ok(Results::of("receptance", &arguments.case, &arguments.results).answer(&answer)?)
}

/// Speed of the load \[m/s\], by default the highest of the map.
fn speed(arguments: &Receptance, case: &Case) -> Result<f64, CliError> {
    match &arguments.speed {
        Some(speed) => speed.within("--speed"),
        None => Ok(case.speed.max()),
    }
}

/// Track and wheel along all axes.
fn matrix(arguments: &Receptance, case: &Case) -> miette::Result<()> {
    let speed = speed(arguments, case)?;
    let frequencies = match &arguments.frequencies[..] {
        [] => {
            let (from, to) = range(arguments, &case.track)?;
            ReceptanceCurves::frequencies(from, to, arguments.points)
        }
        listed => within("--frequencies", listed)?,
    };
    let answer = MatrixAnswer::new(case, speed, frequencies)?;
    Ok(Results::of("receptance", &arguments.case, &arguments.results).answer(&answer)?)
}

/// Frequencies of a list \[Hz\].
pub(super) fn within(argument: &'static str, listed: &[Asked<Frequency>]) -> Result<Vec<f64>, CliError> {
    listed.iter().map(|frequency| frequency.within(argument)).collect()
}

/// The frequencies asked for \[Hz\]; where nothing is said, as many of the usual ones as a measurement
/// has.
fn range(arguments: &Receptance, track: &Track) -> Result<(f64, f64), CliError> {
    let (usual_from, usual_to) = ReceptanceCurves::default_range(&*track.receptance);
    let from = match &arguments.from {
        Some(from) => from.within("--from")?,
        None => usual_from,
    };
    let to = match &arguments.to {
        Some(to) => to.within("--to")?,
        None => usual_to,
    };
    if from < to {
        return Ok((from, to));
    }
    Err(CliError::Argument { argument: "--to", value: format!("{to} Hz"), rule: format!("above --from, {from} Hz") })
}
