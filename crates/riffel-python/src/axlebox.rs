//! Roughness from axle-box acceleration.

use std::path::PathBuf;

use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use riffel_answers::axlebox::{AxleBoxAnswer, AxleBoxRequest};
use riffel_rail::{AxleBoxFile, AxleBoxLayout, AxleBoxPlace, LimitTable};

use crate::array::owned;
use crate::case::Case;
use crate::document::document;
use crate::errors::{of_answer, of_case};

/// Files, or accelerations of channels by name \[m/s²\].
#[derive(FromPyObject)]
pub(crate) enum GivenRun<'py> {
    Files(Vec<PathBuf>),
    Channels(Vec<(String, PyReadonlyArray1<'py, f64>)>),
}

/// A speed that stays the same \[m/s\], a speed for each sample \[m/s\], a reading of the odometer for each sample \[m\].
type GivenPlace<'py> = (Option<f64>, Option<PyReadonlyArray1<'py, f64>>, Option<PyReadonlyArray1<'py, f64>>);

/// What `riffel axlebox --json` prints. `within` is the shortest and the longest wavelength \[m\], the lowest speed \[m/s\] and
/// the length of a block \[m\].
#[pyfunction]
pub(crate) fn axlebox<'py>(
    py: Python<'py>,
    case: &Case,
    run: GivenRun<'py>,
    rate: Option<f64>,
    place: GivenPlace<'py>,
    channels: Vec<String>,
    within: (f64, f64, f64, f64),
    contact_filter: bool,
    keep_defects: bool,
    limits: Vec<String>,
) -> PyResult<Bound<'py, PyAny>> {
    let (speed, speeds, odometer) = place;
    let files = match run {
        GivenRun::Files(paths) => {
            let layout = AxleBoxLayout { rate, speed, channels };
            paths
                .into_iter()
                .map(|path| Ok((path.clone(), AxleBoxFile::open(&path, &layout)?)))
                .collect::<Result<_, _>>()
        }
        GivenRun::Channels(given) => {
            let given = given.into_iter();
            let given = given.map(|(name, values)| (name, owned(&values))).collect();
            let place = match (odometer, speeds) {
                (Some(odometer), _) => AxleBoxPlace::Odometer(owned(&odometer)),
                (None, Some(speeds)) => AxleBoxPlace::Speed(owned(&speeds)),
                (None, None) => AxleBoxPlace::Constant(speed.unwrap_or(f64::NAN)),
            };
            AxleBoxFile::of_arrays("run", given, rate.unwrap_or(f64::NAN), place)
                .map(|file| vec![(PathBuf::from("run"), file)])
        }
    };
    let files: Vec<(PathBuf, AxleBoxFile)> = files.map_err(of_case)?;
    let limits: Vec<LimitTable> = match limits.is_empty() {
        true => LimitTable::all(),
        false => {
            let tables = limits.iter().map(|name| LimitTable::find(name));
            tables.collect::<Result<_, _>>().map_err(of_case)?
        }
    };
    let (shortest, longest, slowest, block) = within;
    let request =
        AxleBoxRequest { shortest, longest, slowest, contact_filter, keep_defects, block, ..AxleBoxRequest::default() };
    let answer = case.compute(py, move |case| AxleBoxAnswer::new(case, &files, &limits, &request, &|_| ()))?;
    document(py, &answer.map_err(of_answer)?)
}
