//! Surveys of many lines and dates.

use std::collections::BTreeMap;
use std::ffi::CString;
use std::io;
use std::path::PathBuf;

use pyo3::exceptions::{PyFileNotFoundError, PyOSError, PyUserWarning};
use pyo3::prelude::*;
use riffel_answers::ExpectedRates;
use riffel_network::{
    Aim, Budget, ExpectedGrowth, Judgement, NetworkError, Store, StoreSettings, StripChart, SurveyFile, growth, plan,
    status, worst,
};
use riffel_rail::{LimitTable, read_date};
use serde::Serialize;

use crate::case::Case;
use crate::document::document;
use crate::errors::{of_answer, of_case, wrong};
use crate::forecast::GivenTraffic;
use crate::interrupt::interruptible;

/// Folder of the store, name of the limit and length of a section \[m\].
type Judged = (PathBuf, String, f64);

/// A line or all, and the case and the traffic of which it is expected to grow.
type Expected<'py> = (Option<String>, PyRef<'py, Case>, Option<GivenTraffic<'py>>);

/// A line or all, and how fast it is expected to grow in each band.
type ExpectedOf = (Option<String>, Vec<Option<ExpectedGrowth>>);

/// Take in a survey; what `riffel network ingest --json` prints.
#[pyfunction]
pub(crate) fn network_ingest(
    py: Python<'_>,
    store: PathBuf,
    resolution: Option<f64>,
    file: PathBuf,
    line: String,
    date: String,
    replace: bool,
    rename: BTreeMap<String, String>,
) -> PyResult<Bound<'_, PyAny>> {
    answer(py, move || {
        let store = Store::create_or_open(&store, StoreSettings { resolution })?;
        let file = SurveyFile::check(&file)?.rename(rename)?;
        store.ingest(&line, &date, &file, replace, &|_| ())
    })
}

/// What `riffel network status --json` prints.
#[pyfunction]
pub(crate) fn network_status(py: Python<'_>, store: PathBuf) -> PyResult<Bound<'_, PyAny>> {
    answer(py, move || status(&Store::open(&store)?.whole()?))
}

/// What `riffel network worst --json` prints.
#[pyfunction]
pub(crate) fn network_worst(
    py: Python<'_>,
    judged: Judged,
    until: Option<String>,
    most: usize,
) -> PyResult<Bound<'_, PyAny>> {
    let until = until.as_deref().map(day).transpose()?;
    answer(py, move || {
        let (store, judgement, section) = opened(&judged)?;
        worst(&store, &judgement, section, until, most)
    })
}

/// What `riffel network growth --json` prints.
#[pyfunction]
pub(crate) fn network_growth<'py>(
    py: Python<'py>,
    judged: Judged,
    between: Option<(String, String)>,
    most: usize,
    expected: Option<Expected<'py>>,
) -> PyResult<Bound<'py, PyAny>> {
    let expected = expected_of(py, &judged, expected)?;
    let between = between.map(|(from, to)| Ok::<_, PyErr>([day(&from)?, day(&to)?])).transpose()?;
    answer(py, move || {
        let (store, judgement, section) = expecting(&judged, expected)?;
        let mut found = growth(&store, &judgement, section, between)?;
        found.truncate(most);
        Ok(found)
    })
}

/// What `riffel network plan --json` prints; `budget` is money, cost of a metre and of a site, or a length \[m\] as money with a
/// metre at 1.
#[pyfunction]
pub(crate) fn network_plan<'py>(
    py: Python<'py>,
    judged: Judged,
    months: f64,
    budget: (f64, f64, f64),
    most_track: bool,
    expected: Option<Expected<'py>>,
) -> PyResult<Bound<'py, PyAny>> {
    let expected = expected_of(py, &judged, expected)?;
    let (money, per_metre, per_site) = budget;
    let budget = Budget { money, per_metre, per_site };
    answer(py, move || {
        let (store, judgement, section) = expecting(&judged, expected)?;
        let aim = match most_track {
            true => Aim::MostTrack,
            false => Aim::WorstFirst,
        };
        plan(&store, &judgement, section, months, &budget, aim)
    })
}

/// What `riffel network chart --json` prints.
#[pyfunction]
pub(crate) fn network_chart(
    py: Python<'_>,
    judged: Judged,
    line: Option<String>,
    rail: Option<String>,
) -> PyResult<Bound<'_, PyAny>> {
    answer(py, move || {
        let (store, judgement, section) = opened(&judged)?;
        StripChart::new(&store, &judgement, section, line.as_deref(), rail.as_deref())
    })
}

fn opened((store, limit, section): &Judged) -> Result<(Store, Judgement, f64), NetworkError> {
    let store = Store::open(store)?.whole()?;
    let judgement = Judgement::new(&store, &LimitTable::find(limit)?)?;
    Ok((store, judgement, *section))
}

/// The same with what is expected.
fn expecting(judged: &Judged, expected: Option<ExpectedOf>) -> Result<(Store, Judgement, f64), NetworkError> {
    let (store, judgement, section) = opened(judged)?;
    let judgement = match expected {
        Some((line, growth)) => judgement.expecting(&store, line.as_deref(), growth)?,
        None => judgement,
    };
    Ok((store, judgement, section))
}

fn expected_of(py: Python<'_>, judged: &Judged, expected: Option<Expected<'_>>) -> PyResult<Option<ExpectedOf>> {
    let Some((line, case, traffic)) = expected else {
        return Ok(None);
    };
    let (_, judgement, _) = opened(judged).map_err(of_network)?;
    let traffic = traffic.map(|given| given.traffic()).transpose()?;
    let bands = judgement.ends_of_bands();
    let growth = case.compute(py, move |case| ExpectedRates::new(case, traffic.as_ref(), &bands))?;
    let growth = growth.map_err(of_answer)?;
    if let Some(reason) = &growth.without_rate {
        let said = CString::new(reason.to_string()).unwrap_or_default();
        PyErr::warn(py, &py.get_type::<PyUserWarning>(), &said, 2)?;
    }
    let growth = growth.of_bands.into_iter().map(|growth| {
        growth.map(|growth| ExpectedGrowth { median: growth.median, band_50: growth.band_50, band_80: growth.band_80 })
    });
    Ok(Some((line, growth.collect())))
}

fn day(text: &str) -> PyResult<jiff::civil::Date> {
    read_date(text).map_err(|said| wrong(said.to_string()))
}

fn answer<'py, T: Serialize + Send + 'static>(
    py: Python<'py>,
    work: impl FnOnce() -> Result<T, NetworkError> + Send + 'static,
) -> PyResult<Bound<'py, PyAny>> {
    document(py, &interruptible(py, work)?.map_err(of_network)?)
}

fn of_network(error: NetworkError) -> PyErr {
    match error {
        NetworkError::Input(error) => of_case(error),
        NetworkError::NoNetwork { .. } => PyFileNotFoundError::new_err(error.to_string()),
        NetworkError::Read { ref reason, .. } if reason.kind() == io::ErrorKind::NotFound => {
            PyFileNotFoundError::new_err(error.to_string())
        }
        NetworkError::Read { .. } | NetworkError::Write { .. } | NetworkError::Locked { .. } => {
            PyOSError::new_err(error.to_string())
        }
        _ => wrong(error.to_string()),
    }
}
