//! `riffel map`

use riffel_answers::LineGrowth;
use riffel_answers::map::{BayGrowth, MapAnswer, growth_over};
use riffel_case::traffic::Traffic;

use crate::arguments::{Map, covering};
use crate::observations;
use crate::posterior::over;
use crate::progress::Progress;
use crate::results::Results;

pub(crate) fn run(arguments: &Map) -> miette::Result<()> {
    if arguments.wheels {
        return super::wheels::run(arguments);
    }
    let case = arguments.case.read_at(arguments.position)?;
    case.check_window()?;
    let curve = match (&arguments.wavelength, &arguments.speed) {
        (Some(wavelength), Some(speed)) => Some((wavelength.within("--wavelength")?, speed.within("--speed")?)),
        _ => None,
    };
    let case = match curve {
        Some((wavelength, _)) => covering(&case, wavelength, wavelength)?,
        None => case,
    };
    let observations = arguments.observations.as_deref().map(observations::read).transpose()?;
    let progress = Progress::new(riffel_keys::say!(progress_growth_map), case.speed.points());
    let mut answer = MapAnswer::new(&case, |rows| progress.advance(rows));
    drop(progress);
    let traffic = arguments.traffic.as_deref().map(Traffic::read).transpose()?;
    let draws = arguments.posterior.draws(&arguments.case)?;
    let over = over(draws.as_ref(), growth_over)?;
    // The calibration knows more than the case says.
    if over.is_none() {
        answer.under_traffic = Some(LineGrowth::new(&case, traffic.as_ref())?);
    }
    answer.over_posterior = over;
    if arguments.bay {
        let rows = case.speed.points() * BayGrowth::map_count();
        let progress = Progress::new(riffel_keys::say!(progress_bay), rows);
        let bay = BayGrowth::new(&case, curve, |rows| progress.advance(rows))?;
        answer.bay = Some(bay);
    }
    if let Some(observations) = observations {
        answer = answer.with_observations(observations);
    }
    Ok(Results::of("map", &arguments.case, &arguments.results).answer(&answer)?)
}
