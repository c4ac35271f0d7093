//! `riffel noise`

use riffel::noise::Surroundings;
use riffel_answers::noise::{NoiseQuestion, RoughWheels};
use riffel_case::TrackRadiator;
use riffel_case::traffic::Traffic;
use riffel_rail::read_decay_rates;

use super::history::History;
use super::roughness::survey;
use crate::arguments::Noise;
use crate::messages::print_remarks;
use crate::posterior::over;
use crate::progress::Progress;
use crate::results::Results;

pub(crate) fn run(arguments: &Noise) -> miette::Result<()> {
    let (path, layout, choose) = (&arguments.roughness, &arguments.layout, &arguments.choose);
    let survey = survey(path, layout)?;
    let survey = History::of_dates(survey, &arguments.earlier, Some(path), layout, choose)?;
    let before = match &arguments.before {
        Some(path) => {
            let before = super::roughness::survey(path, &arguments.layout)?;
            Some(before.choose(&arguments.choose)?.latest().0.mean())
        }
        None => None,
    };
    let case = arguments.case.read()?;
    let draws = arguments.posterior.draws(&arguments.case)?;
    let length = arguments.train_length.as_ref();
    let transfer = arguments.track_transfer.clone();
    let question = NoiseQuestion {
        speed: arguments.speed.within("--speed")?,
        roughness: survey.mean(),
        rails: survey.rails(),
        history: survey.history.clone(),
        before,
        wheel_roughness: arguments.wheel_roughness.clone().map(RoughWheels::Named),
        wheel_modes: arguments.wheel_modes.clone(),
        radiator: TrackRadiator {
            rail_foot: arguments.rail_foot.within("--rail-foot")?,
            sleeper_area: arguments.sleeper_area.within("--sleeper-area")?,
            decay_rate: arguments.decay_rate.as_deref().map(read_decay_rates).transpose()?,
        },
        transfer: transfer.zip(arguments.vehicle_transfer.clone()).map(<[String; 2]>::from),
        limit: arguments.limit.clone(),
        wheels: arguments.wheels,
        train_length: length.map(|length| length.within("--train-length")).transpose()?,
        distance: arguments.distance.within("--distance")?,
        height: arguments.height.within("--height")?,
        surroundings: Surroundings::HardGround,
        traffic: match (&arguments.traffic, &draws) {
            (Some(path), _) => Some(Traffic::read(path)?),
            (None, draws) => draws.as_ref().and_then(|draws| draws.traffic.clone()),
        },
        months: arguments.months,
        limit_dba: arguments.limit_dba,
    };
    let traffic = question.traffic.as_ref();
    let vehicles = traffic.map_or(0, |traffic| traffic.file.vehicle.len());
    let progress = Progress::new(riffel_keys::say!(progress_traffic), vehicles);
    let mut answer = question.answer(&case, &|by| progress.advance(by))?;
    drop(progress);
    answer.over_posterior = over(draws.as_ref(), |draws, progress| question.over(draws, progress))?;
    Results::of("noise", &arguments.case, &arguments.results).answer(&answer)?;
    print_remarks(&survey.warnings);
    print_remarks(&case.remarks);
    Ok(())
}
