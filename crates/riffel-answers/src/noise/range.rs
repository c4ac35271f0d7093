//! What a train, a receiver and radiators can be.

use riffel::noise::PassBy;
use riffel_keys::PhysicalRange;

use super::NoiseRequest;
use crate::AnswerError;

/// Least length of train to a wheel on one rail \[m\]: wheels follow each other at more than their diameter.
const LEAST_PER_WHEEL: f64 = 0.5;

/// `Ok` where every number is within its physical range, whoever asks.
///
/// # Errors
/// [`AnswerError::Argument`] with the argument and its range.
pub(super) fn check(request: &NoiseRequest) -> Result<(), AnswerError> {
    let wrong = |argument, value: String, rule: String| {
        Err(AnswerError::Argument {
            argument,
            value,
            rule,
        })
    };
    let train = &request.train;
    if train.distance.is_nan() || train.distance <= PassBy::NEAREST {
        let rule = "beyond the rail, 0.75 m".to_owned();
        return wrong("--distance", format!("{} m", train.distance), rule);
    }
    for (argument, value, unit) in [
        ("--speed", request.speed, "m/s"),
        ("--distance", train.distance, "m"),
        ("--height", train.height, "m"),
        ("--train-length", train.length, "m"),
        ("--rail-foot", request.rail_foot, "m"),
        ("--sleeper-area", request.sleeper_area, "m²"),
    ] {
        if let Some(range) = PhysicalRange::of(argument) {
            let [low, high] = range.hard;
            if !(value >= low && value <= high) {
                let rule = format!("between {low} and {high} {unit}");
                return wrong(argument, format!("{value} {unit}"), rule);
            }
        }
    }
    let shortest = LEAST_PER_WHEEL * f64::from(train.wheels);
    if train.length < shortest {
        let rule = format!(
            "at least {shortest} m, half a metre to each of {} wheels",
            train.wheels
        );
        return wrong("--train-length", format!("{} m", train.length), rule);
    }
    match request.future.as_ref().map(|future| future.months) {
        Some(months) if !(months.is_finite() && months > 0.0) => wrong(
            "--months",
            months.to_string(),
            "finite and greater than zero".to_owned(),
        ),
        _ => Ok(()),
    }
}
