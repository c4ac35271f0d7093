//! `riffel shakedown`

use riffel_answers::shakedown::ShakedownQuestion;

use crate::arguments::{Shakedown, covering};
use crate::results::Results;

pub(crate) fn run(arguments: &Shakedown) -> miette::Result<()> {
    let mut case = arguments.case.read()?;
    let wave = match (&arguments.wavelength, &arguments.speed) {
        (Some(wavelength), Some(speed)) => {
            let wavelength = wavelength.within("--wavelength")?;
            let speed = speed.within("--speed")?;
            case.check_points([wavelength; 2], [speed; 2])?;
            case = covering(&case, wavelength, wavelength)?;
            Some([wavelength, speed])
        }
        _ => None,
    };
    let frictions = arguments.utilised_friction.iter();
    let amplitude = arguments.amplitude.as_ref();
    let question = ShakedownQuestion {
        utilised_friction: frictions.map(|friction| friction.si()).collect(),
        wave,
        amplitude: amplitude.map(|amplitude| amplitude.within("--amplitude")).transpose()?,
    };
    let answer = question.answer(&case)?;
    Results::of("shakedown", &arguments.case, &arguments.results).answer(&answer)?;
    Ok(())
}
