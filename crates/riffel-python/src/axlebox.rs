//! Runs of a train in memory.

use std::sync::Arc;

use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use riffel_rail::{AxleBoxFile, AxleBoxPlace};

use crate::array::owned;
use crate::errors::of_case;

/// A speed for each sample \[m/s\], a reading of the odometer for each \[m\], or a speed that stays the same \[m/s\].
#[derive(FromPyObject)]
pub(crate) enum PlaceArg<'py> {
    Speed(PyReadonlyArray1<'py, f64>),
    Odometer((PyReadonlyArray1<'py, f64>,)),
    Constant(f64),
}

/// Accelerations of axle boxes in memory, in place of a file.
#[pyclass(frozen, module = "riffel._riffel")]
pub(crate) struct AxleBoxRun(pub(crate) Arc<AxleBoxFile>);

#[pymethods]
impl AxleBoxRun {
    /// Of channels by name \[m/s²\], and the samples per second.
    #[new]
    fn new(channels: Vec<(String, PyReadonlyArray1<'_, f64>)>, rate: f64, place: PlaceArg<'_>) -> PyResult<Self> {
        let channels = channels.into_iter().map(|(name, values)| (name, owned(&values))).collect();
        let place = match place {
            PlaceArg::Speed(speeds) => AxleBoxPlace::Speed(owned(&speeds)),
            PlaceArg::Odometer((odometer,)) => AxleBoxPlace::Odometer(owned(&odometer)),
            PlaceArg::Constant(speed) => AxleBoxPlace::Constant(speed),
        };
        Ok(Self(Arc::new(AxleBoxFile::of_arrays("run", channels, rate, place).map_err(of_case)?)))
    }
}
