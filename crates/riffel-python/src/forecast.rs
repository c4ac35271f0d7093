//! A spectrum under traffic.

use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use riffel::forecast::{ForecastBand, Reach};
use riffel_answers::forecast::{ForecastHorizon, ForecastQuestion, HardenedWave};
use riffel_answers::question::{of, of_keys};

use crate::array::owned;
use crate::ask::QuestionArg;
use crate::document::{document, sentences};
use crate::errors::{of_answer, wrong};

type Real<'py> = Bound<'py, PyArray1<f64>>;

/// A measure of the horizon by its key.
fn horizon(measure: &str) -> PyResult<fn(f64) -> ForecastHorizon> {
    match measure {
        "passages" => Ok(ForecastHorizon::Passages),
        "mgt" => Ok(ForecastHorizon::MillionGrossTonnes),
        "months" => Ok(ForecastHorizon::Months),
        _ => Err(wrong(format!("no horizon is called \"{measure}\""))),
    }
}

/// The bands of the forecast of a question at passages by a measure, with all that is said of them.
#[pyfunction]
pub(crate) fn forecast<'py>(
    py: Python<'py>,
    question: &Bound<'py, PyDict>,
    measure: &str,
    values: PyReadonlyArray1<'py, f64>,
) -> PyResult<Bound<'py, PyDict>> {
    let asked = QuestionArg::new(&of::<ForecastQuestion>(), question)?;
    let (mut answer, _) = asked.answer(py, |keys, client| {
        let question: ForecastQuestion = of_keys(keys.into())?;
        question.forecast_on(&*question.case.read(client)?, client)
    })?;
    let horizon = horizon(measure)?;
    let passages = owned(&values).into_iter().map(|value| horizon(value).passages(&answer.on));
    let passages = passages.collect::<Result<Vec<f64>, _>>().map_err(of_answer)?;
    answer.passages = passages.iter().copied().fold(0.0, f64::max);
    let (on, forecast) = (&answer.on, &answer.leading().forecast);
    let bands = forecast.bands();
    let column = |value: &dyn Fn(&ForecastBand) -> f64| -> Real<'py> {
        bands.iter().map(value).collect::<Vec<_>>().into_pyarray(py)
    };
    let reaches = forecast.reaches(&answer.limit);
    let reach = |band: &ForecastBand| reaches.iter().find(|reach| reach.0 == band);
    let mut grown = Vec::with_capacity(passages.len() * bands.len());
    for &passages in &passages {
        let levels = bands.iter();
        grown.extend(levels.map(|band| forecast.level(band, passages).unwrap_or(f64::NAN)));
    }
    let grown: Bound<'py, PyArray2<f64>> = grown.into_pyarray(py).reshape([passages.len(), bands.len()])?;
    let linear = forecast.linear_range(bands);
    let result = PyDict::new(py);
    let mgt: Vec<f64> = passages.iter().map(|&passages| on.growth.mgt(passages)).collect();
    result.set_item("findings", sentences(&answer.damage_in_words().collect::<Vec<_>>()))?;
    result.set_item("hardening", document(py, &HardenedWave::all(forecast))?)?;
    result.set_item("cracks", document(py, &answer.cracks())?)?;
    result.set_item("passages", passages.into_pyarray(py))?;
    result.set_item("mgt", mgt.into_pyarray(py))?;
    result.set_item("level", grown)?;
    result.set_item("wavelength", column(&|band| band.now.band.wavelength()))?;
    result.set_item("nominal", column(&|band| band.now.band.nominal_millimetres()))?;
    result.set_item("now", column(&|band| band.now.level))?;
    result.set_item("growth_rate", column(&|band| forecast.growth_rate(band)))?;
    result.set_item("limit", column(&|band| reach(band).map_or(f64::NAN, |found| found.1)))?;
    result.set_item(
        "passages_to_limit",
        column(&|band| match reach(band).map(|found| found.2) {
            Some(Reach::After(passages)) => passages,
            Some(Reach::BeyondLinearRange) => f64::NAN,
            Some(Reach::Never) | None => f64::INFINITY,
        }),
    )?;
    let interval = forecast.grinding_interval(&answer.limit);
    result.set_item("grinding_interval", interval.passages())?;
    result.set_item("limit_reached", interval.name())?;
    result.set_item("passages_per_day", on.passages_per_day)?;
    result.set_item("linear_force_ratio", linear.force_ratio)?;
    result.set_item("linear_passages", linear.passages)?;
    result.set_item("remarks", sentences(on.remarks.iter().chain(&answer.without_growth)))?;
    Ok(result)
}

/// The `wear_fit` of the question of a forecast, so many days apart where it has no passages.
#[pyfunction]
pub(crate) fn fit_wear<'py>(
    py: Python<'py>,
    question: &Bound<'py, PyDict>,
    days: Option<f64>,
) -> PyResult<Bound<'py, PyAny>> {
    let asked = QuestionArg::new(&of::<ForecastQuestion>(), question)?;
    let (report, _) = asked.answer(py, move |keys, client| {
        let question: ForecastQuestion = of_keys(keys.into())?;
        question.wear_on(&*question.case.read(client)?, days, client)
    })?;
    document(py, &report)
}
