//! `riffel point`

use riffel_answers::Answer;
use riffel_answers::point::{PointAnswer, PointRequest};
use riffel_case::DrawnSupports;

use crate::arguments::{Point as Arguments, covering, positive};
use crate::error::CliError;
use crate::messages::print_remarks;
use crate::output::{print, print_json};
use crate::results::readable;

pub(crate) fn run(arguments: &Arguments) -> miette::Result<()> {
    let case = arguments.case.read_at(arguments.position)?;
    let wavelength = arguments.wavelength.within("--wavelength")?;
    let speed = arguments.speed.within("--speed")?;
    case.check_points([wavelength; 2], [speed; 2])?;
    let case = covering(&case, wavelength, wavelength)?;
    let request = PointRequest {
        wavelength,
        speed,
        sensitivity: arguments.sensitivity,
        neighbours: arguments.neighbours,
        irregular: arguments
            .spacing_deviation
            .map(|deviation| -> Result<_, CliError> {
                Ok(DrawnSupports {
                    deviation: positive("--spacing-deviation", deviation)?,
                    supports: arguments.supports.unwrap_or(DrawnSupports::USUAL_SUPPORTS),
                    seed: arguments.seed.unwrap_or(1),
                })
            })
            .transpose()?,
    };
    let answer = PointAnswer::new(&case, request)?;
    match arguments.json {
        true => print_json(&answer)?,
        false => print(&readable(&answer))?,
    }
    print_remarks(answer.remarks());
    Ok(())
}
