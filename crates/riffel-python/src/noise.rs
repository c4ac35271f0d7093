//! Rolling noise.

use std::path::PathBuf;

use pyo3::prelude::*;
use riffel::noise::Surroundings;
use riffel::roughness::Spectrum;
use riffel_answers::noise::{Future, NoiseAnswer, NoiseRequest, Train};
use riffel_rail::{TransferPart, TransferTable, WheelModesTable, WheelRoughness, read_decay_rates};

use crate::array::owned;
use crate::arrays_of_rails::spectrum;
use crate::case::Case;
use crate::document::document;
use crate::errors::{of_answer, of_case, wrong};
use crate::forecast::{GivenLevels, GivenTraffic};
use crate::roughness::level_limit;

/// The train: wheels on one rail, its length \[m\], distance and height of the receiver \[m\].
type GivenTrain = (u32, Option<f64>, f64, f64);

/// The roughness of the wheels: the name of a table, or wavelengths \[m\] and levels.
#[derive(FromPyObject)]
pub(crate) enum GivenWheels<'py> {
    Table(String),
    Levels(GivenLevels<'py>),
}

impl GivenWheels<'_> {
    fn read(self) -> PyResult<(String, Spectrum)> {
        match self {
            Self::Table(name) => match WheelRoughness::find(&name) {
                Some(table) => Ok((table.name, table.spectrum)),
                None => {
                    let known: Vec<String> = WheelRoughness::all()
                        .into_iter()
                        .map(|table| table.name)
                        .collect();
                    Err(wrong(format!(
                        "wheel_roughness is \"{name}\", but must be a spectrum or one of {}",
                        known.join(", ")
                    )))
                }
            },
            Self::Levels(levels) => Ok(("given".to_owned(), roughness_of(&levels)?)),
        }
    }
}

fn roughness_of((wavelengths, levels): &GivenLevels<'_>) -> PyResult<Spectrum> {
    spectrum(&owned(wavelengths), &owned(levels))
}

/// What `riffel noise --json` prints.
#[pyfunction]
pub(crate) fn noise<'py>(
    py: Python<'py>,
    case: &Case,
    spectrum: GivenLevels<'py>,
    speed: f64,
    train: GivenTrain,
    wheel_roughness: Option<GivenWheels<'py>>,
    wheel_modes: Option<String>,
    decay_rate: Option<PathBuf>,
    transfer: Option<(String, String)>,
    radiators: (f64, f64),
    ground_to: &str,
    traffic: Option<GivenTraffic<'py>>,
    ahead: (f64, Option<f64>),
) -> PyResult<Bound<'py, PyAny>> {
    let (wheels, length, distance, height) = train;
    let (rail_foot, sleeper_area) = radiators;
    let (months, limit) = ahead;
    let transfer = match transfer {
        Some((track, vehicle)) => Some([
            TransferTable::find(&track, TransferPart::Track).map_err(of_case)?,
            TransferTable::find(&vehicle, TransferPart::Vehicle).map_err(of_case)?,
        ]),
        None => None,
    };
    let future = match traffic {
        Some(traffic) => Some(Future {
            traffic: traffic.traffic()?,
            months,
            limit,
        }),
        None => None,
    };
    let modes = wheel_modes
        .as_deref()
        .map(WheelModesTable::find)
        .transpose();
    let decay = decay_rate.as_deref().map(read_decay_rates).transpose();
    let request = NoiseRequest {
        speed,
        roughness: roughness_of(&spectrum)?,
        wheels: wheel_roughness.map(GivenWheels::read).transpose()?,
        wheel_modes: modes.map_err(of_case)?,
        decay: decay.map_err(of_case)?,
        transfer,
        limit: level_limit(ground_to)?,
        train: Train {
            wheels,
            length: length.unwrap_or(Train::LENGTH_PER_WHEEL * f64::from(wheels)),
            distance,
            height,
            surroundings: Surroundings::HardGround,
        },
        rail_foot,
        sleeper_area,
        future,
    };
    let answer = case.compute(py, move |case| NoiseAnswer::new(case, request, &|_| ()))?;
    document(py, &answer.map_err(of_answer)?.document())
}
