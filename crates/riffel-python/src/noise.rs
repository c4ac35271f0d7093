//! Rolling noise.

use std::path::PathBuf;

use pyo3::prelude::*;
use riffel::noise::Surroundings;
use riffel::roughness::Spectrum;
use riffel_answers::noise::{NoiseQuestion, RoughWheels};
use riffel_case::TrackRadiator;
use riffel_rail::read_decay_rates;

use crate::array::owned;
use crate::arrays_of_rails::spectrum;
use crate::begins::{GivenDates, GivenLevels, survey};
use crate::case::Case;
use crate::document::document;
use crate::errors::{of_answer, of_case};
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
    let question = NoiseQuestion {
        speed,
        roughness: survey.mean(),
        history: survey.history,
        rails: Vec::new(),
        before: None,
        wheel_roughness: match wheel_roughness {
            Some(GivenWheels::Table(name)) => Some(RoughWheels::Named(name)),
            Some(GivenWheels::Levels(levels)) => Some(RoughWheels::Given(roughness_of(&levels)?)),
            None => None,
        },
        wheel_modes,
        radiator: TrackRadiator {
            rail_foot,
            sleeper_area,
            decay_rate: decay_rate.as_deref().map(read_decay_rates).transpose().map_err(of_case)?,
        },
        transfer,
        limit,
        wheels,
        train_length,
        distance,
        height,
        surroundings: Surroundings::HardGround,
        traffic: traffic.map(|traffic| traffic.traffic()).transpose()?,
        months,
        limit_dba,
    };
    let answer = case.compute(py, move |case| question.answer(case, &|_| ()))?;
    document(py, &answer.map_err(of_answer)?)
}
