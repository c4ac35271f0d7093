//! Rolling noise.

use std::path::PathBuf;

use pyo3::prelude::*;
use riffel::roughness::Spectrum;
use riffel_answers::noise::{NoiseQuestion, RoughWheels};
use riffel_answers::question::{Nobody, Source};
use riffel_keys::quantity::Quantity;

use crate::array::owned;
use crate::arrays_of_rails::spectrum;
use crate::begins::{GivenDates, GivenLevels, survey};
use crate::case::Case;
use crate::document::document;
use crate::errors::of_answer;
use crate::forecast::GivenTraffic;

/// The train: wheels on one rail, its length \[m\], distance and height of the receiver \[m\].
type GivenTrain = (u32, Option<f64>, f64, f64);

/// The roughness of the wheels: the name of a table, or wavelengths \[m\] and levels.
#[derive(FromPyObject)]
pub(crate) enum GivenWheels<'py> {
    Table(String),
    Levels(GivenLevels<'py>),
}

fn roughness_of((wavelengths, levels): &GivenLevels<'_>) -> PyResult<Spectrum> {
    spectrum(&owned(wavelengths), &owned(levels))
}

/// What `riffel noise --json` prints.
#[pyfunction]
pub(crate) fn noise<'py>(
    py: Python<'py>,
    case: &Case,
    measured: GivenDates<'py>,
    speed: f64,
    train: GivenTrain,
    wheel_roughness: Option<GivenWheels<'py>>,
    wheel_modes: Option<String>,
    decay_rate: Option<PathBuf>,
    transfer: Option<[String; 2]>,
    radiators: (f64, f64),
    limit: String,
    traffic: Option<GivenTraffic<'py>>,
    ahead: (f64, Option<f64>),
) -> PyResult<Bound<'py, PyAny>> {
    let (wheels, train_length, distance, height) = train;
    let (rail_foot, sleeper_area) = radiators;
    let (months, limit_dba) = ahead;
    let survey = survey(&measured)?;
    let length = |metres: f64| Quantity::new(metres).into();
    let [track_transfer, vehicle_transfer] = transfer.map_or([None, None], |names| names.map(Some));
    let question = NoiseQuestion {
        wheel_roughness: match wheel_roughness {
            Some(GivenWheels::Table(name)) => Some(RoughWheels::Named(name)),
            Some(GivenWheels::Levels(levels)) => Some(RoughWheels::Given(roughness_of(&levels)?)),
            None => None,
        },
        wheel_modes,
        rail_foot: length(rail_foot),
        sleeper_area: Quantity::new(sleeper_area).into(),
        decay_rate: decay_rate.map(Source::File),
        track_transfer,
        vehicle_transfer,
        wheels,
        train_length: train_length.map(length),
        distance: length(distance),
        height: length(height),
        traffic: traffic.map(|traffic| traffic.traffic()).transpose()?.map(Source::from),
        months,
        limit_dba,
        ..NoiseQuestion::of_a_coach(case.case.clone(), survey, speed, &limit).map_err(of_answer)?
    };
    let answer = case.compute(py, move |_| question.answer(&Nobody))?;
    document(py, &answer.map_err(of_answer)?)
}
